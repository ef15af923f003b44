//! How long it takes to build each structure over the teapot, observed by `()`: a parameter moved in the
//! window is to answer within 50 ms.

use criterion::{Criterion, criterion_group, criterion_main};
use raystep_accel::{Rule, Structure};
use raystep_scene::Scene;

fn builds(criterion: &mut Criterion) {
    let scene = Scene::named("teapot-6321").expect("the teapot is shipped");
    let mut group = criterion.benchmark_group("build teapot-6321");
    for (kind, key, values) in [
        ("grid", "resolution", &["3n", "longest", "density"][..]),
        ("kd", "split", &["middle", "median", "sah"]),
        ("bvh", "split", &["middle", "median", "binned", "sweep"]),
    ] {
        for value in values {
            let mut rule = Rule::default_for(kind).expect("a kind of structure");
            rule.set(key, value).expect("a value of this parameter");
            group.bench_function(format!("{kind} {value}"), |bencher| {
                bencher.iter(|| Structure::build(&scene.prims, &rule, &mut ()));
            });
        }
    }
}

criterion_group!(benches, builds);
criterion_main!(benches);
