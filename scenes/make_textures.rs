//! Draws the two images of the checkerboard anew: `cargo run --example make_textures [FOLDER]`.
//!
//! They go to the folder of the scenes unless another one is named.

use std::env;
use std::error::Error;
use std::path::{Path, PathBuf};

use image::RgbImage;

#[path = "textures.rs"]
mod textures;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = env::args_os()
        .nth(1)
        .map_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes"), PathBuf::from);
    write(&folder.join("texture_w.bmp"), textures::white())?;
    write(&folder.join("texture_b.bmp"), textures::black())
}

fn write(path: &Path, (width, height, texels): (u32, u32, Vec<[u8; 3]>)) -> Result<(), Box<dyn Error>> {
    let image = RgbImage::from_raw(width, height, texels.concat()).ok_or("too few texels")?;
    image.save(path)?;
    Ok(())
}
