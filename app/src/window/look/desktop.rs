//! What the desktop says of motion: those who have switched it off there see none here.

use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::sync::mpsc::channel;
use std::time::Duration;

/// How long the desktop may take to answer.
const PATIENCE: Duration = Duration::from_millis(150);

/// A program that knows, its arguments, and the answer that means no motion.
const ASKED: (&str, &[&str], &str) = if cfg!(target_os = "macos") {
    ("defaults", &["read", "com.apple.universalaccess", "reduceMotion"], "1")
} else {
    ("gsettings", &["get", "org.gnome.desktop.interface", "enable-animations"], "false")
};

/// Files of desktops below the folder of settings, and the line in them that means no motion.
const FILES: [(&str, &str, &str); 3] = [
    ("kdeglobals", "AnimationDurationFactor", "0"),
    ("gtk-4.0/settings.ini", "gtk-enable-animations", "false"),
    ("gtk-3.0/settings.ini", "gtk-enable-animations", "false"),
];

/// Whether the desktop wants windows to move; yes if it does not say.
pub(super) fn wants_motion() -> bool {
    let home = || Some(PathBuf::from(std::env::var_os("HOME")?).join(".config"));
    let folder = std::env::var_os("XDG_CONFIG_HOME").map(PathBuf::from).or_else(home);
    let refuses = |(file, key, value): &(&str, &str, &str)| {
        let text = folder.as_ref().and_then(|folder| std::fs::read_to_string(folder.join(file)).ok());
        text.is_some_and(|text| says(&text, key, value))
    };
    !FILES.iter().any(refuses) && !answers()
}

/// Whether a file has a line `key = value`.
fn says(text: &str, key: &str, value: &str) -> bool {
    let is_off = |found: &str| found == value || value == "false" && found == "0";
    text.lines().filter_map(|line| line.split_once('=')).any(|(name, found)| name.trim() == key && is_off(found.trim()))
}

/// Whether the program that knows says that there shall be no motion. If there is none, or it takes long, it does not.
fn answers() -> bool {
    let (sender, answer) = channel();
    std::thread::spawn(move || {
        let (program, arguments, _) = ASKED;
        let mut asked = Command::new(program);
        let said = asked.args(arguments).stdin(Stdio::null()).stderr(Stdio::null()).output();
        // Nobody may wait any more.
        let _ = sender.send(said.map(|said| String::from_utf8_lossy(&said.stdout).trim().to_owned()));
    });
    matches!(answer.recv_timeout(PATIENCE), Ok(Ok(said)) if said == ASKED.2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_of_desktops_are_read() {
        let check = |text: &str, off: [bool; 2]| {
            let [kde, gtk, _] = FILES.map(|(_, key, value)| says(text, key, value));
            assert_eq!([kde, gtk], off, "{text}");
        };
        check("[KDE]\nAnimationDurationFactor=0\n", [true, false]);
        check("[KDE]\nAnimationDurationFactor=0.5\n", [false, false]);
        check("[Settings]\ngtk-enable-animations = false\n", [false, true]);
        check("[Settings]\ngtk-enable-animations=0\r\n", [false, true]);
        check("[Settings]\ngtk-enable-animations=1\n", [false, false]);
        check("", [false, false]);
    }
}
