//! What can go wrong.

use std::fmt;

/// Why the GPU gives no answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fault {
    /// The tree is larger than a buffer may be.
    Large {
        /// What its larger part takes, in bytes.
        bytes: u64,
        /// What a buffer may hold.
        most: u64,
    },
    /// It has more triangles than the GPU's tree tells apart.
    Many,
    /// The device is lost: why, as the driver says.
    Lost(String),
    /// It is out of memory, or refuses something else: what the driver says.
    Refused(String),
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Fault::Large { bytes, most } => {
                write!(f, "the tree takes {bytes} bytes in one piece, and this GPU holds at most {most}")
            }
            Fault::Many => f.write_str("the mesh has more than 268435456 triangles, and the GPU tells no more apart"),
            Fault::Lost(why) => write!(f, "the graphics device is lost: {why}"),
            Fault::Refused(why) => write!(f, "the graphics device refuses: {why}"),
        }
    }
}

impl std::error::Error for Fault {}
