//! Checks the lessons by playing them: every slide on each of its stages with each of its rays.

mod beats;

use std::collections::HashMap;
use std::sync::Arc;

use raystep_accel::Rule;
use raystep_scene::Scene;

use crate::problem::{listed, misspelt};
use crate::texts::Said;
use crate::{
    Act, Built, Library, Listing, Look, Plan, Plays, Problem, Script, Setter, Slide, Spot, Stage, StageKind, Term,
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

/// Everything that is wrong in lessons of somebody's own beside `lecture`, which is taken for right.
pub fn check_beside(lecture: &Library, own: &Library, setter: Setter<'_>) -> Vec<Problem> {
    let has = |library: &Library, slide: &Slide| library.slides.iter().any(|other| other.file == slide.file);
    check_those(&lecture.clone().and(own.clone()), setter, |slide| has(own, slide) && !has(lecture, slide))
}

/// What can be seen to be wrong in slides without building anything, by file and line: texts that cannot be shown, as
/// `setter` says, and structures that do not exist.
pub fn glance(library: &Library, setter: Setter<'_>) -> Vec<Problem> {
    let plans = |slide: &Slide| {
        let plans = slide.stages.iter().flat_map(|stage| [&stage.plan].into_iter().chain(&stage.beside));
        let wrong = plans.flat_map(Plan::wrong);
        wrong.map(|(spot, why)| Problem::new(&slide.file, spot, why)).collect::<Vec<_>>()
    };
    let mut problems: Vec<Problem> =
        library.slides.iter().flat_map(|slide| plans(slide).into_iter().chain(unset(slide, setter))).collect();
    problems.sort();
    // Both stages may have the same.
    problems.dedup();
    problems
}

/// What of a slide's texts cannot be shown as it is written.
fn unset(slide: &Slide, setter: Setter<'_>) -> Vec<Problem> {
    let of = |said: Said<'_>| {
        let wrong = setter(&said.filled(), said.script).into_iter();
        wrong.map(|(byte, why)| Problem::new(&slide.file, said.spot(byte), why)).collect::<Vec<_>>()
    };
    slide.texts().into_iter().flat_map(of).collect()
}

fn check_those(library: &Library, setter: Setter<'_>, wanted: impl Fn(&Slide) -> bool) -> Vec<Problem> {
    let mut checker =
        Checker { library, setter, problems: library.problems.clone(), built: HashMap::new(), told: HashMap::new() };
    checker.terms();
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

/// The kinds of structures that packets walk.
pub(crate) const PACKET_KINDS: [&str; 3] = ["kd", "bsp", "bvh"];

struct Checker<'a> {
    library: &'a Library,
    setter: Setter<'a>,
    problems: Vec<Problem>,
    /// What was built before: slides share scenes and structures.
    built: HashMap<String, Option<Built>>,
    /// Where the paragraphs of the slide begin that are asked for, and whether they can be said somewhere.
    told: HashMap<Spot, bool>,
}

impl Checker<'_> {
    fn say(&mut self, slide: &Slide, spot: Spot, message: impl Into<String>) {
        self.problems.push(Problem::new(&slide.file, spot, message));
    }

    /// Every word that is explained stands in bold on the slide that teaches it.
    fn terms(&mut self) {
        let library = self.library;
        let says = |slide: &Slide, term: &Term| {
            slide.beats.iter().flat_map(|beat| &beat.paragraphs).any(|paragraph| term.is_bold_in(&paragraph.text))
        };
        for term in &library.terms {
            let name = &term.names[0];
            let mut wrong: Vec<(Spot, String)> = Vec::new();
            if !library.slides.iter().any(|slide| says(slide, term)) {
                wrong.push((term.spot, format!("no slide has `{name}` in bold: nobody can ask what it means")));
            } else {
                match library.slide(&term.slide) {
                    None => {
                        let known: Vec<String> = library.slides.iter().map(Slide::id).collect();
                        let known: Vec<&str> = known.iter().map(String::as_str).collect();
                        wrong.push((term.slide_spot, misspelt("slide", &term.slide, &known)));
                    }
                    Some(slide) if !says(slide, term) => {
                        let why =
                            format!("slide {} does not have `{name}` in bold: it is taught on another", term.slide);
                        wrong.push((term.slide_spot, why));
                    }
                    Some(_) => {}
                }
            }
            wrong.extend((self.setter)(&term.means, Script::Plain).into_iter().map(|(_, why)| (term.spot, why)));
            let problems = wrong.into_iter().map(|(spot, message)| Problem::new(crate::term::FILE, spot, message));
            self.problems.extend(problems);
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

    fn slide(&mut self, slide: &Slide) {
        let library = self.library;
        self.problems.extend(unset(slide, self.setter));
        let listing = library.listing(&slide.listing);
        if listing.is_none() && !slide.listing.is_empty() {
            let known: Vec<&str> = library.listings.iter().map(|listing| listing.name.as_str()).collect();
            self.say(slide, slide.listing_spot, misspelt("listing", &slide.listing, &known));
        }
        self.told.clear();
        let mut played = true;
        for stage in &slide.stages {
            self.beat_rays(slide, stage);
            self.offers(slide, stage);
            match self.build(slide, stage) {
                Some(built) => self.stage(slide, stage, listing, &built),
                None => played = false,
            }
        }
        if played && self.readable(slide) {
            self.silence(slide);
        }
    }

    /// Whether the file could be read in full: else beats that are left may miss those before them.
    fn readable(&self, slide: &Slide) -> bool {
        self.library.problems.iter().all(|problem| problem.file != slide.file)
    }

    /// Of every paragraph that is asked for, all that it names happens somewhere.
    fn silence(&mut self, slide: &Slide) {
        for (spot, _) in std::mem::take(&mut self.told).into_iter().filter(|(_, said)| !said) {
            let what = if slide.plays.has_rays() { "ray" } else { slide.plays.name() };
            self.say(
                slide,
                spot,
                format!("this is never said: on no {what} of the slide has all happened that it names"),
            );
        }
    }

    /// What a beat offers can be done on the stage.
    fn offers(&mut self, slide: &Slide, stage: &Stage) {
        let paragraphs = slide.beats.iter().flat_map(|beat| &beat.paragraphs);
        let offers = paragraphs.flat_map(|paragraph| paragraph.offers.iter().map(|offer| (offer, paragraph.spot)));
        for (offer, spot) in offers.collect::<Vec<_>>() {
            match &offer.act {
                Act::Set(settings) => {
                    let Ok(mut rule) = Rule::default_for(&stage.plan.kind) else { continue };
                    for (key, value) in settings {
                        let wrong = match stage.own_setting(key, value) {
                            Some(own) => own.err(),
                            None => rule.set(key, value).err().map(|error| error.to_string()),
                        };
                        if let Some(wrong) = wrong {
                            self.say(slide, spot, wrong);
                        }
                    }
                }
                Act::Compare(kind) if slide.plays != Plays::Walk || *kind == stage.plan.kind => {
                    self.say(slide, spot, format!("there is nothing to compare with `{kind}` here"));
                }
                Act::Compare(_) => {}
                Act::Slide(id) if self.library.slide(id).is_none() => {
                    let known: Vec<String> = self.library.slides.iter().map(Slide::id).collect();
                    let known: Vec<&str> = known.iter().map(String::as_str).collect();
                    self.say(slide, spot, misspelt("slide", id, &known));
                }
                Act::Slide(_) | Act::Best => {}
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
        let scene = match stage.scenes.named(&stage.scene) {
            Ok(scene) => scene,
            Err(error) => {
                // What is wrong in its own file is said there.
                let own = |problem: &Problem| {
                    let name = problem.file.strip_prefix("scenes/").and_then(|name| name.rsplit_once('.'));
                    name.is_some_and(|(name, _)| name == stage.scene)
                };
                if !self.library.problems.iter().any(own) {
                    self.say(slide, stage.scene_spot, error.to_string());
                }
                return None;
            }
        };
        if scene.flat != (stage.kind == StageKind::Flat) {
            let is = if scene.flat { "flat" } else { "solid" };
            let message = format!("the scene `{}` is {is}, the stage is not: write a table [{is}] for it", stage.scene);
            self.say(slide, stage.scene_spot, message);
            return None;
        }
        self.camera(slide, stage, &scene);
        let wrong = stage.wrong_changes(&scene);
        for (spot, message) in &wrong {
            self.say(slide, *spot, message.clone());
        }
        if !wrong.is_empty() {
            return None;
        }
        for (spot, name) in stage.board.iter().flat_map(|board| board.scenes()) {
            if let Err(error) = stage.scenes.knows(name) {
                self.say(slide, spot, error.to_string());
            }
        }
        // Every wrong parameter, not only the first.
        let mut good = true;
        let measured: Vec<Plan> = stage.board.iter().flat_map(|board| board.plans_at_ends()).collect();
        for plan in std::iter::once(&stage.plan).chain(&stage.beside).chain(&stage.abreast).chain(&measured) {
            for (spot, why) in plan.wrong() {
                self.say(slide, spot, why);
                good = false;
            }
        }
        if slide.plays == Plays::Packet && good && !PACKET_KINDS.contains(&stage.plan.kind.as_str()) {
            let message = format!("packets do not walk a structure of the kind `{}`: ", stage.plan.kind);
            self.say(slide, stage.plan.spot, message + &format!("they walk {}", listed(&PACKET_KINDS)));
            good = false;
        }
        if !good {
            return None;
        }
        let own = || stage.draft(slide.plays).ok();
        self.built.entry(key(slide, stage, &stage.plan)).or_insert_with(own).clone()
    }

    /// The structure beside, if the stage has one.
    fn build_beside(&mut self, slide: &Slide, stage: &Stage, built: &Built) -> Option<Built> {
        let scene: &Arc<Scene> = &built.scene;
        let beside = || stage.build_beside(scene, slide.plays).ok().flatten();
        self.built.entry(key(slide, stage, stage.beside.as_ref()?)).or_insert_with(beside).clone()
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
        let nearest = middle.clamp(bounds.min, bounds.max);
        let apart = (middle - nearest).length();
        if !(least..=most).contains(&seen) {
            let message = format!("{what} is {seen}: of this scene something can be seen from {least} to {most}");
            self.say(slide, stage.camera_spot, message);
        } else if apart > seen * 4.0 || !look.shows(&bounds) {
            let message = format!("the camera looks {apart} units beside the scene: nothing of it would be seen");
            self.say(slide, stage.camera_spot, message);
        }
    }

    /// Plays every ray of a stage, or its build.
    fn stage(&mut self, slide: &Slide, stage: &Stage, listing: Option<&Listing>, built: &Built) {
        let readable = self.readable(slide);
        let beside = self.build_beside(slide, stage, built);
        if !slide.plays.has_rays() {
            let Some(play) = built.play_with(beside.as_ref(), None, &slide.beats) else { return };
            self.hear(slide, &play);
            let what = format!("in the {} of the {} stage", slide.plays.name(), stage.kind.name());
            for (index, beat) in slide.beats.iter().enumerate() {
                self.values(slide, beat, &play);
                if readable {
                    self.beat(slide, &what, beat, play.beats[index], &play, listing);
                }
            }
        }
        for ray in &stage.rays {
            let Some(play) = built.play_with(beside.as_ref(), Some(ray.ray), &slide.beats) else { continue };
            self.hear(slide, &play);
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
}

/// What is built, in words: slides share it.
fn key(slide: &Slide, stage: &Stage, plan: &Plan) -> String {
    let settings: Vec<_> = plan.settings.iter().map(|setting| (&setting.key, &setting.value)).collect();
    // A board measures what its own slide asks for, walks have structures of their own, and changes are a stage's, as
    // pairs and packets are.
    let own = [stage.board.is_some(), !stage.abreast.is_empty(), !stage.pairs.is_empty(), !stage.changes.is_empty()];
    let own =
        if own.contains(&true) || matches!(slide.plays, Plays::Packet | Plays::Fit) { slide.file.as_str() } else { "" };
    format!("{} {own} {} {} {settings:?}", slide.plays.name(), stage.scene, plan.kind)
}
