//! Structures that were built, kept for a while: another ray, step or slide over the same scene finds them.

use std::sync::Arc;

use raystep_accel::{BvhVolume, Ray};
use raystep_lesson::{Board, Library, PacketTape, Plan, Plays, Stage, Tape};
use raystep_paint::Mesh;
use raystep_scene::Scene;

use super::asked::{rule_of, slide_and_stage};
use crate::shown::playback::Built;
use crate::shown::view::View;

/// They are kept while all together have at most so many bytes, and are no more than so many.
const MOST_BYTES: usize = 1 << 28;
const MOST: usize = 8;

/// A structure that was built, and its solid scene on the GPU, where there is one.
#[derive(Clone)]
pub(super) struct Stands {
    pub(super) built: Built,
    pub(super) mesh: Option<Arc<Mesh>>,
}

/// What was built last, the last one first.
#[derive(Default)]
pub(super) struct Kept(Vec<Stands>);

impl Kept {
    /// What a view asks for, if it stands.
    pub(super) fn fitting(&self, view: &View, library: &Library) -> Option<&Stands> {
        self.0.iter().find(|stands| fits(&stands.built, view, library))
    }

    /// What was built over the scene that a view asks for.
    pub(super) fn over(&self, view: &View, library: &Library) -> Option<&Stands> {
        self.0.iter().find(|stands| is_over(&stands.built, view, library))
    }

    /// Keeps what was built in the place of what was built alike.
    pub(super) fn keep(&mut self, stands: Stands) {
        self.0.retain(|kept| !same(&kept.built, &stands.built));
        self.0.insert(0, stands);
        let mut bytes = 0;
        let many = self.0.iter().position(|kept| {
            bytes += kept.built.structure.bytes();
            bytes > MOST_BYTES
        });
        self.0.truncate(many.unwrap_or(MOST).clamp(1, MOST));
    }

    /// A scene was uploaded.
    pub(super) fn upload(&mut self, scene: &Arc<Scene>, mesh: &Arc<Mesh>) {
        for kept in self.0.iter_mut().filter(|kept| Arc::ptr_eq(&kept.built.scene, scene)) {
            kept.mesh = Some(mesh.clone());
        }
    }

    /// What was uploaded is gone.
    pub(super) fn lose_uploads(&mut self) {
        self.0.iter_mut().for_each(|kept| kept.mesh = None);
    }
}

/// Whether a kept structure is the one that a view asks for.
fn fits(built: &Built, view: &View, library: &Library) -> bool {
    let Some((slide, stage)) = slide_and_stage(view, library) else { return false };
    // How it was built is kept only where it is played, and a board is its own slide's.
    built.told.as_ref().map_or(Plays::Walk, Tape::plays) == slide.plays
        && (view.example.is_some() || is_of(built.told.as_ref(), stage))
        && is_over(built, view, library)
        && rule_of(view, stage, built.scene.flat).is_ok_and(|rule| rule == built.rule)
}

/// Whether a kept tape is no board's, or this stage's board's; and its packets are the stage's.
fn is_of(told: Option<&Tape>, stage: &Stage) -> bool {
    match told {
        Some(Tape::Board(filled)) => stage.board.as_ref() == Some(&filled.board),
        Some(Tape::Walks(walks)) => stage.abreast == walks.plans,
        Some(Tape::Pairs(pairs)) => stage.pairs == pairs.pairs,
        Some(Tape::Fit(fit)) => stage.volume == Some(fit.volume),
        Some(Tape::Packet(packet)) => PacketTape::packets_of(&stage.rays) == packet.packets,
        _ => true,
    }
}

/// Whether a kept structure stands over the scene that a view asks for.
fn is_over(built: &Built, view: &View, library: &Library) -> bool {
    if let Some(own) = &view.own {
        return Arc::ptr_eq(&own.scene, &built.scene);
    }
    match (&view.mesh, view.example) {
        (_, Some(mistake)) => built.scene.name == mistake.name(),
        (Some(mesh), None) => Arc::ptr_eq(mesh, &built.scene),
        (None, None) => slide_and_stage(view, library).is_some_and(|(_, stage)| stage.is_over(&built.scene)),
    }
}

/// What a kept structure has beside it.
#[derive(PartialEq)]
enum Others<'a> {
    Nothing,
    /// The board that it fills.
    Board(&'a Board),
    /// The structures that are walked with it.
    Walks(&'a [Plan]),
    /// Pairs of objects.
    Pairs(&'a [u32]),
    /// The volume that is fitted around everything.
    Fit(BvhVolume),
    /// The packets that walk it.
    Packets(&'a [Vec<Ray>]),
}

fn others(built: &Built) -> Others<'_> {
    match &built.told {
        Some(Tape::Board(filled)) => Others::Board(&filled.board),
        Some(Tape::Walks(walks)) => Others::Walks(&walks.plans),
        Some(Tape::Pairs(pairs)) => Others::Pairs(&pairs.pairs),
        Some(Tape::Fit(fit)) => Others::Fit(fit.volume),
        Some(Tape::Packet(packet)) => Others::Packets(&packet.packets),
        Some(Tape::Walk(_) | Tape::Build(_)) | None => Others::Nothing,
    }
}

fn same(a: &Built, b: &Built) -> bool {
    a.rule == b.rule
        && others(a) == others(b)
        && a.told.is_some() == b.told.is_some()
        && (Arc::ptr_eq(&a.scene, &b.scene) || a.scene.name == b.scene.name)
}
