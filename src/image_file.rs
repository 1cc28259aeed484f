//! Image files in and out.

use std::fs::File;
use std::io::{BufRead, BufReader, Cursor, Seek};
use std::path::{Path, PathBuf};

use image::codecs::bmp::BmpEncoder;
use image::codecs::png::PngEncoder;
use image::{ImageFormat, ImageReader, Limits, RgbImage};
use thiserror::Error;

use crate::components::Texture;
use crate::film::Film;
use crate::whole_file::{WriteError, write_whole};

/// Most texels along one side of a texture.
pub const MAX_TEXTURE_SIDE: u32 = 8192;

/// A picture or texture file that cannot be used.
#[derive(Debug, Error)]
pub enum ImageFileError {
    /// The ending names no format that can be written.
    #[error("cannot tell the format of {0}: its name must end in .bmp or .png")]
    Ending(PathBuf),
    /// The picture cannot be encoded.
    #[error("cannot encode {0}: {1}")]
    Encode(PathBuf, image::ImageError),
    /// The file cannot be written.
    #[error(transparent)]
    Write(#[from] WriteError),
    /// The texture cannot be read.
    #[error("cannot read texture {0}: {1}")]
    Read(PathBuf, image::ImageError),
    /// The texture is no file.
    #[error("cannot read texture {0}: not a regular file")]
    NotAFile(PathBuf),
    /// The texture's content is in no known format.
    #[error("cannot read texture {0}: neither BMP nor PNG")]
    Format(PathBuf),
    /// The texture is empty.
    #[error("cannot read texture {0}: it has no texel")]
    Empty(PathBuf),
}

/// The format that a name asks for by its ending, `.bmp` or `.png` in any case.
pub fn format_of(path: &Path) -> Result<ImageFormat, ImageFileError> {
    match ImageFormat::from_path(path) {
        Ok(format @ (ImageFormat::Bmp | ImageFormat::Png)) => Ok(format),
        _ => Err(ImageFileError::Ending(path.to_owned())),
    }
}

/// More bytes than the headers of a BMP file are.
const HEADERS: usize = 64;

/// The bytes of a picture file: 24-bit BMP or 8-bit RGB PNG by the path's ending.
pub fn encode(film: &Film, path: &Path) -> Result<Vec<u8>, ImageFileError> {
    encode_rgb8(film.side(), film.to_rgb8(), path)
}

/// The same of a picture of `side` by `side` pixels in 8 bits a channel: red, green, blue, top row first. Bytes that do
/// not fit the side make an empty picture.
pub fn encode_rgb8(side: u32, rgb: Vec<u8>, path: &Path) -> Result<Vec<u8>, ImageFileError> {
    let format = format_of(path)?;
    // Of a BMP nothing is moved then; a PNG is smaller.
    let mut bytes = Vec::with_capacity(rgb.len() + HEADERS);
    let image = RgbImage::from_raw(side, side, rgb).unwrap_or_default();
    let encoded = match format {
        // Straight into memory: through a writer that can seek, a pixel after the other takes a tenth longer.
        ImageFormat::Bmp => image.write_with_encoder(BmpEncoder::new(&mut bytes)),
        _ => image.write_with_encoder(PngEncoder::new(&mut bytes)),
    };
    encoded.map_err(|error| ImageFileError::Encode(path.to_owned(), error))?;
    Ok(bytes)
}

/// Writes a picture, BMP or PNG by the path's ending; the file appears whole or not at all.
pub fn save(film: &Film, path: &Path) -> Result<(), ImageFileError> {
    Ok(write_whole(path, &encode(film, path)?)?)
}

/// Reads a texture of at most [`MAX_TEXTURE_SIDE`] texels a side, BMP or PNG by its content.
pub fn load_texture(path: &Path) -> Result<Texture, ImageFileError> {
    let unreadable = |error| ImageFileError::Read(path.to_owned(), error);
    let metadata = path.metadata().map_err(|error| unreadable(error.into()))?;
    if !metadata.is_file() {
        return Err(ImageFileError::NotAFile(path.to_owned()));
    }
    // By content alone: `ImageReader::open` would go by the ending where the content says nothing.
    let reader =
        File::open(path).and_then(|file| ImageReader::new(BufReader::new(file)).with_guessed_format());
    let reader = reader.map_err(|error| unreadable(error.into()))?;
    if reader.format().is_none() {
        return Err(ImageFileError::Format(path.to_owned()));
    }
    let image = decode(reader).map_err(unreadable)?;
    texture(&image).ok_or_else(|| ImageFileError::Empty(path.to_owned()))
}

/// Reads a texture from the bytes of a file; `None` if they are none.
pub fn decode_texture(bytes: &[u8]) -> Option<Texture> {
    let reader = ImageReader::new(Cursor::new(bytes)).with_guessed_format().ok()?;
    texture(&decode(reader).ok()?)
}

fn decode<R: BufRead + Seek>(mut reader: ImageReader<R>) -> image::ImageResult<RgbImage> {
    let mut limits = Limits::default();
    limits.max_image_width = Some(MAX_TEXTURE_SIDE);
    limits.max_image_height = Some(MAX_TEXTURE_SIDE);
    reader.limits(limits);
    Ok(reader.decode()?.into_rgb8())
}

fn texture(image: &RgbImage) -> Option<Texture> {
    Texture::new(image.width(), image.height(), image.pixels().map(|texel| texel.0).collect())
}
