//! Inputs out of seeds, by changes that a tired hand or a torn file makes.

use raystep_accel::Random;

use super::{NUMBERS, Target};

/// Bytes of an input.
const LONGEST: usize = 4096;

/// A seed, changed in a few places.
pub(super) fn changed(seeds: &[Vec<u8>], target: &Target, random: &mut Random) -> Vec<u8> {
    let mut bytes = seeds[random.below(seeds.len() as u32) as usize].clone();
    for _ in 0..1 + random.below(6) {
        change(&mut bytes, seeds, target, random);
    }
    bytes.truncate(LONGEST);
    bytes
}

fn change(bytes: &mut Vec<u8>, seeds: &[Vec<u8>], target: &Target, random: &mut Random) {
    let at = random.below(bytes.len() as u32 + 1) as usize;
    let most = 1 << random.below(9);
    let end = (at + 1 + random.below(most) as usize).min(bytes.len());
    match random.below(13) {
        0 if at < bytes.len() => bytes[at] ^= 1 << random.below(8),
        1 if at < bytes.len() => bytes[at] = random.bits() as u8,
        2 => drop(bytes.drain(at..end)),
        3 => bytes.truncate(at),
        4 => {
            // Again, behind itself.
            let part = bytes[at..end].to_vec();
            bytes.splice(end..end, part);
        }
        5 => {
            // Very often.
            let part = bytes[at..end].repeat(1 + random.below(200) as usize);
            bytes.splice(at..end, part);
        }
        6 => {
            // Elsewhere.
            let part: Vec<u8> = bytes.drain(at..end).collect();
            let to = random.below(bytes.len() as u32 + 1) as usize;
            bytes.splice(to..to, part);
        }
        7 => {
            // Part of another seed.
            let other = &seeds[random.below(seeds.len() as u32) as usize];
            let from = random.below(other.len() as u32 + 1) as usize;
            let until = (from + random.below(256) as usize).min(other.len());
            bytes.splice(at..end, other[from..until].iter().copied());
        }
        8 => {
            // Another number.
            let digit = |byte: &u8| byte.is_ascii_digit();
            let Some(from) = bytes[at..].iter().position(digit).map(|from| at + from) else { return };
            let length = bytes[from..].iter().take_while(|byte| digit(byte) || **byte == b'.').count();
            let number = NUMBERS[random.below(NUMBERS.len() as u32) as usize];
            bytes.splice(from..from + length, number.bytes());
        }
        _ if target.words.is_empty() => {
            let noise: Vec<u8> = (0..random.below(12)).map(|_| random.bits() as u8).collect();
            bytes.splice(at..end, noise);
        }
        9 => {
            let word = target.words[random.below(target.words.len() as u32) as usize];
            bytes.splice(at..end, word.bytes());
        }
        _ => {
            let word = target.words[random.below(target.words.len() as u32) as usize];
            bytes.splice(at..at, word.bytes());
        }
    }
    bytes.truncate(4 * LONGEST);
}

/// A shorter and emptier input for which `fails` still holds.
pub(super) fn shortened(bytes: &[u8], fails: &dyn Fn(&[u8]) -> bool) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    let mut length = bytes.len().next_power_of_two();
    while length > 0 {
        let mut at = 0;
        while at < bytes.len() {
            let without = [&bytes[..at], &bytes[(at + length).min(bytes.len())..]].concat();
            if fails(&without) {
                bytes = without;
            } else {
                at += length;
            }
        }
        length /= 2;
    }
    for at in 0..bytes.len() {
        let mut emptier = bytes.clone();
        emptier[at] = 0;
        if emptier != bytes && fails(&emptier) {
            bytes = emptier;
        }
    }
    bytes
}
