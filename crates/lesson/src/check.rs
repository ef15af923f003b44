//! Checks the lessons by playing them: every slide on each of its stages with each of its rays.

use std::collections::HashMap;

use raystep_accel::{Event, Value};
use raystep_scene::Scene;

use crate::problem::{listed, misspelt};
use crate::{
    About, Ask, Beat, Built, Library, Listing, Look, Play, Plays, Problem, Script, Setter, Slide, Spot, Stage,
    StageKind, names,
};

/// Everything that is wrong in the lessons, by file and line; nothing if all is well. `setter` says what in
/// their texts cannot be shown.
pub fn check(library: &Library, setter: Setter<'_>) -> Vec<Problem> {
    check_those(library, setter, |_| true)
}

/// Everything that is wrong in one file of the lessons.
pub fn check_file(library: &Library, file: &str, setter: Setter<'_>) -> Vec<Problem> {
    let mut problems = check_those(library, setter, |slide| slide.file == file);
    problems.retain(|problem| problem.file == file);
    problems
}

fn check_those(library: &Library, setter: Setter<'_>, wanted: impl Fn(&Slide) -> bool) -> Vec<Problem> {
    let mut checker = Checker { library, setter, problems: library.problems.clone(), built: HashMap::new() };
    checker.numbers();
    for listing in &library.listings {
        checker.listing(listing);
    }
    for slide in library.slides.iter().filter(|slide| wanted(slide)) {
        checker.slide(slide);
    }
    checker.problems.sort();
    checker.problems.dedup();
    checker.problems
}

struct Checker<'a> {
    library: &'a Library,
    setter: Setter<'a>,
    problems: Vec<Problem>,
    /// What was built before: slides share scenes and structures.
    built: HashMap<String, Option<Built>>,
}

impl Checker<'_> {
    fn say(&mut self, slide: &Slide, spot: Spot, message: impl Into<String>) {
        self.problems.push(Problem::new(&slide.file, spot, message));
    }

    /// No two slides are called the same.
    fn numbers(&mut self) {
        let mut first: HashMap<String, &Slide> = HashMap::new();
        let library = self.library;
        for slide in library.slides.iter().filter(|slide| !slide.numbers.is_empty()) {
            if let Some(other) = first.get(&slide.id()) {
                let message = format!("slide {} is {} already: another number is needed", slide.id(), other.file);
                self.say(slide, slide.numbers_spot, message);
            } else {
                first.insert(slide.id(), slide);
            }
        }
    }

    /// Every line of a listing can be shown.
    fn listing(&mut self, listing: &Listing) {
        for (number, line) in (1..).zip(&listing.lines) {
            for (byte, message) in (self.setter)(&line.text, Script::Code) {
                let letters = line.text.get(..byte).unwrap_or_default().chars().count();
                let spot = Spot { line: number, column: (1 + 2 * line.indent + letters) as u32 };
                self.problems.push(Problem::new(&listing.file, spot, message));
            }
        }
    }

    /// Every text can be shown as it is written.
    fn texts(&mut self, slide: &Slide) {
        for said in slide.texts() {
            for (byte, message) in (self.setter)(&said.filled(), said.script) {
                self.say(slide, said.spot(byte), message);
            }
        }
    }

    fn slide(&mut self, slide: &Slide) {
        let library = self.library;
        self.texts(slide);
        let listing = library.listing(&slide.listing);
        if listing.is_none() && !slide.listing.is_empty() {
            let known: Vec<&str> = library.listings.iter().map(|listing| listing.name.as_str()).collect();
            self.say(slide, slide.listing_spot, misspelt("listing", &slide.listing, &known));
        }
        for stage in &slide.stages {
            self.beat_rays(slide, stage);
            if let Some(built) = self.build(slide, stage) {
                self.stage(slide, stage, listing, &built);
            }
        }
    }

    /// Every ray that a beat names is a ray of the stage.
    fn beat_rays(&mut self, slide: &Slide, stage: &Stage) {
        let known: Vec<&str> = stage.rays.iter().map(|ray| ray.name.as_str()).collect();
        for beat in &slide.beats {
            if let Some(name) = beat.ray.as_deref().filter(|name| !known.is_empty() && !known.contains(name)) {
                let what = format!("ray of the {} stage", stage.kind.name());
                self.say(slide, beat.ray_spot, misspelt(&what, name, &known));
            }
        }
    }

    /// Builds a stage, or says why that cannot be done.
    fn build(&mut self, slide: &Slide, stage: &Stage) -> Option<Built> {
        let scene = match Scene::named(&stage.scene) {
            Ok(scene) => scene,
            Err(error) => {
                self.say(slide, stage.scene_spot, error.to_string());
                return None;
            }
        };
        if scene.flat != (stage.kind == StageKind::Flat) {
            let is = if scene.flat { "flat" } else { "solid" };
            self.say(slide, stage.scene_spot, format!("the scene `{}` is {is}, the stage is not", stage.scene));
            return None;
        }
        self.camera(slide, stage, &scene);
        // Every wrong parameter, not only the first.
        let mut good = true;
        match raystep_accel::Rule::default_for(&stage.plan.kind) {
            Ok(mut rule) => {
                for setting in &stage.plan.settings {
                    if let Err(error) = rule.set(&setting.key, &setting.value) {
                        self.say(slide, setting.spot, error.to_string());
                        good = false;
                    }
                }
            }
            Err(error) => {
                self.say(slide, stage.plan.spot, error.to_string());
                good = false;
            }
        }
        if !good {
            return None;
        }
        let key = format!(
            "{} {} {} {:?}",
            slide.plays.name(),
            stage.scene,
            stage.plan.kind,
            stage.plan.settings.iter().map(|s| (&s.key, &s.value)).collect::<Vec<_>>()
        );
        self.built.entry(key).or_insert_with(|| stage.build(slide.plays).ok()).clone()
    }

    /// From the stage's camera something of its scene is to be seen, neither dust nor one spot of it.
    fn camera(&mut self, slide: &Slide, stage: &Stage, scene: &Scene) {
        let Some(look) = stage.camera else { return };
        let bounds = scene.bounds();
        let size = bounds.extent().max_element();
        // How large what is looked at may be, and how far the middle of the picture lies from the scene.
        let (what, seen, middle) = match look {
            Look::Flat { center, half_height } => ("`half_height`", half_height, center.extend(0.0)),
            Look::Solid { eye, target, .. } => ("the way from `eye` to `target`", (target - eye).length(), target),
        };
        let [least, most] = [size / 1000.0, size * 100.0];
        let apart = (middle - middle.clamp(bounds.min, bounds.max)).length();
        if !(least..=most).contains(&seen) {
            let message = format!("{what} is {seen}: of this scene something can be seen from {least} to {most}");
            self.say(slide, stage.camera_spot, message);
        } else if apart > seen * 4.0 {
            self.say(slide, stage.camera_spot, format!("the camera looks {apart} units beside the scene"));
        }
    }

    /// Plays every ray of a stage, or its build.
    fn stage(&mut self, slide: &Slide, stage: &Stage, listing: Option<&Listing>, built: &Built) {
        // Of a file that could not be read in full, the beats that are left may miss those before them.
        let readable = self.library.problems.iter().all(|problem| problem.file != slide.file);
        if slide.plays == Plays::Build {
            let Some(play) = built.play(None, &slide.beats) else { return };
            let what = format!("in the build of the {} stage", stage.kind.name());
            for (index, beat) in slide.beats.iter().enumerate() {
                self.values(slide, beat, &play);
                if readable {
                    self.beat(slide, &what, beat, play.beats[index], &play, listing);
                }
            }
        }
        for ray in &stage.rays {
            let Some(play) = built.play(Some(ray.ray), &slide.beats) else { continue };
            for promise in &ray.promises {
                if promise.step(&play.tape, 0, play.scene.flat).is_none() {
                    self.say(
                        slide,
                        ray.spot,
                        format!("the ray `{}` promises `{promise}`, but that never happens on it", ray.name),
                    );
                }
            }
            let what = format!("on the ray `{}` of the {} stage", ray.name, stage.kind.name());
            for (index, beat) in slide.beats.iter().enumerate() {
                self.values(slide, beat, &play);
                if readable && slide.ray_of(stage, index).is_some_and(|own| own.name == ray.name) {
                    self.beat(slide, &what, beat, play.beats[index], &play, listing);
                }
            }
        }
    }

    /// A beat where it belongs, `what`: it happens, its listing shows it, and there is something to ask.
    fn beat(
        &mut self,
        slide: &Slide,
        what: &str,
        beat: &Beat,
        step: Option<usize>,
        play: &Play,
        listing: Option<&Listing>,
    ) {
        let Some((step, event)) = step.and_then(|step| Some((step, play.event(step)?))) else {
            let seen = play.tape.events().filter(|event| beat.at.matches(event)).count();
            let message = format!(
                "`{}` never happens {what} after the beat before it{}",
                beat.at,
                if seen > 0 { format!(" (in the whole {}: {seen})", slide.plays.name()) } else { String::new() },
            );
            self.say(slide, beat.spot, message);
            return;
        };
        if let Some(listing) = listing.filter(|listing| listing.line_of(event.name()).is_none()) {
            self.say(slide, beat.spot, format!("the listing `{}` has no line for `{}`", listing.name, event.name()));
        }
        if let Some(ask) = &beat.ask {
            let choices = ask.choices(play, step);
            if choices.len() < 2 || !choices.iter().any(|choice| choice.right) {
                self.say(slide, ask.spot, format!("there is nothing to choose between {what}"));
            }
            self.reasons(slide, ask, play, &event);
        }
    }

    /// Every reason is for an answer that can be given.
    fn reasons(&mut self, slide: &Slide, ask: &Ask, play: &Play, event: &Event) {
        let Some(right) = ask.right(play, event) else { return };
        for reason in ask.reasons.iter().filter(|reason| reason.answer != "else") {
            let answer = reason.answer.as_str();
            let mut allowed = spellings(&right);
            if let About::Event(events) = &ask.about {
                allowed.extend(events.iter().map(String::as_str));
            }
            let alike = |field: &&&str| {
                event.field(field).is_some_and(|value| std::mem::discriminant(&value) == std::mem::discriminant(&right))
            };
            match right {
                Value::Number(_) if crate::choices::is_cut(ask, event) => allowed.extend(crate::choices::CUTS),
                Value::Place(_) | Value::Number(_) => allowed.extend(event.fields().iter().filter(alike)),
                Value::Count(_) if answer.parse::<u32>().is_ok() => continue,
                Value::Count(_) => {
                    allowed.push("all");
                    allowed.extend(event.fields().iter().filter(alike));
                    allowed.extend(slide.plays.events());
                }
                _ => {}
            }
            if !allowed.contains(&answer) {
                self.say(slide, reason.spot, misspelt("answer to this question", answer, &allowed));
            }
        }
        if let Value::Word(_, words @ [_, ..]) = right {
            for option in ask.options.iter().filter(|option| !words.contains(&option.as_str())) {
                self.say(slide, ask.spot, misspelt("answer to this question", option, words));
            }
        }
    }

    /// Conditions compare fields with values that they can have.
    fn values(&mut self, slide: &Slide, beat: &Beat, play: &Play) {
        let conditions = beat.at.fields.iter().map(|condition| (condition, beat.spot));
        let paragraphs = beat.paragraphs.iter().filter_map(|p| Some((p.only_if.as_ref()?, *p.lines.first()?)));
        let Some(event) = play.tape.events().find(|event| names(&beat.at.event, event.name())) else { return };
        for ((field, text), spot) in conditions.chain(paragraphs).collect::<Vec<_>>() {
            let Some(value) = event.field(field) else { continue };
            let allowed = spellings(&value);
            if !allowed.is_empty() && !allowed.contains(&text.as_str()) {
                let message = format!("`{field}` is never `{text}`: it can be {}", listed(&allowed));
                self.say(slide, spot, message);
            }
        }
    }
}

/// How a field's values are spelt, where there are but a few.
fn spellings(value: &Value) -> Vec<&'static str> {
    match value {
        Value::Flag(_) => vec!["yes", "no"],
        Value::Axis(_) => vec!["x", "y", "z"],
        Value::Word(_, words) => words.to_vec(),
        _ => Vec::new(),
    }
}
