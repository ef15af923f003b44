//! Structures against brute force, as `raystep verify` compares them.

use std::process::Command;

use super::{folder, raystep, refused, text};

#[test]
fn structures_are_verified() {
    let folder = folder("verify");
    let output = raystep(&folder, &["verify", "--rays", "10000", "--seed", "5"]);
    let said = text(&output.stdout);
    assert!(output.status.success(), "{said}{}", text(&output.stderr));
    assert!(said.contains("10,000 rays over"), "{said}");
    // Kind, rules, answers, differences.
    for kind in ["grid", "kd", "octree", "bvh"] {
        let row = said.lines().find(|line| line.starts_with(kind)).unwrap_or_else(|| panic!("{said}"));
        assert!(row.ends_with(" 0"), "{row}");
    }
    assert!(std::fs::read_dir(&folder).unwrap().next().is_none(), "nothing differs, so nothing is kept");
    let output = raystep(&folder, &["verify", "--watertight", "--rays", "400", "--structure", "bvh"]);
    assert!(output.status.success() && text(&output.stdout).contains(": 0 lost."), "{}", text(&output.stdout));
    refused(&folder, &["verify", "--structure", "kt"], "did you mean \"kd\"?");
    refused(&folder, &["verify", "--structure", "list"], "brute force is the judge");
    refused(&folder, &["verify", "--structure", "slab"], "only tests the box");
    refused(&folder, &["verify", "--rays", "0"], "--rays");
    refused(&folder, &["verify", "--replay", "none.csv"], "none.csv");
}

/// What is stopped by Ctrl+C was not done: it says how far it came, and the exit code is not 0.
#[test]
#[cfg(unix)]
fn a_verification_that_is_stopped_ends_soon_and_fails() {
    use std::io::{BufRead, BufReader, Read};
    let folder = folder("stopped");
    for more in [&[][..], &["--in-turn"], &["--watertight"]] {
        // More rays than anybody waits for.
        let mut child = Command::new(env!("CARGO_BIN_EXE_raystep"))
            .args([&["verify", "--rays", "1000000000"], more].concat())
            .current_dir(&folder)
            .stdout(std::process::Stdio::piped())
            .stderr(std::process::Stdio::piped())
            .spawn()
            .unwrap();
        let mut first = String::new();
        let mut out = BufReader::new(child.stdout.take().unwrap());
        out.read_line(&mut first).unwrap();
        assert!(first.contains("1,000,000,000 rays"), "{first}");
        let killed = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
        assert!(killed.success());
        let mut rest = String::new();
        out.read_to_string(&mut rest).unwrap();
        let output = child.wait_with_output().unwrap();
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{more:?}: {said}");
        assert!(said.contains("raystep: stopped after"), "{more:?}: {said}");
        assert!(rest.contains("Stopped after"), "{more:?}: {rest}");
    }
}
