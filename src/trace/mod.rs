//! Tables in, radiance out.
//!
//! Nothing here knows a World or a file: tables can be built by systems, by a test or by hand. A frame is traced
//! from tables that do not change under it, so every pixel is a pure function of tables, camera and level, and
//! the picture is the same for every tiling and number of threads.

mod adaptive;
mod air;
mod camera;
mod camera_effects;
mod census;
mod closest;
mod counts;
mod effect_column;
mod effect_rows;
mod filtered_color;
mod hit;
mod kernel;
mod light_table;
mod motion;
mod occlusion;
mod packet;
mod pixels;
mod radiance;
mod samples;
mod sequence;
mod shade;
mod shape_columns;
mod simd;
mod stages;
mod stream;
mod surface_table;
mod tables;
mod tile;
mod trail;
mod tree;

pub use adaptive::{BandAround, RefinedBand, Refinement, error_of_mean};
pub use air::Air;
pub use camera::{CameraRay, CameraRays};
pub use camera_effects::{CameraEffects, CameraRows};
pub use census::{EffectCount, TableCount};
pub use closest::closest_hit;
pub use counts::{Counts, RayCounts};
pub use effect_column::EffectColumn;
pub use hit::{Departure, Hit, Kind, ObjectId};
pub use kernel::Kernel;
pub use light_table::{LightEffectColumns, LightEffects, LightRow, LightTable};
pub use motion::MovingRow;
pub use occlusion::is_occluded;
pub use radiance::{Depth, Radiance, radiance};
pub use samples::{SampleGrid, SamplePoint};
pub use sequence::{Purpose, SampleId, Sequence};
pub use shape_columns::{
    BoardColumns, BoardEffectColumns, BoardEffects, CubeColumns, PyramidColumns, ShapeColumns, SphereColumns,
};
pub use simd::Simd;
pub use stream::Query;
pub use surface_table::{SurfaceEffectColumns, SurfaceEffects, SurfaceRow, SurfaceTable};
pub use tables::{SceneTables, ShapeTable, Trees};
pub use tile::Exposure;
pub use trail::Trail;
pub use tree::{Fork, Packed, SMALLEST_TREE, Sequential, Tree, refit_tree};
