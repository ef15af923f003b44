//! How many instructions a walk takes, counted by valgrind.

use std::process::Command;

use crate::Stage;

/// The argument with which this program starts itself under valgrind.
pub(crate) const WALK: &str = "--walk";

/// Walks once, as the process under valgrind.
pub(crate) fn walk(stage: &Stage, structure: &str, copy: &str) {
    for (name, stripped, silent) in stage.pairs() {
        if name == structure {
            println!("{}", if copy == "stripped" { stripped() } else { silent() });
        }
    }
}

/// Counts and prints all of them.
pub(crate) fn table() {
    println!("instructions for all rays, walk stripped by hand and walk observed by ()");
    for structure in ["grid", "kd", "bvh"] {
        match (count(structure, "stripped"), count(structure, "silent")) {
            (Some(stripped), Some(silent)) => {
                let ratio = silent as f64 / stripped as f64;
                println!("{structure:>5}   stripped {stripped:>12}   () {silent:>12}   ratio {ratio:.4}");
            }
            _ => {
                println!("valgrind is not here, or did not say: no instructions counted");
                return;
            }
        }
    }
}

/// Instructions within the functions named `counted_…`, or nothing if valgrind does not tell.
fn count(structure: &str, copy: &str) -> Option<u64> {
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null", "--collect-atstart=no"])
        .arg(format!("--toggle-collect=*counted_{copy}*"))
        .arg(std::env::current_exe().ok()?)
        .args([WALK, structure, copy])
        .output()
        .ok()?;
    // ==1234== Collected : 56789
    let told = String::from_utf8_lossy(&output.stderr);
    told.lines().find_map(|line| line.split_once("Collected : ")?.1.trim().parse().ok())
}
