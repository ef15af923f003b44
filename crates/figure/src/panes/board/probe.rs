//! A pixel of a heat map seen from near: its number, its neighbours, its place on the scale, and the same ray in the maps
//! beside.

use std::sync::Arc;

use glam::Vec2;

use super::heat_scale::{bar, height, outline};
use super::map::Map;
use super::maps::{Maps, Pixel};
use crate::page::{Anchor, Figure, Image, Ink, Look, line};
use crate::theme::{Face, Role, text_width};

/// So many pixels are seen on each side of the one that is pointed at.
const AROUND: i64 = 5;

/// What lies over the maps where one of their pixels is pointed at.
pub(super) fn draw(maps: &Maps, pixel: &Pixel, room: Vec2, look: &Look, shown: &dyn Fn(usize) -> bool) -> Figure {
    let mut figure = Figure::new(room);
    let corners = maps.corners(room, look);
    for (index, (map, [min, max])) in maps.maps.iter().zip(corners).enumerate() {
        let (Some(count), true) = (map.count(pixel.at), shown(map.entry) && map.size == pixel.size) else { continue };
        let says = format!("{count} {}", if count == 1 { one_of(&maps.of) } else { &maps.of });
        let hint = (map.entry == pixel.entry).then_some("click: step this ray");
        if let Some(image) = maps.image(index) {
            near(&mut figure, map, image, pixel.at, [min, max], &says, hint, look);
        }
        // Where it lies on the scale.
        let u = look.text;
        let corner = Vec2::new(max.x + u * 0.8, min.y);
        let (top, size) = bar(corner, max.y - min.y, u);
        let y = height(count, maps.most(), corner, max.y - min.y, u);
        let aside = Vec2::new(u * 0.35, 0.0);
        figure.add(Role::Tick, None, line(Vec2::new(top.x, y) - aside, Vec2::new(top.x + size.x, y) + aside));
    }
    figure
}

/// What is counted, where there is one of it.
fn one_of(of: &str) -> &str {
    match of {
        "tests" => "test",
        "boxes" => "box",
        "nodes or cells" => "node or cell",
        other => other,
    }
}

/// The pixel in its map, enlarged in a corner of it, and what its ray costs.
fn near(
    figure: &mut Figure,
    map: &Map,
    image: &Image,
    at: [u32; 2],
    [min, max]: [Vec2; 2],
    says: &str,
    hint: Option<&str>,
    look: &Look,
) {
    let u = look.text;
    let one = (max - min) / Vec2::new(map.size[0] as f32, map.size[1] as f32);
    let corner = min + one * Vec2::new(at[0] as f32, at[1] as f32);
    let middle = corner + one * 0.5;
    let side = (u * 6.0).min((max.y - min.y) * 0.35);
    let words = text_width(says, Face::Bold, u).max(hint.map_or(0.0, |hint| text_width(hint, Face::Regular, u)));
    // It keeps away from the pixel: at the right, or at the left.
    let wide = side + words + u * 3.0;
    let taken = middle.x > max.x - wide - u && middle.y < min.y + side + u * 2.0;
    let inset = if taken { min + Vec2::splat(u * 0.6) } else { Vec2::new(max.x - side - u * 0.6, min.y + u * 0.6) };
    let ends = [inset + Vec2::new(0.0, side), inset + Vec2::splat(side)];
    for end in ends {
        figure.add(Role::Page, None, line(end, middle));
    }
    let ring = one.max(Vec2::splat(u * 0.5)) * 0.5;
    figure.add(Role::Tick, None, outline(middle - ring, middle + ring));
    figure.add(Role::Scene, None, Ink::Image { min: inset, max: inset + side, image: crop(image, at) });
    figure.add(Role::Edge, None, outline(inset, inset + side));
    let pixel = side / (2 * AROUND + 1) as f32;
    let center = inset + side * 0.5;
    figure.add(Role::Tick, None, outline(center - pixel * 0.5, center + pixel * 0.5));
    // Where a map is narrow its words stand below the inset.
    let narrow = max.x - min.x < wide + u * 2.0;
    let (x, anchor) = match (narrow, taken) {
        (true, true) => (inset.x + u * 0.5, Anchor::Start),
        (true, false) => (inset.x + side - u * 0.5, Anchor::End),
        (false, true) => (inset.x + side + u, Anchor::Start),
        (false, false) => (inset.x - u, Anchor::End),
    };
    let first = if narrow { inset.y + side + u * 1.4 } else { inset.y + u };
    let mut label = |row: f32, text: &str, role: Role, face: Face| {
        let (at, text) = (Vec2::new(x, first + u * 2.0 * row), text.to_owned());
        figure.add(role, None, Ink::Text { at, text, size: u, face, anchor, boxed: true });
    };
    label(0.0, says, Role::Here, Face::Bold);
    if let Some(hint) = hint {
        label(1.0, hint, Role::Quiet, Face::Regular);
    }
}

/// The pixels around one; beyond the picture there is nothing.
fn crop(image: &Image, [x, y]: [u32; 2]) -> Image {
    let side = 2 * AROUND + 1;
    let pixel = |index: i64| {
        let (column, row) = (i64::from(x) + index % side - AROUND, i64::from(y) + index / side - AROUND);
        let inside = (0..i64::from(image.width)).contains(&column) && (0..i64::from(image.height)).contains(&row);
        let start = (row * i64::from(image.width) + column) * 4;
        let bytes = usize::try_from(start).ok().filter(|_| inside).and_then(|start| image.rgba.get(start..start + 4));
        bytes.and_then(|bytes| bytes.try_into().ok()).unwrap_or([0_u8; 4])
    };
    let rgba: Arc<[u8]> = (0..side * side).flat_map(pixel).collect();
    Image { width: side as u32, height: side as u32, rgba }
}
