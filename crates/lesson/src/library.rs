//! All slides and listings.

use include_dir::{Dir, include_dir};

use crate::{Listing, Problem, Slide};

/// The lessons as they were when the program was built.
static LESSONS: Dir<'static> = include_dir!("$CARGO_MANIFEST_DIR/../../lessons");

/// The lessons, sorted as they are taught.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Library {
    /// The slides that could be read, in order.
    pub slides: Vec<Slide>,
    /// The listings.
    pub listings: Vec<Listing>,
    /// What could not be read.
    pub problems: Vec<Problem>,
}

impl Library {
    /// The lessons in the program itself.
    pub fn embedded() -> Library {
        let mut files = Vec::new();
        collect(&LESSONS, &mut files);
        Library::from_files(files)
    }

    /// The lessons in these files: paths from the folder of lessons on, and texts.
    pub fn from_files(files: impl IntoIterator<Item = (String, String)>) -> Library {
        let mut files: Vec<(String, String)> = files.into_iter().collect();
        files.sort();
        let mut library = Library::default();
        for (path, text) in &files {
            library.add(path, text);
        }
        for (path, text) in &files {
            if path == "sections.txt" {
                library.name_sections(text);
            }
        }
        library
    }

    /// The lessons in a folder.
    ///
    /// # Errors
    /// When the folder or a file in it cannot be read.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn from_dir(folder: &std::path::Path) -> std::io::Result<Library> {
        let mut files = Vec::new();
        let mut folders = vec![folder.to_path_buf()];
        while let Some(next) = folders.pop() {
            for entry in std::fs::read_dir(next)? {
                let path = entry?.path();
                if path.is_dir() {
                    folders.push(path);
                } else if wanted(&path) {
                    let name = path.strip_prefix(folder).unwrap_or(&path).to_string_lossy().replace('\\', "/");
                    files.push((name, std::fs::read_to_string(&path)?));
                }
            }
        }
        Ok(Library::from_files(files))
    }

    /// Adds what one file holds: `section/slide.md` or `listings/name.txt`.
    fn add(&mut self, path: &str, text: &str) {
        let (folder, file) = path.rsplit_once('/').unwrap_or(("", path));
        let problems = if let Some(name) = file.strip_suffix(".txt").filter(|_| folder == "listings") {
            let (listing, problems) = Listing::read(name, path, text);
            self.listings.push(listing);
            problems
        } else if let Some(name) = file.strip_suffix(".md").filter(|_| !folder.is_empty()) {
            let (slide, problems) = Slide::read(folder, name, path, text);
            self.slides.extend(slide);
            problems
        } else {
            Vec::new()
        };
        self.problems.extend(problems);
    }

    /// Names the sections by lines of `folder : title`.
    fn name_sections(&mut self, text: &str) {
        for (folder, title) in text.lines().filter_map(|line| line.split_once(" : ")) {
            for slide in self.slides.iter_mut().filter(|slide| slide.section == folder.trim()) {
                title.trim().clone_into(&mut slide.section_title);
            }
        }
    }

    /// The listing of that name.
    pub fn listing(&self, name: &str) -> Option<&Listing> {
        self.listings.iter().find(|listing| listing.name == name)
    }

    /// The slide called `"5/33"`, `"05-kd-tree/33-which-child-first"` or `"33-which-child-first"`.
    pub fn slide(&self, id: &str) -> Option<&Slide> {
        self.slides.iter().find(|slide| {
            slide.id() == id || slide.name == id || id.split_once('/') == Some((&slide.section, &slide.name))
        })
    }
}

/// Whether a file of the lessons' folder may be a slide or a listing.
fn wanted(path: &std::path::Path) -> bool {
    path.extension().is_some_and(|ending| ending == "md" || ending == "txt")
}

/// The texts in a folder of the program.
fn collect(folder: &Dir<'static>, files: &mut Vec<(String, String)>) {
    for file in folder.files().filter(|file| wanted(file.path())) {
        if let Some(text) = file.contents_utf8() {
            files.push((file.path().to_string_lossy().replace('\\', "/"), text.to_owned()));
        }
    }
    folder.dirs().for_each(|folder| collect(folder, files));
}
