//! What is done to a tree once it is built: primitives are inserted and deleted, slide 44.

use raystep_accel::{Cancelled, Change, Grow, Observer, PrimId, Primitives, Prims, Rule, Structure};
use raystep_scene::Scene;

use crate::keys::Keys;
use crate::reading::Reading;
use crate::{BuildTape, Plan, Spot, Stage};

/// A change as a slide has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Planned {
    /// What is done.
    pub change: Change,
    /// Where it stands in the file.
    pub(crate) spot: Spot,
}

/// A change as it happened.
#[derive(Clone, Debug, PartialEq)]
pub struct Told {
    /// What was done.
    pub change: Change,
    /// How many events the tape holds before it.
    pub from: usize,
    /// Whether the tree had room for it; else it stayed as it was.
    pub done: bool,
    /// The kind of the structure beside, built anew over what there is after the change, and how many nodes that made.
    pub anew: Option<(String, u64)>,
}

/// Most changes of a stage.
const MOST: usize = 8;

/// `change = [{ delete = 9 }, { insert = 10 }]`
pub(crate) fn read(keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Vec<Planned> {
    let mut changes: Vec<Planned> = Vec::new();
    for mut table in keys.tables("change", reading) {
        let at = table.at();
        let insert = table.get::<f32>("insert", reading);
        let delete = table.get::<f32>("delete", reading);
        table.finish(reading);
        let (number_at, number, change): (usize, f32, fn(PrimId) -> Change) = match (insert, delete) {
            (Some((at, number)), None) => (at, number, Change::Insert),
            (None, Some((at, number))) => (at, number, Change::Delete),
            _ => {
                reading.problem(at, "a change is one of the two: `{ insert = 10 }` or `{ delete = 7 }`");
                continue;
            }
        };
        if number < 0.0 || number.fract() != 0.0 || number > 1e6 {
            reading.problem(number_at, format!("`{number}` is no primitive: they are numbered from 0 on"));
            continue;
        }
        changes.push(Planned { change: change(PrimId(number as u32)), spot: reading.spot(number_at) });
    }
    if changes.len() > MOST {
        let spot = keys.at();
        reading.problem(spot, format!("a stage has at most {MOST} changes; here are {}", changes.len()));
        changes.truncate(MOST);
    }
    changes
}

impl Stage {
    /// What is wrong with the stage's changes over its scene, and where.
    pub(crate) fn wrong_changes(&self, scene: &Scene) -> Vec<(Spot, String)> {
        let mut wrong = Vec::new();
        let all = scene.prims.len() as u32;
        if let Some(first) = self.changes.first() {
            if self.plan.kind != "octree" {
                let message = format!("`change` belongs to an octree; the structure here is `{}`", self.plan.kind);
                wrong.push((first.spot, message));
            }
            if !matches!(scene.prims, Prims::Few(_)) {
                wrong.push((first.spot, "`change` belongs to a flat scene".to_owned()));
            }
        }
        let mut held: Vec<PrimId> = (0..self.built_first(scene)).map(PrimId).collect();
        for planned in &self.changes {
            let prim = planned.change.prim();
            let message = match planned.change {
                _ if prim.0 >= all => format!("there is no primitive {prim}: the scene has {all}, numbered from 0"),
                Change::Delete(_) if !held.contains(&prim) => format!("primitive {prim} is not in the tree then"),
                Change::Insert(_) if held.contains(&prim) => {
                    format!("primitive {prim} is in the tree already: only the last primitives of a scene are inserted")
                }
                Change::Delete(_) => {
                    held.retain(|other| *other != prim);
                    continue;
                }
                Change::Insert(_) => {
                    held.push(prim);
                    continue;
                }
            };
            wrong.push((planned.spot, message));
        }
        wrong
    }

    /// How many primitives the tree is built over at first: those before the first one that is only inserted.
    fn built_first(&self, scene: &Scene) -> u32 {
        let all = scene.prims.len() as u32;
        let mut gone = Vec::new();
        let mut first = all;
        for planned in &self.changes {
            match planned.change {
                Change::Delete(prim) => gone.push(prim),
                // What was deleted before comes back, and was there at first.
                Change::Insert(prim) if !gone.contains(&prim) => first = first.min(prim.0),
                Change::Insert(_) => {}
            }
        }
        first
    }

    /// Builds what `rule` says over what the scene has at first, and changes it as the stage says. Of a structure that
    /// cannot be changed, what there is in the end is built.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub(crate) fn build_and_change(
        &self,
        scene: &Scene,
        rule: &Rule,
        watch: &mut impl Observer<Grow>,
    ) -> Result<(Structure, BuildTape), Cancelled> {
        let mut tape = BuildTape::default();
        let mut held: Vec<PrimId> = (0..self.built_first(scene)).map(PrimId).collect();
        if !matches!(rule, Rule::Octree(_)) {
            self.changes.iter().for_each(|planned| follow(planned.change, &mut held));
            let structure = Structure::build(&only(&scene.prims, &held), rule, &mut (watch, &mut tape))?;
            return Ok((structure, tape));
        }
        let mut structure = Structure::build(&only(&scene.prims, &held), rule, &mut (&mut *watch, &mut tape))?;
        for planned in &self.changes {
            let (change, from) = (planned.change, tape.events.len());
            let Structure::Octree(tree) = &mut structure else { break };
            let done = tree.change(&scene.prims, change, &mut tape).is_ok();
            if done {
                follow(change, &mut held);
            }
            let anew = self.beside.as_ref().map(|plan| anew(plan, scene, &held, watch)).transpose()?.flatten();
            tape.changes.push(Told { change, from, done, anew });
        }
        Ok((structure, tape))
    }
}

/// Which primitives there are after a change.
fn follow(change: Change, held: &mut Vec<PrimId>) {
    match change {
        Change::Insert(prim) => held.push(prim),
        Change::Delete(prim) => held.retain(|other| *other != prim),
    }
}

/// Those of the primitives, numbered anew.
fn only(prims: &Prims, held: &[PrimId]) -> Prims {
    let Prims::Few(shapes) = prims else { return prims.clone() };
    Prims::Few(held.iter().filter_map(|prim| shapes.get(prim.index()).copied()).collect())
}

/// How many nodes are made where a structure is built over these primitives.
fn anew(
    plan: &Plan,
    scene: &Scene,
    held: &[PrimId],
    watch: &mut impl Observer<Grow>,
) -> Result<Option<(String, u64)>, Cancelled> {
    let Ok(rule) = plan.rule(scene.flat) else { return Ok(None) };
    let built = Structure::build(&only(&scene.prims, held), &rule, watch)?;
    Ok(Some((plan.kind.clone(), built.node_count() as u64)))
}
