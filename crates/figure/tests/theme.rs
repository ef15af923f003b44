//! Every theme can be read, and its roles can be told apart, also by those who see fewer colours.

use raystep_figure::{Color, Role, Style, Theme};

/// Roles that say what became of something.
const STATES: [Role; 17] = [
    Role::Scene,
    Role::Ray,
    Role::Live,
    Role::Tick,
    Role::Here,
    Role::Seen,
    Role::Waiting,
    Role::Dropped,
    Role::Missed,
    Role::Hit,
    Role::Best,
    Role::Plane,
    Role::Candidate,
    Role::Below,
    Role::Above,
    Role::Guess,
    Role::Wrong,
];

/// What protanopes, deuteranopes and tritanopes see, in linear light (Machado, Oliveira and Fernandes 2009).
const SIMULATIONS: [(&str, [[f64; 3]; 3]); 4] = [
    ("all colours", [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]),
    ("protanopia", [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]]),
    (
        "deuteranopia",
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
    ),
    ("tritanopia", [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]]),
];

#[test]
fn text_and_marks_stand_out_from_the_page() {
    for theme in Theme::ALL {
        let least = if theme.name == "projector" { 7.0 } else { 4.5 };
        let page = theme.style(Role::Page).fill.expect("a page has a colour");
        let panel = theme.style(Role::Panel).fill.expect("a panel has a colour");
        for role in Role::ALL {
            let style = theme.style(role);
            for ground in [page, panel] {
                let found = contrast(style.text, ground);
                assert!(found >= least, "{} text of {role:?}: {found:.2}", theme.name);
                // The rule around a panel only separates.
                if let (Some(stroke), false) = (style.stroke, role == Role::Panel) {
                    let found = contrast(stroke.color.over(ground), ground);
                    assert!(found >= 3.0, "{} line of {role:?}: {found:.2}", theme.name);
                }
                // Text stands on the tint of its own role.
                if let (Some(fill), true) = (style.fill, matches!(role, Role::Here | Role::Waiting | Role::Ground)) {
                    let found = contrast(style.text, fill.over(ground));
                    assert!(found >= least, "{} text of {role:?} on its tint: {found:.2}", theme.name);
                }
            }
            let label = theme.label(role);
            let found = contrast(label.text, label.fill.expect("a label has a ground").over(page));
            assert!(found >= least, "{} label of {role:?}: {found:.2}", theme.name);
        }
    }
}

#[test]
fn what_lies_in_the_scene_is_seen_from_the_last_row() {
    let theme = &Theme::PROJECTOR;
    let page = theme.style(Role::Page).fill.expect("a page has a colour");
    let ground = |role| theme.style(role).fill.map_or(page, |fill| fill.over(page));
    // What was hit, what was not touched, and the page; what was tested and missed is hatched.
    for (a, b) in
        [(Role::Scene, Role::Page), (Role::Hit, Role::Scene), (Role::Best, Role::Scene), (Role::Hit, Role::Page)]
    {
        let found = contrast(ground(a), ground(b));
        assert!(found >= 1.5, "fills of {a:?} and {b:?}: {found:.2}");
    }
    assert!(theme.style(Role::Missed).hatch);
    for role in [Role::Scene, Role::Missed, Role::Hit, Role::Best, Role::Edge, Role::Here, Role::Seen, Role::Waiting] {
        let stroke = theme.style(role).stroke.expect("it has an edge");
        for on in [Role::Page, Role::Scene, Role::Here, Role::Waiting] {
            let found = contrast(stroke.color, ground(on));
            assert!(found >= 3.0, "edge of {role:?} on {on:?}: {found:.2}");
        }
    }
}

#[test]
fn states_differ_in_line_or_in_a_colour_that_everybody_sees() {
    for theme in Theme::ALL {
        for (index, &a) in STATES.iter().enumerate() {
            for &b in &STATES[index + 1..] {
                let (look_a, look_b) = (theme.style(a), theme.style(b));
                if drawn_differently(&look_a, &look_b) {
                    continue;
                }
                let (Some(line_a), Some(line_b)) = (look_a.stroke, look_b.stroke) else { continue };
                for (name, matrix) in &SIMULATIONS {
                    let apart = distance(seen(line_a.color, matrix), seen(line_b.color, matrix));
                    assert!(apart >= 12.0, "{} {a:?} and {b:?} under {name}: {apart:.1}", theme.name);
                }
            }
        }
    }
}

#[test]
fn themes_are_found_by_name() {
    for theme in Theme::ALL {
        assert_eq!(Theme::named(theme.name), Some(theme));
    }
    assert_eq!(Theme::named("sepia"), None);
}

/// Whether dash, hatching, filling or a width of at least a quarter more tells two looks apart.
fn drawn_differently(a: &Style, b: &Style) -> bool {
    let (Some(line_a), Some(line_b)) = (a.stroke, b.stroke) else { return true };
    let ratio = line_a.width.max(line_b.width) / line_a.width.min(line_b.width);
    let opacity = |style: &Style| style.fill.map_or(0, |fill| fill.a);
    let filled = opacity(a).abs_diff(opacity(b)) > 60;
    line_a.dash != line_b.dash || a.hatch != b.hatch || filled || ratio >= 1.25
}

fn linear(channel: u8) -> f64 {
    let c = f64::from(channel) / 255.0;
    if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
}

/// WCAG's contrast of two opaque colours.
fn contrast(a: Color, b: Color) -> f64 {
    let luminance = |c: Color| 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
    let (a, b) = (luminance(a) + 0.05, luminance(b) + 0.05);
    if a > b { a / b } else { b / a }
}

/// Linear red, green and blue as they are seen.
fn seen(color: Color, matrix: &[[f64; 3]; 3]) -> [f64; 3] {
    let rgb = [linear(color.r), linear(color.g), linear(color.b)];
    matrix.map(|row| row.iter().zip(rgb).map(|(weight, channel)| weight * channel).sum::<f64>().clamp(0.0, 1.0))
}

/// Distance in CIE L*a*b* (1976).
fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let lab = |[r, g, b]: [f64; 3]| {
        let f = |t: f64| if t > 0.008856 { t.cbrt() } else { 7.787 * t + 16.0 / 116.0 };
        let x = f((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.95047);
        let y = f(0.2126 * r + 0.7152 * g + 0.0722 * b);
        let z = f((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.08883);
        [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
    };
    let (a, b) = (lab(a), lab(b));
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}
