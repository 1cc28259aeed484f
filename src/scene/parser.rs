//! Words to [`Description`].

use glam::DVec3;

use crate::components::range::{
    COEFFICIENT, COLOR, CUTOFF, FALLOFF, FIELD_OF_VIEW, LENGTH, MAX_LEVEL, MAX_PIXELS, RATIO, SHININESS,
};

use super::ahead::Ahead;
use super::description::{
    BoardDescription, Description, LightDescription, ObjectDescription, ShapeDescription, SpotDescription,
    SurfaceDescription,
};
use super::problem::{Problem, quoted};
use super::values::{Parser, Stop, is_number, is_object_word, rounded};
use super::write::Number;

/// Most objects in a file.
pub const MAX_OBJECTS: u32 = 2_000_000;
/// Most lights of each kind in a file.
pub const MAX_LIGHTS: u32 = 10_000;

/// Reads a scene. On success there may be warnings; on failure there is every problem that could be told apart
/// from its consequences, at least one.
pub fn parse(text: &str) -> Result<(Description, Vec<Problem>), Vec<Problem>> {
    let mut parser = Parser::new(text);
    match parser.file() {
        Ok(description) if parser.problems.is_empty() => Ok((description, parser.finished_warnings())),
        _ => Err(parser.problems),
    }
}

impl Parser<'_> {
    fn file(&mut self) -> Result<Description, Stop> {
        let near = self.number("the distance of the near plane", &LENGTH)?;
        let far = self.number("the distance of the far plane", &LENGTH)?;
        if near >= far {
            let message = format!("the distance of the far plane is {}", Number(far));
            let label = format!("must be greater than that of the near plane, {}", Number(near));
            self.fail(self.last.clone(), message, label)?;
        }
        let fovy = self.number("the vertical field of view", &FIELD_OF_VIEW)?;
        let aspect = self.number("the aspect ratio", &RATIO)?;
        if FIELD_OF_VIEW.contains(fovy) && RATIO.contains(aspect) && !FIELD_OF_VIEW.contains(aspect * fovy) {
            let fovx = Number(rounded(aspect * fovy));
            let message =
                format!("the horizontal field of view, aspect ratio times vertical one, is {fovx} degrees");
            self.fail(self.last.clone(), message, format!("must make it {}", FIELD_OF_VIEW.words))?;
        }
        let level = self.whole("the level of recursion", 0, MAX_LEVEL)?;
        let pixels = self.whole("the number of pixels along each side", 1, MAX_PIXELS)?;
        let board = self.board()?;
        let objects = self.objects()?;
        let lights = self.list("normal light", |parser| parser.light("light"))?;
        let spots = self.list("spotlight", Self::spot)?;
        self.check_rest();
        Ok(Description { near, far, fovy, aspect, level, pixels, board, objects, lights, spots })
    }

    fn board(&mut self) -> Result<BoardDescription, Stop> {
        let cell = self.number("the width of the checkerboard's cells", &LENGTH)?;
        let ambient = self.number("the checkerboard's ambient coefficient", &COEFFICIENT)?;
        let start = self.last.start;
        let diffuse = self.number("the checkerboard's diffuse coefficient", &COEFFICIENT)?;
        let reflection = self.number("the checkerboard's reflection coefficient", &COEFFICIENT)?;
        self.check_sum(start, "ambient + diffuse + reflection", (ambient + diffuse) + reflection);
        Ok(BoardDescription { cell, ambient, diffuse, reflection })
    }

    fn objects(&mut self) -> Result<Vec<ObjectDescription>, Stop> {
        let count = self.count("object", MAX_OBJECTS)?;
        // Grown as objects come: a count alone costs no memory.
        let mut objects = Vec::new();
        let mut ahead = Ahead::read(self, count);
        let mut index = 0;
        while index < count {
            if let Some(taken) = ahead.take(self, &mut objects, count - index) {
                index += taken;
                continue;
            }
            index += 1;
            match self.object(index, count) {
                Ok(object) => objects.push(object),
                Err(Stop::AtObject) => {}
                Err(Stop::Lost) => return Err(Stop::Lost),
            }
        }
        let extra = self.peek().filter(|word| is_object_word(word.text));
        if let Some(word) = extra.filter(|_| self.problems.is_empty()) {
            let message = format!("found {} where the number of normal lights should be", quoted(word.text));
            self.fail_count(word.span(), message, "one object more than announced")?;
        }
        match extra {
            Some(_) => Err(Stop::Lost),
            None => Ok(objects),
        }
    }

    pub(super) fn object(&mut self, index: u32, count: u32) -> Result<ObjectDescription, Stop> {
        let Some(mut word) = self.next() else {
            return self.ended(&format!("object {index} of {count}"), "sphere, cube or pyramid");
        };
        if !is_object_word(word.text) {
            let message = format!("found {} where object {index} of {count} should start", quoted(word.text));
            self.fail_count(word.span(), message, "must be sphere, cube or pyramid")?;
            self.skip_to_object()?;
            // A number before the object was one too many; any other word was this object's name.
            if !is_number(word.text) {
                return Err(Stop::AtObject);
            }
            word = self.next().ok_or(Stop::Lost)?;
        }
        let name = word.text;
        let position = self.point(format_args!("the {name}'s "), "")?;
        let mut length = |what: &str| self.number(format_args!("the {name}'s {what}"), &LENGTH);
        let shape = match name {
            "sphere" => ShapeDescription::Sphere { radius: length("radius")? },
            "cube" => ShapeDescription::Cube { side: length("side")? },
            _ => ShapeDescription::Pyramid { width: length("width")?, height: length("height")? },
        };
        let surface = self.surface(name)?;
        Ok(ObjectDescription { position, shape, surface })
    }

    fn surface(&mut self, name: &str) -> Result<SurfaceDescription, Stop> {
        let mut channel = |what: &str| self.number(format_args!("the {name}'s {what}"), &COLOR);
        let color = DVec3::new(channel("red")?, channel("green")?, channel("blue")?);
        let ambient = self.number(format_args!("the {name}'s ambient coefficient"), &COEFFICIENT)?;
        let start = self.last.start;
        let mut coefficient =
            |what: &str| self.number(format_args!("the {name}'s {what} coefficient"), &COEFFICIENT);
        let diffuse = coefficient("diffuse")?;
        let specular = coefficient("specular")?;
        let reflection = coefficient("reflection")?;
        let sum = ((ambient + diffuse) + specular) + reflection;
        self.check_sum(start, "ambient + diffuse + specular + reflection", sum);
        let shininess = self.number(format_args!("the {name}'s shininess"), &SHININESS)?;
        Ok(SurfaceDescription { color, ambient, diffuse, specular, reflection, shininess })
    }

    /// A count and that many items. Nothing here has a word of its own, so nothing can be skipped to.
    fn list<I>(
        &mut self,
        name: &str,
        mut item: impl FnMut(&mut Self) -> Result<I, Stop>,
    ) -> Result<Vec<I>, Stop> {
        let count = self.count(name, MAX_LIGHTS)?;
        self.in_list = true;
        let mut items = Vec::new();
        for _ in 0..count {
            items.push(item(self)?);
        }
        Ok(items)
    }

    fn light(&mut self, name: &str) -> Result<LightDescription, Stop> {
        let position = self.point(format_args!("the {name}'s "), "")?;
        let falloff = self.number(format_args!("the {name}'s falloff"), &FALLOFF)?;
        Ok(LightDescription { position, falloff })
    }

    fn spot(&mut self) -> Result<SpotDescription, Stop> {
        let light = self.light("spotlight")?;
        let start = self.peek().map_or(self.end, |word| word.start);
        let target = self.point("the ", " of the point that the spotlight looks at")?;
        if target == light.position {
            let message = "the spotlight looks at its own position, so its cone has no direction";
            self.fail(start..self.last.end, message.into(), "must be another point")?;
        }
        let cutoff = self.number("the spotlight's cutoff angle", &CUTOFF)?;
        Ok(SpotDescription { light, target, cutoff })
    }

    /// Passes over the numbers of an object of unknown kind, up to the next object. Any other word would be read as
    /// what it is not, and so would a word of prose that happens to name an object.
    fn skip_to_object(&mut self) -> Result<(), Stop> {
        while self.peek().is_some_and(|word| is_number(word.text)) {
            self.words.next();
        }
        let mut ahead = self.words;
        let starts_object = ahead.next().is_some_and(|word| is_object_word(word.text))
            && ahead.next().is_some_and(|word| is_number(word.text));
        if starts_object { Ok(()) } else { Err(Stop::Lost) }
    }

    /// Prose may follow the last number. A number there is more likely one that some count left out.
    fn check_rest(&mut self) {
        if let Some(word) = self.peek().filter(|word| is_number(word.text)) {
            let message = format!("found {} after the last number of the scene", quoted(word.text));
            self.warn(Problem::warning(word.span(), message, "this and all that follows is not read"));
        }
    }

    fn check_sum(&mut self, start: usize, names: &str, sum: f64) {
        // The promise is in decimal; sums of doubles meet it only nearly.
        if (sum - 1.0).abs() <= 1e-6 || sum.is_nan() {
            return;
        }
        let message = format!("the coefficients add up to {}", Number(rounded(sum)));
        let label = format!("{names} should be 1");
        self.warn(Problem::warning(start..self.last.end, message, label));
    }
}
