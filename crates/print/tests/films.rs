//! Films: how many pictures, for how long, in which colours.

use std::collections::BTreeSet;
use std::io::Cursor;

use glam::Vec2;
use raystep_figure::{Figure, Ink, Role, Theme};
use raystep_print::{Apng, Frame, Gif, Manner, Tally, drawing, frame};

/// Discs in these roles on a page, one after the other, and a slanted line whose edges are blended.
fn picture(roles: &[Role], clear: bool) -> Frame {
    let mut figure = Figure::new(Vec2::new(90.0, 40.0));
    for (index, role) in roles.iter().enumerate() {
        let center = Vec2::new(15.0 + 30.0 * index as f32, 14.0);
        figure.add(*role, None, Ink::Circle { center, radius: 9.0 });
    }
    figure.add(Role::Ray, None, Ink::Line { points: vec![Vec2::new(3.0, 38.0), Vec2::new(87.0, 30.0)] });
    frame(&drawing(&figure, &Manner { clear, ..Manner::plain(&Theme::LIGHT) }), 1.0).unwrap()
}

/// A film's pictures: some roles come, some stay.
fn pictures(clear: bool) -> Vec<Frame> {
    [&[Role::Here][..], &[Role::Here, Role::Best], &[Role::Here, Role::Best, Role::Wrong]]
        .map(|roles| picture(roles, clear))
        .into()
}

fn gif(pictures: &[Frame]) -> Vec<u8> {
    let mut tally = Tally::new(&Theme::LIGHT);
    for picture in pictures {
        tally.add(picture).unwrap();
    }
    let mut gif = Gif::new(tally.palette().unwrap());
    pictures.iter().zip([900, 1800, 2700]).for_each(|(picture, millis)| gif.add(picture, millis).unwrap());
    gif.finish().unwrap()
}

#[test]
fn a_gif_keeps_the_colours_of_roles() {
    let bytes = gif(&pictures(false));
    assert_eq!(bytes, gif(&pictures(false)));
    let mut decoder = ::gif::DecodeOptions::new().read_info(Cursor::new(&bytes)).unwrap();
    let palette: BTreeSet<[u8; 3]> =
        decoder.global_palette().unwrap().chunks_exact(3).map(|rgb| [rgb[0], rgb[1], rgb[2]]).collect();
    for role in [Role::Here, Role::Best, Role::Wrong] {
        let color = Theme::LIGHT.style(role).stroke.unwrap().color;
        assert!(palette.contains(&[color.r, color.g, color.b]), "{role:?}");
    }
    let mut shown = Vec::new();
    while let Some(picture) = decoder.read_next_frame().unwrap() {
        assert!(picture.palette.is_none(), "each picture has the film's palette");
        shown.push((picture.delay, [picture.left, picture.width, picture.height]));
    }
    // After the first one, what has changed: the disc that came, 9 points and half a line around its middle.
    let [(90, [0, 90, 40]), (180, [34, 22, 22]), (270, [64, 22, 22])] = shown[..] else {
        panic!("{shown:?}");
    };
}

#[test]
fn a_clear_film_stays_clear() {
    let mut decoder = ::gif::DecodeOptions::new().read_info(Cursor::new(gif(&pictures(true)))).unwrap();
    while let Some(picture) = decoder.read_next_frame().unwrap() {
        assert_eq!(picture.transparent, Some(picture.buffer[0]), "the corner is clear");
        assert_eq!(picture.dispose, ::gif::DisposalMethod::Background);
    }
}

#[test]
fn an_apng_shows_every_picture_as_it_is() {
    let pictures = pictures(false);
    let mut film = Apng::new(3);
    pictures.iter().zip([900, 1800, 2700]).for_each(|(picture, millis)| film.add(picture.clone(), millis).unwrap());
    let bytes = film.finish().unwrap();
    let mut reader = png::Decoder::new(Cursor::new(&bytes)).read_info().unwrap();
    assert_eq!(reader.info().animation_control().unwrap().num_frames, 3);
    // Pictures lie over those before: together they are what was drawn.
    let mut page = vec![0; pictures[0].rgba.len()];
    for (picture, millis) in pictures.iter().zip([900, 1800, 2700]) {
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut pixels).unwrap();
        let control = *reader.info().frame_control().unwrap();
        assert_eq!((control.delay_num, control.delay_den), (millis, 1000));
        let row = control.width as usize * 4;
        for (y, part) in pixels.chunks_exact(row).take(control.height as usize).enumerate() {
            let at = ((control.y_offset as usize + y) * picture.width as usize + control.x_offset as usize) * 4;
            page[at..at + row].copy_from_slice(part);
        }
        assert_eq!(page, picture.rgba);
    }
    let mut film = Apng::new(2);
    film.add(pictures[0].clone(), 900).unwrap();
    assert!(film.finish().is_err(), "a picture is missing");
    assert!(Apng::new(0).finish().is_err());
}
