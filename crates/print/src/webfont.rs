//! A shipped face with the letters that one file uses, as browsers load it.

use std::collections::BTreeSet;
use std::fmt::Write;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use subsetter::GlyphRemapper;
use ttf_parser::{RawFace, Tag};

use crate::typefaces::Typeface;

/// Writes the rule of a style sheet that brings a face along, for these letters.
pub(crate) fn face(out: &mut String, typeface: Typeface, letters: &BTreeSet<char>) {
    // A face that cannot be cut stays named.
    let Some(bytes) = font(typeface, letters) else { return };
    let slant = if typeface.slants() { "italic" } else { "normal" };
    let kind = if bytes.starts_with(b"OTTO") { "otf" } else { "ttf" };
    let ranges: Vec<String> = letters.iter().map(|letter| format!("U+{:X}", u32::from(*letter))).collect();
    let _ = write!(
        out,
        "@font-face{{font-family:'{}';font-weight:{};font-style:{slant};unicode-range:{};\
         src:url(data:font/{kind};base64,{})}}",
        typeface.family()[0],
        typeface.weight(),
        ranges.join(","),
        STANDARD.encode(bytes),
    );
}

/// The bytes of the face with these letters alone; nothing if it lacks what browsers ask for.
fn font(typeface: Typeface, letters: &BTreeSet<char>) -> Option<Vec<u8>> {
    let (whole, parsed) = (typeface.bytes(), typeface.parsed());
    let mut glyphs = GlyphRemapper::new();
    let mapped: Vec<(char, u16)> =
        letters.iter().filter_map(|letter| Some((*letter, glyphs.remap(parsed.glyph_index(*letter)?.0)))).collect();
    // What is made for pages in print lacks the map from letters to glyphs.
    let cut = subsetter::subset(whole, 0, &glyphs).ok()?;
    let cut = RawFace::parse(&cut, 0).ok()?;
    let own = cut.table_records.into_iter().filter_map(|record| Some((record.tag, cut.table(record.tag)?.to_vec())));
    let mut tables: Vec<(Tag, Vec<u8>)> = own.collect();
    let metrics = Tag::from_bytes(b"OS/2");
    tables.push((metrics, RawFace::parse(whole, 0).ok()?.table(metrics)?.to_vec()));
    tables.push((Tag::from_bytes(b"cmap"), map(&mapped)));
    tables.sort_by_key(|(tag, _)| *tag);
    let outlines = tables.iter().any(|(tag, _)| *tag == Tag::from_bytes(b"CFF "));
    Some(file(if outlines { *b"OTTO" } else { [0, 1, 0, 0] }, tables))
}

/// The table from letters to glyphs, in the format that has room for all letters (12 of the OpenType specification).
fn map(mapped: &[(char, u16)]) -> Vec<u8> {
    let mut table = Vec::new();
    let mut put = |bytes: &[u8]| table.extend_from_slice(bytes);
    // One table, for Windows and the whole of Unicode, 12 bytes from here.
    for word in [0_u16, 1, 3, 10] {
        put(&word.to_be_bytes());
    }
    put(&12_u32.to_be_bytes());
    put(&12_u16.to_be_bytes());
    put(&0_u16.to_be_bytes());
    for word in [16 + 12 * mapped.len() as u32, 0, mapped.len() as u32] {
        put(&word.to_be_bytes());
    }
    for (letter, glyph) in mapped {
        for word in [u32::from(*letter), u32::from(*letter), u32::from(*glyph)] {
            put(&word.to_be_bytes());
        }
    }
    table
}

/// Tables, in the order of their names, as a file with its directory and its sums.
fn file(kind: [u8; 4], mut tables: Vec<(Tag, Vec<u8>)>) -> Vec<u8> {
    let count = tables.len() as u16;
    let power = count.ilog2() as u16;
    let search = 16 << power;
    let mut bytes = kind.to_vec();
    for word in [count, search, power, count * 16 - search] {
        bytes.extend(word.to_be_bytes());
    }
    let mut offset = 12 + 16 * tables.len();
    let mut whole = None;
    for (tag, table) in &mut tables {
        if *tag == Tag::from_bytes(b"head") {
            // The sum of the whole file is not known yet, and counts as nothing in the table's own.
            table[8..12].fill(0);
            whole = Some(offset + 8);
        }
        let length = table.len();
        table.resize(length.next_multiple_of(4), 0);
        bytes.extend(tag.to_bytes());
        for word in [sum(table), offset as u32, length as u32] {
            bytes.extend(word.to_be_bytes());
        }
        offset += table.len();
    }
    for (_, table) in &tables {
        bytes.extend(table);
    }
    if let Some(at) = whole {
        let rest = 0xB1B0_AFBA_u32.wrapping_sub(sum(&bytes));
        bytes[at..at + 4].copy_from_slice(&rest.to_be_bytes());
    }
    bytes
}

/// The sum of all words of four bytes.
fn sum(bytes: &[u8]) -> u32 {
    let word = |bytes: &[u8]| bytes.iter().fold(0, |word, byte| word << 8 | u32::from(*byte));
    bytes.chunks_exact(4).map(word).fold(0, u32::wrapping_add)
}

#[cfg(test)]
mod tests {
    use raystep_figure::Face;

    use super::*;
    use crate::typefaces::MathFont;

    #[test]
    fn a_cut_face_shows_its_letters_as_the_whole_one_does() {
        let check = |typeface: Typeface, text: &str| {
            let letters: BTreeSet<char> = text.chars().collect();
            let bytes = font(typeface, &letters).unwrap();
            assert!(bytes.len() * 4 < typeface.bytes().len(), "{} bytes of {typeface:?}", bytes.len());
            let (cut, whole) = (ttf_parser::Face::parse(&bytes, 0).unwrap(), typeface.parsed());
            for letter in letters {
                let here = cut.glyph_index(letter).unwrap();
                let there = whole.glyph_index(letter).unwrap();
                assert_eq!(cut.glyph_hor_advance(here), whole.glyph_hor_advance(there), "{letter} of {typeface:?}");
                assert_eq!(cut.glyph_bounding_box(here), whole.glyph_bounding_box(there), "{letter} of {typeface:?}");
            }
            assert!(cut.glyph_index('§').is_none() && sum(&bytes) == 0xB1B0_AFBA);
        };
        for face in Face::ALL {
            check(Typeface::Text(face), "node 12 → t ≤ ∞");
        }
        for font in [MathFont::Main, MathFont::Variable] {
            check(Typeface::Math(font), "tx");
        }
    }
}
