//! The `raystep` binary: the window and the command line.
fn main() {}
