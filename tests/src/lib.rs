//! What holds across crates: agreement, laws, slides, layers, pixels.
