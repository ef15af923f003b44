//! What is given: a mesh and rays, and lessons.

use std::path::{Path, PathBuf};

use super::folder;

pub(crate) const SQUARE: &str = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n";
pub(crate) const RAYS: &str = "ox,oy,oz,dx,dy,dz\n1.5,0.5,5,0,0,-1\n0.5,1.5,5,0,0,-1\n9,9,5,0,0,-1\n";

/// A folder with a mesh and rays.
pub(crate) fn with_inputs(name: &str) -> PathBuf {
    let folder = folder(name);
    std::fs::write(folder.join("square.obj"), SQUARE).unwrap();
    std::fs::write(folder.join("rays.csv"), RAYS).unwrap();
    folder
}

pub(crate) fn trace(out: &str) -> [&str; 9] {
    ["trace", "--mesh", "square.obj", "--structure", "kd", "--rays", "rays.csv", "--out", out]
}

/// A folder of lessons with these slides, all of them like one that is shipped.
pub(crate) fn lessons(folder: &Path, slides: &[(&str, u32)], rays: [&str; 3]) -> PathBuf {
    let lessons = folder.join("lessons");
    std::fs::create_dir_all(lessons.join("listings")).unwrap();
    let listing = Path::new(env!("CARGO_MANIFEST_DIR")).join("../lessons/listings/kd-walk.txt");
    std::fs::copy(listing, lessons.join("listings/kd-walk.txt")).unwrap();
    for (path, number) in slides {
        let path = lessons.join(path);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        let [a, b, c] = rays;
        let text = format!(
            "+++\nformat = 1\nslide = [{number}]\ntitle = \"Same\"\nlisting = \"kd-walk\"\nscene = \"flat-twelve\"\n\
             structure = {{ kind = \"kd\" }}\nrays = [\n  \
             {{ name = \"{a}\", from = [0.1, 1.2], towards = [8, 4] }},\n  \
             {{ name = \"{b}\", from = [9.5, 3.2], direction = [-1, -0.2] }},\n  \
             {{ name = \"{c}\", from = [9.8, 0.8], towards = [6.4, 4] }},\n]\n+++\n\
             ## The end {{at=end}}\nSlide {number}.\n\n> ask {{field=hit}}: Is anything hit?\n> - yes: No.\n\
             > - no: Yes.\n\n## Again {{at=end ray=\"{b}\"}}\nSlide {number}.\n\n\
             ## And again {{at=end ray=\"{c}\"}}\nSlide {number}.\n"
        );
        std::fs::write(path, text).unwrap();
    }
    lessons
}

pub(crate) const TWINS: [(&str, u32); 3] = [("01-a/10-same.md", 10), ("02-b/10-same.md", 11), ("02-b/12-other.md", 12)];
