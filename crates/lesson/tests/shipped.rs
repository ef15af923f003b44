//! The lessons that come with the program are right.

use raystep_lesson::{Library, check};

#[test]
fn nothing_is_wrong_in_the_shipped_lessons() {
    let problems = check(&Library::embedded());
    let text: Vec<String> = problems.iter().map(ToString::to_string).collect();
    assert!(problems.is_empty(), "{}", text.join("\n"));
}
