//! Embree, where it is installed: one ray at a time, and packets of 16.

use super::Maker;

#[cfg(not(embree))]
pub fn makers() -> Vec<Maker> {
    Vec::new()
}

#[cfg(embree)]
pub fn makers() -> Vec<Maker> {
    vec![
        Maker { name: "embree3-medium", build: |mesh| own::build(mesh, false, false) },
        Maker { name: "embree3-high", build: |mesh| own::build(mesh, true, false) },
        Maker { name: "embree3-high-packets16", build: |mesh| own::build(mesh, true, true) },
    ]
}

#[cfg(embree)]
mod own {
    use std::ffi::c_void;

    use raystep_accel::{Hit, Mesh, Ray};

    use crate::peers::{Peer, hit};

    #[repr(C)]
    struct RaceRay([f32; 8]);

    #[repr(C)]
    #[derive(Clone)]
    struct RaceHit {
        t: f32,
        prim: u32,
    }

    unsafe extern "C" {
        fn race_build(
            corners: *const f32,
            corner_count: usize,
            triangles: *const u32,
            count: usize,
            high: i32,
        ) -> *mut c_void;
        fn race_nearest(race: *mut c_void, rays: *const RaceRay, hits: *mut RaceHit, count: usize);
        fn race_nearest16(race: *mut c_void, rays: *const RaceRay, hits: *mut RaceHit, count: usize);
        fn race_any(race: *mut c_void, rays: *const RaceRay, hits: *mut u8, count: usize);
    }

    struct Embree {
        race: *mut c_void,
        packets: bool,
    }

    pub fn build(mesh: &Mesh, high: bool, packets: bool) -> Box<dyn Peer> {
        let corners: Vec<f32> = mesh.corners.iter().flat_map(|corner| corner.to_array()).collect();
        let triangles = mesh.triangles.as_flattened();
        // Both arrays are read while it builds, and not later.
        let race = unsafe {
            race_build(corners.as_ptr(), mesh.corners.len(), triangles.as_ptr(), mesh.triangles.len(), i32::from(high))
        };
        assert!(!race.is_null(), "Embree does not start");
        Box::new(Embree { race, packets })
    }

    /// So many rays at a time: they and their hits stay in the first cache.
    const PIECE: usize = 256;

    fn ray(ray: &Ray) -> RaceRay {
        let ([a, b, c], [d, e, f]) = (ray.o.to_array(), ray.d.to_array());
        RaceRay([a, b, c, d, e, f, ray.t_min, ray.t_max])
    }

    impl Peer for Embree {
        fn nearest(&self, rays: &[Ray], hits: &mut [Option<Hit>]) {
            let walk = if self.packets { race_nearest16 } else { race_nearest };
            let mut found = vec![RaceHit { t: 0.0, prim: 0 }; PIECE];
            for (rays, hits) in rays.chunks(PIECE).zip(hits.chunks_mut(PIECE)) {
                let own: Vec<RaceRay> = rays.iter().map(ray).collect();
                // As many hits have room as there are rays.
                unsafe { walk(self.race, own.as_ptr(), found.as_mut_ptr(), own.len()) };
                for (own, hit_of) in found.iter().zip(hits) {
                    *hit_of = (own.prim != u32::MAX).then(|| hit(own.t, own.prim)).flatten();
                }
            }
        }

        fn any(&self, rays: &[Ray], hits: &mut [bool]) {
            let mut found = vec![0u8; PIECE];
            for (rays, hits) in rays.chunks(PIECE).zip(hits.chunks_mut(PIECE)) {
                let own: Vec<RaceRay> = rays.iter().map(ray).collect();
                // As many answers have room as there are rays.
                unsafe { race_any(self.race, own.as_ptr(), found.as_mut_ptr(), own.len()) };
                for (own, hit) in found.iter().zip(hits) {
                    *hit = *own != 0;
                }
            }
        }

        fn bytes(&self) -> Option<usize> {
            None
        }
    }
}
