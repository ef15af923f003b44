//! What comes out of the GPU. Steps aside where no driver answers, unless `RAYSTEP_REQUIRE_GPU=1`.
//! With `RAYSTEP_PICTURES=DIR` the pictures are written there to be looked at.

use glam::{Vec3, vec3};
use raystep_accel::{Aabb, Accel, KdLayout, PrimId, Prims, Ray, Rule, Shape, Sphere, Structure, Visit};
use raystep_figure::{Camera, Form, Moment, Nodes, Role, Space, SpaceMark, Theme, Walk};
use raystep_paint::{Frame, Headless};
use raystep_scene::{Scene, View};

const SIZE: [u32; 2] = [400, 300];

/// A device, or nothing and a line that says so.
fn device() -> Option<Headless> {
    match Headless::new() {
        Ok(headless) => Some(headless),
        Err(none) if std::env::var("RAYSTEP_REQUIRE_GPU").as_deref() == Ok("1") => panic!("{none}"),
        Err(none) => {
            println!("stepping aside: {none}");
            None
        }
    }
}

/// What a test draws: a scene, marks, a camera that looks along y.
struct Stage {
    prims: Prims,
    camera: Camera,
    marks: Vec<(Role, Form)>,
    theme: &'static Theme,
}

impl Stage {
    /// A ball of radius 1 at the origin, seen from y = −6.
    fn ball() -> Stage {
        let ball = Shape::Sphere(Sphere { center: Vec3::ZERO, radius: 1.0 });
        let camera = Camera::Solid { eye: vec3(0.0, -6.0, 0.0), target: Vec3::ZERO, up: Vec3::Z, fov_degrees: 40.0 };
        Stage { prims: Prims::Few(vec![ball]), camera, marks: Vec::new(), theme: &Theme::LIGHT }
    }

    fn with(mut self, role: Role, form: Form) -> Stage {
        self.marks.push((role, form));
        self
    }

    fn draw(&self, headless: &mut Headless) -> Picture {
        let marks = self.marks.iter().cloned().map(|(role, form)| SpaceMark { form, role, place: None }).collect();
        let space = Space { marks, bounds: Aabb::EMPTY, flat: false, notes: Vec::new() };
        let mesh = headless.mesh(&self.prims);
        let pixels = headless.rgba(&Frame {
            prims: &self.prims,
            mesh: Some(&mesh),
            space: &space,
            camera: &self.camera,
            theme: self.theme,
            ground: Role::Panel,
            size: SIZE,
            pixels_per_point: 1.0,
        });
        Picture { pixels }
    }
}

struct Picture {
    pixels: Vec<u8>,
}

impl Picture {
    /// The pixel at x to the right and y down from the middle.
    fn at(&self, x: i32, y: i32) -> [u8; 3] {
        let column = (SIZE[0] as i32 / 2 + x) as usize;
        let row = (SIZE[1] as i32 / 2 + y) as usize;
        let first = (row * SIZE[0] as usize + column) * 4;
        [self.pixels[first], self.pixels[first + 1], self.pixels[first + 2]]
    }

    fn save(&self, name: &str) {
        if let Some(folder) = std::env::var_os("RAYSTEP_PICTURES") {
            let file = std::fs::File::create(std::path::Path::new(&folder).join(name)).expect("the folder exists");
            let mut encoder = png::Encoder::new(file, SIZE[0], SIZE[1]);
            encoder.set_color(png::ColorType::Rgba);
            encoder.write_header().and_then(|mut writer| writer.write_image_data(&self.pixels)).expect("written");
        }
    }
}

/// How far two colours are apart, in the channel that differs most.
fn apart(a: [u8; 3], b: [u8; 3]) -> u8 {
    (0..3).map(|i| a[i].abs_diff(b[i])).max().unwrap_or(0)
}

#[test]
fn a_ball_is_round_and_shaded_on_the_panels_ground() {
    let Some(mut headless) = device() else { return };
    for theme in Theme::ALL {
        let picture = Stage { theme, ..Stage::ball() }.draw(&mut headless);
        let ground = theme.style(Role::Panel).fill.expect("a panel has a ground");
        assert_eq!(picture.at(-199, -149), [ground.r, ground.g, ground.b], "{}", theme.name);
        assert!(apart(picture.at(0, 0), picture.at(-199, 0)) > 12, "the ball stands out in {}", theme.name);
        assert!(apart(picture.at(-20, -20), picture.at(40, 40)) > 8, "light comes from the left in {}", theme.name);
        // 300 pixels show 2·6·tan 20° units; a ball of radius 1 seen from 6 reaches 1/√35 of the distance.
        assert_eq!(picture.at(0, -75), picture.at(-199, 0), "above the ball in {}", theme.name);
        assert!(apart(picture.at(0, -66), picture.at(-199, 0)) > 8, "inside its rim in {}", theme.name);
    }
}

#[test]
fn what_the_scene_hides_is_faint_and_the_rest_is_not() {
    let Some(mut headless) = device() else { return };
    let ink = |y: f32| {
        let line = Form::Segment(vec3(-3.0, y, 0.0), vec3(3.0, y, 0.0));
        let bare = Stage::ball().draw(&mut headless);
        let drawn = Stage::ball().with(Role::Live, line).draw(&mut headless);
        apart(bare.at(0, 0), drawn.at(0, 0))
    };
    let mut ink = ink;
    let (before, behind) = (ink(-2.0), ink(2.0));
    assert!(before > 100, "in front of the ball: {before}");
    assert!((20..before / 2).contains(&behind), "behind it: {behind} against {before}");
}

#[test]
fn a_line_keeps_its_width_at_any_distance() {
    let Some(mut headless) = device() else { return };
    for y in [-4.0, 0.0, 50.0] {
        let stage = Stage { prims: Prims::Few(Vec::new()), ..Stage::ball() };
        let reach = 3.0 * (6.0 + y);
        let line = Form::Segment(vec3(-reach, y, 0.0), vec3(reach, y, 0.0));
        let picture = stage.with(Role::Live, line).draw(&mut headless);
        let inked = (-20..20).filter(|&row| apart(picture.at(0, row), picture.at(0, -100)) > 60).count();
        assert_eq!(inked, 4, "at y = {y}");
    }
}

#[test]
fn the_same_frame_gives_the_same_bytes_and_another_mesh_others() {
    let Some(mut headless) = device() else { return };
    let ball = Stage::ball().draw(&mut headless);
    assert!(ball.pixels == Stage::ball().draw(&mut headless).pixels);
    let nothing = Stage { prims: Prims::Few(Vec::new()), ..Stage::ball() };
    assert!(ball.pixels != nothing.draw(&mut headless).pixels);
}

#[test]
fn odd_marks_do_no_harm() {
    let Some(mut headless) = device() else { return };
    let mut stage = Stage::ball();
    let far = Vec3::splat(1e30);
    let behind = vec3(0.0, -20.0, 0.0);
    for role in Role::ALL {
        stage = stage
            .with(role, Form::Box(Aabb::EMPTY))
            .with(role, Form::Box(Aabb::new(Vec3::ZERO, Vec3::ZERO)))
            .with(role, Form::Sheet(Aabb::new(vec3(0.2, -1.0, -1.0), vec3(0.2, 1.0, 1.0))))
            .with(role, Form::Segment(behind, Vec3::ZERO))
            .with(role, Form::Segment(behind, behind))
            .with(role, Form::Segment(Vec3::ZERO, Vec3::NAN))
            .with(role, Form::Arrow(Vec3::ZERO, far))
            .with(role, Form::Arrow(Vec3::ONE, Vec3::ONE))
            .with(role, Form::Point(behind))
            .with(role, Form::Point(Vec3::INFINITY))
            .with(role, Form::Prim(PrimId(0)))
            .with(role, Form::Prim(PrimId(9999)))
            .with(role, Form::Label { at: Vec3::ZERO, within: None, text: "0".to_owned() });
    }
    stage.draw(&mut headless);
    // The eye at its target sees nothing, and an enormous or empty size becomes one that can be drawn.
    stage.camera = Camera::Solid { eye: Vec3::ZERO, target: Vec3::ZERO, up: Vec3::Z, fov_degrees: 40.0 };
    stage.draw(&mut headless);
}

/// Real walks on the teapot; nothing is asserted but that something is drawn.
#[test]
fn walks_on_the_teapot() {
    let Some(mut headless) = device() else { return };
    let scene = Scene::named("teapot-6321").expect("shipped");
    let View { eye, target, up, fov_degrees } = scene.view;
    let ray = Ray::new(vec3(-6.0, -3.0, 3.6), vec3(6.1, 2.7, -2.0)).expect("a ray");
    let mesh = headless.mesh(&scene.prims);
    for (kind, theme) in Rule::KINDS.into_iter().zip(Theme::ALL.into_iter().cycle()) {
        let rule = Rule::default_for(kind).expect("a kind");
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
        for part in [0.3, 0.6, 1.0] {
            let step = (events.len() as f32 * part) as usize;
            let space = raystep_figure::space(&walk, &Moment::at(&walk, step));
            let pixels = headless.rgba(&Frame {
                prims: &scene.prims,
                mesh: Some(&mesh),
                space: &space,
                camera: &Camera::Solid { eye, target, up, fov_degrees },
                theme,
                ground: Role::Panel,
                size: SIZE,
                pixels_per_point: 1.0,
            });
            let picture = Picture { pixels };
            assert!(apart(picture.at(20, 20), picture.at(-199, -149)) > 8, "{kind} at step {step}");
            picture.save(&format!("teapot-{kind}-{part}.png"));
        }
    }
}
