//! A walk in an instance's own space, set back into the world where the instance stands.

use std::collections::BTreeMap;

use raystep_accel::{Aabb, Hit, Instances, NodeId, Place, PrimId, Prims, Structure, Visit};

use super::Drawing;
use crate::moments::Inside;
use crate::theme::Role;
use crate::words::number;
use crate::world::Form;

/// Of what waits in the instance, so many nodes.
const NEXT: usize = 4;

/// Of the primitives tested there, so many of the last.
const TRAIL: usize = 256;

impl Drawing<'_> {
    /// The instance entered, the node where the walk stands in it, and what was tested there.
    pub(super) fn inside(&mut self, inside: &Inside, event: Option<Visit>) {
        let Prims::Instances(all) = self.walk.prims else { return };
        let (instance, moment) = (inside.instance, &inside.moment);
        let place = Place::Prim(instance);
        let role = if moment.here.is_some() { Role::Seen } else { Role::Here };
        self.outline(role, place);
        self.title(role, place, format!("instance {instance}"));
        for waiting in moment.stack.iter().rev().take(NEXT).rev() {
            self.placed(all, instance, waiting.node, Role::Waiting, None);
        }
        if let Some(Place::Node(node)) = moment.here {
            self.placed(all, instance, node, Role::Here, Some(format!("{node} in it")));
            for &prim in all.model(instance).structure.leaf_prims(node).iter().take(TRAIL) {
                self.triangle(all, instance, prim, Role::Seen);
            }
        }
        let tested = moment.tested.iter().skip(moment.tested.len().saturating_sub(TRAIL));
        let roles = tested.map(|test| (test.prim, if test.t.is_some() { Role::Hit } else { Role::Missed }));
        for (prim, role) in roles.collect::<BTreeMap<_, _>>() {
            self.triangle(all, instance, prim, role);
        }
        match event {
            Some(Visit::Test { t, hit: true, .. }) => {
                self.ring(Role::Hit, Some(place), t, Some(format!("t = {}", number(t))));
            }
            Some(Visit::Volume { t_near, t_far, .. } | Visit::Local { t_near, t_far, .. }) if t_near <= t_far => {
                self.ring(Role::Tick, Some(place), t_near, Some(format!("t_near = {}", number(t_near))));
                self.ring(Role::Tick, Some(place), t_far, Some(format!("t_far = {}", number(t_far))));
            }
            _ => {}
        }
    }

    /// Instances are met by way of what they place: their boxes are outlines, and of the nearest hit the triangle.
    pub(super) fn instances(&mut self, all: &Instances) {
        for test in self.moment.tested.iter().rev().take(TRAIL) {
            let role = if test.t.is_some() { Role::Seen } else { Role::Dropped };
            self.outline(role, Place::Prim(test.prim));
        }
        if let Some(Hit { prim, inner: Some(inner), .. }) = self.moment.best {
            self.triangle(all, prim, inner, Role::Best);
        }
    }

    /// A node of the model as it stands in the world.
    fn placed(&mut self, all: &Instances, instance: PrimId, node: NodeId, role: Role, text: Option<String>) {
        let own = match &all.model(instance).structure {
            Structure::Bvh(tree) => tree.outline(node).bounds(),
            other => other.node_bounds().get(node.index()).copied().unwrap_or(Aabb::EMPTY),
        };
        if own.is_empty() {
            return;
        }
        let world = all.placed()[instance.index()].world_from_local;
        let corners = own.corners().map(|corner| world.point(corner));
        let edge = |index: usize| {
            [1, 2, 4]
                .into_iter()
                .filter(move |bit| index & bit == 0)
                .map(move |bit| [corners[index], corners[index | bit]])
        };
        let place = Some(Place::Prim(instance));
        self.add(role, place, Form::Body((0..8).flat_map(edge).collect()));
        if let Some(text) = text {
            let bounds = world.bounds(&own);
            self.add(role, place, Form::Label { at: bounds.center(), within: Some(bounds), text });
        }
    }

    fn triangle(&mut self, all: &Instances, instance: PrimId, inner: PrimId, role: Role) {
        let triangle = all.triangle(instance, inner);
        self.add(role, Some(Place::Prim(instance)), Form::Polygon(vec![triangle.a, triangle.b, triangle.c]));
    }
}
