//! The window without a screen, as somebody uses it. One program, so that it is linked once.

mod boards;
mod files;
mod hand;
mod heat;
mod keyboard;
mod last;
mod layout;
mod lecture;
mod links;
mod looks;
mod mistakes;
mod pictures;
mod present;
mod saves;
mod typed;
mod walls;
mod window;
mod words;
