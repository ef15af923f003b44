//! The order of pixels in which neighbours stand together.

/// The pixels of a picture as wide as high, 2^`power` each way, in tiles of tiles: four pixels, four fours of them, and so
/// on (Morton 1966).
pub fn tile_order(power: u32) -> impl Iterator<Item = [u32; 2]> {
    let even = move |number: u32| (0..power).fold(0, |bits, i| bits | (number >> (2 * i) & 1) << i);
    (0..1_u32 << (2 * power)).map(move |number| [even(number), even(number >> 1)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pixel_comes_once_and_beside_its_neighbours() {
        let pixels: Vec<[u32; 2]> = tile_order(3).collect();
        assert_eq!(pixels[..5], [[0, 0], [1, 0], [0, 1], [1, 1], [2, 0]]);
        let mut sorted = pixels.clone();
        sorted.sort_unstable();
        sorted.dedup();
        assert_eq!(sorted.len(), 64);
        for tile in pixels.chunks(16) {
            let corner = tile[0];
            assert!(tile.iter().all(|at| (0..2).all(|axis| at[axis] - corner[axis] < 4)), "{tile:?}");
        }
    }
}
