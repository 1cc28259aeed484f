//! What the window says, line by line.

use serde_json::Value;

/// Where the camera is, as the window prints it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pose {
    pub(crate) pos: [f64; 3],
    pub(crate) l: [f64; 3],
    pub(crate) r: [f64; 3],
    pub(crate) u: [f64; 3],
}

/// Where the camera starts.
pub(crate) const START: Pose =
    Pose { pos: [0.0, -150.0, 50.0], l: [0.0, 1.0, 0.0], r: [1.0, 0.0, 0.0], u: [0.0, 0.0, 1.0] };

impl Pose {
    /// `None` if a line is about something else. Numbers are read by the standard library: what a JSON reader makes of
    /// the last digit is not said to be exact.
    fn read(line: &str) -> Option<Self> {
        let vector = |name: &str| {
            let (_, rest) = line.split_once(&format!("\"{name}\":["))?;
            let numbers: Vec<f64> = rest.split_once(']')?.0.split(',').flat_map(str::parse).collect();
            <[f64; 3]>::try_from(numbers).ok()
        };
        Some(Self { pos: vector("pos")?, l: vector("l")?, r: vector("r")?, u: vector("u")? })
    }

    /// The flags that put a camera here.
    pub(crate) fn flags(&self) -> String {
        let commas = |[x, y, z]: [f64; 3]| format!("{x:?},{y:?},{z:?}");
        format!("--eye={} --look={} --up={}", commas(self.pos), commas(self.l), commas(self.u))
    }

    /// Every number's bits.
    pub(crate) fn bits(&self) -> [u64; 12] {
        let mut numbers = [self.pos, self.l, self.r, self.u].into_iter().flatten();
        std::array::from_fn(|_| numbers.next().unwrap().to_bits())
    }
}

/// A line on standard output.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Line {
    Camera(Pose),
    Event(Value),
    Words(String),
}

impl Line {
    pub(crate) fn read(line: &str) -> Self {
        match (Pose::read(line), serde_json::from_str::<Value>(line)) {
            (Some(pose), _) => Self::Camera(pose),
            (None, Ok(event)) if event["event"].is_string() => Self::Event(event),
            _ => Self::Words(line.to_owned()),
        }
    }

    pub(crate) fn camera(&self) -> Option<Pose> {
        if let Self::Camera(pose) = self { Some(*pose) } else { None }
    }

    /// The event, if it has this name.
    pub(crate) fn event(&self, name: &str) -> Option<&Value> {
        if let Self::Event(event) = self { Some(event).filter(|event| event["event"] == name) } else { None }
    }

    pub(crate) fn words(&self) -> Option<&str> {
        if let Self::Words(words) = self { Some(words) } else { None }
    }
}

#[test]
fn lines_are_told_apart() {
    let camera = r#"{"pos":[0.0,-150.0,50.0],"l":[0.0,1.0,0.0],"r":[1.0,0.0,0.0],"u":[0.0,0.0,1.0]}"#;
    assert_eq!(Line::read(camera).camera(), Some(START));
    let event = Line::read(r#"{"event":"mode","mode":"traced"}"#);
    assert_eq!(event.event("mode").unwrap()["mode"], "traced");
    assert_eq!(event.event("ready"), None);
    assert_eq!(Line::read("wrote scene-001.bmp").words(), Some("wrote scene-001.bmp"));
}
