// The scene's surface: two-sided, in a calm light from over the left shoulder.

struct Shaded {
    @builtin(position) clip: vec4<f32>,
    @location(0) world: vec3<f32>,
    @location(1) normal: vec3<f32>,
}

@vertex
fn vertex(@location(0) position: vec3<f32>, @location(1) normal: vec3<f32>) -> Shaded {
    var out: Shaded;
    out.clip = view.clip_from_world * vec4(position, 1.0);
    out.world = position;
    out.normal = normal;
    return out;
}

@fragment
fn fragment(in: Shaded) -> @location(0) vec4<f32> {
    let to_eye = normalize(view.eye.xyz - in.world * view.eye.w);

    // The triangle's own normal, turned to the eye.
    var flat_normal = normalize(cross(dpdx(in.world), dpdy(in.world)));
    flat_normal = select(-flat_normal, flat_normal, dot(flat_normal, to_eye) >= 0.0);

    // Smooth where the neighbours bend gently, flat at creases.
    var smooth_normal = in.normal / max(length(in.normal), 1e-6);
    smooth_normal = select(-smooth_normal, smooth_normal, dot(smooth_normal, flat_normal) >= 0.0);
    let gentle = smoothstep(0.72, 0.9, dot(smooth_normal, flat_normal));
    let normal = normalize(mix(flat_normal, smooth_normal, gentle));

    let lambert = max(dot(normal, view.light.xyz), 0.0);
    let facing = max(dot(normal, to_eye), 0.0);
    // In gamma space, so that the steps look even.
    let shade = 0.6 + 0.42 * lambert + 0.08 * facing;
    return vec4(view.scene.rgb * min(shade, 1.08), 1.0);
}
