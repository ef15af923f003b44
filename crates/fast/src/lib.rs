//! The lecture's last chapter: the same answers as the textbook's, at the full speed of the machine.
//!
//! Every structure here answers exactly as `accel`'s brute force does: the same t to the bit, the same triangle. Lanes of
//! single precision only *rule out*: boxes and triangles that are surely missed. What is left is *judged* by `accel`'s own
//! operations in double precision. Why that is certain stands in the room `judge`.
//!
//! Its rooms, from the ground up; each knows only those before it:
//!
//! | room | slides | what it holds |
//! |---|---|---|
//! | `lanes` | 59 | several numbers to one instruction: AVX-512, AVX2, and what every machine has |
//! | `pages` | | arrays in large pages |
//! | `stack` | 59 | what waits while a walk goes down |
//! | `judge` | | what may be ruled out, and what decides about the rest |
//! | `leaf` | 59 | four triangles in three cache lines, tested at once |
//! | `build` | 53-54 | trees of two children by binned surface area, on all threads |
//! | `bvh2` | 56, 59 | a node in one cache line, the nearer child first, a stack of our own |
//! | `bvh8` | 59 | eight boxes at once |
//! | `packet` | 59 | 8 or 16 rays from one eye that walk together |
//! | `kd` | 28-42, 60-62 | the kd-tree with nodes of eight bytes |
//! | `grid` | 16-22 | the grid |
//! | `fast` | | what every structure here can do, with many rays on many threads |
//! | `kinds` | 64 | the structures by name |
//! | `instances` | 10, 27 | a tree over trees: what is stored once and placed many times |
//! | `daylight` | 10 | pictures by a sun and a sky |
//! | `race` | 64 | the rungs from brute force to all threads, timed over the same rays |

mod build;
mod bvh2;
mod bvh8;
mod daylight;
mod fast;
mod grid;
mod instances;
mod judge;
mod kd;
mod kinds;
mod lanes;
mod leaf;
mod packet;
mod pages;
mod race;
mod stack;

pub use build::Settings;
pub use bvh2::{Below, Bvh2};
pub use bvh8::Bvh8;
pub use daylight::{Daylight, Line, Matter, Surface};
pub use fast::{Any, Fast, Nearest, Question};
pub use grid::Grid;
pub use instances::TwoLevels;
pub use judge::{Count, NotOrdinary, Shot, Work};
pub use kd::Kd;
pub use kinds::{AnyFast, FastKind};
pub use lanes::Isa;
pub use packet::{PacketWidth, Packets};
pub use race::{Answered, Elsewhere, Pace, Race, Row, Rung, Runner, Told, tile_order};
