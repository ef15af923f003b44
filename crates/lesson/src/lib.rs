//! The lecture as data: slides, their beats, rays and questions, and the checker.
//!
//! A slide is a Markdown file with a TOML head. Its headings are *beats*: each waits for an event of a
//! walk or of a build, by the event's name. Nothing in a slide is code; the grammars stand in `lessons/README.md`.

mod ask;
mod attributes;
mod beat;
mod beside;
mod board;
mod body;
mod change;
mod check;
mod choices;
mod condition;
mod counts;
mod facts;
mod fit;
#[cfg(not(target_arch = "wasm32"))]
mod folder;
mod head;
mod keeping;
mod keys;
mod library;
mod limits;
mod listing;
mod minutes;
mod offer;
mod packet;
mod packets;
mod pairs;
mod plan;
mod play;
mod plays;
mod problem;
mod reading;
mod slide;
mod stage;
mod tape;
mod template;
mod term;
mod texts;
mod vocabulary;
mod wait;
mod walks;
mod why;

pub use ask::{About, Ask, Choice, Reason};
pub use beat::{Beat, Medium, Paragraph};
pub use board::{
    Board, BoardTape, Care, Cell, Chart, Column, Counted, Drawn, Entry, Formula, Given, How, Lanes, Map, Maps,
    Measured, Meter, Number, Numbers, Panel, Picture, Pictures, Rendered, Row, Runs, Scale, Stopwatch, Stroke, Table,
    Timed, Timing,
};
pub use change::{Planned, Told};
pub use check::{check, check_beside, check_file, glance};
pub use condition::Condition;
pub use facts::Facts;
pub use fit::FitTape;
pub use library::Library;
pub use listing::{Line, Listing};
pub use offer::{Act, Offer};
pub use packet::PacketTape;
pub use pairs::PairsTape;
pub use plan::{Plan, Setting};
pub use play::{Built, Play, PlayError};
pub use plays::Plays;
pub use problem::{Problem, Spot};
pub use slide::{Show, Slide};
pub use stage::{Look, NamedRay, Stage, StageKind};
pub use tape::{BuildTape, Tape, WalkTape};
pub use term::Term;
pub use texts::{Script, Setter};
pub use vocabulary::names;
pub use wait::Wait;
pub use walks::WalksTape;
pub use why::why;
