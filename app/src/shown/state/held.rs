//! What is taken in the hand: shapes and planes that follow it, cuts that are tried, and the way back.

use std::sync::Arc;

use glam::{Vec2, Vec3};
use raystep_accel::{Event, Grow, HandCut, NodeId, PrimId, Primitives, Structure};
use raystep_figure::Grip;
use raystep_lesson::PairsTape;
use raystep_scene::{Part, Scene};

use super::{Landing, State};
use crate::shown::own::{MOST, OwnScene, Tried};
use crate::shown::playback::Playback;
use crate::shown::view::View;

impl State {
    /// The scene whose shapes can be taken in the hand: a flat one of the slide, and not too large.
    pub fn holdable(&self) -> Option<&Arc<Scene>> {
        let scene = self.playback.as_ref().map(|playback| &playback.play.scene)?;
        (scene.flat && scene.prims.len() <= MOST && !self.view.is_elsewhere()).then_some(scene)
    }

    /// Whether the planes of the structure can be taken in the hand.
    pub fn holds_planes(&self) -> bool {
        let kd = |playback: &Arc<Playback>| matches!(*playback.play.structure, Structure::Kd(_));
        self.holdable().is_some() && self.playback.as_ref().is_some_and(kd)
    }

    /// A part of a shape in a scene, taken at one point and moved to another, as part of a change that is under way.
    pub fn move_part(&mut self, scene: &Scene, prim: PrimId, part: Part, points: [Vec2; 2]) {
        let before = self.target().own.clone();
        if let Some(own) = OwnScene::of(scene, before.as_ref(), prim, part, points) {
            let view = View { own: Some(own), ..self.target().clone() };
            self.want(view, Landing::Keep);
        }
    }

    /// The object of a pair so far from where its arrangement has it, as part of a change that is under way.
    pub fn move_body(&mut self, grip: &Grip, moved: Vec3) {
        let key = PairsTape::key(grip.pair, grip.case);
        self.set_and_stand(&key, &PairsTape::value(moved), Landing::Keep);
    }

    /// A node cut by hand, as part of a change that is under way. Cuts of the nodes below it are given up: those are
    /// other nodes now.
    pub fn cut(&mut self, cut: HandCut) {
        self.cut_and_stand(cut, Landing::Keep);
    }

    fn cut_and_stand(&mut self, cut: HandCut, landing: Landing) {
        let Some(playback) = self.playback.clone() else { return };
        let structure = &playback.play.structure;
        // Beyond the node's faces there is nothing of it to cut: the cut stays where it was.
        if !structure.node_bounds().get(cut.node.index()).is_some_and(|bounds| cut.divides(bounds)) {
            return;
        }
        let below = below(structure, cut.node);
        let cuts = self.rule().and_then(|rule| rule.by_hand()?.without(|node| below.contains(&node)).with(cut));
        if let Some(cuts) = cuts {
            self.set_and_stand("cut", &cuts.to_string(), landing);
        }
    }

    /// Asks the builder what a cut would cost, instead of the one that it weighs at this step; it builds as before.
    pub fn try_cut(&mut self, cut: HandCut) {
        let step = self.view.step;
        let tried = Tried { step, cut };
        if let Some(trial) = self.trial_of(&tried) {
            self.playing = false;
            self.view.tried = Some(tried);
            self.trial = Some(Arc::new(trial));
        }
    }

    /// The build with the cut that is tried weighed at its step.
    fn trial_of(&self, tried: &Tried) -> Option<Playback> {
        let playback = self.playback.as_ref().filter(|_| self.holdable().is_some() && self.question().is_none())?;
        let weighs = |event: &Event| matches!(event, Event::Build(Grow::Weigh { node, .. }) if *node == tried.cut.node);
        playback.event(tried.step).filter(weighs)?;
        let told = Structure::weigh(&playback.play.scene.prims, &playback.rule, tried.cut)?;
        playback.trying(tried.step, told)
    }

    /// Makes the trial that the view speaks of, or gives it up.
    pub(super) fn renew_trial(&mut self) {
        let tried = self.view.tried.filter(|tried| tried.step == self.view.step);
        self.trial = tried.as_ref().and_then(|tried| self.trial_of(tried)).map(Arc::new);
        self.view.tried = tried.filter(|_| self.trial.is_some());
    }

    /// Cuts the node where a cut is tried.
    pub(super) fn cut_here(&mut self) {
        let Some(tried) = self.view.tried else { return };
        self.keep();
        self.cut_and_stand(tried.cut, Landing::Split(tried.cut.node));
    }

    /// Back to the slide's own scene and cuts; the ray stays.
    pub(super) fn reset_scene(&mut self) {
        let mut view = View { own: None, tried: None, ..self.target().clone() };
        view.settings.retain(|(key, _)| key != "cut");
        if !view.same_walk(self.target()) {
            self.keep();
            self.want(view, Landing::Keep);
        } else if self.view.tried.is_some() {
            self.keep();
            self.view.tried = None;
            self.trial = None;
        }
    }

    /// Takes back the change that is under way: it never was.
    pub fn take_back(&mut self) {
        if let Some(view) = self.history.take_back() {
            self.anchor = None;
            self.want(view, Landing::Named);
        }
    }
}

/// The nodes below a node.
fn below(structure: &Structure, node: NodeId) -> Vec<NodeId> {
    let mut open = structure.children(node);
    let mut all = Vec::new();
    while let Some(node) = open.pop() {
        open.extend(structure.children(node));
        all.push(node);
    }
    all
}
