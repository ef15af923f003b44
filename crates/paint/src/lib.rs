//! Figures of solid scenes as pixels on the GPU.
