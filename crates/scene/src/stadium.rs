//! The teapot in a stadium, slide 23: where a grid of equal cells does not adapt.

use glam::{DVec3, Vec3};
use raystep_accel::{Aabb, Mesh, Prims};

use crate::{Scene, View, teapot};

/// The name by which slides ask for it.
pub(crate) const STADIUM: &str = "stadium";

/// How long the stadium is, in metres.
const LENGTH: f32 = 100.0;
/// How wide it is for its length.
const WIDTH: f32 = 0.8;
/// How wide the teapot is from handle to spout, in metres.
const TEAPOT: f32 = 0.2;
/// Into how many sectors the stands are cut.
const SECTORS: u32 = 24;

/// A section through the stands: from the edge of the field up to the roof's rim and down outside. How far
/// out, as a part of half the stadium, and how high, in metres.
const SECTION: [(f32, f32); 9] = [
    (0.56, 0.0),
    (0.56, 1.2),
    (0.74, 7.0),
    (0.78, 7.0),
    (0.78, 9.0),
    (0.96, 19.0),
    (0.78, 23.0),
    (1.0, 23.5),
    (1.0, 0.0),
];

/// A teapot of 0.2 m in the middle of a stadium of 100 m, z up, lengths in metres.
pub(crate) fn stadium() -> Scene {
    let mut mesh = small_teapot();
    let bounds = Aabb::around(mesh.corners.iter().copied());
    let pot = mesh.triangles.len();
    add_bowl(&mut mesh);
    let target = bounds.center();
    Scene {
        name: STADIUM.to_owned(),
        title: "A teapot in a stadium".to_owned(),
        view: View { eye: target + Vec3::new(0.16, -0.46, 0.15), target, up: Vec3::Z, fov_degrees: 40.0 },
        flat: false,
        note: format!(
            "A teapot of {TEAPOT} m and {pot} triangles stands in the middle of a stadium of {LENGTH} m and {} triangles.",
            mesh.triangles.len() - pot
        ),
        prims: Prims::Mesh(mesh),
        origin: DVec3::ZERO,
    }
}

/// The teapot in its true size, upright on the spot in the middle.
fn small_teapot() -> Mesh {
    let mut mesh = teapot(10);
    let bounds = Aabb::around(mesh.corners.iter().copied());
    let scale = TEAPOT / bounds.extent().x;
    let foot = bounds.center().with_z(bounds.min.z);
    for corner in &mut mesh.corners {
        *corner = (*corner - foot) * scale;
    }
    mesh
}

/// The field as a fan of triangles, and around it the stands: rings of quads, each cut in two.
fn add_bowl(mesh: &mut Mesh) {
    let spot = mesh.corners.len() as u32;
    mesh.corners.push(Vec3::ZERO);
    let corner = |ring: u32, sector: u32| spot + 1 + ring * SECTORS + sector % SECTORS;
    for (out, height) in SECTION {
        for sector in 0..SECTORS {
            let angle = std::f64::consts::TAU * f64::from(sector) / f64::from(SECTORS);
            let around = Vec3::new(libm::cos(angle) as f32, WIDTH * libm::sin(angle) as f32, 0.0);
            mesh.corners.push((around * (out * LENGTH * 0.5)).with_z(height));
        }
    }
    for sector in 0..SECTORS {
        mesh.triangles.push([spot, corner(0, sector), corner(0, sector + 1)]);
        for ring in 0..SECTION.len() as u32 - 1 {
            let [a, b] = [corner(ring, sector), corner(ring, sector + 1)];
            let [c, d] = [corner(ring + 1, sector + 1), corner(ring + 1, sector)];
            mesh.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
}

#[cfg(test)]
mod tests {
    use raystep_accel::{AnyGrid, CellId, Grid, GridRule, NestedGrid, NestedRule, PrimId, Primitives};

    use super::*;

    /// In how many cells the teapot lies, and how many of its triangles the fullest of them holds.
    fn crowd(grid: &impl AnyGrid, pot: u32) -> (usize, usize) {
        let cells = (0..grid.cell_count() as u32).map(CellId);
        let of_teapot = |cell| grid.cell_prims(cell).iter().filter(|prim| prim.0 < pot).count();
        let counts: Vec<usize> = cells.map(of_teapot).filter(|&count| count > 0).collect();
        (counts.len(), counts.into_iter().max().unwrap_or(0))
    }

    #[test]
    fn only_the_nested_grid_adapts_to_the_teapot() {
        let scene = stadium();
        let pot = teapot(10).len() as u32;
        assert_eq!(scene.prims.len() as u32, pot + SECTORS * (2 * SECTION.len() as u32 - 1));
        let uniform = Grid::build(&scene.prims, &GridRule::default(), &mut ()).unwrap();
        assert_eq!(crowd(&uniform, pot), (1, pot as usize));
        // Where the lid's small triangles meet, a third level is of use.
        for (levels, enough, few) in [(2, 50, 1500), (3, 400, 600)] {
            let rule = NestedRule { levels, ..NestedRule::default() };
            let nested = NestedGrid::build(&scene.prims, &rule, &mut ()).unwrap();
            let (cells, most) = crowd(&nested, pot);
            assert!(cells > enough && most < few, "{levels} levels: {cells} cells, one with {most} triangles");
        }
    }

    #[test]
    fn the_teapot_stands_on_the_spot() {
        let scene = stadium();
        let bounds = scene.bounds();
        assert_eq!((bounds.extent().x, bounds.min.z), (LENGTH, 0.0));
        let first = scene.prims.bounds(PrimId(0));
        assert!(first.center().length() < TEAPOT);
    }
}
