//! A slide being played: the walk of one ray, and where in it the beats stand.

use std::sync::Arc;

use raystep_accel::{Accel, Cancelled, Hit, Ray, Rule, RuleError, Structure, Trace, Visit};
use raystep_scene::{Scene, UnknownScene};
use thiserror::Error;

use crate::{Beat, Plan, Slide, Stage};

/// How many events a walk keeps.
const TAPE: usize = 200_000;

/// The walk of one ray through one structure, beside the beats of a slide.
#[derive(Clone, Debug)]
pub struct Play {
    /// What the structure was built over.
    pub scene: Arc<Scene>,
    /// What the ray walks through.
    pub structure: Arc<Structure>,
    /// The ray.
    pub ray: Ray,
    /// What happens, in order. Step `i` shows the state after `events[..i]`.
    pub events: Vec<Visit>,
    /// How many events more there were.
    pub lost: u64,
    /// The answer.
    pub hit: Option<Hit>,
    /// For each beat of the slide the step at which it stands, if this walk reaches it.
    pub beats: Vec<Option<usize>>,
}

/// Why a slide cannot be played.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum PlayError {
    /// Its scene is unknown.
    #[error(transparent)]
    Scene(#[from] UnknownScene),
    /// Its structure is not as it should be.
    #[error(transparent)]
    Rule(#[from] RuleError),
    /// Its structure was not built.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

impl Plan {
    /// The rule that the plan spells, for a scene of this kind.
    ///
    /// # Errors
    /// An unknown kind or parameter, or a value that is not allowed.
    pub fn rule(&self, flat: bool) -> Result<Rule, RuleError> {
        let mut rule = Rule::default_for(&self.kind)?;
        for setting in &self.settings {
            rule.set(&setting.key, &setting.value)?;
        }
        Ok(if flat { rule.flat() } else { rule })
    }
}

impl Stage {
    /// The stage's scene and the structure over it.
    ///
    /// # Errors
    /// An unknown scene, or a rule that cannot be followed.
    pub fn build(&self) -> Result<(Arc<Scene>, Arc<Structure>), PlayError> {
        let scene = Scene::named(&self.scene)?;
        let rule = self.plan.rule(scene.flat)?;
        let structure = Structure::build(&scene.prims, &rule, &mut ())?;
        Ok((Arc::new(scene), Arc::new(structure)))
    }
}

impl Play {
    /// Walks `ray` and looks up where the beats stand.
    pub fn new(scene: Arc<Scene>, structure: Arc<Structure>, ray: Ray, beats: &[Beat]) -> Play {
        let mut tape = Trace::new(TAPE);
        let hit = structure.intersect(&scene.prims, &ray, &mut tape);
        let beats = steps(beats, &tape.events, scene.flat);
        Play { scene, structure, ray, events: tape.events, lost: tape.lost, hit, beats }
    }

    /// The event that a step shows; none at step 0.
    pub fn event(&self, step: usize) -> Option<&Visit> {
        self.events.get(step.checked_sub(1)?)
    }

    /// The beat that a step belongs to: the last one reached at or before it, if the beats run that way.
    pub fn beat_at(&self, step: usize) -> Option<usize> {
        let reached = self.beats.iter().enumerate().filter_map(|(beat, at)| Some((beat, (*at)?)));
        reached.filter(|(_, at)| *at <= step).max_by_key(|(_, at)| *at).map(|(beat, _)| beat)
    }
}

/// The step of every beat. Each plays on from the one before it; where a slide turns to another ray, the
/// walk begins again, whichever ray is played.
fn steps(beats: &[Beat], events: &[Visit], flat: bool) -> Vec<Option<usize>> {
    let mut from = 0;
    let step = |(index, beat): (usize, &Beat)| {
        if index > 0 && beat.ray.is_some() {
            from = 0;
        }
        let step = beat.at.step(events, from, flat);
        from = step.unwrap_or(from);
        step
    };
    beats.iter().enumerate().map(step).collect()
}

/// Plays a slide on one of its stages with one of the stage's rays.
///
/// # Errors
/// An unknown scene, or a rule that cannot be followed.
pub fn play(slide: &Slide, stage: &Stage, ray: &Ray) -> Result<Play, PlayError> {
    let (scene, structure) = stage.build()?;
    Ok(Play::new(scene, structure, *ray, &slide.beats))
}
