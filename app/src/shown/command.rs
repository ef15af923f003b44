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
    /// To the next thing that is said or asked, on the next slide where there is none left.
    Onward,
    /// To the thing that was said or asked before, on the slide before where there is none.
    Backward,
    /// To the next slide.
    NextSlide,
    /// To the slide before.
    PreviousSlide,
    /// A digit or a slash of a slide's number; Enter goes there.
    Type(u8),
    /// To the slide's next ray.
    NextRay,
    /// To the slide's ray before.
    PreviousRay,
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
    /// Show the other stage.
    OtherStage,
    /// Show brute force beside the walk.
    Compare,
    /// Show what each ray of the picture costs instead of space.
    Heat,
    /// Show a mistake beside the walk.
    Break,
    /// The presenter's page.
    Present,
    /// The speaker's own window.
    Speaker,
    /// What the speaker is to say, where there is one screen only.
    Notes,
    /// Other panes below space on the presenter's page.
    Panes,
    /// A black page for the class, or no longer.
    Black,
    /// A white one.
    White,
    /// The class goes on seeing what it sees.
    Freeze,
    /// A large pointer.
    Pointer,
    /// A pen, until the next step.
    Pen,
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
    /// The keys that give it on the presenter's page.
    pub presenting: &'static [&'static str],
}

/// The same keys on every page.
const fn entry(command: Command, name: &'static str, keys: &'static [&'static str]) -> Entry {
    Entry { command, name, keys, presenting: keys }
}

/// Other keys before a class than in the study.
const fn differs(
    command: Command,
    name: &'static str,
    keys: &'static [&'static str],
    presenting: &'static [&'static str],
) -> Entry {
    Entry { command, name, keys, presenting }
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
    differs(Command::Onward, "Next beat", &[], &["Page down"]),
    differs(Command::Backward, "Beat before", &[], &["Page up"]),
    differs(Command::NextSlide, "Next slide", &["Page down"], &["Shift+Page down"]),
    differs(Command::PreviousSlide, "Previous slide", &["Page up"], &["Shift+Page up"]),
    differs(Command::Type(b'0'), "Slide number: 0", &[], &["0"]),
    differs(Command::Type(b'1'), "Slide number: 1", &[], &["1"]),
    differs(Command::Type(b'2'), "Slide number: 2", &[], &["2"]),
    differs(Command::Type(b'3'), "Slide number: 3", &[], &["3"]),
    differs(Command::Type(b'4'), "Slide number: 4", &[], &["4"]),
    differs(Command::Type(b'5'), "Slide number: 5", &[], &["5"]),
    differs(Command::Type(b'6'), "Slide number: 6", &[], &["6"]),
    differs(Command::Type(b'7'), "Slide number: 7", &[], &["7"]),
    differs(Command::Type(b'8'), "Slide number: 8", &[], &["8"]),
    differs(Command::Type(b'9'), "Slide number: 9", &[], &["9"]),
    differs(Command::Type(b'/'), "Slide number: section, slash, slide", &[], &["/"]),
    entry(Command::NextRay, "Next ray", &["Y"]),
    entry(Command::PreviousRay, "Ray before", &["Shift+Y"]),
    entry(Command::Speed(1), "Speed ¼×", &[]),
    entry(Command::Speed(2), "Speed ½×", &[]),
    differs(Command::Speed(QUARTERS), "Speed 1×", &["1"], &[]),
    differs(Command::Speed(2 * QUARTERS), "Speed 2×", &["2"], &[]),
    differs(Command::Speed(3 * QUARTERS), "Speed 3×", &["3"], &[]),
    differs(Command::Speed(4 * QUARTERS), "Speed 4×", &["4"], &[]),
    differs(Command::Speed(5 * QUARTERS), "Speed 5×", &["5"], &[]),
    differs(Command::Speed(6 * QUARTERS), "Speed 6×", &["6"], &[]),
    differs(Command::Speed(7 * QUARTERS), "Speed 7×", &["7"], &[]),
    differs(Command::Speed(8 * QUARTERS), "Speed 8×", &["8"], &[]),
    differs(Command::Speed(9 * QUARTERS), "Speed 9×", &["9"], &[]),
    entry(Command::Grain(Grain::Arithmetic), "Step by arithmetic", &[]),
    entry(Command::Grain(Grain::Decision), "Step by decision", &[]),
    entry(Command::Grain(Grain::Visit), "Step by visit", &[]),
    differs(Command::Predict, "Predict", &["P"], &[]),
    differs(Command::Answer(0), "Answer A", &["A"], &["Alt+A"]),
    differs(Command::Answer(1), "Answer B", &["B"], &["Alt+B"]),
    differs(Command::Answer(2), "Answer C", &["C"], &["Alt+C"]),
    differs(Command::Answer(3), "Answer D", &["D"], &["Alt+D"]),
    entry(Command::Skip, "Skip the question", &["Enter"]),
    entry(Command::Lock, "Next step waits at an open question", &[]),
    entry(Command::ByHand, "Set parameters and ray by hand", &["S"]),
    entry(Command::Restore, "Back to the slide's own scene, ray and view", &["Backspace"]),
    entry(Command::Undo, "Undo", &["Ctrl+Z"]),
    entry(Command::Redo, "Redo", &["Ctrl+Shift+Z", "Ctrl+Y"]),
    entry(Command::Flat, "Flat", &[]),
    entry(Command::Solid, "Solid", &[]),
    entry(Command::OtherStage, "Flat or solid", &["V"]),
    entry(Command::Compare, "Compare", &["X"]),
    entry(Command::Heat, "Heat map", &["H"]),
    entry(Command::Break, "Break it", &["M"]),
    entry(Command::Present, "Present", &["F5"]),
    entry(Command::Speaker, "Speaker's window", &["F6"]),
    differs(Command::Notes, "Speaker's notes", &[], &["N"]),
    differs(Command::Panes, "Other panes", &[], &["C"]),
    differs(Command::Black, "Black page", &[], &["B", "."]),
    differs(Command::White, "White page", &[], &["W"]),
    differs(Command::Freeze, "Hold the class's page", &[], &["Z"]),
    differs(Command::Pointer, "Large pointer", &[], &["L"]),
    differs(Command::Pen, "Pen", &[], &["P"]),
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
    /// Its first keys: `"Ctrl+Z"`; of what is done before a class alone those that give it there.
    pub fn keys_text(&self) -> &'static str {
        self.keys.first().or(self.presenting.first()).copied().unwrap_or_default()
    }

    /// The keys that give it on the presenter's page, or in the study.
    pub fn keys_on(&self, present: bool) -> &'static [&'static str] {
        if present { self.presenting } else { self.keys }
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
                for present in [false, true] {
                    let taken = |key: &&str| b.keys_on(present).contains(key);
                    assert!(!a.keys_on(present).iter().any(taken), "{} and {}", a.name, b.name);
                }
            }
        }
    }

    #[test]
    fn tips_name_the_first_key() {
        assert_eq!(Command::Redo.tip(), "Redo  (Ctrl+Shift+Z)");
        assert_eq!(Command::Flat.tip(), "Flat");
    }
}
