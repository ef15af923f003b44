//! A box as it lies in memory: two corners, slide 12.

use glam::Vec2;
use raystep_accel::{Aabb, Axis, Direction, Place, Visit};

use crate::page::{Anchor, Figure, Look, block, write};
use crate::theme::{Face, Role, text_width};
use crate::words::number;

/// Bytes of a coordinate.
const EACH: usize = size_of::<f32>();

/// The six coordinates of a box, each with its bytes in the order in which they lie, as far as its slabs have been cut by
/// what is `done`. While a question asks what stands there, `hide` leaves the fields empty.
pub(super) fn box_bytes(bounds: &Aabb, done: &[Visit], hide: bool, size: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(size);
    let corners = [("min", bounds.min), ("max", bounds.max)];
    let cut = |axis: Axis| {
        done.iter().any(|event| match *event {
            Visit::Divide { axis: of, .. } | Visit::Parallel { axis: of, .. } => of == Direction::Along(axis),
            _ => false,
        })
    };
    let fields: Vec<(String, f32, bool)> = corners
        .iter()
        .flat_map(|(name, corner)| Axis::ALL.map(|axis| (format!("{name}.{}", axis.name()), corner[axis], cut(axis))))
        .collect();
    let remark = format!("two corners, {} numbers of {EACH} bytes: {} bytes", fields.len(), size_of::<Aabb>());
    let top = look.heading(&mut figure, "Bytes of the box", &remark);
    let place = Some(Place::World);
    let width = (size.x - 2.0 * look.margin()) / fields.len() as f32;
    let u = (look.text * 1.3).min((size.y - top) / 6.2).min(width / 6.4);
    let y = top + u * 1.4;
    for (index, (name, value, known)) in fields.iter().enumerate() {
        let corner = Vec2::new(look.margin() + width * index as f32, y);
        let middle = corner.x + width * 0.5;
        let write = |figure: &mut Figure, role, down: f32, text: &str, size: f32, face| {
            let size = size.min((width - u * 0.3) / text_width(text, face, 1.0).max(0.01));
            write(figure, role, place, Vec2::new(middle, y + u * down), text, size, face, Anchor::Middle);
        };
        write(&mut figure, Role::Text, -0.7, name, u * 0.85, Face::Medium);
        figure.add(Role::Seen, place, block(corner, Vec2::new(width, u * 1.8), 0.0));
        let says = match (known, hide) {
            (true, _) => number(*value),
            (false, true) => "?".to_owned(),
            (false, false) => String::new(),
        };
        write(&mut figure, Role::Value, 0.9, &says, u, Face::Mono);
        let bytes = value.to_le_bytes().map(|byte| format!("{byte:02x}"));
        let bytes = if *known { bytes.join(" ") } else { String::new() };
        write(&mut figure, Role::Quiet, 2.6, &bytes, u * 0.8, Face::Mono);
        let from = format!("byte {}", index * EACH);
        write(&mut figure, Role::Quiet, 3.8, &from, u * 0.7, Face::Regular);
    }
    figure
}
