//! `raystep heatmap`: what each ray of a picture costs, or what it sees, as a picture or a table.

mod seen;

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

use clap::{Args, ValueEnum};
use glam::Vec2;
use raystep_accel::{Rule, Structure};
use raystep_figure::{Ask, Figure, Image, Ink, Look as Letters, Maps, Pane, Role, Theme, whole};
use raystep_lesson::Column;
use raystep_print::{png, svg};
use raystep_scene::Scene;
use seen::{Seen, Sees};

use super::measure::look::{Look, Shot};
use super::progress::bar;
use super::subject::Subject;
use crate::export::Size;
use crate::fault::Fault;
use crate::files;
use crate::shown::heat::{Heated, Walked, Wish};
use crate::shown::kind_name::kind_name;

/// What to count, and where to write it.
#[derive(Args, Debug)]
pub struct HeatmapArguments {
    #[command(flatten)]
    subject: Subject,
    /// `close` (the object fills the picture), `scene` (the scene's own view), or EX,EY,EZ,TX,TY,TZ[,DEGREES]:
    /// the eye, what it looks at, and the vertical angle of view.
    #[arg(long, value_name = "CAMERA", default_value = "close", allow_hyphen_values = true)]
    camera: Look,
    /// The size of the map: a ray for each pixel.
    #[arg(long, value_name = "WxH", default_value = "640x400")]
    size: Size,
    /// What is counted of each ray, or seen along it.
    #[arg(long, value_name = "COUNT", default_value = "tests")]
    of: Of,
    /// Where to write: a picture (.png), or the numbers (.csv), a line for each row of pixels from above.
    #[arg(long, value_name = "FILE.png|FILE.csv")]
    out: PathBuf,
    /// The picture without its scale of numbers, as many pixels as the map has.
    #[arg(long)]
    bare: bool,
}

/// What can be counted of a ray.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Of {
    /// Tests of primitives.
    Tests,
    /// Nodes or cells entered.
    Visits,
    /// Volumes tested.
    Boxes,
    /// No count: how far away is what the ray hits.
    Depth,
    /// No count: which way that faces.
    Normal,
    /// No count: how it looks in the light of a sun, with shadows.
    Shaded,
}

impl Of {
    /// What is counted, or what is seen.
    fn told(self) -> Result<Column, Sees> {
        match self {
            Of::Tests => Ok(Column::Tests),
            Of::Visits => Ok(Column::Visits),
            Of::Boxes => Ok(Column::Boxes),
            Of::Depth => Err(Sees::Depth),
            Of::Normal => Err(Sees::Normal),
            Of::Shaded => Err(Sees::Shaded),
        }
    }
}

/// What a file can hold.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Picture,
    Numbers,
}

/// Size of letters beside a map.
const LETTERS: f32 = 15.0;

/// Counts and writes.
pub(crate) fn run(arguments: &HeatmapArguments) -> Result<(), Fault> {
    let kind = kind(&arguments.out)?;
    if arguments.bare && kind == Kind::Numbers {
        return Err(Fault::new("--bare leaves out the scale of a picture, and a .csv has none: leave --bare out"));
    }
    let read: Vec<&Path> = arguments.subject.mesh.iter().map(PathBuf::as_path).collect();
    files::may_write(&arguments.out, &read)?;
    let scene = Arc::new(arguments.subject.scene()?);
    if scene.flat {
        return Err(Fault::new(format!(
            "{} is flat: a ray through a pixel would fall onto it from above; name a solid scene or a mesh",
            scene.name
        )));
    }
    let Shot { camera, size, .. } = Shot::of(&scene, arguments.camera, arguments.size, false);
    let size: Vec2 = size.into();
    let rays = [size.x as u32, size.y as u32];
    // A camera that sees nothing is said before anything is counted.
    camera.ray(Vec2::ZERO, size).map_err(|error| Fault::new(format!("--camera shoots no rays: {error}")))?;
    let (name, walked) = walked(&arguments.subject, &scene)?;
    let of = match arguments.of.told() {
        Ok(of) => of,
        Err(sees) => {
            let seen = Seen::of(&scene, &walked, camera, rays, sees);
            said(rays, &seen.took, "seen");
            let bytes = match kind {
                Kind::Picture => painted(size, seen.image())?,
                Kind::Numbers => seen.numbers().into_bytes(),
            };
            return files::write(&arguments.out, &bytes);
        }
    };
    let wish = Wish { scene, structures: vec![(name, walked)], of, camera, size };
    // What somebody would see first who waits for it.
    let begun = Instant::now();
    let coarse = rays.map(|side| side.div_ceil(COARSE).max(1));
    wish.clone().count(coarse, &|| true);
    let first = begun.elapsed();
    let bar = bar(u64::from(rays[1]), "rows");
    let counting = || {
        bar.inc(1);
        true
    };
    let begun = Instant::now();
    let heated = wish.count(rays, &counting);
    let took = begun.elapsed();
    bar.finish_and_clear();
    let heated = heated.ok_or_else(|| Fault::new("nothing was counted"))?;
    files::say(&format!("a first map of {} × {} rays in {:.1} ms", coarse[0], coarse[1], first.as_secs_f64() * 1e3));
    said(rays, &took, "counted");
    let bytes = match kind {
        Kind::Picture => picture(&heated, size, arguments.bare)?,
        Kind::Numbers => numbers(&heated).into_bytes(),
    };
    files::write(&arguments.out, &bytes)
}

/// A pixel of the first map is as wide and as high as so many of the last one.
const COARSE: u32 = 8;

/// How long it took.
fn said(rays: [u32; 2], took: &Duration, what: &str) {
    let (seconds, threads) = (took.as_secs_f64(), rayon::current_num_threads());
    let all = u64::from(rays[0]) * u64::from(rays[1]);
    files::say(&format!("{} rays {what} in {seconds:.3} s on {threads} threads", whole(all)));
}

/// The structure that is named, and what it is called.
fn walked(subject: &Subject, scene: &Arc<Scene>) -> Result<(String, Walked), Fault> {
    if let Some(kind) = subject.fast()? {
        let walked = Walked::fast(scene, kind).ok_or_else(|| {
            Fault::new(format!("{} is no mesh: {} stands over triangles alone", scene.name, kind.name()))
        })?;
        walked.build();
        return Ok((kind.name().to_owned(), walked));
    }
    let rule = subject.rule(false)?;
    let structure = Structure::build(&scene.prims, &rule, &mut ()).map_err(|error| Fault::new(error.to_string()))?;
    Ok((name(&rule), Walked::Textbook(Arc::new(structure))))
}

/// What a file of that name holds.
fn kind(path: &Path) -> Result<Kind, Fault> {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase()).unwrap_or_default();
    match ending.as_str() {
        "png" => Ok(Kind::Picture),
        "csv" => Ok(Kind::Numbers),
        _ => Err(Fault::new(format!(
            "--out {}: a heat map is written as FILE.png or FILE.csv; end the name so",
            path.display()
        ))),
    }
}

/// The structure with the parameters that differ from the usual ones.
fn name(rule: &Rule) -> String {
    let differs = Rule::default_for(rule.kind()).map(|usual| rule.differences(&usual)).unwrap_or_default();
    let differs = differs.into_iter().map(|(key, value)| format!(", {} {value}", key.replace('_', " ")));
    format!("{}{}", kind_name(rule.kind()), differs.collect::<String>())
}

/// The map with its scale; bare, its pixels alone.
fn picture(heated: &Heated, size: Vec2, bare: bool) -> Result<Vec<u8>, Fault> {
    if bare && let Some(image) = heated.maps().and_then(|maps| maps.image(0)) {
        return painted(size, image.clone());
    }
    // In a small picture letters are smaller, so that its words fit.
    let look = Letters { text: LETTERS.min(size.y / 12.0).max(9.0), titles: true, least: 0.0 };
    let room = Maps::room(size, 1, &look);
    let room = Vec2::new(room.x.max(look.text * 34.0).ceil(), room.y);
    let figure = heated.reel().still(&heated.instant()).draw(Pane::Picture, &Ask::new(room, look));
    png(&svg(&figure, &Theme::LIGHT), 1.0).map_err(|error| Fault::new(error.to_string()))
}

/// Pixels alone.
fn painted(size: Vec2, image: Image) -> Result<Vec<u8>, Fault> {
    let mut figure = Figure::new(size);
    figure.add(Role::Scene, None, Ink::Image { min: Vec2::ZERO, max: size, image });
    png(&svg(&figure, &Theme::LIGHT), 1.0).map_err(|error| Fault::new(error.to_string()))
}

/// A line for each row of pixels, from above.
fn numbers(heated: &Heated) -> String {
    let mut text = String::new();
    let Some(map) = heated.maps().and_then(|maps| maps.maps.first()) else { return text };
    for row in map.counts.chunks(map.size[0].max(1) as usize) {
        for (index, count) in row.iter().enumerate() {
            let _ = write!(text, "{}{count}", if index > 0 { "," } else { "" });
        }
        text.push('\n');
    }
    text
}
