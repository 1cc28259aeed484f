//! Picture files: the same pixels in both formats, and a BMP byte by byte.

use image::{ImageFormat, RgbImage};

use crate::program::Folder;

fn decode(bytes: &[u8], format: ImageFormat) -> RgbImage {
    let image = image::load_from_memory_with_format(bytes, format).unwrap();
    assert_eq!(image.color(), image::ColorType::Rgb8);
    image.into_rgb8()
}

#[test]
fn both_formats_hold_the_same_pixels() {
    let folder = Folder::with_scene();
    folder.run("render scene.txt -o out.bmp").quiet();
    folder.run("render scene.txt -o out.png").quiet();
    let bmp = decode(&folder.read("out.bmp"), ImageFormat::Bmp);
    let png = decode(&folder.read("out.png"), ImageFormat::Png);
    assert_eq!(bmp.dimensions(), (32, 32));
    assert!(bmp == png);
    let mut colors: Vec<[u8; 3]> = bmp.pixels().map(|pixel| pixel.0).collect();
    colors.sort_unstable();
    colors.dedup();
    assert!(colors.len() > 50, "only {} colours", colors.len());
}

/// The 54 bytes before the pixels: file header and BITMAPINFOHEADER, after the format's own description.
fn header(side: u32) -> Vec<u8> {
    let stride = (3 * side).div_ceil(4) * 4;
    let pixels = stride * side;
    let mut bytes = b"BM".to_vec();
    bytes.extend((54 + pixels).to_le_bytes()); // size of the file
    bytes.extend(0_u32.to_le_bytes()); // reserved
    bytes.extend(54_u32.to_le_bytes()); // where the pixels start
    bytes.extend(40_u32.to_le_bytes()); // size of the second header
    bytes.extend(side.to_le_bytes()); // width
    bytes.extend(side.to_le_bytes()); // height; positive: bottom row first
    bytes.extend(1_u16.to_le_bytes()); // planes
    bytes.extend(24_u16.to_le_bytes()); // bits a pixel
    bytes.extend(0_u32.to_le_bytes()); // no compression
    bytes.extend(pixels.to_le_bytes()); // size of the pixels
    bytes.extend([0; 16]); // resolution and palette: nothing said
    bytes
}

/// Rows from the bottom, each blue, green, red and filled up with zeros to a multiple of four bytes.
fn body(image: &RgbImage) -> Vec<u8> {
    let mut bytes = Vec::new();
    for y in (0..image.height()).rev() {
        for x in 0..image.width() {
            let [red, green, blue] = image.get_pixel(x, y).0;
            bytes.extend([blue, green, red]);
        }
        while bytes.len() % 4 != 0 {
            bytes.push(0);
        }
    }
    bytes
}

#[test]
fn a_bmp_is_right_byte_by_byte() {
    let folder = Folder::with_scene();
    for (side, length) in [(1, 58), (2, 70), (3, 90), (4, 102), (5, 134), (32, 3126)] {
        // From here the floor fills the bottom of the picture, and the top is empty.
        let view = format!("--eye 5,-60,20 --look 0,1,-0.1 --size {side}");
        folder.run(&format!("render scene.txt -o out.png {view}")).quiet();
        let png = decode(&folder.read("out.png"), ImageFormat::Png);
        assert_eq!(png.dimensions(), (side, side));
        let bmp = folder.render(&view);
        assert_eq!(bmp.len(), length, "side {side}");
        assert_eq!(bmp[..54], header(side), "side {side}");
        assert_eq!(bmp[54..], body(&png), "side {side}");
        assert!(bmp[54..].iter().any(|&byte| byte != 0), "side {side}: black throughout");
    }
}

#[test]
fn the_top_row_is_the_top_and_the_left_column_the_left() {
    // A red sphere in the upper left quarter; below, four cells that meet at the origin, 150 ahead and 50 below the
    // eye. Rows are 0.25 apart on a plane at distance 1, so row 4 meets the floor 400 ahead, row 5 no more than 133
    // ahead. Ambient light only: every colour is one of three.
    let scene = "1 1000 90 1 1 8  1e6 1 0 0  1  sphere -50 -50 100 30  1 0 0  1 0 0 0  1  0 0";
    let folder = Folder::empty();
    folder.put("scene.txt", scene);
    folder.run("render scene.txt -o out.png").quiet();
    let image = decode(&folder.read("out.png"), ImageFormat::Png);
    let with_color = |color: [u8; 3]| {
        let pixels = image.enumerate_pixels().filter(move |(_, _, pixel)| pixel.0 == color);
        pixels.map(|(x, y, _)| (x, y)).collect::<Vec<_>>()
    };
    let (red, white) = (with_color([255, 0, 0]), with_color([255; 3]));
    assert!(!red.is_empty());
    assert!(red.iter().all(|&(x, y)| x < 4 && y < 4), "red at {red:?}");
    let beyond = (4..8).map(|x| (x, 4));
    let before = (5..8).flat_map(|y| (0..4).map(move |x| (x, y)));
    assert_eq!(white, beyond.chain(before).collect::<Vec<_>>());
    assert_eq!(red.len() + white.len() + with_color([0; 3]).len(), 64);
}
