//! Accuracy in the panel, and the strip.

use bevy_ecs::prelude::*;

use super::super::Request;
use super::super::strip::error_in_words;
use super::screen::Screen;
use crate::components::{
    Adaptive, AreaLight, CheckerFilter, Checkerboard, Cutoff, Light, Precision, Sampling, Snapshot, Texture,
    TextureFilter, Textured,
};
use crate::study::{FrontPoint, Preset, Setting};
use crate::viewer::editor::{accuracy, own_level};
use crate::viewer::live::Shows;

fn now(screen: &mut Screen) -> Setting {
    accuracy(&mut screen.world)
}

/// Takes everything back, step by step; how many there were.
fn undo_all(screen: &mut Screen) -> usize {
    let mut steps = 0;
    while screen.editor.undo(&mut screen.world).is_some() {
        steps += 1;
    }
    screen.settle();
    steps
}

#[test]
fn presets_are_those_of_the_scene_in_any_order() {
    let mut screen = Screen::of_file("official.txt");
    let scene = now(&mut screen);
    assert_eq!(own_level(&screen.world), None, "nobody has chosen yet");
    for preset in [Preset::Reference, Preset::Draft, Preset::Fine, Preset::Assignment] {
        screen.click_on(preset.name());
        assert_eq!(now(&mut screen), preset.of(scene), "{}", preset.name());
    }
    assert_eq!(undo_all(&mut screen), 4);
    assert_eq!(now(&mut screen), scene);
    assert_eq!(own_level(&screen.world), None);
    assert!(screen.world.get_resource::<Adaptive>().is_none());
}

#[test]
fn what_a_file_holds_of_a_preset_makes_the_scene_modified() {
    let mut screen = Screen::of_file("official.txt");
    screen.click_on("f32");
    assert_eq!(now(&mut screen).precision, Precision::F32);
    assert!(!screen.editor.is_modified(), "a file holds no precision");
    screen.click_on("reference");
    assert!(screen.editor.is_modified(), "a file holds a level");
    assert_eq!(undo_all(&mut screen), 2);
    assert!(!screen.editor.is_modified());
}

#[test]
fn knobs_without_a_preset() {
    let mut screen = Screen::of_file("official.txt");
    let adaptive = screen.switches("adaptive")[0];
    screen.click(adaptive.center());
    assert_eq!(screen.world.get_resource(), Some(&Adaptive { threshold: 1.0 / 128.0 }));
    let threshold = screen.numbers("adaptive")[0];
    screen.click(threshold.center());
    screen.type_text("0.25");
    screen.key(egui::Key::Enter);
    screen.settle();
    assert_eq!(screen.world.get_resource(), Some(&Adaptive { threshold: 0.25 }));
    let cutoff = screen.numbers("cutoff")[0];
    screen.click(cutoff.center());
    screen.type_text("0.125");
    screen.key(egui::Key::Enter);
    screen.settle();
    assert_eq!(screen.world.get_resource(), Some(&Cutoff(0.125)));
    screen.click_on("filtered");
    let filtered = |screen: &mut Screen| {
        screen
            .world
            .query_filtered::<(), (With<Checkerboard>, With<CheckerFilter>)>()
            .iter(&screen.world)
            .count()
    };
    assert_eq!(filtered(&mut screen), 1);
    screen.click(adaptive.center());
    assert!(screen.world.get_resource::<Adaptive>().is_none());
    assert_eq!(undo_all(&mut screen), 5);
    assert_eq!(filtered(&mut screen), 0);
    assert!(screen.world.get_resource::<Cutoff>().is_none());
}

#[test]
fn filters_and_shadow_rays_are_there_for_what_has_them() {
    let mut screen = Screen::of_file("official.txt");
    assert!(screen.has("cells") && !screen.has("images") && !screen.has("shadows"));
    let board = screen.first::<Checkerboard>();
    let image = std::sync::Arc::new(Texture::new(1, 1, vec![[1, 2, 3]]).unwrap());
    screen.world.entity_mut(board).insert(Textured { white: image.clone(), black: image });
    let light = screen.first::<Light>();
    let area = AreaLight { radius: 2.0, samples: 16 };
    screen.world.entity_mut(light).insert(area);
    screen.settle();
    assert!(!screen.has("cells"));
    screen.click_on("mip");
    assert_eq!(screen.world.get(board), Some(&TextureFilter::Mip));
    let shadows = screen.numbers("shadows")[0];
    screen.click(shadows.center());
    screen.type_text("5");
    screen.key(egui::Key::Enter);
    screen.settle();
    assert_eq!(screen.world.get(light), Some(&AreaLight { samples: 5, ..area }));
    assert_eq!(undo_all(&mut screen), 2);
    assert_eq!(screen.world.get::<TextureFilter>(board), None);
    assert_eq!(screen.world.get(light), Some(&area));
}

/// A screen without a panel and with a strip, of a picture of 10 by 10 pixels.
fn with_strip() -> Screen {
    let mut screen = Screen::of_file("official.txt");
    screen.is_panel_open = false;
    let status = &mut screen.status;
    (status.strip, status.picture, status.side, status.traced) = (true, Some(Shows::Picture), 10, 12.34);
    status.counts.rays.primary = 100;
    status.counts.rays.shadow = 150;
    screen.settle();
    screen
}

#[test]
fn the_strip_says_what_the_picture_cost_and_that_errors_are_estimates() {
    let mut screen = with_strip();
    for text in ["12.3 ms", "2.50 rays/pixel", "error not known yet", "faster", "truer"] {
        assert!(screen.has(text), "`{text}` among {:?}", screen.texts());
    }
    screen.status.error = Some(3.0 / 255.0);
    screen.settle();
    assert!(screen.has("error about 3.0 levels (estimated)"));
    screen.status.strip = false;
    screen.settle();
    assert!(!screen.has("12.3 ms"));
    assert_eq!(error_in_words(0.0), "error below 0.1 levels (estimated)");
    assert_eq!(error_in_words(0.5), "error about 128 levels (estimated)");
}

#[test]
fn a_heat_map_has_a_scale() {
    let mut screen = with_strip();
    assert!(!screen.has("64 levels"));
    (screen.status.picture, screen.status.most) = (Some(Shows::Errors), 64.0);
    screen.settle();
    assert!(screen.has("64 levels"));
    (screen.status.picture, screen.status.most) = (Some(Shows::Rays), 37.0);
    screen.settle();
    assert!(screen.has("37 rays/pixel") && !screen.has("2.50 rays/pixel"));
}

/// Drags the strip's slider to a share of its length.
fn slide(screen: &mut Screen, share: f32) {
    let slider = screen.sliders("faster")[0];
    let at = egui::pos2(slider.left() + 6.0 + share * (slider.width() - 12.0), slider.center().y);
    screen.click(at);
}

#[test]
fn the_slider_goes_through_the_presets_until_a_front_is_known() {
    let mut screen = with_strip();
    let scene = now(&mut screen);
    for (share, preset) in [(1.0, Preset::Reference), (0.0, Preset::Draft), (0.67, Preset::Fine)] {
        slide(&mut screen, share);
        assert_eq!(now(&mut screen), preset.of(scene), "at {share}");
        assert!(screen.has(preset.name()));
    }
    assert_eq!(undo_all(&mut screen), 3);
    assert_eq!(now(&mut screen), scene);
}

#[test]
fn the_slider_goes_along_the_front_and_tells_predicted_prices() {
    let mut screen = with_strip();
    let scene = Setting { pixels: 999, ..now(&mut screen) };
    let point = |side, milliseconds, rmse| FrontPoint {
        setting: Setting { side, ..scene },
        milliseconds,
        rmse,
        rmse_bound: rmse,
    };
    screen.status.front.points = vec![point(1, 10.0, 0.1), point(3, 90.0, 0.01), point(8, 640.0, 0.001)];
    screen.settle();
    slide(&mut screen, 1.0);
    assert_eq!(*screen.world.resource::<Sampling>(), Sampling { side: 8 });
    assert!(screen.has("about 640 ms, 60 dB (predicted)"), "{:?}", screen.texts());
    slide(&mut screen, 0.5);
    assert_eq!(*screen.world.resource::<Sampling>(), Sampling { side: 3 });
    assert!(screen.has("about 90 ms, 40 dB (predicted)"));
    assert_ne!(screen.world.resource::<Snapshot>().pixels, 999, "the size is not the slider's");
    assert!(!screen.has("measure"), "while the picture is not complete");
    screen.status.is_complete = true;
    screen.settle();
    assert_eq!(screen.click_on("measure"), [Request::MeasureFront]);
}

#[test]
fn the_strip_makes_way_for_the_panel() {
    let mut screen = with_strip();
    let wide = screen.find("truer").right();
    screen.is_panel_open = true;
    screen.settle();
    assert!(screen.find("truer").right() <= wide);
    assert!(screen.has("12.3 ms") && screen.has("preset"));
}
