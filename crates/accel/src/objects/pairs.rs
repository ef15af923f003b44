//! The matrix of slide 19: which tests there are, whose they are, and a pair to try each on.

use super::{Body, Kind, Step, Steps, example};

/// A test of two objects.
#[derive(Clone, Copy, Debug)]
pub struct Pair {
    /// What is tested.
    pub first: Kind,
    /// What it is tested against.
    pub second: Kind,
    /// The idea of the test, in a few words.
    pub idea: &'static str,
    /// Where it was described.
    pub source: &'static str,
}

impl Pair {
    /// Two objects to try it on.
    pub fn example(&self) -> [Body<'static>; 2] {
        [example::first(self), example::body(self.second)]
    }

    /// The steps of the test on two objects, and whether they meet; nothing if it is a test of other kinds.
    pub fn observe(&self, [first, second]: [&Body<'_>; 2]) -> Option<(Vec<Step>, bool)> {
        if (first.kind(), second.kind()) != (Some(self.first), Some(self.second)) {
            return None;
        }
        let mut steps = Steps::default();
        let answer = first.meets(second, &mut steps)?;
        Some((steps.0, answer))
    }
}

const ERICSON: &str = "Ericson, Real-Time Collision Detection, 2005";

const fn pair(first: Kind, second: Kind, idea: &'static str, source: &'static str) -> Pair {
    Pair { first, second, idea, source }
}

/// Every test there is: the rays' row of the matrix, then what builders and culling ask, then points.
pub const PAIRS: [Pair; 23] = [
    pair(Kind::Ray, Kind::Plane, "one division", ERICSON),
    pair(Kind::Ray, Kind::Sphere, "a quadratic equation", "Haines et al., Ray Tracing Gems, 2019"),
    pair(
        Kind::Ray,
        Kind::Cylinder,
        "a quadratic equation and a slab",
        "Cychosz and Waggenspack, Graphics Gems IV, 1994",
    ),
    pair(Kind::Ray, Kind::Cone, "a quadratic equation and a slab", "Eberly, Intersection of a Line and a Cone"),
    pair(Kind::Ray, Kind::Triangle, "three areas of one sign", "Woop, Benthin and Wald, JCGT 2013"),
    pair(Kind::Ray, Kind::Polygon, "its plane, then crossings counted", "Badouel, Graphics Gems, 1990"),
    pair(Kind::Ray, Kind::Aabb, "three slabs", "Kay and Kajiya, SIGGRAPH 1986"),
    pair(Kind::Ray, Kind::Obb, "three slabs in the box's own frame", ERICSON),
    pair(Kind::Triangle, Kind::Aabb, "thirteen directions to be apart in", "Akenine-Möller, JGT 2001"),
    pair(Kind::Sphere, Kind::Aabb, "the nearest point of the box", "Arvo, Graphics Gems, 1990"),
    pair(Kind::Aabb, Kind::Aabb, "three pairs of shadows", ERICSON),
    pair(Kind::Obb, Kind::Obb, "fifteen directions to be apart in", "Gottschalk, Lin and Manocha, SIGGRAPH 1996"),
    pair(Kind::Frustum, Kind::Aabb, "six planes, each with the reach of the box", "Assarsson and Möller, JGT 2000"),
    pair(Kind::Plane, Kind::Aabb, "the reach of the box along the normal", ERICSON),
    pair(Kind::Point, Kind::Plane, "the sign of a dot product", ERICSON),
    pair(Kind::Point, Kind::Sphere, "a distance, squared", ERICSON),
    pair(Kind::Point, Kind::Cylinder, "a height and a distance", ERICSON),
    pair(Kind::Point, Kind::Cone, "a height, and how wide the cone is there", ERICSON),
    pair(Kind::Point, Kind::Triangle, "three areas of one sign", ERICSON),
    pair(Kind::Point, Kind::Polygon, "crossings counted", "Haines, Graphics Gems IV, 1994"),
    pair(Kind::Point, Kind::Aabb, "three coordinates between their limits", ERICSON),
    pair(Kind::Point, Kind::Obb, "three coordinates in the box's own frame", ERICSON),
    pair(Kind::Point, Kind::Frustum, "the inner side of six planes", "Assarsson and Möller, JGT 2000"),
];
