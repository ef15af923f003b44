//! What takes part in "which is best?": a structure of the textbook, or one at full speed.

use raystep_accel::{Accel, Cost, Grow, Observer, Prims, Ray, Rule, Structure, Want};
use raystep_fast::{AnyFast, Fast, FastKind, Settings};
use raystep_scene::Scene;

use crate::shown::kind_name::kind_name;

/// How a structure is to be built.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Candidate {
    /// A structure of the textbook, with these parameters.
    Textbook(Rule),
    /// A structure of the last chapter at full speed.
    Fast(FastKind),
}

impl Candidate {
    /// Every kind of structure that can be built over a scene, with the usual parameters: those of the textbook first.
    /// Here every ray walks alone, and so packets have no part in it.
    pub(crate) fn all(scene: &Scene) -> Vec<Candidate> {
        let rules = Rule::KINDS.into_iter().filter_map(|kind| Rule::default_for(kind).ok());
        let textbook = rules.map(|rule| Candidate::Textbook(if scene.flat { rule.flat() } else { rule }));
        let fast = matches!(scene.prims, Prims::Mesh(_)).then_some(FastKind::ALONE).into_iter().flatten();
        textbook.chain(fast.map(Candidate::Fast)).collect()
    }

    /// What it is called.
    pub(crate) fn name(&self) -> &'static str {
        match self {
            Candidate::Textbook(rule) => kind_name(rule.kind()),
            Candidate::Fast(kind) => kind_name(kind.name()),
        }
    }

    /// Whether it is one of those at full speed.
    pub(crate) fn is_fast(&self) -> bool {
        matches!(self, Candidate::Fast(_))
    }

    /// The name of its kind in files.
    pub(crate) fn kind(&self) -> &'static str {
        match self {
            Candidate::Textbook(rule) => rule.kind(),
            Candidate::Fast(kind) => kind.name(),
        }
    }

    /// Its kind with its parameters.
    pub(crate) fn written(&self) -> String {
        match self {
            Candidate::Textbook(rule) => {
                let parameters =
                    rule.parameters().iter().map(|p| format!(" {}={}", p.key, p.value)).collect::<String>();
                format!("{}{parameters}", rule.kind())
            }
            Candidate::Fast(kind) => kind.name().to_owned(),
        }
    }

    /// Builds it; nothing if it cannot be built over this scene, or if `go_on` says so.
    pub(super) fn build(&self, scene: &Scene, go_on: &(dyn Fn() -> bool + Sync)) -> Option<Built> {
        match (self, &scene.prims) {
            (Candidate::Textbook(rule), prims) => {
                Structure::build(prims, rule, &mut Watch(go_on)).ok().map(|built| Built::Textbook(Box::new(built)))
            }
            (Candidate::Fast(kind), Prims::Mesh(mesh)) => {
                go_on().then(|| Built::Fast(Box::new(kind.build(mesh, &Settings::default()))))
            }
            (Candidate::Fast(_), Prims::Few(_) | Prims::Instances(_)) => None,
        }
    }
}

/// What was built.
pub(super) enum Built {
    Textbook(Box<Structure>),
    Fast(Box<AnyFast>),
}

impl Built {
    /// What a ray costs.
    pub(super) fn cost(&self, scene: &Scene, ray: &Ray) -> Cost {
        let mut cost = Cost::default();
        match self {
            Built::Textbook(structure) => _ = structure.intersect(&scene.prims, ray, &mut cost),
            Built::Fast(fast) => _ = fast.walk(ray, Want::Nearest, &mut cost),
        }
        cost
    }

    /// The same walk, counting nothing.
    #[inline]
    pub(super) fn shoot(&self, scene: &Scene, ray: &Ray) {
        match self {
            Built::Textbook(structure) => _ = std::hint::black_box(structure.intersect(&scene.prims, ray, &mut ())),
            Built::Fast(fast) => _ = std::hint::black_box(fast.intersect(ray)),
        }
    }

    /// Nodes or cells that there are, where they are counted.
    pub(super) fn nodes(&self) -> Option<u64> {
        match self {
            Built::Textbook(structure) => {
                let cells = structure.grid().map_or(0, |grid| grid.cell_count() as u64);
                Some(structure.node_count() as u64 + cells)
            }
            Built::Fast(_) => None,
        }
    }

    /// What it takes in memory.
    pub(super) fn bytes(&self) -> u64 {
        match self {
            Built::Textbook(structure) => structure.bytes() as u64,
            Built::Fast(fast) => fast.bytes() as u64,
        }
    }
}

/// Lets a builder give up.
struct Watch<'a>(&'a (dyn Fn() -> bool + Sync));

impl Observer<Grow> for Watch<'_> {
    fn on(&mut self, _: Grow) {}

    fn cancelled(&self) -> bool {
        !(self.0)()
    }
}
