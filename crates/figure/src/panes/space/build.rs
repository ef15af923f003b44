//! What a builder has done so far, in space.

use std::collections::BTreeSet;

use glam::Vec3;
use raystep_accel::{Aabb, Axis, CellId, Direction, FreePlane, Grow, NodeId, Place, PrimId, Primitives, Structure};

use super::layer::Layer;
use super::numbers::numbers_of;
use crate::moments::{Build, Fate, GrowMoment, GrowNode};
use crate::panes::tree::node_role;
use crate::theme::Role;
use crate::words::{VolumeName, coordinate, counted, number};
use crate::world::{Depth, Form, Space, SpaceMark, convex, drawn, frontier};

/// Most boxes of nodes in one picture.
const BOXES: usize = 300;

/// Of the way to the current node in space, so many levels, and of what waits so many nodes.
const LEVELS: usize = 3;
const NEXT: usize = 3;

/// Of a finished tree in space, so many levels.
const UPPER: u32 = 3;

/// Most cells of a grid in one picture.
const CELLS: usize = 1024;

/// Of the cells that the box of a primitive meets, most that are drawn in space.
const MET: usize = 48;

/// Most sets on a curve that is drawn.
const CURVE: usize = 400;

/// Most weighed splits in one picture.
const TICKS: usize = 120;

/// Space at a moment of a build; of a tree in a solid scene, the end of the way down.
pub fn space_of_build(build: &Build<'_>, moment: &GrowMoment) -> Space {
    space_of_build_to(build, moment, Depth::Path)
}

/// The same, with as many boxes of a tree in a solid scene as asked for.
pub fn space_of_build_to(build: &Build<'_>, moment: &GrowMoment, depth: Depth) -> Space {
    let bounds = build.nodes.reach();
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

    /// The planes that an open question offers.
    fn guesses(&mut self) {
        let Some((id, node)) = self.moment.node.and_then(|id| self.moment.nodes.get_key_value(&id)) else { return };
        for (axis, plane, text) in &self.moment.guesses {
            let Some(axis) = axis.axis() else { continue };
            let sheet = sheet(&node.bounds, axis, *plane);
            self.add(Role::Guess, Some(Place::Node(*id)), Form::Sheet(sheet));
            let form = Form::Label { at: sheet.center(), within: None, text: text.clone() };
            self.add(Role::Guess, Some(Place::Node(*id)), form);
        }
    }

    /// All cells while they are few; those that hold something; those of the current primitive.
    fn cells(&mut self) {
        let (Some(grid), count @ 1..) = (self.build.structure.grid(), self.moment.cell_count) else { return };
        let outline = |role, cell: CellId| SpaceMark {
            form: Form::Box(grid.cell_bounds(cell)),
            role,
            place: Some(Place::Cell(cell)),
        };
        let filled = |cell: CellId| self.moment.cells.contains_key(&cell);
        if self.build.flat && count as usize <= CELLS {
            let role = |cell| if filled(cell) { Role::Filled } else { Role::Edge };
            self.marks.extend((0..count).map(CellId).map(|cell| outline(role(cell), cell)));
        }
        if !self.build.flat {
            let layer = Layer::middle(grid.lattice());
            self.notes.push(layer.to_string());
            self.marks.extend(layer.marks(self.moment.cells.keys().copied()));
        }
        if let Some(Grow::Refine { cell, .. }) = self.moment.event {
            self.marks.push(outline(Role::Here, cell));
        }
        // Of a large flat grid only the cells that are filled are drawn.
        if self.build.flat && count as usize > CELLS {
            let filled = self.moment.cells.keys().rev().take(CELLS);
            self.marks.extend(filled.map(|cell| outline(Role::Seen, *cell)));
        }
        // Of very many in space, those around the next one to be decided.
        let met = &self.moment.rasterised;
        let most = if self.build.flat { usize::MAX } else { MET };
        let next = met.iter().position(|(_, fate)| *fate == Fate::Open).unwrap_or(met.len());
        let from = next.saturating_sub(most / 2).min(met.len().saturating_sub(most));
        if met.len() > most {
            self.notes.push(format!("its box meets {} cells, not all drawn", met.len()));
        }
        for &(cell, fate) in met.iter().skip(from).take(most) {
            let role = match fate {
                Fate::Open => Role::Waiting,
                Fate::Stored => Role::Here,
                Fate::Pruned => Role::Dropped,
            };
            self.marks.push(outline(role, cell));
            if self.build.flat {
                let form = Form::Number { within: grid.cell_bounds(cell), text: cell.to_string() };
                let role = if role == Role::Dropped { Role::Quiet } else { role };
                self.marks.push(SpaceMark { form, role, place: Some(Place::Cell(cell)) });
            }
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
            // stands out.
            let repeats = role == Role::Seen && node.children.iter().all(|child| self.moment.nodes.contains_key(child));
            let repeats = repeats && !node.children.is_empty() && !lowest.contains(&id);
            let role = if repeats { Role::Edge } else { role };
            // What a leaf refers to tints it; the volumes of a hierarchy are never empty.
            let filled = node.leaf.is_some() && node.prims > 0 && !matches!(self.build.structure, Structure::Bvh(_));
            if self.build.flat && filled {
                for form in self.build.nodes.look(self.build.structure, id, node.bounds, true) {
                    self.add(Role::Filled, Some(Place::Node(id)), form);
                }
            }
            // Nodes that are not yet in the tree have numbers beyond its own, and only a box.
            for form in self.build.nodes.look(self.build.structure, id, node.bounds, self.build.flat) {
                self.add(role, Some(Place::Node(id)), form);
            }
        }
    }

    /// The line through the middles of the sets in the order of their codes, and which neighbour each has chosen.
    fn curve(&mut self) {
        let (moment, flat) = (self.moment, self.build.flat);
        if moment.curve.is_empty() || moment.curve.len() > CURVE {
            if !moment.curve.is_empty() {
                self.notes.push(format!("a curve through {} sets, not drawn", moment.curve.len()));
            }
            return;
        }
        let seen = |at: Vec3| if flat { at.with_z(0.0) } else { at };
        for pair in moment.curve.windows(2) {
            let place = Some(Place::Node(pair[1].0));
            self.add(Role::Line, place, Form::Segment(seen(pair[0].1), seen(pair[1].1)));
        }
        let middle = |node: NodeId| moment.curve.iter().find(|(own, _)| *own == node).map(|(_, at)| seen(*at));
        for (node, nearest) in &moment.preferred {
            if let (Some(from), Some(to)) = (middle(*node), middle(*nearest)) {
                // Not quite to the middle: two that chose each other have two heads.
                self.add(Role::Candidate, Some(Place::Node(*node)), Form::Arrow(from, from.lerp(to, 0.8)));
            }
        }
        for (node, at) in &moment.curve {
            self.add(Role::Tick, Some(Place::Node(*node)), Form::Point(seen(*at)));
        }
        if let Some(Grow::Rank { node, rank, first, second, third, x, y, z }) = moment.event {
            let text = format!("{}: code {first}{second}{third}…", rank + 1);
            let form = Form::Label { at: seen(Vec3::new(x, y, z)), within: None, text };
            self.add(Role::Tick, Some(Place::Node(node)), form);
        }
    }

    /// The nodes that a split has named and that are still to be built. In space the next few; a kd-tree's are halves, and
    /// an octree's all alike.
    fn waiting(&mut self) {
        let (build, moment) = (self.build, self.moment);
        if !build.flat && matches!(build.structure, Structure::Kd(_) | Structure::Octree(_)) {
            return;
        }
        let fresh = moment.waiting.iter().rev().filter(|id| !moment.nodes.contains_key(id));
        for &id in fresh.take(if build.flat { BOXES } else { NEXT }) {
            let named = moment.nodes.iter().find(|(_, node)| node.children.contains(&id));
            // Some builders number their nodes anew in the end: then nobody knows yet where it will lie.
            let known = named.filter(|(parent, node)| build.structure.children(**parent) == node.children);
            let bounds = build.nodes.bounds(id);
            // Over their parent they would only double what its plane says; a hierarchy has none.
            let plain = !matches!(build.structure, Structure::Bvh(_));
            let over = plain && known.is_some_and(|(parent, _)| moment.node == Some(*parent));
            if known.is_none() || over || bounds.is_empty() {
                continue;
            }
            for form in build.nodes.look(build.structure, id, bounds, build.flat) {
                self.add(Role::Waiting, Some(Place::Node(id)), form);
            }
            if build.flat {
                self.add(Role::Waiting, Some(Place::Node(id)), Form::Number { within: bounds, text: id.to_string() });
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
        if deepest > 0 && !moment.nodes.is_empty() {
            self.notes.push(drawn(VolumeName::drawn(self.build.structure), self.depth(), deepest));
        }
        way
    }

    /// The boxes of the level that is asked for, and of the leaves above it.
    fn lowest(&self) -> BTreeSet<NodeId> {
        let nodes = &self.moment.nodes;
        let children = |id: NodeId| nodes.get(&id).map(|node| node.children.clone()).unwrap_or_default();
        match self.depth() {
            Depth::Down(level) if nodes.contains_key(&NodeId::ROOT) => {
                frontier(level as usize, BOXES, children).into_iter().collect()
            }
            _ => BTreeSet::new(),
        }
    }

    /// How many boxes are drawn: once nothing is under consideration any more, those of the upper levels instead of
    /// the path.
    fn depth(&self) -> Depth {
        let finished = matches!(self.moment.event, Some(Grow::End { .. }));
        match self.depth {
            // A node of an octree has as many children as three levels of two have leaves.
            Depth::Path if finished && matches!(self.build.structure, Structure::Octree(_)) => Depth::Down(1),
            Depth::Path if finished => Depth::Down(UPPER.min(self.build.nodes.levels().deepest() as u32)),
            depth => depth,
        }
    }

    /// In space, the halves of split nodes whose turn has not come: what the plane leaves of them. In a hierarchy nobody knows
    /// yet.
    fn halves(&mut self) {
        let Structure::Kd(_) = self.build.structure else { return };
        if self.build.flat {
            return;
        }
        let moment = self.moment;
        let path = moment.path();
        for node in path.iter().rev().take(LEVELS).filter_map(|id| moment.nodes.get(id)) {
            let Some((taken, axis)) = node.split.and_then(|taken| Some((taken, taken.axis.axis()?))) else { continue };
            let (mut below, mut above) = (node.bounds, node.bounds);
            below.max[axis] = taken.plane;
            above.min[axis] = taken.plane;
            for (id, half) in [(taken.below, below), (taken.above, above)] {
                if moment.waiting.contains(&id) && !moment.nodes.contains_key(&id) {
                    self.add(Role::Waiting, Some(Place::Node(id)), Form::Box(half));
                }
            }
        }
    }

    /// The splits weighed for the current node as ticks at its edges, the one at hand as a whole plane.
    fn splits(&mut self) {
        let Some((id, node)) = self.moment.node.and_then(|id| self.moment.nodes.get_key_value(&id)) else { return };
        let place = Some(Place::Node(*id));
        let every = self.moment.weighed.len().div_ceil(TICKS).max(1);
        // Once the node is split, what else was weighed covers no primitives any more.
        for weighed in self.moment.weighed.iter().step_by(every).filter(|_| node.split.is_none()) {
            let Some(axis) = weighed.axis.axis() else { continue };
            for (from, to) in ticks(&node.bounds, axis, weighed.plane) {
                self.add(Role::Candidate, place, Form::Segment(from, to));
            }
        }
        let flat = self.build.flat;
        let cell = if let Structure::Bsp(tree) = self.build.structure { Some(tree.cell(*id)) } else { None };
        let sheet = |across: Direction, plane: f32, free: Option<FreePlane>| match &cell {
            Some(cell) => convex::sheet(cell, free?, flat),
            None => Some(Form::Sheet(sheet(&node.bounds, across.axis()?, plane))),
        };
        if let Some(sheet) = node.split.and_then(|taken| sheet(taken.axis, taken.plane, taken.free)) {
            self.add(Role::Plane, place, sheet);
        }
        match self.moment.event {
            // A proposed plane, its normal, and who proposed it.
            Some(Grow::Normal { plane, from, .. }) => {
                if let Place::Prim(prim) = from {
                    self.add(Role::Here, Some(from), Form::Prim(prim));
                }
                let free = self.moment.free.zip(cell.as_ref());
                let forms =
                    free.map(|(free, cell)| [convex::sheet(cell, free, flat), convex::normal(cell, free, flat)]);
                for form in forms.into_iter().flatten().flatten() {
                    self.add(Role::Candidate, place, form);
                }
                self.title(Role::Candidate, *id, node.bounds, format!("proposed: n · p = {}", number(plane)));
            }
            Some(Grow::Weigh { axis, plane, below, above, cost, .. }) => {
                if let Some(sheet) = sheet(axis, plane, self.moment.free) {
                    self.add(Role::Candidate, place, sheet);
                }
                self.title(
                    Role::Candidate,
                    *id,
                    node.bounds,
                    format!("{below} below, {above} above: cost {}", number(cost)),
                );
            }
            // The lines that cut a cell into equal ones.
            Some(Grow::Divide { at_x, at_y, at_z, .. }) => {
                for (axis, at) in [(Axis::X, at_x), (Axis::Y, at_y), (Axis::Z, at_z)] {
                    if !(flat && axis == Axis::Z) {
                        self.add(Role::Plane, place, Form::Sheet(self::sheet(&node.bounds, axis, at)));
                    }
                }
                self.title(Role::Here, *id, node.bounds, format!("node {id}: cut into {} cells", node.children.len()));
            }
            Some(Grow::Split { axis, plane, .. }) => {
                let cut = if VolumeName::of(self.build.structure).cut == "way" { "shared out" } else { "cut" };
                let text = format!("node {id}: {cut} at {} = {}", coordinate(axis), number(plane));
                self.title(Role::Here, *id, node.bounds, text);
            }
            _ => {
                let count = counted(u64::from(node.prims), "primitive", "primitives");
                self.title(Role::Here, *id, node.bounds, format!("node {id}: {count}"));
            }
        }
    }
}

/// The part of a plane across `axis` that lies in a box.
fn sheet(bounds: &Aabb, axis: Axis, plane: f32) -> Aabb {
    let mut sheet = *bounds;
    sheet.min[axis] = plane;
    sheet.max[axis] = plane;
    sheet
}

/// The edges of a box; of its rectangle in a flat scene.
fn edges(bounds: &Aabb, flat: bool) -> impl Iterator<Item = (Vec3, Vec3)> {
    let corner = |index: usize| {
        let side = |axis: Axis| if index >> axis.index() & 1 == 0 { bounds.min[axis] } else { bounds.max[axis] };
        Vec3::new(side(Axis::X), side(Axis::Y), side(Axis::Z))
    };
    let (corners, axes) = if flat { (4, 2) } else { (8, 3) };
    let from = (0..corners).flat_map(move |index| (0..axes).map(move |axis| (index, index | 1 << axis)));
    from.filter(|(from, to)| from != to).map(|(from, to)| (corner(from), corner(to))).collect::<Vec<_>>().into_iter()
}

/// Short lines at the two sides of a box that a plane across `axis` would cut.
fn ticks(bounds: &Aabb, axis: Axis, plane: f32) -> [(Vec3, Vec3); 2] {
    let along = if axis == Axis::Y { Axis::X } else { Axis::Y };
    let length = 0.05 * bounds.extent()[along];
    let at = |value: f32| {
        let mut at = bounds.center();
        at[axis] = plane;
        at[along] = value;
        at
    };
    let (low, high) = (bounds.min[along], bounds.max[along]);
    [(at(low), at(low + length)), (at(high - length), at(high))]
}
