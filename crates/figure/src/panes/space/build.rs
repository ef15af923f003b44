//! What a builder has done so far, in space.

mod cells;
mod curve;
mod cuts;

use std::collections::BTreeSet;

use glam::Vec3;
use raystep_accel::{Aabb, Grow, NodeId, Place, PrimId, Primitives, Structure};

use super::numbers::numbers_of;
use crate::moments::{Build, GrowMoment, GrowNode};
use crate::panes::tree::node_role;
use crate::theme::Role;
use crate::words::{VolumeName, number};
use crate::world::{Depth, Form, Space, SpaceMark, drawn, frontier};

/// Most boxes of nodes in one picture.
const BOXES: usize = 300;

/// Of the way to the current node in space, so many levels, and of what waits so many nodes.
const LEVELS: usize = 3;
const NEXT: usize = 3;

/// Beside so many boxes none that wait are drawn of an octree in space: with eight children each they soon are a tangle.
const WIRES: usize = 20;

/// Of a finished tree in space, so many levels.
const UPPER: u32 = 3;

/// Space at a moment of a build; of a tree in a solid scene, the end of the way down.
pub fn space_of_build(build: &Build<'_>, moment: &GrowMoment) -> Space {
    space_of_build_to(build, moment, Depth::Path)
}

/// The same, with as many boxes of a tree in a solid scene as asked for.
pub fn space_of_build_to(build: &Build<'_>, moment: &GrowMoment, depth: Depth) -> Space {
    let bounds = build.nodes.reach();
    let depth = depth_of_build(build, moment, depth);
    let mut drawing = Drawing { build, moment, depth, marks: Vec::new(), notes: Vec::new() };
    drawing.the_box();
    drawing.cells();
    drawing.halves();
    drawing.nodes();
    drawing.changes();
    drawing.waiting();
    drawing.curve();
    drawing.shared();
    drawing.splits();
    drawing.current();
    drawing.guesses();
    if build.flat {
        let best =
            |prim: PrimId| drawing.marks.iter().any(|mark| mark.role == Role::Best && mark.form == Form::Prim(prim));
        let numbers = numbers_of(build.prims, |prim| if best(prim) { Role::Best } else { Role::Text });
        drawing.marks.extend(numbers);
    }
    let margin = 0.03 * if bounds.is_empty() { 0.0 } else { bounds.extent().length() };
    let mut bounds = bounds.padded(margin);
    // What a tree is cut by, or where its sets lie, is said in coordinates.
    if build.flat && build.structure.node_count() > 0 {
        drawing.add(Role::Edge, None, Form::Axes(bounds));
        bounds = super::with_axes(bounds);
    }
    Space { marks: drawing.marks, bounds, flat: build.flat, notes: drawing.notes }
}

struct Drawing<'a> {
    build: &'a Build<'a>,
    moment: &'a GrowMoment,
    depth: Depth,
    marks: Vec<SpaceMark>,
    notes: Vec<String>,
}

impl Drawing<'_> {
    fn add(&mut self, role: Role, place: Option<Place>, form: Form) {
        self.marks.push(SpaceMark { form, role, place });
    }

    /// A label in a corner of a node's box.
    fn title(&mut self, role: Role, node: NodeId, bounds: Aabb, text: String) {
        let form = Form::Label { at: bounds.center(), within: Some(bounds), text };
        self.add(role, Some(Place::Node(node)), form);
    }

    /// The box around the primitives, and while it grows, which of them set its sides.
    fn the_box(&mut self) {
        let moment = self.moment;
        if moment.bounds.is_empty() {
            return;
        }
        // Until the first cell is filled, the first plane proposed or weighed, or the first sets are joined.
        let tally = &moment.tally;
        let grows = tally.rasterised == 0
            && moment.free.is_none()
            && tally.weighed == 0
            && tally.taken == 0
            && tally.joined == 0;
        self.add(if grows { Role::Here } else { Role::Edge }, Some(Place::World), Form::Box(moment.bounds));
        if !grows {
            return;
        }
        let axes = if self.build.flat { 2 } else { 3 };
        let mut setters: Vec<PrimId> =
            (0..6).filter(|side| side % 3 < axes).filter_map(|side| moment.sides[side]).collect();
        setters.sort();
        setters.dedup();
        for prim in setters {
            self.add(Role::Best, Some(Place::Prim(prim)), Form::Prim(prim));
        }
        if !moment.nodes.is_empty() {
            return;
        }
        let sides = moment.bounds.extent().to_array();
        let text = sides[..axes].iter().map(|side| number(*side)).collect::<Vec<_>>().join(" × ");
        let form = Form::Label { at: moment.bounds.center(), within: Some(moment.bounds), text };
        self.add(Role::Here, Some(Place::World), form);
    }

    /// The primitive under consideration; in a drawing, with its number.
    fn current(&mut self) {
        let Some(prim) = self.moment.prim else { return };
        self.add(Role::Here, Some(Place::Prim(prim)), Form::Prim(prim));
        let bounds = self.build.prims.bounds(prim);
        // The cells are those that its box meets.
        if !self.moment.rasterised.is_empty() {
            for (from, to) in edges(&bounds, self.build.flat) {
                self.add(Role::Ray, Some(Place::Prim(prim)), Form::Segment(from, to));
            }
        }
        let form = Form::Label { at: bounds.center(), within: Some(bounds), text: format!("primitive {prim}") };
        self.add(Role::Value, Some(Place::Prim(prim)), form);
    }

    /// The primitives on both sides of the split just taken.
    fn shared(&mut self) {
        for prim in self.moment.shared.iter().rev().take(BOXES) {
            self.add(Role::Hit, Some(Place::Prim(*prim)), Form::Prim(*prim));
        }
    }

    /// What the change at hand has touched so far, and the primitives that are not in the structure.
    fn changes(&mut self) {
        let (build, moment) = (self.build, self.moment);
        for prim in build.coming(moment) {
            self.add(Role::Waiting, Some(Place::Prim(prim)), Form::Prim(prim));
        }
        for prim in build.gone(moment) {
            self.add(Role::Dropped, Some(Place::Prim(prim)), Form::Prim(prim));
        }
        let Some(change) = build.change(moment) else { return };
        for id in build.touched(moment, change) {
            let Some(node) = moment.nodes.get(&id) else { continue };
            self.add(Role::Plane, Some(Place::Node(id)), Form::Box(node.bounds));
        }
        let prim = change.change.prim();
        // Where it is gone it is drawn as such.
        if !build.gone(moment).contains(&prim) {
            self.add(Role::Here, Some(Place::Prim(prim)), Form::Prim(prim));
        }
    }

    /// The boxes of the nodes, those being split or waiting for it above all others.
    fn nodes(&mut self) {
        // Of very many, the uppermost.
        let mut depths = vec![0; 1 + self.moment.nodes.values().map(|node| node.depth as usize).max().unwrap_or(0)];
        for node in self.moment.nodes.values() {
            depths[node.depth as usize] += 1;
        }
        let mut room = BOXES;
        let deepest = depths.iter().position(|&count| {
            let full = count > room;
            room = room.saturating_sub(count);
            full
        });
        let high = |node: &GrowNode| deepest.is_none_or(|deepest| (node.depth as usize) < deepest);
        let lowest = if self.build.flat { BTreeSet::new() } else { self.lowest() };
        let way = if self.build.flat { None } else { Some(self.way(&lowest)) };
        let is_shown = |id: &NodeId, node: &GrowNode| match &way {
            Some(way) => way.contains(id),
            None => high(node),
        };
        let shown = self.moment.nodes.iter().filter(|(id, node)| is_shown(id, node));
        let rest = self.moment.node.and_then(|id| self.moment.nodes.get_key_value(&id));
        for (&id, node) in shown.chain(rest) {
            let role = node_role(self.moment, id);
            // Boxes of split nodes only repeat what their children show, unless those are not shown; the current one
            // stands out. A volume is more than those in it: in a drawing a grey one would be taken for a primitive.
            let tree = matches!(self.build.structure, Structure::Bvh(_));
            let repeats = role == Role::Seen && node.children.iter().all(|child| self.moment.nodes.contains_key(child));
            let alone = node.children.is_empty() || lowest.contains(&id) || tree && self.build.flat;
            let repeats = repeats && !alone;
            let role = if repeats { Role::Edge } else { role };
            // What a leaf refers to tints it; the volumes of a hierarchy are never empty.
            let filled = node.leaf.is_some() && node.prims > 0 && !tree;
            if self.build.flat && filled {
                for form in self.build.nodes.look(self.build.structure, id, node.bounds, true) {
                    self.add(Role::Filled, Some(Place::Node(id)), form);
                }
            }
            for form in self.build.look(self.moment, id, node.bounds) {
                self.add(role, Some(Place::Node(id)), form);
            }
        }
    }

    /// The nodes that a split has named and that are still to be built. In space the next few; a kd-tree's are halves.
    fn waiting(&mut self) {
        let (build, moment) = (self.build, self.moment);
        if !build.flat && matches!(build.structure, Structure::Kd(_)) {
            return;
        }
        let fresh = moment.waiting.iter().rev().filter(|id| !moment.nodes.contains_key(id));
        let most = match build.structure {
            _ if build.flat => BOXES,
            Structure::Octree(_) => NEXT.min(WIRES.saturating_sub(self.marks.len())),
            _ => NEXT,
        };
        for &id in fresh.take(most) {
            let named = moment.nodes.iter().find(|(_, node)| node.children.contains(&id));
            // Some builders number their nodes anew in the end: then nobody knows yet where it will lie.
            let known = named.filter(|(parent, node)| build.structure.children(**parent) == node.children);
            let bounds = build.nodes.bounds(id);
            // Over their parent their outlines would only double what its plane says; a hierarchy has none.
            let plain = !matches!(build.structure, Structure::Bvh(_));
            let over = plain && known.is_some_and(|(parent, _)| moment.node == Some(*parent));
            if known.is_none() || bounds.is_empty() || over && !build.flat {
                continue;
            }
            for form in build.nodes.look(build.structure, id, bounds, build.flat) {
                if over {
                    // Below all others, for the number to find its part.
                    self.marks.insert(0, SpaceMark { form, role: Role::Edge, place: Some(Place::Node(id)) });
                    continue;
                }
                let form = if plain && !build.flat { form.apart(&bounds, &moment.bounds) } else { form };
                self.add(Role::Waiting, Some(Place::Node(id)), form);
            }
            if build.flat {
                self.add(
                    Role::Waiting,
                    Some(Place::Node(id)),
                    Form::Number { within: bounds, text: id.to_string(), scale: 1.0 },
                );
            }
        }
    }

    /// Of a tree in space: the current node, the last few it came from with what they were split into, the next few
    /// that wait, the box around everything, and the level that is asked for.
    fn way(&mut self, lowest: &BTreeSet<NodeId>) -> BTreeSet<NodeId> {
        let moment = self.moment;
        let children = |id: NodeId| moment.nodes.get(&id).map(|node| node.children.clone()).unwrap_or_default();
        let path = moment.path();
        let mut way: BTreeSet<NodeId> = path.iter().rev().take(LEVELS).copied().collect();
        for &id in path.iter().rev().skip(1).take(LEVELS) {
            way.extend(children(id));
        }
        way.extend(path.last().into_iter().flat_map(|&id| children(id)));
        way.extend(path.first());
        way.extend(moment.waiting.iter().rev().take(NEXT));
        way.extend(lowest);
        let deepest = self.build.nodes.levels().deepest();
        let reached = moment.nodes.values().map(|node| node.depth).max().unwrap_or(0);
        if deepest > 0 && !moment.nodes.is_empty() {
            let depth = match self.depth {
                // A finished tree has all levels, however it was built.
                Depth::Down(level) if !is_finished(self.moment) => Depth::Down(level.min(reached)),
                depth => depth,
            };
            self.notes.push(drawn(VolumeName::drawn(self.build.structure), depth, deepest));
        }
        way
    }

    /// The boxes of the level that is asked for, and of the leaves above it.
    fn lowest(&self) -> BTreeSet<NodeId> {
        let nodes = &self.moment.nodes;
        let children = |id: NodeId| nodes.get(&id).map(|node| node.children.clone()).unwrap_or_default();
        match self.depth {
            Depth::Down(level) if nodes.contains_key(&NodeId::ROOT) => {
                frontier(level as usize, BOXES, children).into_iter().collect()
            }
            _ => BTreeSet::new(),
        }
    }
}

fn is_finished(moment: &GrowMoment) -> bool {
    matches!(moment.event, Some(Grow::End { .. }))
}

/// How many boxes are drawn where so many are asked for: once nothing is under consideration any more, those of the
/// upper levels instead of the path.
pub(crate) fn depth_of_build(build: &Build<'_>, moment: &GrowMoment, depth: Depth) -> Depth {
    let finished = is_finished(moment);
    match depth {
        // A node of an octree has as many children as three levels of two have leaves.
        Depth::Path if finished && matches!(build.structure, Structure::Octree(_)) => Depth::Down(1),
        Depth::Path if finished => Depth::Down(UPPER.min(build.nodes.levels().deepest() as u32)),
        depth => depth,
    }
}

/// The edges of a box; of its rectangle in a flat scene.
fn edges(bounds: &Aabb, flat: bool) -> impl Iterator<Item = (Vec3, Vec3)> {
    let corners = bounds.corners();
    let (count, axes) = if flat { (4, 2) } else { (8, 3) };
    let from = (0..count).flat_map(move |index| (0..axes).map(move |axis| (index, index | 1 << axis)));
    from.filter(|(from, to)| from != to).map(move |(from, to)| (corners[from], corners[to]))
}
