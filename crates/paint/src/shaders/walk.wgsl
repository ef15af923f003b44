// Walks rays through a tree of two children, on top of `meet.wgsl`. Nothing in either relies on infinities or on what is
// no number.

// The layout of `Record`.
struct Shot {
    // One over each component of the direction.
    r: vec3f,
    t_min: f32,
    // What is added to b·r where the ray enters a slab, and where it leaves it.
    enter: vec3f,
    t_max: f32,
    leave: vec3f,
    // Bits 0 to 2: whether the ray runs down each axis. From ALONG on its largest axis. ASIDE: it is not walked here.
    flags: u32,
    // The origin, the largest axis last.
    o: vec3f,
    // One over the direction's largest component.
    r_z: f32,
    shear: vec2f,
    rest: vec2f,
}

const ALONG = 8u;
const ASIDE = 32u;

// The layout of `Node`: both children.
struct Node {
    low_0: vec3f,
    child_0: u32,
    high_0: vec3f,
    child_1: u32,
    low_1: vec3f,
    rest_0: u32,
    high_1: vec3f,
    rest_1: u32,
}

// A child is the number of a node; or, with this bit, the first of a leaf's triangles and below that how many there are.
const LEAF = 0x80000000u;
const COUNT_BITS = 3u;

// The layout of `Found`.
struct Found {
    prims: array<u32, 4>,
    state: u32,
    // Nodes opened, leaves among them.
    nodes: u32,
    leaves: u32,
    tests: u32,
}

// The triangles that are left hold the answer; a hit is sure; more are left than there is room for; not walked to the end.
const LEFT = 0u;
const SURE = 1u;
const MANY = 2u;
const AGAIN = 3u;

struct Ask {
    rays: u32,
    // Whether any hit will do.
    any: u32,
}

@group(0) @binding(0) var<uniform> ask: Ask;
@group(0) @binding(1) var<storage, read> shots: array<Shot>;
@group(0) @binding(2) var<storage, read> tree: array<Node>;
@group(0) @binding(3) var<storage, read> triangles: array<Triangle>;
@group(0) @binding(4) var<storage, read_write> found: array<Found>;

const HIGH = 64u;
const ROOM = 4u;
const NONE = 0xffffffffu;

// What the slabs of a box leave of the ray.
fn slabs(low: vec3f, high: vec3f, shot: Shot, down: vec3<bool>) -> vec2f {
    let near = select(low, high, down) * shot.r + shot.enter;
    let far = select(high, low, down) * shot.r + shot.leave;
    return vec2f(max(max(near.x, near.y), near.z), min(min(far.x, far.y), far.z));
}

// Drops the triangles that lie behind the end; how many are kept, in front.
fn keep(prims: ptr<function, array<u32, 4>>, nears: ptr<function, array<f32, 4>>, left: u32, end: f32) -> u32 {
    var kept = 0u;
    for (var k = 0u; k < left; k += 1u) {
        if (*nears)[k] <= end {
            (*prims)[kept] = (*prims)[k];
            (*nears)[kept] = (*nears)[k];
            kept += 1u;
        }
    }
    return kept;
}

@compute @workgroup_size(64)
fn walk(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= ask.rays {
        return;
    }
    let shot = shots[id.x];
    let down = (vec3u(shot.flags) & vec3u(1u, 2u, 4u)) != vec3u(0u);
    let along = (shot.flags / ALONG) & 3u;
    var state = LEFT;
    var nodes = 0u;
    var leaves = 0u;
    var tests = 0u;
    // Nothing that lies further counts any more.
    var end = shot.t_max;
    // The triangles that may be the answer, and from which t on each is met.
    var prims: array<u32, 4>;
    var nears: array<f32, 4>;
    var left = 0u;
    // From which t on triangles are met that found no room.
    var lost = 0.0;
    var has_lost = false;
    // What waits: a child, and where the ray enters its box.
    var children: array<u32, 64>;
    var enters: array<f32, 64>;
    var high = 0u;
    var here = 0u;
    var near = shot.t_min;
    if shot.flags >= ASIDE {
        state = AGAIN;
    }
    while state == LEFT {
        nodes += 1u;
        if (here & LEAF) == 0u {
            let node = tree[here];
            let first = slabs(node.low_0, node.high_0, shot, down);
            let second = slabs(node.low_1, node.high_1, shot, down);
            let near_0 = max(first.x, shot.t_min);
            let near_1 = max(second.x, shot.t_min);
            let meets_0 = near_0 <= min(first.y, end);
            let meets_1 = near_1 <= min(second.y, end);
            if meets_0 && meets_1 {
                if high == HIGH {
                    state = AGAIN;
                    break;
                }
                // The nearer child first, by the middles of the ways through both: boxes often begin at the same plane.
                let turn = near_1 + min(second.y, end) < near_0 + min(first.y, end);
                children[high] = select(node.child_1, node.child_0, turn);
                enters[high] = select(near_1, near_0, turn);
                high += 1u;
                here = select(node.child_0, node.child_1, turn);
                near = select(near_0, near_1, turn);
                continue;
            }
            if meets_0 || meets_1 {
                here = select(node.child_1, node.child_0, meets_0);
                near = select(near_1, near_0, meets_0);
                continue;
            }
        } else {
            let bits = here & ~LEAF;
            let count = bits & ((1u << COUNT_BITS) - 1u);
            leaves += 1u;
            tests += count;
            for (var i = 0u; i < count; i += 1u) {
                let triangle = triangles[(bits >> COUNT_BITS) + i];
                let met = meet(triangle, shot, along);
                if !met.left {
                    continue;
                }
                var from_t = near;
                if met.bounded {
                    from_t = max(near, met.low);
                    if met.high < shot.t_min {
                        continue;
                    }
                }
                if from_t > end {
                    continue;
                }
                if met.sure {
                    end = min(end, met.high);
                    if ask.any != 0u {
                        state = SURE;
                        break;
                    }
                }
                if left == ROOM {
                    left = keep(&prims, &nears, left, end);
                }
                if left < ROOM {
                    prims[left] = triangle.prim;
                    nears[left] = from_t;
                    left += 1u;
                } else {
                    lost = select(from_t, min(lost, from_t), has_lost);
                    has_lost = true;
                }
            }
        }
        // The next that may hold something nearer.
        var waits = false;
        while high > 0u && !waits {
            high -= 1u;
            waits = enters[high] <= end;
        }
        if !waits {
            break;
        }
        here = children[high];
        near = enters[high];
    }
    if state == LEFT && has_lost && lost <= end {
        state = MANY;
    }
    left = select(0u, keep(&prims, &nears, left, end), state == LEFT);
    for (var k = 0u; k < ROOM; k += 1u) {
        found[id.x].prims[k] = select(NONE, prims[k], k < left);
    }
    found[id.x].state = state;
    found[id.x].nodes = nodes;
    found[id.x].leaves = leaves;
    found[id.x].tests = tests;
}
