//! A data-oriented ray tracer: a scene is an ECS World, a picture is traced from its component tables.
//!
//! ```text
//! scene file -parse-> Description -spawn-> World -extract-> SceneTables -trace-> Film -> BMP, PNG, window
//!                                            \-list_draws-> DrawList -preview-> GL
//! ```
//!
//! Nothing points back. Objects, lights and camera are entities; what they can do is said by [`components`];
//! [`systems`] move them into tables; [`trace`] reads tables only.
//!
//! | convention | here |
//! |---|---|
//! | world | right-handed, z up, lengths in world units |
//! | camera | position and orthonormal `l` (look), `r` (right), `u` (up), `u = r x l` |
//! | angles | degrees in components and files |
//! | colour | linear, 0 to 1; 8 bits = channel times 255, truncated |
//! | picture | square; row 0 is the top, column 0 the left; rays through pixel centres; n x n samples are the pixels of an n times finer picture |
//! | level | rays that may follow each other: 0 black, 1 no mirror image |
//! | precision | `f64` unless asked for `f32` |
//!
//! ```
//! use archetrace::components::{Ambient, CameraPose, Color, Lens, Light, Position, Snapshot, Sphere};
//! use archetrace::systems::{Frame, Workers, frame_schedule, prepare};
//! use bevy_ecs::prelude::World;
//!
//! let mut world = World::new();
//! world.spawn((CameraPose::default(), Lens { near: 1.0, far: 1000.0, fovy: 60.0, aspect: 1.0 }));
//! world.spawn((Sphere { radius: 20.0 }, Position::new(0.0, 0.0, 50.0), Color::new(1.0, 0.5, 0.0), Ambient(1.0)));
//! world.insert_resource(Snapshot { pixels: 16, level: 1 });
//! prepare::<f64>(&mut world, Workers::new(None)?);
//! frame_schedule::<f64>().run(&mut world);
//! let (film, _) = world.resource::<Frame>().traced()?;
//! assert_eq!(film.pixels()[8 * 16 + 8], [1.0, 0.5, 0.0]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod cli;
pub mod components;
pub mod effects;
pub mod film;
pub mod geometry;
pub mod image_file;
mod large_pages;
#[cfg(feature = "viewer")]
pub mod preview;
pub mod scene;
pub mod selfcheck;
pub mod study;
#[path = "../systems/mod.rs"]
pub mod systems;
pub mod trace;
#[cfg(feature = "viewer")]
pub mod viewer;
pub mod whole_file;
