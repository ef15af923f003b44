// A ray and a triangle: whether it may be met, whether it surely is, and between which t. Why that is certain stands in
// `compute/margins.rs`.

// The layout of `Corners`.
struct Triangle {
    a: vec3f,
    prim: u32,
    b: vec3f,
    // The longest side of its box.
    size: f32,
    c: vec3f,
    rest: u32,
}

// The margins, from there.
override AREA: f32;
override FAR_AREA: f32;
override LEAST_AREA: f32;
override DEPTH: f32;

struct Met {
    // Whether it may be hit, and whether it surely is.
    left: bool,
    sure: bool,
    // Between these the hit lies, if `bounded`.
    bounded: bool,
    low: f32,
    high: f32,
}

// The components along the axes, the largest of the direction last.
fn turned(p: vec3f, along: u32) -> vec3f {
    return select(select(p, p.zxy, along == 1u), p.yzx, along == 0u);
}

fn sheared(p: vec3f, shot: Shot) -> vec3f {
    let q = p - shot.o;
    return vec3f(q.xy - shot.shear * q.z, q.z);
}

fn meet(triangle: Triangle, shot: Shot, along: u32) -> Met {
    let a = sheared(turned(triangle.a, along), shot);
    let b = sheared(turned(triangle.b, along), shot);
    let c = sheared(turned(triangle.c, along), shot);
    // Twice the areas that the ray makes with each edge, and how large one has to be to have a sign.
    let u = c.x * b.y - c.y * b.x;
    let v = a.x * c.y - a.y * c.x;
    let w = b.x * a.y - b.y * a.x;
    let size = triangle.size;
    let away = abs(a.z) + 2.0 * size;
    let margin = away * (AREA * size + FAR_AREA * away) + LEAST_AREA;
    let least = min(min(u, v), w);
    let most = max(max(u, v), w);
    var met = Met(!(least < -margin && margin < most), false, false, 0.0, 0.0);
    let area = u + v + w;
    if !met.left || abs(area) < 8.0 * margin {
        return met;
    }
    // Between which t it is met.
    let over = 1.0 / area;
    let depth = a.z + ((v * over) * (b.z - a.z) + (w * over) * (c.z - a.z));
    let slack = (12.0 * size * (margin * abs(over)) + DEPTH * away) * abs(shot.r_z);
    let t = depth * shot.r_z;
    met.bounded = true;
    met.low = t - slack;
    met.high = t + slack;
    // Surely hit where all areas surely have one sign, and t surely counts.
    let wide = max(max(max(abs(a.x), abs(b.x)), abs(c.x)), max(max(abs(a.y), abs(b.y)), abs(c.y)));
    let inside = least > 2.0 * margin || most < -2.0 * margin;
    met.sure = inside && wide <= 2.0 * size + DEPTH * away && abs(t) >= 2.0 * slack && met.low >= shot.t_min && met.high <= shot.t_max;
    return met;
}
