//! What each ray of a picture costs, as `raystep heatmap` writes it.

use super::{SQUARE, folder, raystep, refused, text};

#[test]
fn a_heat_map_holds_what_each_ray_costs() {
    let folder = folder("heatmap");
    std::fs::write(folder.join("square.obj"), SQUARE).unwrap();
    let done = |arguments: &[&str]| {
        let output = raystep(&folder, arguments);
        assert!(output.status.success(), "{arguments:?}: {}", text(&output.stderr));
        text(&output.stdout)
    };
    let scene = ["--scene", "teapot-6321", "--structure", "kd", "--rule", "max_depth=16"];
    let map =
        |more: &[&str]| done(&[&["heatmap"], &scene[..], &["--camera", "scene", "--size", "48x30"], more].concat());
    map(&["--out", "map.csv"]);
    let rows = std::fs::read_to_string(folder.join("map.csv")).unwrap();
    let rows: Vec<Vec<u64>> =
        rows.lines().map(|row| row.split(',').map(|count| count.parse().unwrap()).collect()).collect();
    assert_eq!((rows.len(), rows[0].len()), (30, 48));
    for [x, y] in [[0_usize, 0], [24, 15], [20, 18], [47, 29]] {
        let pixel = format!("{x},{y}");
        let more = ["--size", "48x30", "--format", "csv", "--pixel", &pixel];
        let walk = done(&[&["trace"], &scene[..], &more].concat());
        // Counted by the walk's last step, behind what it says.
        let tests = walk.lines().last().unwrap().rsplit(',').nth(3).unwrap();
        assert_eq!(rows[y][x].to_string(), tests, "at {pixel}");
    }
    map(&["--out", "bare.png", "--bare"]);
    map(&["--out", "map.png", "--of", "visits"]);
    let size = |name: &str| {
        let reader = png::Decoder::new(std::io::BufReader::new(std::fs::File::open(folder.join(name)).unwrap()));
        let reader = reader.read_info().unwrap();
        (reader.info().width, reader.info().height)
    };
    assert_eq!(size("bare.png"), (48, 30));
    assert!(size("map.png").0 > 48 && size("map.png").1 > 30, "there is room for the scale");
    let first = std::fs::read(folder.join("map.png")).unwrap();
    map(&["--out", "map.png", "--of", "visits"]);
    assert_eq!(std::fs::read(folder.join("map.png")).unwrap(), first, "the same to the byte");
    done(&[
        "heatmap",
        "--mesh",
        "square.obj",
        "--structure",
        "bvh",
        "--of",
        "boxes",
        "--size",
        "16x16",
        "--out",
        "s.csv",
    ]);

    let heat = ["heatmap", "--structure", "kd", "--scene"];
    for (more, says) in [
        (&["teapot-6321", "--out", "map.jpg"][..], "--out map.jpg: a heat map is written as FILE.png or FILE.csv"),
        (&["teapot-6321", "--out", "map.csv", "--bare"], "--bare leaves out the scale of a picture"),
        (&["teapot-6321", "--out", "none/map.png"], "there is no folder none"),
        (
            &["flat-twelve", "--out", "flat.png"],
            "flat-twelve is flat: a ray through a pixel would fall onto it from above",
        ),
        (&["teapot-6322", "--out", "map.png"], "teapot-6321"),
        (&["teapot-6321", "--out", "map.png", "--of", "hits"], "tests, visits, boxes"),
        (&["teapot-6321", "--out", "map.png", "--rule", "depth=3"], "max_depth"),
        (&["teapot-6321", "--out", "map.png", "--camera", "0,0,0,0,0,0"], "the eye must not lie at the target"),
    ] {
        refused(&folder, &[&heat[..], more].concat(), says);
    }
    refused(&folder, &["heatmap", "--structure", "kd", "--mesh", "square.obj", "--out", "square.obj"], "FILE.png");
    assert_eq!(std::fs::read(folder.join("map.png")).unwrap(), first, "what is refused leaves what was there");
    let names = std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name()).collect::<Vec<_>>();
    assert_eq!(names.len(), 5, "{names:?}");
}
