//! What is said of slides and listings that are wrong: each line names file, line, column, what was
//! found, and what is allowed.

use raystep_lesson::{Library, check};

const SLIDE: &str = include_str!("good_slide.md");
const LISTING: &str = "walk\n  t ← (plane − o) / d | plane : {{t}}\n  order | split push\n  leaf | enter test better pop drop\n  done | end\n";

/// All problems of the good slide once `from` in it is replaced by `to`.
fn said(from: &str, to: &str) -> String {
    assert!(SLIDE.contains(from), "the good slide has no {from:?}");
    of_files(&SLIDE.replacen(from, to, 1), LISTING)
}

fn of_files(slide: &str, listing: &str) -> String {
    let file = |path: &str, text: &str| (path.to_owned(), text.to_owned());
    let library = Library::from_files([file("05-kd-tree/1-first.md", slide), file("listings/walk.txt", listing)]);
    check(&library, &|_, _| Vec::new()).iter().map(|problem| format!("  {problem}\n")).collect()
}

#[test]
fn the_good_slide_is_good() {
    assert_eq!(of_files(SLIDE, LISTING), "");
}

#[test]
fn every_mistake_is_named_with_its_place_and_the_nearest_right_spelling() {
    let mistakes = [
        ("no head", "+++\nformat", "format"),
        ("head not closed", "+++\n## The plane", "## The plane"),
        ("bad TOML", "title = \"First\"", "title = \"First"),
        ("unknown format", "format = 1", "format = 2"),
        ("unknown key", "listing =", "listnig ="),
        ("key missing", "title = \"First\"\n", ""),
        ("wrong type", "title = \"First\"", "title = 7"),
        ("slide is no number", "slide = [33, 38]", "slide = 3.5"),
        ("empty title", "title = \"First\"", "title = \"\""),
        ("unknown pane", "\"stack\"", "\"stak\""),
        ("unknown listing", "\"walk\"", "\"wakl\""),
        ("missing scene", "flat-twelve", "flat-twleve"),
        ("scene of the other kind", "flat-twelve", "teapot-6321"),
        ("no structure", "structure = { kind = \"kd\", max_depth = 6, min_objects = 2 }\n", ""),
        ("unknown structure", "kind = \"kd\"", "kind = \"kt\""),
        ("unknown parameter", "max_depth = 6", "max_dept = 6"),
        ("parameter out of range", "max_depth = 6", "max_depth = 600"),
        ("parameter is a list", "max_depth = 6", "max_depth = [6]"),
        ("rays are no list", "rays = [", "rays = 3\nstrahlen = ["),
        ("one ray only", "  { name = \"far hit\", from = [0.1, 1.2], towards = [8, 4] },\n", ""),
        ("same ray twice", "\"far hit\"", "\"near hit\""),
        ("unknown key of a ray", "from = [-0.5, 0.2]", "form = [-0.5, 0.2]"),
        ("point of four numbers", "[-0.5, 0.2]", "[-0.5, 0.2, 0, 1]"),
        ("ray without direction", "towards = [8.2, 3.9]", "towards = [-0.5, 0.2]"),
        ("towards and direction", "towards = [8.2, 3.9]", "towards = [8.2, 3.9], direction = [1, 0]"),
        ("broken promise", "\"drop\"", "\"split.far\""),
        ("misspelt promise", "\"drop\"", "\"dorp\""),
        ("unknown play", "title = \"First\"", "title = \"First\"\nplays = \"biuld\""),
        ("rays of a build", "title = \"First\"", "title = \"First\"\nplays = \"build\""),
        ("no stage", "[flat]", "[flach]"),
        ("text above the beats", "## The plane", "Hello.\n\n## The plane"),
        ("no beats", "## ", "### "),
        ("beat without event", "{at=plane}", ""),
        ("empty heading", "## The plane {", "## {"),
        ("braces not closed", "{at=plane}", "{at=plane"),
        ("misspelt event", "at=split.both", "at=split.bth"),
        ("unknown event", "at=split.both", "at=explosion"),
        ("misspelt attribute", "ray=\"far hit\"", "rya=\"far hit\""),
        ("unknown ray", "ray=\"far hit\"", "ray=\"far hitt\""),
        ("quotation mark not closed", "ray=\"far hit\"", "ray=\"far hit"),
        ("beat that never happens", "at=drop", "at=skip"),
        ("beat after the end", "at=plane", "at=end"),
        ("the hundredth of few", "at=drop", "at=drop#100"),
        ("number is no number", "at=drop", "at=drop#two"),
        ("condition on an unknown field", "at=drop", "at=drop dept=0"),
        ("condition that cannot be", "side=both", "side=bth"),
        ("unknown field in the text", "{{plane}}", "{{plain}}"),
        ("field that this event lacks", "{{best_t}}", "{{plane}}"),
        ("field not closed", "{{best_t}}", "{{best_t}"),
        ("question about an unknown field", "field=near", "field=nera"),
        ("question about nothing", "{field=near}", "{}"),
        ("question without text", "Which child first?", ""),
        ("unknown attribute of a question", "{field=near}", "{feld=near}"),
        ("reason for no answer", "- far: Only", "- fra: Only"),
        ("answer without reason", "- far: Only", "- far Only"),
        ("no question", "> ask {field=near}: Which child first?\n> - far: Only later.\n", ""),
        ("condition without a comparison", "> if side=both", "> if side"),
        ("condition on an event that is none", "> if side=both", "> if plain.t=3"),
        ("comparison of what is no number", "> if side=both", "> if side<3"),
        ("stage that is none", "> if side=both", "> if stage=sollid"),
        ("text without a colon", "> if side=both: Both.", "> paper if side=both"),
        ("count of an unknown event", "{{plane}}", "{{count.plain}}"),
        ("field that an earlier event lacks", "{{best_t}}", "{{push.best_t}}"),
        ("what never happened before", "It stands at {{plane}}.", "It stands at {{drop.t_near}}."),
        ("nothing is played beside", "{{best_t}}", "{{beside.count.test}}"),
        ("beside is an unknown structure", "min_objects = 2 }", "min_objects = 2 }\nbeside = { kind = \"kt\" }"),
        ("unknown offer", "The best is {{best_t}}.", "> window: [Go](go:home)"),
        ("offer on paper", "The best is {{best_t}}.", "[Less](set:max_depth=3)"),
        ("offer of a wrong parameter", "The best is {{best_t}}.", "> window: [Less](set:max_dept=3)"),
        ("offer of no value", "The best is {{best_t}}.", "> window: [Less](set:max_depth)"),
        ("offer of an unknown slide", "The best is {{best_t}}.", "> window: [On](slide:9/9)"),
        ("comparison with itself", "The best is {{best_t}}.", "> window: [Both](compare:kd)"),
        ("comparison with nothing", "The best is {{best_t}}.", "> window: [Both](compare:kt)"),
        ("other event on the solid stage", "{at=drop}", "{at=drop solid=pop}"),
        ("one bracket missing", "slide = [33, 38]", "slide = [33, 38"),
        ("one quotation mark missing", "listing = \"walk\"", "listing = \"walk"),
        ("no number at all", "slide = [33, 38]", "slide = []"),
        ("number that is a path", "slide = [33, 38]", "slide = \"../33\""),
        ("same number twice", "slide = [33, 38]", "slide = [33, 33]"),
        ("opens on a stage that is not there", "title = \"First\"", "title = \"First\"\nopens = \"solid\""),
        ("a layout that there is not", "title = \"First\"", "title = \"First\"\nlayout = \"pared\""),
        ("a layout of bytes that are not shown", "title = \"First\"", "title = \"First\"\nlayout = \"paired\""),
        ("opens on nothing", "title = \"First\"", "title = \"First\"\nopens = \"sollid\""),
        ("text for a stage that is not", "> if side=both", "> if stage=sollid"),
        ("quote that neither asks nor depends", "> if side=both", "> when side=both"),
        ("camera from nowhere", "rays = [", "camera = { center = [nan, 0], half_height = 3 }\nrays = ["),
        ("camera of no height", "rays = [", "camera = { center = [0, 0], half_height = 0 }\nrays = ["),
        ("camera of negative height", "rays = [", "camera = { center = [0, 0], half_height = -3 }\nrays = ["),
        ("camera on a grain", "rays = [", "camera = { center = [4, 3], half_height = 1e-5 }\nrays = ["),
        ("camera on a speck", "rays = [", "camera = { center = [4, 3], half_height = 0.002 }\nrays = ["),
        ("camera from afar", "rays = [", "camera = { center = [4, 3], half_height = 1e6 }\nrays = ["),
        ("camera beside the scene", "rays = [", "camera = { center = [400, 3], half_height = 3 }\nrays = ["),
        ("camera past the scene", "rays = [", "camera = { center = [20, 3], half_height = 3 }\nrays = ["),
        ("camera without a height", "rays = [", "camera = { center = [4, 3], half_hight = 3 }\nrays = ["),
        ("nothing to choose between", "The best is", "> ask {field=node}: Which?\n\nThe best is"),
    ];
    let mut table = String::new();
    for (what, from, to) in mistakes {
        let found = if what == "no question" || what == "no beats" {
            of_files(&SLIDE.replace(from, to), LISTING)
        } else {
            said(from, to)
        };
        assert!(!found.is_empty(), "{what} goes unnoticed");
        table += &format!("{what}\n{found}");
    }
    for (what, camera) in [
        ("eye at the target", "eye = [1, 2, 3], target = [1, 2, 3]"),
        ("eye in the target", "eye = [1e-20, 0, 0], target = [0, 0, 0]"),
        ("eye at no number", "eye = [nan, 2, 3], target = [1, 2, inf]"),
        ("up along the view", "eye = [0, 0, 9], target = [0, 0, 0]"),
        ("up is nothing", "eye = [0, 9, 0], target = [0, 0, 0], up = [0, 0, 0]"),
        ("angle of nothing", "eye = [0, 9, 0], target = [0, 0, 0], fov_degrees = 0"),
        ("angle behind the eye", "eye = [0, 9, 0], target = [0, 0, 0], fov_degrees = 180"),
        ("eye too far", "eye = [0, 9e5, 0], target = [0, 0, 0]"),
        ("looks away", "eye = [100, 2, 3], target = [200, 2, 3], up = [0, 0, 1]"),
    ] {
        let solid = SLIDE.replace("[flat]", &format!("[solid]\ncamera = {{ {camera} }}"));
        let solid = solid.replace("flat-twelve", "teapot-6321").replace(", promise = [\"drop\"]", "");
        let solid = solid.replace("{at=drop}\nThe best is {{best_t}}.", "{at=end}");
        let found = of_files(&solid, LISTING);
        assert!(!found.is_empty(), "{what} goes unnoticed");
        table += &format!("{what}\n{found}");
    }
    for (what, listing) in [
        ("listing with an unknown event", LISTING.replace("| end", "| ende")),
        ("listing with an unknown field", LISTING.replace("{{t}}", "{{tt}}")),
        ("listing with a wrong condition", LISTING.replace("| plane :", "| plane if dd=0 :")),
        ("listing without a line for an event", LISTING.replace("push", "")),
    ] {
        table += &format!("{what}\n{}", of_files(SLIDE, &listing));
    }
    insta::assert_snapshot!(table);
}

#[test]
fn a_wrong_change_is_named_with_its_place() {
    let slide = |kind: &str, change: &str| {
        let structure = format!("structure = {{ kind = \"{kind}\" }}");
        let head = "format = 1\nslide = \"44b\"\ntitle = \"One disc moves\"\nplays = \"build\"\nlisting = \"walk\"";
        let ask = "> ask {field=nodes}: How many?\n> - else: {{nodes}}.";
        let scene = "scene = \"flat-corner-moved\"";
        format!("+++\n{head}\n{scene}\n{structure}\nchange = {change}\n+++\n## It stands {{at=end}}\n{ask}\n")
    };
    let mistakes = [
        ("none", "octree", "[{ delete = 8 }, { insert = 10 }, { delete = 10 }, { insert = 8 }]"),
        ("of a kd-tree", "kd", "[{ delete = 8 }]"),
        ("no such primitive", "octree", "[{ delete = 80 }]"),
        ("half a primitive", "octree", "[{ delete = 0.5 }]"),
        ("both at once", "octree", "[{ delete = 8, insert = 10 }]"),
        ("neither", "octree", "[{ remove = 8 }]"),
        ("deleted twice", "octree", "[{ delete = 8 }, { delete = 8 }]"),
        ("inserted twice", "octree", "[{ insert = 10 }, { insert = 10 }]"),
        ("no list", "octree", "8"),
    ];
    let said = mistakes.map(|(what, kind, change)| format!("{what}\n{}", of_files(&slide(kind, change), LISTING)));
    insta::assert_snapshot!(said.join("\n"));
}
