use std::sync::mpsc::{self, Receiver};
use std::time::Instant;

use bevy_ecs::prelude::*;

use crate::components::Precision::{self, F32, F64};

use super::super::test_views::{heavy, official, rendered, view, workers};
use super::super::traced_view::SharedTables;
use super::*;
use crate::components::{
    Adaptive, Aperture, CameraPose, Cutoff, ExposureStops, Shutter, Sphere, SrgbTransfer, Velocity,
};
use crate::film::Film;
use crate::study::{Difference, ERROR_LEVELS, false_color};
use crate::trace::SampleGrid;

const LONG: Duration = Duration::from_secs(60);
const SIDE: u32 = 100;

/// A live trace that waits after each picture until it has been taken.
struct Stepped {
    live: Live,
    news: Receiver<()>,
}

impl Stepped {
    fn new() -> Self {
        let (sender, news) = mpsc::sync_channel(0);
        // Told of twice: the picture can be taken in between.
        let wake = move || {
            let _ = sender.send(()).and_then(|()| sender.send(()));
        };
        Self { live: Live::new(workers(), wake).unwrap(), news }
    }

    fn next(&self) -> Shown {
        self.news.recv_timeout(LONG).unwrap();
        let shown = self.live.latest().unwrap().unwrap();
        self.news.recv_timeout(LONG).unwrap();
        shown
    }

    /// Every picture up to the last.
    fn all(&self, what: LiveRequest) -> Vec<Shown> {
        self.live.request(what);
        let mut shown = vec![self.next()];
        while !shown[shown.len() - 1].is_final {
            shown.push(self.next());
        }
        shown
    }
}

impl Drop for Stepped {
    fn drop(&mut self) {
        // Nobody listens any more: let the thread go on to its end.
        self.news = mpsc::channel().1;
    }
}

fn wanted(view: TracedView, side: u32, samples: Samples) -> LiveRequest {
    LiveRequest { view, side, samples, shows: Shows::Picture }
}

fn request(precision: Precision, side: u32, grid: u32) -> LiveRequest {
    wanted(view(&mut official(), precision), side, Samples::of(SampleGrid::new(grid)))
}

fn heavy_request() -> LiveRequest {
    wanted(view(&mut heavy(), F64), 1024, Samples::of(SampleGrid::new(3)))
}

/// The picture must be what `render` makes at this size with `grid` by `grid` samples.
#[track_caller]
fn assert_rendered(shown: &Shown, precision: Precision, side: u32, grid: u32) {
    let (film, counts) = rendered(official(), precision, side, grid);
    assert_eq!((shown.side, shown.samples), (side, grid * grid));
    assert!(shown.rgb8 == film.to_rgb8(), "{side} pixels, {grid} by {grid} samples");
    assert_eq!(shown.counts, counts);
    assert!(shown.milliseconds > 0.0);
}

/// The mean of the first samples of each pixel, from the pixels of a finer picture.
fn mean_so_far(grid: SampleGrid, samples: u32) -> Vec<u8> {
    let (fine, _) = rendered(official(), F64, SIDE * grid.side(), 1);
    let index = |column: u32, row: u32| (row * fine.side() + column) as usize;
    let mut bytes = Vec::new();
    for (row, column) in (0..SIDE).flat_map(|row| (0..SIDE).map(move |column| (row, column))) {
        let points = (0..samples).map(|pass| grid.point(pass));
        let picked = points.map(|at| index(column * grid.side() + at.column, row * grid.side() + at.row));
        let picked: Vec<[f64; 3]> = picked.map(|index| fine.pixels()[index]).collect();
        for channel in 0..3 {
            let mean = picked.iter().map(|pixel| pixel[channel]).sum::<f64>() / f64::from(samples);
            bytes.push((0..=255).rev().find(|&level| f64::from(level) <= mean * 255.0).unwrap());
        }
    }
    bytes
}

#[test]
fn the_picture_comes_coarse_then_full_then_with_more_samples() {
    let shown = Stepped::new().all(request(F64, SIDE, 3));
    assert_eq!(shown.len(), 10);
    assert_rendered(&shown[0], F64, 13, 1);
    assert_rendered(&shown[1], F64, SIDE, 1);
    for (samples, shown) in (1..).zip(&shown[1..]) {
        assert_eq!((shown.side, shown.samples), (SIDE, samples));
        assert_eq!(shown.counts.rays.primary, u64::from(SIDE * SIDE * samples));
        assert!(shown.rgb8 == mean_so_far(SampleGrid::new(3), samples), "{samples} samples");
        assert_eq!(shown.is_final, samples == 9);
    }
    assert_rendered(&shown[9], F64, SIDE, 3);
}

#[test]
fn single_precision_is_traced_as_render_does() {
    let shown = Stepped::new().all(request(F32, SIDE, 3));
    assert_rendered(&shown[1], F32, SIDE, 1);
    assert_rendered(&shown[9], F32, SIDE, 3);
    assert!(shown[1].rgb8 != rendered(official(), F64, SIDE, 1).0.to_rgb8());
}

#[test]
fn a_grid_without_a_centre_shows_the_centre_first_all_the_same() {
    let shown = Stepped::new().all(request(F64, SIDE, 2));
    assert_eq!(shown.len(), 6);
    assert_rendered(&shown[1], F64, SIDE, 1);
    assert_rendered(&shown[5], F64, SIDE, 2);
}

#[test]
fn one_sample_is_enough_if_no_more_are_asked_for() {
    let shown = Stepped::new().all(request(F64, SIDE, 1));
    assert_eq!(shown.len(), 3);
    // The same again, when its error is known.
    assert_eq!([shown[1].is_final, shown[2].is_final], [false, true]);
    assert_rendered(&shown[1], F64, SIDE, 1);
    assert_rendered(&shown[2], F64, SIDE, 1);
}

/// With samples where they matter, and without faint rays.
fn choosy() -> World {
    let mut world = official();
    world.insert_resource(Adaptive { threshold: 1.0 / 64.0 });
    world.insert_resource(Cutoff(0.05));
    world
}

#[test]
fn adaptive_samples_and_a_cutoff_give_what_render_gives() {
    for (grid, precision) in [(3, F64), (4, F32)] {
        let samples = Samples { grid: SampleGrid::new(grid), threshold: Some(1.0 / 64.0) };
        let shown = Stepped::new().all(wanted(view(&mut choosy(), precision), SIDE, samples));
        let (film, counts) = rendered(choosy(), precision, SIDE, grid);
        assert_eq!(shown.len(), 3, "coarse, one sample, all of them");
        assert!(shown[2].rgb8 == film.to_rgb8(), "{grid} by {grid}");
        assert_eq!(shown[2].counts, counts);
        let all = u64::from(SIDE * SIDE * grid * grid);
        assert!((all / 10..all).contains(&counts.rays.primary), "{counts:?}");
    }
}

/// The official scene with spheres that move, seen by a camera that is given something.
fn seen_by(give: fn(&mut EntityWorldMut<'_>)) -> World {
    let mut world = official();
    let spheres: Vec<_> = world.query_filtered::<Entity, With<Sphere>>().iter(&world).collect();
    for sphere in spheres {
        world.entity_mut(sphere).insert(Velocity(glam::DVec3::new(300.0, 0.0, 100.0)));
    }
    let camera = world.query_filtered::<Entity, With<CameraPose>>().single(&world).unwrap();
    give(&mut world.entity_mut(camera));
    world
}

#[test]
fn effects_of_the_camera_show_as_render_shows_them() {
    let effects: [fn(&mut EntityWorldMut<'_>); 4] = [
        |camera| _ = camera.insert(Aperture { radius: 6.0, focus: 190.0 }),
        |camera| _ = camera.insert(Shutter { open: 0.0, close: 0.1 }),
        |camera| _ = camera.insert(ExposureStops(-1.0)),
        |camera| _ = camera.insert(SrgbTransfer),
    ];
    let plain = rendered(seen_by(|_| ()), F64, SIDE, 2).0.to_rgb8();
    let live = Stepped::new();
    for (number, give) in effects.into_iter().enumerate() {
        let samples = Samples::of(SampleGrid::new(2));
        let shown = live.all(wanted(view(&mut seen_by(give), F64), SIDE, samples)).pop().unwrap();
        let (film, counts) = rendered(seen_by(give), F64, SIDE, 2);
        assert!(shown.rgb8 == film.to_rgb8(), "effect {number}");
        assert_eq!(shown.counts, counts);
        assert!(shown.rgb8 != plain, "effect {number} does not show");
    }
}

/// The official scene traced so finely that what is left is far below the errors that are estimated.
fn truth() -> Film {
    rendered(official(), F64, SIDE, 17).0
}

#[test]
fn the_estimated_error_is_right_within_a_factor_of_two() {
    let truth = truth();
    for grid in [1, 2, 3, 5] {
        let shown = Stepped::new().all(request(F64, SIDE, grid));
        let estimated = shown[shown.len() - 1].error.unwrap();
        let (film, _) = rendered(official(), F64, SIDE, grid);
        let real = Difference::between(&film, &truth).unwrap().rmse;
        assert!((0.5..2.0).contains(&(estimated / real)), "{grid} by {grid}: {estimated} for {real}");
    }
}

#[test]
fn the_error_of_adaptive_samples_is_right_within_a_factor_of_two() {
    let truth = truth();
    for threshold in [1.0 / 16.0, 1.0 / 64.0] {
        let mut world = official();
        world.insert_resource(Adaptive { threshold });
        let samples = Samples { grid: SampleGrid::new(5), threshold: Some(threshold) };
        let shown = Stepped::new().all(wanted(view(&mut world, F64), SIDE, samples));
        let estimated = shown[shown.len() - 1].error.unwrap();
        let (film, _) = rendered(world, F64, SIDE, 5);
        let real = Difference::between(&film, &truth).unwrap().rmse;
        assert!((0.5..2.0).contains(&(estimated / real)), "{threshold}: {estimated} for {real}");
    }
}

fn heat_map(world: &mut World, samples: Samples, shows: Shows) -> Shown {
    let what = LiveRequest { view: view(world, F64), side: SIDE, samples, shows };
    let all = Stepped::new().all(what);
    assert!(all.iter().all(|shown| shown.shows == shows), "no picture comes in between");
    all.into_iter().next_back().unwrap()
}

#[test]
fn the_rays_of_each_pixel_are_those_of_its_column() {
    // At level 1 every pixel that shows an object takes one ray more for each light, and the sky none.
    let mut world = official();
    world.resource_mut::<crate::components::Snapshot>().level = 1;
    let samples = Samples::of(SampleGrid::new(2));
    let shown = heat_map(&mut world, samples, Shows::Rays);
    let sky = false_color(4.0 / shown.most);
    assert_eq!(shown.rgb8[..3], sky, "four camera rays and no other in the upper left corner");
    let lights = world.query::<&crate::components::Light>().iter(&world).count();
    let most = f64::from(u32::try_from(lights).unwrap() + 1) * 4.0;
    assert!(shown.most <= most && shown.most > 4.0, "{} of {most}", shown.most);
    assert!(shown.rgb8.as_chunks::<3>().0.contains(&false_color(1.0)));
}

#[test]
fn errors_are_dark_where_all_samples_agree() {
    let mut world = official();
    let shown = heat_map(&mut world, Samples::of(SampleGrid::new(3)), Shows::Errors);
    assert_eq!((shown.side, shown.most), (SIDE, ERROR_LEVELS));
    let pixels = shown.rgb8.as_chunks::<3>().0;
    assert_eq!(pixels[0], false_color(0.0), "the sky");
    let bright = pixels.iter().filter(|&&pixel| pixel != false_color(0.0)).count();
    assert!((pixels.len() / 20..pixels.len()).contains(&bright), "{bright} of {}", pixels.len());
}

#[test]
fn a_picture_is_there_when_it_is_waited_for_and_none_after_the_last() {
    let live = Live::new(workers(), || ()).unwrap();
    assert!(live.latest().is_none());
    live.request(request(F64, SIDE, 3));
    let start = Instant::now();
    let mut last = None;
    while let Some(shown) = live.wait(LONG) {
        last = Some(shown.unwrap());
    }
    assert!(last.is_some_and(|last| last.is_final));
    assert!(start.elapsed() < LONG, "waited for what does not come");
}

#[test]
fn what_was_asked_for_before_is_given_up() {
    let live = Live::new(workers(), || ()).unwrap();
    for _ in 0..20 {
        live.request(heavy_request());
        live.wait(Duration::from_millis(5));
    }
    live.request(request(F64, SIDE, 3));
    let start = Instant::now();
    loop {
        let shown = live.wait(LONG).unwrap().unwrap();
        // No half of 1024 is among them.
        assert!([100, 50, 25, 13, 7].contains(&shown.side), "{} pixels", shown.side);
        if shown.is_final {
            break assert_rendered(&shown, F64, SIDE, 3);
        }
    }
    assert!(start.elapsed() < Duration::from_secs(10), "took {:?}", start.elapsed());
}

#[test]
fn a_heavy_scene_gets_coarse_until_it_is_there_at_once() {
    let live = Live::new(workers(), || ()).unwrap();
    let first = (0..100).find_map(|_| {
        live.request(heavy_request());
        live.wait(Duration::from_millis(100))
    });
    let first = first.expect("no picture in a hundred moves of the camera").unwrap();
    assert!(first.side <= 1024 / 8, "{} pixels", first.side);
}

#[test]
fn after_a_stop_nothing_comes_and_nothing_is_held() {
    let live = Live::new(workers(), || ()).unwrap();
    let what = heavy_request();
    let SharedTables::F64(tables) = what.view.tables.clone() else { panic!("asked for f64") };
    live.request(what);
    live.wait(Duration::from_millis(50));
    live.stop();
    let start = Instant::now();
    assert!(live.wait(LONG).is_none());
    assert!(start.elapsed() < Duration::from_secs(2), "took {:?}", start.elapsed());
    assert_eq!(Arc::strong_count(&tables), 1, "the tables are held");
    assert!(live.latest().is_none());
}

#[test]
fn dropping_it_ends_the_thread_promptly() {
    let what = heavy_request();
    let SharedTables::F64(tables) = what.view.tables.clone() else { panic!("asked for f64") };
    let (sender, wakes) = mpsc::channel::<()>();
    let wake = move || {
        let _ = sender.send(());
    };
    let live = Live::new(workers(), wake).unwrap();
    live.request(what);
    live.wait(Duration::from_millis(50));
    let start = Instant::now();
    drop(live);
    assert!(start.elapsed() < Duration::from_secs(2), "took {:?}", start.elapsed());
    assert_eq!(Arc::strong_count(&tables), 1, "the tables are held");
    // The thread alone had the other end.
    while wakes.try_recv().is_ok() {}
    assert_eq!(wakes.try_recv(), Err(mpsc::TryRecvError::Disconnected));
}

#[test]
fn a_picture_too_large_for_the_memory_is_an_error_and_the_next_one_is_not() {
    let live = Live::new(workers(), || ()).unwrap();
    live.request(request(F64, u32::MAX, 1));
    assert!(matches!(live.wait(LONG), Some(Err(FrameError::Memory(_)))));
    assert!(live.wait(LONG).is_none());
    live.request(request(F64, SIDE, 1));
    assert!(live.wait(LONG).unwrap().is_ok());
}
