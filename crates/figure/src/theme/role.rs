//! What a mark means. How a meaning looks is the theme's business.

/// The meaning of a mark. Each differs from the others in shape or line as well as in colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Role {
    /// A primitive that nothing has happened to: pale and thin.
    Scene,
    /// The ray outside the interval under consideration: thin and dashed.
    Ray,
    /// The line that the ray lies on, where it is no ray: thin.
    Line,
    /// The part of the ray under consideration: thick.
    Live,
    /// A ray of a packet that takes part, as a cell: solid.
    Lane,
    /// One of several rays, told apart by its dashes: thin. The first of every four.
    Thread1,
    /// The second.
    Thread2,
    /// The third.
    Thread3,
    /// The fourth.
    Thread4,
    /// The part of such a ray under consideration: the same dashes, thick.
    Strand1,
    /// That of the second.
    Strand2,
    /// That of the third.
    Strand3,
    /// That of the fourth.
    Strand4,
    /// A value of t along the ray: a small ring with a label.
    Tick,
    /// The current place: thick outline, light fill.
    Here,
    /// A place visited before: thin solid outline.
    Seen,
    /// A place on the stack: dashed outline.
    Waiting,
    /// A place that was never opened: dotted outline, faded.
    Dropped,
    /// A primitive tested and missed: hatched.
    Missed,
    /// A primitive that was hit: solid fill.
    Hit,
    /// The best hit so far: solid fill and a ring at the point.
    Best,
    /// A split plane or a slab's plane: a long line through the box.
    Plane,
    /// A split that was weighed and not taken: a short tick at the edge of the box.
    Candidate,
    /// What lies below a split that is weighed: hatched.
    Below,
    /// What lies above it: dashed, not hatched.
    Above,
    /// A possible answer to the open question.
    Guess,
    /// What the pointer is on, in every view.
    Hover,
    /// Edges of cells and trees, axes of rulers.
    Edge,
    /// A cell or a leaf that refers to primitives: tinted.
    Filled,
    /// The part of the ray under consideration where a surface lies before it: as wide, in dashes.
    LiveBehind,
    /// A line behind a surface: thin and dotted.
    Hidden,
    /// Where the step before stood: pale and dotted.
    Ghost,
    /// Where a mistaken walk goes wrong.
    Wrong,
    /// Plain text.
    Text,
    /// Text of lesser importance.
    Quiet,
    /// Numbers of the current step.
    Value,
    /// The ground of the current line of a listing or a table.
    Ground,
    /// The ground of a page.
    Page,
    /// The ground of a panel on the page.
    Panel,
}

impl Role {
    /// Every role.
    pub const ALL: [Role; 39] = [
        Role::Scene,
        Role::Ray,
        Role::Line,
        Role::Live,
        Role::Lane,
        Role::Thread1,
        Role::Thread2,
        Role::Thread3,
        Role::Thread4,
        Role::Strand1,
        Role::Strand2,
        Role::Strand3,
        Role::Strand4,
        Role::Tick,
        Role::Here,
        Role::Seen,
        Role::Waiting,
        Role::Dropped,
        Role::Missed,
        Role::Hit,
        Role::Best,
        Role::Plane,
        Role::Candidate,
        Role::Below,
        Role::Above,
        Role::Guess,
        Role::Hover,
        Role::Edge,
        Role::Filled,
        Role::LiveBehind,
        Role::Hidden,
        Role::Ghost,
        Role::Wrong,
        Role::Text,
        Role::Quiet,
        Role::Value,
        Role::Ground,
        Role::Page,
        Role::Panel,
    ];

    /// One of several rays, counted from 0.
    pub fn thread(lane: usize) -> Role {
        [Role::Thread1, Role::Thread2, Role::Thread3, Role::Thread4][lane % 4]
    }

    /// The part of it under consideration.
    pub fn strand(lane: usize) -> Role {
        [Role::Strand1, Role::Strand2, Role::Strand3, Role::Strand4][lane % 4]
    }
}
