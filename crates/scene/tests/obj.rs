//! What the OBJ reader says to right, odd and hostile files.

use std::fmt::Write;

use glam::{DVec3, Vec3};
use raystep_accel::{Accel, List, Ray};
use raystep_scene::{Loaded, ObjError, Scene, read_obj};

/// A square in the plane z = 0 to add faces to.
const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

fn check(bytes: &[u8]) -> String {
    match read_obj(bytes, "a.obj", &mut |_| true) {
        Err(wrong) => wrong.to_string(),
        Ok(Loaded { mesh, notes, .. }) => {
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
        ("picture", b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR".to_vec()),
        ("another format", b"ply\nformat ascii 1.0\n".to_vec()),
        ("misspelt keyword", with("usmtl red\nf 1 2 3")),
        ("truncated face", with("f 1 2")),
        ("truncated vertex", b"v 0 0\nf 1 1 1".to_vec()),
        ("not a number", b"v 0 zero 0\nf 1 1 1".to_vec()),
        ("NaN", b"v 0 0 0\nv 0 nan 0\nf 1 2 1".to_vec()),
        ("infinite", b"v 0 0 0\nv 0 1e39 0\nf 1 2 1".to_vec()),
        ("too far", b"v 0 -1e20 0\nf 1 1 1".to_vec()),
        ("index 0", with("f 0 1 2")),
        ("index above", with("f 1 2 5")),
        ("index before the first", with("f -5 -1 -2")),
        ("huge index", with("f 1 2 99999999999999999999999999")),
        ("huge index back", with("f 1 2 -99999999999999999999999999")),
        ("huge normal", with("vn 0 0 1\nf 1//1 2//1 3//4294967297")),
        ("normal of none", with("f 1//1 2//1 3//1")),
        ("texture coordinates of none", with("f 1/1/1 2/2/2 3/3/3\nf 1/1 2/2 3/3\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1")),
        ("normal 0", with("vt 0 0\nvn 0 0 1\nf 1/1/1 2/1/0 3/1/1")),
        ("normal before the first", with("vn 0 0 1\nf 1//-2 2//-1 3//-1")),
        ("wrong number of a normal", with("vn 0 zero 1\nvt nan\nf 1/1/1 2/1/1 3/1/1")),
        ("four parts", with("f 1/1/1/1 2 3")),
        ("words for texture and normal", with("f 1/a/b 2/a/b 3/a/b")),
        ("word for an index", with("f one 2 3")),
        ("empty corner", with("f / 2 3")),
        ("missing vertex", with("f /1/1 2 3")),
        ("materials in the file", with("newmtl red\nKd 0.5 0 0\nKd 1 0 0\nmap_Kd a.png\nf 1 2 3")),
        ("weights", with("vw 0 0 1\nvw 1 0 1\nf 1 2 3")),
        ("keywords of old", with("res 3 4\ncdc 1 2\ncdp 1 2\nbzp 1 2 3\nf 1 2 3")),
        ("capital letters", b"V 0 0 0\nV 1 0 0\nV 0 1 0\nF 1 2 3".to_vec()),
        ("many words", with(&((0..99).map(|i| format!("w{i} 1\n")).collect::<String>() + "f 1 2 3"))),
        ("hash in a number", b"v 0 0 1\nv 4 0 1\nv 0 4 -1.#IND00\nf 1 2 3".to_vec()),
        ("hash in a number of no face", with("v 0 0 -1.#IND00\nf 1 2 3")),
        ("hash in an index", with("f 1 2 3# a face")),
        ("hash in a name", with("o a#b\nf 1 2 3 #a face")),
        ("vertices of no face", with("v 0 nan 0\nv 1 2\nv\nv 1e20 0 0\nf 1 2 3\nf -8 -7 -6")),
        ("vertex of a face with two corners", with("v 0 nan 0\nf 1 5\nf 1 2 3")),
        ("second wrong vertex used", b"v nan 0 0\nv 0 0 0\nv 1 0 0\nv 0 inf 0\nf 2 3 4".to_vec()),
        ("faces of two corners", with("f 1 2\nf 1 99\nf\nf 1 2 3")),
        ("Ctrl-Z at the end", with("f 1 2 3\n\u{1A}")),
        ("Ctrl-Z behind a number", with("f 1 2 3\u{1A}\u{1A}\n")),
        ("zeros at the end", with("f 1 2 3\n\0\0\0\0")),
        ("Ctrl-Z in the middle", with("f 1 2 3\n\u{1A}\nf 2 3 4")),
        ("Ctrl-Z in a number", with("f 1 2\u{1A} 3\nf 2 3 4")),
        ("control characters in a comment", with("# \u{1} \u{7F}\nf 1 2 3")),
        ("wrong word in a continued line", with("f 1 \\\n 2 \\\n  3x")),
        ("long word", with(&format!("{}\nf 1 2 {}", "w".repeat(20_000), "3".repeat(20_000)))),
        ("long number", format!("{SQUARE}v 0 {} 0\nf 1 2 5", "x".repeat(20_000)).into_bytes()),
        ("bow tie", with("f 1 2 4 3")),
        ("twice around", with("f 1 2 3 4 1 2 3 4")),
    ];
    let said: Vec<String> = table.iter().map(|(name, bytes)| format!("{name}: {}", check(bytes))).collect();
    insta::assert_snapshot!(said.join("\n"));
}

/// What rays downwards, or along y, meet in a file: the primitive and t, or nothing.
fn met(file: &str, rays: &[[f64; 3]], d: Vec3) -> String {
    let scene = Scene::from_obj(file.as_bytes(), "a.obj", &mut |_| true).unwrap();
    let hit = |o: &[f64; 3]| {
        let ray = Ray::new(scene.moved(DVec3::from_array(*o)), d).unwrap();
        List.intersect(&scene.prims, &ray, &mut ()).map_or("-".to_owned(), |hit| format!("{}:{}", hit.prim, hit.t))
    };
    format!("{} | {}", rays.iter().map(hit).collect::<Vec<_>>().join(" "), scene.note.replace('\n', " | "))
}

#[test]
fn rays_meet_what_the_file_says() {
    // A twisted quad in an upright wall, one in the plane, and one that bends into space; a triangle beside them.
    let wall = "v 0 0 0\nv 2 0 0\nv 0 0 2\nv 2 0 2\nv 5 0 0\nv 6 0 0\nv 6 0 1\nf 1 2 3 4\nf 5 6 7";
    let at_wall = [[1.0, -5.0, 0.2], [1.0, -5.0, 1.8], [0.3, -5.0, 1.85], [0.3, -5.0, 1.0], [5.9, -5.0, 0.5]];
    let flat = "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 2 2 0\nv 5 0 0\nv 6 0 0\nv 6 1 0\nf 1 2 3 4\nf 5 6 7";
    let at_flat = [[1.0, 0.2, 5.0], [1.0, 1.8, 5.0], [0.3, 1.85, 5.0], [0.3, 1.0, 5.0], [5.9, 0.5, 5.0]];
    let bent = "v 0 0 0\nv 2 0 1\nv 0 2 1\nv 2 2 2\nf 1 2 3 4";
    // Survey coordinates: a square of half a metre. Ten centimetres above its middle; three beside it.
    let survey = "v 465812.13 5247903.21 412.5\nv 465812.63 5247903.21 412.5\nv 465812.63 5247903.71 412.5\n\
                  v 465812.13 5247903.71 412.5\nf 1 2 3\nf 1 3 4";
    let at_survey = [[465812.4, 5247903.4, 412.6], [465812.4, 5247903.74, 500.0], [465812.10, 5247903.5, 500.0]];
    // Fractions of a metre between corners that single precision holds.
    let posts = "v 5000000 7 0\nv 5000001 7 0\nv 5000000 8 0\nf 1 2 3";
    let small = "v 1000.00001 0 0\nv 1000.00002 0 0\nv 1000.00001 0.00001 0\nf 1 2 3";
    // Nothing to save: as large as far, round enough, or far out on the whole.
    let around = "v -500000 -500000 0\nv 500000.1 -500000 0\nv 0 500000 0\nf 1 2 3";
    let near = "v 100 100 0\nv 101 100 0\nv 100 101 0\nf 1 2 3";
    let said = [
        met(wall, &at_wall, Vec3::Y),
        met(flat, &at_flat, Vec3::NEG_Z),
        met(bent, &at_flat[..4], Vec3::NEG_Z),
        met(survey, &at_survey, Vec3::NEG_Z),
        met(posts, &[[5000000.25, 7.7, 1.0], [5000000.35, 7.7, 1.0]], Vec3::NEG_Z),
        met(small, &[[1000.000012, 0.000002, 1.0], [1000.000018, 0.000009, 1.0]], Vec3::NEG_Z),
        met(around, &[[1.0, 1.0, 1.0]], Vec3::NEG_Z),
        met(near, &[[100.25, 100.25, 1.0]], Vec3::NEG_Z),
    ];
    insta::assert_snapshot!(said.join("\n"));
}

/// However the lines of a file of one megabyte are made, it is read in a second or two; a busy machine gets more.
#[test]
fn long_lines_and_words_are_read_in_time() {
    let mega = 1 << 20;
    for text in [
        format!("f 1 2 3{}", " \\\n 1".repeat(mega / 5)),
        format!("f 1 2 3{}", "\\\n".repeat(mega / 2)),
        format!("{}\nf 1 2 3", "w".repeat(mega)),
        format!("v 0 0 {}\nf 1 2 3", "9".repeat(mega)),
        format!("f 1 2 3/{}", "/".repeat(mega)),
        format!("f 1 2 3 {}", "#".repeat(mega)),
        format!("f 1 2 3{}", "#x ".repeat(mega / 3)),
        format!("{}f 1 2 3", "w 1\n".repeat(mega / 4)),
        (0..mega / 8).map(|i| format!("w{i:06}\n")).collect::<String>() + "f 1 2 3",
    ] {
        let begun = std::time::Instant::now();
        let said = check(format!("{SQUARE}{text}").as_bytes());
        assert!(begun.elapsed().as_secs() < 60, "{:?} for {}", begun.elapsed(), &text[..12]);
        assert!(said.len() < 2000, "{} bytes are said", said.len());
    }
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
