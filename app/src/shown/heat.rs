//! Heat maps of any structure over any solid scene: what each ray of a camera costs, pixel by pixel.

use std::sync::{Arc, LazyLock};

use glam::Vec2;
use rayon::prelude::*;
use raystep_accel::{Accel, Cost, Prims, Ray, RayError, Reveal, Structure, Want};
use raystep_fast::{AnyFast, Fast, FastKind, Settings};
use raystep_figure::{Board, Camera, Instant, Known, Map, Maps, Panel, Pixel, Reel};
use raystep_lesson::Column;
use raystep_scene::Scene;

use super::board::counted;

/// What a heat map is to show.
#[derive(Clone, Debug)]
pub(crate) struct Wish {
    /// What is hit.
    pub(crate) scene: Arc<Scene>,
    /// Through what, each with a name: a map for each, all on one scale.
    pub(crate) structures: Vec<Named>,
    /// What is counted.
    pub(crate) of: Column,
    /// From where.
    pub(crate) camera: Camera,
    /// Width and height of the picture in points.
    pub(crate) size: Vec2,
}

/// A structure and what it is called.
type Named = (String, Walked);

/// What rays are walked through.
#[derive(Clone, Debug)]
pub(crate) enum Walked {
    /// A structure of the textbook.
    Textbook(Arc<Structure>),
    /// A structure of the last chapter at full speed: what is counted is its own work.
    Fast(Arc<Quick>),
}

/// A fast structure that is built when the first ray needs it.
pub(crate) type Quick = LazyLock<AnyFast, Box<dyn FnOnce() -> AnyFast + Send>>;

impl Walked {
    /// A fast structure over a scene of triangles, still to be built; nothing over other shapes.
    pub(crate) fn fast(scene: &Arc<Scene>, kind: FastKind) -> Option<Walked> {
        let Prims::Mesh(_) = scene.prims else { return None };
        let scene = scene.clone();
        let build = move || match &scene.prims {
            Prims::Mesh(mesh) => kind.build(mesh, &Settings::default()),
            Prims::Few(_) | Prims::Instances(_) => unreachable!("looked at above"),
        };
        Some(Walked::Fast(Arc::new(LazyLock::new(Box::new(build)))))
    }

    /// Builds it, if it is not built.
    pub(crate) fn build(&self) {
        if let Walked::Fast(fast) = self {
            LazyLock::force(fast);
        }
    }

    /// What a ray costs.
    pub(crate) fn cost(&self, scene: &Scene, ray: &Ray) -> Cost {
        let mut cost = Cost::default();
        match self {
            Walked::Textbook(structure) => _ = structure.intersect(&scene.prims, ray, &mut cost),
            Walked::Fast(fast) => _ = fast.walk(ray, Want::Nearest, &mut cost),
        }
        cost
    }

    fn is(&self, other: &Walked) -> bool {
        match (self, other) {
            (Walked::Textbook(a), Walked::Textbook(b)) => Arc::ptr_eq(a, b),
            (Walked::Fast(a), Walked::Fast(b)) => Arc::ptr_eq(a, b),
            _ => false,
        }
    }
}

/// A heat map that was counted.
#[derive(Debug)]
pub(crate) struct Heated {
    /// What it shows.
    pub(crate) wish: Wish,
    /// Rays across and down.
    pub(crate) rays: [u32; 2],
    panels: [Panel; 1],
    events: Vec<Reveal>,
    names: Vec<String>,
}

impl Wish {
    /// Whether both show the same.
    pub(crate) fn is_same(&self, other: &Wish) -> bool {
        let same = |(a, b): (&Named, &Named)| a.0 == b.0 && a.1.is(&b.1);
        self.structures.len() == other.structures.len()
            && self.structures.iter().zip(&other.structures).all(same)
            && Arc::ptr_eq(&self.scene, &other.scene)
            && (self.of, self.camera, self.size) == (other.of, other.camera, other.size)
    }

    /// The ray through the middle of a pixel, where there are so many across and down.
    ///
    /// # Errors
    /// The camera sees nothing: its eye lies at what it looks at.
    pub(crate) fn ray(&self, [across, down]: [u32; 2], [x, y]: [u32; 2]) -> Result<Ray, RayError> {
        let part = Vec2::new(x as f32 + 0.5, y as f32 + 0.5) / Vec2::new(across as f32, down as f32);
        self.camera.ray(part * self.size, self.size)
    }

    /// Counts what so many rays across and down cost, row by row; nothing if `go_on` says so before a row.
    pub(crate) fn count(self, rays: [u32; 2], go_on: &(dyn Fn() -> bool + Sync)) -> Option<Heated> {
        let counts: Option<Vec<Vec<u32>>> =
            self.structures.iter().map(|(_, structure)| self.count_one(structure, rays, go_on)).collect();
        Some(Heated::of(self, rays, counts?))
    }

    fn count_one(&self, walked: &Walked, rays: [u32; 2], go_on: &(dyn Fn() -> bool + Sync)) -> Option<Vec<u32>> {
        let one = |at: [u32; 2]| {
            // A camera that sees nothing shoots rays that cost nothing.
            let cost = self.ray(rays, at).map_or(Cost::default(), |ray| walked.cost(&self.scene, &ray));
            u32::try_from(self.of.count(&cost)).unwrap_or(u32::MAX)
        };
        let row = |y: u32| go_on().then(|| (0..rays[0]).map(|x| one([x, y])).collect::<Vec<u32>>());
        let rows: Option<Vec<Vec<u32>>> = (0..rays[1]).into_par_iter().map(row).collect();
        Some(rows?.concat())
    }
}

impl Heated {
    fn of(wish: Wish, rays: [u32; 2], counts: Vec<Vec<u32>>) -> Heated {
        let named = wish.structures.iter().zip(counts).enumerate();
        let map = |(entry, ((name, _), counts)): (usize, (&(String, _), Vec<u32>))| Map {
            entry,
            name: name.clone(),
            size: rays,
            counts,
            known: Known::Fully,
        };
        let maps: Vec<Map> = named.map(map).collect();
        let title = format!("{} per ray", capital(counted(wish.of)));
        let about = format!("{}, a ray for each of {} × {} pixels", wish.scene.title, rays[0], rays[1]);
        let maps = Maps::new(title, about, counted(wish.of).to_owned(), maps);
        let event = |map: &Map| {
            let all = map.counts.iter().map(|count| f64::from(*count));
            let mean = (all.clone().sum::<f64>() / map.counts.len().max(1) as f64) as f32;
            let least = all.clone().fold(f64::INFINITY, f64::min) as f32;
            Reveal::Map { entry: map.entry as u32, mean, least, most: all.fold(0.0, f64::max) as f32 }
        };
        let events = maps.maps.iter().map(event).collect();
        let names = maps.maps.iter().map(|map| map.name.clone()).collect();
        Heated { wish, rays, panels: [Panel::Maps(maps)], events, names }
    }

    /// The maps, to be drawn as those of a board are.
    pub(crate) fn reel(&self) -> Reel<'_> {
        Reel::new(Board { panels: &self.panels, events: &self.events, names: &self.names })
    }

    /// All of them to be seen.
    pub(crate) fn instant(&self) -> Instant {
        self.reel().at(self.events.len())
    }

    /// The maps.
    pub(crate) fn maps(&self) -> Option<&Maps> {
        match &self.panels {
            [Panel::Maps(maps)] => Some(maps),
            _ => None,
        }
    }

    /// The ray of a pixel.
    pub(crate) fn ray_of(&self, pixel: &Pixel) -> Option<Ray> {
        self.wish.ray(pixel.size, pixel.at).ok()
    }
}

/// What a pixel says in a sentence: its number and its ray.
pub(crate) fn sentence(count: u32, of: Column, ray: &Ray) -> String {
    let [o, d] = [ray.o, ray.d].map(|v| {
        let [x, y, z] = v.to_array().map(raystep_figure::number);
        format!("({x}, {y}, {z})")
    });
    format!("{count} {} on the ray from {o} along {d}.", counted(of))
}

fn capital(words: &str) -> String {
    let mut letters = words.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

#[cfg(test)]
mod tests {
    use raystep_accel::Rule;
    use raystep_fast::Work;

    use super::*;

    fn wish(kind: &str, of: Column) -> Wish {
        let scene = Arc::new(Scene::named("teapot:3x3").unwrap());
        let walked = match FastKind::named(kind) {
            Some(fast) => Walked::fast(&scene, fast).unwrap(),
            None => {
                let rule = Rule::default_for(kind).unwrap();
                Walked::Textbook(Arc::new(Structure::build(&scene.prims, &rule, &mut ()).unwrap()))
            }
        };
        let view = scene.close_view();
        let camera = Camera::Solid { eye: view.eye, target: view.target, up: view.up, fov_degrees: view.fov_degrees };
        let structures = vec![(kind.to_owned(), walked)];
        Wish { scene, structures, of, camera, size: Vec2::new(60.0, 40.0) }
    }

    #[test]
    fn a_pixel_is_what_its_ray_costs() {
        for (kind, of) in [
            ("kd", Column::Tests),
            ("bvh", Column::Boxes),
            ("grid", Column::Visits),
            ("list", Column::Tests),
            ("fast-bvh8", Column::Visits),
            ("fast-kd", Column::Tests),
        ] {
            let heated = wish(kind, of).count([30, 20], &|| true).unwrap();
            let maps = heated.maps().unwrap();
            let mut different = false;
            for (index, count) in maps.maps[0].counts.iter().enumerate() {
                let at = [index as u32 % 30, index as u32 / 30];
                let ray = heated.ray_of(&Pixel { entry: 0, at, size: [30, 20], count: *count }).unwrap();
                let cost = match &heated.wish.structures[0].1 {
                    Walked::Textbook(structure) => {
                        let mut cost = Cost::default();
                        structure.intersect(&heated.wish.scene.prims, &ray, &mut cost);
                        of.count(&cost)
                    }
                    // Its own count of the same walk.
                    Walked::Fast(fast) => {
                        let mut work = Work::default();
                        fast.walk(&ray, Want::Nearest, &mut work);
                        if of == Column::Tests { work.triangles } else { work.nodes }
                    }
                };
                assert_eq!(u64::from(*count), cost, "{kind} at {at:?}");
                different |= *count != maps.maps[0].counts[0];
            }
            assert_eq!(
                different,
                kind != "list",
                "{kind}: brute force costs the same everywhere, and nothing else does"
            );
        }
    }

    #[test]
    fn counting_is_given_up_before_a_row() {
        assert!(wish("kd", Column::Tests).count([30, 20], &|| false).is_none());
    }
}
