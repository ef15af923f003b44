//! What is shown: the slide and its walk, how far it is, from where it is seen, and the commands that change
//! that. It knows no window, file or clock, so that everything that shows slides can share it.

pub(crate) mod all_nodes;
pub(crate) mod awaited;
pub(crate) mod beside;
pub(crate) mod board;
pub(crate) mod camera;
pub mod command;
pub(crate) mod eye;
pub(crate) mod heat;
pub(crate) mod history;
pub(crate) mod kind_name;
pub(crate) mod lecture;
pub(crate) mod link;
pub(crate) mod own;
pub(crate) mod pictures;
pub(crate) mod playback;
pub(crate) mod reel;
pub mod state;
pub(crate) mod steps;
pub(crate) mod talk;
pub(crate) mod unknown;
pub(crate) mod view;
pub(crate) mod words;

pub use beside::{Beside, Pace, Rivals};
pub use lecture::{Cover, InHand, Lecture};
pub use link::Link;
pub use own::{OwnScene, Tried};
pub use playback::{Playback, Posed};
pub use steps::Steps;
pub use talk::Talk;
pub use view::{RayChoice, View};
