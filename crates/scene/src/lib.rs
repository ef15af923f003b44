//! What rays meet: the teapot's patches, flat scenes, and the reader that guards OBJ files.
//!
//! Everything loads from bytes. What is wrong in a file is a [`SceneError`]: a sentence with file, line and
//! column that says what was found and what is allowed.

mod close;
mod decimal;
mod error;
mod flat;
mod hand;
mod numbers;
mod obj;
mod outdoors;
mod scene;
mod scenes;
mod shipped;
mod stadium;
mod teapot;
mod tree;
pub mod trial;
mod view;
mod woods;

pub use decimal::decimal;
pub use error::SceneError;
pub use hand::Part;
pub use obj::{Loaded, ObjError, read_obj};
pub use outdoors::MOST_TREES;
pub use scene::Scene;
pub use scenes::{SCENE_ENDINGS, Scenes};
pub use shipped::{UnknownScene, scene_names};
pub use teapot::{MOST_STEPS, teapot};
pub use tree::tree;
pub use view::View;
pub use woods::{Kind, Land, Stuff, TRIANGLES_OF_A_TREE, Woods};
