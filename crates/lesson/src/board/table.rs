//! A table: rows of named things, columns of what was printed, what follows from it, and what is measured here.

use raystep_accel::{BvhVolume, Cost, KdLayout, Width};
use raystep_fast::FastKind;

use crate::check::PACKET_KINDS;
use crate::keys::Keys;
use crate::problem::{listed, misspelt};
use crate::reading::Reading;
use crate::{Plan, Spot, head, limits, template};

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
}

impl Column {
    /// All of them, with the names that slides and facts give them.
    pub const NAMES: [(&'static str, Column); 14] = [
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

    /// Whether it is measured here.
    pub fn is_measured(self) -> bool {
        !matches!(self, Column::Printed | Column::Total | Column::Computed)
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
    let plan = keys.table("structure", reading).and_then(|mut table| head::plan(&mut table, reading));
    let volume = volume(&mut keys, reading);
    let fast = fast(&mut keys, plan.as_ref(), reading);
    let how = how(&mut keys, plan.as_ref(), reading);
    let mut cells = Vec::new();
    for column in [Column::Printed, Column::Total] {
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

/// `fast = "fast-bvh8"`: a structure of the last chapter at full speed.
fn fast(keys: &mut Keys<'_>, plan: Option<&Plan>, reading: &mut Reading<'_>) -> Option<FastKind> {
    let (at, name) = keys.get::<String>("fast", reading)?;
    let known = FastKind::ALL.into_iter().find(|kind| kind.name() == name);
    if known.is_none() {
        reading.problem(at, misspelt("fast structure", &name, &FastKind::ALL.map(FastKind::name)));
    } else if plan.is_some() {
        reading.problem(at, "a row measures one structure: either `structure` or `fast`");
    }
    known
}

/// `lanes = 4`, `layout = "plain"`: how the row's structure is walked and stored.
fn how(keys: &mut Keys<'_>, plan: Option<&Plan>, reading: &mut Reading<'_>) -> How {
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
    How { lanes, layout }
}
