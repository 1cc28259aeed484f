//! Scenes to be looked at.

use crate::program::{Folder, SCENE};

/// [`SCENE`] with so many pixels along each side, which is the window's size, too.
pub(crate) fn scene(pixels: u32) -> String {
    let scene = SCENE.replacen("\n32\n", &format!("\n{pixels}\n"), 1);
    assert_eq!(scene != SCENE, pixels != 32);
    scene
}

/// A folder with [`scene`] as `scene.txt`.
pub(crate) fn folder(pixels: u32) -> Folder {
    let folder = Folder::empty();
    folder.put("scene.txt", scene(pixels));
    folder
}

/// A scene that takes minutes to trace, because of its thousand lights. It is as large as a window gets, and larger.
pub(crate) fn slow_scene() -> String {
    let lights: Vec<String> =
        (0..1000).map(|n| format!("{} -70 {} 0.00001", n % 40 * 5, 100 + n / 40)).collect();
    let one = "\n1\n60 -70 100  0.00001\n";
    let slow = scene(1500).replacen(one, &format!("\n{}\n{}\n", lights.len(), lights.join("\n")), 1);
    assert!(slow.len() > 10_000);
    slow
}

/// A folder with [`slow_scene`] as `scene.txt`.
pub(crate) fn slow_folder() -> Folder {
    let folder = Folder::empty();
    folder.put("scene.txt", slow_scene());
    folder
}
