//! Bytes that nobody would write: six readers and walkers take any, without a panic and in bounded time.
//!
//! Each body stands here once. The suite runs it over seeds that are changed at random ([`drive`]); `fuzz/`
//! hands the same bodies to libFuzzer.

mod decode;
pub mod drive;
mod files;
mod mutate;
mod obj;
mod rays;
mod settings;
mod texts;
mod walks;

pub use files::files;
pub use obj::obj;
pub use rays::rays;
pub use settings::settings;
pub use texts::texts;
pub use walks::walks;

/// A body, and words that its input is made of.
pub struct Target {
    /// Its name: that of the folder of its seeds, and of its libFuzzer target.
    pub name: &'static str,
    /// What takes the bytes; it panics if something does not hold.
    pub body: fn(&[u8]),
    /// What is put into the seeds.
    pub words: &'static [&'static str],
    /// Files of the project that are seeds too: folders, with the ending of the files.
    pub seeds: &'static [(&'static str, &'static str)],
}

/// All of them.
pub const TARGETS: [Target; 6] =
    [obj::TARGET, rays::TARGET, files::TARGET, texts::TARGET, walks::TARGET, settings::TARGET];

/// Numbers where readers go wrong.
pub(crate) const NUMBERS: [&str; 24] = [
    "0",
    "-0",
    "1",
    "-1",
    "2147483647",
    "2147483648",
    "-2147483649",
    "4294967296",
    "18446744073709551616",
    "1e18",
    "1e38",
    "1e39",
    "1e-45",
    "1e999",
    "nan",
    "inf",
    "-inf",
    "0.1",
    "1.",
    ".5",
    "+1",
    "1_0",
    "0x1",
    "٣",
];
