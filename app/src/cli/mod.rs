//! The command line: what Raystep does without a window.
