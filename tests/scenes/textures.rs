//! The textures of the repository are what their program draws.

use std::path::Path;

use archetrace::components::Texture;
use archetrace::image_file::load_texture;

#[path = "../../scenes/textures.rs"]
mod drawn;

fn committed(name: &str) -> Texture {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
    load_texture(&folder.join(name)).unwrap()
}

fn assert_same(committed: &Texture, (width, height, texels): (u32, u32, Vec<[u8; 3]>)) {
    assert_eq!((committed.width(), committed.height()), (width, height));
    let columns_and_rows = (0..height).flat_map(|row| (0..width).map(move |column| (column, row)));
    for ((column, row), drawn) in columns_and_rows.zip(texels) {
        assert_eq!(
            committed.texel(column, row),
            drawn,
            "column {column}, row {row}; run `cargo run --example make_textures`"
        );
    }
}

#[test]
fn the_texture_of_white_cells_is_as_drawn() {
    assert_same(&committed("texture_w.bmp"), drawn::white());
}

#[test]
fn the_texture_of_black_cells_is_as_drawn() {
    assert_same(&committed("texture_b.bmp"), drawn::black());
}

#[test]
fn the_textures_differ_from_each_other_and_from_themselves_turned_around() {
    for (width, height, texels) in [drawn::white(), drawn::black()] {
        let at = |column: u32, row: u32| texels[row as usize * width as usize + column as usize];
        let grid = || (0..height).flat_map(|row| (0..width).map(move |column| (column, row)));
        assert!(grid().any(|(column, row)| at(column, row) != at(width - 1 - column, row)));
        assert!(grid().any(|(column, row)| at(column, row) != at(column, height - 1 - row)));
    }
    assert_ne!(drawn::white().2, drawn::black().2);
}
