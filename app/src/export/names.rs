//! Names of files. A name that is written as a part of one loses letters; two that were different stay so.

use std::collections::HashSet;

use raystep_accel::{PrimId, Primitives, Ray};
use raystep_figure::Camera;
use raystep_lesson::{Library, Slide, Stage};
use raystep_scene::Scene;

/// The beginning of the names of a slide's files.
pub(super) fn of_slide(library: &Library, slide: &Slide) -> String {
    let plain = |slide: &Slide| format!("slide{}", tame(&slide.name));
    let is_alone = |name: &str| library.slides.iter().filter(|other| alike(&plain(other)) == alike(name)).count() < 2;
    // A name that only one section has needs no section.
    let name = |slide: &Slide| match plain(slide) {
        name if is_alone(&name) => name,
        _ => format!("slide{}-{}", tame(&slide.section), tame(&slide.name)),
    };
    let here = library.slides.iter().position(|other| std::ptr::eq(other, slide));
    let names = distinct(library.slides.iter().map(name));
    here.map_or_else(|| plain(slide), |here| names[here].clone())
}

/// What is put behind it for a ray of the stage; nothing for the stage's own.
pub(super) fn of_ray(stage: &Stage, name: &str) -> String {
    let rays = &stage.rays;
    let Some(here) = rays.iter().position(|ray| ray.name == name).filter(|here| *here > 0) else {
        return String::new();
    };
    let names = rays.iter().skip(1).map(|ray| format!("-{}", slug(&ray.name)));
    distinct(names).swap_remove(here - 1)
}

/// What is put behind it for a ray that was drawn: another one gets another name.
pub(super) fn of_own_ray(ray: &Ray) -> String {
    let numbers = ray.o.to_array().into_iter().chain(ray.d.to_array()).chain([ray.t_min, ray.t_max]);
    format!("-own-ray-{:08x}", mixed(numbers.flat_map(|number| number.to_bits().to_le_bytes())))
}

/// What is put behind it for a scene that was changed by hand: another one gets another name.
pub(super) fn of_own_scene(scene: &Scene) -> String {
    let shapes = (0..scene.prims.len() as u32).map(|prim| format!("{:?}", scene.prims.shape(PrimId(prim))));
    format!("-own-scene-{:08x}", mixed(shapes.flat_map(String::into_bytes)))
}

/// What the camera of a link is called: another one gets another name.
pub(crate) fn of_linked_camera(camera: &Camera) -> String {
    format!("linked-{:08x}", mixed(format!("{camera:?}").into_bytes().into_iter()))
}

/// One number of many, in which every bit counts (Fowler, Noll, Vo).
fn mixed(bytes: impl Iterator<Item = u8>) -> u32 {
    bytes.fold(0x811c_9dc5_u32, |mixed, byte| (mixed ^ u32::from(byte)).wrapping_mul(0x0100_0193))
}

/// A name as a part of a file's name: letters and digits, and signs in words.
pub(super) fn slug(name: &str) -> String {
    let mut spelt = String::new();
    let mut letters = name.chars().peekable();
    let mut before = ' ';
    while let Some(letter) = letters.next() {
        let digit = |letter: Option<&char>| letter.is_some_and(char::is_ascii_digit);
        match letter {
            '-' | '−' if !before.is_alphanumeric() && digit(letters.peek()) => spelt.push_str("-minus-"),
            '.' if before.is_ascii_digit() && digit(letters.peek()) => spelt.push('.'),
            _ if letter.is_alphanumeric() => spelt.push(letter.to_ascii_lowercase()),
            _ => match SIGNS.iter().find(|(sign, _)| *sign == letter) {
                Some((_, word)) => spelt.push_str(&format!("-{word}-")),
                None => spelt.push('-'),
            },
        }
        before = letter;
    }
    spelt.split('-').filter(|part| !part.is_empty()).collect::<Vec<_>>().join("-")
}

/// Signs that tell rays apart, as words.
const SIGNS: [(char, &str); 13] = [
    ('<', "lt"),
    ('>', "gt"),
    ('≤', "le"),
    ('≥', "ge"),
    ('=', "eq"),
    ('≠', "ne"),
    ('+', "plus"),
    ('→', "right"),
    ('←', "left"),
    ('↑', "up"),
    ('↓', "down"),
    ('*', "star"),
    ('\'', "prime"),
];

/// The name of a slide or a section without what some systems do not take in a file's name.
fn tame(name: &str) -> String {
    name.replace(|letter: char| letter.is_control() || "<>:\"/\\|?*".contains(letter), "-")
}

/// Some systems take names for the same that differ in small and capital letters only.
fn alike(name: &str) -> String {
    name.to_lowercase()
}

/// The same names, but where one comes again it gets a number that no other has.
fn distinct(names: impl Iterator<Item = String>) -> Vec<String> {
    let names: Vec<String> = names.collect();
    let mut taken: HashSet<String> = names.iter().map(|name| alike(name)).collect();
    let mut met = HashSet::new();
    let mut tell = |name: String| {
        // Without any letter it would say nothing.
        if met.insert(alike(&name)) && !name.ends_with('-') {
            return name;
        }
        let numbered = |n: usize| format!("{}-{n}", name.trim_end_matches('-'));
        let free = (2..).map(numbered).find(|name| taken.insert(alike(name)));
        free.unwrap_or(name)
    };
    names.into_iter().map(&mut tell).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_lose_letters_stay_apart() {
        let check = |names: &[&str], files: &[&str]| {
            let made = distinct(names.iter().map(|name| format!("-{}", slug(name))));
            assert_eq!(made, files, "{names:?}");
        };
        check(&["both children", "from the right"], &["-both-children", "-from-the-right"]);
        check(&["x > 0", "x < 0", "x = 0"], &["-x-gt-0", "-x-lt-0", "-x-eq-0"]);
        check(&["→", "←", "↗", "↘"], &["-right", "-left", "-2", "-3"]);
        check(&["-1", "1", "−1", "1.5", "15"], &["-minus-1", "-1", "-minus-1-2", "-1.5", "-15"]);
        check(&["A ray", "a ray", "a, ray", "a ray 2"], &["-a-ray", "-a-ray-3", "-a-ray-4", "-a-ray-2"]);
        check(&["ÄRA", "äRA"], &["-Ära", "-ära-2"]);
        check(&["", "?", "\u{200b}"], &["-2", "-3", "-4"]);
    }

    #[test]
    fn slides_of_one_name_are_told_apart_by_their_sections() {
        let head = |number: u32| format!("+++\nformat = 1\nslide = [{number}]\ntitle = \"T\"\n");
        let body = "listing = \"kd-walk\"\nscene = \"flat-twelve\"\nstructure = { kind = \"kd\" }\nrays = [\n  \
                    { name = \"a\", from = [0.1, 1.2], towards = [8, 4] },\n  \
                    { name = \"b\", from = [9.5, 3.2], direction = [-1, -0.2] },\n]\n+++\n## A {at=end}\nText.\n";
        let paths = ["01-a/10-same.md", "02-b/10-same.md", "02-b/11-other.md", "02-b/10-Same.md", "1/01-a-10-same.md"];
        let files = paths.iter().zip(1..).map(|(path, number)| ((*path).to_owned(), head(number) + body));
        let library = Library::from_files(files);
        assert_eq!(library.slides.len(), paths.len(), "{:?}", library.problems);
        let mut stems: Vec<String> = library.slides.iter().map(|slide| of_slide(&library, slide)).collect();
        assert!(stems.contains(&"slide11-other".to_owned()) && stems.contains(&"slide01-a-10-same".to_owned()));
        stems.sort_by_key(|stem| alike(stem));
        stems.dedup_by_key(|stem| alike(stem));
        assert_eq!(stems.len(), paths.len(), "{stems:?}");
    }
}
