//! Two laws through measured points: a power and a logarithm.

/// `y = factor · x^exponent`, fitted to the logarithms.
#[derive(Clone, Copy, Debug)]
pub(super) struct Power {
    pub(super) exponent: f64,
}

/// `y = start + slope · log₂ x`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Logarithm {
    pub(super) start: f64,
    pub(super) slope: f64,
    /// How far the points lie off, root mean square, as a part of their mean.
    pub(super) residual: f64,
}

/// The power law nearest to the points, all of which must be positive.
pub(super) fn power(points: &[(f64, f64)]) -> Power {
    let logarithms: Vec<_> = points.iter().filter(|(_, y)| *y > 0.0).map(|(x, y)| (x.log2(), y.log2())).collect();
    Power { exponent: straight(&logarithms).1 }
}

/// The logarithm nearest to the points.
pub(super) fn logarithm(points: &[(f64, f64)]) -> Logarithm {
    let points: Vec<_> = points.iter().map(|(x, y)| (x.log2(), *y)).collect();
    let (start, slope) = straight(&points);
    let n = points.len() as f64;
    let off: f64 = points.iter().map(|(x, y)| (start + slope * x - y).powi(2)).sum();
    let mean = points.iter().map(|(_, y)| y).sum::<f64>() / n;
    Logarithm { start, slope, residual: (off / n).sqrt() / mean }
}

/// Least squares: where the line begins, and its slope.
fn straight(points: &[(f64, f64)]) -> (f64, f64) {
    let n = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / n;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let across: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let along: f64 = points.iter().map(|p| (p.0 - x).powi(2)).sum();
    let slope = across / along;
    (y - slope * x, slope)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn laws_are_found_again() {
        let sample = |law: fn(f64) -> f64| [2.0, 5.0, 17.0, 300.0, 9000.0].map(|x| (x, law(x)));
        assert!((power(&sample(|x| 7.0 * x.powf(0.4))).exponent - 0.4).abs() < 1e-9);
        let found = logarithm(&sample(|x| 3.0 + 2.0 * x.log2()));
        assert!((found.start - 3.0).abs() < 1e-9 && (found.slope - 2.0).abs() < 1e-9 && found.residual < 1e-9);
        assert!(logarithm(&sample(|x| x)).residual > 0.5);
    }
}
