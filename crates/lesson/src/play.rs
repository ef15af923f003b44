//! A slide being played: a tape, and where on it the beats stand.

use std::sync::Arc;

use raystep_accel::{Cancelled, Event, KdLayout, Ray, Rule, RuleError, Structure};
use raystep_scene::{Scene, UnknownScene};
use thiserror::Error;

use crate::{Beat, Care, Plan, Plays, Stage, Tape};

/// The walk of one ray or of a packet through a structure, the building of one, or a board, beside the beats of a slide.
#[derive(Clone, Debug)]
pub struct Play {
    /// What the structure was built over.
    pub scene: Arc<Scene>,
    /// What the ray walks through, or what the build ends in.
    pub structure: Arc<Structure>,
    /// What happens, in order. Step `i` shows the state after the first `i` events.
    pub tape: Tape,
    /// What is played beside it, if it is to be told of.
    pub beside: Option<Tape>,
    /// For each beat of the slide the step at which it stands, if this tape reaches it.
    pub beats: Vec<Option<usize>>,
    /// The last layout in which the bytes of a kd-tree's node are shown.
    pub layout: KdLayout,
}

/// A stage's scene, the structure over it, and what is played whichever ray there is: a build, a board.
#[derive(Clone, Debug)]
pub struct Built {
    /// The scene.
    pub scene: Arc<Scene>,
    /// The structure.
    pub structure: Arc<Structure>,
    /// What is played without a ray, or by more than one: how it was built, a board, packets.
    pub told: Option<Tape>,
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
    /// The stage's scene and the structure over it, with how it was built if that is to be played.
    ///
    /// # Errors
    /// An unknown scene, or a rule that cannot be followed.
    pub fn build(&self, plays: Plays) -> Result<Built, PlayError> {
        self.plan.build(self, &self.scenes.named(&self.scene)?, plays, Care::Full)
    }

    /// The same, but a board is filled coarsely: enough to see whether it is right, and not yet to be quoted.
    ///
    /// # Errors
    /// An unknown scene, or a rule that cannot be followed.
    pub fn draft(&self, plays: Plays) -> Result<Built, PlayError> {
        self.plan.build(self, &self.scenes.named(&self.scene)?, plays, Care::Draft)
    }

    /// The structure beside, over the same scene, if the stage has one.
    ///
    /// # Errors
    /// A rule that cannot be followed.
    pub fn build_beside(&self, scene: &Arc<Scene>, plays: Plays) -> Result<Option<Built>, PlayError> {
        self.beside.as_ref().map(|plan| plan.build(self, scene, plays, Care::Full)).transpose()
    }
}

impl Plan {
    /// The structure over a scene, with how it was built if that is to be played.
    fn build(&self, stage: &Stage, scene: &Arc<Scene>, plays: Plays, care: Care) -> Result<Built, PlayError> {
        let rule = self.rule(scene.flat)?;
        let (structure, told) = Tape::record(plays, Some(stage), scene, &rule, care, &mut ())?;
        Ok(Built { scene: scene.clone(), structure: Arc::new(structure), told })
    }
}

impl Built {
    /// The build or the board if one is to be played, else the walk of the ray; nothing where there is neither.
    pub fn play(&self, ray: Option<Ray>, beats: &[Beat]) -> Option<Play> {
        Some(Play::new(self.scene.clone(), self.structure.clone(), self.tape(ray)?, beats))
    }

    /// The same, with what is played beside it.
    pub fn play_with(&self, beside: Option<&Built>, ray: Option<Ray>, beats: &[Beat]) -> Option<Play> {
        let play = self.play(ray, beats)?;
        Some(Play { beside: beside.and_then(|beside| beside.tape(ray)), ..play })
    }

    /// What happens.
    fn tape(&self, ray: Option<Ray>) -> Option<Tape> {
        match (&self.told, ray) {
            (Some(told), _) => Some(told.with_ray(&self.scene, &self.structure, ray)),
            (None, Some(ray)) => Some(Tape::walk(&self.scene, &self.structure, ray)),
            (None, None) => None,
        }
    }
}

impl Play {
    /// Looks up where on the tape the beats stand.
    pub fn new(scene: Arc<Scene>, structure: Arc<Structure>, tape: Tape, beats: &[Beat]) -> Play {
        let beats = steps(beats, &tape, scene.flat);
        Play { scene, structure, tape, beside: None, beats, layout: KdLayout::Compact }
    }

    /// The event that a step shows; none at step 0.
    pub fn event(&self, step: usize) -> Option<Event> {
        self.tape.event(step.checked_sub(1)?)
    }

    /// The beat that a step belongs to: the last one reached at or before it, if the beats run that way. What is said of
    /// a pair is said of that pair alone.
    pub fn beat_at(&self, step: usize) -> Option<usize> {
        let reached = self.beats.iter().enumerate().filter_map(|(beat, at)| Some((beat, (*at)?)));
        let pair = |step: usize| match self.event(step)? {
            Event::Pair(trial) => Some(trial.pair),
            _ => None,
        };
        let here = pair(step);
        reached.filter(|(_, at)| *at <= step && pair(*at) == here).max_by_key(|(_, at)| *at).map(|(beat, _)| beat)
    }
}

/// The step of every beat. Each plays on from the one before it; where a slide turns to another ray, the
/// walk begins again, whichever ray is played.
fn steps(beats: &[Beat], tape: &Tape, flat: bool) -> Vec<Option<usize>> {
    let mut from = 0;
    let step = |(index, beat): (usize, &Beat)| {
        if index > 0 && beat.ray.is_some() {
            from = 0;
        }
        let step = beat.wait(flat).step(tape, from, flat);
        from = step.unwrap_or(from);
        step
    };
    beats.iter().enumerate().map(step).collect()
}
