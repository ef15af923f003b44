use glam::Vec3;
use rayon::prelude::*;
use raystep_accel::Hit;
use raystep_fast::*;
use raystep_scene::*;
use std::io::Write;
#[path = "/tmp/surface_body.rs"]
mod surface;
use surface::Looks;
fn main() {
    let a: Vec<f32> = std::env::args().skip(1).map(|a| a.parse().unwrap()).collect();
    let (size, samples, trees, tris) = (a[0] as u32, a[1] as u32, a[2] as u32, a[3] as u32);
    let t = std::time::Instant::now();
    let woods = Woods::planted(trees, tris, &mut || ());
    eprintln!("grown {:?} {}", t.elapsed(), woods.instances.triangles());
    let scene = TwoLevels::build(&woods.instances, &Settings::default());
    eprintln!("built {:?} {}", t.elapsed(), scene.bytes());
    let v = |i: usize| Vec3::new(a[i], a[i + 1], a[i + 2]);
    let mut eye = v(4);
    eye.z += woods.land.height(eye.x, eye.y);
    let mut target = v(7);
    target.z += woods.land.height(target.x, target.y);
    let day = Daylight {
        eye,
        target,
        fov_degrees: a[13],
        size: [size, size],
        samples,
        sun: v(10).normalize(),
        haze: 2200.0,
        shade: 5.0,
    };
    let lines: Vec<Line> = (0..size).into_par_iter().map(|y| day.row(y, &scene, &Looks(&woods))).collect();
    eprintln!("drawn {:?}", t.elapsed());
    let mut f = std::fs::File::create("/tmp/woods.ppm").unwrap();
    write!(f, "P6 {size} {size} 255\n").unwrap();
    let rgb: Vec<u8> = lines.iter().flat_map(|l| l.rgba.chunks(4).flat_map(|p| [p[0], p[1], p[2]])).collect();
    f.write_all(&rgb).unwrap();
    let w = lines.iter().fold((0, 0, 0), |s, l| (s.0 + l.seen + l.lit, s.1 + l.work.triangles, s.2 + l.work.nodes));
    eprintln!("{:?} tests/ray {} nodes/ray {}", w, w.1 as f64 / w.0 as f64, w.2 as f64 / w.0 as f64);
    let _: Option<Hit> = None;
}
