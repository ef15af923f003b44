//! What every flat picture of every shipped slide must show, at every step of every ray: nothing covers what decides.

use std::collections::BTreeSet;

use glam::Vec2;
use raystep_accel::{KdLayout, Place, PrimId, Primitives, Prims, Shape, Structure, Visit};
use raystep_figure::{
    Camera, Figure, Form, Ink, Look, Mark, Moment, Nodes, Role, Scenery, Space, Walk, ruler, ruler_height, space,
    stage, text_width,
};
use raystep_lesson::{Library, Plays, StageKind, Tape};

/// The size of the picture on a plate, and in the window of a small laptop.
const SIZES: [Vec2; 2] = [Vec2::new(667.0, 560.0), Vec2::new(560.0, 360.0)];

/// Calls `check` at every step of the flat walks of every slide with each of its rays; `said` names the place.
fn every_flat_step(check: &mut dyn FnMut(&str, &Walk<'_>, &Moment)) {
    let library = Library::embedded();
    let mut steps = 0;
    for slide in library.slides.iter().filter(|slide| slide.plays == Plays::Walk) {
        for on in slide.stages.iter().filter(|stage| stage.kind == StageKind::Flat) {
            let built = on.build(slide.plays).expect("a shipped stage");
            let nodes = Nodes::of(&built.structure);
            for ray in &on.rays {
                let play = built.play(Some(ray.ray), &slide.beats).expect("a walk");
                let Tape::Walk(tape) = &play.tape else { panic!("{} plays no walk", slide.id()) };
                let walk = Walk {
                    structure: &play.structure,
                    prims: &play.scene.prims,
                    nodes: &nodes,
                    ray: tape.ray,
                    events: &tape.events,
                    lost: tape.lost,
                    flat: true,
                    layout: KdLayout::Compact,
                };
                let mut moment = Moment::start(&walk);
                for step in 0..=tape.events.len() {
                    moment.advance(&walk, step);
                    steps += 1;
                    check(&format!("{}, ray “{}”, step {step}", slide.id(), ray.name), &walk, &moment);
                }
            }
        }
    }
    assert!(steps > 800, "{steps} steps");
}

fn drawn(space: &Space, prims: &Prims, size: Vec2) -> (Camera, Figure) {
    let camera = Camera::frame(&space.bounds, size.x / size.y, true);
    (camera, stage(space, prims, &camera, size, Scenery::Drawn))
}

/// The box of a label; nothing for other marks.
fn label_box(mark: &Mark) -> Option<(Vec2, Vec2, &str)> {
    let Ink::Text { at, text, size, face, boxed: true, .. } = &mark.ink else { return None };
    let half = Vec2::new(text_width(text, *face, *size) * 0.5 + size * 0.5, size * 0.8);
    Some((*at - half, *at + half, text))
}

/// Points of the outline of a primitive, and of its inside, as a camera sees them.
fn points_of(prims: &Prims, prim: PrimId, camera: &Camera, size: Vec2) -> Vec<Vec2> {
    let along = |a: glam::Vec3, b: glam::Vec3| (0..24).map(move |i| a.lerp(b, i as f32 / 24.0));
    let around = |corners: &[glam::Vec3]| -> Vec<glam::Vec3> {
        let next = corners.iter().cycle().skip(1);
        corners.iter().zip(next).flat_map(|(a, b)| along(*a, *b)).collect()
    };
    let points = match prims.shape(prim) {
        Shape::Sphere(sphere) => {
            let turn = |i: i32| Vec2::from_angle(i as f32 / 48.0 * std::f32::consts::TAU).extend(0.0) * sphere.radius;
            (0..48).map(|i| sphere.center + turn(i)).chain([sphere.center]).collect()
        }
        Shape::Wall(wall) => along(wall.from.extend(0.0), wall.to.extend(0.0)).collect(),
        Shape::Triangle(triangle) => around(&[triangle.a, triangle.b, triangle.c]),
        Shape::Prism(prism) => around(&prism.outline.iter().map(|corner| corner.extend(0.0)).collect::<Vec<_>>()),
        shape => vec![shape.bounds().center()],
    };
    points.into_iter().filter_map(|at| Some(camera.project(at.with_z(0.0), size)?.0)).collect()
}

#[test]
fn no_label_covers_what_is_hit_later() {
    let mut found = Vec::new();
    every_flat_step(&mut |said, walk, moment| {
        let later = walk.events[moment.step..].iter();
        let coming: BTreeSet<PrimId> = later
            .filter_map(|event| if let Visit::Test { prim, hit: true, .. } = event { Some(*prim) } else { None })
            .collect();
        for size in SIZES {
            let (camera, figure) = drawn(&space(walk, moment), walk.prims, size);
            for (min, max, text) in figure.marks.iter().filter_map(label_box) {
                for prim in &coming {
                    let under = |at: &Vec2| at.cmpgt(min + 0.5).all() && at.cmplt(max - 0.5).all();
                    let points = points_of(walk.prims, *prim, &camera, size);
                    // In a crowd of primitives that are smaller than a letter no label finds room.
                    let (low, high) = points
                        .iter()
                        .fold((Vec2::INFINITY, Vec2::NEG_INFINITY), |(low, high), at| (low.min(*at), high.max(*at)));
                    if (high - low).max_element() > max.y - min.y && points.iter().any(under) {
                        found.push(format!("{said}, {size}: “{text}” covers primitive {prim}"));
                    }
                }
            }
        }
    });
    assert!(found.is_empty(), "{} times\n{}", found.len(), found.join("\n"));
}

#[test]
fn the_planes_of_a_box_carry_their_numbers_and_the_line_its_ts() {
    every_flat_step(&mut |said, walk, moment| {
        let (Structure::Slab(_), Some(slab)) = (walk.structure, moment.slab.as_ref()) else { return };
        let space = space(walk, moment);
        let (camera, figure) = drawn(&space, walk.prims, SIZES[0]);
        let texts: Vec<&str> = figure.marks.iter().filter_map(label_box).map(|(.., text)| text).collect();
        let says = |text: &str| texts.iter().any(|label| label.starts_with(text));
        // Every plane that was cut, to the end: its line, with its number at it.
        for cut in slab.cuts.iter().filter(|cut| !cut.axis.leaves_plane()) {
            for at in [cut.low, cut.high] {
                let plane = format!("{} = {}", cut.axis, raystep_figure::number(at));
                assert!(says(&plane), "{said}: no label {plane:?} among {texts:?}");
                let axis = cut.axis.axis().expect("a box has no others");
                let drawn =
                    |form: &Form| matches!(form, Form::Sheet(sheet) if sheet.min[axis] == at && sheet.max[axis] == at);
                assert!(space.marks.iter().any(|mark| drawn(&mark.form)), "{said}: {plane} is not drawn");
            }
        }
        // The t at hand stand on the line that the ray lies on, which is drawn there.
        let ts: Vec<(&str, f32)> = match moment.event {
            Some(Visit::Volume { t_near, t_far, .. }) => vec![("t_near", t_near), ("t_far", t_far)],
            _ => {
                let cut = slab.cuts.iter().find(|cut| cut.axis == slab.axis && !cut.axis.leaves_plane());
                cut.and_then(|cut| cut.t).map_or(Vec::new(), |[t1, t2]| vec![("t1", t1), ("t2", t2)])
            }
        };
        for (name, t) in ts.into_iter().filter(|(_, t)| t.is_finite()) {
            let text = format!("{name} = {}", raystep_figure::number(t));
            assert!(says(&text), "{said}: no label {text:?} among {texts:?}");
            let at = walk.ray.at(t);
            let Some((page, _)) = camera.project(at, SIZES[0]) else { continue };
            let role = if t < 0.0 { Role::Line } else { Role::Ray };
            let on_it = |mark: &Mark| match &mark.ink {
                Ink::Line { points } if mark.role == role => off(page, points[0], points[points.len() - 1]) < 1.0,
                _ => false,
            };
            let seen = page.cmpge(Vec2::ZERO).all() && page.cmple(SIZES[0]).all();
            assert!(!seen || figure.marks.iter().any(on_it), "{said}: {text} floats");
        }
        // The ruler shows each of them with its number.
        let look = Look::WINDOW;
        let height = ruler_height(walk, &look);
        let ruler = ruler(walk, moment, false, Vec2::new(790.0, height), &look);
        let known = slab.cuts.iter().filter(|cut| !cut.axis.leaves_plane()).filter_map(|cut| cut.t);
        let told =
            |says: &str| ruler.marks.iter().any(|mark| matches!(&mark.ink, Ink::Text { text, .. } if text == says));
        for t in known.flatten() {
            let number = raystep_figure::number(t);
            assert!(told(&number), "{said}: {number} is not on the ruler");
        }
    });
}

/// How far a point lies off a line between two others.
fn off(at: Vec2, from: Vec2, to: Vec2) -> f32 {
    let along = to - from;
    let part = ((at - from).dot(along) / along.length_squared().max(1e-9)).clamp(0.0, 1.0);
    at.distance(from + along * part)
}

#[test]
fn places_and_primitives_carry_their_numbers() {
    let (mut numbered, mut all) = (0, 0);
    every_flat_step(&mut |said, walk, moment| {
        let space = space(walk, moment);
        let (camera, figure) = drawn(&space, walk.prims, SIZES[0]);
        let named = |place: Place, text: &str| {
            let names = |mark: &&Mark| {
                mark.place == Some(place)
                    && matches!(&mark.ink, Ink::Text { text: own, .. } if own.split([' ', ':']).any(|word| word == text))
            };
            figure.marks.iter().find(names)
        };
        if matches!(walk.structure, Structure::Slab(_)) {
            return;
        }
        for prim in (0..walk.prims.len() as u32).map(PrimId) {
            let Shape::Sphere(disc) = walk.prims.shape(prim) else { continue };
            let (center, _) = camera.project(disc.center, SIZES[0]).expect("a flat camera sees it");
            let radius = camera
                .project(disc.center + glam::Vec3::X * disc.radius, SIZES[0])
                .map_or(0.0, |(at, _)| at.x - center.x);
            if radius < 16.0 {
                continue;
            }
            all += 1;
            numbered += usize::from(named(Place::Prim(prim), &prim.to_string()).is_some());
        }
        if let (Some(here @ Place::Cell(cell)), true) = (moment.here, moment.guesses.is_empty()) {
            assert!(named(here, &cell.to_string()).is_some(), "{said}: the cell has no number");
        }
    });
    // The ray may run through one so that there is no room left.
    assert!(numbered * 100 >= all * 97, "{numbered} of {all} discs carry their numbers");
}
