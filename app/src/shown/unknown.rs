//! What is asked for and is not there: a sentence that says what there is.

use raystep_lesson::{Library, Plays, Slide};

/// There is no such slide; those of its section are named, or where there is no such section, the sections' first and
/// last ones.
pub(crate) fn no_slide(library: &Library, id: &str) -> String {
    let ids: Vec<String> = library.slides.iter().map(Slide::id).collect();
    let sections: Vec<&[String]> = ids.chunk_by(|a, b| section(a) == section(b)).collect();
    let known = match sections.iter().find(|ids| section(&ids[0]) == section(id)) {
        Some(ids) => ids.join(", "),
        None => sections.iter().map(|ids| ends(ids)).collect::<Vec<_>>().join(", "),
    };
    format!("there is no slide \"{id}\"; there are {known}")
}

fn section(id: &str) -> &str {
    id.split('/').next().unwrap_or(id)
}

fn ends(ids: &[String]) -> String {
    match ids {
        [first, .., last] => format!("{first} to {last}"),
        ids => ids.join(", "),
    }
}

/// There is no such ray, but there are others; or none, and what is played instead.
pub(crate) fn no_ray(slide: &Slide, name: &str) -> String {
    let rays = slide.stages.iter().flat_map(|stage| &stage.rays);
    let mut known: Vec<&str> = rays.map(|ray| ray.name.as_str()).collect();
    known.dedup();
    let id = slide.id();
    let plays = match slide.plays {
        Plays::Walk | Plays::Walks | Plays::Packet => {
            return format!("slide {id} has no ray \"{name}\"; there are \"{}\"", known.join("\", \""));
        }
        Plays::Build => "plays how its structure is built",
        Plays::Board => "shows tables, charts or pictures",
        Plays::Pairs => "tests pairs of objects",
        Plays::Fit => "plays how a volume is fitted",
    };
    format!("slide {id} {plays}: it has no rays")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slide_without_rays_says_what_it_plays() {
        let library = Library::embedded();
        let check = |id: &str, says: &str| assert_eq!(no_ray(library.slide(id).unwrap(), "none"), says);
        check("1/1", "slide 1/1 shows tables, charts or pictures: it has no rays");
        check("5/30", "slide 5/30 plays how its structure is built: it has no rays");
        check("3/19", "slide 3/19 tests pairs of objects: it has no rays");
        assert!(no_ray(library.slide("5/33").unwrap(), "none").contains("there are \"both children, far hit\", \""));
    }

    #[test]
    fn slides_of_the_section_are_named_or_all_sections() {
        let check = |id: &str, begin: &str| {
            let said = no_slide(&Library::embedded(), id);
            assert!(said.starts_with(&format!("there is no slide \"{id}\"; there are {begin}")), "{said}");
            assert!(said.len() < 200, "{said}");
        };
        check("5/99", "5/28, 5/28b, ");
        check("10/1", "1/1 to 1/11b, 2/12 to ");
        check("", "1/1 to ");
    }
}
