//! Numbers that are typed into a field: what is none gets a sentence.

use std::cell::RefCell;
use std::ops::RangeInclusive;

use egui::{DragValue, Response, Ui};

/// What a number can be, and how its ends are written.
pub(crate) struct Allowed {
    pub(crate) range: RangeInclusive<f64>,
    pub(crate) digits: fn(f64) -> String,
    /// Whether it is a whole one.
    pub(crate) whole: bool,
}

impl Allowed {
    /// Any number.
    pub(crate) const ANY: Allowed = Allowed::within(f64::NEG_INFINITY, f64::INFINITY);

    /// Any number from one to another.
    pub(crate) const fn within(least: f64, most: f64) -> Allowed {
        Allowed { range: least..=most, digits: |number| number.to_string(), whole: false }
    }

    /// Any whole number from one to another.
    pub(crate) const fn whole(least: f64, most: f64) -> Allowed {
        Allowed { whole: true, ..Allowed::within(least, most) }
    }

    /// What is said of a text that was typed, and the number that it is.
    fn read(&self, name: &str, text: &str) -> (Option<f64>, Option<String>) {
        let [least, most] = [*self.range.start(), *self.range.end()];
        let ends = [least, most].map(self.digits);
        let goes =
            if least.is_finite() { format!("; {name} goes from {} to {}", ends[0], ends[1]) } else { String::new() };
        match number(text) {
            None => {
                let point = text.trim().replace(',', ".");
                let comma = text.matches(',').count() == 1 && point.parse::<f64>().is_ok();
                let hint = if comma { format!(", but {point} is: write a point") } else { String::new() };
                (None, Some(format!("\u{201c}{}\u{201d} is no number{hint}{goes}.", text.trim())))
            }
            Some(number) if self.whole && number.fract() != 0.0 && self.range.contains(&number) => {
                let nearest = (self.digits)(number.round());
                (Some(number.round()), Some(format!("{name} is a whole number: {nearest} is taken.")))
            }
            Some(number) if !self.range.contains(&number) => {
                let nearest = (self.digits)(number.clamp(least, most));
                (Some(number), Some(format!("\u{201c}{}\u{201d} cannot be{goes}: {nearest} is taken.", text.trim())))
            }
            number => (number, None),
        }
    }
}

/// How a field answered, and what was wrong with what was typed into it.
pub(crate) struct Typed {
    pub(crate) response: Response,
    pub(crate) wrong: Option<String>,
}

/// Adds a field for a number. A number outside of what is allowed becomes the nearest one that is, and is said to.
pub(crate) fn field(
    ui: &mut Ui,
    name: &str,
    allowed: &Allowed,
    field: DragValue<'_>,
    add: impl FnOnce(&mut Ui, DragValue<'_>) -> Response,
) -> Typed {
    let said = RefCell::new(None);
    let read = |text: &str| {
        let (number, wrong) = allowed.read(name, text);
        *said.borrow_mut() = wrong;
        number
    };
    let response = add(ui, field.custom_parser(read).update_while_editing(false));
    Typed { response, wrong: said.into_inner() }
}

/// A number as somebody types it: `50000`, `50,000`, `5e4`, `5·10⁴`, `5*10^4`.
fn number(text: &str) -> Option<f64> {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    // A comma stands before three digits, or means what nobody can tell.
    let groups = text.split(',').skip(1);
    let three = |group: &str| group.chars().take_while(char::is_ascii_digit).count() == 3;
    if !groups.into_iter().all(three) {
        return None;
    }
    let plain: String = text.chars().filter(|letter| !matches!(letter, ',' | '\'' | ' ' | '\u{a0}')).collect();
    let plain = plain.replace(['−', '⁻'], "-");
    let raised = |letter: char| RAISED.iter().position(|known| *known == letter);
    let lowered: String = plain
        .chars()
        .map(|letter| raised(letter).and_then(|digit| char::from_digit(digit as u32, 10)).unwrap_or(letter))
        .collect();
    let lowered = lowered.replace("·10^", "e").replace("*10^", "e").replace("·10", "e");
    lowered.parse::<f64>().ok().filter(|number| number.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_is_read_as_it_is_written() {
        let table = [
            ("1000", Some(1000.0)),
            (" 50,000 ", Some(50_000.0)),
            ("5e10", Some(5e10)),
            ("5·10¹⁰", Some(5e10)),
            ("5*10^10", Some(5e10)),
            ("1.5·10⁻⁵", Some(1.5e-5)),
            ("−2", Some(-2.0)),
            ("many", None),
            ("1,5", None),
            ("", None),
            ("inf", None),
        ];
        for (text, number) in table {
            assert_eq!(super::number(text), number, "{text}");
        }
    }

    #[test]
    fn what_cannot_be_is_said() {
        let check = |allowed: &Allowed, text: &str, is: Option<f64>, says: Option<&str>| {
            assert_eq!(allowed.read("depth", text), (is, says.map(str::to_owned)), "{text}");
        };
        let depth = Allowed::within(0.0, 64.0);
        check(&depth, "12", Some(12.0), None);
        check(&depth, "abc", None, Some("\u{201c}abc\u{201d} is no number; depth goes from 0 to 64."));
        let cannot = "\u{201c}999\u{201d} cannot be; depth goes from 0 to 64: 64 is taken.";
        check(&depth, "999", Some(999.0), Some(cannot));
        check(&Allowed::whole(0.0, 64.0), "12", Some(12.0), None);
        check(&Allowed::whole(0.0, 64.0), "2.5", Some(3.0), Some("depth is a whole number: 3 is taken."));
        check(&Allowed::ANY, "1,5", None, Some("\u{201c}1,5\u{201d} is no number, but 1.5 is: write a point."));
        check(&Allowed::ANY, "1e9", Some(1e9), None);
        check(&Allowed::ANY, "x", None, Some("\u{201c}x\u{201d} is no number."));
    }
}
