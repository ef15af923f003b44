//! What each structure is good at, in a sentence drawn from the numbers.

use raystep_figure::number;
use raystep_figure::whole;

use super::Rated;

/// Something in which structures differ: less is better.
struct Measure {
    /// What the least of it is called.
    least: &'static str,
    /// What it is called.
    name: &'static str,
    of: fn(&Rated) -> f64,
    says: fn(f64) -> String,
    /// Whether it differs from machine to machine.
    time: bool,
}

const MEASURES: [Measure; 5] = [
    Measure { least: "fewest tests", name: "tests", of: |rated| rated.tests, says: a_ray, time: false },
    Measure { least: "fewest steps", name: "steps", of: Rated::steps, says: a_ray, time: false },
    Measure { least: "quickest rays", name: "time of a ray", of: |rated| rated.ray_us, says: microseconds, time: true },
    Measure {
        least: "quickest to build",
        name: "time to build",
        of: |rated| rated.build_ms,
        says: milliseconds,
        time: true,
    },
    Measure { least: "smallest", name: "bytes", of: |rated| rated.bytes as f64, says: bytes, time: false },
];

fn a_ray(value: f64) -> String {
    format!("{} a ray", number(value as f32))
}

fn microseconds(value: f64) -> String {
    format!("{} µs", number(value as f32))
}

fn milliseconds(value: f64) -> String {
    format!("{} ms", number(value as f32))
}

fn bytes(value: f64) -> String {
    format!("{} bytes", whole(value as u64))
}

/// A sentence for each structure, those in the order in which they stand; times are left out unless they are asked for.
pub(crate) fn told(rated: &[Rated], times: bool) -> Vec<String> {
    rated.iter().map(|own| sentence(rated, own, times)).collect()
}

/// So many tests, in the mean.
fn told_tests(tests: f64) -> String {
    let tests = number(tests as f32);
    format!("{tests} {}", if tests == "1" { "test" } else { "tests" })
}

fn sentence(rated: &[Rated], own: &Rated, times: bool) -> String {
    // Like is compared with like: those of the textbook with each other, and those at full speed.
    let alike = |other: &Rated| !other.is_list() && other.what.is_fast() == own.what.is_fast();
    let structures: Vec<&Rated> = rated.iter().filter(|other| alike(other)).collect();
    let measures = || MEASURES.iter().filter(|measure| times || !measure.time);
    let best = |measure: &Measure| {
        let least = |a: &&&Rated, b: &&&Rated| (measure.of)(a).total_cmp(&(measure.of)(b));
        structures.iter().min_by(least).copied()
    };
    if own.is_list() {
        let against = best(&MEASURES[0]).map_or_else(String::new, |least| {
            format!(", {} times those of the {}", number((own.tests / least.tests) as f32), named(least.what.name()))
        });
        return format!(
            "{}: nothing is built and nothing stored; {} a ray{against}.",
            own.what.name(),
            told_tests(own.tests)
        );
    }
    let first: Vec<String> = measures()
        .filter(|measure| best(measure).is_some_and(|least| (measure.of)(least) == (measure.of)(own)))
        .map(|measure| format!("{} ({})", measure.least, (measure.says)((measure.of)(own))))
        .collect();
    // How far it lies from the best, in factors.
    let mut behind: Vec<(f64, &Measure, &Rated)> = measures()
        .filter_map(|measure| {
            let other = best(measure).filter(|least| (measure.of)(least) != (measure.of)(own))?;
            Some(((measure.of)(own) / (measure.of)(other).max(f64::MIN_POSITIVE), measure, other))
        })
        .collect();
    behind.sort_by(|a, b| a.0.total_cmp(&b.0));
    let against = |&(factor, measure, other): &(f64, &Measure, &Rated)| {
        format!("{} times the {} of the {}", number(factor as f32), measure.name, named(other.what.name()))
    };
    let far = behind.last().filter(|(factor, ..)| *factor >= 2.0 && factor.is_finite()).map(against);
    let near = behind.first().map(against).unwrap_or_default();
    match (first.as_slice(), far) {
        ([], Some(far)) if behind.len() > 1 => {
            format!("{}: first in nothing; at best {near}, at worst {far}.", own.what.name())
        }
        ([], _) => format!("{}: first in nothing; at best {near}.", own.what.name()),
        (first, Some(far)) => format!("{}: {}; for that, {far}.", own.what.name(), listed(first)),
        (first, None) => format!("{}: {}.", own.what.name(), listed(first)),
    }
}

/// A name as it stands within a sentence.
fn named(name: &str) -> String {
    let short = name.split_whitespace().next().unwrap_or_default();
    let capitals = short.chars().filter(|c| c.is_uppercase()).count();
    if capitals > 1 {
        return name.to_owned();
    }
    let mut letters = name.chars();
    letters.next().map_or_else(String::new, |first| first.to_lowercase().chain(letters).collect())
}

/// `a, b and c`
fn listed(parts: &[String]) -> String {
    match parts {
        [] => String::new(),
        [only] => only.clone(),
        [most @ .., last] => format!("{} and {last}", most.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use raystep_accel::Rule;
    use raystep_fast::FastKind;

    use super::*;
    use crate::rating::Candidate;

    fn rated(kind: &str, [tests, visits, build_ms, ray_us]: [f64; 4], bytes: u64) -> Rated {
        let rule = Rule::default_for(kind).unwrap();
        let what = Candidate::Textbook(rule);
        Rated { what, rays: 100, tests, visits, boxes: 0.0, nodes: Some(9), bytes, build_ms, ray_us }
    }

    #[test]
    fn a_sentence_says_what_the_numbers_say() {
        let all = [
            rated("list", [600.0, 0.0, 0.0, 90.0], 0),
            rated("grid", [30.0, 20.0, 1.0, 3.0], 4000),
            rated("kd", [2.0, 10.0, 50.0, 1.0], 80_000),
            rated("bvh", [3.0, 15.0, 20.0, 1.5], 8000),
            rated("octree", [2.0, 18.0, 20.0, 1.5], 8000),
        ];
        assert_eq!(
            told(&all, true),
            [
                "Brute force: nothing is built and nothing stored; 600 tests a ray, 300 times those of the kd-tree.",
                "Grid: quickest to build (1 ms) and smallest (4000 bytes); for that, 15 times the tests of the kd-tree.",
                "kd-tree: fewest tests (2 a ray), fewest steps (10 a ray) and quickest rays (1 µs); for that, 50 times the \
                 time to build of the grid.",
                "BVH: first in nothing; at best 1.5 times the tests of the kd-tree, at worst 20 times the time to build \
                 of the grid.",
                "Octree: fewest tests (2 a ray); for that, 20 times the time to build of the grid.",
            ]
        );
        let fast = |kind, numbers, bytes| Rated { what: Candidate::Fast(kind), ..rated("kd", numbers, bytes) };
        let more = [fast(FastKind::Bvh2, [1.0, 8.0, 2.0, 0.2], 9000), fast(FastKind::Bvh8, [2.0, 4.0, 3.0, 0.1], 9500)];
        let more = told(&[&all[..], &more].concat(), true);
        assert_eq!(more[..5], told(&all, true), "those of the textbook are compared with each other");
        assert_eq!(
            more[5..],
            [
                "Fast BVH2: fewest tests (1 a ray), quickest to build (2 ms) and smallest (9000 bytes); for that, 2 times \
                 the time of a ray of the fast BVH8.",
                "Fast BVH8: fewest steps (4 a ray) and quickest rays (0.1 µs); for that, 2 times the tests of the fast BVH2.",
            ]
        );
        let counts = told(&all, false);
        assert!(
            counts.iter().all(|sentence| !sentence.contains("time to") && !sentence.contains("quickest")),
            "{counts:?}"
        );
    }
}
