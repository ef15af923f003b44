//! Nobody hears what is said.

use std::process::Command;

use super::inputs::with_inputs;

#[test]
fn nobody_listening_is_no_reason_to_break_off() {
    let folder = with_inputs("deaf");
    let section = folder.join("05-kd-tree");
    std::fs::create_dir_all(&section).unwrap();
    std::fs::write(section.join("33-wrong.md"), "+++\nformat = 1\nslide = [33]\ntitel = \"Wrong\"\n+++\n").unwrap();
    let calls: [(&[&str], i32); 5] = [
        (&["check", "05-kd-tree/33-wrong.md"], 2),
        (&["trace", "--mesh", "none.obj", "--structure", "kd", "--rays", "rays.csv"], 2),
        (&["square.obj"], 2),
        (&["export", "--slide", "5/33", "--stage", "flat", "--steps", "1", "--size", "64x40", "--out", "pictures"], 0),
        (&["nonsense.obj"], 2),
    ];
    for (call, code) in calls {
        // Closed, full, and with nobody at the other end.
        let shell = |to: &str| {
            let line = format!("exec \"$0\" \"$@\" {to}");
            let mut command = Command::new("bash");
            command.arg("-c").arg(line).arg(env!("CARGO_BIN_EXE_raystep")).args(call).current_dir(&folder);
            command.env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY").status().unwrap().code()
        };
        for to in ["2>&-", ">&- 2>&-", "2>/dev/full", "2> >(exec true; sleep 0)"] {
            assert_eq!(shell(to), Some(code), "{call:?} {to}");
        }
    }
}
