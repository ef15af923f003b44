//! One walk, step by step, for people.

use raystep_accel::{Accel, Cost, Event, Hit, KdLayout, Ray, Rule, Structure, Trace, Visit};
use raystep_figure::{Reel, Walk, counted, number, whole};
use raystep_scene::Scene;
use serde::Serialize;

use super::told::{Align, Format, Grid, Page, to_csv};
use crate::fault::Fault;
use crate::shown::all_nodes::AllNodes;
use crate::shown::kind_name::kind_name;

/// A ray that has walked.
pub(super) struct Walked<'a> {
    pub(super) scene: &'a Scene,
    pub(super) rule: &'a Rule,
    pub(super) structure: &'a Structure,
    pub(super) ray: &'a Ray,
    pub(super) tape: &'a Trace<Visit>,
    pub(super) hit: Option<Hit>,
}

/// A step as tables hold it.
#[derive(Serialize)]
struct Step {
    step: usize,
    event: &'static str,
    says: String,
    prim_tests: u64,
    node_visits: u64,
    cell_steps: u64,
    box_tests: u64,
}

/// A walk that is longer is shown with a gap in its middle.
const LONGEST: usize = 1200;
/// Of such a walk so many steps are shown on each side of the gap.
const ENDS: usize = 500;

impl Walked<'_> {
    /// The walk as a page or as a table.
    pub(super) fn written(&self, format: Format) -> Result<String, Fault> {
        match format {
            Format::Csv => to_csv(self.steps().iter()),
            format => Ok(self.page().written(format)),
        }
    }

    /// What happens, and what was counted by then.
    fn steps(&self) -> Vec<Step> {
        let Walked { scene, structure, ray, tape, .. } = self;
        let all = AllNodes::of(structure, None);
        let (prims, nodes, flat) = (&scene.prims, &all.own, scene.flat);
        let walk = Walk {
            structure,
            prims,
            nodes,
            ray: **ray,
            events: &tape.events,
            lost: tape.lost,
            flat,
            layout: KdLayout::Compact,
        };
        let reel = Reel::new(walk);
        let mut cost = Cost::default();
        let step = |(index, event): (usize, &Visit)| {
            raystep_accel::Observer::on(&mut cost, *event);
            let event = Event::Walk(*event);
            Step {
                step: index + 1,
                event: event.name(),
                says: reel.sentence(index + 1, &event).replace("**", ""),
                prim_tests: cost.prim_tests,
                node_visits: cost.node_visits,
                cell_steps: cost.cell_steps,
                box_tests: cost.box_tests,
            }
        };
        tape.events.iter().enumerate().map(step).collect()
    }

    fn page(&self) -> Page {
        let Walked { scene, rule, structure, ray, tape, hit } = self;
        let mut steps = self.steps();
        // As in the window: what a flat scene has in z is no step.
        steps.retain(|step| {
            !scene.flat || tape.events.get(step.step - 1).is_none_or(|event| !Event::Walk(*event).concerns_z())
        });
        let mut page = Page::default();
        page.heading(format!(
            "{}: {}. {}: {}, {}",
            scene.name,
            counted(raystep_accel::Primitives::len(&scene.prims) as u64, "primitive", "primitives"),
            kind_name(rule.kind()),
            counted(structure.node_count() as u64, "node or cell", "nodes or cells"),
            counted(structure.bytes() as u64, "byte", "bytes"),
        ));
        let parameters: Vec<String> = rule.parameters().iter().map(|p| format!("{}={}", p.key, p.value)).collect();
        if !parameters.is_empty() {
            page.text(format!("Built with {}.", parameters.join(" ")));
        }
        let point = |p: glam::DVec3| p.to_array().map(|x| number(x as f32)).join(", ");
        let moved = scene.origin != glam::DVec3::ZERO;
        // Where all lies far off, as many digits as tell places of the mesh apart.
        let place = |p: glam::Vec3| {
            let (near, far) = (p.as_dvec3(), scene.moved_back(p));
            let axis = |axis: usize| spelt(far[axis], near[axis]);
            if moved { [0, 1, 2].map(axis).join(", ") } else { point(far) }
        };
        if moved {
            let [x, y, z] = scene.origin.to_array();
            page.text(format!(
                "The steps count coordinates from ({x}, {y}, {z}), so that single precision tells them apart."
            ));
        }
        page.text(format!(
            "The ray starts at ({}) and runs along ({}); t counts from {} to {}.",
            place(ray.o),
            point(ray.d.as_dvec3()),
            number(ray.t_min),
            number(ray.t_max),
        ));
        let mut grid = Grid::new([("step", Align::Right), ("event", Align::Left), ("what happens", Align::Left)]);
        let cut = steps.len() > LONGEST;
        for (index, step) in steps.iter().enumerate() {
            if cut && (ENDS..steps.len() - ENDS).contains(&index) {
                if index == ENDS {
                    let left = whole((steps.len() - 2 * ENDS) as u64);
                    let says = format!("{left} steps are left out here; --format csv and --format json have them all.");
                    grid.row(["…".to_owned(), String::new(), says]);
                }
                continue;
            }
            grid.row([whole(step.step as u64), step.event.to_owned(), step.says.clone()]);
        }
        page.table(grid);
        if tape.lost > 0 {
            let more = counted(tape.lost, "event more", "events more");
            page.text(format!("Not kept: {more} that happened."));
        }
        page.text(match hit {
            Some(hit) => {
                format!("The ray hits primitive {} at t = {}, at ({}).", hit.prim, number(hit.t), place(ray.at(hit.t)))
            }
            None => "The ray hits nothing.".to_owned(),
        });
        let mut cost = Cost::default();
        structure.intersect(&scene.prims, ray, &mut cost);
        let counts = [
            counted(cost.prim_tests, "test of a primitive", "tests of primitives"),
            counted(cost.node_visits, "node visited", "nodes visited"),
            counted(cost.cell_steps, "cell entered", "cells entered"),
            counted(cost.box_tests, "volume tested", "volumes tested"),
        ];
        page.text(format!("Counted: {}.", counts.join(", ")));
        page
    }
}

/// A coordinate with so many digits that four of its part `near` the mesh are told.
fn spelt(far: f64, near: f64) -> String {
    let size = if near == 0.0 { 0 } else { libm::floor(libm::log10(near.abs())) as i32 };
    let digits = format!("{far:.*}", (3 - size).clamp(0, 12) as usize);
    let trimmed = if digits.contains('.') { digits.trim_end_matches('0').trim_end_matches('.') } else { &digits };
    trimmed.to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_far_off_keep_the_digits_that_tell_them_apart() {
        let check = |far: f64, near: f64, says: &str| assert_eq!(spelt(far, near), says);
        check(465812.4, -0.1, "465812.4");
        check(5247903.70, 0.2, "5247903.7");
        check(412.5, 0.0, "412.5");
        check(5247903.123456, 0.123456, "5247903.1235");
        check(1e12 + 2048.0, 2048.0, "1000000002048");
    }
}
