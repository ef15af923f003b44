//! A convex body by its edges: which of them an eye sees as its outline.

use glam::Vec3;

/// An edge of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// One end.
    pub from: Vec3,
    /// The other end.
    pub to: Vec3,
    /// The outward normals of the two faces that meet there; zero where there is none.
    pub normals: [Vec3; 2],
}

/// Bodies with so few edges, as a box has them, show them all alike.
const FEW: usize = 12;

/// The lines that show a body to an eye: those of its outline, and those that are fainter.
pub fn lines(edges: &[Edge], eye: Vec3) -> (Vec<Vec<Vec3>>, Vec<[Vec3; 2]>) {
    let rim = |edge: &&Edge| {
        let [a, b] = edge.normals.map(|normal| normal.dot(eye - edge.from) > 0.0);
        edges.len() <= FEW || a != b || edge.normals.contains(&Vec3::ZERO)
    };
    let (strong, faint): (Vec<&Edge>, Vec<&Edge>) = edges.iter().partition(rim);
    let strong = strong.iter().map(|edge| [edge.from, edge.to]).collect();
    (chained(strong), faint.iter().map(|edge| [edge.from, edge.to]).collect())
}

/// Lines joined where they meet, so that dashes run on around a corner.
fn chained(mut lines: Vec<[Vec3; 2]>) -> Vec<Vec<Vec3>> {
    let mut chains = Vec::new();
    while let Some([from, to]) = lines.pop() {
        let mut chain = vec![from, to];
        while let Some(next) = chain.last().and_then(|&end| lines.iter().position(|line| line.contains(&end))) {
            let [a, b] = lines.swap_remove(next);
            chain.push(if chain.last() == Some(&a) { b } else { a });
        }
        chains.push(chain);
    }
    chains
}
