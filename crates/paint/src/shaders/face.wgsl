// Translucent faces of boxes, and primitives to which something happened; some are hatched.

override FADE: f32 = 1.0;

struct Face {
    @builtin(position) clip: vec4<f32>,
    @location(0) fill: vec4<f32>,
    @location(1) hatch: vec4<f32>,
}

@vertex
fn vertex(@location(0) position: vec3<f32>, @location(1) fill: vec4<f32>, @location(2) hatch: vec4<f32>) -> Face {
    var out: Face;
    out.clip = view.clip_from_world * vec4(position, 1.0);
    out.clip.z *= FACE_NEARER;
    out.fill = fill;
    out.hatch = hatch;
    return out;
}

@fragment
fn fragment(in: Face) -> @location(0) vec4<f32> {
    // Thin diagonal lines, at the same distance on the page wherever the face is.
    let step = 7.0 * view.pixels_per_point;
    let along = (in.clip.x + in.clip.y) / step;
    let off = abs(fract(along) - 0.5) * step;
    let line = clamp(0.6 * view.pixels_per_point - off + 0.5, 0.0, 1.0) * in.hatch.a;
    let alpha = line + in.fill.a * (1.0 - line);
    let color = (in.hatch.rgb * line + in.fill.rgb * in.fill.a * (1.0 - line)) / max(alpha, 1e-6);
    return vec4(color, alpha * FADE);
}
