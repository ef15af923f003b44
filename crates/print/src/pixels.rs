//! Pixels inside an SVG file: a PNG as a data address.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use raystep_figure::Image;

/// The image as `data:image/png;base64,...`.
pub(crate) fn data_url(image: &Image) -> String {
    format!("data:image/png;base64,{}", STANDARD.encode(encoded(image)))
}

fn encoded(image: &Image) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, image.width, image.height);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    let written = encoder.write_header().and_then(|mut writer| writer.write_image_data(&image.rgba));
    // An image without pixels has no PNG: it is left out.
    if written.is_ok() { bytes } else { Vec::new() }
}
