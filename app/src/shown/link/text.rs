//! Links as text.

use std::fmt::{self, Write};
use std::str::FromStr;

use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, percent_decode_str, utf8_percent_encode};
use raystep_accel::{Grain, HandCut, Interval, Mistake, Ray, Rule, RuleError};
use raystep_fast::FastKind;
use raystep_figure::Depth;
use raystep_lesson::{Column, StageKind};

use super::{ASPECT, Link, camera, numbers};
use crate::shown::beside::{Pace, Rivals};
use crate::shown::command::QUARTERS;
use crate::shown::own::MOST as MOST_SHAPES;

/// What stands in a link as it is; everything else would end it, or mean something else in it.
const PLAIN: &AsciiSet = &NON_ALPHANUMERIC
    .remove(b'-')
    .remove(b'_')
    .remove(b'.')
    .remove(b',')
    .remove(b':')
    .remove(b'/')
    .remove(b'~')
    .remove(b'=');

/// Letters of a link, at most.
const LONGEST: usize = 1 << 16;
/// Letters of it that a sentence quotes.
const QUOTED: usize = 60;
/// No walk has more steps.
const MOST_STEPS: usize = 1 << 40;
/// Things that are set, at most.
const MOST_SET: usize = 256;
/// Numbers of a shape, at most.
const MOST_NUMBERS: usize = 2048;

const GRAINS: [Grain; 3] = [Grain::Arithmetic, Grain::Decision, Grain::Visit];
const KEYS: [&str; 24] = [
    "stage", "ray", "own", "step", "set", "shape", "try", "example", "camera", "aspect", "levels", "part", "beside",
    "mistake", "pace", "heat", "fast", "mesh", "grain", "speed", "present", "hand", "question", "answers",
];

impl fmt::Display for Link {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut parts: Vec<(&str, String)> = Vec::new();
        let mut add = |key: &'static str, value: Option<String>| parts.extend(value.map(|value| (key, value)));
        add("stage", self.stage.map(|stage| stage.name().to_owned()));
        add("ray", self.ray.clone());
        add("own", self.own.map(|ray| listed(&of_ray(&ray))));
        add("step", self.step.map(|step| step.to_string()));
        for (key, value) in &self.set {
            add("set", Some(format!("{key}:{value}")));
        }
        for (prim, numbers) in &self.shapes {
            add("shape", Some(format!("{prim}:{}", listed(numbers))));
        }
        add("try", self.tried.map(|cut| cut.to_string()));
        add("example", self.example.map(|mistake| mistake.name().to_owned()));
        add("camera", self.camera.map(|camera| listed(&numbers(&camera))));
        add("aspect", (self.aspect != ASPECT).then(|| self.aspect.to_string()));
        add(
            "levels",
            self.depth.map(|depth| match depth {
                Depth::Path => "path".to_owned(),
                Depth::Down(level) => level.to_string(),
            }),
        );
        add("part", self.part.map(|part| listed(&[part.near, part.far])));
        add("beside", self.beside.map(|rivals| rivals.kinds().collect::<Vec<_>>().join(",")));
        add("mistake", self.mistake.map(|mistake| mistake.name().to_owned()));
        add("pace", (self.pace == Pace::T).then(|| "t".to_owned()));
        add("heat", self.heat.map(|of| of.name().to_owned()));
        add("fast", self.fast.map(|kind| kind.name().to_owned()));
        add("mesh", self.mesh.clone());
        add("grain", (self.grain != Grain::Decision).then(|| self.grain.word().to_owned()));
        add("speed", (self.speed != QUARTERS).then(|| (f32::from(self.speed) / f32::from(QUARTERS)).to_string()));
        add("present", self.present.then(|| "yes".to_owned()));
        add("hand", self.by_hand.then(|| "yes".to_owned()));
        add("question", self.asked.open.then(|| "open".to_owned()));
        let answers = self.asked.answers.iter().filter_map(|answer| letter(*answer)).collect::<String>();
        add("answers", Some(answers).filter(|answers| !answers.is_empty()));
        write!(f, "{}", utf8_percent_encode(&self.slide, PLAIN))?;
        for (index, (key, value)) in parts.iter().enumerate() {
            f.write_char(if index == 0 { '?' } else { '&' })?;
            write!(f, "{key}={}", utf8_percent_encode(value, PLAIN))?;
        }
        Ok(())
    }
}

impl FromStr for Link {
    type Err = String;

    /// Reads a link in which all is right; else sentences say what is not.
    fn from_str(text: &str) -> Result<Link, String> {
        let (link, wrong) = Link::read(text);
        if wrong.is_empty() { Ok(link) } else { Err(wrong.join("; ")) }
    }
}

impl Link {
    /// What a link says, and a sentence for whatever of it makes no sense; that is left out. What stands before a `#` is
    /// the page's that it was copied from.
    pub fn read(text: &str) -> (Link, Vec<String>) {
        let (mut link, mut wrong) = (Link::default(), Vec::new());
        if text.len() > LONGEST {
            wrong.push(format!("a link has at most {LONGEST} letters; here are {}", text.len()));
            return (link, wrong);
        }
        let text = text.trim();
        let text = text.rsplit_once('#').map_or(text, |(_, text)| text);
        let (slide, parts) = text.split_once('?').unwrap_or((text, ""));
        match decoded(slide) {
            Ok(slide) if !slide.trim().is_empty() => link.slide = slide,
            Ok(_) => wrong.push("a link begins with a slide, as in 5/33?step=3".to_owned()),
            Err(why) => wrong.push(format!("{}: {why}", short(slide))),
        }
        for part in parts.split('&').filter(|part| !part.is_empty()) {
            let said = match part.split_once('=') {
                None => Err("a part of a link is written key=value".to_owned()),
                Some((key, value)) => decoded(value).and_then(|value| link.set_part(key, value)),
            };
            if let Err(why) = said {
                wrong.push(format!("{}: {why}", short(part)));
            }
        }
        (link, wrong)
    }

    /// Sets one part, or says what would be right.
    fn set_part(&mut self, key: &str, value: String) -> Result<(), String> {
        match key {
            "stage" => {
                let known = StageKind::ALL.into_iter().find(|kind| kind.name() == value);
                self.stage = Some(known.ok_or("there are flat and solid")?);
            }
            "ray" => self.ray = Some(value),
            "own" => self.own = Some(ray(&value)?),
            "step" => {
                let step = value.parse().ok().filter(|step| *step <= MOST_STEPS);
                self.step = Some(step.ok_or_else(|| format!("a whole number from 0 to {MOST_STEPS} is needed"))?);
            }
            "set" => {
                let (key, value) = value.split_once(':').ok_or("a parameter is written set=key:value")?;
                known(key, value)?;
                if self.set.len() == MOST_SET {
                    return Err(format!("at most {MOST_SET} parameters are set"));
                }
                self.set.push((key.to_owned(), value.to_owned()));
            }
            "shape" => {
                let (prim, numbers) = value.split_once(':').ok_or("a shape is written shape=number:x,y,…")?;
                let prim =
                    prim.trim().parse().map_err(|_| "the number of the shape stands first, as in 3:2.5,1,0.5")?;
                let numbers =
                    floats(numbers, MOST_NUMBERS).ok_or("a shape has finite numbers with commas between them")?;
                if self.shapes.iter().any(|(other, _)| *other == prim) {
                    return Err("this shape lies elsewhere already".to_owned());
                }
                if self.shapes.len() == MOST_SHAPES {
                    return Err(format!("at most {MOST_SHAPES} shapes are moved"));
                }
                self.shapes.push((prim, numbers));
            }
            "try" => {
                self.tried = Some(cut(&value).ok_or("a cut is written node:axis=place, as in 0:x=2.09")?);
            }
            "example" => self.example = Some(mistake(&value)?),
            "mistake" => self.mistake = Some(mistake(&value)?),
            "part" => {
                const NEEDED: &str = "two numbers are needed, the smaller t first";
                let ends = floats(&value, 2).filter(|ends| ends.len() == 2 && ends[0] < ends[1]).ok_or(NEEDED)?;
                self.part = Some(Interval::new(ends[0], ends[1]));
            }
            "pace" => {
                let paces = [("step", Pace::Event), ("t", Pace::T)];
                let known = paces.into_iter().find(|(name, _)| *name == value);
                self.pace = known.ok_or("there are step and t")?.1;
            }
            "heat" => {
                let known = Column::COUNTS.into_iter().find(|of| of.name() == value);
                self.heat =
                    Some(known.ok_or_else(|| format!("there are {}", Column::COUNTS.map(Column::name).join(", ")))?);
            }
            "fast" => {
                let names = FastKind::ALONE.map(FastKind::name);
                let known = FastKind::ALONE.into_iter().find(|kind| kind.name() == value);
                self.fast = Some(known.ok_or_else(|| format!("there are {}", names.join(", ")))?);
            }
            "camera" => {
                const NEEDED: &str = "three numbers are needed (the middle, and half the height) or ten (eye, target, \
                                      up, degrees), with which something is seen";
                self.camera = Some(floats(&value, 16).as_deref().and_then(camera).ok_or(NEEDED)?);
            }
            "aspect" => {
                let aspect = value.parse().ok().filter(|aspect| (0.01..=100.0).contains(aspect));
                self.aspect = aspect.ok_or("a number from 0.01 to 100 is needed")?;
            }
            "levels" => {
                let level = value.parse().ok().filter(|level| (1..=64).contains(level)).map(Depth::Down);
                let path = (value == "path").then_some(Depth::Path);
                self.depth = Some(path.or(level).ok_or("path, or a number from 1 to 64 is needed")?);
            }
            "beside" => {
                self.beside = Some(rivals(&value).ok_or_else(|| format!("there are {}", Rule::KINDS.join(", ")))?);
            }
            "mesh" => self.mesh = Some(value),
            "grain" => {
                let known = GRAINS.into_iter().find(|grain| grain.word() == value);
                self.grain = known.ok_or("there are arithmetic, decision and visit")?;
            }
            "speed" => {
                let quarters = value.parse::<f32>().ok().map(|times| times * f32::from(QUARTERS));
                let known = quarters.filter(|q| q.fract() == 0.0 && (1.0..=f32::from(9 * QUARTERS)).contains(q));
                self.speed = known.ok_or("a number of quarters from 0.25 to 9 is needed, as in 0.5")? as u8;
            }
            "present" => self.present = flag(&value)?,
            "hand" => self.by_hand = flag(&value)?,
            "question" if value == "open" => self.asked.open = true,
            "question" => return Err("a question is open, or nothing is said of it".to_owned()),
            "answers" => {
                const NEEDED: &str = "the letters of the last answers are needed, one or two, as in b or cb";
                let answers: Option<Vec<usize>> = value.chars().map(answer).collect();
                self.asked.answers = answers.filter(|answers| (1..=2).contains(&answers.len())).ok_or(NEEDED)?;
            }
            _ => return Err(format!("a link has no such part; there are {}", KEYS.join(", "))),
        }
        Ok(())
    }
}

/// Says what is wrong, unless some structure has such a parameter with such a value. What else there may be are numbers:
/// of a meter, of a pair's body.
fn known(key: &str, value: &str) -> Result<(), String> {
    let mut refused = None;
    for mut rule in Rule::KINDS.iter().filter_map(|kind| Rule::default_for(kind).ok()) {
        match rule.set(key, value) {
            Ok(()) => return Ok(()),
            // This structure has such a parameter, and says what it can be.
            Err(error @ RuleError::Value { .. }) => refused = refused.or(Some(error.to_string())),
            Err(_) => {}
        }
    }
    let is_number = |part: &str| part.parse::<f64>().is_ok_and(f64::is_finite);
    match refused {
        Some(refused) => Err(refused),
        None if value.split(' ').all(is_number) => Ok(()),
        None => {
            let (value, key) = (short(value), short(key));
            Err(format!("{value} is nothing that {key} can be: no structure has such a parameter, and it is no number"))
        }
    }
}

/// The letter of an answer, the first being a.
fn letter(answer: usize) -> Option<char> {
    u8::try_from(answer).ok().filter(|answer| *answer < 26).map(|answer| char::from(b'a' + answer))
}

/// The answer of a letter.
fn answer(letter: char) -> Option<usize> {
    letter.is_ascii_lowercase().then(|| letter as usize - 'a' as usize)
}

/// As forms write it: `+` is a blank, `%20` is one, too.
fn decoded(text: &str) -> Result<String, String> {
    let text = text.replace('+', " ");
    let decoded = percent_decode_str(&text).decode_utf8();
    let decoded = decoded.map_err(|_| "what stands behind % is no letter in UTF-8".to_owned())?;
    if decoded.chars().any(char::is_control) {
        return Err("a link has no control characters".to_owned());
    }
    Ok(decoded.into_owned())
}

fn short(text: &str) -> String {
    match text.char_indices().nth(QUOTED) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

fn flag(value: &str) -> Result<bool, String> {
    match value {
        "yes" => Ok(true),
        "no" => Ok(false),
        _ => Err("yes or no is needed".to_owned()),
    }
}

fn mistake(name: &str) -> Result<Mistake, String> {
    let known = || Mistake::ALL.map(Mistake::name).join(", ");
    let named = Mistake::ALL.into_iter().find(|mistake| mistake.name() == name);
    named.ok_or_else(|| format!("there are {}", known()))
}

/// A cut as a rule spells it.
fn cut(text: &str) -> Option<HandCut> {
    let mut rule = Rule::default_for("kd").ok()?;
    rule.set("cut", text).ok()?;
    let mut cuts = rule.by_hand()?.cuts().collect::<Vec<_>>().into_iter();
    cuts.next().filter(|_| cuts.next().is_none())
}

/// The kinds of structures beside: one, or several with commas between them.
fn rivals(text: &str) -> Option<Rivals> {
    let known = |word: &str| Rule::KINDS.into_iter().find(|kind| *kind == word.trim());
    let kinds: Option<Vec<&'static str>> = text.split(',').map(known).collect();
    kinds.filter(|kinds| kinds.len() <= Rivals::MOST).map(Rivals::of)
}

/// Numbers with commas between them, at most so many.
fn floats(text: &str, most: usize) -> Option<Vec<f32>> {
    let mut numbers = text.split(',').map(|number| number.trim().parse::<f32>().ok().filter(|number| !number.is_nan()));
    numbers.by_ref().take(most).collect::<Option<Vec<f32>>>().filter(|_| numbers.next().is_none())
}

fn listed(numbers: &[f32]) -> String {
    numbers.iter().map(ToString::to_string).collect::<Vec<_>>().join(",")
}

/// Where it starts, its direction, and the t that count unless all do.
fn of_ray(ray: &Ray) -> Vec<f32> {
    let mut numbers = [ray.o.to_array(), ray.d.to_array()].concat();
    if (ray.t_min, ray.t_max) != (0.0, f32::INFINITY) {
        numbers.extend([ray.t_min, ray.t_max]);
    }
    numbers
}

fn ray(text: &str) -> Result<Ray, String> {
    let (ray, range) = match floats(text, 16).as_deref() {
        Some(&[ox, oy, oz, dx, dy, dz, ref range @ ..]) => {
            (Ray::new([ox, oy, oz].into(), [dx, dy, dz].into()), range.to_vec())
        }
        _ => {
            return Err("a ray has six numbers with commas between them: where it starts, and its direction, as in \
                        0.1,1.2,0,1,0.5,0"
                .to_owned());
        }
    };
    let ray = match range[..] {
        [] => ray,
        [t_min, t_max] => ray.and_then(|ray| ray.within(t_min, t_max)),
        _ => return Err("behind the direction stand the smallest and the largest t, or nothing".to_owned()),
    };
    ray.map_err(|error| format!("the ray cannot be walked: {error}"))
}
