//! The own colour of a surface over what a pixel covers of it.

use crate::components::Texture;
use crate::effects::{
    BoardTexture, CellPoint, Effect, ImageFilter, MipChain, PixelCone, Rgb, bilinear_color, cell_point,
    white_share,
};
use crate::geometry::{Real, Vector};

use super::kernel::{has, known};
use super::shade::own_color;
use super::{Kind, ObjectId, SceneTables};

/// Where a pixel's ray meets a surface.
#[derive(Clone, Copy)]
pub(super) struct PixelSpot<T> {
    pub(super) point: Vector<T>,
    /// Unit direction of the ray.
    pub(super) direction: Vector<T>,
    /// What the pixel covers around the ray at the point.
    pub(super) cone: PixelCone<T>,
}

/// The [`own_color`] of an object, averaged over what the pixel covers of it where a filter asks for that.
pub(super) fn filtered_color<T: Real, const EFFECTS: u32>(
    tables: &SceneTables<T>,
    object: ObjectId,
    plain: Rgb<T>,
    spot: PixelSpot<T>,
) -> Rgb<T> {
    let boards = &tables.boards.shapes;
    let knows_filters = has::<EFFECTS>(Effect::TextureFilter) || has::<EFFECTS>(Effect::CheckerFilter);
    let is_filtered = knows_filters && object.kind == Kind::Board && boards.has_filters();
    let filtered = if is_filtered { board_color::<T, EFFECTS>(tables, object, plain, spot) } else { None };
    filtered.unwrap_or_else(|| own_color::<T, EFFECTS>(tables, object, plain, spot.point))
}

/// The colour of a checkerboard that has a filter.
#[inline(never)]
fn board_color<T: Real, const EFFECTS: u32>(
    tables: &SceneTables<T>,
    object: ObjectId,
    plain: Rgb<T>,
    spot: PixelSpot<T>,
) -> Option<Rgb<T>> {
    let boards = &tables.boards.shapes;
    let row = object.row as usize;
    let (origin, width) = boards.pattern(row);
    let at = cell_point(spot.point.x - origin.x, spot.point.y - origin.y, width);
    let covered = spot.cone.on_level_plane(spot.direction).map(|length| length / width);
    if has::<EFFECTS>(Effect::CheckerFilter) && boards.effects.checker_filter.get(row).is_some() {
        return Some(plain * white_share(at, covered));
    }
    let filter = known::<EFFECTS, _>(Effect::TextureFilter, boards.effects.texture_filter.get(row))?;
    Some(image_color(boards.effects.texture.get(row)?, filter, at, covered))
}

/// The colour of the image of a cell, of which a pixel covers some share along each axis.
#[inline(never)]
fn image_color<T: Real>(
    images: &BoardTexture,
    filter: &ImageFilter,
    cell: CellPoint<T>,
    covered: [T; 2],
) -> Rgb<T> {
    let image = if cell.white { &images.white } else { &images.black };
    let at = [cell.along_x, T::ONE - cell.along_y];
    match filter {
        ImageFilter::Bilinear => bilinear_color(image, at),
        ImageFilter::Mip { white, black } => {
            let chain: &MipChain = if cell.white { white } else { black };
            chain.color(image, at, covered_texels(image, covered))
        }
    }
}

/// Texels along the side on which a pixel covers more.
#[inline(always)]
fn covered_texels<T: Real>(image: &Texture, [along_x, along_y]: [T; 2]) -> T {
    (along_x * T::from_u32(image.width())).at_least(along_y * T::from_u32(image.height()))
}
