//! Pairs of objects: a symbol for each kind of step of their tests, and a few words for each.

use std::borrow::Cow;

use raystep_accel::{Cover, Kind, Pair, Part, Place, Probe, Step, Trial, Value};

use super::{Fact, Symbol};
use crate::theme::Role;
use crate::words::{VolumeName, told};

const LAID: Symbol = Symbol { sign: "□", name: "pair", role: Role::Here, rank: 5 };
const CUT: Symbol = Symbol { sign: "▽", name: "cut", role: Role::Plane, rank: 1 };
const NARROW: Symbol = Symbol { sign: "△", name: "interval", role: Role::Seen, rank: 0 };
const SHADOW: Symbol = Symbol { sign: "◇", name: "shadows", role: Role::Seen, rank: 0 };
const NUMBER: Symbol = Symbol { sign: "○", name: "comparison", role: Role::Seen, rank: 0 };
const YES: Symbol = Symbol { sign: "●", name: "meet", role: Role::Hit, rank: 7 };
const NO: Symbol = Symbol { sign: "×", name: "apart", role: Role::Missed, rank: 6 };

/// `a ray`, `an oriented box`.
fn one(kind: Kind) -> String {
    match kind {
        Kind::Obb => "an oriented box".to_owned(),
        kind => format!("a {}", kind.word()),
    }
}

/// What the two objects of a pair are, in words: `a ray and a cone`.
pub(crate) fn both(pair: &Pair) -> String {
    match pair.first == pair.second {
        true if pair.first == Kind::Obb => "two oriented boxes".to_owned(),
        true => "two boxes".to_owned(),
        false => format!("{} and {}", one(pair.first), one(pair.second)),
    }
}

impl Fact for Trial {
    fn name(&self) -> &'static str {
        self.name()
    }

    fn place(&self) -> Place {
        self.place()
    }

    fn field(&self, name: &str) -> Option<Value> {
        self.field(name)
    }

    fn symbol(&self) -> Option<Symbol> {
        Some(match &self.step {
            None => LAID,
            Some(Step::Slab(visit)) => return visit.symbol().map(|_| CUT),
            Some(Step::Probe(probe)) => match probe {
                Probe::Cut { .. } | Probe::Quadratic { .. } | Probe::Parallel { .. } => CUT,
                Probe::Narrow { .. } => NARROW,
                Probe::Shadow { .. } => SHADOW,
                Probe::Met { hit: yes, .. } | Probe::Touch { touch: yes } => {
                    if *yes {
                        YES
                    } else {
                        NO
                    }
                }
                Probe::Compare { .. } | Probe::Side { .. } | Probe::Parity { .. } | Probe::Areas { .. } => NUMBER,
                Probe::Shear { .. } | Probe::Edge { .. } | Probe::Nearest { .. } => return None,
            },
        })
    }

    fn short(&self, volume: VolumeName) -> Cow<'static, str> {
        let probe = match &self.step {
            None => return self.tried().map_or_else(String::new, |pair| format!("{} lie there", both(pair))).into(),
            Some(Step::Slab(visit)) => return visit.short(volume),
            Some(Step::Probe(probe)) => probe,
        };
        Cow::Borrowed(match probe {
            Probe::Cut { .. } => "a plane cuts the ray's line",
            Probe::Parallel { .. } => "the ray runs along the surface",
            Probe::Quadratic { real: true, .. } => "the equation has two solutions",
            Probe::Quadratic { .. } => "the equation has no solution",
            Probe::Narrow { empty: true, .. } => "nothing of the interval is left",
            Probe::Narrow { .. } => "the interval narrows",
            Probe::Shear { .. } => "the triangle is seen along the ray",
            Probe::Areas { inside: true, .. } => "three areas of one sign",
            Probe::Areas { .. } => "three areas of different signs",
            Probe::Edge { crossed: true, .. } => "an edge is crossed",
            Probe::Edge { .. } => "an edge is not crossed",
            Probe::Parity { .. } => "the crossings are counted",
            Probe::Compare { inside: true, .. } => "within its limits",
            Probe::Compare { .. } => "beyond its limits",
            Probe::Nearest { .. } => "the nearest point, along one axis",
            Probe::Shadow { apart: true, .. } => "the shadows lie apart",
            Probe::Shadow { .. } => "the shadows overlap",
            Probe::Side { cover: Cover::Outside, .. } => "the box lies outside the plane",
            Probe::Side { cover: Cover::Across, .. } => "the plane passes through the box",
            Probe::Side { .. } => "the box lies inside the plane",
            Probe::Met { hit: true, .. } => "the ray meets it",
            Probe::Met { .. } => "the ray misses it",
            Probe::Touch { touch: true } => "they share a point",
            Probe::Touch { .. } => "they are apart",
        })
    }

    fn sentence(&self, volume: VolumeName) -> String {
        let probe = match &self.step {
            None => {
                let Some(pair) = self.tried() else { return String::new() };
                let both = both(pair);
                let (first, rest) = both.split_at(1);
                return format!("{}{rest}. The idea of the test: {}.", first.to_uppercase(), pair.idea);
            }
            Some(Step::Slab(visit)) => return visit.sentence(volume),
            Some(Step::Probe(probe)) => probe,
        };
        let template = match probe {
            Probe::Cut { .. } => {
                "Along its normal the plane is at {{height}} from the start, and a unit of t goes {{slant}}: t = {{t}}."
            }
            Probe::Parallel { .. } => {
                "One unit of t brings the ray nearer by {{slant}} only: it runs along the surface."
            }
            Probe::Quadratic { real: true, .. } => {
                "a·t² + 2·b·t + c = 0 with a = {{a}}, b = {{b}}, c = {{c}}: t = {{t1}} and t = {{t2}}."
            }
            Probe::Quadratic { .. } => {
                "a·t² + 2·b·t + c = 0 with a = {{a}}, b = {{b}}, c = {{c}}: b² − a·c = {{discriminant}} has no root."
            }
            Probe::Narrow { empty: true, .. } => "Of [{{t1}}, {{t2}}] nothing lies in what was left.",
            Probe::Narrow { .. } => "From t = {{t1}} to t = {{t2}}; left is [{{t_near}}, {{t_far}}].",
            Probe::Shear { .. } => "Seen along the ray, {{along}} is depth: each unit of it shifts by ({{x}}, {{y}}).",
            Probe::Areas { inside: true, .. } => {
                "The areas {{u}}, {{v}} and {{w}} have one sign: the ray passes within all three edges."
            }
            Probe::Areas { .. } => "The areas {{u}}, {{v}} and {{w}} differ in sign: the ray passes an edge outside.",
            Probe::Edge { crossed: true, .. } => {
                "Edge {{edge}} runs from height {{from}} to {{to}} and passes the point's height at {{at}}, to its right."
            }
            Probe::Edge { .. } => "Edge {{edge}} runs from height {{from}} to {{to}}: it is not crossed.",
            Probe::Parity { inside: true, .. } => "{{crossings crossing}}, an odd number: the point lies inside.",
            Probe::Parity { .. } => "{{crossings crossing}}, an even number: the point lies outside.",
            Probe::Compare { of: Part::Radius, inside: true, .. } => {
                "The distance squared, {{value}}, is no more than {{high}}, the radius squared."
            }
            Probe::Compare { of: Part::Radius, .. } => {
                "The distance squared, {{value}}, is more than {{high}}, the radius squared."
            }
            Probe::Compare { inside: true, .. } => "{{of}}: {{value}} lies from {{low}} to {{high}}.",
            Probe::Compare { .. } => "{{of}}: {{value}} does not lie from {{low}} to {{high}}.",
            Probe::Nearest { .. } => {
                "Along {{of}} the box reaches from {{low}} to {{high}}; nearest to {{value}} is {{nearest}}, {{gap}} away."
            }
            Probe::Shadow { apart: true, .. } => {
                "Along ({{x}}, {{y}}, {{z}}): [{{a_low}}, {{a_high}}] and [{{b_low}}, {{b_high}}] lie apart."
            }
            Probe::Shadow { .. } => {
                "Along ({{x}}, {{y}}, {{z}}): [{{a_low}}, {{a_high}}] and [{{b_low}}, {{b_high}}] overlap. That decides nothing."
            }
            Probe::Side { cover: Cover::Across, .. } => {
                "The box's middle lies {{distance}} from the plane and the box reaches {{reach}}: the plane passes through."
            }
            Probe::Side { cover: Cover::Outside, .. } => {
                "The box's middle lies {{distance}} from the plane and the box reaches {{reach}}: all of it is outside."
            }
            Probe::Side { .. } => {
                "The box's middle lies {{distance}} from the plane and the box reaches {{reach}}: all of it is inside."
            }
            Probe::Met { hit: true, .. } => "The ray meets it at t = {{t}}.",
            Probe::Met { .. } => "The ray misses it.",
            Probe::Touch { touch: true } => "The two share a point.",
            Probe::Touch { .. } => "The two are apart.",
        };
        told(template, self)
    }
}
