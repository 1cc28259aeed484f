//! The command line that traces a view again.

use core::fmt;
use std::ffi::{OsStr, OsString};
use std::path::Path;

use glam::DVec3;

use crate::components::CameraPose;
use crate::effects::EffectSet;
use crate::scene::Number;
use crate::study::Setting;

/// `archetrace render` with everything that makes it write the same bytes as a snapshot of the window. As text it is
/// a line for the shell: every number is in the fewest digits that read back to it, and quoted is what has to be.
#[derive(Clone, Debug)]
pub struct RenderCommand<'a> {
    /// Scene file.
    pub scene: &'a Path,
    /// Picture to write.
    pub output: &'a Path,
    /// The camera, as the window has it.
    pub pose: &'a CameraPose,
    /// Accuracy; nothing for what `render` gives the scene by itself.
    pub setting: Option<Setting>,
    /// Effects that are switched off.
    pub muted: EffectSet,
    /// Arguments about textures, as they were given: `--texture` and what follows. None for plain cells.
    pub texture: &'a [OsString],
}

impl fmt::Display for RenderCommand<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let CameraPose { position, l, u, .. } = self.pose;
        write!(
            f,
            "archetrace render {} --output={}",
            Quoted(&not_an_option(self.scene)),
            Quoted(self.output.as_os_str())
        )?;
        write!(f, " --eye={} --look={} --up={}", Commas(*position), Commas(*l), Commas(*u))?;
        if let Some(setting) = &self.setting {
            write!(f, " {}", setting.flags())?;
        }
        self.muted.iter().try_for_each(|effect| write!(f, " --without={}", effect.name()))?;
        self.texture.iter().try_for_each(|argument| write!(f, " {}", Quoted(argument)))
    }
}

/// A path that is not taken for an option.
fn not_an_option(path: &Path) -> OsString {
    let looks_like_one = path.as_os_str().as_encoded_bytes().starts_with(b"-");
    if looks_like_one { Path::new(".").join(path).into() } else { path.into() }
}

struct Commas(DVec3);

impl fmt::Display for Commas {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{},{},{}", Number(self.0.x), Number(self.0.y), Number(self.0.z))
    }
}

/// A word for the shell: as it is where that is safe, else in quotes.
struct Quoted<'a>(&'a OsStr);

impl fmt::Display for Quoted<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let is_safe = |c: char| c.is_ascii_alphanumeric() || "-_./=,:+@%".contains(c);
        match self.0.to_str() {
            Some(word) if !word.is_empty() && word.chars().all(is_safe) => f.write_str(word),
            Some(word) if !word.chars().any(char::is_control) => {
                write!(f, "'{}'", word.replace('\'', r"'\''"))
            }
            // Bytes that are no text, and what a terminal would act upon.
            _ => {
                f.write_str("$'")?;
                self.0.as_encoded_bytes().iter().try_for_each(|&byte| match byte {
                    b' '..=b'~' if !br"'\".contains(&byte) => write!(f, "{}", char::from(byte)),
                    _ => write!(f, "\\x{byte:02x}"),
                })?;
                f.write_str("'")
            }
        }
    }
}
