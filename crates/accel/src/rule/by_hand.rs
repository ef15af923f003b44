//! Cuts that are chosen by hand, for a few nodes: a builder takes them whatever they cost.

use std::fmt;

use crate::{Aabb, Axis, NodeId};

/// Where a node shall be cut. A tree of planes is cut there; a hierarchy shares out its list of primitives there, by
/// their centres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HandCut {
    /// The node.
    pub node: NodeId,
    /// Across this axis.
    pub axis: Axis,
    /// At this coordinate.
    pub at: f32,
}

impl HandCut {
    /// Whether it goes through a box: a plane in a face of it cuts nothing.
    pub fn divides(&self, bounds: &Aabb) -> bool {
        bounds.min[self.axis] < self.at && self.at < bounds.max[self.axis]
    }

    /// As a rule spells it: `0:x=2.09`.
    fn read(text: &str) -> Option<HandCut> {
        let (node, plane) = text.trim().split_once(':')?;
        let (axis, at) = plane.split_once('=')?;
        let axis = Axis::ALL.into_iter().find(|known| known.to_string() == axis.trim())?;
        let at = at.trim().parse().ok().filter(|at: &f32| at.is_finite())?;
        Some(HandCut { node: NodeId(node.trim().parse().ok()?), axis, at })
    }
}

impl fmt::Display for HandCut {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}={}", self.node.0, self.axis, self.at)
    }
}

/// The cuts that are chosen by hand, one for a node, in the order of the nodes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ByHand {
    cuts: [Option<HandCut>; ByHand::MOST],
}

impl ByHand {
    /// The most of them.
    pub const MOST: usize = 8;

    /// All of them.
    pub fn cuts(&self) -> impl Iterator<Item = HandCut> + '_ {
        self.cuts.iter().copied().flatten()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.cuts().next().is_none()
    }

    /// The cut of a node, if one was chosen.
    pub fn of(&self, node: NodeId) -> Option<HandCut> {
        self.cuts().find(|cut| cut.node == node)
    }

    /// The same with another cut, in the place of the node's own; nothing if they become too many.
    #[must_use]
    pub fn with(&self, cut: HandCut) -> Option<ByHand> {
        let others = self.cuts().filter(|other| other.node != cut.node);
        ByHand::of_all(others.chain([cut]))
    }

    /// The same without some.
    #[must_use]
    pub fn without(&self, gone: impl Fn(NodeId) -> bool) -> ByHand {
        ByHand::of_all(self.cuts().filter(|cut| !gone(cut.node))).unwrap_or_default()
    }

    fn of_all(cuts: impl Iterator<Item = HandCut>) -> Option<ByHand> {
        let mut all: Vec<HandCut> = cuts.collect();
        all.sort_by_key(|cut| cut.node);
        let twice = all.windows(2).any(|pair| pair[0].node == pair[1].node);
        if twice || all.len() > ByHand::MOST {
            return None;
        }
        let mut cuts = [None; ByHand::MOST];
        for (place, cut) in cuts.iter_mut().zip(all) {
            *place = Some(cut);
        }
        Some(ByHand { cuts })
    }

    /// As a rule spells them: `0:x=2.09,1:y=3`, or `none`.
    pub(super) fn read(text: &str) -> Option<ByHand> {
        if text.trim() == "none" {
            return Some(ByHand::default());
        }
        let cuts: Option<Vec<HandCut>> = text.split(',').map(HandCut::read).collect();
        ByHand::of_all(cuts?.into_iter())
    }
}

impl fmt::Display for ByHand {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_empty() {
            return f.write_str("none");
        }
        let all: Vec<String> = self.cuts().map(|cut| cut.to_string()).collect();
        f.write_str(&all.join(","))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cuts_are_spelt_and_read() {
        let check = |text: &str, again: Option<&str>| {
            assert_eq!(ByHand::read(text).map(|cuts| cuts.to_string()).as_deref(), again, "{text}");
        };
        check("none", Some("none"));
        check("0:x=2.09", Some("0:x=2.09"));
        check(" 5:z=-1e-3, 1 : y = 3 ", Some("1:y=3,5:z=-0.001"));
        check("0:x=1,0:y=2", None);
        check("0:x=1,", None);
        check("0:x=NaN", None);
        check("0:w=1", None);
        check("x=1", None);
        check("", None);
        check(&(0..9).map(|node| format!("{node}:x=1")).collect::<Vec<_>>().join(","), None);
    }

    #[test]
    fn a_node_has_one_cut() {
        let cut = |node, at| HandCut { node: NodeId(node), axis: Axis::X, at };
        let cuts = ByHand::default().with(cut(3, 1.0)).and_then(|cuts| cuts.with(cut(1, 2.0))).unwrap();
        assert_eq!(cuts.with(cut(3, 4.0)).unwrap().to_string(), "1:x=2,3:x=4");
        assert_eq!(cuts.without(|node| node == NodeId(3)).to_string(), "1:x=2");
    }
}
