//! Heat maps: what each ray of a picture costs, through several structures on one scale.

use crate::keys::Keys;
use crate::problem::misspelt;
use crate::reading::Reading;
use raystep_fast::FastKind;

use crate::{Plan, template};

use super::{Column, table};

/// Heat maps beside each other, on one scale.
#[derive(Clone, Debug, PartialEq)]
pub struct Maps {
    /// What they are about, in a few words.
    pub title: String,
    /// What stands behind the title.
    pub about: String,
    /// What is counted: tests, visits or boxes.
    pub of: Column,
    /// The maps.
    pub maps: Vec<Map>,
}

/// A heat map.
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    /// What it is called.
    pub name: String,
    /// What is built for it.
    pub plan: Option<Plan>,
    /// The fast structure that is built instead.
    pub fast: Option<FastKind>,
    /// When it comes to be seen, among everything on the board.
    pub(crate) step: Option<f32>,
}

/// Reads `[[heat]]`.
pub(super) fn read(keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Option<Maps> {
    let (title, about) = (keys.need::<String>("title", reading), keys.get::<String>("about", reading));
    let of = match keys.get::<String>("of", reading) {
        None => Some(Column::Tests),
        Some((at, of)) => {
            let known = Column::COUNTS.into_iter().find(|column| column.name() == of);
            if known.is_none() {
                reading.problem(at, misspelt("count", &of, &Column::COUNTS.map(Column::name)));
            }
            known
        }
    };
    let mut maps = Vec::new();
    for mut keys in keys.tables("maps", reading) {
        let (name, step) = (keys.need::<String>("name", reading), keys.get::<f32>("step", reading));
        let plan = keys.table("structure", reading).and_then(|mut table| Plan::read(&mut table, reading));
        let at = keys.at();
        table::moves(plan.as_ref(), true, at, reading);
        let fast = table::fast(&mut keys, plan.as_ref(), reading);
        if plan.is_none() && fast.is_none() && !keys.has("structure") && !keys.has("fast") {
            reading.problem(keys.at(), "`structure` is missing: write `structure = { kind = \"kd\" }`");
        }
        keys.finish(reading);
        if let Some((at, name)) = &name {
            template::check_said(name, *at, "map", reading);
        }
        if let (Some((_, name)), true) = (name, plan.is_some() || fast.is_some()) {
            maps.push(Map { name, plan, fast, step: step.map(|(_, step)| step) });
        }
    }
    if maps.is_empty() || maps.len() > 3 {
        reading.problem(keys.at(), "from one to three `maps` stand beside each other");
    }
    Some(Maps { title: title?.1, about: about.unwrap_or_default().1, of: of?, maps })
}
