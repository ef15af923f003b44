//! What is said and asked before a class: its words, how large they are, and on how many pages they stand.

mod answer;
mod fitted;
mod pages;
mod speech;

pub(super) use fitted::{Column, Fitted, Room};
pub(crate) use pages::Pages;
pub(super) use speech::Speech;
