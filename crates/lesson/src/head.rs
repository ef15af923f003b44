//! The head of a slide: TOML between two lines of `+++`.

mod stage;

use raystep_accel::KdLayout;
use toml::de::{DeTable, DeValue};

use crate::counts::{check_count, check_length};
use crate::keys::{At, FromToml, Keys};
use crate::problem::{misspelt, short};
use crate::reading::Reading;
use crate::{Plays, Show, Spot, Stage, StageKind, limits};

/// The format that this program reads.
const FORMAT: f32 = 1.0;

/// What a head says.
#[derive(Default)]
pub(crate) struct Head {
    pub(crate) numbers: Vec<String>,
    pub(crate) numbers_spot: Spot,
    pub(crate) title: String,
    pub(crate) title_spot: Spot,
    pub(crate) listing: String,
    pub(crate) listing_spot: Spot,
    pub(crate) show: Vec<Show>,
    pub(crate) layout: Option<KdLayout>,
    pub(crate) stages: Vec<Stage>,
    pub(crate) opens: Option<StageKind>,
}

/// Reads a head; none if it is no TOML. `text` is the file up to the head's end, its first `+++` blanked, so that a byte of it is
/// the same byte of the file.
pub(crate) fn read(text: &str, reading: &mut Reading<'_>) -> Option<Head> {
    let (table, errors) = DeTable::parse_recoverable(text);
    // What follows the first mistake is read wrongly because of it.
    if let Some(error) = errors.iter().min_by_key(|error| error.span().map_or(0, |span| span.start)) {
        let message = format!("the head is no TOML: {}", short_lines(error.message()));
        reading.problem(error.span().map_or(0, |span| span.start), message);
        return None;
    }
    let mut keys = Keys::new(table.get_ref(), 0);

    if let Some((at, format)) = keys.need::<f32>("format", reading)
        && format != FORMAT
    {
        reading.problem(at, format!("format {format} is not known here: this program reads format {FORMAT}"));
    }
    let (numbers_at, numbers) = numbers(&mut keys, reading);
    let (title_at, title) = keys.need::<String>("title", reading).unwrap_or_default();
    if title_at > 0 && title.trim().is_empty() {
        reading.problem(title_at, "the title is empty");
    } else {
        check_length("the title", title_at, &title, reading);
    }
    // Everything that follows names the events of what is played.
    reading.plays = plays(&mut keys, reading);
    let listing = match reading.plays {
        // No algorithm runs on a board, and no one algorithm where several structures are walked.
        Plays::Board | Plays::Walks | Plays::Pairs => keys.get::<String>("listing", reading),
        Plays::Walk | Plays::Build | Plays::Packet | Plays::Fit => keys.need::<String>("listing", reading),
    };
    let (listing_at, listing) = listing.unwrap_or_default();
    let show = show(&mut keys, reading);
    let layout = layout(&mut keys, &show, reading);

    // Two stages in tables of their own, or one whose keys stand in the head itself.
    let mut stages = Vec::new();
    for kind in StageKind::ALL {
        if let Some(mut table) = keys.table(kind.name(), reading) {
            stages.extend(stage::stage(kind, &mut table, reading));
            table.finish(reading);
        }
    }
    if !keys.has("flat") && !keys.has("solid") {
        stages.extend(stage::stage_in_head(&mut keys, reading));
    }
    let opens = opens(&mut keys, &stages, reading);
    keys.finish(reading);
    let [numbers_spot, title_spot, listing_spot] = [numbers_at, title_at, listing_at].map(|at| reading.spot(at));
    Some(Head { numbers, numbers_spot, title, title_spot, listing, listing_spot, show, layout, stages, opens })
}

/// A message in one line.
fn short_lines(message: &str) -> String {
    message.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The slide's numbers, and where they stand: they name the slide, on the command line and in names of files.
fn numbers(keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> At<Vec<String>> {
    let Some((at, Numbers(mut numbers))) = keys.need::<Numbers>("slide", reading) else { return At::default() };
    if numbers.is_empty() {
        reading.problem(at, format!("`slide` is empty here, but should be {}", Numbers::WHAT));
    }
    if !check_count("numbers", at, numbers.len(), limits::ENTRIES, reading) {
        numbers.truncate(limits::ENTRIES);
    }
    for index in 0..numbers.len() {
        let number = &numbers[index];
        if !is_number(number) {
            let number = short(number);
            reading.problem(at, format!("`{number}` is no slide's number: write up to four digits, with a letter or two behind them if need be, as in \"13a\""));
        } else if numbers[..index].contains(number) {
            reading.problem(at, format!("the number {number} is there twice"));
        }
    }
    numbers.retain(|number| is_number(number));
    (at, numbers)
}

/// Whether it is up to four digits and perhaps a letter or two.
fn is_number(text: &str) -> bool {
    let digits = text.bytes().take_while(u8::is_ascii_digit).count();
    let letters = &text[digits..];
    (1..=4).contains(&digits) && letters.len() <= 2 && letters.bytes().all(|letter| letter.is_ascii_lowercase())
}

/// The stage that the slide opens on, if it says one.
fn opens(keys: &mut Keys<'_>, stages: &[Stage], reading: &mut Reading<'_>) -> Option<StageKind> {
    let (at, name) = keys.get::<String>("opens", reading)?;
    let Some(kind) = StageKind::ALL.into_iter().find(|kind| kind.name() == name) else {
        reading.problem(at, misspelt("stage", &name, &StageKind::ALL.map(StageKind::name)));
        return None;
    };
    // A stage that could not be read has been told already.
    if !stages.is_empty() && !stages.iter().any(|stage| stage.kind == kind) && !keys.has(kind.name()) {
        reading.problem(at, format!("the slide opens on a {name} stage, but has none: write a table [{name}]"));
        return None;
    }
    Some(kind)
}

/// What the slide plays: a walk if it does not say.
fn plays(keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Plays {
    let Some((at, name)) = keys.get::<String>("plays", reading) else { return Plays::default() };
    let known = Plays::ALL.into_iter().find(|plays| plays.name() == name);
    known.unwrap_or_else(|| {
        reading.problem(at, misspelt("thing to play", &name, &Plays::ALL.map(Plays::name)));
        Plays::default()
    })
}

/// The panes that a slide shows; space and the listing if it does not say.
fn show(keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Vec<Show> {
    let Some((at, names)) = keys.get::<Vec<String>>("show", reading) else {
        return vec![Show::Space, Show::Listing];
    };
    let mut show = Vec::new();
    for name in names.into_iter().take(limits::ENTRIES) {
        match Show::NAMES.iter().find(|(known, _)| *known == name) {
            Some((_, pane)) => show.push(*pane),
            None => reading.problem(at, misspelt("pane", &name, &Show::NAMES.map(|(known, _)| known))),
        }
    }
    show
}

/// The last layout of a node that its bytes are shown in: the last of all if the slide does not say.
fn layout(keys: &mut Keys<'_>, show: &[Show], reading: &mut Reading<'_>) -> Option<KdLayout> {
    let (at, name) = keys.get::<String>("layout", reading)?;
    let known = KdLayout::ALL.iter().copied().find(|layout| layout.word() == name);
    if known.is_none() {
        reading.problem(at, misspelt("layout of nodes", &name, KdLayout::WORDS));
    } else if !show.contains(&Show::Bytes) {
        reading.problem(at, "`layout` says which bytes of a node are shown: write \"bytes\" among the panes of `show`");
    }
    known
}

/// The numbers of slides: 33, "13a", or several.
struct Numbers(Vec<String>);

impl FromToml for Numbers {
    const WHAT: &'static str = "a slide's number, or several: 33, \"13a\", [33, 38]";

    fn from_toml(value: &DeValue<'_>) -> Option<Numbers> {
        let one = |value: &DeValue<'_>| match value {
            DeValue::Integer(number) => Some(number.to_string()),
            DeValue::String(text) => Some(text.to_string()),
            _ => None,
        };
        match value.as_array() {
            Some(list) => list.iter().map(|value| one(value.get_ref())).collect::<Option<_>>().map(Numbers),
            None => one(value).map(|number| Numbers(vec![number])),
        }
    }
}
