//! Pairs of objects that are tested one after the other, each in two arrangements.

use glam::Vec3;
use raystep_accel::{Arrangement, PAIRS, Pair, Trial};

use crate::keys::Keys;
use crate::problem::misspelt;
use crate::reading::Reading;

/// The scene in which they lie.
pub(crate) const SCENE: &str = "pairs";

/// Arrangements of a pair.
const CASES: u32 = 2;

/// How far a body can be moved along an axis.
const FURTHEST: f32 = 100.0;

/// Tests of pairs, one after the other.
#[derive(Clone, Debug, PartialEq)]
pub struct PairsTape {
    /// The pairs, by their places in [`PAIRS`].
    pub pairs: Vec<u32>,
    /// How the objects lie, in the order in which they are tested.
    pub cases: Vec<Arrangement>,
    /// What happens.
    pub events: Vec<Trial>,
}

impl PairsTape {
    /// The tests of these pairs, in two arrangements each, the first of the two objects where the settings put it, as
    /// keys and values. A setting that says nothing of them counts for nothing.
    pub(crate) fn new(pairs: &[u32], settings: &[(String, String)]) -> PairsTape {
        let moved = |pair: u32, case: u32| {
            let set = settings.iter().rev().find(|(key, _)| *key == PairsTape::key(pair, case));
            set.and_then(|(key, value)| PairsTape::read(key, value).ok()).unwrap_or(Vec3::ZERO)
        };
        let all = pairs.iter().flat_map(|pair| (1..=CASES).map(|case| (*pair, case)));
        let cases: Vec<Arrangement> =
            all.filter_map(|(pair, case)| Arrangement::of(pair, case, moved(pair, case))).collect();
        let events = cases.iter().flat_map(Arrangement::observe).collect();
        PairsTape { pairs: pairs.to_vec(), cases, events }
    }

    /// What the setting is called that moves the first object of an arrangement: `ray_cone_1`.
    pub fn key(pair: u32, case: u32) -> String {
        let name = PAIRS.get(pair as usize).map_or("", |pair| pair.name);
        format!("{}_{case}", name.replace(['/', '-'], "_"))
    }

    /// Which arrangement of a pair such a setting is about.
    pub(crate) fn case_of(pair: u32, key: &str) -> Option<u32> {
        (1..=CASES).find(|case| PairsTape::key(pair, *case) == key)
    }

    /// How far a setting moves it: `"0.5 0 -1"`.
    pub(crate) fn read(key: &str, value: &str) -> Result<Vec3, String> {
        let parts: Vec<f32> = value.split_whitespace().filter_map(|part| part.parse().ok()).collect();
        match *parts.as_slice() {
            [x, y, z] if [x, y, z].iter().all(|part| part.abs() <= FURTHEST) => Ok(Vec3::new(x, y, z)),
            _ => Err(format!(
                "`{key}` is `{value}`: it can be three numbers, x, y and z, from -{FURTHEST} to {FURTHEST}"
            )),
        }
    }

    /// How such a setting is written.
    pub fn value(moved: Vec3) -> String {
        // To a thousandth: a hand is not finer.
        let [x, y, z] = moved.to_array().map(|part| (part * 1000.0).round() / 1000.0 + 0.0);
        format!("{x} {y} {z}")
    }
}

/// `pairs = ["ray/plane", "ray/sphere"]`; all that there are if the slide does not say.
pub(crate) fn read(keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Vec<u32> {
    let Some((at, names)) = keys.get::<Vec<String>>("pairs", reading) else { return (0..PAIRS.len() as u32).collect() };
    let mut pairs = Vec::new();
    for name in names {
        match Pair::named(&name).map(|index| index as u32) {
            None => {
                let known: Vec<&str> = PAIRS.iter().map(|pair| pair.name).collect();
                reading.problem(at, misspelt("pair", &name, &known));
            }
            Some(pair) if pairs.contains(&pair) => {
                reading.problem(at, format!("the pair `{name}` is there twice"));
            }
            Some(pair) => pairs.push(pair),
        }
    }
    if pairs.is_empty() {
        reading.problem(at, "one pair or more is tested: write `pairs = [\"ray/sphere\"]`");
    }
    pairs
}
