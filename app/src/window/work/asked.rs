//! What a view asks for: its slide and stage, the ray, the rule of the structure.

use raystep_accel::{Ray, Rule};
use raystep_lesson::{Library, Plays, Slide, Stage};

use crate::shown::view::{RayChoice, View};

/// The ray that a view asks for; a build needs none.
pub(super) fn ray_of(view: &View, slide: &Slide, stage: &Stage) -> Result<Option<Ray>, String> {
    match (&view.ray, slide.plays) {
        (_, plays) if !plays.has_rays() => Ok(None),
        (RayChoice::Own(ray), _) => Ok(Some(*ray)),
        (RayChoice::Named(index), _) => {
            let named = stage.rays.get(*index).ok_or("The slide has no such ray.")?;
            Ok(Some(named.ray))
        }
    }
}

/// The rule that a view asks for, over a scene that is flat or not; says so where a setting cannot be.
pub(super) fn rule_of(view: &View, stage: &Stage, flat: bool) -> Result<Rule, String> {
    let mut rule = match view.example {
        Some(mistake) => mistake.example().rule,
        None => stage.plan.rule(flat).map_err(|error| error.to_string())?,
    };
    for (key, value) in &view.settings {
        match stage.own_setting(key, value) {
            // The rule knows nothing of it.
            Some(own) => own?,
            None => rule.set(key, value).map_err(|error| error.to_string())?,
        }
    }
    Ok(rule)
}

/// Whether a view is of a slide that plays a board.
pub(super) fn plays_board(view: &View, library: &Library) -> bool {
    library.slides.get(view.slide).is_some_and(|slide| slide.plays == Plays::Board)
}

/// The slide of a view and its stage.
pub(super) fn slide_and_stage<'a>(view: &View, library: &'a Library) -> Option<(&'a Slide, &'a Stage)> {
    let slide = library.slides.get(view.slide)?;
    Some((slide, slide.stage(view.stage).or(slide.stages.first())?))
}
