//! Effects of the camera: blur, exposure, the curve of sRGB.

use archetrace::components::{
    Aperture, CameraPose, Checkerboard, ExposureStops, Lens, Sampling, SrgbTransfer,
};
use archetrace::effects::{Effect, EffectSet};
use archetrace::geometry::Real;
use archetrace::systems::{Frame, Tables};
use bevy_ecs::prelude::*;

use super::{View, lamp, wall_ahead, white};
use crate::support::picture::assert_same;
use crate::support::scenes::full_case;
use crate::support::tracing::trace;

/// The camera of a World gets another component.
fn equip(world: &mut World, effect: impl Bundle) {
    let camera = world.query_filtered::<Entity, With<Lens>>().single(world).unwrap();
    world.entity_mut(camera).insert(effect);
}

/// The share of a disk of radius 1 on the far side of a line at this distance from its middle.
fn segment(distance: f64) -> f64 {
    (distance.acos() - distance * (1.0 - distance * distance).sqrt()) / core::f64::consts::PI
}

#[test]
fn an_edge_out_of_focus_is_blurred_as_wide_as_the_circle_of_confusion() {
    fn check<T: Real>() {
        let (radius, focus, depth) = (2.0, 30.0, 75.0);
        let circle = radius * (depth / focus - 1.0);
        for share in [-1.1, -0.9, -0.5, 0.0, 0.25, 0.8, 1.1] {
            // One pixel that is next to nothing wide, beside the edge of a white cell, which begins to the right.
            let view = View::from_above(-share * circle, 500.0, depth, 1);
            let mut world = View { lens: Lens { fovy: 1e-6, ..view.lens }, ..view }.world();
            world.spawn((Checkerboard { cell: 1000.0 }, white(1.0, 0.0)));
            world.insert_resource(Sampling { side: 64 });
            equip(&mut world, Aperture { radius, focus });
            let found = trace::<T>(&mut world).picture.middle()[0];
            let expected = if share.abs() > 1.0 { f64::from(u8::from(share < 0.0)) } else { segment(share) };
            // 4096 points that are spread evenly miss the area by less than a few rows of their grid.
            assert!((found - expected).abs() < 0.01, "edge at {share}: {found}, on paper {expected}");
        }
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn what_is_in_focus_is_as_sharp_as_through_a_pinhole() {
    // The edge of the cell runs through no pixel centre.
    let picture = |aperture: Option<Aperture>| {
        let mut world = View::from_above(1.234, 500.0, 40.0, 31).world();
        world.spawn((Checkerboard { cell: 1000.0 }, white(1.0, 0.0)));
        if let Some(aperture) = aperture {
            equip(&mut world, aperture);
        }
        trace::<f64>(&mut world).picture
    };
    let sharp = picture(None);
    assert_same("in focus", &sharp, &picture(Some(Aperture { radius: 1.0, focus: 40.0 })));
    assert_ne!(sharp, picture(Some(Aperture { radius: 5.0, focus: 20.0 })));
}

#[test]
fn values_that_do_nothing_are_not_there() {
    fn check<T: Real>() {
        let plain = trace::<T>(&mut full_case().world());
        let mut world = full_case().world();
        equip(&mut world, (Aperture { radius: 0.0, focus: 50.0 }, ExposureStops(0.0)));
        let neutral = trace::<T>(&mut world);
        assert_same("neutral camera", &plain.picture, &neutral.picture);
        assert_eq!(plain.counts, neutral.counts);
        let tables = world.resource::<Tables<T>>();
        let beyond = EffectSet::of(&[Effect::Aperture, Effect::Exposure, Effect::Srgb]);
        assert!(tables.effects().iter().all(|effect| !beyond.contains(effect)));
        assert!(tables.effect_counts().iter().filter(|c| beyond.contains(c.effect)).all(|c| c.bytes == 0));
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn exposure_counts_before_light_is_cut_off() {
    fn check<T: Real>() {
        // A wall that sends back 0.5 and 3 times 0.375: 1.625, which is white.
        let shown = |stops: f64| {
            let mut world = View::one_ray().world();
            world.spawn((wall_ahead(0.0), white(0.5, 0.375)));
            for _ in 0..3 {
                world.spawn(lamp(0.0, -5.0, 0.0));
            }
            equip(&mut world, ExposureStops(stops));
            trace::<T>(&mut world).picture.middle()
        };
        assert_eq!(shown(0.0), [1.0; 3]);
        assert_eq!(shown(-1.0), [0.8125; 3]);
        assert_eq!(shown(-2.0), [0.40625; 3]);
        assert_eq!(shown(1.0), [1.0; 3]);
        let half_stop = shown(-1.5)[0];
        assert!((half_stop - 1.625 * 0.125_f64.sqrt()).abs() < 1e-15, "{half_stop}");
    }
    check::<f64>();
    check::<f32>();
}

/// The bytes of the first pixel and its light.
fn bytes(ambient: f64, srgb: bool) -> (u8, f64) {
    let mut world = View::one_ray().world();
    world.spawn((wall_ahead(0.0), white(ambient, 0.0)));
    if srgb {
        equip(&mut world, SrgbTransfer);
    }
    let light = trace::<f64>(&mut world).picture.middle()[0];
    let (film, _) = world.resource::<Frame>().traced().unwrap();
    (film.to_rgb8()[0], light)
}

#[test]
fn the_curve_of_srgb_changes_bytes_and_no_light() {
    for (light, linear, curved) in [(0.0, 0, 0), (0.18, 45, 117), (0.5, 127, 187), (1.0, 255, 255)] {
        assert_eq!(bytes(light, false), (linear, light));
        assert_eq!(bytes(light, true), (curved, light));
    }
}

#[test]
fn a_film_becomes_linear_again_when_the_camera_does() {
    let mut world = View::one_ray().world();
    world.spawn((wall_ahead(0.0), white(0.5, 0.0)));
    equip(&mut world, SrgbTransfer);
    let shown = |world: &mut World| {
        trace::<f64>(world);
        world.resource::<Frame>().traced().unwrap().0.to_rgb8()[0]
    };
    assert_eq!(shown(&mut world), 187);
    let camera = world.query_filtered::<Entity, With<CameraPose>>().single(&world).unwrap();
    world.entity_mut(camera).remove::<SrgbTransfer>();
    assert_eq!(shown(&mut world), 127);
}
