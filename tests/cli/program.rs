//! Runs the program in a folder of its own.

use std::fs;
use std::path::PathBuf;
use std::process::Output;
use std::time::Duration;

use tempfile::TempDir;

/// The program.
pub(crate) const PROGRAM: &str = env!("CARGO_BIN_EXE_archetrace");

/// A scene with one of everything, and neither a mirror image of itself nor turned by 180 degrees the same.
pub(crate) const SCENE: &str = "\
1 1000  60 1
3
32
10  0.2 0.5 0.3
3
sphere   10  20 15  12     1 0.4 0.2    0.2 0.4 0.3 0.1  20
cube    -30   0  0  18     0.3 0.8 0.4  0.2 0.6 0 0.2  1
pyramid -10 -50  0  20 25  0.2 0.4 1    0.3 0.7 0 0  1
1
60 -70 100  0.00001
1
-60 -70 90  0  0 10 10  30
";

/// How a run ended.
#[derive(Debug)]
pub(crate) struct Run {
    pub(crate) code: Option<i32>,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

impl From<Output> for Run {
    fn from(output: Output) -> Self {
        Self {
            code: output.status.code(),
            stdout: String::from_utf8_lossy(&output.stdout).into_owned(),
            stderr: String::from_utf8_lossy(&output.stderr).into_owned(),
        }
    }
}

impl Run {
    /// It worked and had nothing to complain about; what it printed.
    #[track_caller]
    pub(crate) fn quiet(self) -> String {
        assert_eq!((self.code, self.stderr.as_str()), (Some(0), ""), "{self:?}");
        self.stdout
    }

    /// It worked, whatever it said.
    #[track_caller]
    pub(crate) fn succeeded(self) -> Self {
        assert_eq!(self.code, Some(0), "{self:?}");
        self
    }

    /// It failed with status 1 and one line; the line.
    #[track_caller]
    pub(crate) fn refusal(self) -> String {
        assert_eq!((self.code, self.stdout.as_str()), (Some(1), ""), "{self:?}");
        let line = self.stderr.strip_suffix('\n').expect("the line ends");
        assert!(line.starts_with("error: ") && !line.contains('\n'), "{line}");
        line.to_owned()
    }

    /// It was called wrongly; what it said.
    #[track_caller]
    pub(crate) fn misuse(self) -> String {
        assert_eq!((self.code, self.stdout.as_str()), (Some(2), ""), "{self:?}");
        assert!(self.stderr.starts_with("error: "), "{self:?}");
        self.stderr
    }
}

/// A folder that is gone after the test.
pub(crate) struct Folder(TempDir);

impl Folder {
    /// With nothing in it.
    pub(crate) fn empty() -> Self {
        Self(TempDir::new().unwrap())
    }

    /// With [`SCENE`] as `scene.txt`.
    pub(crate) fn with_scene() -> Self {
        let folder = Self::empty();
        folder.put("scene.txt", SCENE);
        folder
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub(crate) fn put(&self, name: &str, content: impl AsRef<[u8]>) {
        fs::write(self.path(name), content).unwrap();
    }

    pub(crate) fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// Everything in it, hidden files too, in order.
    pub(crate) fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.0.path()).unwrap();
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    /// Runs the program here, with arguments divided by blanks. A hang fails the test.
    pub(crate) fn run(&self, arguments: &str) -> Run {
        self.run_list(&arguments.split_whitespace().collect::<Vec<_>>())
    }

    /// Runs the program here.
    pub(crate) fn run_list(&self, arguments: &[&str]) -> Run {
        self.finish(assert_cmd::Command::new(PROGRAM).args(arguments))
    }

    /// Runs a line of bash here, in which `$P` is the program.
    pub(crate) fn bash(&self, line: &str) -> Run {
        self.finish(assert_cmd::Command::new("bash").args(["-c", line]).env("P", PROGRAM))
    }

    /// A machine with other work may take its time; a program that waits for ever is told from that.
    #[track_caller]
    fn finish(&self, command: &mut assert_cmd::Command) -> Run {
        let command = command.current_dir(self.0.path()).timeout(Duration::from_secs(120));
        let run = Run::from(command.output().unwrap());
        assert!(run.code.is_some(), "killed by a signal, or still running after 120 s: {run:?}");
        assert!(!run.stderr.contains("panicked"), "{run:?}");
        run
    }

    /// Renders `scene.txt` with further arguments and gives back the file.
    #[track_caller]
    pub(crate) fn render(&self, arguments: &str) -> Vec<u8> {
        self.run(&format!("render scene.txt -o rendered.bmp {arguments}")).quiet();
        self.read("rendered.bmp")
    }
}
