//! A convex body by its edges: which of them an eye sees as its outline.

use glam::Vec3;
use raystep_accel::outline;

/// Bodies with so few edges, as a box has them, show them all alike.
const FEW: usize = 12;

/// The lines that show a body to an eye: those of its outline, and those that are fainter.
pub fn lines(edges: &[[Vec3; 2]], eye: Vec3) -> (Vec<Vec<Vec3>>, Vec<[Vec3; 2]>) {
    match rim(edges, eye).filter(|_| edges.len() > FEW) {
        Some(rim) => {
            let beside =
                |edge: &&[Vec3; 2]| !rim.windows(2).any(|pair| edge.contains(&pair[0]) && edge.contains(&pair[1]));
            let faint = edges.iter().filter(beside).copied().collect();
            (vec![rim], faint)
        }
        None => (chained(edges.to_vec()), Vec::new()),
    }
}

/// The corners that an eye sees outermost, as a closed line; nothing for an eye that does not see it whole.
fn rim(edges: &[[Vec3; 2]], eye: Vec3) -> Option<Vec<Vec3>> {
    let corners: Vec<Vec3> = edges.iter().flatten().copied().collect();
    let middle = corners.iter().sum::<Vec3>() / corners.len().max(1) as f32;
    let forward = (middle - eye).as_dvec3().try_normalize()?;
    let (right, up) = forward.any_orthonormal_pair();
    let seen = corners.iter().map(|corner| {
        let from_eye = (*corner - eye).as_dvec3();
        let distance = from_eye.dot(forward);
        (distance > 0.0).then(|| glam::DVec2::new(from_eye.dot(right), from_eye.dot(up)) / distance)
    });
    let around = outline(&seen.collect::<Option<Vec<_>>>()?);
    let rim: Vec<Vec3> = around.iter().chain(around.first()).map(|&index| corners[index]).collect();
    (rim.len() > 3).then_some(rim)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_outline_of_a_body_is_strong_and_the_rest_faint() {
        // Two pyramids over a hexagon: an eye far above sees the hexagon around six edges, and six below.
        let ring: Vec<Vec3> = [(2.0, 0.0), (1.0, 2.0), (-1.0, 2.0), (-2.0, 0.0), (-1.0, -2.0), (1.0, -2.0)]
            .map(|(x, y)| Vec3::new(x, y, 0.0))
            .to_vec();
        let next = ring.iter().cycle().skip(1);
        let mut edges: Vec<[Vec3; 2]> = ring.iter().zip(next).map(|(&from, &to)| [from, to]).collect();
        edges.extend(ring.iter().flat_map(|&corner| [[corner, Vec3::Z], [corner, Vec3::NEG_Z]]));
        let (strong, faint) = lines(&edges, Vec3::Z * 100.0);
        assert_eq!((strong.len(), strong[0].len(), faint.len()), (1, 7, 12));
        // From within, there is no outline.
        let (strong, faint) = lines(&edges, Vec3::ZERO);
        assert_eq!((strong.iter().map(|path| path.len() - 1).sum(), faint.len()), (edges.len(), 0));
    }
}
