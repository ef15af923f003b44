// What every shader knows: the view, and how far towards the eye marks are moved.

struct View {
    clip_from_world: mat4x4<f32>,
    eye: vec4<f32>,
    light: vec4<f32>,
    scene: vec4<f32>,
    size: vec2<f32>,
    pixels_per_point: f32,
    near: f32,
}

@group(0) @binding(0) var<uniform> view: View;

// Marks lie on surfaces. In reverse z a depth times 1 + x is nearer by the part x of its distance.
const FACE_NEARER: f32 = 1.0005;
const LINE_NEARER: f32 = 1.0015;
const POINT_NEARER: f32 = 1.01;
