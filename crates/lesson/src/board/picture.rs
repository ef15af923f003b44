//! Pictures that a board asks for: of which scene, seen from where, through which structure.

use glam::Vec3;
use raystep_accel::BvhVolume;

use super::table;
use crate::Plan;
use crate::keys::Keys;
use crate::reading::Reading;

/// Pictures beside each other.
#[derive(Clone, Debug, PartialEq)]
pub struct Pictures {
    /// What they are about, in a few words.
    pub title: String,
    /// What stands behind the title.
    pub about: String,
    /// Whether the seconds are told that they take.
    pub times: bool,
    /// The pictures.
    pub pictures: Vec<Picture>,
}

/// A picture to be made.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// What it is called.
    pub name: String,
    /// The name of its scene; the board's own if it has none.
    pub scene: Option<String>,
    /// Which structure its rays walk through.
    pub plan: Plan,
    /// Where it is seen from: the eye, what lies in the middle, the vertical angle in degrees. As the scene says,
    /// if it does not.
    pub view: Option<(Vec3, Vec3, f32)>,
    /// Its pixels across and down: fewer, the more pictures stand side by side.
    pub size: [u32; 2],
    /// The volume around everything that is drawn over it.
    pub volume: Option<BvhVolume>,
    /// When it comes to be seen, among everything on the board.
    pub(crate) step: Option<f32>,
    /// Where it stands.
    pub(crate) spot: crate::Spot,
}

/// Pixels of one picture, of each of two, of each of three.
const SIZES: [[u32; 2]; 3] = [[720, 450], [480, 300], [400, 250]];

/// The most pictures beside each other.
const MOST: usize = 6;

/// Reads `[[picture]]`.
pub(super) fn read(keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Option<Pictures> {
    let (title, about) = (keys.need::<String>("title", reading), keys.get::<String>("about", reading));
    let times = keys.get::<bool>("times", reading).unwrap_or_default().1;
    let mut pictures = Vec::new();
    for mut keys in keys.tables("pictures", reading) {
        let spot = reading.spot(keys.at());
        let (name, step) = (keys.need::<String>("name", reading), keys.get::<f32>("step", reading));
        let scene = keys.get::<String>("scene", reading).map(|(_, scene)| scene);
        let plan = keys.table("structure", reading).and_then(|mut table| Plan::read(&mut table, reading));
        let at = keys.at();
        table::moves(plan.as_ref(), false, at, reading);
        let (eye, target) = (keys.get::<Vec3>("eye", reading), keys.get::<Vec3>("target", reading));
        let fov = keys.get::<f32>("fov_degrees", reading).map_or(40.0, |(_, fov)| fov);
        let volume = table::volume(&mut keys, reading);
        let at = keys.at();
        keys.finish(reading);
        let view = match (eye, target) {
            (Some((_, eye)), Some((_, target))) => Some((eye, target, fov)),
            (None, None) => None,
            _ => {
                reading.problem(at, "a picture has both `eye` and `target`, or neither");
                None
            }
        };
        if let Some((_, name)) = name {
            let plan = plan.unwrap_or_else(Plan::boxes);
            let (size, step) = (SIZES[0], step.map(|(_, step)| step));
            pictures.push(Picture { name, scene, plan, view, size, volume, step, spot });
        }
    }
    if pictures.is_empty() || pictures.len() > MOST {
        reading.problem(keys.at(), format!("from one to {MOST} `pictures` stand beside each other"));
    }
    let size = SIZES[pictures.len().clamp(1, SIZES.len()) - 1];
    for picture in &mut pictures {
        picture.size = size;
    }
    Some(Pictures { title: title?.1, about: about.unwrap_or_default().1, times, pictures })
}
