//! Where no more can be written: a sentence, and nothing half.

use std::path::PathBuf;
use std::process::{Command, Stdio};

use super::inputs::{RAYS, trace, with_inputs};
use super::{names, raystep, said};

#[test]
fn a_full_disk_is_a_sentence() {
    // The standard output.
    let folder = with_inputs("full-output");
    for call in [&trace("-")[..7], &["doctor"]] {
        let full = std::fs::File::options().write(true).open("/dev/full").unwrap();
        let output = raystep(&folder, call).stdout(full).stderr(Stdio::piped()).output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{call:?}: {}", said(&output));
        assert!(said(&output).contains("standard output: the disk is full"), "{call:?}: {}", said(&output));
    }
    // A disk of its own, where one may be made.
    let disk = folder.join("disk");
    std::fs::create_dir(&disk).unwrap();
    let mount = Command::new("mount").args(["-t", "tmpfs", "-o", "size=16k", "none"]).arg(&disk).output();
    if !mount.is_ok_and(|mount| mount.status.success()) {
        println!("stepping aside: no small disk can be made here");
        return;
    }
    let _disk = Mounted(disk.clone());
    std::fs::write(disk.join("out.csv"), "old").unwrap();
    std::fs::write(folder.join("many.csv"), "ox,oy,oz,dx,dy,dz\n".to_owned() + &"1,1,5,0,0,-1\n".repeat(3000)).unwrap();
    let out = disk.join("out.csv").to_string_lossy().into_owned();
    let calls: [(&[&str], &str); 2] = [
        (&["trace", "--mesh", "square.obj", "--structure", "kd", "--rays", "many.csv", "--out", &out], "out.csv"),
        (&["export", "--slide", "5/33", "--stage", "flat", "--out", disk.to_str().unwrap()], ".png"),
    ];
    for (call, name) in calls {
        let output = raystep(&folder, call).output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{call:?}: {}", said(&output));
        assert!(said(&output).contains(name) && said(&output).contains("the disk is full"), "{}", said(&output));
        assert_eq!(names(&disk), ["out.csv"], "nothing half is left");
        assert_eq!(std::fs::read_to_string(disk.join("out.csv")).unwrap(), "old", "what was there stays");
    }
}

/// A disk that is taken away again.
struct Mounted(PathBuf);

impl Drop for Mounted {
    fn drop(&mut self) {
        let _ = Command::new("umount").arg(&self.0).status();
    }
}

#[test]
fn a_file_that_may_not_be_so_large_is_a_sentence() {
    let folder = with_inputs("limited");
    std::fs::write(folder.join("rays.csv"), RAYS.to_owned() + &"1.5,0.5,5,0,0,-1\n".repeat(20_000)).unwrap();
    std::fs::write(folder.join("out.csv"), "before").unwrap();
    let before = names(&folder);
    let call = "ulimit -f 40; exec \"$0\" \"$@\"";
    let output = Command::new("bash")
        .args(["-c", call, env!("CARGO_BIN_EXE_raystep")])
        .args(trace("out.csv"))
        .current_dir(&folder)
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    assert!(said(&output).contains("out.csv: no file may be that large here"), "{}", said(&output));
    assert_eq!(std::fs::read_to_string(folder.join("out.csv")).unwrap(), "before");
    assert_eq!(names(&folder), before);
}
