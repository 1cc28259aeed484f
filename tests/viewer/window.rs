//! A window to be driven.

use std::collections::VecDeque;
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::display::{Display, PATIENCE, lines_of, spawn};
use crate::lines::{Line, Pose};
use crate::program::{Folder, PROGRAM};

/// What a desktop around the tests may have set and a window would listen to.
const SURROUNDINGS: [&str; 6] =
    ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET", "WINIT_X11_SCALE_FACTOR", "XAUTHORITY", "XMODIFIERS"];

/// The program in a folder, with nothing around it but what a test says.
pub(crate) fn program(folder: &Folder) -> Command {
    without_surroundings(folder, Path::new(PROGRAM))
}

/// Another program, likewise.
pub(crate) fn without_surroundings(folder: &Folder, program: &Path) -> Command {
    let mut command = Command::new(program);
    for name in SURROUNDINGS {
        command.env_remove(name);
    }
    command.current_dir(folder.path(""));
    command
}

/// An open window that has the focus of a display of its own. It is gone after the test.
pub(crate) struct Window {
    program: Child,
    /// Its number on the display.
    pub(crate) id: u32,
    lines: Receiver<String>,
    /// What nobody has asked about yet, in the order in which it came.
    pending: VecDeque<Line>,
    /// Everything, for messages.
    story: Vec<String>,
    complaints: Receiver<String>,
    /// Where the camera was when somebody last asked.
    pub(crate) pose: Pose,
    pub(crate) display: Display,
}

impl Window {
    /// Opens a window in a folder: `archetrace view` with arguments divided by blanks.
    #[track_caller]
    pub(crate) fn open(folder: &Folder, arguments: &str) -> Self {
        Self::open_with(&arguments.split_whitespace().collect::<Vec<_>>(), &mut program(folder))
    }

    /// The same with a command that has been set up, and a list of arguments.
    #[track_caller]
    pub(crate) fn open_with(arguments: &[&str], command: &mut Command) -> Self {
        let display = Display::start();
        command.arg("view").args(arguments).args(["--print-camera", "--print-events"]);
        let mut window = Self::start(display, command);
        window.event("ready");
        window.camera();
        window.wait_for_window();
        window.focus();
        window
    }

    /// Opens a window that is not told to tell anything.
    #[track_caller]
    pub(crate) fn silent(command: &mut Command) -> Self {
        let display = Display::start();
        let mut window = Self::start(display, command);
        window.wait_for_window();
        window.focus();
        window
    }

    fn start(display: Display, command: &mut Command) -> Self {
        command.env("DISPLAY", &display.name).stdin(Stdio::null());
        let mut program = spawn(command.stdout(Stdio::piped()).stderr(Stdio::piped()));
        let lines = lines_of(program.stdout.take().unwrap());
        let complaints = lines_of(program.stderr.take().unwrap());
        let (pending, story, id, pose) = (VecDeque::new(), Vec::new(), 0, crate::lines::START);
        Self { program, id, lines, pending, story, complaints, pose, display }
    }

    #[track_caller]
    fn wait_for_window(&mut self) {
        let deadline = Instant::now() + PATIENCE;
        while self.id == 0 {
            assert!(Instant::now() < deadline, "there is no window\n{}", self.tell());
            self.id = self.display.window_named("archetrace").unwrap_or_default();
        }
    }
}

/// Hands.
impl Window {
    /// Gives the window the keyboard: there is no window manager that would.
    #[track_caller]
    pub(crate) fn focus(&self) {
        self.display.xdotool(&format!("windowfocus --sync {}", self.id));
    }

    /// Presses keys one after the other, each as `xdotool key` names it.
    #[track_caller]
    pub(crate) fn key(&self, keys: &str) {
        self.display.xdotool(&format!("key {keys}"));
    }

    /// Puts the pointer over a pixel of the window.
    #[track_caller]
    pub(crate) fn point(&self, (x, y): (u32, u32)) {
        self.display.xdotool(&format!("mousemove --window {} {x} {y}", self.id));
    }

    /// Clicks on a pixel of the window.
    #[track_caller]
    pub(crate) fn click(&self, at: (u32, u32)) {
        self.point(at);
        self.display.xdotool("click 1");
    }

    /// Makes the window larger or smaller.
    #[track_caller]
    pub(crate) fn resize(&self, width: u32, height: u32) {
        self.display.xdotool(&format!("windowsize {} {width} {height}", self.id));
    }

    /// Sends the program a signal: STOP makes the machine look busy, CONT ends that.
    #[track_caller]
    pub(crate) fn signal(&self, name: &str) {
        let id = self.program.id().to_string();
        assert!(Command::new("kill").args([&format!("-{name}"), &id]).status().unwrap().success());
    }
}

/// Ears.
impl Window {
    /// Waits for a line, and takes it out of what has been said.
    #[track_caller]
    pub(crate) fn wait<T>(&mut self, what: &str, pick: impl Fn(&Line) -> Option<T>) -> T {
        let deadline = Instant::now() + PATIENCE;
        loop {
            if let Some((at, found)) = self.pending.iter().enumerate().find_map(|(i, l)| Some((i, pick(l)?)))
            {
                self.pending.remove(at);
                return found;
            }
            if let Err(error) = self.listen(deadline.saturating_duration_since(Instant::now())) {
                panic!("{what} did not come ({error})\n{}", self.tell());
            }
        }
    }

    fn listen(&mut self, at_most: Duration) -> Result<(), RecvTimeoutError> {
        let line = self.lines.recv_timeout(at_most)?;
        self.pending.push_back(Line::read(&line));
        self.story.push(line);
        Ok(())
    }

    /// The next pose of the camera that is printed.
    #[track_caller]
    pub(crate) fn camera(&mut self) -> Pose {
        self.pose = self.wait("a pose of the camera", Line::camera);
        self.pose
    }

    /// The next event of this name.
    #[track_caller]
    pub(crate) fn event(&mut self, name: &str) -> Value {
        self.event_where(name, |_| true)
    }

    /// The next event of this name that something else holds for.
    #[track_caller]
    pub(crate) fn event_where(&mut self, name: &str, holds: impl Fn(&Value) -> bool) -> Value {
        self.wait(&format!("event {name}"), |line| line.event(name).filter(|event| holds(event)).cloned())
    }

    /// The next line in words that starts so; the rest of it.
    #[track_caller]
    pub(crate) fn words(&mut self, start: &str) -> String {
        self.wait(start, |line| Some(line.words()?.strip_prefix(start)?.to_owned()))
    }

    /// Presses a key that moves the camera, and waits for the pose it moves to.
    #[track_caller]
    pub(crate) fn step(&mut self, key: &str) -> Pose {
        self.key(key);
        self.camera()
    }

    /// From now on nobody reads what the program says.
    pub(crate) fn deaf(&mut self) {
        self.lines = mpsc::channel().1;
    }

    /// Whatever has been said and not asked about is of no interest.
    pub(crate) fn forget(&mut self) {
        while self.listen(Duration::ZERO).is_ok() {}
        self.pending.clear();
    }

    /// What has been said and not asked about.
    pub(crate) fn unasked(&mut self) -> Vec<Line> {
        while self.listen(Duration::ZERO).is_ok() {}
        self.pending.iter().cloned().collect()
    }

    /// Everything the program has said.
    pub(crate) fn tell(&self) -> String {
        let complaints: Vec<String> = self.complaints.try_iter().collect();
        format!("standard output:\n{}\nstandard error:\n{}", self.story.join("\n"), complaints.join("\n"))
    }

    /// Waits until the window shows something.
    #[track_caller]
    pub(crate) fn shows(&self, what: &str, expected: impl Fn(u16, u16, &[u8]) -> bool) {
        let deadline = Instant::now() + PATIENCE;
        loop {
            let (width, height, pixels) = self.display.pixels(self.id);
            if expected(width, height, &pixels) {
                return;
            }
            assert!(Instant::now() < deadline, "the window does not show {what}\n{}", self.tell());
            thread::sleep(Duration::from_millis(30));
        }
    }
}

/// Ends.
impl Window {
    /// Waits for the program to end by itself.
    #[track_caller]
    pub(crate) fn ends_within(&mut self, at_most: Duration) -> ExitStatus {
        let deadline = Instant::now() + at_most;
        loop {
            if let Some(status) = self.program.try_wait().unwrap() {
                return status;
            }
            assert!(Instant::now() < deadline, "still there after {at_most:?}\n{}", self.tell());
            thread::sleep(Duration::from_millis(10));
        }
    }

    /// Closes the window: the program ends well, and had nothing to complain about.
    #[track_caller]
    pub(crate) fn close(mut self) {
        self.key("ctrl+q");
        self.ends_well(PATIENCE);
    }

    /// The program ends by itself, and well.
    #[track_caller]
    pub(crate) fn ends_well(&mut self, at_most: Duration) {
        let status = self.ends_within(at_most);
        while self.listen(PATIENCE).is_ok() {}
        assert_eq!(status.code(), Some(0), "{}", self.tell());
        let complaints: Vec<String> = self.complaints.iter().collect();
        let is_bad = |line: &String| line.contains("panicked") || line.starts_with("error");
        assert!(!complaints.iter().any(is_bad), "{complaints:?}\n{}", self.tell());
    }
}

impl Drop for Window {
    fn drop(&mut self) {
        // It may have ended already, which is as well.
        let _ = self.program.kill();
        let _ = self.program.wait();
    }
}
