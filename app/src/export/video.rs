//! Videos, written by ffmpeg where it is installed.

use std::io::{Read, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, Command, Stdio};

use super::film::{Film, turns};
use super::{Format, Order};
use crate::fault::Fault;

/// The program.
const FFMPEG: &str = "ffmpeg";

/// Programs skip in a film with few pictures a second, and WebM forgets how long the last one stays; what repeats costs
/// next to nothing. A cropped picture may have an odd side.
const FILTERS: &str = "pad=ceil(iw/2)*2:ceil(ih/2)*2,fps=25,scale=out_color_matrix=bt709:out_range=tv";

/// Which colours its numbers mean: otherwise programs guess, by how large the picture is.
const COLORS: [&str; 8] =
    ["-color_range", "tv", "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709"];

/// Whether the program lies where programs are looked for.
pub(crate) fn has_ffmpeg() -> bool {
    let names = [FFMPEG.to_owned(), format!("{FFMPEG}{}", std::env::consts::EXE_SUFFIX)];
    let folders = std::env::var_os("PATH").unwrap_or_default();
    std::env::split_paths(&folders).any(|folder| names.iter().any(|name| folder.join(name).is_file()))
}

/// Whether a video can be written, before anything is drawn.
pub(super) fn ready(order: &Order) -> Result<(), Fault> {
    if !order.format.is_video() {
        return Ok(());
    }
    let ending = order.format.ending();
    if order.clear {
        return Err(Fault::new(format!(
            "a video has a ground: --transparent is for png, svg, pdf, apng and gif, not {ending}"
        )));
    }
    if !order.size.is_even() {
        return Err(Fault::new(format!(
            "--size {}: a video has an even number of pixels in both directions",
            order.size
        )));
    }
    let mut command = Command::new(FFMPEG);
    command.arg("-version").stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    match command.status() {
        Ok(status) if status.success() => Ok(()),
        _ => Err(Fault::new(format!(
            "--format {ending} is written by {FFMPEG}, which was not found on this machine: install it, or write \
             --format gif or apng"
        ))),
    }
}

/// Writes a video to a path, whatever stands there.
pub(super) fn write(film: &Film<'_>, order: &Order, path: &Path) -> Result<(), Fault> {
    let mut encoder: Option<Encoder> = None;
    let written = film.each(|index, frame| {
        let encoder = match &mut encoder {
            Some(encoder) => encoder,
            None => encoder.insert(Encoder::start([frame.width, frame.height], order, path)?),
        };
        let pixels = frame.rgb(order.theme);
        // A picture that stays is there more than once.
        (0..turns(film, index)).try_for_each(|_| encoder.add(&pixels))
    });
    match encoder {
        Some(encoder) => encoder.end(written),
        None => written,
    }
}

/// A running ffmpeg.
struct Encoder {
    child: Child,
    pixels: Option<ChildStdin>,
}

impl Encoder {
    fn start([width, height]: [u32; 2], order: &Order, path: &Path) -> Result<Encoder, Fault> {
        let mut command = Command::new(FFMPEG);
        command.args(["-loglevel", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgb24"]);
        command.args(["-video_size", &format!("{width}x{height}"), "-framerate", &format!("1000/{}", order.delay)]);
        command.args(["-i", "-", "-vf", FILTERS]).args(COLORS);
        // Nothing in the file tells when it was written, or by whom.
        command.args(["-map_metadata", "-1", "-fflags", "+bitexact", "-flags:v", "+bitexact", "-pix_fmt", "yuv420p"]);
        command.args(match order.format {
            Format::Webm => &["-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-f", "webm"][..],
            _ => &["-c:v", "libx264", "-crf", "18", "-movflags", "+faststart", "-f", "mp4"][..],
        });
        command.arg(path).stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::piped());
        let mut child = command.spawn().map_err(|error| Fault::new(format!("{FFMPEG}: {error}")))?;
        let pixels = child.stdin.take();
        Ok(Encoder { child, pixels })
    }

    /// Where it has ended already, what it said is told later.
    fn add(&mut self, pixels: &[u8]) -> Result<(), Fault> {
        let written = self.pixels.as_mut().map(|pipe| pipe.write_all(pixels));
        match written {
            Some(Err(error)) => Err(Fault::new(format!("{FFMPEG}: {error}"))),
            _ => Ok(()),
        }
    }

    /// Waits until the file is whole; what was not written to the end is given up.
    fn end(mut self, written: Result<(), Fault>) -> Result<(), Fault> {
        if written.is_err() && self.child.try_wait().is_ok_and(|ended| ended.is_none()) {
            let _ = self.child.kill();
        }
        drop(self.pixels.take());
        let mut said = String::new();
        if let Some(mut errors) = self.child.stderr.take() {
            let _ = errors.read_to_string(&mut said);
        }
        let status = self.child.wait().map_err(|error| Fault::new(format!("{FFMPEG}: {error}")))?;
        match said.lines().next() {
            Some(line) if !status.success() => Err(Fault::new(format!("{FFMPEG}: {line}"))),
            _ if status.success() || written.is_err() => written,
            _ => Err(Fault::new(format!("{FFMPEG} ended without a word"))),
        }
    }
}
