//! Chromium without a window. Debian's package `chromium`; tests/run installs it.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use image::RgbImage;
use serde_json::Value;
use tempfile::TempDir;

/// A page in a folder of its own, with the page that looks at it.
pub(crate) struct Opened(TempDir);

impl Opened {
    pub(crate) fn new(page: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("cost.html"), page).unwrap();
        fs::write(folder.path().join("look.html"), include_str!("look.html")).unwrap();
        Self(folder)
    }

    /// What `look.html` has found out.
    pub(crate) fn look(&self) -> Value {
        let output = self.chromium(&["--dump-dom", "--virtual-time-budget=20000"], "look.html");
        let dom = String::from_utf8(output.stdout).unwrap();
        let found = dom.split_once("<pre id=\"found\">").and_then(|(_, rest)| rest.split_once("</pre>"));
        let (found, _) =
            found.unwrap_or_else(|| panic!("{dom}\n{}", String::from_utf8_lossy(&output.stderr)));
        serde_json::from_str(found).unwrap_or_else(|error| panic!("{error}: {found}"))
    }

    /// The page as it is seen in a window of that size; `page` is `cost.html` or `look.html#N`, where the Nth button is pressed.
    pub(crate) fn screenshot(&self, page: &str, [width, height]: [u32; 2], is_dark: bool) -> RgbImage {
        let file = self.0.path().join("screen.png");
        let flags = [
            format!("--screenshot={}", file.display()),
            format!("--window-size={width},{height}"),
            format!("--blink-settings=preferredColorScheme={}", if is_dark { 0 } else { 1 }),
            "--hide-scrollbars".to_owned(),
            "--virtual-time-budget=20000".to_owned(),
        ];
        let output = self.chromium(&flags.each_ref().map(String::as_str), page);
        let shot = image::open(&file);
        shot.unwrap_or_else(|error| panic!("{error}: {}", String::from_utf8_lossy(&output.stderr)))
            .into_rgb8()
    }

    fn chromium(&self, flags: &[&str], page: &str) -> Output {
        let profile = tempfile::tempdir().unwrap();
        let mut command = Command::new(chromium());
        command.args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run"]);
        command.args(["--disable-background-networking", "--disable-component-update", "--disable-sync"]);
        // The page that looks is a file and looks at a file.
        command.args(["--allow-file-access-from-files", "--host-resolver-rules=MAP * ~NOTFOUND"]);
        command.arg(format!("--user-data-dir={}", profile.path().display()));
        command.args(flags).arg(format!("file://{}/{page}", self.0.path().display()));
        command.output().unwrap()
    }
}

fn chromium() -> PathBuf {
    let path = Path::new("/usr/bin/chromium");
    assert!(path.exists(), "no {}: install Debian's package chromium, or run tests/run", path.display());
    path.to_owned()
}
