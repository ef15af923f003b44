//! Formulas as pictures: set once by `print`, kept as textures.

use std::collections::HashMap;

use egui::{ColorImage, Image, TextureHandle, TextureOptions, Ui, Vec2, vec2};
use raystep_figure::Color;
use raystep_print::{extent, formula};

/// The most formulas kept.
const MOST: usize = 256;

/// A formula at a size and colour, in pixels of this display.
#[derive(PartialEq, Eq, Hash)]
struct Key {
    tex: String,
    size: u32,
    color: Color,
    pixels: u32,
}

/// All formulas that were shown.
#[derive(Default)]
pub(crate) struct Formulas {
    pictures: HashMap<Key, Option<TextureHandle>>,
    /// How wide and high each is with letters of size 1.
    extents: HashMap<String, Vec2>,
}

impl Formulas {
    /// Shows a formula with letters of this size, smaller if there is no room for it.
    pub(crate) fn show(&mut self, ui: &mut Ui, tex: &str, size: f32, color: Color) {
        let room = ui.available_width();
        let width = self.extent(tex).x * size;
        let size = if width > room { size * room / width } else { size };
        match self.picture(ui, tex, size, color) {
            Some((texture, size)) => {
                ui.add(Image::new((texture.id(), size)).alt_text(tex));
            }
            None => {
                ui.label(tex);
            }
        }
    }

    /// How high a formula is with letters of this size, smaller if there is no room for it.
    pub(crate) fn height(&mut self, tex: &str, size: f32, room: f32) -> f32 {
        let extent = self.extent(tex);
        extent.y * size.min(room / extent.x.max(1e-6))
    }

    /// Lets go of all pictures: they lie on a device that is gone.
    pub(crate) fn clear(&mut self) {
        self.pictures.clear();
    }

    /// How wide and high a formula is with letters of size 1.
    fn extent(&mut self, tex: &str) -> Vec2 {
        if let Some(extent) = self.extents.get(tex) {
            return *extent;
        }
        if self.extents.len() > MOST {
            self.extents.clear();
        }
        let extent = extent(tex, 1.0);
        let extent = vec2(extent.width, extent.height + extent.depth);
        self.extents.insert(tex.to_owned(), extent);
        extent
    }

    /// The picture of a formula and its size in points.
    pub(crate) fn picture(&mut self, ui: &Ui, tex: &str, size: f32, color: Color) -> Option<(&TextureHandle, Vec2)> {
        if self.pictures.len() > MOST {
            self.pictures.clear();
        }
        let scale = ui.ctx().pixels_per_point();
        let key = Key { tex: tex.to_owned(), size: (size * 16.0) as u32, color, pixels: (scale * 64.0) as u32 };
        let context = ui.ctx().clone();
        let texture = self.pictures.entry(key).or_insert_with(|| {
            let bytes = raystep_print::png(&formula(tex, size, color), scale).ok()?;
            Some(context.load_texture(tex, decoded(&bytes)?, TextureOptions::LINEAR))
        });
        let texture = texture.as_ref()?;
        let [width, height] = texture.size();
        Some((texture, vec2(width as f32, height as f32) / scale))
    }
}

/// The pixels of a PNG file with straight alpha.
pub(crate) fn decoded(bytes: &[u8]) -> Option<ColorImage> {
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().ok()?;
    let mut pixels = vec![0; reader.output_buffer_size()?];
    let info = reader.next_frame(&mut pixels).ok()?;
    pixels.truncate(info.buffer_size());
    let size = [info.width as usize, info.height as usize];
    (info.color_type == png::ColorType::Rgba).then(|| ColorImage::from_rgba_unmultiplied(size, &pixels))
}
