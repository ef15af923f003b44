//! What is verified: the textbook's structures, and those of the last chapter at full speed.

use std::fmt;

use raystep_accel::{Accel, Hit, Mesh, Prims, Ray, Rule, Shape, Structure, Want};
use raystep_fast::{AnyFast, Fast, FastKind, Settings, TwoLevels};
use raystep_scene::Scene;
use raystep_scene::trial::rules::rules;

use super::UntilStopped;
use crate::cli::spelt;
use crate::fault::Fault;

/// A structure to be built.
#[derive(Clone, Copy, Debug)]
pub(super) enum Contender {
    /// One of the textbook's, with its parameters.
    Textbook(Rule),
    /// A fast one.
    Fast(FastKind),
}

/// A structure over a scene.
pub(super) enum Built {
    Textbook(Structure),
    Fast(AnyFast),
    /// Over instances, as fast as can be.
    Levels(TwoLevels),
}

impl Contender {
    /// All that are tried, with the line that spells each.
    pub(super) fn all() -> impl Iterator<Item = (&'static str, Contender)> {
        let fast = FastKind::ALL.into_iter().map(|kind| (kind.name(), Contender::Fast(kind)));
        rules().map(|(line, rule)| (line, Contender::Textbook(rule))).chain(fast)
    }

    /// The one that a line spells.
    pub(super) fn spelt(line: &str) -> Result<Contender, Fault> {
        match FastKind::ALL.into_iter().find(|kind| kind.name() == line) {
            Some(kind) => Ok(Contender::Fast(kind)),
            None => Ok(Contender::Textbook(spelt::rule(line)?)),
        }
    }

    /// What kind of structure it is.
    pub(super) fn kind(&self) -> &'static str {
        match self {
            Contender::Textbook(rule) => rule.kind(),
            Contender::Fast(kind) => kind.name(),
        }
    }

    /// Builds it over a scene; nothing if all is stopped, or where it cannot stand: fast ones stand over triangles alone.
    pub(super) fn build(&self, scene: &Scene) -> Option<Built> {
        match self {
            Contender::Textbook(rule) => {
                let rule = if scene.flat { rule.flat() } else { *rule };
                Structure::build(&scene.prims, &rule, &mut UntilStopped).ok().map(Built::Textbook)
            }
            Contender::Fast(kind) => match &scene.prims {
                Prims::Mesh(mesh) => Some(Built::Fast(kind.build(mesh, &Settings::default()))),
                Prims::Few(shapes) => Some(Built::Fast(kind.build(&triangles(shapes)?, &Settings::default()))),
                Prims::Instances(all) => Some(Built::Levels(TwoLevels::build(all, &Settings::default()))),
            },
        }
    }

    /// Whether it can stand over a scene.
    pub(super) fn fits(&self, scene: &Scene) -> bool {
        match (self, &scene.prims) {
            (Contender::Fast(_), Prims::Few(shapes)) => triangles(shapes).is_some(),
            _ => true,
        }
    }
}

/// The mesh of shapes that are triangles, all of them.
fn triangles(shapes: &[Shape<'_>]) -> Option<Mesh> {
    let mut mesh = Mesh::default();
    for shape in shapes {
        let Shape::Triangle(triangle) = shape else { return None };
        let first = mesh.corners.len() as u32;
        mesh.corners.extend([triangle.a, triangle.b, triangle.c]);
        mesh.triangles.push([first, first + 1, first + 2]);
    }
    Some(mesh)
}

impl Built {
    /// The nearest hit of a ray, and whether there is any.
    pub(super) fn answers(&self, prims: &Prims, ray: &Ray) -> (Option<Hit>, bool) {
        let fast = |structure: &dyn Fn(Want) -> Option<Hit>| (structure(Want::Nearest), structure(Want::Any).is_some());
        match self {
            Built::Textbook(own) => (own.intersect(prims, ray, &mut ()), own.occluded(prims, ray, &mut ())),
            Built::Fast(own) => fast(&|want| own.walk(ray, want, &mut ())),
            Built::Levels(own) => fast(&|want| own.walk(ray, want, &mut ())),
        }
    }

    /// The textbook's structure, if it is one.
    pub(super) fn textbook(&self) -> Option<&Structure> {
        match self {
            Built::Textbook(own) => Some(own),
            Built::Fast(_) | Built::Levels(_) => None,
        }
    }
}

impl fmt::Debug for Built {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Built::Textbook(_) => "textbook",
            Built::Fast(_) => "fast",
            Built::Levels(_) => "fast, two levels",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_spell_contenders_and_fast_ones_stand_over_triangles() {
        for (line, contender) in Contender::all() {
            assert_eq!(Contender::spelt(line).unwrap().kind(), contender.kind(), "{line}");
        }
        assert!(Contender::spelt("fast-bvh3").is_err());
        let fast = Contender::Fast(FastKind::Bvh8);
        for (scene, stands) in [("teapot:1x1", true), ("forest:2", true), ("flat-twelve", false)] {
            let scene = Scene::named(scene).unwrap();
            assert_eq!((fast.fits(&scene), fast.build(&scene).is_some()), (stands, stands), "{}", scene.name);
        }
    }
}
