//! The stack as an open bin: what was put in last lies on top and is taken first. From the far end of a lecture hall it
//! looks like nothing that could be clicked.

use glam::Vec2;
use raystep_accel::Place;

use super::stack::JOINED;
use crate::moments::{Build, GrowMoment, Moment, PacketMoment};
use crate::page::{Anchor, Figure, Ink, Look, block, write};
use crate::theme::{Face, Role, text_width};
use crate::words::number;

/// How what waits is taken out.
const OPENED: &str = ", opened from the top";

/// Something that waits, and what is known of it.
struct Item {
    place: Place,
    says: String,
}

/// The nodes that wait for a ray.
pub fn bin(moment: &Moment, size: Vec2, look: &Look) -> Figure {
    let item = |waiting: &crate::moments::Waiting| Item {
        place: Place::Node(waiting.node),
        says: format!("[{}, {}]", number(waiting.near), number(waiting.far)),
    };
    draw("Stack", OPENED, &moment.stack.iter().map(item).collect::<Vec<_>>(), size, look)
}

/// The nodes that a builder has yet to build; of one that joins sets, those that are left.
pub fn bin_of_build(build: &Build<'_>, moment: &GrowMoment, size: Vec2, look: &Look) -> Figure {
    let item = |node: &raystep_accel::NodeId| Item { place: Place::Node(*node), says: String::new() };
    if build.joins() {
        return draw(JOINED, "", &moment.apart().iter().map(item).collect::<Vec<_>>(), size, look);
    }
    draw("Still to be built", OPENED, &moment.waiting.iter().map(item).collect::<Vec<_>>(), size, look)
}

/// The nodes that wait for the rays of a packet.
pub(crate) fn bin_of_packet(moment: &PacketMoment, size: Vec2, look: &Look) -> Figure {
    let item = |(node, lanes): &(raystep_accel::NodeId, raystep_accel::Lanes)| {
        let rays: Vec<String> = lanes.iter().map(|lane| (lane + 1).to_string()).collect();
        let says = if rays.len() == 1 { format!("ray {}", rays[0]) } else { format!("rays {}", rays.join(" ")) };
        Item { place: Place::Node(*node), says }
    };
    draw("Stack", OPENED, &moment.stack.iter().map(item).collect::<Vec<_>>(), size, look)
}

/// The bin with what lies in it, the first at the bottom, and in which `order` it goes. Where not all of it has room, the
/// lowest is the rest.
fn draw(title: &str, order: &str, items: &[Item], size: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(size);
    let top = look.heading(&mut figure, title, "");
    let u = look.text;
    let left = look.margin();
    let right = (size.x - look.margin()).min(left + u * 17.0);
    let foot = size.y - u * 1.7;
    let (height, gap) = (u * 1.75, u * 0.3);
    let room = ((foot - gap - top) / (height + gap)).floor().max(1.0) as usize;
    let walls = vec![Vec2::new(left, top), Vec2::new(left, foot), Vec2::new(right, foot), Vec2::new(right, top)];
    figure.add(Role::Text, None, Ink::Line { points: walls });
    // The topmost ones are seen; below them all others in one.
    let shown = if items.len() > room { room - 1 } else { items.len() };
    let hidden = items.len() - shown;
    let mut bottom = foot - gap;
    if hidden > 0 {
        let at = Vec2::new((left + right) * 0.5, bottom - height * 0.5);
        let says = if shown == 0 { format!("{hidden} nodes") } else { format!("{hidden} more below") };
        write(&mut figure, Role::Waiting, None, at, &says, u * 0.9, Face::Regular, Anchor::Middle);
        bottom -= height + gap;
    }
    for Item { place, says } in &items[hidden..] {
        let corner = Vec2::new(left + u * 0.5, bottom - height);
        let extent = Vec2::new(right - left - u, height);
        figure.add(Role::Waiting, Some(*place), block(corner, extent, 0.0));
        let middle = bottom - height * 0.5;
        let name = place.to_string();
        let wide = |text: &str, face| text_width(text, face, u);
        let both = wide(&name, Face::Bold) + wide(says, Face::Mono) + u * 2.4 <= extent.x;
        let mut put = |x, text: &str, face, anchor| {
            write(&mut figure, Role::Waiting, Some(*place), Vec2::new(x, middle), text, u, face, anchor);
        };
        if both && !says.is_empty() {
            put(corner.x + u * 0.8, &name, Face::Bold, Anchor::Start);
            put(corner.x + extent.x - u * 0.8, says, Face::Mono, Anchor::End);
        } else {
            put(corner.x + extent.x * 0.5, &name, Face::Bold, Anchor::Middle);
        }
        bottom -= height + gap;
    }
    let says = match items.len() {
        0 => "nothing waits".to_owned(),
        1 => "1 node waits".to_owned(),
        many => format!("{many} nodes wait{order}"),
    };
    let at = Vec2::new(left, size.y - u * 0.75);
    let short = says.split(',').next().unwrap_or_default().to_owned();
    let fits = text_width(&says, Face::Regular, u * 0.9) <= size.x - 2.0 * left;
    write(&mut figure, Role::Quiet, None, at, if fits { &says } else { &short }, u * 0.9, Face::Regular, Anchor::Start);
    figure
}
