//! What the OBJ reader says to right, odd and hostile files.

use std::fmt::Write;

use raystep_scene::{Loaded, ObjError, read_obj};

/// A square in the plane z = 0 to add faces to.
const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

fn check(bytes: &[u8]) -> String {
    match read_obj(bytes, "a.obj", &mut |_| true) {
        Err(wrong) => wrong.to_string(),
        Ok(Loaded { mesh, notes }) => {
            let mut said = format!("{:?}", mesh.triangles);
            for note in notes {
                let _ = write!(said, "\n    {note}");
            }
            said
        }
    }
}

fn utf16(text: &str, bytes: impl Fn(u16) -> [u8; 2]) -> Vec<u8> {
    [0xFEFF].into_iter().chain(text.encode_utf16()).flat_map(bytes).collect()
}

#[test]
fn files_right_odd_and_hostile() {
    let with = |faces: &str| format!("{SQUARE}{faces}").into_bytes();
    let table: Vec<(&str, Vec<u8>)> = vec![
        ("triangle", with("f 1 2 3")),
        ("counted back", with("f -4 -3 -2")),
        ("texture and normal", with("vt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\nf 1//1 2//1 3//1\nf 1/1 2/1 3/1")),
        ("square", with("f 1 2 3 4")),
        ("vertices after the face", b"f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0".to_vec()),
        ("arrow fanned wrongly from corner 1", b"v 0 0 0\nv 4 2 0\nv 0 4 0\nv 1 2 0\nf 2 3 4 1".to_vec()),
        ("order kept", with("f 1 2 3\nf 1 2 3 4\nf 2 3 4")),
        ("degenerate triangle", with("f 1 1 2\nf 1 2 3")),
        ("degenerate polygon", with("f 1 2 1 2\nf 1 2 3")),
        ("nothing but degenerate", with("f 1 2 1 2")),
        ("groups and materials", with("mtllib ../../etc/passwd\no a\ng b c\ns off\nusemtl Kd\nf 1 2 3\nl 1 2")),
        ("colours", b"v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 0 1 0\nf 1 2 3".to_vec()),
        ("byte order mark", [b"\xEF\xBB\xBF".to_vec(), with("f 1 2 3")].concat()),
        ("UTF-16 little end", utf16(&format!("{SQUARE}f 1 2 3"), u16::to_le_bytes)),
        ("UTF-16 big end", utf16(&format!("{SQUARE}f 1 2 3"), u16::to_be_bytes)),
        ("Latin-1 comment", [b"# caf\xE9\n".to_vec(), with("f 1 2 3")].concat()),
        ("carriage returns", format!("{SQUARE}f 1 2 3\n").replace('\n', "\r").into_bytes()),
        ("both line ends", format!("{SQUARE}f 1 2 3\n").replace('\n', "\r\n").into_bytes()),
        ("continued line", with("f 1 \\\n2 \\\n3")),
        ("continued at the end", with("f 1 2 3 \\")),
        ("tabs and comments", with("\tf\t1 2 3 # a face")),
        ("empty", vec![]),
        ("only comments", b"# nothing here\n\n".to_vec()),
        ("only vertices", SQUARE.into()),
        ("binary", b"solid\x00\x01\x02\xFF".to_vec()),
        ("picture", b"\x89PNG\r\n\x1a\n".to_vec()),
        ("another format", b"ply\nformat ascii 1.0\n".to_vec()),
        ("misspelt keyword", with("usmtl red\nf 1 2 3")),
        ("truncated face", with("f 1 2")),
        ("truncated vertex", b"v 0 0\nf 1 1 1".to_vec()),
        ("not a number", b"v 0 zero 0\nf 1 1 1".to_vec()),
        ("NaN", b"v 0 0 0\nv 0 nan 0\nf 1 1 1".to_vec()),
        ("infinite", b"v 0 0 0\nv 0 1e39 0\nf 1 1 1".to_vec()),
        ("too far", b"v 0 -1e20 0\nf 1 1 1".to_vec()),
        ("index 0", with("f 0 1 2")),
        ("index above", with("f 1 2 5")),
        ("index before the first", with("f -5 -1 -2")),
        ("huge index", with("f 1 2 99999999999999999999999999")),
        ("huge index back", with("f 1 2 -99999999999999999999999999")),
        ("huge normal", with("vn 0 0 1\nf 1//1 2//1 3//4294967297")),
        ("normal of none", with("f 1//1 2//1 3//1")),
        ("four parts", with("f 1/1/1/1 2 3")),
        ("word for an index", with("f one 2 3")),
        ("empty corner", with("f / 2 3")),
        ("material keyword", with("f 1 2 3\nKd 0.5")),
    ];
    let said: Vec<String> = table.iter().map(|(name, bytes)| format!("{name}: {}", check(bytes))).collect();
    insta::assert_snapshot!(said.join("\n"));
}

/// No prefix and no single changed byte of a good file makes the reader panic.
#[test]
fn damaged_files_are_survived() {
    let good =
        format!("mtllib a.mtl\n{SQUARE}vn 0 0 1\nf 1//1 2//1 3//1\nf -1//-1 -2//-1 -3//-1 -4//-1\n").into_bytes();
    for end in 0..good.len() {
        check(&good[..end]);
    }
    for at in 0..good.len() {
        for byte in [0, b'\n', b'/', b'-', b'9', b'\\', b'\r', 0xFF] {
            let mut damaged = good.clone();
            damaged[at] = byte;
            check(&damaged);
        }
    }
}

#[test]
fn reading_can_be_stopped_at_every_report() {
    let text = format!("{SQUARE}{}", "f 1 2 3\nf 1 2 3 4\n".repeat(20_000));
    let mut reports = 0;
    assert!(
        read_obj(text.as_bytes(), "a.obj", &mut |_| {
            reports += 1;
            true
        })
        .is_ok()
    );
    assert!(reports > 3, "{reports}");
    for stop_at in 0..reports {
        let mut left = stop_at;
        let mut last = 0.0_f32;
        let stopped = read_obj(text.as_bytes(), "a.obj", &mut |part| {
            assert!(last <= part && part <= 1.0, "{last} then {part}");
            last = part;
            left -= 1;
            left >= 0
        });
        assert!(matches!(stopped, Err(ObjError::Cancelled)));
    }
}
