//! Links: whatever a window shows is found again by its link.

use proptest::prelude::*;
use raystep_accel::{Axis, Grain, NodeId, PrimId, Primitives, Ray, Rule};
use raystep_figure::{Camera, Depth};
use raystep_lesson::{Library, StageKind};
use raystep_scene::Scene;

use super::*;

fn number() -> impl Strategy<Value = f32> {
    prop_oneof![-1e3_f32..1e3, Just(0.0), Just(-0.0), Just(1e-30), Just(-7.5e20)]
}

fn point() -> impl Strategy<Value = Vec3> {
    [number(), number(), number()].prop_map(Vec3::from_array)
}

fn own() -> impl Strategy<Value = Ray> {
    let range = prop_oneof![Just([0.0, f32::INFINITY]), [0.0_f32..1.0, 1.0_f32..50.0]];
    let direction = (0.1_f32..3.0, number(), -2.0_f32..2.0).prop_map(Vec3::from);
    (point(), direction, range)
        .prop_filter_map("no ray", |(o, d, [near, far])| Ray::new(o, d).and_then(|ray| ray.within(near, far)).ok())
}

fn flat() -> impl Strategy<Value = Camera> {
    (number(), number(), 1e-3_f32..1e4)
        .prop_map(|(x, y, half_height)| Camera::Flat { center: Vec2::new(x, y), half_height })
}

fn solid() -> impl Strategy<Value = Camera> {
    let camera = (point(), point(), 1.0_f32..170.0);
    camera.prop_map(|(eye, target, fov_degrees)| Camera::Solid { eye, target, up: Vec3::Z, fov_degrees })
}

/// Shapes that were moved, each once.
fn shapes() -> impl Strategy<Value = Vec<(u32, Vec<f32>)>> {
    let numbers = proptest::collection::vec(number(), 3..9);
    proptest::collection::btree_map(0..600_u32, numbers, 0..4).prop_map(|shapes| shapes.into_iter().collect())
}

fn cut() -> impl Strategy<Value = HandCut> {
    (0..99_u32, proptest::sample::select(Axis::ALL.to_vec()), number()).prop_map(|(node, axis, at)| HandCut {
        node: NodeId(node),
        axis,
        at,
    })
}

fn part() -> impl Strategy<Value = Interval> {
    (number(), 1e-3_f32..1e3)
        .prop_map(|(near, long)| Interval::new(near, near + long))
        .prop_filter("too short", |part| part.near < part.far)
}

fn mistake() -> impl Strategy<Value = Mistake> {
    proptest::sample::select(Mistake::ALL.to_vec())
}

/// A link with anything in it that a link can hold.
fn any_link() -> impl Strategy<Value = Link> {
    let text = "[ -~äπ→]{1,12}";
    let kinds = proptest::sample::subsequence(Rule::KINDS.to_vec(), 1..=Rivals::MOST);
    let place = (
        text,
        proptest::option::of(proptest::sample::select(StageKind::ALL.to_vec())),
        proptest::option::of(text),
        proptest::option::of(own()),
        proptest::option::of(0..MOST_STEPS),
        proptest::sample::subsequence(SETTINGS.to_vec(), 0..=SETTINGS.len()),
        shapes(),
        proptest::option::of(cut()),
        proptest::option::of(mistake()),
        proptest::option::of(prop_oneof![flat(), solid()].prop_filter("sees nothing", looks)),
    );
    let look = (
        prop_oneof![Just(ASPECT), 0.01_f32..100.0],
        proptest::option::of(prop_oneof![Just(Depth::Path), (1..=64_u32).prop_map(Depth::Down)]),
        proptest::option::of(part()),
        proptest::option::of(kinds.prop_map(Rivals::of)),
        (
            proptest::option::of(mistake()),
            proptest::sample::select(vec![Pace::Event, Pace::T]),
            proptest::option::of(proptest::sample::select(Column::COUNTS.to_vec())),
            proptest::option::of(proptest::sample::select(FastKind::ALONE.to_vec())),
        ),
        proptest::option::of(text),
        proptest::sample::select(vec![Grain::Arithmetic, Grain::Decision, Grain::Visit]),
        1..=9 * QUARTERS,
        any::<[bool; 2]>(),
        (any::<bool>(), proptest::collection::vec(0..26_usize, 0..=2))
            .prop_map(|(open, answers)| Asked { open, answers }),
    );
    (place, look).prop_map(|((slide, stage, ray, own, step, set, shapes, tried, example, camera), look)| {
        let (aspect, depth, part, beside, (mistake, pace, heat, fast), mesh, grain, speed, [present, by_hand], asked) =
            look;
        Link {
            slide: if slide.trim().is_empty() { "5/33".to_owned() } else { slide },
            stage,
            ray,
            own,
            step,
            set: set.into_iter().map(|(key, value)| (key.to_owned(), value.to_owned())).collect(),
            shapes,
            tried,
            example,
            camera,
            aspect,
            depth,
            part,
            beside,
            mistake,
            pace,
            heat,
            fast,
            mesh,
            grain,
            speed,
            present,
            by_hand,
            asked,
        }
    })
}

/// What can be set: parameters, a number of a meter, a body of a pair.
const SETTINGS: [(&str, &str); 5] =
    [("max_depth", "3"), ("split", "sah"), ("resolution", "3n"), ("Nx", "640"), ("ray_cone_1", "0.5 0 -1e-7")];

/// No walk has more steps than a link can name.
const MOST_STEPS: usize = 1 << 40;

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_link_is_read_as_it_was_written(link in any_link()) {
        let text = link.to_string();
        prop_assert!(text.is_ascii() && !text.contains(' '), "{text}");
        prop_assert_eq!(text.parse::<Link>(), Ok(link.clone()), "{}", text);
        prop_assert_eq!(format!(" https://a.b/page?c=d#{text}\n").parse::<Link>(), Ok(link));
    }
}

/// Every flat stage of the lecture whose shapes can be moved, with its scene.
fn movable(library: &Library) -> Vec<(usize, std::sync::Arc<Scene>)> {
    let stages = library.slides.iter().enumerate().filter_map(|(place, slide)| {
        let stage = slide.stage(StageKind::Flat)?;
        let scene = stage.scenes.named(&stage.scene).ok()?;
        (!scene.parts().is_empty() && scene.prims.len() <= crate::shown::own::MOST).then_some((place, scene))
    });
    stages.collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn what_was_moved_by_hand_lies_there_again(
        stage in any::<proptest::sample::Index>(),
        moves in proptest::collection::vec((any::<proptest::sample::Index>(), -3.0_f32..3.0, -3.0_f32..3.0), 1..6),
    ) {
        static LIBRARY: std::sync::LazyLock<Library> = std::sync::LazyLock::new(Library::embedded);
        let stages = movable(&LIBRARY);
        let (place, scene) = stage.get(&stages);
        let mut own: Option<OwnScene> = None;
        for (part, x, y) in moves {
            let now = own.as_ref().map_or(scene, |own| &own.scene).clone();
            let parts = now.parts();
            let (prim, part, at) = *part.get(&parts);
            own = OwnScene::of(&now, own.as_ref(), prim, part, [at, at + Vec2::new(x, y)]).or(own);
        }
        prop_assume!(own.is_some());
        let view = View { own, step: 2, ..View::of_slide(*place, StageKind::Flat) };
        let link = Link::of_view(&view, &LIBRARY);
        let text = link.to_string();
        let (found, wrong) = text.parse::<Link>().unwrap().view(&LIBRARY);
        prop_assert!(wrong.is_empty(), "{text}: {wrong:?}");
        let (found, own) = (found.unwrap().own.unwrap(), view.own.unwrap());
        prop_assert_eq!(&found.moved, &own.moved);
        for prim in (0..own.scene.prims.len() as u32).map(PrimId) {
            prop_assert_eq!(found.scene.prims.shape(prim), own.scene.prims.shape(prim), "{}: {}", text, prim);
        }
        prop_assert_eq!((&found.scene.name, found.scene.view), (&own.scene.name, own.scene.view));
        prop_assert!(text.len() < 60 + 90 * own.moved.len(), "{text}");
    }
}

#[test]
fn links_of_before_are_read() {
    let old = "5/33?stage=flat&ray=both%20children&step=13&set=max_depth:3&set=cut:0:x%3D2.09&camera=4,2,1.5&aspect=1.4&\
               levels=2&beside=grid,bvh&grain=visit&speed=0.5&present=yes&hand=yes";
    let link = old.parse::<Link>().unwrap();
    let kept = Link {
        slide: "5/33".to_owned(),
        stage: Some(StageKind::Flat),
        ray: Some("both children".to_owned()),
        step: Some(13),
        set: vec![("max_depth".to_owned(), "3".to_owned()), ("cut".to_owned(), "0:x=2.09".to_owned())],
        camera: Some(Camera::Flat { center: Vec2::new(4.0, 2.0), half_height: 1.5 }),
        aspect: 1.4,
        depth: Some(Depth::Down(2)),
        beside: Some(Rivals::of(["grid", "bvh"])),
        grain: Grain::Visit,
        speed: 2,
        present: true,
        by_hand: true,
        ..Link::default()
    };
    assert_eq!(link, kept);
    // What is new in them says nothing unless it is there.
    assert_eq!(link.to_string(), old.replace("%3D", "="));
}

#[test]
fn every_view_of_the_lecture_is_found_again() {
    let library = Library::embedded();
    let mut seen = 0;
    for (place, slide) in library.slides.iter().enumerate() {
        for stage in &slide.stages {
            let step = 3 * place + 1;
            let settings = match (&stage.plan.kind[..], slide.plays.has_rays()) {
                ("kd", true) => vec![("max_depth".to_owned(), "3".to_owned())],
                _ => Vec::new(),
            };
            let camera = match stage.kind {
                StageKind::Flat => Camera::Flat { center: Vec2::new(1.5, -0.25), half_height: 2.0 },
                StageKind::Solid => {
                    Camera::Solid { eye: Vec3::new(3.0, 1.0, 2.0), target: Vec3::ZERO, up: Vec3::Z, fov_degrees: 33.3 }
                }
            };
            let own = Ray::new(Vec3::new(0.1, 0.2, 0.0), Vec3::new(0.3, -0.4, 0.0)).unwrap();
            let rays = (0..stage.rays.len()).map(RayChoice::Named).chain([RayChoice::Own(own)]);
            for ray in rays.filter(|_| slide.plays.has_rays()) {
                let view = View {
                    ray,
                    settings: settings.clone(),
                    camera: Some(camera),
                    step,
                    ..View::of_slide(place, stage.kind)
                };
                let link = Link::of_view(&view, &library);
                let (found, wrong) = link.to_string().parse::<Link>().unwrap().view(&library);
                let found = found.unwrap_or_else(|| panic!("{link}: {wrong:?}"));
                assert!(wrong.is_empty() && found.same_page(&view), "{link}: {wrong:?}, {found:?}");
                assert_eq!(Link::of_view(&found, &library), link);
                seen += 1;
            }
        }
    }
    assert!(seen > 100, "{seen} views");
}

#[test]
fn every_wrong_link_gets_a_sentence() {
    let library = Library::embedded();
    let check = |text: &str, says: &str| {
        let said = match text.parse::<Link>() {
            Err(why) => why,
            Ok(link) => link.view(&library).1.join("; "),
        };
        assert!(said.starts_with(says), "{text}: {said}");
    };
    check("", "a link begins with a slide, as in 5/33?step=3");
    // A sentence quotes no more than a line.
    let long = "3".repeat(70);
    let quoted = |many: usize| "3".repeat(many);
    check(
        &format!("5/33?set=max_depth:{long}"),
        &format!("set=max_depth:{}…: max_depth = {}…: allowed is a whole number", quoted(46), quoted(60)),
    );
    check("?step=3", "a link begins with a slide");
    check("5/33?step", "step: a part of a link is written key=value");
    check("5/33?step=-1", "step=-1: a whole number from 0 to");
    check("5/33?stepp=1", "stepp=1: a link has no such part; there are stage, ray,");
    check("5/33?ray=%FF", "ray=%FF: what stands behind % is no letter in UTF-8");
    check("5/33?ray=%00", "ray=%00: a link has no control characters");
    check("5/33?stage=round", "stage=round: there are flat and solid");
    check("5/33?own=1,2", "own=1,2: a ray has six numbers");
    check("5/33?own=0,0,0,0,0,0", "own=0,0,0,0,0,0: the ray cannot be walked");
    check("5/33?own=0,0,0,1,0,0,1", "own=0,0,0,1,0,0,1: behind the direction stand");
    check("5/33?set=max_depth", "set=max_depth: a parameter is written set=key:value");
    check("5/33?camera=1,2", "camera=1,2: three numbers are needed");
    check("5/33?camera=0,0,nan", "camera=0,0,nan: three numbers are needed");
    check("5/33?aspect=0", "aspect=0: a number from 0.01 to 100");
    check("5/33?shape=1", "shape=1: a shape is written shape=number:x,y,…");
    check("5/33?shape=a:1,2", "shape=a:1,2: the number of the shape stands first");
    check("5/33?shape=1:1,x", "shape=1:1,x: a shape has finite numbers with commas between them");
    check("5/33?shape=1:1,2,3&shape=1:1,2,3", "shape=1:1,2,3: this shape lies elsewhere already");
    check("5/33?shape=99:1,2,3", "shape=99: there is no shape 99; the last one is");
    check("5/33?shape=0:1,2", "shape=0: 0 is a disc: x and y of its middle and its radius");
    check("5/33?stage=solid&shape=0:1,2,1", "The Utah teapot");
    check("5/33?example=kd-any-hit&shape=0:1,2,1", "shapes are moved in the slide's own scene, and in no other");
    check("5/33?try=0", "try=0: a cut is written node:axis=place, as in 0:x=2.09");
    check("5/33?part=3,1", "part=3,1: two numbers are needed, the smaller t first");
    check("5/33?pace=fast", "pace=fast: there are step and t");
    check("5/33?mistake=none", "mistake=none: there are slab-no-swap, slab-strict");
    check("5/33?example=none", "example=none: there are slab-no-swap, slab-strict");
    check("5/33?mistake=slab-strict", "slide 5/33 has no mistake \"slab-strict\"; there are kd-left-first, kd-any-hit");
    check("5/33?heat=time", "heat=time: there are tests, visits, boxes");
    check("5/33?heat=tests&fast=bvh", "fast=bvh: there are fast-grid, fast-kd, fast-bvh2, fast-bvh8");
    check("5/33?levels=0", "levels=0: path, or a number from 1 to 64");
    check("5/33?beside=kdd", "beside=kdd: there are list, grid");
    check("5/33?grain=fine", "grain=fine: there are arithmetic, decision and visit");
    check("5/33?speed=0.3", "speed=0.3: a number of quarters");
    check("5/33?present=1", "present=1: yes or no is needed");
    check("5/33?question=yes", "question=yes: a question is open, or nothing is said of it");
    check("5/33?answers=2", "answers=2: the letters of the last answers are needed, one or two, as in b or cb");
    check("5/99?step=1", "there is no slide \"5/99\"; there are 5/28");
    check("5/33?ray=none", "slide 5/33 has no ray \"none\"; there are \"both children, far hit\"");
    check("5/33?set=max_dept:3", "kd has no parameter \"max_dept\"");
    check("5/33?set=max_depth:9999999", "set=max_depth:9999999: max_depth = 9999999: allowed is ");
    check("3/22?stage=solid&ray=a", "slide 3/22");
    check(&format!("5/33?ray={}", "x".repeat(1 << 17)), "a link has at most 65536 letters");
}
