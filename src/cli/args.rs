//! What can be asked for.

use std::env;
use std::ffi::OsString;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use clap::builder::TypedValueParser;
use clap::error::ErrorKind;
use clap::{Args as ClapArgs, CommandFactory, Parser, Subcommand, ValueEnum};
use glam::DVec3;

use crate::components;
use crate::components::range::{COORDINATE, MAX_PIXELS};
use crate::effects::Effect;
use crate::image_file::format_of;

use super::accuracy_args::{AccuracyArgs, WishArgs};

const EXAMPLES: &str = "\
Examples:
  archetrace scenes/official.txt
  archetrace render scenes/official.txt -o official.bmp
  archetrace render scenes/official.txt -o side.png --eye -150,-50,60 --look 1,0.4,-0.2 --size 512
  archetrace check scenes/official.txt";

/// A data-oriented ray tracer: scene description in, picture out.
#[derive(Debug, Parser)]
#[command(version, about, after_help = EXAMPLES)]
#[cfg_attr(feature = "viewer", command(override_usage = USAGE))]
pub(super) struct Args {
    #[command(subcommand)]
    command: Command,
}

#[cfg(feature = "viewer")]
const USAGE: &str = "archetrace <COMMAND>\n       archetrace <SCENE>  (short for: archetrace view <SCENE>)";

#[derive(Debug, Subcommand)]
pub(super) enum Command {
    Render(RenderArgs),
    #[cfg(feature = "viewer")]
    Preview(PreviewArgs),
    Check(CheckArgs),
    Effects(EffectsArgs),
    Cost(CostArgs),
    Write(WriteArgs),
    Selfcheck(SelfcheckArgs),
    #[cfg(feature = "viewer")]
    View(ViewArgs),
}

/// Trace a scene and write the picture.
#[derive(Debug, Parser)]
#[command(after_help = RENDER_HELP)]
pub(super) struct RenderArgs {
    /// Scene description
    pub(super) scene: PathBuf,
    /// Picture to write: .bmp or .png
    #[arg(short, long, value_name = "OUT", value_parser = picture_path())]
    pub(super) output: PathBuf,
    #[command(flatten)]
    pub(super) picture: PictureArgs,
    #[command(flatten)]
    pub(super) wish: WishArgs,
    /// Switch an effect off, as if no entity asked for it: its name in `archetrace effects`; more than once for more
    #[arg(long, value_name = "EFFECT", value_parser = effect())]
    pub(super) without: Vec<Effect>,
    /// Trace with the kernel that has every effect, whatever the scene asks for: the same picture, only slower
    #[arg(long)]
    pub(super) all_effects: bool,
    /// Write what was measured and counted
    #[arg(long, value_name = "FILE.json")]
    pub(super) stats: Option<PathBuf>,
}

/// What is traced of a scene, and how.
#[derive(Debug, ClapArgs)]
pub(super) struct PictureArgs {
    #[command(flatten)]
    pub(super) camera: CameraArgs,
    /// Pixels along each side [default: the scene's]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=i64::from(MAX_PIXELS)))]
    pub(super) size: Option<u32>,
    #[command(flatten)]
    pub(super) accuracy: AccuracyArgs,
    #[command(flatten)]
    pub(super) images: ImageArgs,
    /// Threads that trace [default: one per processor]
    #[arg(long, value_name = "N", value_parser = thread_count())]
    pub(super) threads: Option<NonZeroUsize>,
}

impl PictureArgs {
    /// What a scene shows through a camera, everything else as it is.
    pub(super) fn of_scene(camera: &CameraArgs, images: &ImageArgs) -> Self {
        let (camera, images) = (camera.clone(), images.clone());
        Self { camera, size: None, accuracy: AccuracyArgs::default(), images, threads: None }
    }
}

/// Say what effects a scene asks for, who asks for them, and what each costs: rays, rows, bytes, milliseconds, and the
/// difference that it makes to the picture.
#[derive(Debug, Parser)]
pub(super) struct EffectsArgs {
    /// Scene description
    pub(super) scene: PathBuf,
    #[command(flatten)]
    pub(super) picture: PictureArgs,
    /// How often each frame is traced, in turns with the others
    #[arg(long, value_name = "N", default_value = "5", value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub(super) rounds: u32,
    /// Print JSON
    #[arg(long)]
    pub(super) json: bool,
    /// Draw the milliseconds as bars
    #[arg(long, value_name = "FILE.svg")]
    pub(super) chart: Option<PathBuf>,
    /// Count instructions as well, with valgrind
    #[arg(long)]
    pub(super) instructions: bool,
}

/// Show what accuracy costs in time: trace a scene with every knob turned, compare with a reference, and write the price
/// list.
#[derive(Debug, Parser)]
#[command(after_help = COST_HELP)]
pub(super) struct CostArgs {
    /// Scene description
    pub(super) scene: PathBuf,
    /// Folder for the report: cost.html, cost.csv, cost.json, cost.svg and pictures [default: <scene>-cost]
    #[arg(short, long, value_name = "DIR")]
    pub(super) output: Option<PathBuf>,
    /// Fewer settings and samples, at 256 pixels or less
    #[arg(long)]
    pub(super) quick: bool,
    /// How often each setting is traced, in turns with the others [default: 7, or 3 with --quick]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub(super) rounds: Option<u32>,
    /// Count instructions as well, with valgrind
    #[arg(long)]
    pub(super) instructions: bool,
    #[command(flatten)]
    pub(super) camera: CameraArgs,
    /// Pixels along each side [default: the scene's]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(8..=4096))]
    pub(super) size: Option<u32>,
    #[command(flatten)]
    pub(super) images: ImageArgs,
    /// Threads that trace [default: one per processor]
    #[arg(long, value_name = "N", value_parser = thread_count())]
    pub(super) threads: Option<NonZeroUsize>,
}

const COST_HELP: &str = "\
Ctrl-C ends it early; what was measured until then is written.

Examples:
  archetrace cost scenes/official.txt --quick
  archetrace cost scenes/official.txt -o prices --size 512 --instructions";

/// Where the camera stands and where it looks.
#[derive(Clone, Debug, ClapArgs)]
pub(super) struct CameraArgs {
    /// Eye position
    #[arg(long, value_name = "X,Y,Z", default_value = "0,-150,50", value_parser = point, allow_hyphen_values = true)]
    pub(super) eye: DVec3,
    /// Direction to look in; any length but 0
    #[arg(long, value_name = "X,Y,Z", default_value = "0,1,0", value_parser = direction, allow_hyphen_values = true)]
    pub(super) look: DVec3,
    /// Direction to the top of the picture; any length but 0
    #[arg(long, value_name = "X,Y,Z", default_value = "0,0,1", value_parser = direction, allow_hyphen_values = true)]
    pub(super) up: DVec3,
}

/// What lies on the checkerboard.
#[derive(Clone, Debug, ClapArgs)]
pub(super) struct ImageArgs {
    /// Lay images on the checkerboard: `texture_w.bmp` and `texture_b.bmp` beside the scene, or built-in ones
    #[arg(long)]
    pub(super) texture: bool,
    /// Image for the white cells
    #[arg(long, value_name = "FILE", requires = "texture")]
    pub(super) white: Option<PathBuf>,
    /// Image for the black cells
    #[arg(long, value_name = "FILE", requires = "texture")]
    pub(super) black: Option<PathBuf>,
}

/// Draw the preview of a scene off screen and write the picture.
#[cfg(feature = "viewer")]
#[derive(Debug, Parser)]
#[command(after_help = PREVIEW_HELP)]
pub(super) struct PreviewArgs {
    /// Scene description
    pub(super) scene: PathBuf,
    /// Picture to write: .bmp or .png
    #[arg(short, long, value_name = "OUT", value_parser = picture_path())]
    pub(super) output: PathBuf,
    #[command(flatten)]
    pub(super) camera: CameraArgs,
    /// Pixels along each side [default: the scene's]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=i64::from(MAX_PIXELS)))]
    pub(super) size: Option<u32>,
    #[command(flatten)]
    pub(super) images: ImageArgs,
    /// Mark lights, and the cones of spotlights
    #[arg(long)]
    pub(super) lights: bool,
    /// Draw the world's axes: x red, y green, z blue
    #[arg(long)]
    pub(super) axes: bool,
    /// One sample a pixel, so that every pixel shows one object alone
    #[arg(long)]
    pub(super) plain: bool,
}

#[cfg(feature = "viewer")]
const PREVIEW_HELP: &str = "\
Objects show their own colour, without light. The camera is that of `archetrace render`. OpenGL 3.3 is needed, a \
display is not.

Examples:
  archetrace preview scenes/official.txt -o official.png
  archetrace preview scenes/cone_edge.txt -o lights.png --lights --axes --eye 0,-200,120 --look 0,1,-0.5";

impl ImageArgs {
    /// The images that are asked for, as arguments.
    #[cfg(feature = "viewer")]
    pub(super) fn arguments(&self) -> Vec<OsString> {
        let named = [("--white", &self.white), ("--black", &self.black)];
        let files =
            named.into_iter().filter_map(|(flag, file)| Some([flag.into(), file.clone()?.into_os_string()]));
        std::iter::once("--texture".into()).chain(files.flatten()).collect()
    }
}

const RENDER_HELP: &str = "\
The camera looks along l = unit(look), with r = unit(look x up) to the right and u = r x l to the top. \
Where look is parallel to up, +y takes the part of up.

Examples:
  archetrace render scenes/official.txt -o official.bmp
  archetrace render scenes/official.txt -o top.png --eye 0,0,200 --look 0,0,-1 --texture
  archetrace render scenes/official.txt -o side.bmp --eye=-150,-50,60 --look 1,0.4,-0.2 --stats side.json";

impl Args {
    /// The command of the process. Ends it with status 2 if the arguments make no sense, with 0 after `--help`.
    pub(super) fn of_process() -> Command {
        let command = Self::parse_from(with_command(env::args_os().collect())).command;
        match &command {
            Command::Render(render) if render.stats.as_ref() == Some(&render.output) => {
                let message = "--stats and --output must be different files";
                Self::command().error(ErrorKind::ArgumentConflict, message).exit()
            }
            _ => command,
        }
    }
}

/// A file instead of a command is a scene to view.
fn with_command(mut arguments: Vec<OsString>) -> Vec<OsString> {
    let names_file = |word: &OsString| Path::new(word).components().count() > 1 || Path::new(word).is_file();
    let is_command = |word: &OsString| Args::command().find_subcommand(word).is_some();
    if cfg!(feature = "viewer") && arguments.get(1).is_some_and(|word| names_file(word) && !is_command(word))
    {
        arguments.insert(1, "view".into());
    }
    arguments
}

/// Validate a scene and print what is in it.
#[derive(Debug, Parser)]
pub(super) struct CheckArgs {
    /// Scene description
    pub(super) scene: PathBuf,
}

/// Write the World that a scene spawns back as a scene description.
#[derive(Debug, Parser)]
pub(super) struct WriteArgs {
    /// Scene description
    pub(super) scene: PathBuf,
    /// File to write [default: standard output]
    #[arg(short, long, value_name = "OUT")]
    pub(super) output: Option<PathBuf>,
}

/// Hold the kernels of this program against exact truth, on this machine.
#[derive(Debug, Parser)]
#[command(after_help = SELFCHECK_HELP)]
pub(super) struct SelfcheckArgs {
    /// Ten million rays of each kind instead of a hundred thousand: takes many minutes
    #[arg(long)]
    pub(super) long: bool,
}

const SELFCHECK_HELP: &str = "\
Each line is a kind of rays in one precision: how many, how many of their parameters are off by up to 1/2, 1, 2, 4 and \
more epsilons, the largest error, surfaces missed and met falsely, and answers wrong in another way. Status 1 if any is.

Example:
  archetrace selfcheck";

/// Open a window on a scene: fly through it, edit it, trace it with 0.
#[cfg(feature = "viewer")]
#[derive(Debug, Parser)]
pub(super) struct ViewArgs {
    /// Scene description
    pub(super) scene: PathBuf,
    #[command(flatten)]
    pub(super) camera: CameraArgs,
    #[command(flatten)]
    pub(super) images: ImageArgs,
    /// Floating-point precision of the trace
    #[arg(long, value_enum, default_value_t = Precision::F64)]
    pub(super) precision: Precision,
    /// Threads that trace [default: one per processor]
    #[arg(long, value_name = "N", value_parser = thread_count())]
    pub(super) threads: Option<NonZeroUsize>,
    /// Folder for traced pictures [default: the current one]
    #[arg(long, value_name = "DIR")]
    pub(super) out: Option<PathBuf>,
    /// Write the camera's pose to standard output, at the start and at every change
    #[arg(long)]
    pub(super) print_camera: bool,
    /// Write whatever happens to standard output, one JSON object a line
    #[arg(long)]
    pub(super) print_events: bool,
}

/// Floating-point precision of the trace.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Precision {
    /// Double precision
    F64,
    /// Single precision
    F32,
}

impl From<Precision> for components::Precision {
    fn from(precision: Precision) -> Self {
        match precision {
            Precision::F64 => Self::F64,
            Precision::F32 => Self::F32,
        }
    }
}

fn picture_path() -> impl TypedValueParser<Value = PathBuf> {
    clap::builder::PathBufValueParser::new()
        .try_map(|path| format_of(&path).map(|_| path).map_err(|error| error.to_string()))
}

fn effect() -> impl TypedValueParser<Value = Effect> {
    clap::builder::PossibleValuesParser::new(Effect::ALL.map(Effect::name)).try_map(|name| {
        Effect::ALL.into_iter().find(|effect| effect.name() == name).ok_or("must be the name of an effect")
    })
}

fn thread_count() -> impl TypedValueParser<Value = NonZeroUsize> {
    /// More would be a slip of the finger, and each costs memory.
    const MAX_THREADS: i64 = 1024;
    clap::value_parser!(u32).range(1..=MAX_THREADS).try_map(|count| NonZeroUsize::try_from(count as usize))
}

fn point(text: &str) -> Result<DVec3, String> {
    let mut numbers = text.split(',').map(|part| part.trim().parse::<f64>().ok());
    let mut next = || numbers.next().flatten().filter(|number| COORDINATE.contains(*number));
    match (next(), next(), next(), numbers.next()) {
        (Some(x), Some(y), Some(z), None) => Ok(DVec3::new(x, y, z)),
        _ => Err(format!("must be three numbers with commas between, each {}", COORDINATE.words)),
    }
}

fn direction(text: &str) -> Result<DVec3, String> {
    match point(text)? {
        DVec3::ZERO => Err("must not be zero: it has no direction".into()),
        direction => Ok(direction),
    }
}
