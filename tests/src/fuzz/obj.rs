//! The bytes of an OBJ file.

use raystep_scene::{ObjError, read_obj};

use super::Target;

pub(super) const TARGET: Target = Target {
    name: "obj",
    body: obj,
    words: &[
        "v ",
        "vt ",
        "vn ",
        "vp ",
        "vw ",
        "f ",
        "l ",
        "p ",
        "o ",
        "g ",
        "s ",
        "usemtl ",
        "mtllib ",
        "newmtl ",
        "Kd ",
        "curv ",
        "surf ",
        "end",
        "call ",
        "cstype ",
        "#",
        "\\\n",
        "\r\n",
        "\r",
        "\n",
        "/",
        "//",
        "1/1/1",
        "1//1",
        "-1",
        " ",
        "\t",
        "\u{feff}",
        "\u{1a}",
        "\0",
        "f 1 2 3\n",
        "f -1 -2 -3\n",
        "v 0 0 0\n",
        "v 1 0 0\n",
        "v 0 1 0\n",
        "v 1e18 0 0\n",
        "f 1 2 3 4 5\n",
    ],
    seeds: &[],
};

/// Reads an OBJ file: a mesh whose triangles stand on finite corners that are there, or a sentence with a place.
///
/// # Panics
/// If that does not hold.
pub fn obj(bytes: &[u8]) {
    match read_obj(bytes, "mesh.obj", &mut |_| true) {
        Ok(loaded) => {
            assert!(!loaded.mesh.triangles.is_empty(), "a mesh without triangles");
            assert!(loaded.mesh.corners.iter().all(|corner| corner.is_finite()), "a corner that is nowhere");
            let corners = loaded.mesh.corners.len() as u32;
            assert!(
                loaded.mesh.triangles.iter().flatten().all(|&corner| corner < corners),
                "a corner that is not there"
            );
            assert!(
                loaded.notes.iter().all(|note| !note.is_empty() && note.len() < 2000),
                "a note that is no sentence"
            );
        }
        Err(ObjError::Wrong(wrong)) => {
            assert!(wrong.line >= 1 && wrong.column >= 1 && !wrong.message.is_empty());
            let sentence = wrong.to_string();
            assert!(sentence.len() < 3000, "a sentence of {} letters", sentence.len());
        }
        Err(ObjError::Cancelled) => panic!("nobody cancelled"),
    }
}
