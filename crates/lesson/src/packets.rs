//! The packets of a stage: several rays each, given one by one or spread evenly between two.

use glam::{Vec2, Vec3};
use raystep_accel::Ray;
use toml::Spanned;
use toml::de::DeValue;

use crate::counts::{check_count, check_length, promises};
use crate::keys::{FromToml, Keys, wrong};
use crate::reading::Reading;
use crate::{NamedRay, limits};

/// How many rays a packet has that does not say.
const LANES: f32 = 4.0;

/// `[{ name = "a fan", from = [0, 1], towards = [[8, 2], [8, 5]], lanes = 4 }]`: each packet by its first ray.
pub(crate) fn read(keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Vec<NamedRay> {
    const WHAT: &str = "a list of packets: [{ name = \"...\", from = [x, y], towards = [[x, y], [x, y]] }]";
    if let Some(rays) = keys.raw("rays") {
        reading.problem(rays.span().start, "`rays` walk one by one: several at once are `packets`");
    }
    let Some(value) = keys.raw("packets") else {
        reading.problem(keys.at(), format!("`packets` is missing: write `packets = ` and {WHAT}"));
        return Vec::new();
    };
    let Some(list) = value.get_ref().as_array() else {
        wrong("packets", WHAT, value, reading);
        return Vec::new();
    };
    if !check_count("packets", value.span().start, list.len(), limits::RAYS, reading) {
        return Vec::new();
    }
    let mut packets: Vec<NamedRay> = Vec::new();
    for value in list {
        let Some(packet) = packet(value, reading) else { continue };
        let at = value.span().start;
        for other in &packets {
            if other.name == packet.name {
                reading.problem(at, format!("the packet `{}` is there twice: each name stands once", packet.name));
            } else if other.ray == packet.ray {
                let message = format!("the packet `{}` has the first ray of `{}`", packet.name, other.name);
                reading.problem(at, message + ": packets are told apart by it");
            }
        }
        packets.push(packet);
    }
    if list.len() < 2 {
        reading.problem(value.span().start, format!("a stage has two packets or more; here is {}", list.len()));
    }
    packets
}

/// One packet.
fn packet(value: &Spanned<DeValue<'_>>, reading: &mut Reading<'_>) -> Option<NamedRay> {
    let at = value.span().start;
    let Some(table) = value.get_ref().as_table() else {
        wrong(
            "packets",
            "a list of tables: { name = \"...\", from = [x, y], towards = [[x, y], [x, y]] }",
            value,
            reading,
        );
        return None;
    };
    let mut keys = Keys::new(table, at);
    let name = keys.need::<String>("name", reading);
    let from = keys.need::<Points>("from", reading);
    let towards = keys.get::<Points>("towards", reading);
    let direction = keys.get::<Points>("direction", reading);
    let lanes = keys.get::<f32>("lanes", reading);
    let range = keys.get::<Vec2>("t", reading);
    let kept = keys.get::<Vec<String>>("promise", reading);
    keys.finish(reading);

    let ((name_at, name), (from_at, Points(from))) = (name?, from?);
    check_length("the packet's name", name_at, &name, reading);
    if name.trim().is_empty() {
        reading.problem(name_at, "the packet's name is empty: it says what is to be seen");
    }
    let (lanes_at, lanes) = lanes.unwrap_or((at, LANES));
    let [least, most] = limits::LANES;
    if lanes.fract() != 0.0 || !(least as f32..=most as f32).contains(&lanes) {
        reading.problem(lanes_at, format!("`lanes` is {lanes}: a packet has from {least} to {most} rays"));
        return None;
    }
    let lanes = lanes as usize;
    let (to_at, Points(to), is_point) = match (towards, direction) {
        (Some((at, points)), None) => (at, points, true),
        (None, Some((at, points))) => (at, points, false),
        _ => {
            reading.problem(at, "a packet has either `towards` (points) or `direction`");
            return None;
        }
    };
    let (from, to) = (spread("from", from_at, &from, lanes, reading), spread("towards", to_at, &to, lanes, reading));
    let range = range.map_or([0.0, f32::INFINITY], |(_, range)| range.into());
    let mut rays = Vec::new();
    for (lane, (from, to)) in (1..).zip(from?.into_iter().zip(to?)) {
        let d = if is_point { (to - from).normalize_or_zero() } else { to };
        match Ray::new(from, d).and_then(|ray| ray.within(range[0], range[1])) {
            Ok(ray) => rays.push(ray),
            Err(error) => {
                reading.problem(to_at, format!("ray {lane} of the packet cannot be walked: {error}"));
                return None;
            }
        }
    }
    let promises = promises(kept.unwrap_or_default(), reading);
    let (ray, others) = (rays.remove(0), rays);
    let (spot, name_spot) = (reading.spot(at), reading.spot(name_at));
    Some(NamedRay { name, ray, others, promises, spot, name_spot })
}

/// A point for each ray: the same for all, or from the first to the last of two in equal steps, or each its own.
fn spread(key: &str, at: usize, points: &[Vec3], lanes: usize, reading: &mut Reading<'_>) -> Option<Vec<Vec3>> {
    match *points {
        [one] => Some(vec![one; lanes]),
        [first, last] => Some((0..lanes).map(|lane| first.lerp(last, lane as f32 / (lanes - 1) as f32)).collect()),
        _ if points.len() == lanes => Some(points.to_vec()),
        _ => {
            let found = points.len();
            reading.problem(
                at,
                format!(
                    "`{key}` has {found} points for {lanes} rays: write one, two between which they are spread, or one for each"
                ),
            );
            None
        }
    }
}

/// A point, or several.
struct Points(Vec<Vec3>);

impl FromToml for Points {
    const WHAT: &'static str = "a point, or several: [x, y], [[x, y], [x, y]]";

    fn from_toml(value: &DeValue<'_>) -> Option<Points> {
        if let Some(one) = Vec3::from_toml(value) {
            return Some(Points(vec![one]));
        }
        value.as_array()?.iter().map(|value| Vec3::from_toml(value.get_ref())).collect::<Option<_>>().map(Points)
    }
}
