//! What a step looks like, as plain data.
