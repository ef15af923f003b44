//! The body of a slide: headings, paragraphs, and block quotes that ask or depend.

use crate::attributes::{self, Attribute};
use crate::problem::misspelt;
use crate::reading::Reading;
use crate::vocabulary::{check_event, check_field};
use crate::{About, Ask, Beat, Condition, Medium, Paragraph, Plays, Reason, Spot, Wait, limits, offer, template, wait};

/// A line of the body with the byte where it begins.
type Line<'a> = (usize, &'a str);

/// Reads the beats in `lines`.
pub(crate) fn read(lines: &[Line<'_>], reading: &mut Reading<'_>) -> Vec<Beat> {
    let heading = |line: &Line<'_>| line.1.starts_with("## ") || line.1.trim_end() == "##";
    let first = lines.iter().position(heading).unwrap_or(lines.len());
    if let Some((at, _)) = lines[..first].iter().find(|(_, line)| !line.trim().is_empty()) {
        reading.problem(*at, "text stands below a heading: begin with `## Title {at=event}`");
    }
    if let Some((at, _)) = lines.iter().filter(|line| heading(line)).nth(limits::BEATS) {
        reading.problem(*at, format!("a slide has at most {} beats: this is one more", limits::BEATS));
        return Vec::new();
    }
    lines[first..].chunk_by(|_, next| !heading(next)).filter_map(|lines| beat(lines, reading)).collect()
}

/// One beat: its heading and what is below it.
fn beat(lines: &[Line<'_>], reading: &mut Reading<'_>) -> Option<Beat> {
    let (&(at, heading), below) = lines.split_first()?;
    let text = heading.trim_start_matches("##");
    let (title, braces) = braces(text, at + heading.len() - text.len(), reading);
    let letters = title.trim().chars().count();
    if letters == 0 {
        reading.problem(at, "the heading has no title: write `## Title {at=event}`");
    } else if letters > limits::TITLE {
        reading.problem(at, format!("the heading has {letters} letters: at most {} can be shown", limits::TITLE));
    }
    // What stands between the braces could not be read.
    let braces = braces?;
    let (mut waits, mut solid, mut ray, mut of) = (None, None, None, None);
    let mut fields = Vec::new();
    for Attribute { key, key_at, value, value_at } in braces {
        match key.as_str() {
            "at" => waits = Some((value_at, value)),
            "solid" => solid = Some((value_at, value)),
            "ray" if !reading.plays.has_rays() => {
                let message = match reading.plays {
                    Plays::Pairs => "pairs have no rays: their beats name none".to_owned(),
                    plays => format!("a {} has no rays: its beats name none", plays.name()),
                };
                reading.problem(key_at, message);
            }
            "ray" => ray = Some((value_at, value)),
            "of" if !reading.abreast.is_empty() => {
                if !reading.abreast.contains(&value) {
                    let known: Vec<&str> = reading.abreast.iter().map(String::as_str).collect();
                    let message = misspelt("structure of the stage", &value, &known);
                    reading.problem(value_at, message);
                }
                of = Some(value);
            }
            _ => fields.push((key_at, key, value)),
        }
    }
    let Some((wait_at, event)) = waits else {
        reading.problem(at, "a heading says which event it waits for: `## Title {at=split.both}`");
        return None;
    };
    let mut at_event = wait::parse(&event, wait_at, reading)?;
    at_event.of = of;
    let mut at_solid = solid.and_then(|(at, event)| wait_on_solid(&event, at, &at_event, reading));
    for (key_at, key, value) in fields {
        if check_condition(&at_event, &key, key_at, reading) {
            at_solid.iter_mut().chain([&mut at_event]).for_each(|wait| wait.fields.push((key.clone(), value.clone())));
        }
    }

    let (ray_spot, ray) = ray.map_or((reading.spot(at), None), |(at, name)| (reading.spot(at), Some(name)));
    let mut beat = Beat {
        title: title.trim().to_owned(),
        title_spot: reading.spot(at + heading.len() - text.trim_start().len()),
        at: at_event,
        at_solid,
        ray,
        paragraphs: Vec::new(),
        ask: None,
        spot: reading.spot(at),
        ray_spot,
    };
    for block in below.split(|(_, line)| line.trim().is_empty()).filter(|block| !block.is_empty()) {
        read_block(block, &mut beat, reading);
    }
    Some(beat)
}

/// What a beat waits for on the solid stage: its text is about the same event.
fn wait_on_solid(text: &str, at: usize, flat: &Wait, reading: &mut Reading<'_>) -> Option<Wait> {
    let wait = wait::parse(text, at, reading)?;
    if wait.event != flat.event {
        let event = &flat.event;
        reading.problem(at, format!("`solid` waits for the same event, another time: `at={event} solid={event}#9`"));
        return None;
    }
    Some(wait)
}

/// A heading's condition is a field of the event it waits for; anything else is a misspelt attribute.
fn check_condition(at: &Wait, key: &str, key_at: usize, reading: &mut Reading<'_>) -> bool {
    let known = reading.plays.fields(&at.event);
    let good = known.contains(&key);
    if !good {
        let allowed: Vec<&str> = ["at", "solid", "ray"].into_iter().chain(known).collect();
        reading.problem(key_at, misspelt("attribute of a heading", key, &allowed));
    }
    good
}

/// A paragraph, a question or a paragraph with a condition.
fn read_block(block: &[Line<'_>], beat: &mut Beat, reading: &mut Reading<'_>) {
    let (at, first) = block[0];
    let quoted = first.strip_prefix('>').map(str::trim_start);
    match quoted {
        Some(text) if text.starts_with("ask") => {
            if beat.ask.is_some() {
                reading.problem(at, "a beat asks one question: give the second a heading of its own");
            }
            beat.ask = ask(&quote(block), &beat.at.event, reading);
        }
        Some(text) if depends(text) => beat.paragraphs.extend(dependent(&quote(block), &beat.at, reading)),
        Some(_) => reading.problem(
            at,
            "a line that begins with `>` asks (`> ask {field=near}: question`) or depends (`> if field=value: text`)",
        ),
        None => beat.paragraphs.push(paragraph(block, None, None, &beat.at.event, reading)),
    }
}

/// The lines of a block quote without their `>`.
fn quote<'a>(block: &[Line<'a>]) -> Vec<Line<'a>> {
    let bare = |&(at, line): &Line<'a>| {
        let text = line.strip_prefix('>').unwrap_or(line);
        let text = text.strip_prefix(' ').unwrap_or(text);
        (at + line.len() - text.len(), text)
    };
    block.iter().map(bare).collect()
}

/// Plain text.
fn paragraph(
    lines: &[Line<'_>],
    only_if: Option<Condition>,
    only_in: Option<Medium>,
    event: &str,
    reading: &mut Reading<'_>,
) -> Paragraph {
    let mut offers = Vec::new();
    let mut said = Vec::new();
    for &(at, line) in lines {
        template::check_said(line, at, event, reading);
        if only_in == Some(Medium::Window) {
            let (text, found) = offer::take(line, at, reading);
            said.extend(Some(text).filter(|text| !text.is_empty()));
            offers.extend(found);
            continue;
        }
        if offer::is_in(line) {
            reading.problem(at, "only the window can do that: write `> window: [words](set:key=value)`");
        }
        if reading.beside
            && only_in != Some(Medium::Paper)
            && template::named(line).any(|name| name.starts_with("beside."))
        {
            reading.problem(at, "what is played beside is told on paper: write `> paper: text`");
        }
        said.push(line.trim_end().to_owned());
    }
    let spot = reading.spot(lines.first().map_or(0, |(at, _)| *at));
    Paragraph { text: said.join("\n"), only_if, only_in, offers, spot, lines: spots(lines, reading) }
}

/// Where a paragraph may be said alone, as it is written.
const MEDIA: [(&str, Medium); 2] = [("window", Medium::Window), ("paper", Medium::Paper)];

/// Whether a block quote says when, or where, it is said.
fn depends(text: &str) -> bool {
    let medium = |(name, _): &(&str, Medium)| {
        text.strip_prefix(name).is_some_and(|rest| rest.starts_with(':') || rest.starts_with(" if "))
    };
    text.starts_with("if ") || MEDIA.iter().any(medium)
}

/// `if verdict=miss: text`, `window: text`, `paper if hit=yes: text`
fn dependent(lines: &[Line<'_>], at: &Wait, reading: &mut Reading<'_>) -> Option<Paragraph> {
    let (start, first) = lines[0];
    let Some((test, text)) = first.split_once(':') else {
        reading.problem(start, "write `> if field=value: text`, `> window: text` or `> paper: text`");
        return None;
    };
    let medium = MEDIA.iter().find(|(name, _)| test.starts_with(name));
    let condition = test.trim_start_matches(medium.map_or("", |(name, _)| name)).trim_start();
    let only_if = match condition.strip_prefix("if ") {
        Some(test) => {
            let test_at = start + (test.as_ptr() as usize - first.as_ptr() as usize);
            Some(Condition::read(test, &at.event, test_at, reading)?)
        }
        None => None,
    };
    let mut said = lines.to_vec();
    said[0] = (start + first.len() - text.trim_start().len(), text.trim_start());
    let event = only_if.as_ref().and_then(Condition::event).unwrap_or(&at.event).to_owned();
    Some(paragraph(&said, only_if, medium.map(|(_, medium)| *medium), &event, reading))
}

/// `ask {field=near}: question`, then `- answer: reason` lines.
fn ask(lines: &[Line<'_>], event: &str, reading: &mut Reading<'_>) -> Option<Ask> {
    let (start, first) = lines[0];
    let text = first.strip_prefix("ask").unwrap_or(first);
    let Some((braces, question)) = text.trim_start().strip_prefix('{').and_then(|text| text.split_once("}:")) else {
        reading.problem(start, "write `> ask {field=near}: question`");
        return None;
    };
    let question_at = start + first.len() - question.len();
    let (mut about, mut alike) = (None, None);
    let mut options = Vec::new();
    let before = reading.count();
    for Attribute { key, key_at, value, value_at } in
        attributes::read(braces, question_at - 2 - braces.len(), reading).unwrap_or_default()
    {
        match key.as_str() {
            "field" => {
                check_field(event, &value, value_at, reading);
                about = Some(About::Field(value));
            }
            "count" => {
                check_event(&value, value_at, reading);
                about = Some(About::Count { event: value, alike: None });
            }
            "alike" => {
                check_field(event, &value, value_at, reading);
                alike = Some(value);
            }
            "event" => {
                check_event(&value, value_at, reading);
                about = Some(About::Event(value.split('|').map(str::to_owned).collect()));
            }
            "least" => {
                check_event(&value, value_at, reading);
                if reading.abreast.is_empty() {
                    reading.problem(key_at, "only walks side by side can be compared: write `plays = \"walks\"`");
                }
                about = Some(About::Least(value));
            }
            "answer" if value.trim().is_empty() => reading.problem(value_at, "the answer is empty"),
            "answer" => about = Some(About::Said(value)),
            "options" => options = value.split_whitespace().map(str::to_owned).collect(),
            _ => reading.problem(
                key_at,
                misspelt(
                    "attribute of a question",
                    &key,
                    &["field", "count", "alike", "event", "options", "least", "answer"],
                ),
            ),
        }
    }
    if let Some(About::Count { alike: of, .. }) = &mut about {
        *of = alike;
    }
    if about.is_none() && reading.count() == before {
        reading.problem(start, "a question needs `field=` (of the coming event), `event=` (which comes), `count=` (how many the walk has) or `answer=` (what no event tells)");
    }

    // The question may run over several lines; each `-` begins an answer.
    let mut lines = lines.to_vec();
    lines[0] = (start + first.len() - question.trim_start().len(), question.trim_start());
    let dash = |line: &Line<'_>| line.1.trim_start().starts_with("- ");
    let first_answer = lines.iter().position(dash).unwrap_or(lines.len());
    let (question, answers) = lines.split_at(first_answer);
    if joined(question).trim().is_empty() {
        reading.problem(start, "the question is empty");
    }
    check_fields(question, event, reading);
    let reasons = answers.chunk_by(|_, next| !dash(next)).filter_map(|lines| reason(lines, event, reading)).collect();
    let (spot, lines) = (reading.spot(start), spots(question, reading));
    Some(Ask { question: joined(question), about: about?, options, reasons, spot, lines })
}

/// `- answer: reason` or `- answer (what the button says): reason`
fn reason(lines: &[Line<'_>], event: &str, reading: &mut Reading<'_>) -> Option<Reason> {
    let (start, first) = lines[0];
    let text = first.trim_start().trim_start_matches("- ");
    let Some((answer, why)) = text.split_once(':') else {
        reading.problem(start, "write `> - answer: why it is wrong`");
        return None;
    };
    let mut said = lines.to_vec();
    said[0] = (start + first.len() - why.trim_start().len(), why.trim_start());
    check_fields(&said, event, reading);
    let answer_at = start + first.len() - text.len();
    let letters = answer.trim().chars().count();
    if letters > limits::TITLE {
        reading
            .problem(answer_at, format!("the answer has {letters} letters: a button shows at most {}", limits::TITLE));
    }
    let (spot, lines) = (reading.spot(answer_at), spots(&said, reading));
    let (answer, label) = match answer.trim().strip_suffix(')').and_then(|answer| answer.split_once('(')) {
        Some((answer, label)) => (answer.trim().to_owned(), Some(label.trim().to_owned())),
        None => (answer.trim().to_owned(), None),
    };
    Some(Reason { answer, label, text: joined(&said), spot, lines })
}

/// Splits `Title {at=...}` into the title and what stands between the braces, if that can be read; `at` is its
/// first byte.
fn braces<'a>(text: &'a str, at: usize, reading: &mut Reading<'_>) -> (&'a str, Option<Vec<Attribute>>) {
    let Some((title, inside)) = text.split_once('{') else { return (text, Some(Vec::new())) };
    let inside_at = at + title.len() + 1;
    let Some(inside) = inside.trim_end().strip_suffix('}') else {
        reading.problem(inside_at - 1, "`{` is not closed by `}` at the end of the heading");
        return (title, None);
    };
    (title, attributes::read(inside, inside_at, reading))
}

/// Checks the `{{field}}`s of some lines.
fn check_fields(lines: &[Line<'_>], event: &str, reading: &mut Reading<'_>) {
    for (at, line) in lines {
        template::check(line, *at, event, reading);
    }
}

/// Lines as one text.
fn joined(lines: &[Line<'_>]) -> String {
    lines.iter().map(|(_, line)| line.trim_end()).collect::<Vec<_>>().join("\n")
}

/// Where each of some lines begins.
fn spots(lines: &[Line<'_>], reading: &Reading<'_>) -> Vec<Spot> {
    lines.iter().map(|(at, _)| reading.spot(*at)).collect()
}
