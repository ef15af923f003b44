//! How long a slide takes, as its notes say: "About 5 minutes", "Two minutes".

/// Numbers that notes write out.
const WORDS: [&str; 12] =
    ["one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"];

/// The first number of minutes that a text names.
pub(crate) fn minutes(text: &str) -> Option<f32> {
    let words: Vec<&str> = text.split(|letter: char| !letter.is_alphanumeric() && letter != '.').collect();
    words.windows(2).find_map(|pair| {
        let [number, unit] = pair else { return None };
        let counts = ["minute", "minutes"].contains(&unit.trim_end_matches('.'));
        let word = WORDS.iter().position(|word| word.eq_ignore_ascii_case(number)).map(|index| index as f32 + 1.0);
        word.or_else(|| number.parse().ok()).filter(|minutes: &f32| counts && *minutes > 0.0 && *minutes < 1000.0)
    })
}

#[cfg(test)]
mod tests {
    use super::minutes;

    #[test]
    fn the_first_number_of_minutes_counts() {
        let check = |text: &str, found: Option<f32>| assert_eq!(minutes(text), found, "{text}");
        check("- About 8 minutes. Slides 33 to 38 of the deck in one.", Some(8.0));
        check("- Two minutes. Draw a box.", Some(2.0));
        check("- One minute. Leave it on the wall.", Some(1.0));
        check("- A break. Three minutes, or fifteen.", Some(3.0));
        check("- 2.5 minutes, together with 11b another 3.", Some(2.5));
        check("- Say \u{201c}down\u{201d} with your hands.", None);
    }
}
