//! What is asked of the camera is done in its order, and a pose that stays is not touched.

use archetrace::components::{CameraInput, CameraMove, CameraPose, Home, Lens, Reference, Snapshot};
use archetrace::geometry::Vector;
use archetrace::systems::{Tables, control_schedule, extract_schedule, frame_schedule, prepare};
use bevy_ecs::prelude::*;
use bevy_ecs::schedule::Schedule;
use glam::DVec3;

use crate::support::random::Random;
use crate::support::tracing::workers;

const LENS: Lens = Lens { near: 1.0, far: 1000.0, fovy: 60.0, aspect: 1.0 };

/// A World with a camera, the schedule that moves it, and how often another schedule saw it move.
struct Controlled {
    world: World,
    control: Schedule,
    look: Schedule,
}

#[derive(Resource, Default)]
struct Seen {
    poses: usize,
    references: usize,
}

fn see(
    poses: Query<(), Changed<CameraPose>>,
    references: Query<(), Changed<Reference>>,
    mut seen: ResMut<Seen>,
) {
    seen.poses += poses.iter().count();
    seen.references += references.iter().count();
}

impl Controlled {
    fn new(camera: impl Bundle) -> Self {
        let mut world = World::new();
        prepare::<f64>(&mut world, workers(1));
        world.init_resource::<Seen>();
        world.spawn(camera);
        let mut look = Schedule::default();
        look.add_systems(see);
        let mut controlled = Self { world, control: control_schedule(), look };
        controlled.changes();
        controlled
    }

    fn at_start() -> Self {
        Self::new((CameraPose::default(), LENS))
    }

    /// Asks, runs the schedule once, and checks that nothing is left to be asked.
    fn ask(&mut self, moves: &[CameraMove]) -> CameraPose {
        self.world.resource_mut::<CameraInput>().0.extend_from_slice(moves);
        self.control.run(&mut self.world);
        assert_eq!(self.world.resource::<CameraInput>().0, []);
        self.pose()
    }

    fn pose(&mut self) -> CameraPose {
        *self.world.query::<&CameraPose>().single(&self.world).unwrap()
    }

    fn distance(&mut self) -> f64 {
        self.world.query::<&Reference>().single(&self.world).unwrap().distance
    }

    /// Changes of a pose and of a reference distance since the last look.
    fn changes(&mut self) -> [usize; 2] {
        *self.world.resource_mut::<Seen>() = Seen::default();
        self.look.run(&mut self.world);
        let seen = self.world.resource::<Seen>();
        [seen.poses, seen.references]
    }
}

/// A pose whose three directions have no zero component.
fn tilted_pose() -> CameraPose {
    CameraPose::looking(DVec3::new(3.0, -20.0, 7.5), DVec3::new(1.0, 2.0, -0.5), DVec3::new(0.2, 0.3, 1.0))
        .unwrap()
}

#[test]
fn steps_along_the_axes_are_exactly_the_sum() {
    let start = tilted_pose();
    let CameraPose { position, l, r, u } = start;
    for distance in [5.0, -5.0, 25.0, 0.5, 1e9, 0.1] {
        for (asked, axis) in [
            (CameraMove::Forward(distance), l),
            (CameraMove::Right(distance), r),
            (CameraMove::Up(distance), u),
        ] {
            let moved = Controlled::new((start, LENS)).ask(&[asked]);
            assert_eq!(moved, CameraPose { position: position + distance * axis, ..start }, "{asked:?}");
        }
    }
}

#[test]
fn turns_are_about_the_cameras_own_axes_and_by_degrees() {
    let CameraPose { l, r, u, .. } = CameraPose::default();
    let (sine, cosine) = (30.0_f64.to_radians().sin(), 30.0_f64.to_radians().cos());
    for (asked, expected) in [
        (CameraMove::Turn(30.0), [l * cosine - r * sine, r * cosine + l * sine, u]),
        (CameraMove::Heading(30.0), [l * cosine - r * sine, r * cosine + l * sine, u]),
        (CameraMove::Pitch(30.0), [l * cosine + u * sine, r, u * cosine - l * sine]),
        (CameraMove::Tilt(30.0), [l, r * cosine - u * sine, u * cosine + r * sine]),
    ] {
        let turned = Controlled::at_start().ask(&[asked]);
        assert_eq!(turned.position, CameraPose::default().position);
        for (found, expected) in [turned.l, turned.r, turned.u].into_iter().zip(expected) {
            assert!(found.distance(expected) <= 2.0 * f64::EPSILON, "{asked:?}: {turned:?}");
        }
    }
}

#[test]
fn moves_are_made_in_the_order_in_which_they_were_asked_for() {
    let CameraPose { position, l, r, u } = CameraPose::default();
    let pose = Controlled::at_start().ask(&[
        CameraMove::Forward(5.0),
        CameraMove::Turn(90.0),
        CameraMove::Forward(5.0),
        CameraMove::Pitch(90.0),
        CameraMove::Forward(5.0),
    ]);
    assert_eq!(pose, CameraPose { position: position + 5.0 * l - 5.0 * r + 5.0 * u, l: u, r: l, u: r });
    let turned_first = Controlled::at_start().ask(&[CameraMove::Turn(90.0), CameraMove::Forward(5.0)]);
    assert_eq!(turned_first.position, position - 5.0 * r);
}

#[test]
fn in_one_frame_or_in_many_the_same_moves_end_at_the_same_bits() {
    let random = &mut Random::new(0x0c_a3e7a);
    let moves: Vec<CameraMove> = (0..300).map(|_| random_move(random)).collect();
    let mut at_once = Controlled::at_start();
    at_once.ask(&moves);
    let mut one_by_one = Controlled::at_start();
    for &asked in &moves {
        one_by_one.ask(&[asked]);
    }
    assert_eq!(one_by_one.pose(), at_once.pose());
    assert_eq!(one_by_one.distance(), at_once.distance());
}

fn random_move(random: &mut Random) -> CameraMove {
    let size = random.between(-30.0, 30.0);
    random.pick(&[
        CameraMove::Forward(size),
        CameraMove::Right(size),
        CameraMove::Up(size),
        CameraMove::Turn(size),
        CameraMove::Heading(size),
        CameraMove::Pitch(size),
        CameraMove::Tilt(size),
        CameraMove::Raise(size),
    ])
}

#[test]
fn raised_the_eye_looks_at_the_reference_point_and_its_distance_is_kept() {
    let mut controlled = Controlled::at_start();
    let pose = controlled.ask(&[CameraMove::Raise(112.5)]);
    // The triangle of 3, 4 and 5.
    assert_eq!(pose.position, DVec3::new(0.0, -150.0, 162.5));
    assert!(pose.l.distance(DVec3::new(0.0, 0.8, -0.6)) <= 2.0 * f64::EPSILON);
    assert_eq!(pose.r, DVec3::X);
    assert_eq!(controlled.distance(), 187.5);
    assert_eq!(controlled.changes(), [1, 1]);
    // The point moves along with a camera that moves otherwise.
    controlled.ask(&[CameraMove::Forward(5.0), CameraMove::Turn(5.0)]);
    assert_eq!(controlled.distance(), 187.5);
    assert_eq!(controlled.changes(), [1, 0]);
}

#[test]
fn another_reference_distance_is_another_point() {
    let mut controlled = Controlled::new((CameraPose::default(), LENS, Reference { distance: 20.0 }));
    assert!(
        controlled.ask(&[CameraMove::Raise(15.0)]).l.distance(DVec3::new(0.0, 0.8, -0.6))
            <= 2.0 * f64::EPSILON
    );
    assert_eq!(controlled.distance(), 25.0);
}

#[test]
fn home_is_the_default_pose_or_the_cameras_own() {
    let away = [CameraMove::Raise(40.0), CameraMove::Turn(33.0), CameraMove::Right(12.0)];
    let mut controlled = Controlled::at_start();
    assert_ne!(controlled.ask(&away), CameraPose::default());
    assert_eq!(controlled.ask(&[CameraMove::Home]), CameraPose::default());
    assert_eq!(controlled.distance(), 150.0);

    let mut controlled = Controlled::new((CameraPose::default(), LENS, Home(tilted_pose())));
    controlled.ask(&away);
    assert_eq!(controlled.ask(&[CameraMove::Home]), tilted_pose());
    assert_eq!(controlled.distance(), 150.0);
}

#[test]
fn a_pose_is_marked_as_changed_only_by_a_move_that_moves() {
    let mut controlled = Controlled::at_start();
    for idle in [
        &[] as &[CameraMove],
        &[CameraMove::Home],
        &[CameraMove::Forward(0.0), CameraMove::Turn(0.0), CameraMove::Turn(360.0)],
        &[CameraMove::Raise(0.0)],
        &[CameraMove::Forward(1e80)],
        &[CameraMove::Forward(f64::NAN), CameraMove::Pitch(f64::INFINITY)],
    ] {
        controlled.ask(idle);
        assert_eq!(controlled.changes(), [0, 0], "{idle:?}");
    }
    controlled.ask(&[CameraMove::Turn(1e-9)]);
    assert_eq!(controlled.changes(), [1, 0]);
}

#[test]
fn a_pose_of_no_numbers_is_left_to_those_who_report_it() {
    let mut controlled = Controlled::new((CameraPose { l: DVec3::NAN, ..CameraPose::default() }, LENS));
    controlled.ask(&[]);
    assert_eq!(controlled.changes(), [0, 0]);
}

#[test]
fn moves_that_cannot_be_made_are_left_out_and_the_others_are_made() {
    let straight_up = CameraPose { position: DVec3::ZERO, l: DVec3::Z, r: DVec3::X, u: DVec3::NEG_Y };
    let mut controlled = Controlled::new((straight_up, LENS));
    for height in [150.0, 200.0, 1e80, f64::INFINITY] {
        let pose = controlled.ask(&[CameraMove::Raise(height), CameraMove::Right(5.0)]);
        assert_eq!((pose.position.z, pose.l, controlled.distance()), (0.0, DVec3::Z, 150.0), "{height}");
    }
    assert_eq!(controlled.pose().position, DVec3::new(20.0, 0.0, 0.0));
}

#[test]
fn the_eye_stays_among_the_coordinates_that_are_allowed() {
    for moves in [
        [CameraMove::Forward as fn(f64) -> CameraMove, CameraMove::Forward],
        [CameraMove::Right, CameraMove::Right],
        [CameraMove::Up, CameraMove::Raise],
    ] {
        for sign in [1.0, -1.0] {
            let mut controlled = Controlled::at_start();
            for asked in moves {
                let there = controlled.ask(&[asked(sign * 9e69)]);
                assert!(there.position.abs().max_element() <= 1e70);
                assert_eq!(controlled.ask(&[asked(sign * 9e69), asked(sign * f64::MAX)]), there);
            }
        }
    }
    // An eye that was put outside can come back, at once or home.
    let outside = CameraPose { position: DVec3::Y * 2e70, ..CameraPose::default() };
    let mut controlled = Controlled::new((outside, LENS));
    assert_eq!(controlled.ask(&[CameraMove::Forward(-5e69)]), outside);
    assert_eq!(controlled.ask(&[CameraMove::Forward(-2e70)]).position, DVec3::ZERO);
    let mut controlled = Controlled::new((outside, LENS));
    assert_eq!(controlled.ask(&[CameraMove::Home]), CameraPose::default());
}

#[test]
fn without_a_camera_or_with_two_the_moves_are_forgotten() {
    let mut none = Controlled::new(CameraPose::default());
    assert_eq!(none.ask(&[CameraMove::Forward(5.0)]), CameraPose::default(), "no lens, no camera");
    let mut two = Controlled::at_start();
    let second = two.world.spawn((CameraPose::default(), LENS)).id();
    two.changes();
    two.world.resource_mut::<CameraInput>().0.push(CameraMove::Forward(5.0));
    two.control.run(&mut two.world);
    assert_eq!(two.changes(), [0, 0]);
    two.world.despawn(second);
    assert_eq!(two.ask(&[]), CameraPose::default(), "what was forgotten is not made later");
}

#[test]
fn a_frame_shows_the_moves_that_were_asked_for_before_it() {
    let mut controlled = Controlled::at_start();
    controlled.world.insert_resource(Snapshot { pixels: 1, level: 1 });
    let look =
        |world: &World| world.resource::<Tables<f64>>().camera.clone().unwrap().ray(0, 0).ray.direction;
    let mut frame = frame_schedule::<f64>();
    frame.run(&mut controlled.world);
    assert_eq!(look(&controlled.world), Vector::from_dvec3(DVec3::Y));
    controlled.world.resource_mut::<CameraInput>().0.push(CameraMove::Turn(90.0));
    frame.run(&mut controlled.world);
    assert_eq!(look(&controlled.world), Vector::from_dvec3(DVec3::NEG_X));
    // The window runs the two by themselves.
    controlled.ask(&[CameraMove::Turn(90.0)]);
    extract_schedule::<f64>().run(&mut controlled.world);
    assert_eq!(look(&controlled.world), Vector::from_dvec3(DVec3::NEG_Y));
}
