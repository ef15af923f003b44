//! How long one step of the window takes to draw up on the teapot: the moment, and the figures of every
//! pane. A frame has 16 ms; this part of it is to stay below 4 ms.

use criterion::{Criterion, criterion_group, criterion_main};
use glam::{Vec2, Vec3};
use raystep_accel::{Accel, KdLayout, Ray, Rule, Structure, Visit};
use raystep_figure::{Ask, Camera, Film, Look, Nodes, Pane, Reel, Scenery, Walk};
use raystep_scene::Scene;

fn steps(criterion: &mut Criterion) {
    let scene = Scene::named("teapot-6321").expect("the teapot is shipped");
    let ray = Ray::new(Vec3::new(-4.0, 2.0, 0.4), Vec3::new(5.1, -2.1, 1.5).normalize()).expect("a ray");
    let mut group = criterion.benchmark_group("one step on teapot-6321");
    for (name, kind, setting) in [
        ("grid", "grid", None),
        ("kd", "kd", None),
        ("bvh", "bvh", None),
        ("bvh of hulls", "bvh", Some(("volume", "hull"))),
        ("bsp", "bsp", None),
    ] {
        let mut rule = Rule::default_for(kind).expect("a kind of structure");
        if let Some((key, value)) = setting {
            rule.set(key, value).expect("a parameter");
        }
        let structure = Structure::build(&scene.prims, &rule, &mut ()).expect("nobody cancels");
        let mut events: Vec<Visit> = Vec::new();
        structure.intersect(&scene.prims, &ray, &mut events);
        let nodes = Nodes::of(&structure);
        let walk = Walk {
            structure: &structure,
            prims: &scene.prims,
            nodes: &nodes,
            ray,
            events: &events,
            lost: 0,
            flat: false,
            layout: KdLayout::Compact,
        };
        let reel = Reel::new(walk);
        let film = Film::new(&reel);
        let camera = Camera::frame(&walk.world(), 1.4, false);
        let look = Look::WINDOW;
        let mut step = 0;
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                step = (step + 7) % (events.len() + 1);
                let instant = film.at(&reel, step);
                let still = reel.still(&instant);
                let space = still.space().expect("a walk is in space");
                [
                    raystep_figure::stage(&space, &scene.prims, &camera, Vec2::new(700.0, 500.0), Scenery::Left),
                    still.draw(Pane::Tree, &Ask::new(Vec2::new(700.0, 160.0), look)),
                    still.draw(Pane::Ruler, &Ask::new(Vec2::new(700.0, 110.0), look)),
                    still.draw(Pane::Bin, &Ask::new(Vec2::new(380.0, 160.0), look)),
                    still.draw(Pane::Work, &Ask::new(Vec2::new(380.0, 120.0), look)),
                    still.draw(Pane::Timeline, &Ask::new(Vec2::new(800.0, 60.0), look)),
                ]
            });
        });
    }
}

criterion_group!(benches, steps);
criterion_main!(benches);
