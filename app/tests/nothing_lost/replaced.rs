//! What stood there before: it stays, or is replaced by something whole.

use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};
use std::path::Path;
use std::process::{Child, Command, Stdio};

use super::inputs::{RAYS, SQUARE, trace, with_inputs};
use super::{names, raystep, said};

#[test]
fn what_must_not_be_replaced_is_refused() {
    /// Makes something, tries to write there, and expects the sentence and nothing changed.
    fn check(name: &str, out: &str, says: &str, make: impl FnOnce(&Path)) {
        let folder = with_inputs(name);
        make(&folder);
        let look = |at: &Path| {
            let known = std::fs::symlink_metadata(at).ok()?;
            let bytes = known.is_file().then(|| std::fs::read(at).unwrap());
            Some((known.file_type(), known.permissions().mode(), bytes, std::fs::read_link(at).ok()))
        };
        let at = folder.join(out);
        let (before, beside) = (look(&at), names(&folder));
        let inputs = [SQUARE, RAYS].map(str::to_owned);
        let output = raystep(&folder, &trace(out)).output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{name}: {}", said(&output));
        assert!(said(&output).contains(says), "{name}: {}", said(&output));
        assert_eq!((look(&at), names(&folder)), (before, beside), "{name}");
        assert_eq!(["square.obj", "rays.csv"].map(|name| std::fs::read_to_string(folder.join(name)).unwrap()), inputs);
    }
    let nothing = |_: &Path| {};
    check("link", "out.csv", "it is a link to real.csv", |folder| {
        std::fs::write(folder.join("real.csv"), "mine").unwrap();
        symlink("real.csv", folder.join("out.csv")).unwrap();
    });
    check("dangling", "out.csv", "it is a link to nowhere", |folder| {
        symlink("nowhere", folder.join("out.csv")).unwrap();
    });
    check("pipe", "out.csv", "it is no plain file", |folder| {
        assert!(Command::new("mkfifo").arg(folder.join("out.csv")).status().unwrap().success());
    });
    check("protected", "out.csv", "it is write-protected", |folder| {
        std::fs::write(folder.join("out.csv"), "mine").unwrap();
        std::fs::set_permissions(folder.join("out.csv"), PermissionsExt::from_mode(0o444)).unwrap();
    });
    check("folder", "out.csv", "it is a folder", |folder| std::fs::create_dir(folder.join("out.csv")).unwrap());
    check("null", "/dev/null", "it is no plain file", nothing);
    check("full", "/dev/full", "it is no plain file", nothing);
    check("nowhere", "there/out.csv", "there is no folder there", nothing);
    check("mesh", "square.obj", "this file is read", nothing);
    check("rays", "./rays.csv", "this file is read", nothing);
    check("hard-link", "out.csv", "this file is read", |folder| {
        std::fs::hard_link(folder.join("rays.csv"), folder.join("out.csv")).unwrap();
    });
    assert!(std::fs::metadata("/dev/null").unwrap().file_type().is_char_device());
}

#[test]
fn a_file_keeps_its_mode_and_its_neighbours() {
    for mode in [0o600, 0o640, 0o666, 0o755] {
        let folder = with_inputs("mode");
        std::fs::write(folder.join("out.csv.part"), "mine").unwrap();
        std::fs::write(folder.join("out.csv"), "old").unwrap();
        std::fs::set_permissions(folder.join("out.csv"), PermissionsExt::from_mode(mode)).unwrap();
        let output = raystep(&folder, &trace("out.csv")).output().unwrap();
        assert!(output.status.success(), "{}", said(&output));
        assert!(std::fs::read_to_string(folder.join("out.csv")).unwrap().starts_with("ray,hit"));
        assert_eq!(std::fs::metadata(folder.join("out.csv")).unwrap().permissions().mode() & 0o7777, mode);
        assert_eq!(std::fs::read_to_string(folder.join("out.csv.part")).unwrap(), "mine");
        assert_eq!(names(&folder), ["out.csv", "out.csv.part", "rays.csv", "square.obj"]);
        // A new file is as open as any other program would make it.
        std::fs::remove_file(folder.join("out.csv")).unwrap();
        assert!(raystep(&folder, &trace("out.csv")).status().unwrap().success());
        let mode = |name: &str| std::fs::metadata(folder.join(name)).unwrap().permissions().mode();
        assert_eq!(mode("out.csv"), mode("out.csv.part"));
    }
}

#[test]
fn two_programs_write_one_file_one_after_the_other() {
    let folder = with_inputs("two");
    let rays = |n: usize| "ox,oy,oz,dx,dy,dz\n".to_owned() + &"1.5,0.5,5,0,0,-1\n".repeat(n);
    let sizes = [3000, 5000, 7000, 9000];
    for n in sizes {
        std::fs::write(folder.join(format!("{n}.csv")), rays(n)).unwrap();
    }
    for _ in 0..3 {
        let begin = |n: usize| {
            let rays = format!("{n}.csv");
            let call = ["trace", "--mesh", "square.obj", "--structure", "bvh", "--rays", &rays, "--out", "out.csv"];
            raystep(&folder, &call).stderr(Stdio::piped()).spawn().unwrap()
        };
        let programs: Vec<Child> = sizes.into_iter().map(begin).collect();
        for program in programs {
            let output = program.wait_with_output().unwrap();
            assert!(output.status.success(), "{}", said(&output));
        }
        let lines = std::fs::read_to_string(folder.join("out.csv")).unwrap().lines().count();
        assert!(sizes.contains(&(lines - 1)), "{lines} lines are of no program");
        assert!(!names(&folder).iter().any(|name| name.ends_with(".part")), "{:?}", names(&folder));
    }
}
