//! Which rays of a packet take part.

use std::fmt;

/// A set of lanes of a packet of `width` rays. Written with each lane's own digit in its place: `0--3` are
/// the first and the last of four.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Lanes {
    /// Bit `i` stands for lane `i`.
    mask: u16,
    width: u8,
}

impl Lanes {
    /// The widest packet.
    pub const MOST: usize = u16::BITS as usize;

    /// The lanes below `width` that `takes_part` names. `width` must not be above [`Lanes::MOST`].
    #[inline]
    pub fn of(width: usize, mut takes_part: impl FnMut(usize) -> bool) -> Lanes {
        let mask = (0..width).fold(0, |mask, lane| mask | u16::from(takes_part(lane)) << lane);
        Lanes { mask, width: width as u8 }
    }

    /// No lane.
    #[inline]
    pub fn none(width: usize) -> Lanes {
        Lanes { mask: 0, width: width as u8 }
    }

    /// A single lane.
    #[inline]
    pub fn one(width: usize, lane: usize) -> Lanes {
        Lanes { mask: 1 << lane, width: width as u8 }
    }

    /// How many lanes the packet has.
    #[inline]
    pub fn width(self) -> usize {
        usize::from(self.width)
    }

    /// One bit a lane, the first lowest.
    #[inline]
    pub fn mask(self) -> u16 {
        self.mask
    }

    /// How many take part.
    #[inline]
    pub fn count(self) -> u32 {
        self.mask.count_ones()
    }

    /// Whether none takes part.
    #[inline]
    pub fn is_empty(self) -> bool {
        self.mask == 0
    }

    /// Whether this one takes part.
    #[inline]
    pub fn has(self, lane: usize) -> bool {
        self.mask >> lane & 1 == 1
    }

    /// With one more.
    #[inline]
    #[must_use]
    pub fn with(self, lane: usize) -> Lanes {
        Lanes { mask: self.mask | 1 << lane, ..self }
    }

    /// Those that are in both sets.
    #[inline]
    #[must_use]
    pub fn and(self, other: Lanes) -> Lanes {
        Lanes { mask: self.mask & other.mask, ..self }
    }

    /// Those that take part, in order.
    #[inline]
    pub fn iter(self) -> impl Iterator<Item = usize> {
        (0..self.width()).filter(move |&lane| self.has(lane))
    }
}

impl fmt::Display for Lanes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        (0..self.width()).try_for_each(|lane| if self.has(lane) { write!(f, "{lane:x}") } else { f.write_str("-") })
    }
}
