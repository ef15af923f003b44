// Lines of constant width on the page, dashed or not, and arrow heads, which taper.

override FADE: f32 = 1.0;

struct Instance {
    @location(0) start: vec3<f32>,
    @location(1) stop: vec3<f32>,
    @location(2) width: vec2<f32>,
    @location(3) dash: vec2<f32>,
    // How much of the end to keep (all where 0), and how much of it to cut off.
    @location(4) end: vec2<f32>,
    @location(5) color: vec4<f32>,
}

struct Stroke {
    @builtin(position) clip: vec4<f32>,
    // In pixels along and across the line.
    @location(0) @interpolate(linear) at: vec2<f32>,
    @location(1) @interpolate(flat) length: f32,
    @location(2) @interpolate(flat) width: vec2<f32>,
    @location(3) @interpolate(flat) dash: vec2<f32>,
    @location(4) @interpolate(flat) color: vec4<f32>,
}

@vertex
fn vertex(in: Instance, @builtin(vertex_index) index: u32) -> Stroke {
    var out: Stroke;
    out.width = in.width;
    out.dash = in.dash;
    out.color = in.color;

    // Both ends in front of the eye.
    var a = view.clip_from_world * vec4(in.start, 1.0);
    var b = view.clip_from_world * vec4(in.stop, 1.0);
    if max(a.w, b.w) <= view.near {
        out.clip = vec4(2.0, 2.0, 0.0, 1.0);
        return out;
    }
    if a.w < view.near {
        a = mix(a, b, (view.near - a.w) / (b.w - a.w));
    } else if b.w < view.near {
        b = mix(b, a, (view.near - b.w) / (a.w - b.w));
    }

    // On the page, in pixels.
    var from_page = a.xy / a.w * 0.5 * view.size;
    var to_page = b.xy / b.w * 0.5 * view.size;
    var depth = vec2(a.z / a.w, b.z / b.w);
    let whole = distance(from_page, to_page);
    let along = select(vec2(1.0, 0.0), (to_page - from_page) / whole, whole > 1e-4);
    if in.end.x > 0.0 {
        depth.x = mix(depth.y, depth.x, min(in.end.x / max(whole, 1e-4), 1.0));
        from_page = to_page - along * in.end.x;
    }
    let cut = min(in.end.y, whole);
    depth.y = mix(depth.y, depth.x, cut / max(whole, 1e-4));
    to_page -= along * cut;
    out.length = distance(from_page, to_page);

    // A quad with room for round ends.
    let right = index == 1u || index == 2u || index == 4u;
    let upper = index == 2u || index == 4u || index == 5u;
    let half = max(in.width.x, in.width.y) * 0.5 + 1.0;
    out.at = vec2(select(-half, out.length + half, right), select(-half, half, upper));
    let page = from_page + along * out.at.x + vec2(-along.y, along.x) * out.at.y;
    let z = mix(depth.x, depth.y, clamp(out.at.x / max(out.length, 1e-4), 0.0, 1.0));
    out.clip = vec4(page * 2.0 / view.size, z * LINE_NEARER, 1.0);
    return out;
}

@fragment
fn fragment(in: Stroke) -> @location(0) vec4<f32> {
    let beyond = max(-in.at.x, in.at.x - in.length);
    var outside: f32;
    if in.width.x == in.width.y {
        // Distance from a line with round ends.
        outside = length(vec2(max(beyond, 0.0), in.at.y)) - in.width.x * 0.5;
    } else {
        let half = mix(in.width.x, in.width.y, in.at.x / max(in.length, 1e-4)) * 0.5;
        outside = max(abs(in.at.y) - half, beyond);
    }
    if in.dash.y > 0.0 {
        let period = in.dash.x + in.dash.y;
        let place = in.at.x - period * floor(in.at.x / period);
        outside = max(outside, abs(place - in.dash.x * 0.5) - in.dash.x * 0.5);
    }
    let cover = clamp(0.5 - outside, 0.0, 1.0);
    return vec4(in.color.rgb, in.color.a * cover * FADE);
}
