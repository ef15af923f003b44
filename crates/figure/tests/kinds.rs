//! What any kind of picture can rely on: walks and builds draw what they say they draw, and a kind that knows one
//! pane needs to say nothing else.

use std::borrow::Cow;

use glam::{Vec2, Vec3};
use raystep_accel::{
    Accel, Arrangement, Axes, BvhVolume, CellId, Fit, Grow, KdLayout, NestedRule, PAIRS, Place, Prims, Ray, Reveal,
    Rule, Shape, Sphere, Structure, Trial, Triangle, Value, fit_around,
};
use raystep_figure::{
    Anchor, Ask, Board, Build, Depth, Face, Fact, Figure, Film, Fitting, Form, Ink, Instant, Kind, Known, Look, Map,
    Maps, Motion, Nodes, Pairs, Pane, Panel, Reel, Role, Space, Symbol, VolumeName, Walk, told,
};

const SIZE: Vec2 = Vec2::new(600.0, 200.0);

fn ask() -> Ask<'static> {
    Ask::new(SIZE, Look::WINDOW)
}

/// Between two figures of a pane lies a way that begins with the one and ends with the other, to the byte.
fn moves(old: &Figure, new: &Figure) {
    let Some(motion) = Motion::between(old, new, &[]) else { return };
    assert_eq!((&motion.at(0.0), &motion.at(1.0)), (old, new));
    let half = motion.at(0.5);
    // What is drawn on the way is what the new figure shows, elsewhere.
    let look = |figure: &Figure| figure.marks.iter().map(|mark| (mark.role, mark.place)).collect::<Vec<_>>();
    assert_eq!(look(&half), look(new));
    assert!(half != *new && half != *old);
    // The same way back.
    assert!(Motion::between(new, old, &[]).is_some());
}

/// Draws every pane at every step: those that it names, and no other.
fn check(what: &str, kind: &dyn Kind) {
    let panes = kind.panes();
    let (mut at, mut before) = (kind.start(), kind.start());
    for step in 0..=kind.len() {
        kind.advance(&mut at, step);
        for pane in Pane::ALL {
            let drawn = match pane {
                Pane::Changed => kind.changed(&before, &at, &ask()),
                _ => kind.draw(&at, pane, &ask()),
            };
            assert_eq!(drawn.is_some(), panes.contains(&pane), "{what}, {pane:?} at step {step}");
            if let (Some(new), Some(old)) = (drawn, kind.draw(&before, pane, &ask())) {
                moves(&old, &new);
            }
        }
        for pane in [kind.best()].into_iter().flatten() {
            assert!(panes.contains(&pane), "{what} is not best seen in {pane:?}");
        }
        before.clone_from(&at);
    }
}

#[test]
fn walks_and_builds_draw_the_panes_that_they_name() {
    let disc = |x: f32, y: f32| Shape::Sphere(Sphere { center: Vec3::new(x, y, 0.0), radius: 0.4 });
    let prims = Prims::Few(vec![disc(1.0, 3.0), disc(2.0, 1.0), disc(4.0, 3.5), disc(5.0, 1.0), disc(7.0, 2.6)]);
    let ray = Ray::new(Vec3::new(-1.0, 1.8, 0.0), Vec3::new(1.0, 0.1, 0.0)).unwrap();
    // A hierarchy that is put together from sets grows otherwise than one that is divided.
    let joined = ["bottom-up", "ploc", "insertion"].map(|builder| ("bvh", Some(builder)));
    for (kind, builder) in Rule::KINDS.map(|kind| (kind, None)).into_iter().chain(joined) {
        let mut rule = Rule::default_for(kind).unwrap().flat();
        if let Some(builder) = builder {
            rule.set("builder", builder).unwrap();
        }
        let (mut walked, mut grown) = (Vec::new(), Vec::new());
        let structure = Structure::build(&prims, &rule, &mut grown).unwrap();
        structure.intersect(&prims, &ray, &mut walked);
        let (structure, prims, nodes, flat) = (&structure, &prims, &Nodes::of(&structure), true);
        check(
            &format!("a walk, {kind}"),
            &Walk { structure, prims, nodes, ray, events: &walked, lost: 0, flat, layout: KdLayout::Compact },
        );
        check(
            &format!("a build, {kind}"),
            &Build {
                structure,
                nodes,
                prims,
                events: &grown,
                lost: &Default::default(),
                instead: None,
                changes: &[],
                flat,
            },
        );
    }
}

#[test]
fn pairs_draw_the_panes_that_they_name_and_every_step_has_words() {
    let all = (0..PAIRS.len() as u32).flat_map(|pair| [1, 2].map(|case| Arrangement::of(pair, case, Vec3::ZERO)));
    let cases: Vec<Arrangement> = all.map(|lies| lies.expect("a pair and its case")).collect();
    let events: Vec<Trial> = cases.iter().flat_map(Arrangement::observe).collect();
    let pairs = Pairs { cases: &cases, events: &events };
    check("pairs", &pairs);
    let mut told = String::new();
    let mut at = pairs.start();
    for step in 0..=pairs.len() {
        pairs.advance(&mut at, step);
        let space = pairs.space(&at, Depth::Path).expect("two objects lie there");
        assert!(!space.bounds.is_empty() && space.bounds.extent().is_finite(), "step {step}");
        // What is taken in the hand is where the picture says.
        let grip = pairs.grip(&at).expect("one of them can be moved");
        assert!(space.marks.iter().any(|mark| mark.form == Form::Point(grip.at)), "step {step}");
        let Some(fact) = pairs.fact(step) else { continue };
        let says = fact.sentence(VolumeName::BOX);
        assert!(!says.is_empty() && !says.contains("{{") && !says.contains("NaN"), "step {step}: {says}");
        told += &format!("{:<16} {}\n", fact.name(), says);
    }
    insta::assert_snapshot!(told);
}

#[test]
fn fittings_draw_the_panes_that_they_name_and_every_step_has_words() {
    let corner = |n: usize| Vec3::new((n % 3) as f32, (n / 3 % 4) as f32 * 0.7, (n / 5) as f32 * 0.4);
    let triangle = |n: usize| Shape::Triangle(Triangle { a: corner(n), b: corner(n + 4), c: corner(n + 7) });
    let ball = Shape::Sphere(Sphere { center: Vec3::new(1.0, 2.0, 3.0), radius: 0.5 });
    let prims = Prims::Few((0..24).map(triangle).chain([ball]).collect());
    let mut told = String::new();
    for (flat, axes) in [(true, Axes::Xy), (false, Axes::Xyz)] {
        for &volume in BvhVolume::ALL {
            let mut events: Vec<Fit> = Vec::new();
            fit_around(&prims, volume, axes, &mut events).expect("nobody cancels");
            let fitting = Fitting { prims: &prims, events: &events, volume, flat };
            check(&format!("{volume:?}"), &fitting);
            let mut at = fitting.start();
            let mut kinds = std::collections::BTreeSet::new();
            for step in 0..=fitting.len() {
                fitting.advance(&mut at, step);
                let space = fitting.space(&at, Depth::Path).expect("a set lies there");
                assert!(!space.bounds.is_empty() && space.bounds.extent().is_finite(), "{volume:?} step {step}");
                let Some(fact) = fitting.fact(step) else { continue };
                let says = fact.sentence(VolumeName::BOX);
                assert!(!says.is_empty() && !says.contains("{{") && !says.contains("NaN"), "{volume:?} {step}: {says}");
                // What an event is about lights up.
                let place = fact.place();
                if !matches!(place, Place::World)
                    && fact.name() != "face.gone"
                    && !(flat && fact.name().contains("face"))
                {
                    assert!(!fitting.outline(&at, place).is_empty() || flat, "{volume:?} {step}: {place:?}");
                }
                if !flat && kinds.insert(fact.name()) {
                    told += &format!("{volume:?} {:<16} {says}\n", fact.name());
                }
            }
            let Some(Fit::End { .. }) = events.last() else { panic!("{volume:?} never ends") };
            assert!(space_has_a_volume(&fitting.space(&at, Depth::Path)), "{volume:?} flat {flat}");
        }
    }
    insta::assert_snapshot!(told);
}

/// Whether the volume that was found is to be seen.
fn space_has_a_volume(space: &Option<Space>) -> bool {
    space.as_ref().is_some_and(|space| space.marks.iter().any(|mark| mark.role == Role::Here))
}

#[test]
fn a_build_has_stored_at_its_end_what_the_structure_refers_to() {
    let disc = |x: f32, y: f32| Shape::Sphere(Sphere { center: Vec3::new(x, y, 0.0), radius: 0.4 });
    let prims = Prims::Few((0..40).map(|n| disc((n % 8) as f32, (n / 8) as f32 + 0.01 * n as f32)).collect());
    let crowded = |kind: &str| match Rule::default_for(kind).unwrap().flat() {
        Rule::NestedGrid(rule) => Rule::NestedGrid(NestedRule { more_than: 1, ..rule }),
        rule => rule,
    };
    for kind in Rule::KINDS {
        let mut grown = Vec::new();
        let structure = Structure::build(&prims, &crowded(kind), &mut grown).unwrap();
        let Some(&Grow::End { references, .. }) = grown.last() else { continue };
        let build = Build {
            structure: &structure,
            nodes: &Nodes::of(&structure),
            prims: &prims,
            events: &grown,
            lost: &Default::default(),
            instead: None,
            changes: &[],
            flat: true,
        };
        let mut at = build.start();
        build.advance(&mut at, build.len());
        let (tally, stored) = (build.tally(&at), format!("{references} references stored"));
        assert!(tally.ends_with(&stored), "{kind}: {tally}, not {stored}");
    }
}

#[test]
fn a_pixel_of_a_heat_map_is_found_and_seen_from_near() {
    let map = |entry: usize, counts: Vec<u32>| Map {
        entry,
        name: format!("map {entry}"),
        size: [4, 3],
        counts,
        known: Known::Fully,
    };
    let few: Vec<u32> = (0..12).collect();
    let many: Vec<u32> = few.iter().map(|count| count * 100).collect();
    let maps = Maps::new("Where".to_owned(), String::new(), "tests".to_owned(), vec![map(0, few), map(1, many)]);
    let reveal = |entry| Reveal::Map { entry, mean: 5.5, least: 0.0, most: 1100.0 };
    let (panels, events, names) = ([Panel::Maps(maps)], [reveal(0), reveal(1)], ["a", "b"].map(str::to_owned));
    let board = Board { panels: &panels, events: &events, names: &names };
    check("a board", &board);
    let reel = Reel::new(board);
    let ask = Ask::new(Vec2::new(900.0, 400.0), Look::WINDOW);
    let points = (0..90).flat_map(|x| (0..40).map(move |y| Vec2::new(x as f32 + 0.5, y as f32 + 0.5) * 10.0));
    for (step, seen) in [(0, vec![]), (1, vec![0]), (2, vec![0, 1])] {
        let instant = reel.at(step);
        let still = reel.still(&instant);
        let drawn = still.draw(Pane::Picture, &ask);
        let mut found: Vec<(usize, [u32; 2])> = Vec::new();
        for point in points.clone() {
            let Some(pixel) = still.pixel_at(&ask, point) else { continue };
            let [x, y] = pixel.at;
            assert_eq!(pixel.count, (y * 4 + x) * if pixel.entry == 0 { 1 } else { 100 });
            let over = drawn.marks.iter().any(|mark| match &mark.ink {
                Ink::Image { min, max, image } => {
                    image.width == 4 && point.cmpge(*min).all() && point.cmplt(*max).all()
                }
                _ => false,
            });
            assert!(over, "{point} lies on a picture");
            let near = still.probe(&ask, &pixel).unwrap();
            let says = |text: &str| {
                near.marks.iter().any(|mark| matches!(&mark.ink, Ink::Text { text: own, .. } if own == text))
            };
            // The same ray in all the maps that are to be seen.
            for entry in &seen {
                let count = (y * 4 + x) * if *entry == 0 { 1 } else { 100 };
                let noun = if count == 1 { "test" } else { "tests" };
                assert!(says(&format!("{count} {noun}")), "{pixel:?} at step {step}");
            }
            found.push((pixel.entry, pixel.at));
        }
        found.sort_unstable();
        found.dedup();
        assert_eq!(found.len(), 12 * seen.len(), "every pixel can be pointed at, and none that is hidden");
    }
}

/// A bar chart whose bars appear one after the other: it has no scene, no ray and no structure.
struct Bars(Vec<Bar>);

struct Bar {
    name: &'static str,
    tests: f32,
    place: Place,
}

impl Kind for Bars {
    fn len(&self) -> usize {
        self.0.len()
    }

    fn start(&self) -> Instant {
        Instant::new(0_usize)
    }

    fn advance(&self, at: &mut Instant, step: usize) {
        let shown = at.state_mut::<usize>();
        *shown = step.min(self.0.len()).max(*shown);
    }

    fn panes(&self) -> Vec<Pane> {
        vec![Pane::Picture]
    }

    fn draw(&self, at: &Instant, pane: Pane, ask: &Ask<'_>) -> Option<Figure> {
        if pane != Pane::Picture {
            return None;
        }
        let mut figure = Figure::new(ask.size);
        for (row, bar) in self.0.iter().take(*at.state()).enumerate() {
            let min = Vec2::new(0.0, 20.0 * row as f32);
            let max = min + Vec2::new(ask.size.x * bar.tests / 100.0, 16.0);
            figure.add(Role::Missed, Some(bar.place), Ink::Rect { min, max, round: 0.0 });
            let (text, size) = (bar.name.to_owned(), ask.look.text);
            let text = Ink::Text { at: min, text, size, face: Face::Regular, anchor: Anchor::Start, boxed: false };
            figure.add(Role::Text, Some(bar.place), text);
        }
        Some(figure)
    }

    fn fact(&self, step: usize) -> Option<&dyn Fact> {
        Some(self.0.get(step.checked_sub(1)?)?)
    }
}

impl Fact for Bar {
    fn name(&self) -> &'static str {
        "bar"
    }

    fn place(&self) -> Place {
        self.place
    }

    fn field(&self, name: &str) -> Option<Value> {
        (name == "tests").then_some(Value::Number(self.tests))
    }

    fn symbol(&self) -> Option<Symbol> {
        Some(Symbol { sign: "■", name: "bar", role: Role::Missed, rank: 0 })
    }

    fn short(&self, _: VolumeName) -> Cow<'static, str> {
        self.name.into()
    }

    fn sentence(&self, _: VolumeName) -> String {
        told("A ray makes {{tests}} tests.", self)
    }
}

fn bars() -> Bars {
    let bar = |index, name, tests| Bar { name, tests, place: Place::Cell(CellId(index)) };
    Bars(vec![bar(0, "list", 100.0), bar(1, "grid", 9.0), bar(2, "kd", 2.5)])
}

#[test]
fn a_kind_that_knows_one_pane_says_nothing_else() {
    check("bars", &bars());
    let reel = Reel::new(bars());
    let film = Film::new(&reel);
    let words = |figure: &Figure| -> Vec<String> {
        let text = |ink: &Ink| if let Ink::Text { text, .. } = ink { Some(text.clone()) } else { None };
        figure.marks.iter().filter_map(|mark| text(&mark.ink)).collect()
    };
    for step in 0..=reel.len() {
        let instant = film.at(&reel, step);
        let still = reel.still(&instant);
        assert_eq!(still.step(), step);
        assert_eq!(words(&still.draw(Pane::Picture, &ask())), ["list", "grid", "kd"][..step]);
        assert!(still.space().is_none() && still.here().is_none() && still.cost().is_none());
        for pane in Pane::ALL.into_iter().filter(|pane| !still.has(*pane)) {
            assert_eq!(still.draw(pane, &ask()), Figure::new(SIZE), "{pane:?}");
        }
    }
    // What every kind has: a place for each step, words for it, and a track of all steps.
    assert_eq!(reel.steps_at(Place::Cell(CellId(1))), [2]);
    let instant = film.at(&reel, 3);
    let still = reel.still(&instant);
    assert_eq!(still.fact().map(|fact| fact.sentence(reel.volume())).as_deref(), Some("A ray makes 2.5 tests."));
    let track = words(&still.draw(Pane::Timeline, &ask()));
    assert_eq!(track, ["step 3 of 3", "kd", "■", "■", "■", "■", "bar"]);
    let asked = words(&reel.still(&film.at(&reel, 1)).draw(Pane::Timeline, &Ask { hide: true, ..ask() }));
    assert_eq!(asked, ["step 1 of 3", "list", "■", "■", "bar"]);
}
