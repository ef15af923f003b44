//! What a lecturer has set for the class: what covers the page, which panes stand below space, what is in the hand.

/// What covers the class's page.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Cover {
    /// All black: everybody looks at the lecturer.
    Black,
    /// All white: there is light to write by.
    White,
}

/// What is in the lecturer's hand.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum InHand {
    /// The usual pointer.
    #[default]
    Nothing,
    /// A large pointer.
    Pointer,
    /// A pen, whose strokes go at the next step.
    Pen,
}

/// What a lecturer has set for the class.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Lecture {
    /// What covers the page.
    pub cover: Option<Cover>,
    /// How often other panes were called for below space.
    pub turn: usize,
    /// What is in the lecturer's hand.
    pub in_hand: InHand,
    /// Whether the speaker's notes stand on the only screen.
    pub notes: bool,
    /// Whether the speaker's window is open.
    pub speaker: bool,
    /// Whether the class goes on seeing what it saw.
    pub frozen: bool,
    /// The number of a slide, as far as it is typed.
    pub typed: String,
}

/// The longest number of a slide that is typed.
const LONGEST: usize = 7;

impl Lecture {
    /// Covers the page, or uncovers it where it is covered so.
    pub(crate) fn cover(&mut self, cover: Cover) {
        self.cover = (self.cover != Some(cover)).then_some(cover);
    }

    /// Takes something in the hand, or puts it away.
    pub(crate) fn take(&mut self, thing: InHand) {
        self.in_hand = if self.in_hand == thing { InHand::Nothing } else { thing };
    }

    /// One more letter of a slide's number; what is longer than any begins anew.
    pub(crate) fn type_letter(&mut self, letter: u8) {
        if self.typed.len() >= LONGEST {
            self.typed.clear();
        }
        self.typed.push(char::from(letter));
    }
}
