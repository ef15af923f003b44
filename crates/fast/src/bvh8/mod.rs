//! The hierarchy with eight children to a node: one ray tests eight boxes at once, and the tree is a third as deep.

mod collapse;
mod node;
mod walk;

use raystep_accel::{Hit, Mesh, Ray, Want};

use crate::build::{Settings, tree};
use crate::fast::{Fast, Question};
use crate::judge::{Count, NotOrdinary};
use crate::lanes::{Isa, dispatch};
use crate::leaf::{Four, any_ray};
use crate::pages::Pages;
pub(crate) use node::{LEAF, Node, octant};

/// A hierarchy of boxes with up to eight children to a node.
#[derive(Clone, Debug)]
pub struct Bvh8 {
    nodes: Pages<Node>,
    leaves: Pages<Four>,
    reach: f32,
    /// Whether leaves hold parts of triangles.
    parted: bool,
    isa: Isa,
}

impl Bvh8 {
    /// Builds it, on the threads of the current pool.
    pub fn build(mesh: &Mesh, settings: &Settings) -> Bvh8 {
        let tree = tree(mesh, settings);
        let (nodes, leaves) = collapse::nodes(&tree, mesh);
        Bvh8 { nodes, leaves, reach: tree.reach(), parted: tree.parted, isa: Isa::best() }
    }

    /// Its nodes, its leaves, and the largest coordinate: for walks of other rooms.
    pub(crate) fn parts(&self) -> (&[Node], &[Four], f32) {
        (&self.nodes, &self.leaves, self.reach)
    }

    /// Walks any ray, with the textbook's own tests.
    fn careful(&self, ray: &Ray, want: Want, count: &mut impl Count) -> Option<Hit> {
        // Boxes of parts are wide enough for ordinary rays only.
        if self.parted {
            any_ray(&self.leaves, ray, want, count)
        } else {
            walk::careful(&self.nodes, &self.leaves, ray, want, count)
        }
    }

    /// The same with other instructions.
    #[must_use]
    pub fn with(self, isa: Isa) -> Bvh8 {
        Bvh8 { isa, ..self }
    }
}

impl Fast for Bvh8 {
    fn walk(&self, ray: &Ray, want: Want, count: &mut impl Count) -> Option<Hit> {
        let Self { nodes, leaves, reach, isa, .. } = self;
        let walked = walk::STACK.with_borrow_mut(|stack| match want {
            Want::Nearest => dispatch!(isa, walk::walk::<false>(nodes, leaves, ray, *reach, stack, count)),
            Want::Any => dispatch!(isa, walk::walk::<true>(nodes, leaves, ray, *reach, stack, count)),
        });
        walked.unwrap_or_else(|NotOrdinary| self.careful(ray, want, count))
    }

    fn ask_some<T>(&self, rays: &[Ray], answers: &mut [T], question: impl Question<T>) {
        let mut done = 0;
        while done < rays.len() {
            let (rays, answers) = (&rays[done..], &mut answers[done..]);
            let ordinary = walk::STACK.with_borrow_mut(|stack| {
                let Self { nodes, leaves, reach, .. } = self;
                dispatch!(self.isa, walk::walk_some(nodes, leaves, rays, answers, *reach, question, stack))
            });
            done += ordinary;
            // One that is not ordinary.
            if let (Some(ray), Some(answer)) = (rays.get(ordinary), answers.get_mut(ordinary)) {
                *answer = question.answer(self.careful(ray, question.want(), &mut ()));
                done += 1;
            }
        }
    }

    fn bytes(&self) -> usize {
        size_of_val(&*self.nodes) + size_of_val(&*self.leaves)
    }
}
