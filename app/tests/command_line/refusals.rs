//! What cannot be done, and the sentence that says so.

use super::{RAYS, SQUARE, folder, refused};

#[test]
fn what_has_no_end_is_refused() {
    let folder = folder("endless");
    std::fs::write(folder.join("square.obj"), SQUARE).unwrap();
    refused(&folder, &["measure", "--size", "16384x16384"], "16384x16384 are too many pixels");
    if cfg!(unix) {
        let trace = |mesh, rays| ["trace", "--structure", "kd", "--mesh", mesh, "--rays", rays];
        refused(&folder, &trace("/dev/zero", "rays.csv"), "/dev/zero: it is a device; a file is needed");
        refused(&folder, &trace("square.obj", "/dev/zero"), "/dev/zero: it is a device; a file is needed");
    }
}

#[test]
fn what_cannot_be_done_is_said_in_a_sentence() {
    let folder = folder("refused");
    std::fs::write(folder.join("square.obj"), SQUARE).unwrap();
    std::fs::write(folder.join("rays.csv"), RAYS).unwrap();
    std::fs::write(folder.join("header.csv"), "x,y,z\n1,2,3\n").unwrap();
    std::fs::write(folder.join("empty.obj"), "").unwrap();
    let trace = |mesh, structure, rays| ["trace", "--mesh", mesh, "--structure", structure, "--rays", rays];
    refused(&folder, &trace("none.obj", "kd", "rays.csv"), "none.obj");
    refused(&folder, &trace("empty.obj", "kd", "rays.csv"), "empty.obj");
    refused(&folder, &trace("square.obj", "kt", "rays.csv"), "did you mean \"kd\"?");
    refused(&folder, &trace("square.obj", "kd", "header.csv"), "header.csv:1:1");
    refused(&folder, &[&trace("square.obj", "kd", "rays.csv")[..], &["--rule", "max_dept=3"]].concat(), "max_depth");
    refused(&folder, &[&trace("square.obj", "kd", "rays.csv")[..], &["--format", "xls"]].concat(), "text, md, latex");
    let flat = ["trace", "--scene", "flat-twelve", "--structure", "kd"];
    refused(&folder, &[&flat[..], &["--pixel", "800,500"]].concat(), "--ray 0,1,0,1,0.5,0");
    refused(&folder, &[&flat[..], &["--ray", "0,1,0,1,0.5"]].concat(), "--ray 0,1,0,1,0.5: 6 numbers are needed");
    refused(&folder, &[&flat[..], &["--ray", "0,1,0,0,0,0"]].concat(), "the direction is zero");
    refused(&folder, &["export", "--slide", "99/1", "--out", "pictures"], "there is no slide");
    refused(&folder, &["export", "--slide", "5/33", "--ray", "nobody", "--out", "pictures"], "no ray");
    refused(&folder, &["export", "--slide", "5/33", "--size", "9", "--out", "pictures"], "1600x1000");
    refused(&folder, &["nonsense.obj"], "no such file");
    let trace = ["trace", "--scene", "flat-twelve", "--pixel", "800,500", "--structure"];
    refused(&folder, &[&trace[..], &["slab"]].concat(), "only tests the box");
    refused(&folder, &["measure", "--also", "slab"], "only tests the box");
}
