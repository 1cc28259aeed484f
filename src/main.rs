//! The `archetrace` program.

use std::process::ExitCode;

fn main() -> ExitCode {
    archetrace::cli::run()
}
