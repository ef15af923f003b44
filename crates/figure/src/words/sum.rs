//! Sums and comparisons in a text: they come out as they stand there, with as many digits as that takes.

use std::ops::Range;

use super::number::{digits, number};

/// The most digits that a number of a sum has. One that does not come out even so is said to come out nearly: `≈`.
const MOST: usize = 6;

/// What stands between two numbers that are compared.
const COMPARES: [&str; 12] = [
    "less than",
    "smaller than",
    "more than",
    "larger than",
    "nearer than",
    "further than",
    ", not ",
    " < ",
    " > ",
    " ≤ ",
    " ≥ ",
    " comes ",
];

/// A piece of a text.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Piece {
    /// What stands as it is.
    Text(String),
    /// A number, in brackets after a sign.
    Number { x: f32, bracketed: bool },
}

impl Piece {
    fn write(&self, count: usize) -> String {
        match self {
            Piece::Text(text) => text.clone(),
            Piece::Number { x, bracketed: false } => digits(*x, count),
            Piece::Number { x, bracketed: true } => format!("({})", digits(*x, count)),
        }
    }
}

/// The pieces as one text. Where `0.51 · 9 = 4.61` stands in it and does not come out in the digits that are shown, the
/// numbers before the sign get more of them; so do two that are compared and look alike.
pub(crate) fn come_out(pieces: &[Piece]) -> String {
    let mut counts = vec![3; pieces.len()];
    let mut signs = Vec::new();
    let (text, _) = written(pieces, &counts);
    let places: Vec<usize> = text.match_indices(" = ").map(|(at, _)| at).collect();
    // What is written before a sign moves it: it is found again by its number among them.
    for nth in 0..places.len() {
        let at_digits = |counts: &[usize]| {
            let (text, spans) = written(pieces, counts);
            let at = text.match_indices(" = ").nth(nth)?.0;
            let (sum, result) = equation(&text, at)?;
            let comes = number(value_of(&text[sum.clone()])? as f32) == result;
            let within = spans.iter().enumerate().filter(|(_, (from, to))| *from >= sum.start && *to <= sum.end);
            Some((comes, within.map(|(index, _)| index).collect::<Vec<_>>()))
        };
        let Some((false, within)) = at_digits(&counts) else { continue };
        let finer = (4..=MOST).find_map(|count| {
            let mut more = counts.clone();
            for &index in &within {
                more[index] = count;
            }
            at_digits(&more).is_some_and(|(comes, _)| comes).then_some(more)
        });
        match finer {
            Some(more) => counts = more,
            None => signs.push(nth),
        }
    }
    tell_apart(pieces, &mut counts);
    let (text, _) = written(pieces, &counts);
    let mut nearly = text.clone();
    for (nth, (at, sign)) in text.match_indices(" = ").enumerate().collect::<Vec<_>>().into_iter().rev() {
        if signs.contains(&nth) {
            nearly.replace_range(at..at + sign.len(), " ≈ ");
        }
    }
    nearly
}

/// More digits for two numbers that are compared, differ, and look alike.
fn tell_apart(pieces: &[Piece], counts: &mut [usize]) {
    for (i, three) in pieces.windows(3).enumerate() {
        let [Piece::Number { x, .. }, Piece::Text(between), Piece::Number { x: other, .. }] = three else { continue };
        let alike = |count: usize| digits(*x, count) == digits(*other, count);
        if x == other || !COMPARES.iter().any(|word| between.contains(word)) || !alike(counts[i].max(counts[i + 2])) {
            continue;
        }
        if let Some(count) = (4..=MOST).find(|count| !alike(*count)) {
            (counts[i], counts[i + 2]) = (count, count);
        }
    }
}

/// The text, and where each piece lies in it.
fn written(pieces: &[Piece], counts: &[usize]) -> (String, Vec<(usize, usize)>) {
    let mut text = String::new();
    let spans = pieces.iter().zip(counts).map(|(piece, count)| {
        let from = text.len();
        text.push_str(&piece.write(*count));
        (from, text.len())
    });
    let spans = spans.collect();
    (text, spans)
}

/// A sum and what it comes to, around the sign at this place: whichever stands first.
fn equation(text: &str, at: usize) -> Option<(Range<usize>, &str)> {
    let (before, after) = (&text[..at], &text[at + 3..]);
    if let (Some(start), Some(result)) = (sum_before(before), result_after(after)) {
        return Some((start..at, result));
    }
    let end = sum_after(after)?;
    Some((at + 3..at + 3 + end, result_before(before)?))
}

/// Where the longest sum begins that ends with this text.
fn sum_before(text: &str) -> Option<usize> {
    let of_sums = |c: char| c.is_ascii_digit() || " .,()−+-·×/".contains(c);
    let run = text.rfind(|c| !of_sums(c)).map_or(0, |at| at + text[at..].chars().next().map_or(1, char::len_utf8));
    let begins = |at: usize| {
        let before = text[..at].chars().next_back();
        let sign = text[..at].trim_end().chars().next_back();
        before.is_none_or(|c| c == ' ' || c == '(') && !sign.is_some_and(|c| "−+-·×/".contains(c))
    };
    let starts = text[run..].char_indices().filter(|(_, c)| *c != ' ').map(|(at, _)| run + at);
    starts.filter(|at| begins(*at)).find(|at| value_of(&text[*at..]).is_some())
}

/// The number with which a text begins, if nothing is done to it.
fn result_after(text: &str) -> Option<&str> {
    let inner = |c: char| c.is_ascii_digit() || ",.−-".contains(c);
    let end = text.find(|c| !inner(c)).unwrap_or(text.len());
    let (found, rest) = text.split_at(end);
    let found = found.trim_end_matches([',', '.']);
    let goes_on = rest.trim_start().starts_with(['−', '+', '-', '·', '×', '/', '⁻', '\\', '^'])
        || rest.starts_with(|c: char| c.is_alphanumeric());
    (found.contains(|c: char| c.is_ascii_digit()) && !goes_on).then_some(found)
}

/// Where the longest sum ends with which a text begins.
fn sum_after(text: &str) -> Option<usize> {
    let of_sums = |c: char| c.is_ascii_digit() || " .,()−+-·×/".contains(c);
    let run = text.find(|c| !of_sums(c)).unwrap_or(text.len());
    let ends = text[..run].char_indices().map(|(at, c)| at + c.len_utf8()).rev();
    let goes_on = |end: usize| {
        let rest = text[end..].trim_start();
        rest.starts_with(['−', '+', '-', '·', '×', '/', '\\', '^', '⁻'])
            || text[end..].starts_with(char::is_alphanumeric)
    };
    let mut ends = ends.filter(|end| !text[..*end].ends_with(' ') && !goes_on(*end));
    ends.find(|end| value_of(&text[..*end]).is_some())
}

/// The number with which a text ends, if nothing is done to it.
fn result_before(text: &str) -> Option<&str> {
    let inner = |c: char| c.is_ascii_digit() || ",.−".contains(c);
    let start = text.rfind(|c| !inner(c)).map_or(0, |at| at + text[at..].chars().next().map_or(1, char::len_utf8));
    let (rest, found) = text.split_at(start);
    let goes_on =
        rest.trim_end().ends_with(['−', '+', '-', '·', '×', '/', '(']) || rest.ends_with(|c: char| c.is_alphanumeric());
    (found.contains(|c: char| c.is_ascii_digit()) && !goes_on).then_some(found)
}

/// What a sum of at least two numbers comes to.
fn value_of(text: &str) -> Option<f64> {
    let mut sum = Sum { rest: text, signs: 0 };
    let value = sum.sum()?;
    (sum.rest.trim().is_empty() && sum.signs > 0).then_some(value)
}

/// A sum being read.
struct Sum<'a> {
    rest: &'a str,
    /// How many signs stood between numbers so far.
    signs: usize,
}

impl Sum<'_> {
    fn sum(&mut self) -> Option<f64> {
        let mut value = self.product()?;
        loop {
            match self.sign(&['+', '−', '-']) {
                Some('+') => value += self.product()?,
                Some(_) => value -= self.product()?,
                None => return Some(value),
            }
        }
    }

    fn product(&mut self) -> Option<f64> {
        let mut value = self.factor()?;
        loop {
            match self.sign(&['·', '×', '/']) {
                Some('/') => value /= self.factor()?,
                Some(_) => value *= self.factor()?,
                None => return Some(value),
            }
        }
    }

    /// A number, with its own sign right before it, or a sum in brackets.
    fn factor(&mut self) -> Option<f64> {
        let rest = self.rest.trim_start();
        if let Some(inner) = rest.strip_prefix('(') {
            self.rest = inner;
            let value = self.sum()?;
            self.rest = self.rest.trim_start().strip_prefix(')')?;
            return Some(value);
        }
        let (unsigned, negative) = match rest.strip_prefix(['−', '-']) {
            Some(unsigned) => (unsigned, true),
            None => (rest, false),
        };
        let end = unsigned.find(|c: char| !(c.is_ascii_digit() || c == '.' || c == ',')).unwrap_or(unsigned.len());
        let (digits, rest) = unsigned.split_at(end);
        if digits.ends_with([',', '.']) {
            return None;
        }
        self.rest = rest;
        let value: f64 = digits.replace(',', "").parse().ok()?;
        Some(if negative { -value } else { value })
    }

    fn sign(&mut self, among: &[char]) -> Option<char> {
        let rest = self.rest.trim_start();
        let sign = rest.chars().next().filter(|sign| among.contains(sign))?;
        self.rest = &rest[sign.len_utf8()..];
        self.signs += 1;
        Some(sign)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(text: &str) -> Piece {
        Piece::Text(text.to_owned())
    }

    fn exact(x: f32) -> Piece {
        Piece::Number { x, bracketed: false }
    }

    #[test]
    fn a_sum_has_the_digits_that_it_takes() {
        let chance = |count: &str, p: f32, cost: f32| come_out(&[text(count), exact(p), text(" = "), exact(cost)]);
        assert_eq!(chance("9 · ", 0.512, 4.608), "9 · 0.512 = 4.61");
        // 5000 · 0.512 would be 2560.
        assert_eq!(chance("5000 · ", 0.512_34, 2561.7), "5000 · 0.5123 = 2562");
        // Only what stands before the sign gets more of them.
        let two = [exact(0.51234), text(": 5000 · "), exact(0.51234), text(" = "), exact(2561.7), text(".")];
        assert_eq!(come_out(&two), "0.512: 5000 · 0.5123 = 2562.");
        // The sum may stand behind it.
        let behind = [exact(2561.7), text(" = 5000 · "), exact(0.51234), text(" primitives")];
        assert_eq!(come_out(&behind), "2562 = 5000 · 0.5123 primitives");
        // What was computed in another order of roundings comes out nearly.
        assert_eq!(chance("2 · ", 0.5, 1.25), "2 · 0.5 ≈ 1.25");
    }

    #[test]
    fn what_is_compared_has_the_digits_that_tell_it_apart() {
        let compared = |a: f32, between: &str, b: f32| come_out(&[exact(a), text(between), exact(b), text(".")]);
        assert_eq!(compared(25.5914, " is less than ", 25.6023), "25.59 is less than 25.6.");
        assert_eq!(compared(25.6, " ≥ ", 25.6), "25.6 ≥ 25.6.");
        assert_eq!(compared(25.5914, " and ", 25.6023), "25.6 and 25.6.");
        assert_eq!(compared(3.0, " < ", 3.000_000_2), "3 < 3.");
    }

    #[test]
    fn what_is_no_sum_stays_as_it_is() {
        for as_it_is in [
            "t = 3",
            "x − 3 = 4",
            "n · 3 + 4 = 9",
            "step 3. 1 + 1 = 2",
            "(x, 3 + 4) = 9",
            "8 × 8 = 64 cells",
            "1 + 2 = 1 + 3",
            "3·10⁷ · 2 = 9",
            "cells 2, 3 = 4",
            "1 + 2 = 3·10⁷",
        ] {
            assert_eq!(come_out(&[text(as_it_is)]), as_it_is);
        }
        for (wrong, nearly) in
            [("(2 − (−1)) / 4 = 0.8", "(2 − (−1)) / 4 ≈ 0.8"), ("so 1 + −2 = 3, and", "so 1 + −2 ≈ 3, and")]
        {
            assert_eq!(come_out(&[text(wrong)]), nearly);
        }
    }
}
