//! What the test binaries share: seeded randomness, Worlds, tracing, and comparing pictures.
#![allow(dead_code, reason = "every test binary uses a part of it")]

pub(crate) mod case;
pub(crate) mod parts;
pub(crate) mod picture;
pub(crate) mod random;
pub(crate) mod scenes;
pub(crate) mod tracing;
