//! What the window remembers from one time to the next: sizes of panes, theme, zoom. Written whole or not at all, and
//! read field by field: one that makes no sense is left out, and the others stay.

use std::path::{Path, PathBuf};

use raystep_figure::Theme;
use serde::Serialize;
use toml::{Table, Value};

use super::desktop;
use crate::shown::pictures::Pane;
use crate::{fields, files, folders};

/// What is remembered.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Remembered {
    /// The name of the study's theme.
    pub theme: String,
    /// The name of the theme for a class.
    pub presenting: String,
    /// The factor of the whole window.
    pub zoom: f32,
    /// Whether questions are asked.
    pub predict: bool,
    /// Whether pictures move between steps, once somebody has said so; else the desktop says it.
    pub motion: Option<bool>,
    /// The width of the lesson, once it was dragged.
    pub lesson: Option<f32>,
    /// The width of the column at the right.
    pub walk: Option<f32>,
    /// The heights of the panes, once they were dragged.
    pub heights: Heights,
    /// The chosen tab.
    #[serde(skip)]
    pub(crate) tab: Pane,
    /// What made no sense, a sentence each.
    #[serde(skip)]
    pub(crate) wrong: Vec<String>,
    /// Whether the desktop wants motion. Nobody has asked it: then there is none.
    #[serde(skip)]
    desktop: bool,
    #[serde(skip)]
    file: Option<PathBuf>,
    /// What the file says, in other words: it is not written again before something else is to be said.
    #[serde(skip)]
    written: Table,
}

/// The heights of the panes that were dragged, in points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Heights {
    /// Of the work done.
    pub work: Option<f32>,
    /// Of the stack.
    pub stack: Option<f32>,
    /// Of the tree or the cell table.
    pub tree: Option<f32>,
    /// Of the t ruler.
    pub ruler: Option<f32>,
    /// Of a node's bytes, where they stand in the ruler's place.
    pub bytes: Option<f32>,
    /// Of what changed.
    pub changed: Option<f32>,
    /// Of what stands behind tabs.
    pub tabs: Option<f32>,
}

impl Default for Remembered {
    fn default() -> Remembered {
        Remembered {
            theme: "light".to_owned(),
            presenting: "projector".to_owned(),
            zoom: 1.0,
            predict: true,
            motion: None,
            lesson: None,
            walk: None,
            heights: Heights::default(),
            tab: Pane::Changed,
            wrong: Vec::new(),
            desktop: false,
            file: None,
            written: Table::new(),
        }
    }
}

impl Remembered {
    /// What the user's own file says, as far as it can be read.
    pub fn of_user() -> Remembered {
        let file = folders::settings().map(|folder| folder.join("window.toml"));
        let read = file.map_or_else(Remembered::default, |file| Remembered::of_file(&file));
        read.wrong.iter().for_each(|sentence| files::say(sentence));
        Remembered { desktop: desktop::wants_motion(), ..read }
    }

    fn of_file(file: &Path) -> Remembered {
        let mut read = match std::fs::read(file) {
            Ok(bytes) => Remembered::read(&String::from_utf8_lossy(&bytes)),
            Err(_) => Remembered::default(),
        };
        for sentence in &mut read.wrong {
            *sentence = format!("{}:{sentence}", file.display());
        }
        Remembered { file: Some(file.to_path_buf()), written: read.said(), ..read }
    }

    /// What a text says, as far as it makes sense.
    pub fn read(text: &str) -> Remembered {
        let mut read = Remembered::default();
        let wrong = fields::read(text, |key, spelt| read.set(key, spelt));
        Remembered { wrong, ..read }
    }

    /// Whether pictures move between steps.
    pub(crate) fn moves(&self) -> bool {
        self.motion.unwrap_or(self.desktop)
    }

    /// Remembers this zoom, whether questions are asked, and whether pictures move.
    pub(crate) fn keep(&mut self, zoom: f32, predict: bool, motion: bool) {
        (self.zoom, self.predict) = (zoom, predict);
        if motion != self.moves() {
            self.motion = Some(motion);
        }
        self.write();
    }

    /// Sets one field as it is spelt, or says what would be right.
    fn set(&mut self, key: &str, spelt: &str) -> Result<(), String> {
        let value = fields::value(spelt);
        let number = |least: f32, most: f32| {
            let number = value.as_ref().and_then(fields::number);
            let within = number.filter(|number| (least..=most).contains(number));
            within.ok_or_else(|| format!("a number from {least} to {most} is needed"))
        };
        let size = || number(1.0, 1e5).map(Some);
        match key {
            "theme" | "presenting" => {
                let name = value.as_ref().and_then(Value::as_str).unwrap_or_default();
                let known = || Theme::ALL.map(|theme| format!("\"{}\"", theme.name)).join(", ");
                let theme = Theme::named(name).ok_or_else(|| format!("there are {}", known()))?;
                theme.name.clone_into(if key == "theme" { &mut self.theme } else { &mut self.presenting });
            }
            "predict" => {
                self.predict = value.as_ref().and_then(Value::as_bool).ok_or("true or false is needed")?;
            }
            "motion" => {
                self.motion = Some(value.as_ref().and_then(Value::as_bool).ok_or("true or false is needed")?);
            }
            "zoom" => self.zoom = number(0.5, 3.0)?,
            "lesson" => self.lesson = size()?,
            "walk" => self.walk = size()?,
            "heights.work" => self.heights.work = size()?,
            "heights.stack" => self.heights.stack = size()?,
            "heights.tree" => self.heights.tree = size()?,
            "heights.ruler" => self.heights.ruler = size()?,
            "heights.bytes" => self.heights.bytes = size()?,
            "heights.changed" => self.heights.changed = size()?,
            "heights.tabs" => self.heights.tabs = size()?,
            _ => return Err("there is no such setting".to_owned()),
        }
        Ok(())
    }

    /// What the file shall say.
    fn said(&self) -> Table {
        Table::try_from(self).unwrap_or_default()
    }

    /// Writes the file if it would say something else. What cannot be written is not remembered; nothing else is lost.
    fn write(&mut self) {
        let (Some(file), said) = (&self.file, self.said()) else { return };
        if self.written != said && files::renew(file, &said.to_string()).is_ok() {
            self.written = said;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read_again() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("deep/window.toml");
        let mut kept = Remembered::of_file(&file);
        kept.write();
        assert!(!file.exists(), "what nobody has set is not written");
        kept.theme = "dark".to_owned();
        kept.lesson = Some(300.5);
        kept.heights.tree = Some(200.0);
        kept.write();
        let read = Remembered::of_file(&file);
        assert_eq!((read.wrong.as_slice(), read.said()), (&[][..], kept.said()));
        assert_eq!((read.theme.as_str(), read.lesson, read.heights.tree), ("dark", Some(300.5), Some(200.0)));
        assert_eq!(std::fs::read_dir(file.parent().unwrap()).unwrap().count(), 1, "no half-written file is left");

        // Whoever has written it by hand finds it again until something else is to be said.
        let own = "# mine\nzoom = 2 # large\ntheme = \"drak\"\n";
        std::fs::write(&file, own).unwrap();
        let mut read = Remembered::of_file(&file);
        read.write();
        assert_eq!(std::fs::read_to_string(&file).unwrap(), own);
        read.predict = false;
        read.write();
        let read = Remembered::of_file(&file);
        assert_eq!((read.zoom, read.predict, read.wrong.len()), (2.0, false, 0));
    }

    #[cfg(unix)]
    #[test]
    fn a_file_that_is_kept_elsewhere_stays_there() {
        let folder = tempfile::tempdir().unwrap();
        let [file, elsewhere] = ["window.toml", "elsewhere.toml"].map(|name| folder.path().join(name));
        std::fs::write(&elsewhere, "zoom = 2.0").unwrap();
        std::os::unix::fs::symlink(&elsewhere, &file).unwrap();
        let mut read = Remembered::of_file(&file);
        read.zoom = 1.5;
        read.write();
        assert!(std::fs::symlink_metadata(&file).unwrap().is_symlink());
        assert!(std::fs::read_to_string(&elsewhere).unwrap().contains("zoom = 1.5"));
    }

    #[test]
    fn one_wrong_field_loses_only_itself() {
        // Two good fields around each wrong one.
        let check = |line: &str, says: &[&str]| {
            let (above, below) = if line.starts_with("tree") { ("", line) } else { (line, "") };
            let text = format!("predict = false\n{above}\nlesson = 300\n[heights]\nstack = 90.0\n{below}\n");
            let read = Remembered::read(&text);
            let good = (read.predict, read.lesson, read.heights.stack);
            assert_eq!(good, (false, Some(300.0), Some(90.0)), "{line}: {:?}", read.wrong);
            let rest = Remembered { predict: true, lesson: None, wrong: Vec::new(), ..read.clone() };
            let rest = Remembered { heights: Heights { stack: None, ..read.heights }, ..rest };
            assert_eq!(rest, Remembered::default(), "{line}");
            assert_eq!(read.wrong, says, "{line}");
        };
        check("", &[]);
        check("# lesson = 5", &[]);
        check("zoom = \"large\"", &["2: zoom = \"large\": a number from 0.5 to 3 is needed; it is left out"]);
        check("zoom = nan", &["2: zoom = nan: a number from 0.5 to 3 is needed; it is left out"]);
        check("zoom = 1e9", &["2: zoom = 1e9: a number from 0.5 to 3 is needed; it is left out"]);
        check("walk = inf", &["2: walk = inf: a number from 1 to 100000 is needed; it is left out"]);
        check("walk = -5", &["2: walk = -5: a number from 1 to 100000 is needed; it is left out"]);
        check("theme = 3", &["2: theme = 3: there are \"light\", \"dark\", \"projector\", \"print\"; it is left out"]);
        check("tree = [1]", &["6: heights.tree = [1]: a number from 1 to 100000 is needed; it is left out"]);
        check("tree = 0.5", &["6: heights.tree = 0.5: a number from 1 to 100000 is needed; it is left out"]);
        check("thme = \"dark\"", &["2: thme = \"dark\": there is no such setting; it is left out"]);
    }

    #[test]
    fn a_broken_line_loses_only_itself() {
        let broken = [
            "zoom =",
            "zoom = 1..5",
            "= 3",
            "zoom",
            "zoom = \"2",
            "zoom = \"\"\"2",
            "{",
            "[",
            "]",
            "[[",
            "\u{0}\u{1}",
            "zoom = 2 3",
            "zoom = [1,",
            "zoom = {",
            "'",
            "zoom = 2 \\",
            "walk = 3\nwalk = 4",
        ];
        for line in broken {
            let read = Remembered::read(&format!("predict = false\n{line}\nlesson = 300\n"));
            let good = (read.predict, read.zoom, read.lesson);
            assert_eq!(good, (false, 1.0, Some(300.0)), "{line}: {:?}", read.wrong);
            assert!(read.wrong[0].starts_with(['2', '3']), "{line}: {:?}", read.wrong);
            assert!(read.wrong.iter().all(|says| !says.contains('\n')), "{line}: {:?}", read.wrong);
        }
        for text in ["\u{feff}zoom = 2.0\n", "zoom = 2.0\r\npredict = true\r\n", "\r\n\nzoom = 2"] {
            assert_eq!((Remembered::read(text).zoom, Remembered::read(text).wrong.len()), (2.0, 0), "{text:?}");
        }
    }
}
