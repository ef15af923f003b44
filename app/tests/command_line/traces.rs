//! Walks and hits of rays, as `raystep trace` writes them.

use super::{RAYS, SQUARE, folder, raystep, refused, text};

#[test]
fn every_structure_answers_a_table_of_rays() {
    let folder = folder("trace");
    std::fs::write(folder.join("square.obj"), SQUARE).unwrap();
    std::fs::write(folder.join("rays.csv"), RAYS).unwrap();
    for kind in ["list", "grid", "kd", "bvh"] {
        let arguments =
            ["trace", "--mesh", "square.obj", "--structure", kind, "--rays", "rays.csv", "--out", "hits.csv"];
        let output = raystep(&folder, &arguments);
        assert!(output.status.success(), "{}", text(&output.stderr));
        let hits = std::fs::read_to_string(folder.join("hits.csv")).unwrap();
        let rows: Vec<&str> = hits.lines().collect();
        assert_eq!(rows[0], "ray,hit,t,prim,prim_tests,node_visits,cell_steps,box_tests");
        let begins = [
            "0,true,5,",
            "1,true,5,",
            "2,false,,,",
            "3,unusable: the direction is zero",
            "4,\"unusable: oy is \"\"zero\"\", not a number\"",
            "5,false,,,",
        ];
        assert_eq!(rows.len(), begins.len() + 1, "{hits}");
        for (row, begin) in rows[1..].iter().zip(begins) {
            assert!(row.starts_with(begin), "{kind}: {row}");
        }
    }
}

#[test]
fn one_walk_is_written_as_json() {
    let folder = folder("json");
    let walk = |arguments: &[&str]| {
        let output = raystep(&folder, &[&["trace", "--format", "json", "--structure", "kd"], arguments].concat());
        assert!(output.status.success(), "{}", text(&output.stderr));
        serde_json::from_slice::<serde_json::Value>(&output.stdout).unwrap()
    };
    let walked = walk(&["--scene", "flat-twelve", "--ray", "0.1,1.2,0,7.9,2.8,0"]);
    assert_eq!(walked["format"], "raystep-walk");
    assert!(walked["structure"]["parameters"]["max_depth"].is_string() && walked["origin"].is_null(), "{walked}");
    assert_eq!(walked["ray"]["o"], serde_json::json!([0.1, 1.2, 0.0]));
    assert!(walked["hit"]["t"].as_f64().unwrap() < 1.0, "{walked}");
    // As in the README.
    let walked = walk(&["--scene", "teapot-6321", "--rule", "split=sah", "--pixel", "800,500"]);
    assert!(walked["hit"]["t"].is_number(), "{}", walked["hit"]);
    // Coordinates of a file that are moved: the ray stands there as it was given.
    std::fs::write(folder.join("survey.obj"), SURVEY).unwrap();
    let walked = walk(&["--mesh", "survey.obj", "--ray", "465812.4,5247903.5,412.6,0,0,-1"]);
    assert_eq!(walked["origin"], serde_json::json!([465812.5, 5247903.5, 412.5]));
    let o = [465_812.4, 5_247_903.5, 412.6];
    assert!(
        o.iter().zip(walked["ray"]["o"].as_array().unwrap()).all(|(o, read)| (o - read.as_f64().unwrap()).abs() < 1e-6)
    );
    assert!((walked["hit"]["t"].as_f64().unwrap() - 0.1).abs() < 1e-6, "{}", walked["hit"]);
}

/// A square of half a metre in the coordinates of a survey.
const SURVEY: &str = "v 465812.13 5247903.21 412.5\nv 465812.63 5247903.21 412.5\nv 465812.63 5247903.71 412.5\n\
                      v 465812.13 5247903.71 412.5\nf 1 2 3\nf 1 3 4\n";

#[test]
fn odd_files_are_read_and_what_was_left_out_is_said() {
    let folder = folder("odd");
    let down = "ox,oy,oz,dx,dy,dz\n1,1,10,0,0,-1\n2.5,0.5,10,0,0,-1\n0.5,3.9,10,0,0,-1\n";
    let triangle = "v 0 0 1\nv 4 0 1\nv 0 4 1\n";
    let hits = "true,9 true,9 false,";
    let twisted = "v 0 0 0\nv 2 0 0\nv 0 0 2\nv 2 0 2\nf 1 2 3 4\n";
    let upright = "ox,oy,oz,dx,dy,dz\n1,-5,0.2,0,1,0\n1,-5,1.8,0,1,0\n0.3,-5,1.85,0,1,0\n";
    let survey = "ox,oy,oz,dx,dy,dz\n465812.4,5247903.74,500,0,0,-1\n465812.4,5247903.70,412.75,0,0,-1\n";
    let quote = "ox,oy,oz,dx,dy,dz\n1,1,10,0,0,-1\n1,1,10,0,0,\"-1\n1,1,10,0,0,\"-1\"\n";
    let around = format!("{triangle}f{}\n", " 1 2 3".repeat(2000));
    let open = "unusable: a quotation mark is opened and not closed,";
    for (name, mesh, rays, met, says) in [
        (
            "missing texture",
            &*format!("{triangle}f 1/1 2/2 3/3"),
            down,
            hits,
            "1 face names texture coordinates that are not there",
        ),
        (
            "normal 0",
            &format!("{triangle}vn 0 0 1\nf 1//1 2//0 3//1"),
            down,
            hits,
            "1 face names normals that are not there",
        ),
        (
            "weights",
            &format!("{triangle}vw 0 0 1\nf 1 2 3"),
            down,
            hits,
            "1 line passed over: `vw` is no keyword of OBJ",
        ),
        (
            "no face uses it",
            &format!("{triangle}v 0 0 -1.#IND00\nf 1 2 3"),
            down,
            hits,
            "1 vertex that no face uses left out",
        ),
        ("around and around", &around, down, hits, "1 polygon cut into triangles"),
        ("twisted wall", twisted, upright, "true,5 true,5 true,5", "1 polygon with edges that cross"),
        ("survey", SURVEY, survey, "false, true,0.25", "coordinates were moved by (-465812.5, -5247903.5, -412.5)"),
        ("open quotation mark", SQUARE, quote, &format!("true,10 {open} true,10"), "1 of 3 rows are no rays"),
    ] {
        std::fs::write(folder.join("odd.obj"), mesh).unwrap();
        std::fs::write(folder.join("odd.csv"), rays).unwrap();
        for kind in ["list", "grid", "kd", "bvh"] {
            let call = ["trace", "--mesh", "odd.obj", "--rays", "odd.csv", "--format", "csv", "--structure", kind];
            let output = raystep(&folder, &call);
            let (table, said) = (text(&output.stdout), text(&output.stderr));
            assert!(output.status.success() && said.contains(says), "{name}: {said}");
            let rows =
                table.lines().skip(1).map(|row| row.splitn(4, ',').skip(1).take(2).collect::<Vec<_>>().join(","));
            assert_eq!(rows.collect::<Vec<_>>().join(" "), met, "{name} {kind}: {said}");
        }
    }
    std::fs::write(folder.join("odd.obj"), format!("{triangle}v 4 4 -1.#IND00\nf 1 2 3\nf 2 4 3\n")).unwrap();
    let trace = ["trace", "--mesh", "odd.obj", "--structure", "kd"];
    refused(&folder, &[&trace[..], &["--rays", "odd.csv"]].concat(), "odd.obj:4:7: `-1.#IND00` is not a number");
}
