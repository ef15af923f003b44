//! Which slides, stages and rays are drawn.

use raystep_accel::Ray;
use raystep_lesson::{Library, NamedRay, Slide, Stage, StageKind};

use super::ExportArguments;
use super::own::{pairs, seen};
use crate::cli::rays;
use crate::export::{Changed, Format, Ground, Session, rays_of_beats};
use crate::fault::Fault;
use crate::shown::unknown::{no_ray, no_slide};

/// A stage, built, with what walks on it.
pub(super) struct Stood<'a> {
    pub(super) ground: Ground<'a>,
    pub(super) rays: Vec<&'a NamedRay>,
    pub(super) own: Option<Ray>,
}

impl Stood<'_> {
    /// The walks to draw.
    pub(super) fn sessions(&self) -> Vec<Session<'_>> {
        match self.own {
            Some(ray) => Session::of_own_ray(&self.ground, ray),
            None => Session::of_rays(&self.ground, &self.rays),
        }
    }
}

/// The stages to draw.
pub(super) fn grounds<'a>(library: &'a Library, arguments: &ExportArguments) -> Result<Vec<Stood<'a>>, Fault> {
    let settings = pairs(&arguments.own)?;
    let mut grounds = Vec::new();
    for slide in chosen(library, arguments)? {
        for stage in StageKind::ALL.into_iter().filter_map(|kind| slide.stage(kind)) {
            let own = own_ray(slide, stage, arguments)?;
            let rays = rays(slide, stage, arguments);
            let left_out = arguments.stage.as_deref().is_some_and(|name| name != stage.kind.name());
            // A build has no ray to be named.
            let nothing =
                if !slide.plays.has_rays() { arguments.ray.is_some() } else { rays.is_empty() && own.is_none() };
            if !left_out && !nothing {
                let seen = seen(&arguments.own, stage, arguments.size)?;
                let changed = Changed { settings: settings.clone(), seen, ..Changed::default() };
                let ground = Ground::of_changed_stage(library, slide, stage, changed, arguments.times)?;
                grounds.push(Stood { ground, rays, own });
            }
        }
    }
    Ok(grounds)
}

/// A ray that is written in numbers, on the stage that it is for: in the plane, on the flat one.
fn own_ray(slide: &Slide, stage: &Stage, arguments: &ExportArguments) -> Result<Option<Ray>, Fault> {
    let named = |ray: &str| slide.stages.iter().any(|stage| stage.ray(ray).is_some());
    let Some(line) = arguments.ray.as_deref().filter(|ray| is_written(ray) && !named(ray)) else { return Ok(None) };
    let ray = rays::read_one(line, glam::DVec3::ZERO).map_err(|why| Fault::new(format!("--ray {line}: {why}")))?;
    let in_plane = ray.o.z == 0.0 && ray.d.z == 0.0 && slide.stage(StageKind::Flat).is_some();
    let here = match &arguments.stage {
        Some(_) => true,
        None => (stage.kind == StageKind::Flat) == in_plane || slide.stages.len() == 1,
    };
    Ok(Some(ray).filter(|_| here && slide.plays.has_rays()))
}

/// Whether a ray is numbers and not a name.
fn is_written(ray: &str) -> bool {
    ray.contains(',') && ray.starts_with(|first: char| first.is_ascii_digit() || "+-.".contains(first))
}

fn chosen<'a>(library: &'a Library, arguments: &ExportArguments) -> Result<Vec<&'a Slide>, Fault> {
    let Some(id) = &arguments.slide else { return Ok(library.slides.iter().collect()) };
    match library.slide(id) {
        Some(slide) => Ok(vec![slide]),
        None => Err(Fault::new(no_slide(library, id))),
    }
}

/// The named ray, or those that the beats want; without beats, the stage's own.
fn rays<'a>(slide: &'a Slide, stage: &'a Stage, arguments: &ExportArguments) -> Vec<&'a NamedRay> {
    if let Some(name) = &arguments.ray {
        return stage.ray(name).into_iter().collect();
    }
    if arguments.steps.is_some() || arguments.format == Format::Json {
        return stage.rays.first().into_iter().collect();
    }
    rays_of_beats(slide, stage)
}

/// Why nothing was chosen.
pub(super) fn nothing(library: &Library, arguments: &ExportArguments) -> String {
    let slides = chosen(library, arguments).unwrap_or_default();
    let stages = |slide: &Slide| slide.stages.iter().map(|stage| stage.kind.name()).collect::<Vec<_>>().join(" and ");
    match (slides.as_slice(), &arguments.ray, &arguments.stage) {
        ([slide], Some(ray), _) => no_ray(slide, ray),
        ([slide], None, Some(stage)) => format!("slide {} has no {stage} stage, only {}", slide.id(), stages(slide)),
        _ => "there is no such slide, ray and stage".to_owned(),
    }
}
