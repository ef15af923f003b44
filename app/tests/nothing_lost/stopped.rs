//! Programs that are stopped.

use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use super::{folder, names, raystep, said};

/// Asks a program to end as soon as something holds.
fn stopped_when(mut program: Child, signal: &str, holds: impl Fn() -> bool) -> (Option<i32>, String) {
    let begun = Instant::now();
    while !holds() && program.try_wait().unwrap().is_none() && begun.elapsed() < Duration::from_secs(300) {
        std::thread::sleep(Duration::from_millis(2));
    }
    assert!(Command::new("kill").args([signal, &program.id().to_string()]).status().unwrap().success());
    let output = program.wait_with_output().unwrap();
    (output.status.code(), said(&output))
}

#[test]
fn what_is_stopped_leaves_nothing_half() {
    for signal in ["-INT", "-TERM"] {
        let folder = folder("stopped");
        let pictures = folder.join("pictures");
        let call = ["export", "--slide", "5/33", "--stage", "flat", "--steps", "0..30", "--out", "pictures"];
        let program = raystep(&folder, &call).stderr(Stdio::piped()).spawn().unwrap();
        let some = || pictures.is_dir() && names(&pictures).iter().filter(|name| name.ends_with(".png")).count() > 1;
        let (code, says) = stopped_when(program, signal, some);
        assert_eq!(code, Some(130), "{says}");
        assert!(says.contains("stopped"), "{says}");
        for name in names(&pictures) {
            let bytes = std::fs::read(pictures.join(&name)).unwrap();
            assert!(name.ends_with(".png") && bytes.ends_with(b"IEND\xAE\x42\x60\x82"), "{name} is not whole");
        }

        // Of a page that was begun nothing is there.
        let program = raystep(&folder, &[]).stderr(Stdio::piped()).spawn().unwrap();
        let begun = || names(&folder).iter().any(|name| name.starts_with('.'));
        let (code, says) = stopped_when(program, signal, begun);
        assert_eq!(code, Some(130), "{says}");
        assert_eq!(names(&folder), ["pictures"], "{says}");
    }
}
