//! `archetrace selfcheck`

use crate::selfcheck::{SEED, Tally, check_all};

use super::args::SelfcheckArgs;
use super::{CliError, print};

/// Rays of each group and precision.
const RAYS: u64 = 100_000;
const LONG_RAYS: u64 = 10_000_000;

/// Holds the kernels of this program against exact truth on this machine and prints one line for each group.
pub(super) fn selfcheck(args: &SelfcheckArgs) -> Result<(), CliError> {
    let rays = if args.long { LONG_RAYS } else { RAYS };
    print(&format!("seed {SEED:#x}; errors of ray parameters in epsilons (2^-52 and 2^-23)\n"))?;
    print(&format!("{}\n", Tally::header()))?;
    let is_good = check_all(rays, SEED, |tally| print(&format!("{tally}\n")))?;
    if is_good { Ok(()) } else { Err(CliError::Selfcheck) }
}
