//! A table: rows of named things, columns of what was printed, what follows from it, and what is measured here.

use raystep_accel::{BvhVolume, Cost, KdLayout, Width};
use raystep_fast::FastKind;

use crate::check::PACKET_KINDS;
use crate::keys::Keys;
use crate::problem::{listed, misspelt};
use crate::reading::Reading;
use crate::{Plan, Spot, limits, template};

use super::{Formula, How, Numbers};

/// A table of a board.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// What it is about, in a few words.
    pub title: String,
    /// What stands behind the title.
    pub about: String,
    /// What a row is: the head of the first column.
    pub of: String,
    /// What is told of each row.
    pub columns: Vec<(Column, String)>,
    /// The rows.
    pub rows: Vec<Row>,
}

/// What a column tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Column {
    /// A number as the lecture prints it, word for word.
    Printed,
    /// A total as the lecture prints it.
    Total,
    /// What follows from printed numbers.
    Computed,
    /// Tests of primitives, a ray, measured here.
    Tests,
    /// Nodes or cells entered, a ray, measured here.
    Visits,
    /// Volumes tested, a ray, measured here.
    Boxes,
    /// Nodes or cells of the structure.
    Nodes,
    /// Bytes of the structure, or of the volume.
    Bytes,
    /// How much room the volume encloses, measured here.
    Content,
    /// Its surface.
    Area,
    /// How many planes bound it.
    Planes,
    /// Slabs, faces or equations that a test of it takes, in the mean.
    Cuts,
    /// Of the rays that meet it, the share that meet nothing in it.
    Vain,
    /// Lanes of a packet that took part in a visit.
    Alive,
    /// Millions of rays a second, timed here.
    Speed,
    /// The slowest and the quickest round of them.
    Spread,
    /// Microseconds of a ray.
    Time,
    /// Milliseconds of the building.
    Build,
    /// Of the time of a picture, the part in which rays are intersected.
    Share,
    /// Seconds of a picture of a million rays.
    Picture,
    /// Words of the slide: what was.
    Before,
    /// Words of the slide: what has come of it.
    After,
}

/// On what a structure runs that is timed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Runs {
    /// On one thread.
    #[default]
    Alone,
    /// On all threads.
    Threads,
    /// On a graphics card.
    GraphicsCard,
}

/// Which instructions a fast structure is walked with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lanes {
    /// What the compiler makes of plain arrays.
    Portable,
    /// Those of that name.
    Named(&'static str),
}

impl Lanes {
    /// How slides write them.
    const NAMES: [(&'static str, Lanes); 3] =
        [("portable", Lanes::Portable), ("avx2", Lanes::Named("avx2")), ("avx512", Lanes::Named("avx512"))];
}

impl Column {
    /// All of them, with the names that slides and facts give them.
    pub const NAMES: [(&'static str, Column); 22] = [
        ("printed", Column::Printed),
        ("total", Column::Total),
        ("computed", Column::Computed),
        ("tests", Column::Tests),
        ("visits", Column::Visits),
        ("boxes", Column::Boxes),
        ("nodes", Column::Nodes),
        ("bytes", Column::Bytes),
        ("content", Column::Content),
        ("area", Column::Area),
        ("planes", Column::Planes),
        ("cuts", Column::Cuts),
        ("vain", Column::Vain),
        ("alive", Column::Alive),
        ("speed", Column::Speed),
        ("spread", Column::Spread),
        ("time", Column::Time),
        ("build", Column::Build),
        ("share", Column::Share),
        ("seconds", Column::Picture),
        ("before", Column::Before),
        ("after", Column::After),
    ];

    /// What can be counted of a ray.
    pub const COUNTS: [Column; 3] = [Column::Tests, Column::Visits, Column::Boxes];

    /// What a ray has cost, of those that can be counted: tests of primitives where it is none of them.
    pub fn count(self, cost: &Cost) -> u64 {
        match self {
            Column::Visits => cost.node_visits + cost.cell_steps,
            Column::Boxes => cost.box_tests,
            _ => cost.prim_tests,
        }
    }

    /// How slides write it.
    pub fn name(self) -> &'static str {
        Column::NAMES[self as usize].0
    }

    /// Whether it is a time, or follows from one: such numbers differ from machine to machine.
    pub fn is_timed(self) -> bool {
        use Column::{Build, Picture, Share, Speed, Spread, Time};
        matches!(self, Speed | Spread | Time | Build | Share | Picture)
    }

    /// Whether it is measured here.
    pub fn is_measured(self) -> bool {
        !matches!(self, Column::Printed | Column::Total | Column::Computed | Column::Before | Column::After)
    }
}

/// A row of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// What it is about; it may name its own numbers and those of the meter, as in `{{Nx}} pixels`.
    pub name: String,
    /// A few words behind its name; it may name them, too.
    pub note: String,
    /// What its cells hold, but for what is measured.
    pub cells: Vec<(Column, Cell)>,
    /// What is built and measured for it.
    pub plan: Option<Plan>,
    /// The volume around everything that is measured for it.
    pub volume: Option<BvhVolume>,
    /// The fast structure that is measured for it instead of a textbook's.
    pub fast: Option<FastKind>,
    /// How that is walked and stored.
    pub how: How,
    /// The name of the scene that it is measured over; the board's own if it has none.
    pub scene: Option<String>,
    /// When it comes to be seen, among everything on the board.
    pub(crate) step: Option<f32>,
    /// Where it stands.
    pub(crate) spot: Spot,
}

/// What stands in a cell.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// Words, as they are.
    Text(String),
    /// What a formula gives, and what stands behind the number.
    Value(Formula, String),
}

impl Cell {
    /// Its number where the numbers of the meter stand; no number where it holds words.
    pub fn number(&self, numbers: &Numbers) -> f64 {
        match self {
            Cell::Text(text) => {
                let digits: String = text.chars().filter(|c| *c != ',').collect();
                let word = digits.split_whitespace().next().unwrap_or_default();
                word.trim_end_matches(['\u{d7}', '%']).parse().unwrap_or(f64::NAN)
            }
            Cell::Value(formula, _) => formula.at(0.0, numbers),
        }
    }
}

/// Reads `[[table]]`.
pub(super) fn read(keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Option<Table> {
    let (title, about) = (keys.need::<String>("title", reading), keys.get::<String>("about", reading));
    let of = keys.get::<String>("of", reading);
    let columns = keys.tables("columns", reading).into_iter().filter_map(|keys| column(keys, reading)).collect();
    let rows = keys.tables("rows", reading).into_iter().filter_map(|keys| row(keys, reading)).collect();
    let table =
        Table { title: title?.1, about: about.unwrap_or_default().1, of: of.unwrap_or_default().1, columns, rows };
    let at = keys.at();
    let measures = table.columns.iter().any(|(column, _)| column.is_measured());
    if table.columns.is_empty() || table.rows.is_empty() {
        reading.problem(at, "a table has columns and rows, one or more of each");
    } else if measures && table.rows.iter().all(|row| row.plan.is_none() && row.volume.is_none() && row.fast.is_none())
    {
        reading.problem(at, "nothing is measured: give a row `structure = { kind = \"...\" }` or `volume = \"...\"`");
    }
    Some(table)
}

/// `{ tells = "printed", head = "as printed" }`
fn column(mut keys: Keys<'_>, reading: &mut Reading<'_>) -> Option<(Column, String)> {
    let (tells, head) = (keys.need::<String>("tells", reading), keys.need::<String>("head", reading));
    keys.finish(reading);
    let ((at, tells), (_, head)) = (tells?, head?);
    let known = Column::NAMES.iter().find(|(name, _)| *name == tells);
    if known.is_none() {
        reading.problem(at, misspelt("column", &tells, &Column::NAMES.map(|(name, _)| name)));
    }
    Some((known?.1, head))
}

/// `volume = "sphere"`: a single volume around everything.
pub(super) fn volume(keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Option<BvhVolume> {
    let (at, word) = keys.get::<String>("volume", reading)?;
    let known = BvhVolume::ALL.iter().find(|volume| volume.word() == word);
    if known.is_none() {
        reading.problem(at, misspelt("volume", &word, BvhVolume::WORDS));
    }
    known.copied()
}

/// `{ name = "Uniform grid", structure = { kind = "grid" }, printed = "44.86", computed = "26336575 / 44.86" }`
fn row(mut keys: Keys<'_>, reading: &mut Reading<'_>) -> Option<Row> {
    let (name, note) = (keys.need::<String>("name", reading), keys.get::<String>("note", reading));
    let step = keys.get::<f32>("step", reading);
    let scene = keys.get::<String>("scene", reading).map(|(_, scene)| scene);
    let spot = reading.spot(keys.at());
    let plan = keys.table("structure", reading).and_then(|mut table| Plan::read(&mut table, reading));
    let volume = volume(&mut keys, reading);
    let fast = fast(&mut keys, plan.as_ref(), reading);
    let at = keys.at();
    moves(plan.as_ref(), true, at, reading);
    let how = how(&mut keys, plan.as_ref(), fast, reading);
    let mut cells = Vec::new();
    for column in [Column::Printed, Column::Total, Column::Before, Column::After] {
        if let Some((at, text)) = keys.get::<String>(column.name(), reading) {
            if text.chars().count() > limits::TITLE {
                reading.problem(at, format!("a cell has at most {} letters", limits::TITLE));
            }
            cells.push((column, Cell::Text(text)));
        }
    }
    let unit = keys.get::<String>("unit", reading).unwrap_or_default().1;
    if let Some((at, text)) = keys.get::<String>(Column::Computed.name(), reading)
        && let Some(formula) = Formula::read(&text, at, &[], reading)
    {
        // What is printed stands still, and so does what it is compared with.
        if formula.is_moved() && !cells.is_empty() {
            reading.problem(at, format!("`{text}` moves with the meter: a printed number cannot stand beside it"));
        }
        cells.push((Column::Computed, Cell::Value(formula, unit)));
    }
    keys.finish(reading);
    for (at, words) in [&name, &note].into_iter().flatten() {
        template::check_said(words, *at, "row", reading);
    }
    Some(Row {
        name: name?.1,
        note: note.unwrap_or_default().1,
        cells,
        plan,
        volume,
        fast,
        how,
        scene,
        spot,
        step: step.map(|(_, step)| step),
    })
}

/// Says so if a plan follows numbers that the meter has not, or follows any where nothing `can` move.
pub(super) fn moves(plan: Option<&Plan>, can: bool, at: usize, reading: &mut Reading<'_>) {
    for setting in plan.iter().flat_map(|plan| &plan.settings) {
        for name in template::named(&setting.value) {
            if !can {
                reading
                    .problem(at, format!("`{}` cannot move with the meter here: it moves rows and maps", setting.key));
            } else if !reading.numbers.iter().any(|known| known == name) {
                let known: Vec<&str> = reading.numbers.iter().map(String::as_str).collect();
                let message = misspelt("number of the meter", name, &known);
                reading.problem(at, message);
            }
        }
    }
}

/// `fast = "fast-bvh8"`: a structure of the last chapter at full speed.
pub(super) fn fast(keys: &mut Keys<'_>, plan: Option<&Plan>, reading: &mut Reading<'_>) -> Option<FastKind> {
    let (at, name) = keys.get::<String>("fast", reading)?;
    let known = FastKind::ALL.into_iter().find(|kind| kind.name() == name);
    if known.is_none() {
        reading.problem(at, misspelt("fast structure", &name, &FastKind::ALL.map(FastKind::name)));
    } else if plan.is_some() {
        reading.problem(at, "a row measures one structure: either `structure` or `fast`");
    }
    known
}

/// `lanes = 4`, `layout = "plain"`, `runs = "threads"`, `isa = "portable"`: how the row's structure is walked and stored.
fn how(keys: &mut Keys<'_>, plan: Option<&Plan>, fast: Option<FastKind>, reading: &mut Reading<'_>) -> How {
    let kind = plan.map_or("", |plan| plan.kind.as_str());
    let lanes = keys.get::<f32>("lanes", reading).and_then(|(at, lanes)| {
        let width = Width::ALL.iter().copied().find(|width| width.lanes() as f32 == lanes);
        if width.is_none() {
            reading
                .problem(at, format!("`lanes` is {lanes}: rays are measured in packets of {}", listed(Width::WORDS)));
        } else if !PACKET_KINDS.contains(&kind) {
            reading.problem(at, format!("packets do not walk this structure: they walk {}", listed(&PACKET_KINDS)));
        }
        width
    });
    let layout = keys.get::<String>("layout", reading).and_then(|(at, name)| {
        let layout = KdLayout::ALL.iter().copied().find(|layout| layout.word() == name);
        if layout.is_none() {
            reading.problem(at, misspelt("layout of nodes", &name, KdLayout::WORDS));
        } else if kind != "kd" {
            reading.problem(at, "only the nodes of a kd-tree, `kind = \"kd\"`, are laid out in several ways");
        }
        layout
    });
    let runs = keys.get::<String>("runs", reading).and_then(|(at, name)| {
        const RUNS: [(&str, Runs); 2] = [("threads", Runs::Threads), ("gpu", Runs::GraphicsCard)];
        let runs = RUNS.into_iter().find(|(known, _)| *known == name);
        match (runs, fast) {
            (None, _) => reading.problem(at, misspelt("way to run", &name, &RUNS.map(|(known, _)| known))),
            (Some((_, Runs::GraphicsCard)), kind) if kind != Some(FastKind::Bvh2) => {
                reading.problem(at, "a graphics card walks `fast = \"fast-bvh2\"` alone");
            }
            (Some(_), None) => reading.problem(at, "only a `fast` structure runs on `threads`"),
            (Some(_), Some(_)) => {}
        }
        runs.map(|(_, runs)| runs)
    });
    let isa = keys.get::<String>("isa", reading).and_then(|(at, name)| {
        let isa = Lanes::NAMES.into_iter().find(|(known, _)| *known == name);
        if isa.is_none() {
            reading.problem(at, misspelt("set of instructions", &name, &Lanes::NAMES.map(|(known, _)| known)));
        } else if fast.is_none() {
            reading.problem(at, "only a `fast` structure is walked with instructions of one's choice");
        }
        isa.map(|(_, isa)| isa)
    });
    How { lanes, layout, runs: runs.unwrap_or_default(), isa }
}
