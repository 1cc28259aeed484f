//! Random edits, undo and redo: after each, the tables are those of a World that was built with the same content.

use bevy_ecs::prelude::*;

use crate::components::{
    Ambient, Checkerboard, Color, Cube, Diffuse, Falloff, Gloss, Lens, Mirror, Order, Position, Pyramid,
    Sampling, Snapshot, Sphere, SpotCone,
};
use crate::scene::spawn;
use crate::systems::Workers;

use super::super::{Editor, New};
use super::model::{Item, Model, Random, Shape};
use super::{Followed, description, workers};

/// The edited World, and beside it every content that it should have had.
struct Game {
    edited: Followed,
    editor: Editor,
    contents: Vec<Model>,
    at: usize,
    random: Random,
    workers: Workers,
}

impl Game {
    fn new(file: &str, seed: u64) -> Self {
        let mut edited = Followed::of_file(file);
        let contents = vec![Model::read(&mut edited.world)];
        Self { edited, editor: Editor::default(), contents, at: 0, random: Random(seed), workers: workers() }
    }

    fn check(&mut self) {
        let built = self.contents[self.at].build();
        let expected = Followed::with_workers(built, self.workers.clone()).tables();
        let found = self.edited.tables();
        assert!(found == expected, "found {found}\nbut expected {expected}");
    }

    /// The content that an edit starts from. What was undone is gone.
    fn begin(&mut self) -> Model {
        self.contents.truncate(self.at + 1);
        self.contents[self.at].clone()
    }

    fn end(&mut self, content: Model) {
        self.editor.end_gesture();
        if content != self.contents[self.at] {
            self.contents.push(content);
            self.at += 1;
        }
    }

    fn any(&mut self, filter: impl Fn(&Item) -> bool) -> Option<Entity> {
        let items = self.contents[self.at].items.iter();
        let entities: Vec<Entity> = items.filter(|&item| filter(item)).map(|item| item.entity).collect();
        self.random.one_of(&entities)
    }

    /// A drag of some frames, which may end where it began: one component of one entity runs through values.
    fn drag<C: Component + Clone + PartialEq>(
        &mut self,
        entity: Entity,
        value: impl Fn(&mut Random) -> Option<C>,
        set: impl Fn(&mut Model, Option<C>),
    ) {
        let values: Vec<Option<C>> = (0..=self.random.below(3)).map(|_| value(&mut self.random)).collect();
        let before = self.edited.world.get::<C>(entity).cloned();
        if values.iter().all(|value| *value == before) {
            return;
        }
        let mut content = self.begin();
        for value in values {
            self.editor.change(&mut self.edited.world, entity, value.clone());
            set(&mut content, value);
            if self.random.below(2) == 0 {
                self.edited.extract.run(&mut self.edited.world);
            }
        }
        self.end(content);
    }

    fn drag_item<C: Component + Clone + PartialEq>(
        &mut self,
        entity: Entity,
        value: impl Fn(&mut Random) -> Option<C>,
        set: impl Fn(&mut Item, Option<C>),
    ) {
        self.drag(entity, value, |content, value| set(content.item(entity), value));
    }

    fn edit_object(&mut self, entity: Entity) {
        match self.random.below(6) {
            0 => self.resize(entity),
            1 => self.drag_item(
                entity,
                |r| Some(Color(r.point())),
                |i, v| i.surface.as_mut().unwrap().0 = v.unwrap(),
            ),
            2 => self.drag_item(
                entity,
                |r| Some(Ambient(r.unit())),
                |i, v| i.surface.as_mut().unwrap().1 = v.unwrap(),
            ),
            3 => self.drag_item(
                entity,
                |r| Some(Diffuse(r.unit())),
                |i, v| i.surface.as_mut().unwrap().2 = v.unwrap(),
            ),
            4 => {
                let gloss = maybe(|r| Gloss { specular: r.unit(), shininess: 9.0 });
                self.drag_item(entity, gloss, |i, v| i.gloss = v);
            }
            _ => self.drag_item(entity, maybe(|r| Mirror(r.unit())), |i, v| i.mirror = v),
        }
    }

    fn resize(&mut self, entity: Entity) {
        match self.contents[self.at].item(entity).shape {
            Shape::Sphere(_) => self.drag_item(
                entity,
                |r| Some(Sphere { radius: 1.0 + r.unit() }),
                |i, v| i.shape = Shape::Sphere(v.unwrap()),
            ),
            Shape::Cube(_) => self.drag_item(
                entity,
                |r| Some(Cube { side: 1.0 + r.unit() }),
                |i, v| i.shape = Shape::Cube(v.unwrap()),
            ),
            Shape::Pyramid(_) => self.drag_item(
                entity,
                |r| Some(Pyramid { width: 1.0 + r.unit(), height: 1.0 + r.unit() }),
                |i, v| i.shape = Shape::Pyramid(v.unwrap()),
            ),
            Shape::Board(_) => self.drag_item(
                entity,
                |r| Some(Checkerboard { cell: 1.0 + r.unit() }),
                |i, v| i.shape = Shape::Board(v.unwrap()),
            ),
            Shape::Light => {}
        }
    }

    fn edit_light(&mut self, entity: Entity) {
        match self.random.below(2) {
            0 => self.drag_item(entity, maybe(|r| Falloff(r.unit())), |i, v| i.falloff = v),
            _ => {
                let cone = maybe(|r| SpotCone { target: 7.0 + r.point(), cutoff: 90.0 * r.unit() });
                self.drag_item(entity, cone, |i, v| i.cone = v);
            }
        }
    }

    fn edit_camera(&mut self) {
        let mut cameras = self.edited.world.query_filtered::<Entity, With<Lens>>();
        let camera = cameras.single(&self.edited.world).unwrap();
        let lens = |r: &mut Random| Some(Lens { near: 1.0 + r.unit(), far: 900.0, fovy: 60.0, aspect: 1.0 });
        self.drag(camera, lens, |content, value| content.lens = value.unwrap());
    }

    fn edit_setting(&mut self) {
        let mut content = self.contents[self.at].clone();
        let amount = 1 + u32::try_from(self.random.below(3)).unwrap();
        if self.random.below(2) == 0 {
            content.snapshot = Snapshot { pixels: 8 * amount, level: amount };
            self.editor.change_setting(&mut self.edited.world, content.snapshot);
        } else {
            content.sampling = Sampling { side: amount };
            self.editor.change_setting(&mut self.edited.world, content.sampling);
        }
        if content != self.contents[self.at] {
            self.begin();
            self.end(content);
        }
    }

    /// The model's own idea of the last place in the scene's order.
    fn arrive(&mut self, entity: Entity) {
        let mut content = self.begin();
        let mut item = Item::read(&self.edited.world, entity);
        let (light, board) = (item.is_light(), item.is_board());
        let rivals =
            content.items.iter().filter(|other| other.is_light() == light && (board || !other.is_board()));
        let place = rivals.filter_map(|other| other.order).max().map_or(0, |last| last.0 + 1);
        assert_eq!(item.order, Some(Order(place)));
        item.order = Some(Order(place));
        if !light && !board && content.items.iter().any(|other| other.is_board() && other.order == item.order)
        {
            let boards =
                content.items.iter_mut().filter(|other| other.is_board() && other.order >= item.order);
            boards.for_each(|other| other.order = other.order.map(|order| Order(order.0 + 1)));
        }
        content.items.push(item);
        self.end(content);
    }

    fn replace(&mut self) {
        let file = self.random.one_of(&["highlights.txt", "cone_edge.txt", "cube_on_board.txt"]).unwrap();
        let description = description(file);
        if !self.editor.replace_scene(&mut self.edited.world, &description) {
            return;
        }
        let mut spawned = World::new();
        spawn(&mut spawned, &description);
        spawned.insert_resource(self.contents[self.at].sampling);
        let expected = Followed::with_workers(spawned, self.workers.clone()).tables();
        assert!(self.edited.tables() == expected, "{file}");
        self.begin();
        let content = Model::read(&mut self.edited.world);
        self.end(content);
    }

    fn undo(&mut self) {
        assert_eq!(self.editor.undo(&mut self.edited.world).is_some(), self.at > 0);
        self.at = self.at.saturating_sub(1);
    }

    fn redo(&mut self) {
        let possible = self.at + 1 < self.contents.len();
        assert_eq!(self.editor.redo(&mut self.edited.world).is_some(), possible);
        self.at += usize::from(possible);
    }

    fn step(&mut self) {
        let world = &mut self.edited.world;
        match self.random.below(20) {
            0 | 1 => {
                let (what, _) = self.random.one_of(&New::ALL).unwrap();
                let entity = self.editor.add(world, what);
                self.arrive(entity);
            }
            2 => {
                let entity = self.any(|_| true);
                self.editor.select(entity);
                if let Some(entity) = self.editor.duplicate(&mut self.edited.world) {
                    self.arrive(entity);
                }
            }
            3 | 4 => {
                let entity = self.any(|_| true);
                self.editor.select(entity);
                if self.editor.delete(&mut self.edited.world) {
                    let mut content = self.begin();
                    content.items.retain(|item| Some(item.entity) != entity);
                    self.end(content);
                }
            }
            5..8 => self.undo(),
            8 | 9 => self.redo(),
            10 if self.random.below(5) == 0 => self.replace(),
            11 => self.edit_camera(),
            12 => self.edit_setting(),
            13 | 14 => {
                if let Some(entity) = self.any(Item::is_light) {
                    self.edit_light(entity);
                }
            }
            15..18 => {
                if let Some(entity) = self.any(|item| !item.is_light()) {
                    self.edit_object(entity);
                }
            }
            _ => {
                if let Some(entity) = self.any(|_| true) {
                    let position = |r: &mut Random| Some(Position(r.point()));
                    self.drag_item(entity, position, |item, value| item.position = value.unwrap());
                }
            }
        }
    }
}

fn maybe<C>(value: impl Fn(&mut Random) -> C) -> impl Fn(&mut Random) -> Option<C> {
    move |random| (random.below(3) > 0).then(|| value(random))
}

#[test]
fn tables_after_any_edits_are_those_of_a_world_built_so() {
    for seed in 0..4 {
        let mut game = Game::new("official.txt", seed);
        let first = game.edited.tables();
        for _ in 0..1000 {
            game.step();
            // Several edits may fall between two frames.
            if game.random.below(4) > 0 {
                game.check();
            }
        }
        game.check();
        let last = game.edited.tables();
        let steps = game.at;
        while game.at > 0 {
            game.undo();
            if game.random.below(10) == 0 {
                game.check();
            }
        }
        assert!(game.edited.tables() == first, "seed {seed}: all undone");
        (0..steps).for_each(|_| game.redo());
        assert!(game.edited.tables() == last, "seed {seed}: all redone");
        assert!(steps > 50, "seed {seed}: only {steps} steps were left to undo");
    }
}
