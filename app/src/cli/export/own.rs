//! Walks and builds of no slide: a scene or a mesh, a structure, and a ray through it.

use std::path::PathBuf;
use std::sync::Arc;

use clap::Args;
use glam::Vec2;
use raystep_accel::Ray;
use raystep_lesson::{Library, Stage};
use raystep_scene::Scene;

use super::ExportArguments;
use crate::cli::measure::look::{Look, Shot};
use crate::cli::{rays, subject, trace};
use crate::export::{Ground, Session, Size};
use crate::fault::Fault;
use crate::shown::camera::Seen;

/// What is not a slide's.
#[derive(Args, Debug)]
pub(crate) struct Own {
    /// A shipped scene instead of a slide: flat-twelve, teapot-6321 ...
    #[arg(long, value_name = "NAME", conflicts_with_all = ["slide", "all", "mesh"], requires = "structure")]
    scene: Option<String>,
    /// A mesh instead of a slide.
    #[arg(long, value_name = "FILE.obj", conflicts_with_all = ["slide", "all"], requires = "structure")]
    mesh: Option<PathBuf>,
    /// The structure over the scene or the mesh: list, grid, nested-grid, hashed-grid, kd, octree, bsp or bvh.
    #[arg(long, value_name = "KIND", conflicts_with_all = ["slide", "all"])]
    structure: Option<String>,
    /// A parameter of the structure, also of a slide's; may be repeated.
    #[arg(long, value_name = "KEY=VALUE")]
    rule: Vec<String>,
    /// The ray through the middle of a pixel of a solid picture of --size, counted from the upper left one.
    #[arg(long, value_name = "X,Y", value_parser = trace::pixel, conflicts_with_all = ["slide", "all", "ray"])]
    pixel: Option<[u32; 2]>,
    /// How the structure over the scene or the mesh is built, instead of a ray's walk.
    #[arg(long, conflicts_with_all = ["slide", "all", "ray", "pixel"])]
    build: bool,
    /// Where a solid scene is seen from: `close`, `scene`, or EX,EY,EZ,TX,TY,TZ[,DEGREES], the eye, what it looks at, and
    /// the vertical angle of view.
    #[arg(long, value_name = "CAMERA", allow_hyphen_values = true)]
    camera: Option<Look>,
}

impl Own {
    /// Whether a scene or a mesh takes the place of slides.
    pub(super) fn is_asked(&self) -> bool {
        self.scene.is_some() || self.mesh.is_some()
    }
}

/// The parameters that a slide's structure has instead of its own: keys and values.
pub(super) fn pairs(own: &Own) -> Result<Vec<(String, String)>, Fault> {
    subject::pairs(&own.rule)
}

/// Where a stage is seen from, if not as its slide says.
pub(super) fn seen(own: &Own, stage: &Stage, size: Size) -> Result<Option<(String, Seen)>, Fault> {
    if own.camera.is_none() {
        return Ok(None);
    }
    let scene = stage.scenes.named(&stage.scene).map_err(|error| Fault::new(error.to_string()))?;
    camera(own, &scene, size)
}

/// Where a scene is seen from, if that was said.
fn camera(own: &Own, scene: &Scene, size: Size) -> Result<Option<(String, Seen)>, Fault> {
    let Some(look) = own.camera else { return Ok(None) };
    if scene.flat {
        let why = format!("{} is flat and seen from straight above: a camera is for solid scenes", scene.name);
        return Err(Fault::new(format!("--camera: {why}")));
    }
    let camera = Shot::of(scene, look, size, false).camera;
    let pixels: Vec2 = size.into();
    camera.ray(Vec2::ZERO, pixels).map_err(|error| Fault::new(format!("--camera sees nothing: {error}")))?;
    Ok(Some((look.to_string(), Seen { camera, aspect: pixels.x / pixels.y })))
}

/// The scene with its structure, and the ray that walks; no ray where a build is asked for.
pub(super) fn ground<'a>(
    library: &'a Library,
    arguments: &ExportArguments,
) -> Result<(Ground<'a>, Option<Ray>), Fault> {
    let own = &arguments.own;
    let scene = match &own.mesh {
        Some(path) => {
            let scene = subject::mesh(path)?;
            // A picture tells the name of the file, not where it lies.
            let title =
                path.file_stem().map_or_else(|| scene.title.clone(), |stem| stem.to_string_lossy().into_owned());
            Scene { title, ..scene }
        }
        None => {
            let named = library.scenes.named(own.scene.as_deref().unwrap_or_default());
            Arc::unwrap_or_clone(named.map_err(|error| Fault::new(error.to_string()))?)
        }
    };
    let rule = subject::spelt(own.structure.as_deref().unwrap_or_default(), &own.rule, scene.flat)?;
    let ray = if own.build { None } else { Some(ray(arguments, &scene)?) };
    let seen = camera(own, &scene, arguments.size)?;
    Ok((Ground::of_scene(library, scene, rule, own.build, seen)?, ray))
}

/// What is drawn of it.
pub(super) fn sessions<'a>(ground: &'a Ground<'a>, ray: Option<Ray>) -> Vec<Session<'a>> {
    match ray {
        Some(ray) => Session::of_own_ray(ground, ray),
        None => Session::of_build(ground),
    }
}

fn ray(arguments: &ExportArguments, scene: &Scene) -> Result<Ray, Fault> {
    if let Some(line) = &arguments.ray {
        let wrong = |why: String| Fault::new(format!("--ray {line}: {why}"));
        let ray = rays::read_one(line, scene.origin).map_err(wrong)?;
        if scene.flat && (ray.o.z != 0.0 || ray.d.z != 0.0) {
            return Err(wrong(format!("{} is flat: a ray in its plane has z 0, as in 0,1,0,1,0.5,0", scene.name)));
        }
        return Ok(ray);
    }
    let Some([x, y]) = arguments.own.pixel else {
        return Err(Fault::new(
            "say which ray walks: --ray OX,OY,OZ,DX,DY,DZ or, on a solid scene, --pixel X,Y; or --build, how the \
             structure is built",
        ));
    };
    let look = arguments.own.camera.unwrap_or(Look::Scene);
    trace::through(scene, &Shot::of(scene, look, arguments.size, false).camera, arguments.size, [x, y])
}
