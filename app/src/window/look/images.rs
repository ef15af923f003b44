//! Images of figures as textures, each uploaded once.

use std::collections::HashMap;
use std::hash::{DefaultHasher, Hash, Hasher};

use egui::{ColorImage, Context, Id, TextureHandle, TextureOptions};
use raystep_figure::Image;

/// The most images kept.
const MOST: usize = 24;

/// All images that were shown, by their pixels.
#[derive(Clone, Default)]
struct Uploaded(HashMap<u64, TextureHandle>);

/// The texture of an image. Its pixels stay squares where they are stretched.
pub(super) fn texture(context: &Context, image: &Image) -> TextureHandle {
    let mut hasher = DefaultHasher::new();
    (image.width, image.height, &image.rgba).hash(&mut hasher);
    let (key, id) = (hasher.finish(), Id::unique("images of figures"));
    let known = context.data(|data| data.get_temp::<Uploaded>(id).unwrap_or_default());
    if let Some(texture) = known.0.get(&key) {
        return texture.clone();
    }
    let size = [image.width as usize, image.height as usize];
    let pixels = ColorImage::from_rgba_unmultiplied(size, &image.rgba);
    let texture = context.load_texture("image", pixels, TextureOptions::NEAREST);
    context.data_mut(|data| {
        let kept = data.get_temp_mut_or_default::<Uploaded>(id);
        if kept.0.len() >= MOST {
            kept.0.clear();
        }
        kept.0.insert(key, texture.clone());
    });
    texture
}
