//! What rays meet on their ways, beside what they take: whether a tree is bad, a node dear, or a leaf.

use raystep_accel::Want;
use raystep_fast::Count;

use crate::rays::{Ask, Rays};
use crate::{Built, median};

/// What rays met.
#[derive(Default)]
pub struct Met {
    /// Nodes that were opened: all boxes of their children tested.
    pub nodes: u64,
    pub leaves: u64,
    /// Triangles tested.
    pub triangles: u64,
    /// Triangles judged in double precision.
    pub judged: u64,
}

impl Count for Met {
    fn node(&mut self, _boxes: u32) {
        self.nodes += 1;
    }

    fn triangles(&mut self, triangles: u32) {
        self.leaves += 1;
        self.triangles += u64::from(triangles);
    }

    fn judged(&mut self, triangles: u32) {
        self.judged += u64::from(triangles);
    }
}

/// What a line through the box around everything is expected to meet, by the surfaces of boxes (slide 53).
#[derive(Default)]
pub struct Expected {
    pub nodes: f64,
    pub leaves: f64,
    pub triangles: f64,
}

/// Prints a row for each kind of rays and each peer that counts.
pub fn print(built: &[Built], kinds: &[Rays]) {
    println!("\n  {:<33}{:>8}{:>8}{:>11}{:>9}{:>9}", "of each", "nodes", "leaves", "triangles", "judged", "ns a ray");
    for one in built {
        if let Some(Expected { nodes, leaves, triangles }) = one.peer.expected() {
            println!("  {:<24}{:<9}{nodes:>8.2}{leaves:>8.2}{triangles:>11.2}", one.name, "line");
        }
    }
    for (kind, Rays { name, ask, rays }) in kinds.iter().enumerate() {
        let want = if *ask == Ask::Any { Want::Any } else { Want::Nearest };
        for one in built {
            let took = median(&one.times[kind]);
            let row = |of: &str, Met { nodes, leaves, triangles, judged }: Met, many: usize| {
                let each = |number: u64| number as f64 / many as f64;
                let (nodes, leaves, triangles, judged) = (each(nodes), each(leaves), each(triangles), each(judged));
                println!("  {:<24}{of:<9}{nodes:>8.2}{leaves:>8.2}{triangles:>11.2}{judged:>9.3}{took:>9.1}", one.name);
            };
            if let Some((met, packets)) = one.peer.packets(rays, want) {
                row("packet", met, packets);
                println!("  {:<24}{packets} packets of rays walk together", "");
            } else if let Some(met) = one.peer.met(rays, want) {
                row(name, met, rays.len());
            }
        }
    }
}
