//! What the GPU is given of faces, lines and points.

use bytemuck::{Pod, Zeroable};

/// A corner of a translucent triangle; the layout in `face.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Pod, Zeroable)]
pub(crate) struct FaceCorner {
    pub(crate) position: [f32; 3],
    pub(crate) fill: [u8; 4],
    /// The colour of the hatching; nothing where transparent.
    pub(crate) hatch: [u8; 4],
}

/// A line or an arrow head, widths and lengths in pixels; the layout in `line.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Pod, Zeroable)]
pub(crate) struct Line {
    pub(crate) from: [f32; 3],
    pub(crate) to: [f32; 3],
    /// At its beginning and at its end; a head tapers.
    pub(crate) width: [f32; 2],
    /// Lengths of line and gap; no gap, no dashes.
    pub(crate) dash: [f32; 2],
    /// How much of its end to keep (all where 0), and how much of it to cut off.
    pub(crate) end: [f32; 2],
    pub(crate) color: [u8; 4],
}

/// A ring around a point, in pixels; the layout in `point.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Pod, Zeroable)]
pub(crate) struct Point {
    pub(crate) center: [f32; 3],
    /// Radius, and width of the ring.
    pub(crate) size: [f32; 2],
    pub(crate) ring: [u8; 4],
    pub(crate) fill: [u8; 4],
}
