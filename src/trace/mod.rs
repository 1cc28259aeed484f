//! Tables in, radiance out.
//!
//! Nothing here knows a World or a file: tables can be built by systems, by a test or by hand. A frame is traced
//! from tables that do not change under it, so every pixel is a pure function of tables, camera and level, and
//! the picture is the same for every tiling and number of threads.

mod camera;
mod census;
mod closest;
mod counts;
mod hit;
mod occlusion;
mod radiance;
mod shade;
mod tables;
mod tile;

pub use camera::CameraRays;
pub use census::{EffectCount, TableCount};
pub use closest::closest_hit;
pub use counts::{Counts, RayCounts};
pub use hit::{Departure, Hit, Kind, ObjectId};
pub use occlusion::is_occluded;
pub use radiance::radiance;
pub use tables::{
    BoardColumns, BoardTexture, CubeColumns, EffectColumn, GlossRow, LightRow, LightTable, PyramidColumns,
    SceneTables, ShapeColumns, ShapeTable, SphereColumns, SurfaceRow, SurfaceTable,
};
pub use tile::trace_tile;
