//! What the benches of scene files are told.

use std::error::Error;
use std::num::NonZeroUsize;
use std::path::PathBuf;

use archetrace::components::{CameraPose, Snapshot};
use archetrace::scene::{Source, spawn};
use archetrace::trace::Simd;
use bevy_ecs::prelude::World;
use clap::{Args, ValueEnum};
use glam::DVec3;

/// A scene file, how it is looked at, and what with.
#[derive(Clone, Debug, Args)]
pub(crate) struct View {
    /// Scene description
    pub(crate) scene: PathBuf,
    /// Eye position
    #[arg(long, default_value = "0,-150,50", value_parser = vector, allow_hyphen_values = true)]
    eye: DVec3,
    /// Direction of view
    #[arg(long, default_value = "0,1,0", value_parser = vector, allow_hyphen_values = true)]
    look: DVec3,
    /// Pixels along each side; the scene's unless given
    #[arg(long)]
    size: Option<u32>,
    #[arg(long, value_enum, default_value = "f64")]
    pub(crate) precision: Precision,
    /// Threads that trace; one per processor unless given
    #[arg(long)]
    pub(crate) threads: Option<NonZeroUsize>,
    /// Vector instructions by number, 0 for those that every processor has; the widest unless given
    #[arg(long)]
    simd: Option<usize>,
    /// Given by cargo
    #[arg(long, hide = true)]
    bench: bool,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
pub(crate) enum Precision {
    F32,
    F64,
}

impl View {
    /// Spawns the scene and puts the camera in its place; returns the pixels along each side.
    pub(crate) fn set_up(&self, world: &mut World) -> Result<u32, Box<dyn Error>> {
        spawn(world, &Source::read(&self.scene)?.load()?.description);
        let pose = CameraPose::looking(self.eye, self.look, DVec3::Z).ok_or("no direction of view")?;
        for mut camera in world.query::<&mut CameraPose>().iter_mut(world) {
            *camera = pose;
        }
        let mut snapshot = world.resource_mut::<Snapshot>();
        snapshot.pixels = self.size.unwrap_or(snapshot.pixels);
        Ok(snapshot.pixels)
    }

    /// The vector instructions that were asked for.
    pub(crate) fn simd(&self) -> Result<Simd, Box<dyn Error>> {
        let Some(number) = self.simd else { return Ok(Simd::detect()) };
        Ok(*Simd::available().get(number).ok_or("this processor has no such instructions")?)
    }
}

fn vector(text: &str) -> Result<DVec3, String> {
    let numbers: Vec<f64> =
        text.split(',').map(str::parse).collect::<Result<_, _>>().map_err(|_| "three numbers X,Y,Z")?;
    <[f64; 3]>::try_from(numbers).map(DVec3::from_array).map_err(|_| "three numbers X,Y,Z".to_owned())
}
