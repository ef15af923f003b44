//! Images of figures as textures, each uploaded once.

use std::collections::HashMap;
use std::sync::Arc;

use egui::{ColorImage, Context, Id, TextureHandle, TextureOptions};
use raystep_figure::Image;

/// The most images kept.
const MOST: usize = 24;

/// All images that were shown, by where their pixels lie: these are kept, so that no others come to lie there.
#[derive(Clone, Default)]
struct Uploaded(HashMap<(usize, u32), Known>);

/// The pixels of an image, and its texture.
type Known = (Arc<[u8]>, TextureHandle);

/// The texture of an image. Its pixels stay squares where they are stretched.
pub(super) fn texture(context: &Context, image: &Image) -> TextureHandle {
    let key = (image.rgba.as_ptr() as usize, image.width);
    let id = Id::unique("images of figures");
    let known = context.data_mut(|data| {
        let kept = data.get_temp_mut_or_default::<Uploaded>(id);
        kept.0.get(&key).map(|(_, texture)| texture.clone())
    });
    if let Some(texture) = known {
        return texture;
    }
    let size = [image.width as usize, image.height as usize];
    let pixels = ColorImage::from_rgba_unmultiplied(size, &image.rgba);
    let texture = context.load_texture("image", pixels, TextureOptions::NEAREST);
    context.data_mut(|data| {
        let kept = data.get_temp_mut_or_default::<Uploaded>(id);
        if kept.0.len() >= MOST {
            kept.0.clear();
        }
        kept.0.insert(key, (image.rgba.clone(), texture.clone()));
    });
    texture
}
