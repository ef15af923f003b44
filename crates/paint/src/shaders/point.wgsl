// Rings around points, of constant size on the page.

override FADE: f32 = 1.0;

struct Ring {
    @builtin(position) clip: vec4<f32>,
    @location(0) at: vec2<f32>,
    @location(1) @interpolate(flat) size: vec2<f32>,
    @location(2) @interpolate(flat) ring: vec4<f32>,
    @location(3) @interpolate(flat) fill: vec4<f32>,
}

@vertex
fn vertex(
    @location(0) center: vec3<f32>,
    @location(1) size: vec2<f32>,
    @location(2) ring: vec4<f32>,
    @location(3) fill: vec4<f32>,
    @builtin(vertex_index) index: u32,
) -> Ring {
    var out: Ring;
    let right = index == 1u || index == 2u || index == 4u;
    let upper = index == 2u || index == 4u || index == 5u;
    let reach = size.x + 1.0;
    out.at = vec2(select(-reach, reach, right), select(-reach, reach, upper));
    out.size = size;
    out.ring = ring;
    out.fill = fill;
    out.clip = view.clip_from_world * vec4(center, 1.0);
    // Behind the eye w is negative and the point is clipped away.
    out.clip.z *= POINT_NEARER;
    out.clip += vec4(out.at * 2.0 / view.size * out.clip.w, 0.0, 0.0);
    return out;
}

@fragment
fn fragment(in: Ring) -> @location(0) vec4<f32> {
    let r = length(in.at);
    let cover = clamp(in.size.x - r + 0.5, 0.0, 1.0);
    let inner = clamp(in.size.x - in.size.y - r + 0.5, 0.0, 1.0) * in.fill.a;
    let color = mix(in.ring, vec4(in.fill.rgb, 1.0), inner);
    return vec4(color.rgb, max(color.a, inner) * cover * FADE);
}
