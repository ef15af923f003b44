//! The command line, as its users call it.

mod exports;
mod heat_maps;
mod lessons;
mod measures;
mod refusals;
mod traces;
mod verifications;

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A folder of this test's own, empty.
fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).unwrap();
    path
}

/// Calls Raystep in a folder, without a display.
fn raystep(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_raystep"))
        .args(arguments)
        .current_dir(folder)
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY")
        .output()
        .unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// A refused call: exit code 2 and a sentence that holds `says`.
fn refused(folder: &Path, arguments: &[&str], says: &str) {
    let output = raystep(folder, arguments);
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {said}");
    assert!(said.contains(says), "{arguments:?}: {said}");
}

const SQUARE: &str = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n";

const RAYS: &str = "ox,oy,oz,dx,dy,dz,t_min,t_max\n\
                    1.5,0.5,5,0,0,-1,0,inf\n\
                    0.5,1.5,5,0,0,-1,,\n\
                    9,9,5,0,0,-1,0,inf\n\
                    0,0,5,0,0,0,0,inf\n\
                    0,zero,5,0,0,-1,0,inf\n\
                    1.5,0.5,5,0,0,-1,0,2\n";
