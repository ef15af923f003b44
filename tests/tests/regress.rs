//! Rays that once showed a difference are shot again.

use std::path::Path;

#[test]
fn kept_rays_show_no_difference_any_more() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("regress");
    let rays = raystep::cli::replay(&folder).unwrap_or_else(|fault| panic!("{fault}"));
    assert!(rays > 0, "no rays in {}", folder.display());
}
