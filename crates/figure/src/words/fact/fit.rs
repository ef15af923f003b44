//! The fitting of volumes: a symbol for each kind of step, and a few words for each.

use std::borrow::Cow;

use raystep_accel::{Fit, FrameFrom, Place, Value};

use super::{Fact, Symbol};
use crate::theme::Role;
use crate::words::{VolumeName, told};

const WIDEN: Symbol = Symbol { sign: "□", name: "box grows", role: Role::Here, rank: 2 };
const OUTSIDE: Symbol = Symbol { sign: "●", name: "furthest, outside", role: Role::Best, rank: 4 };
const INSIDE: Symbol = Symbol { sign: "○", name: "furthest, inside", role: Role::Seen, rank: 5 };
const TRIED: Symbol = Symbol { sign: "◇", name: "tried", role: Role::Candidate, rank: 0 };
const STANDS: Symbol = Symbol { sign: "□", name: "volume so far", role: Role::Here, rank: 3 };
const TAKEN: Symbol = Symbol { sign: "▽", name: "taken", role: Role::Here, rank: 3 };
const PUSHED: Symbol = Symbol { sign: "△", name: "planes", role: Role::Plane, rank: 3 };
const CORNER: Symbol = Symbol { sign: "●", name: "corner", role: Role::Best, rank: 4 };
const MADE: Symbol = Symbol { sign: "△", name: "face made", role: Role::Here, rank: 2 };
const GONE: Symbol = Symbol { sign: "×", name: "face gone", role: Role::Dropped, rank: 1 };
const FITTED: Symbol = Symbol { sign: "■", name: "fitted", role: Role::Hit, rank: 7 };

impl Fact for Fit {
    fn name(&self) -> &'static str {
        self.name()
    }

    fn place(&self) -> Place {
        self.place()
    }

    fn field(&self, name: &str) -> Option<Value> {
        self.field(name)
    }

    fn concerns_z(&self) -> bool {
        self.concerns_z()
    }

    fn symbol(&self) -> Option<Symbol> {
        Some(match self {
            Fit::Widen { grown: true, .. } => WIDEN,
            Fit::Far { outside: true, .. } => OUTSIDE,
            Fit::Far { .. } => INSIDE,
            Fit::Try { .. } | Fit::Frame { .. } | Fit::Shift { .. } => TRIED,
            Fit::Ball { .. } | Fit::Sphere { .. } => STANDS,
            Fit::Choose { taken: true, .. } => TAKEN,
            Fit::Push { .. } => PUSHED,
            Fit::Seed { .. } | Fit::Apex { .. } => CORNER,
            Fit::Make { .. } => MADE,
            Fit::Hide { .. } => GONE,
            Fit::End { .. } => FITTED,
            _ => return None,
        })
    }

    fn short(&self, _: VolumeName) -> Cow<'static, str> {
        Cow::Borrowed(match self {
            Fit::Begin { .. } => "the set is given",
            Fit::Widen { grown: true, .. } => "the box grows",
            Fit::Widen { .. } => "it lies in the box",
            Fit::Gather { .. } => "the points are gathered",
            Fit::Far { outside: true, .. } => "the furthest point lies outside",
            Fit::Far { .. } => "the furthest point lies inside",
            Fit::Try { .. } => "a sphere is tried",
            Fit::Ball { .. } => "the smallest sphere so far",
            Fit::Shift { .. } => "the centre moves",
            Fit::Sphere { .. } => "the sphere is found",
            Fit::Keep { few: true, .. } => "a point is kept",
            Fit::Keep { .. } => "a point far out is kept",
            Fit::Mean { .. } => "the mean of the points",
            Fit::Align { .. } => "two directions turn",
            Fit::Frame { from: FrameFrom::Principal, .. } => "the principal axes",
            Fit::Frame { from: FrameFrom::World, .. } => "the axes of the world",
            Fit::Frame { .. } => "a small turn is tried",
            Fit::Choose { taken: true, .. } => "the smaller box is taken",
            Fit::Choose { .. } => "no turn helps: smaller ones",
            Fit::Push { .. } => "two planes are pushed out",
            Fit::Seed { .. } => "a first corner",
            Fit::Apex { .. } => "the point furthest outside",
            Fit::Hide { .. } => "a face goes",
            Fit::Make { .. } => "a face comes to be",
            Fit::Enough { far, .. } if *far > 0.0 => "there are corners enough",
            Fit::Enough { .. } => "nothing lies outside",
            Fit::Plane { .. } => "the plane of a face",
            Fit::End { .. } => "the volume is fitted",
        })
    }

    fn sentence(&self, _: VolumeName) -> String {
        let template = match self {
            Fit::Begin { .. } => "{{prims primitive}}, and the box around them.",
            Fit::Widen { grown: true, .. } => "To hold {{prim}} the box grows.",
            Fit::Widen { .. } => "{{prim}} lies in the box already.",
            Fit::Gather { .. } => "The corners of all primitives, and the middles of round ones: {{points point}}.",
            Fit::Far { outside: true, .. } => {
                "Furthest from the centre lies point {{point}}, {{far}} away. The sphere reaches {{radius}}: outside."
            }
            Fit::Far { .. } => {
                "Even the furthest point, {{far}} away, lies in the sphere, which reaches {{radius}}: it holds them all."
            }
            Fit::Try { on: 1, .. } => "A sphere with one point on it has no size yet.",
            Fit::Try { .. } => "The smallest sphere with these {{on point}} on it: radius {{radius}}.",
            Fit::Ball { .. } => "The smallest sphere so far, decided by {{few point}}: radius {{radius}}.",
            Fit::Shift { .. } => {
                "From a centre that reached {{radius}} it moves by {{part}} of the way to the furthest."
            }
            Fit::Sphere { .. } => "Centre ({{x}}, {{y}}, {{z}}), radius {{radius}}.",
            Fit::Keep { few: true, .. } => "The points are few, and all of them are kept: point {{point}}.",
            Fit::Keep { .. } => "Point {{point}} lies furthest in one of 26 directions.",
            Fit::Mean { .. } => "The mean of {{points point}} lies at ({{x}}, {{y}}, {{z}}).",
            Fit::Align { .. } => {
                "The points spread {{along_first}} along {{first}}, {{along_second}} along {{second}}, with {{together}} in common: both turn by the angle with tangent {{tangent}}."
            }
            Fit::Frame { from: FrameFrom::Principal, .. } => {
                "Along the principal axes the set is {{wide_u}} wide by {{wide_v}}, and the box has the surface {{surface}}."
            }
            Fit::Frame { from: FrameFrom::World, .. } => {
                "Along the axes of the world it is {{wide_u}} wide by {{wide_v}}, with the surface {{surface}}."
            }
            Fit::Frame { .. } => {
                "Turned by the angle with tangent {{tangent}}: {{wide_u}} by {{wide_v}}, surface {{surface}}."
            }
            Fit::Choose { taken: true, .. } => "The surface {{surface}} is smaller than {{least}}: it is taken.",
            Fit::Choose { .. } => {
                "The best of these has {{surface}}, no less than {{least}}: the next turns are half as large."
            }
            Fit::Push { .. } => "Across {{axis}} the points lie between {{low}} and {{high}}.",
            Fit::Seed { count: 1, .. } => "Point {{point}} lies furthest from the middle, {{far}} away.",
            Fit::Seed { count: 2, .. } => "Point {{point}} lies furthest from it, {{far}} away.",
            Fit::Seed { count: 3, .. } => "Point {{point}} lies furthest from their line, {{far}} away.",
            Fit::Seed { .. } => "Point {{point}} lies furthest from their plane, {{far}} away.",
            Fit::Apex { .. } => "Point {{point}} lies furthest outside, {{far}} before a face: corner {{count}}.",
            Fit::Hide { .. } => "Face {{face}} sees the new corner from outside, and goes.",
            Fit::Make { .. } => "Face {{face}}, between points {{a}}, {{b}} and {{c}}: {{before point}} before it.",
            Fit::Enough { far, .. } if *far > 0.0 => {
                "{{faces triangle}} with {{corners corner}} are enough: points still lie outside, by {{far}} at most."
            }
            Fit::Enough { .. } => "{{faces triangle}} with {{corners corner}}; nothing lies outside.",
            Fit::Plane { .. } => "Face {{face}} has its plane at {{plane}} from the middle: no point lies before it.",
            Fit::End { planes: 0, .. } => "No plane bounds it. It takes {{bytes}} bytes.",
            Fit::End { .. } => "{{planes plane}} bound it, and it takes {{bytes}} bytes.",
        };
        told(template, self)
    }
}
