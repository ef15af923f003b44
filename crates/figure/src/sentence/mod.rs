//! What events say, in plain words.

mod grow;
mod visit;

pub(crate) use grow::of_grow;
pub(crate) use visit::of_visit;

/// `1 node`, `2 nodes`.
fn count(n: u32, what: &str) -> String {
    if n == 1 { format!("1 {what}") } else { format!("{n} {what}s") }
}
