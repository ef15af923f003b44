//! One ray through several structures at once: their events in one order, that of t along the ray.

use std::sync::Arc;

use raystep_accel::{Accel, Cancelled, Grow, Observer, Ray, Rule, Structure, Trace, Visit};
use raystep_scene::Scene;

use crate::{Plan, Tape, WalkTape};

/// Several structures over one scene, and the walks of a ray through them.
#[derive(Clone, Debug)]
pub struct WalksTape {
    /// How each was built.
    pub plans: Vec<Plan>,
    /// The structures.
    pub structures: Vec<Arc<Structure>>,
    /// The walk through each; none before a ray walks.
    pub walks: Vec<Tape>,
    /// Whose event each step is, and which of its events.
    pub order: Vec<(usize, usize)>,
    /// How far along the ray each step has come.
    pub reached: Vec<f32>,
}

impl WalksTape {
    /// Builds the structures.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub(crate) fn build(
        plans: &[Plan],
        scene: &Scene,
        watch: &mut impl Observer<Grow>,
    ) -> Result<WalksTape, Cancelled> {
        let mut structures = Vec::new();
        for rule in plans.iter().filter_map(|plan| plan.rule(scene.flat).ok()) {
            structures.push(Arc::new(Structure::build(&scene.prims, &rule, watch)?));
        }
        let (walks, order, reached) = (Vec::new(), Vec::new(), Vec::new());
        Ok(WalksTape { plans: plans.to_vec(), structures, walks, order, reached })
    }

    /// Structures that stand already over a scene that is flat or not, each with its rule.
    pub fn of(built: Vec<(Rule, Arc<Structure>)>, flat: bool) -> WalksTape {
        let plans = built.iter().map(|(rule, _)| Plan::of(rule, flat)).collect();
        let structures = built.into_iter().map(|(_, structure)| structure).collect();
        WalksTape { plans, structures, walks: Vec::new(), order: Vec::new(), reached: Vec::new() }
    }

    /// The step at which a walk has made its first `done` events, as far as it makes so many; when it is over, all are.
    pub fn step_with(&self, walker: usize, done: usize) -> usize {
        let own = self.order.iter().enumerate().filter(|(_, (other, _))| *other == walker);
        match own.clone().count() <= done {
            true => self.order.len(),
            false => done.checked_sub(1).and_then(|last| own.map(|(at, _)| at + 1).nth(last)).unwrap_or(0),
        }
    }

    /// Lets a ray walk through all of them.
    pub(crate) fn walk(&self, scene: &Scene, ray: Ray) -> WalksTape {
        let mut tape = WalksTape { walks: Vec::new(), order: Vec::new(), reached: Vec::new(), ..self.clone() };
        let mut along: Vec<Vec<f32>> = Vec::new();
        for structure in &self.structures {
            let mut trace = Trace::new(MOST);
            let hit = structure.intersect(&scene.prims, &ray, &mut trace);
            along.push(reached(&ray, &trace.events));
            tape.walks.push(Tape::Walk(WalkTape { ray, events: trace.events, lost: trace.lost, hit }));
        }
        // The walk that is furthest behind goes on; at the same t, the one that has done less.
        let mut next = vec![0; along.len()];
        while let Some((t, walker)) = (0..along.len())
            .filter_map(|walker| Some((*along[walker].get(next[walker])?, walker)))
            .min_by(|a, b| a.0.total_cmp(&b.0).then((next[a.1], a.1).cmp(&(next[b.1], b.1))))
        {
            tape.order.push((walker, next[walker]));
            tape.reached.push(t);
            next[walker] += 1;
        }
        tape
    }

    /// What slides call the structures: their kinds, with a number where one stands there twice.
    pub fn names(&self) -> Vec<String> {
        names(&self.plans)
    }

    /// How many events of a walk are among the first `step` of all.
    pub(crate) fn done(&self, walker: usize, step: usize) -> usize {
        self.order.iter().take(step).filter(|(own, _)| *own == walker).count()
    }
}

/// What slides call the structures of a stage.
pub(crate) fn names(plans: &[Plan]) -> Vec<String> {
    let name = |(index, plan): (usize, &Plan)| {
        let before = plans[..index].iter().filter(|other| other.kind == plan.kind).count();
        if before > 0 { format!("{}{}", plan.kind, before + 1) } else { plan.kind.clone() }
    };
    plans.iter().enumerate().map(name).collect()
}

/// The most events of one walk.
const MOST: usize = 50_000;

/// How far along the ray a walk has come after each of its events: the largest t at which it entered something. Of a
/// walk that is over, infinitely far.
fn reached(ray: &Ray, events: &[Visit]) -> Vec<f32> {
    let mut far = ray.t_min;
    let along = events.iter().map(|event| {
        far = match *event {
            Visit::Enter { t_near, .. } | Visit::Pop { t_near, .. } => far.max(t_near),
            Visit::End { hit: true, t, .. } => far.max(t),
            _ => far,
        };
        far
    });
    along.collect()
}
