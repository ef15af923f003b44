//! What structures are tried on: scenes and rays that leave an algorithm nothing to stand on, and the
//! structures that must agree about them. The tests and `raystep verify` share them.

pub mod rays;
pub mod rules;
pub mod scenes;
