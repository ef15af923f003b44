//! What can be seen to be wrong in lessons when they are read.

use raystep_lesson::{Library, Script, glance};
use raystep_print::{proof, proof_code, proof_plain};

/// What of a text cannot be shown, as those say who set it.
pub(crate) fn set(text: &str, script: Script) -> Vec<(usize, String)> {
    match script {
        Script::Plain => proof_plain(text),
        Script::Markdown => proof(text),
        Script::Code => proof_code(text),
    }
}

/// Somebody's own lessons, with what can be seen to be wrong in their slides among their problems.
pub(crate) fn proofread(mut own: Library) -> Library {
    own.problems.extend(glance(&own, &set));
    own
}
