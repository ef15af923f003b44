//! Everything that can be done in the window, once: keys, menu, palette, help and accessible names read this.

use egui::{Key, Modifiers};
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
    /// Play so many times as fast.
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
    /// Write pictures to files.
    Export,
    /// Copy the picture of space.
    Copy,
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
    /// The keys that give it, the first one shown.
    pub keys: &'static [(Modifiers, Key)],
}

const NONE: Modifiers = Modifiers::NONE;
const SHIFT: Modifiers = Modifiers::SHIFT;
const CTRL: Modifiers = Modifiers::COMMAND;

const fn entry(command: Command, name: &'static str, keys: &'static [(Modifiers, Key)]) -> Entry {
    Entry { command, name, keys }
}

/// Every command.
pub const ENTRIES: &[Entry] = &[
    entry(Command::Play, "Play or pause", &[(NONE, Key::Space)]),
    entry(Command::Next, "Next step", &[(NONE, Key::ArrowRight)]),
    entry(Command::Previous, "Previous step", &[(NONE, Key::ArrowLeft)]),
    entry(Command::NextCoarse, "Next coarser step", &[(SHIFT, Key::ArrowRight)]),
    entry(Command::PreviousCoarse, "Previous coarser step", &[(SHIFT, Key::ArrowLeft)]),
    entry(Command::First, "First step", &[(NONE, Key::Home)]),
    entry(Command::Last, "Last step", &[(NONE, Key::End)]),
    entry(Command::NextSlide, "Next slide", &[(NONE, Key::PageDown)]),
    entry(Command::PreviousSlide, "Previous slide", &[(NONE, Key::PageUp)]),
    entry(Command::Speed(1), "Speed 1×", &[(NONE, Key::Num1)]),
    entry(Command::Speed(2), "Speed 2×", &[(NONE, Key::Num2)]),
    entry(Command::Speed(3), "Speed 3×", &[(NONE, Key::Num3)]),
    entry(Command::Speed(4), "Speed 4×", &[(NONE, Key::Num4)]),
    entry(Command::Speed(5), "Speed 5×", &[(NONE, Key::Num5)]),
    entry(Command::Speed(6), "Speed 6×", &[(NONE, Key::Num6)]),
    entry(Command::Speed(7), "Speed 7×", &[(NONE, Key::Num7)]),
    entry(Command::Speed(8), "Speed 8×", &[(NONE, Key::Num8)]),
    entry(Command::Speed(9), "Speed 9×", &[(NONE, Key::Num9)]),
    entry(Command::Grain(Grain::Arithmetic), "Step by arithmetic", &[]),
    entry(Command::Grain(Grain::Decision), "Step by decision", &[]),
    entry(Command::Grain(Grain::Visit), "Step by visit", &[]),
    entry(Command::Predict, "Predict", &[(NONE, Key::P)]),
    entry(Command::Answer(0), "Answer A", &[(NONE, Key::A)]),
    entry(Command::Answer(1), "Answer B", &[(NONE, Key::B)]),
    entry(Command::Answer(2), "Answer C", &[(NONE, Key::C)]),
    entry(Command::Answer(3), "Answer D", &[(NONE, Key::D)]),
    entry(Command::Skip, "Skip the question", &[(NONE, Key::Enter)]),
    entry(Command::Lock, "Next step waits at an open question", &[]),
    entry(Command::Restore, "Back to the slide's own ray and view", &[(NONE, Key::Backspace)]),
    entry(Command::Undo, "Undo", &[(CTRL, Key::Z)]),
    entry(Command::Redo, "Redo", &[(CTRL.plus(SHIFT), Key::Z), (CTRL, Key::Y)]),
    entry(Command::Flat, "Flat", &[]),
    entry(Command::Solid, "Solid", &[]),
    entry(Command::Compare, "Compare", &[(NONE, Key::X)]),
    entry(Command::Break, "Break it", &[]),
    entry(Command::Present, "Present", &[(NONE, Key::F5)]),
    entry(Command::FullScreen, "Full screen", &[(NONE, Key::F11)]),
    entry(Command::Frame, "Frame the current place", &[(NONE, Key::F)]),
    entry(Command::ResetCamera, "Reset the camera", &[(NONE, Key::R)]),
    entry(Command::Export, "Export", &[(CTRL, Key::E)]),
    entry(Command::Copy, "Copy the picture", &[(CTRL, Key::C)]),
    entry(Command::Open, "Open a mesh", &[(CTRL, Key::O)]),
    entry(Command::Cancel, "Cancel what is under way", &[(NONE, Key::Escape)]),
    entry(Command::Palette, "Find a command or slide", &[(CTRL, Key::K)]),
    entry(Command::Theme, "Next theme: light, dark, projector", &[]),
    entry(Command::ZoomIn, "Zoom in", &[(CTRL, Key::Plus), (CTRL, Key::Equals)]),
    entry(Command::ZoomOut, "Zoom out", &[(CTRL, Key::Minus)]),
    entry(Command::ZoomReset, "Usual size", &[(CTRL, Key::Num0)]),
    entry(Command::Help, "Keys", &[(NONE, Key::Questionmark), (NONE, Key::F1)]),
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
        let keys = self.entry().map_or(String::new(), Entry::keys_text);
        if keys.is_empty() { self.name().to_owned() } else { format!("{}  ({keys})", self.name()) }
    }
}

impl Entry {
    /// Its first keys as text: `"Ctrl+Z"`.
    pub fn keys_text(&self) -> String {
        self.keys.first().map_or(String::new(), |&(modifiers, key)| keys_text(modifiers, key))
    }
}

fn keys_text(modifiers: Modifiers, key: Key) -> String {
    let mut text = String::new();
    if modifiers.command {
        text.push_str("Ctrl+");
    }
    if modifiers.shift {
        text.push_str("Shift+");
    }
    text.push_str(match key {
        Key::ArrowRight => "→",
        Key::ArrowLeft => "←",
        Key::PageDown => "Page down",
        Key::PageUp => "Page up",
        Key::Questionmark => "?",
        Key::Plus => "+",
        Key::Minus => "−",
        other => other.name(),
    });
    text
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
