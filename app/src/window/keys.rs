//! From keys to commands, while no field has the focus.

use egui::{Event, Key, Modifiers, Ui};

use crate::shown::command::{Command, ENTRIES};

/// The events of this frame that may be commands, and whether a widget has the focus and keeps most keys. None while
/// something is chosen from a list.
pub(super) fn events(ui: &Ui) -> (Vec<Event>, bool) {
    if ui.ctx().any_popup_open() {
        return (Vec::new(), false);
    }
    let focused = ui.ctx().memory(egui::Memory::focused);
    // Esc lets go of a widget.
    if let Some(id) = focused.filter(|_| ui.input(|input| input.key_pressed(Key::Escape))) {
        ui.ctx().memory_mut(|memory| memory.surrender_focus(id));
    }
    (ui.input(|input| input.events.clone()), focused.is_some())
}

/// The command that an event gives; `present` on the presenter's page, where `typing` are the letters that go on with the
/// number of a slide that is being typed.
pub(super) fn given_by(event: &Event, focused: bool, present: bool, typing: &[char]) -> Option<Command> {
    let letter = letter(event, typing).filter(|_| !focused);
    letter.or_else(|| command(event, focused, present))
}

/// The letter of a slide's number, `40b`, if the event is one of those that are `typing` now.
fn letter(event: &Event, typing: &[char]) -> Option<Command> {
    let Event::Key { key, pressed: true, modifiers: Modifiers::NONE, .. } = event else { return None };
    let letter = key.name().to_ascii_lowercase().parse::<char>().ok().filter(char::is_ascii_alphabetic)?;
    typing.contains(&letter).then_some(Command::Type(letter as u8))
}

/// Whether Shift is held: what runs forth runs back.
pub(super) fn shift(ui: &Ui) -> bool {
    ui.input(|input| input.modifiers.shift)
}

/// The command of an event; `focused` leaves only those with Ctrl and the F keys, which no button takes.
fn command(event: &Event, focused: bool, present: bool) -> Option<Command> {
    let (key, modifiers) = match event {
        Event::Copy => return (!focused).then_some(Command::Copy),
        Event::Key { key, pressed: true, modifiers, .. } => (*key, *modifiers),
        _ => return None,
    };
    let entry = ENTRIES.iter().find(|entry| entry.keys_on(present).iter().any(|keys| given(keys, key, modifiers)))?;
    let free = matches!(key, Key::F1 | Key::F5 | Key::F6 | Key::F11 | Key::PageDown | Key::PageUp)
        || modifiers.command && !matches!(entry.command, Command::Undo | Command::Redo | Command::Copy);
    (!focused || free).then_some(entry.command)
}

/// Whether this key was wanted, as the table of commands spells it.
fn given(keys: &str, key: Key, modifiers: Modifiers) -> bool {
    let Some(wanted) = Wanted::read(keys) else { return false };
    // On some keyboards these need Shift to be typed.
    let typed = matches!(wanted.key, Key::Questionmark | Key::Plus | Key::Slash);
    key == wanted.key
        && modifiers.command == wanted.ctrl
        && modifiers.alt == wanted.alt
        && (typed || modifiers.shift == wanted.shift)
}

/// A key with what is held down beside it.
struct Wanted {
    ctrl: bool,
    alt: bool,
    shift: bool,
    key: Key,
}

impl Wanted {
    /// `"Ctrl+Shift+Z"`.
    fn read(keys: &str) -> Option<Wanted> {
        let (ctrl, keys) = keys.strip_prefix("Ctrl+").map_or((false, keys), |rest| (true, rest));
        let (alt, keys) = keys.strip_prefix("Alt+").map_or((false, keys), |rest| (true, rest));
        let (shift, keys) = keys.strip_prefix("Shift+").map_or((false, keys), |rest| (true, rest));
        let key = match keys {
            "→" => Key::ArrowRight,
            "←" => Key::ArrowLeft,
            "Page down" => Key::PageDown,
            "Page up" => Key::PageUp,
            name => Key::from_name(name)?,
        };
        Some(Wanted { ctrl, alt, shift, key })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn press(key: Key, modifiers: Modifiers) -> Event {
        Event::Key { key, physical_key: None, pressed: true, repeat: false, modifiers }
    }

    #[test]
    fn keys_give_commands() {
        let ctrl = Modifiers { ctrl: true, command: true, ..Modifiers::NONE };
        let give = |key, modifiers| command(&press(key, modifiers), false, false);
        assert_eq!(give(Key::ArrowRight, Modifiers::NONE), Some(Command::Next));
        assert_eq!(give(Key::ArrowRight, Modifiers::SHIFT), Some(Command::NextCoarse));
        assert_eq!(give(Key::Z, ctrl), Some(Command::Undo));
        assert_eq!(give(Key::Z, ctrl | Modifiers::SHIFT), Some(Command::Redo));
        assert_eq!(give(Key::Questionmark, Modifiers::SHIFT), Some(Command::Help));
        assert_eq!(give(Key::A, ctrl), None);
    }

    #[test]
    fn a_clicker_walks_by_beats_and_letters_give_no_answers_before_a_class() {
        let check = |key, modifiers, study, class| {
            let event = press(key, modifiers);
            assert_eq!((command(&event, false, false), command(&event, false, true)), (study, class), "{key:?}");
        };
        let none = Modifiers::NONE;
        check(Key::PageDown, none, Some(Command::NextSlide), Some(Command::Onward));
        check(Key::PageUp, none, Some(Command::PreviousSlide), Some(Command::Backward));
        check(Key::PageDown, Modifiers::SHIFT, None, Some(Command::NextSlide));
        check(Key::B, none, Some(Command::Answer(1)), Some(Command::Black));
        check(Key::Period, none, None, Some(Command::Black));
        check(Key::B, Modifiers::ALT, None, Some(Command::Answer(1)));
        check(Key::Num3, none, Some(Command::Speed(12)), Some(Command::Type(b'3')));
        check(Key::Slash, Modifiers::SHIFT, None, Some(Command::Type(b'/')));
        check(Key::P, none, Some(Command::Predict), Some(Command::Pen));
        assert_eq!(letter(&press(Key::B, none), &['b']), Some(Command::Type(b'b')), "40b");
        assert_eq!(letter(&press(Key::B, none), &[]), None);
        assert_eq!(letter(&press(Key::C, none), &['b']), None);
        check(Key::F6, none, Some(Command::Speaker), Some(Command::Speaker));
    }

    #[test]
    fn every_key_of_the_table_is_known() {
        for keys in ENTRIES.iter().flat_map(|entry| entry.keys.iter().chain(entry.presenting)) {
            assert!(Wanted::read(keys).is_some(), "{keys}");
        }
    }

    #[test]
    fn a_focused_widget_keeps_its_keys() {
        for key in [Key::Space, Key::ArrowRight, Key::Enter, Key::A] {
            assert_eq!(command(&press(key, Modifiers::NONE), true, false), None);
        }
        assert_eq!(command(&press(Key::F5, Modifiers::NONE), true, true), Some(Command::Present));
    }
}
