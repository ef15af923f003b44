//! Everything that can be done, once: keys, menu, palette, help and accessible names read this.

use raystep_accel::Grain;

/// Something to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Command {
    /// Start or stop playing.
    Play,
    /// To the next step of the chosen grain.
    Next,
    /// To the step before.
    Previous,
    /// To the next step of the next coarser grain.
    NextCoarse,
    /// To the coarser step before.
    PreviousCoarse,
    /// Before the walk.
    First,
    /// To the walk's end.
    Last,
    /// To the next slide.
    NextSlide,
    /// To the slide before.
    PreviousSlide,
    /// Play at so many quarters of the usual speed.
    Speed(u8),
    /// Stop at steps of this grain.
    Grain(Grain),
    /// Ask before a step that answers a question.
    Predict,
    /// Give the answer with this number, from 0.
    Answer(u8),
    /// Do what the text offers, the first, the second ...
    Offer(u8),
    /// Go on without an answer.
    Skip,
    /// Whether → waits at an open question.
    Lock,
    /// Show or hide what can be set by hand: parameters, and the ray in numbers.
    ByHand,
    /// Back to the slide's own ray, parameters and view.
    Restore,
    /// Take back the last change.
    Undo,
    /// Make the change again.
    Redo,
    /// Show the flat stage.
    Flat,
    /// Show the solid stage.
    Solid,
    /// Show brute force beside the walk.
    Compare,
    /// Show what each ray of the picture costs instead of space.
    Heat,
    /// Show a mistake beside the walk.
    Break,
    /// The presenter's page.
    Present,
    /// Fill the screen.
    FullScreen,
    /// Move the camera to the current place.
    Frame,
    /// The slide's own camera.
    ResetCamera,
    /// The boxes of one level of a tree more.
    Deeper,
    /// The boxes of one level less.
    Shallower,
    /// All of the ray on the ruler.
    WholeRay,
    /// The slide's own scene, and the builder's cuts.
    ResetScene,
    /// Cut a node where a cut is tried.
    CutHere,
    /// Show how one step becomes the next.
    Motion,
    /// Write pictures to files.
    Export,
    /// Copy the picture of space.
    Copy,
    /// Copy a line of text that leads back to this place.
    Link,
    /// Measure all structures over what is shown.
    Best,
    /// Open a mesh.
    Open,
    /// Give up what is being built or loaded.
    Cancel,
    /// Search all commands and slides.
    Palette,
    /// The next theme.
    Theme,
    /// Everything larger.
    ZoomIn,
    /// Everything smaller.
    ZoomOut,
    /// The usual size.
    ZoomReset,
    /// The page of keys.
    Help,
}

/// What a command is called and which keys give it.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// The command.
    pub command: Command,
    /// Its name, also for screen readers.
    pub name: &'static str,
    /// The keys that give it, as they are read: `"Ctrl+Z"`. The first one is shown.
    pub keys: &'static [&'static str],
}

const fn entry(command: Command, name: &'static str, keys: &'static [&'static str]) -> Entry {
    Entry { command, name, keys }
}

/// How many quarters the usual speed has.
pub(crate) const QUARTERS: u8 = 4;

/// Every command.
pub const ENTRIES: &[Entry] = &[
    entry(Command::Play, "Play or pause", &["Space"]),
    entry(Command::Next, "Next step", &["→"]),
    entry(Command::Previous, "Previous step", &["←"]),
    entry(Command::NextCoarse, "Next coarser step", &["Shift+→"]),
    entry(Command::PreviousCoarse, "Previous coarser step", &["Shift+←"]),
    entry(Command::First, "First step", &["Home"]),
    entry(Command::Last, "Last step", &["End"]),
    entry(Command::NextSlide, "Next slide", &["Page down"]),
    entry(Command::PreviousSlide, "Previous slide", &["Page up"]),
    entry(Command::Speed(1), "Speed ¼×", &[]),
    entry(Command::Speed(2), "Speed ½×", &[]),
    entry(Command::Speed(QUARTERS), "Speed 1×", &["1"]),
    entry(Command::Speed(2 * QUARTERS), "Speed 2×", &["2"]),
    entry(Command::Speed(3 * QUARTERS), "Speed 3×", &["3"]),
    entry(Command::Speed(4 * QUARTERS), "Speed 4×", &["4"]),
    entry(Command::Speed(5 * QUARTERS), "Speed 5×", &["5"]),
    entry(Command::Speed(6 * QUARTERS), "Speed 6×", &["6"]),
    entry(Command::Speed(7 * QUARTERS), "Speed 7×", &["7"]),
    entry(Command::Speed(8 * QUARTERS), "Speed 8×", &["8"]),
    entry(Command::Speed(9 * QUARTERS), "Speed 9×", &["9"]),
    entry(Command::Grain(Grain::Arithmetic), "Step by arithmetic", &[]),
    entry(Command::Grain(Grain::Decision), "Step by decision", &[]),
    entry(Command::Grain(Grain::Visit), "Step by visit", &[]),
    entry(Command::Predict, "Predict", &["P"]),
    entry(Command::Answer(0), "Answer A", &["A"]),
    entry(Command::Answer(1), "Answer B", &["B"]),
    entry(Command::Answer(2), "Answer C", &["C"]),
    entry(Command::Answer(3), "Answer D", &["D"]),
    entry(Command::Skip, "Skip the question", &["Enter"]),
    entry(Command::Lock, "Next step waits at an open question", &[]),
    entry(Command::ByHand, "Set parameters and ray by hand", &["S"]),
    entry(Command::Restore, "Back to the slide's own scene, ray and view", &["Backspace"]),
    entry(Command::Undo, "Undo", &["Ctrl+Z"]),
    entry(Command::Redo, "Redo", &["Ctrl+Shift+Z", "Ctrl+Y"]),
    entry(Command::Flat, "Flat", &[]),
    entry(Command::Solid, "Solid", &[]),
    entry(Command::Compare, "Compare", &["X"]),
    entry(Command::Heat, "Heat map", &["H"]),
    entry(Command::Break, "Break it", &[]),
    entry(Command::Present, "Present", &["F5"]),
    entry(Command::FullScreen, "Full screen", &["F11"]),
    entry(Command::Frame, "Frame the current place", &["F"]),
    entry(Command::ResetCamera, "Reset the camera", &["R"]),
    entry(Command::Deeper, "Boxes of one level more", &["+", "="]),
    entry(Command::Shallower, "Boxes of one level less", &["−"]),
    entry(Command::WholeRay, "All of the ray on the ruler", &["T"]),
    entry(Command::ResetScene, "Reset the scene and its cuts", &["Shift+R"]),
    entry(Command::CutHere, "Cut where the plane is tried", &[]),
    entry(Command::Motion, "Motion between steps", &[]),
    entry(Command::Export, "Export", &["Ctrl+E"]),
    entry(Command::Copy, "Copy the picture", &["Ctrl+C"]),
    entry(Command::Link, "Copy a link to this place", &["Ctrl+L"]),
    entry(Command::Best, "Which structure is best?", &[]),
    entry(Command::Open, "Open a mesh", &["Ctrl+O"]),
    entry(Command::Cancel, "Cancel what is under way", &["Escape"]),
    entry(Command::Palette, "Find a command or slide", &["Ctrl+K"]),
    entry(Command::Theme, "Next theme: light, dark, projector", &[]),
    entry(Command::ZoomIn, "Zoom in", &["Ctrl++", "Ctrl+="]),
    entry(Command::ZoomOut, "Zoom out", &["Ctrl+−"]),
    entry(Command::ZoomReset, "Usual size", &["Ctrl+0"]),
    entry(Command::Help, "Keys", &["?", "F1"]),
];

impl Command {
    /// Its row in the table.
    pub fn entry(self) -> Option<&'static Entry> {
        ENTRIES.iter().find(|entry| entry.command == self)
    }

    /// What it is called.
    pub fn name(self) -> &'static str {
        self.entry().map_or("", |entry| entry.name)
    }

    /// Its name with its first key: what a tooltip says.
    pub fn tip(self) -> String {
        let keys = self.entry().map_or("", Entry::keys_text);
        if keys.is_empty() { self.name().to_owned() } else { format!("{}  ({keys})", self.name()) }
    }
}

impl Entry {
    /// Its first keys: `"Ctrl+Z"`.
    pub fn keys_text(&self) -> &'static str {
        self.keys.first().copied().unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_commands_share_a_name_or_a_key() {
        for (i, a) in ENTRIES.iter().enumerate() {
            for b in &ENTRIES[i + 1..] {
                assert_ne!(a.name, b.name);
                assert!(a.keys.iter().all(|key| !b.keys.contains(key)), "{} and {}", a.name, b.name);
            }
        }
    }

    #[test]
    fn tips_name_the_first_key() {
        assert_eq!(Command::Redo.tip(), "Redo  (Ctrl+Shift+Z)");
        assert_eq!(Command::Flat.tip(), "Flat");
    }
}
