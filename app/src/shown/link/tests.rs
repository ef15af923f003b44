//! Links: whatever a window shows is found again by its link.

use proptest::prelude::*;
use raystep_accel::{Grain, Ray, Rule};
use raystep_figure::{Camera, Depth};
use raystep_lesson::{Library, StageKind};

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
        proptest::option::of(prop_oneof![flat(), solid()].prop_filter("sees nothing", looks)),
    );
    let look = (
        prop_oneof![Just(ASPECT), 0.01_f32..100.0],
        proptest::option::of(prop_oneof![Just(Depth::Path), (1..=64_u32).prop_map(Depth::Down)]),
        proptest::option::of(kinds.prop_map(Rivals::of)),
        proptest::option::of(text),
        proptest::sample::select(vec![Grain::Arithmetic, Grain::Decision, Grain::Visit]),
        1..=9 * QUARTERS,
        any::<[bool; 2]>(),
    );
    (place, look).prop_map(|((slide, stage, ray, own, step, set, camera), look)| {
        let (aspect, depth, beside, mesh, grain, speed, [present, by_hand]) = look;
        Link {
            slide: if slide.trim().is_empty() { "5/33".to_owned() } else { slide },
            stage,
            ray,
            own,
            step,
            set: set.into_iter().map(|(key, value)| (key.to_owned(), value.to_owned())).collect(),
            camera,
            aspect,
            depth,
            beside,
            mesh,
            grain,
            speed,
            present,
            by_hand,
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
    check("5/33?levels=0", "levels=0: path, or a number from 1 to 64");
    check("5/33?beside=kdd", "beside=kdd: there are list, grid");
    check("5/33?grain=fine", "grain=fine: there are arithmetic, decision and visit");
    check("5/33?speed=0.3", "speed=0.3: a number of quarters");
    check("5/33?present=1", "present=1: yes or no is needed");
    check("5/99?step=1", "there is no slide \"5/99\"; there are 1/");
    check("5/33?ray=none", "slide 5/33 has no ray \"none\"; there are \"both children, far hit\"");
    check("5/33?set=max_dept:3", "kd has no parameter \"max_dept\"");
    check("5/33?set=max_depth:9999999", "set=max_depth:9999999: 9999999 is nothing that max_depth can be");
    check("3/22?stage=solid&ray=a", "slide 3/22");
    check(&format!("5/33?ray={}", "x".repeat(1 << 17)), "a link has at most 65536 letters");
}
