//! Which images lie on the checkerboard, and which cannot.

use std::io::Cursor;
use std::process::Command;

use image::{ImageFormat, Rgb, RgbImage};

use crate::program::Folder;

/// The board from above in nothing but its own light: every pixel is a texel.
const BOARD: &str = "1 1000 60 1 1 16  40 1 0 0  0 0 0";
const FROM_ABOVE: &str = "--eye 5,7,100 --look 0,0,-1 --texture";

fn folder_with_board() -> Folder {
    let folder = Folder::empty();
    folder.put("scene.txt", BOARD);
    folder
}

fn file_of(color: [u8; 3], format: ImageFormat) -> Vec<u8> {
    let mut bytes = Vec::new();
    RgbImage::from_pixel(2, 3, Rgb(color)).write_to(&mut Cursor::new(&mut bytes), format).unwrap();
    bytes
}

fn bmp_of(color: [u8; 3]) -> Vec<u8> {
    file_of(color, ImageFormat::Bmp)
}

const RED: [u8; 3] = [255, 0, 0];
const BLUE: [u8; 3] = [0, 0, 255];
const GREEN: [u8; 3] = [0, 255, 0];

/// The colours of the board in a picture, in order.
fn colors(folder: &Folder, arguments: &str) -> Vec<[u8; 3]> {
    let bytes = folder.render(&format!("{FROM_ABOVE} {arguments}"));
    let image = image::load_from_memory_with_format(&bytes, ImageFormat::Bmp).unwrap();
    let mut colors: Vec<[u8; 3]> = image.into_rgb8().pixels().map(|pixel| pixel.0).collect();
    colors.sort_unstable();
    colors.dedup();
    colors
}

#[test]
fn images_beside_the_scene_are_used() {
    let folder = folder_with_board();
    folder.put("texture_w.bmp", bmp_of(RED));
    folder.put("texture_b.bmp", bmp_of(BLUE));
    assert_eq!(colors(&folder, ""), [BLUE, RED]);
}

#[test]
fn images_beside_the_scene_are_found_from_anywhere() {
    let folder = folder_with_board();
    folder.put("texture_w.bmp", bmp_of(RED));
    folder.put("texture_b.bmp", bmp_of(BLUE));
    let elsewhere = Folder::empty();
    let scene = folder.path("scene.txt");
    elsewhere.run(&format!("render {} -o out.bmp {FROM_ABOVE}", scene.display())).quiet();
    assert_eq!(elsewhere.read("out.bmp"), folder.render(FROM_ABOVE));
}

#[test]
fn named_images_win_over_those_beside_the_scene() {
    let folder = folder_with_board();
    folder.put("texture_w.bmp", bmp_of(RED));
    folder.put("texture_b.bmp", bmp_of(BLUE));
    folder.put("other.bmp", bmp_of(GREEN));
    assert_eq!(colors(&folder, "--white other.bmp"), [BLUE, GREEN]);
    assert_eq!(colors(&folder, "--black other.bmp"), [GREEN, RED]);
    assert_eq!(colors(&folder, "--black other.bmp --white other.bmp"), [GREEN]);
}

#[test]
fn without_images_the_built_in_ones_are_used() {
    let folder = folder_with_board();
    let built_in = folder.render(FROM_ABOVE);
    let scenes = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes");
    let named =
        folder.render(&format!("{FROM_ABOVE} --white {scenes}/texture_w.bmp --black {scenes}/texture_b.bmp"));
    assert!(built_in == named);
    let swapped =
        folder.render(&format!("{FROM_ABOVE} --white {scenes}/texture_b.bmp --black {scenes}/texture_w.bmp"));
    assert!(built_in != swapped);
    assert!(colors(&folder, "").len() > 20);
}

#[test]
fn one_image_beside_the_scene_leaves_the_other_built_in() {
    let folder = folder_with_board();
    let scenes = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes");
    folder.put("texture_w.bmp", bmp_of(RED));
    let found = folder.render(FROM_ABOVE);
    assert!(found == folder.render(&format!("{FROM_ABOVE} --black {scenes}/texture_b.bmp")));
    assert!(colors(&folder, "").contains(&RED));
}

#[test]
fn without_the_option_images_mean_nothing() {
    let folder = folder_with_board();
    let view = FROM_ABOVE.replace("--texture", "");
    let plain = folder.render(&view);
    folder.put("texture_w.bmp", bmp_of(RED));
    folder.put("texture_b.bmp", "no image");
    assert!(plain == folder.render(&view));
    assert!(plain[54..].iter().all(|byte| [0, 255].contains(byte)));
}

#[test]
fn the_content_decides_the_format_not_the_name() {
    let folder = folder_with_board();
    folder.put("white.bmp", file_of(GREEN, ImageFormat::Png));
    folder.put("black", file_of(BLUE, ImageFormat::Bmp));
    assert_eq!(colors(&folder, "--white white.bmp --black black"), [BLUE, GREEN]);
}

/// A file that cannot be a texture; the line, which names it.
#[track_caller]
fn refused(folder: &Folder, name: &str) -> String {
    let before = folder.names();
    let mut lines = ["white", "black"].map(|side| {
        let arguments = format!("render scene.txt -o out.bmp {FROM_ABOVE} --{side} {name}");
        folder.run(&arguments).refusal()
    });
    assert_eq!(folder.names(), before);
    assert_eq!(lines[0], lines[1]);
    let line = core::mem::take(&mut lines[0]);
    assert!(line.starts_with(&format!("error: cannot read texture {name}: ")), "{line}");
    line
}

#[test]
fn what_is_no_file_is_no_texture() {
    let folder = folder_with_board();
    assert!(refused(&folder, "none.bmp").contains("No such file or directory"));
    assert!(refused(&folder, ".").ends_with("not a regular file"));
    assert!(refused(&folder, "/dev/zero").ends_with("not a regular file"));
    let made = Command::new("mkfifo").arg(folder.path("pipe")).status().unwrap();
    assert!(made.success());
    assert!(refused(&folder, "pipe").ends_with("not a regular file"));
}

#[test]
fn a_broken_image_beside_the_scene_is_refused_too() {
    let folder = folder_with_board();
    folder.put("texture_b.bmp", "no image");
    let line = folder.run(&format!("render scene.txt -o out.bmp {FROM_ABOVE}")).refusal();
    assert!(line.starts_with("error: cannot read texture texture_b.bmp: "), "{line}");
}

#[test]
fn a_corrupt_image_is_refused() {
    let folder = folder_with_board();
    for format in [ImageFormat::Bmp, ImageFormat::Png] {
        let whole = file_of(RED, format);
        folder.put("cut.bmp", &whole[..whole.len() / 2]);
        refused(&folder, "cut.bmp");
        folder.put("start.bmp", &whole[..8]);
        refused(&folder, "start.bmp");
    }
    folder.put("noise.bmp", "BM and then nothing that makes sense, but for long enough to hold a header");
    refused(&folder, "noise.bmp");
}

#[test]
fn what_is_no_image_at_all_is_said_to_be_none() {
    let folder = folder_with_board();
    folder.put("empty.bmp", "");
    folder.put("text.txt", "no image");
    folder.put("text.bmp", "no image");
    for name in ["empty.bmp", "text.txt", "text.bmp"] {
        let line = refused(&folder, name);
        // Nobody knows what buffer that would be, and the ending is not what is wrong.
        for riddle in ["buffer", "extension"] {
            assert!(!line.contains(riddle), "{line}");
        }
    }
}

/// The start of a BMP with the sides that it claims.
fn bmp_claiming(width: i32, height: i32) -> Vec<u8> {
    let mut bytes = bmp_of(RED);
    bytes[18..22].copy_from_slice(&width.to_le_bytes());
    bytes[22..26].copy_from_slice(&height.to_le_bytes());
    bytes
}

/// A PNG with the sides that it claims; its checksum is right.
fn png_claiming(width: u32, height: u32) -> Vec<u8> {
    let mut bytes = file_of(RED, ImageFormat::Png);
    bytes[16..20].copy_from_slice(&width.to_be_bytes());
    bytes[20..24].copy_from_slice(&height.to_be_bytes());
    let checksum = crc32(&bytes[12..29]);
    bytes[29..33].copy_from_slice(&checksum.to_be_bytes());
    bytes
}

fn crc32(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |crc, &byte| {
        (0..8).fold(crc ^ u32::from(byte), |crc, _| {
            let carry = if crc & 1 == 1 { 0xedb8_8320 } else { 0 };
            (crc >> 1) ^ carry
        })
    })
}

#[test]
fn the_checksum_of_these_tests_is_that_of_png() {
    let bytes = file_of(RED, ImageFormat::Png);
    assert_eq!(bytes[29..33], crc32(&bytes[12..29]).to_be_bytes());
    assert_eq!(png_claiming(2, 3), bytes);
    assert_eq!(bmp_claiming(2, 3), bmp_of(RED));
}

#[test]
fn an_image_that_claims_to_be_huge_is_refused_without_the_memory() {
    let folder = folder_with_board();
    for (width, height) in [(100_000, 100_000), (8193, 1), (1, 8193), (i32::MAX, i32::MAX)] {
        folder.put("huge.bmp", bmp_claiming(width, height));
        refused(&folder, "huge.bmp");
        folder.put("huge.png", png_claiming(width.cast_unsigned(), height.cast_unsigned()));
        refused(&folder, "huge.png");
    }
    for (width, height) in [(-5, 3), (i32::MIN, 1), (0, 0), (0, 5)] {
        folder.put("odd.bmp", bmp_claiming(width, height));
        refused(&folder, "odd.bmp");
    }
    folder.put("huge.bmp", bmp_claiming(100_000, 100_000));
    let run = folder.bash(
        "ulimit -v 1000000; exec $P render scene.txt -o out.bmp --threads 1 --texture --white huge.bmp",
    );
    run.refusal();
}

#[test]
fn an_image_of_the_largest_size_is_used() {
    let folder = folder_with_board();
    for (width, height) in [(8192, 1), (1, 8192)] {
        let mut bytes = Vec::new();
        RgbImage::from_pixel(width, height, Rgb(GREEN))
            .write_to(&mut Cursor::new(&mut bytes), ImageFormat::Bmp)
            .unwrap();
        folder.put("large.bmp", bytes);
        assert_eq!(colors(&folder, "--white large.bmp --black large.bmp"), [GREEN]);
    }
}
