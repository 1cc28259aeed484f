//! Pictures in files, and what the window says of its own.

use crate::program::Folder;

/// A square picture: red, green, blue, top row first.
#[derive(Clone, PartialEq)]
pub(crate) struct Picture {
    pub(crate) side: u32,
    pub(crate) rgb: Vec<u8>,
}

impl Picture {
    /// Of a file's bytes.
    pub(crate) fn read(bytes: &[u8]) -> Self {
        let picture = image::load_from_memory(bytes).unwrap().to_rgb8();
        Self { side: picture.width(), rgb: picture.into_raw() }
    }

    /// What `archetrace render` makes of `scene.txt` with these arguments.
    #[track_caller]
    pub(crate) fn rendered(folder: &Folder, arguments: &str) -> Self {
        let picture = Self::read(&folder.render(arguments));
        std::fs::remove_file(folder.path("rendered.bmp")).unwrap();
        picture
    }

    /// FNV-1a, 64 bits, as its authors publish it.
    pub(crate) fn hash(&self) -> String {
        let hash = self.rgb.iter().fold(14_695_981_039_346_656_037_u64, |hash, &byte| {
            (hash ^ u64::from(byte)).wrapping_mul(1_099_511_628_211)
        });
        format!("{hash:016x}")
    }
}
