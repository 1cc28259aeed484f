//! The survey: every effect there is, one line each, by the table whose entities carry it.
//!
//! A line has the effect, its name in reports and in the tables, the component that asks for it, the stages of the trace
//! that have code for it (see `trace/stages.rs`), and what it is. Whatever follows from that is made of the line: the bit
//! and the name of the effect, its column or its field, the count of its rows and bytes, the query that extracts it, the
//! checks of its numbers, the look for changes, and the copies of each stage with and without it.

/// Calls a macro with the lines of some effects in braces, after what else it is to be given: of `all`, or of one table.
macro_rules! survey {
    ($which:ident, $then:ident $($given:tt)*) => {
        $crate::effects::lines! { $which $then [$($given)*]
            surfaces {
                Gloss gloss: Gloss [follow shine] "Highlights.";
                Mirror mirror: Mirror [follow] "Mirrors.";
                Glass glass: Glass [follow] "Glass: refraction, and Fresnel's reflection.";
                Absorption absorption: Absorption [follow] "Glass that takes light away.";
            }
            boards {
                Texture texture: Textured [paint] "Images on checkerboards.";
                TextureFilter texture_filter: TextureFilter [paint] "Images that are averaged over some texels.";
                CheckerFilter checker_filter: CheckerFilter [paint] "Cells that are averaged over what a pixel covers.";
            }
            lights {
                Falloff falloff: Falloff [gather] "Lights that lose strength with distance.";
                SpotCone spot_cone: SpotCone [gather] "Spotlights.";
                LightColor light_color: LightColor [shine] "Lights of another colour than white.";
                Directional directional: Directional [gather] "Parallel light.";
                AreaLight area_light: AreaLight [gather] "Lights with an extent, and soft shadows.";
            }
            air {
                Background background: Background [look_beyond] "Light from where there is no surface.";
                Fog fog: Fog [follow look_beyond] "Fog.";
            }
            motion {
                MotionBlur motion_blur: Velocity [] "Objects that move while the camera looks.";
            }
            camera {
                Aperture aperture: Aperture [expose] "A camera with a lens of some width.";
                Exposure exposure: ExposureStops [expose] "A camera for which light counts more or less.";
                Srgb srgb: SrgbTransfer [] "Pictures by the curve of sRGB.";
            }
        }
    };
}

/// Picks the lines of one table, or all.
macro_rules! lines {
    (all $then:ident [$($given:tt)*] $($table:ident { $($line:tt)* })*) => {
        $then! { $($given)* { $($($line)*)* } }
    };
    (surfaces $then:ident [$($given:tt)*] surfaces $lines:tt $($others:tt)*) => { $then! { $($given)* $lines } };
    (boards $then:ident [$($given:tt)*] boards $lines:tt $($others:tt)*) => { $then! { $($given)* $lines } };
    (lights $then:ident [$($given:tt)*] lights $lines:tt $($others:tt)*) => { $then! { $($given)* $lines } };
    (air $then:ident [$($given:tt)*] air $lines:tt $($others:tt)*) => { $then! { $($given)* $lines } };
    (camera $then:ident [$($given:tt)*] camera $lines:tt $($others:tt)*) => { $then! { $($given)* $lines } };
    ($which:ident $then:ident $given:tt $table:ident $lines:tt $($others:tt)*) => {
        $crate::effects::lines! { $which $then $given $($others)* }
    };
}

pub(crate) use lines;
pub(crate) use survey;
