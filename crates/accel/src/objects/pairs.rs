//! The matrix of slide 19: which tests there are, whose they are, and a pair to try each on.

use super::{Body, Kind, Step, Steps, example};

/// A test of two objects.
#[derive(Clone, Copy, Debug)]
pub struct Pair {
    /// What slides call it: `"ray/cone"`.
    pub name: &'static str,
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

    /// The same two, and once more with the first one elsewhere: there the test answers the other way.
    pub fn cases(&self) -> [[Body<'static>; 2]; 2] {
        let [first, second] = self.example();
        [[first, second], [first.moved(example::elsewhere(self)), second]]
    }

    /// The place in [`PAIRS`] of the test that slides call so.
    pub fn named(name: &str) -> Option<usize> {
        PAIRS.iter().position(|pair| pair.name == name)
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

const fn pair(name: &'static str, first: Kind, second: Kind, idea: &'static str, source: &'static str) -> Pair {
    Pair { name, first, second, idea, source }
}

/// Every test there is: the rays' row of the matrix, then what builders and culling ask, then points.
pub const PAIRS: [Pair; 23] = [
    pair("ray/plane", Kind::Ray, Kind::Plane, "one division", ERICSON),
    pair("ray/sphere", Kind::Ray, Kind::Sphere, "a quadratic equation", "Haines et al., Ray Tracing Gems, 2019"),
    pair(
        "ray/cylinder",
        Kind::Ray,
        Kind::Cylinder,
        "a quadratic equation and a slab",
        "Cychosz and Waggenspack, Graphics Gems IV, 1994",
    ),
    pair(
        "ray/cone",
        Kind::Ray,
        Kind::Cone,
        "a quadratic equation and a slab",
        "Eberly, Intersection of a Line and a Cone",
    ),
    pair("ray/triangle", Kind::Ray, Kind::Triangle, "three areas of one sign", "Woop, Benthin and Wald, JCGT 2013"),
    pair("ray/polygon", Kind::Ray, Kind::Polygon, "its plane, then crossings counted", "Badouel, Graphics Gems, 1990"),
    pair("ray/box", Kind::Ray, Kind::Aabb, "three slabs", "Kay and Kajiya, SIGGRAPH 1986"),
    pair("ray/oriented-box", Kind::Ray, Kind::Obb, "three slabs in the box's own frame", ERICSON),
    pair("triangle/box", Kind::Triangle, Kind::Aabb, "thirteen directions to be apart in", "Akenine-Möller, JGT 2001"),
    pair("sphere/box", Kind::Sphere, Kind::Aabb, "the nearest point of the box", "Arvo, Graphics Gems, 1990"),
    pair("box/box", Kind::Aabb, Kind::Aabb, "three pairs of shadows", ERICSON),
    pair(
        "oriented-box/oriented-box",
        Kind::Obb,
        Kind::Obb,
        "fifteen directions to be apart in",
        "Gottschalk, Lin and Manocha, SIGGRAPH 1996",
    ),
    pair(
        "frustum/box",
        Kind::Frustum,
        Kind::Aabb,
        "six planes, each with the reach of the box",
        "Assarsson and Möller, JGT 2000",
    ),
    pair("plane/box", Kind::Plane, Kind::Aabb, "the reach of the box along the normal", ERICSON),
    pair("point/plane", Kind::Point, Kind::Plane, "the sign of a dot product", ERICSON),
    pair("point/sphere", Kind::Point, Kind::Sphere, "a distance, squared", ERICSON),
    pair("point/cylinder", Kind::Point, Kind::Cylinder, "a height and a distance", ERICSON),
    pair("point/cone", Kind::Point, Kind::Cone, "a height, and how wide the cone is there", ERICSON),
    pair("point/triangle", Kind::Point, Kind::Triangle, "three areas of one sign", ERICSON),
    pair("point/polygon", Kind::Point, Kind::Polygon, "crossings counted", "Haines, Graphics Gems IV, 1994"),
    pair("point/box", Kind::Point, Kind::Aabb, "three coordinates between their limits", ERICSON),
    pair("point/oriented-box", Kind::Point, Kind::Obb, "three coordinates in the box's own frame", ERICSON),
    pair("point/frustum", Kind::Point, Kind::Frustum, "the inner side of six planes", "Assarsson and Möller, JGT 2000"),
];
