//! Packets, slide 59: rays from one eye that walk together. A node is tested once for all of them, a triangle for eight at
//! once. Rays that part walk alone.

mod beam;
mod meet;
mod walk;
mod work;

use raystep_accel::{Hit, Mesh, Ray, Want};

use crate::build::Settings;
use crate::bvh8::Bvh8;
use crate::fast::{Fast, Question};
use crate::judge::Count;
use crate::lanes::{Isa, dispatch};
use beam::Found;

/// The hierarchy with eight children to a node, walked by packets of rays.
#[derive(Clone, Debug)]
pub struct Packets {
    tree: Bvh8,
    width: PacketWidth,
    isa: Isa,
}

/// How many rays walk together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PacketWidth {
    /// 8
    Eight,
    /// 16
    Sixteen,
}

impl Packets {
    /// Builds it, on the threads of the current pool.
    pub fn build(mesh: &Mesh, width: PacketWidth, settings: &Settings) -> Packets {
        Packets { tree: Bvh8::build(mesh, settings), width, isa: Isa::best() }
    }

    /// The same with other instructions.
    #[must_use]
    pub fn with(self, isa: Isa) -> Packets {
        Packets { tree: self.tree.with(isa), isa, ..self }
    }

    /// Walks packets of 8·`G` rays.
    fn ask_packets<const G: usize, T>(&self, rays: &[Ray], answers: &mut [T], question: impl Question<T>) {
        let (nodes, leaves, reach) = self.tree.parts();
        let mut found = Found::<G>::NONE;
        walk::STACK.with_borrow_mut(|stack| {
            for (rays, answers) in rays.chunks(8 * G).zip(answers.chunks_mut(8 * G)) {
                // Quickly seen: rays of different origins do not walk together.
                let apart = rays.first().map(|ray| ray.o) != rays.last().map(|ray| ray.o);
                if apart {
                    self.tree.ask_some(rays, answers, question);
                    continue;
                }
                let found = &mut found;
                if dispatch!(self.isa, walk::walk(nodes, leaves, rays, reach, stack, found, &mut ())) {
                    // By eights: of a longer loop the compiler makes scattered stores, which are slow.
                    for (group, answers) in answers.as_chunks_mut::<8>().0.iter_mut().take(G).enumerate() {
                        for (at, answer) in answers.iter_mut().enumerate() {
                            *answer = question.answer(found.hit(group, at));
                        }
                    }
                } else {
                    self.tree.ask_some(rays, answers, question);
                }
            }
        });
    }
}

impl Fast for Packets {
    /// One ray alone.
    fn walk(&self, ray: &Ray, want: Want, count: &mut impl Count) -> Option<Hit> {
        self.tree.walk(ray, want, count)
    }

    fn ask_some<T>(&self, rays: &[Ray], answers: &mut [T], question: impl Question<T>) {
        match (question.want(), self.width) {
            (Want::Any, _) => self.tree.ask_some(rays, answers, question),
            (Want::Nearest, PacketWidth::Eight) => self.ask_packets::<1, T>(rays, answers, question),
            (Want::Nearest, PacketWidth::Sixteen) => self.ask_packets::<2, T>(rays, answers, question),
        }
    }

    fn bytes(&self) -> usize {
        self.tree.bytes()
    }
}
