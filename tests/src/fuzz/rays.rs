//! A table of rays.

use super::Target;

pub(super) const TARGET: Target = Target {
    name: "rays",
    body: rays,
    words: &[
        "ox,oy,oz,dx,dy,dz\n",
        "ox,oy,oz,dx,dy,dz,t_min,t_max\n",
        ",",
        "\"",
        "\"\"",
        "\n",
        "\r\n",
        "\r",
        ";",
        "\t",
        " ",
        "#",
        "\u{feff}",
        "0,0,0,1,0,0\n",
        "0,0,0,0,0,0\n",
        "0,0,0,1e-45,0,0,0,inf\n",
        ",,,,,,,\n",
    ],
    seeds: &[],
};

/// Reads a table of rays: rays that can be walked, or sentences.
///
/// # Panics
/// If that does not hold.
pub fn rays(bytes: &[u8]) {
    match raystep::cli::read_rays(bytes, "rays.csv") {
        Ok(rows) => {
            for row in rows {
                match row {
                    Ok(ray) => {
                        assert!(ray.o.is_finite() && ray.d.is_finite() && ray.d != glam::Vec3::ZERO, "{ray:?}");
                        assert!(ray.t_min.is_finite() && !ray.t_max.is_nan(), "{ray:?}");
                    }
                    Err(why) => assert!(!why.is_empty()),
                }
            }
        }
        Err(fault) => assert!(fault.to_string().starts_with("rays.csv"), "{fault}"),
    }
}
