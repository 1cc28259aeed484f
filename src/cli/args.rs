//! What can be asked for.

use std::num::NonZeroUsize;
use std::path::PathBuf;

use clap::builder::TypedValueParser;
use clap::error::ErrorKind;
use clap::{CommandFactory, Parser, Subcommand, ValueEnum};
use glam::DVec3;

use crate::components::range::{COORDINATE, MAX_LEVEL, MAX_PIXELS};
use crate::image_file::format_of;

const EXAMPLES: &str = "\
Examples:
  archetrace render scenes/official.txt -o official.bmp
  archetrace render scenes/official.txt -o side.png --eye -150,-50,60 --look 1,0.4,-0.2 --size 512
  archetrace check scenes/official.txt";

/// A data-oriented ray tracer: scene description in, picture out.
#[derive(Debug, Parser)]
#[command(version, about, after_help = EXAMPLES)]
pub(super) struct Args {
    #[command(subcommand)]
    pub(super) command: Command,
}

#[derive(Debug, Subcommand)]
pub(super) enum Command {
    Render(RenderArgs),
    Check(CheckArgs),
    Write(WriteArgs),
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
    /// Eye position
    #[arg(long, value_name = "X,Y,Z", default_value = "0,-150,50", value_parser = point, allow_hyphen_values = true)]
    pub(super) eye: DVec3,
    /// Direction to look in; any length but 0
    #[arg(long, value_name = "X,Y,Z", default_value = "0,1,0", value_parser = direction, allow_hyphen_values = true)]
    pub(super) look: DVec3,
    /// Direction to the top of the picture; any length but 0
    #[arg(long, value_name = "X,Y,Z", default_value = "0,0,1", value_parser = direction, allow_hyphen_values = true)]
    pub(super) up: DVec3,
    /// Pixels along each side [default: the scene's]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=i64::from(MAX_PIXELS)))]
    pub(super) size: Option<u32>,
    /// Level of recursion: 0 is black, 1 has no mirror image [default: the scene's]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(0..=i64::from(MAX_LEVEL)))]
    pub(super) level: Option<u32>,
    /// Lay images on the checkerboard: `texture_w.bmp` and `texture_b.bmp` beside the scene, or built-in ones
    #[arg(long)]
    pub(super) texture: bool,
    /// Image for the white cells
    #[arg(long, value_name = "FILE", requires = "texture")]
    pub(super) white: Option<PathBuf>,
    /// Image for the black cells
    #[arg(long, value_name = "FILE", requires = "texture")]
    pub(super) black: Option<PathBuf>,
    /// Floating-point precision of the trace
    #[arg(long, value_enum, default_value_t = Precision::F64)]
    pub(super) precision: Precision,
    /// Threads that trace [default: one per processor]
    #[arg(long, value_name = "N", value_parser = thread_count())]
    pub(super) threads: Option<NonZeroUsize>,
    /// Write what was measured and counted
    #[arg(long, value_name = "FILE.json")]
    pub(super) stats: Option<PathBuf>,
}

const RENDER_HELP: &str = "\
The camera looks along l = unit(look), with r = unit(look x up) to the right and u = r x l to the top. \
Where look is parallel to up, +y takes the part of up.

Examples:
  archetrace render scenes/official.txt -o official.bmp
  archetrace render scenes/official.txt -o top.png --eye 0,0,200 --look 0,0,-1 --texture
  archetrace render scenes/official.txt -o side.bmp --eye=-150,-50,60 --look 1,0.4,-0.2 --stats side.json";

impl Args {
    /// The arguments of the process. Ends it with status 2 if they make no sense, with 0 after `--help`.
    pub(super) fn of_process() -> Self {
        let args = Self::parse();
        match &args.command {
            Command::Render(render) if render.stats.as_ref() == Some(&render.output) => {
                let message = "--stats and --output must be different files";
                Self::command().error(ErrorKind::ArgumentConflict, message).exit()
            }
            _ => args,
        }
    }
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

/// Floating-point precision of the trace.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Precision {
    /// Double precision
    F64,
    /// Single precision
    F32,
}

fn picture_path() -> impl TypedValueParser<Value = PathBuf> {
    clap::builder::PathBufValueParser::new()
        .try_map(|path| format_of(&path).map(|_| path).map_err(|error| error.to_string()))
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
