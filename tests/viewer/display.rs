//! A display of a test's own, and hands for its keyboard and mouse.

use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{self, Receiver};
use std::thread;
use std::time::Duration;

use x11rb::protocol::xproto::{ClientMessageEvent, ConnectionExt, EventMask, ImageFormat, InputFocus};
use x11rb::rust_connection::RustConnection;

/// How long anything may take. A machine that runs all tests at once is slow.
pub(crate) const PATIENCE: Duration = Duration::from_secs(60);

/// Lines of a stream as they come; the end of the stream is the end of the channel.
pub(crate) fn lines_of(stream: impl std::io::Read + Send + 'static) -> Receiver<String> {
    let (sender, lines) = mpsc::channel();
    thread::spawn(move || {
        let whole = BufReader::new(stream).lines().map_while(Result::ok);
        // Nobody listens any more once the test is over.
        let _ = whole.map(|line| sender.send(line)).find(Result::is_err);
    });
    lines
}

/// Starts a program, which [`missing`] is about.
pub(crate) fn spawn(command: &mut Command) -> Child {
    command.spawn().unwrap_or_else(|error| missing(command, &error))
}

fn missing(command: &Command, error: &std::io::Error) -> ! {
    let program = command.get_program().display();
    panic!("cannot run {program}: {error}; tests/run installs what these tests need")
}

/// An X server without a screen. It is gone after the test.
pub(crate) struct Display {
    server: Child,
    /// What `DISPLAY` is set to.
    pub(crate) name: String,
}

impl Display {
    /// On a number that the server finds free.
    pub(crate) fn start() -> Self {
        let mut command = Command::new("Xvfb");
        command.args(["-displayfd", "1", "-screen", "0", "1280x1024x24+32", "-nolisten", "tcp", "-noreset"]);
        let mut server = spawn(command.stdout(Stdio::piped()).stderr(Stdio::null()));
        let number = lines_of(server.stdout.take().unwrap()).recv_timeout(PATIENCE);
        let name = format!(":{}", number.expect("Xvfb tells the number of its display"));
        Self { server, name }
    }

    /// Runs xdotool, with arguments divided by blanks; what it printed.
    #[track_caller]
    pub(crate) fn xdotool(&self, arguments: &str) -> String {
        let mut command = self.hands(arguments);
        let output = command.output().unwrap_or_else(|error| missing(&command, &error));
        assert!(output.status.success(), "xdotool {arguments}: {output:?}");
        String::from_utf8(output.stdout).unwrap()
    }

    fn hands(&self, arguments: &str) -> Command {
        let mut command = Command::new("xdotool");
        command.args(arguments.split_whitespace()).env("DISPLAY", &self.name);
        command
    }

    /// The window that has this in its title, once it shows.
    pub(crate) fn window_named(&self, name: &str) -> Option<u32> {
        // Finding nothing is a failure to xdotool.
        let mut command = self.hands(&format!("search --onlyvisible --name {name}"));
        let output = command.output().unwrap_or_else(|error| missing(&command, &error));
        String::from_utf8(output.stdout).unwrap().trim().parse().ok()
    }

    /// Asks a window to close, as the cross in its title bar does. There is no window manager that would.
    pub(crate) fn ask_to_close(&self, window: u32) {
        let connection = self.connect();
        let atom = |name: &str| connection.intern_atom(false, name.as_bytes()).unwrap().reply().unwrap().atom;
        let message =
            ClientMessageEvent::new(32, window, atom("WM_PROTOCOLS"), [atom("WM_DELETE_WINDOW"), 0, 0, 0, 0]);
        connection.send_event(false, window, EventMask::NO_EVENT, message).unwrap().check().unwrap();
    }

    /// Gives the keyboard to nobody.
    pub(crate) fn take_focus_away(&self) {
        let connection = self.connect();
        let nobody = connection.set_input_focus(InputFocus::NONE, x11rb::NONE, x11rb::CURRENT_TIME);
        nobody.unwrap().check().unwrap();
    }

    /// Width, height and colours of a window, top row first.
    pub(crate) fn pixels(&self, window: u32) -> (u16, u16, Vec<u8>) {
        let connection = self.connect();
        let size = connection.get_geometry(window).unwrap().reply().unwrap();
        let (width, height) = (size.width, size.height);
        let image = connection.get_image(ImageFormat::Z_PIXMAP, window, 0, 0, width, height, !0).unwrap();
        let bytes = image.reply().unwrap().data;
        assert_eq!(bytes.len(), usize::from(width) * usize::from(height) * 4, "32 bits a pixel");
        let rgb = bytes.chunks(4).flat_map(|bgr| [bgr[2], bgr[1], bgr[0]]).collect();
        (width, height, rgb)
    }

    fn connect(&self) -> RustConnection {
        x11rb::connect(Some(&self.name)).unwrap().0
    }
}

impl Display {
    /// Ends it, with everything that is on it.
    pub(crate) fn stop(&mut self) {
        // It may have died already, which is as well.
        let _ = self.server.kill();
        let _ = self.server.wait();
    }
}

impl Drop for Display {
    fn drop(&mut self) {
        self.stop();
    }
}
