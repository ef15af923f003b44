//! What structures are tried on: scenes and rays that leave an algorithm nothing to stand on, and the
//! structures that must agree about them. The tests and `raystep verify` share them.

pub mod crowd;
pub mod rays;
pub mod rules;
pub mod scenes;
pub mod sphere;

use scenes::Case;

/// The case called `trial:NAME:SEED`, or `trial:NAME` where nothing is drawn by lot.
pub fn named(name: &str) -> Option<Case> {
    if let Some(case) = sphere::named(name).or_else(|| crowd::named(name)) {
        return Some(case);
    }
    let (_, seed) = name.strip_prefix("trial:")?.split_once(':')?;
    scenes::cases_of(seed.parse().ok()?).into_iter().find(|case| case.name == name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_case_is_found_by_its_name() {
        let names = scenes::cases_of(3).into_iter().map(|case| case.name);
        for name in names.chain(sphere::NAMES.map(str::to_owned)).chain([crowd::NAME.to_owned()]) {
            assert_eq!(named(&name).expect(&name).name, name);
        }
        assert!(["trial:", "trial:slivers", "trial:nothing:1", "slivers:1"].map(named).iter().all(Option::is_none));
    }
}
