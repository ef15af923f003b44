//! Tables of costs, as `raystep measure` writes them.

use super::{SQUARE, folder, raystep, refused, text};

/// Lines without what differs from run to run or when a structure is added: figures become `#`, kinds of their own go.
fn shape_of(page: &str) -> String {
    let lines = page.lines().filter(|line| !line.is_empty());
    let plain = lines.take_while(|line| !line.starts_with("Structures that")).map(|line| {
        let words = line.split_whitespace().map(|word| {
            let is_figure = word.chars().all(|c| c.is_ascii_digit() || ".,-".contains(c));
            if is_figure && word != "-" { "#" } else { word }
        });
        words.collect::<Vec<_>>().join(" ")
    });
    plain.collect::<Vec<_>>().join("\n")
}

#[test]
fn the_lectures_tables_are_measured() {
    let folder = folder("measure");
    let output = raystep(&folder, &["measure", "--size", "24x18"]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    insta::assert_snapshot!(shape_of(&text(&output.stdout)));

    let output =
        raystep(&folder, &["measure", "--size", "16x16", "--shadows", "--format", "json", "--also", "kd split=median"]);
    let rows: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let row = |name: &str| rows.as_array().unwrap().iter().find(|row| row["row"] == name).unwrap().clone();
    assert_eq!(row("list")["printed"], 6321.0);
    assert_eq!(row("kd-32-2")["printed"], 2.8);
    assert!(row("kd split=median")["printed"].is_null());
    assert!(row("kd-8-10")["tests_per_ray"].as_f64().unwrap() > row("kd-32-2")["tests_per_ray"].as_f64().unwrap());

    let output = raystep(&folder, &["measure", "--growth", "--finest", "3", "--size", "16x16"]);
    let said = text(&output.stdout);
    assert!(said.contains("tests: exponent 1.00") && said.contains("Needles through one point"), "{said}");

    refused(&folder, &["measure", "--scene", "teapot"], "there is no scene");
    refused(&folder, &["measure", "--camera", "far"], "write close, scene, or six numbers");
    refused(&folder, &["measure", "--also", "kd depth=3"], "max_depth");
    refused(&folder, &["measure", "--format", "xls"], "[possible values: text, md, latex, csv, json]");
}

#[test]
fn all_structures_are_measured_on_a_mesh() {
    let folder = folder("best");
    std::fs::write(folder.join("square.obj"), SQUARE).unwrap();
    let best = ["measure", "--best", "--mesh", "square.obj", "--size", "16x16"];
    let said = |more: &[&str]| {
        let output = raystep(&folder, &[&best[..], more].concat());
        assert!(output.status.success(), "{}", text(&output.stderr));
        text(&output.stdout)
    };
    let records: Vec<serde_json::Value> = serde_json::from_str(&said(&["--format", "json"])).unwrap();
    let kinds: Vec<&str> = records.iter().map(|record| record["structure"].as_str().unwrap()).collect();
    let fast = ["fast-grid", "fast-kd", "fast-bvh2", "fast-bvh8"];
    assert_eq!(kinds, [&raystep_accel::Rule::KINDS[..], &fast].concat());
    assert!(records.iter().all(|record| record["rays"] == 256 && record["build_ms"].is_null()), "{records:?}");
    assert_eq!(records[0]["tests_per_ray"], 2.0, "brute force tests both triangles");
    assert!(said(&["--times", "--format", "csv"]).starts_with("structure,rule,rays,tests_per_ray,"));
    let page = said(&[]);
    assert_eq!(page, said(&[]), "counts are the same every time");
    assert!(
        page.contains("square.obj: 2 primitives; 256 rays") && page.contains("Brute force: nothing is built"),
        "{page}"
    );
    assert!(
        !page.contains("ms") && said(&["--times", "--format", "md"]).contains("build ms"),
        "times stand where they are asked for"
    );
    refused(&folder, &["measure", "--mesh", "square.obj"], "--best");
    refused(&folder, &["measure", "--best", "--scene", "flat-twelve"], "flat-twelve is flat");
    refused(&folder, &["measure", "--best", "--mesh", "none.obj"], "none.obj: there is no such file or folder");
}
