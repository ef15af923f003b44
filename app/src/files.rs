//! Files, the standard output and the standard error: nothing is lost half-way, and nothing is destroyed that was not
//! meant.

use std::collections::BTreeSet;
use std::fs::{File, FileType, Metadata};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use tempfile::{Builder, NamedTempFile, TempDir};

use crate::fault::{Fault, about};
use crate::reading;

/// Reads a table, or a text of that size.
pub(crate) fn read(path: &Path) -> Result<Vec<u8>, Fault> {
    no_device(path)?;
    reading::read(path, reading::TABLE, &|| true).map_err(about(path))
}

/// Reads a mesh.
pub(crate) fn read_mesh(path: &Path) -> Result<Vec<u8>, Fault> {
    no_device(path)?;
    reading::read(path, reading::MESH, &|| true).map_err(about(path))
}

/// A device may never end.
fn no_device(path: &Path) -> Result<(), Fault> {
    let kind = std::fs::metadata(path).map_err(about(path))?.file_type();
    if is_device(kind) {
        return Err(Fault::new(format!("{}: it is a device; a file is needed", path.display())));
    }
    Ok(())
}

/// Refuses to write where something stands that must not be replaced: anything but a plain file, a file that is
/// write-protected, or one of those that are `read`. The sentence says what to do instead.
pub(crate) fn may_write(path: &Path, read: &[&Path]) -> Result<(), Fault> {
    old(path)?;
    match read.iter().find(|other| is_same(path, other)) {
        None => Ok(()),
        Some(_) => Err(refused(path, "this file is read: write to another one")),
    }
}

/// Writes a file under another name first: what was there stays until the new one is whole, and whatever happens
/// no part of it is left.
pub(crate) fn write(path: &Path, bytes: &[u8]) -> Result<(), Fault> {
    let old = old(path)?;
    let mut part = Part::beside(path)?;
    part.fill(bytes, old.as_ref()).map_err(about(path))?;
    if old.is_some() {
        // What was there may go only when the new file has reached the disk.
        part.file.as_file().sync_all().map_err(about(path))?;
    }
    part.put(path)
}

/// The same for a file that another program fills, under the name that it is given.
pub(crate) fn fill(path: &Path, fill: impl FnOnce(&Path) -> Result<(), Fault>) -> Result<(), Fault> {
    let old = old(path)?;
    let part = Part::beside(path)?;
    fill(part.file.path())?;
    if let Some(old) = &old {
        keep_owner(part.file.as_file(), old);
        part.file.as_file().set_permissions(old.permissions()).map_err(about(path))?;
        part.file.as_file().sync_all().map_err(about(path))?;
    }
    part.put(path)
}

/// Puts a small file of the program's own in its place, in its folder if there is none yet. It is whole at any moment,
/// but after a power cut it may be the one before.
pub(crate) fn renew(path: &Path, text: &str) -> Result<(), Fault> {
    // Where the user has put a link instead, the file stays where the user keeps it.
    let path = &std::fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
    folder(around(path))?;
    let old = old(path)?;
    let mut part = Part::beside(path)?;
    part.fill(text.as_bytes(), old.as_ref()).map_err(about(path))?;
    part.put(path)
}

/// Makes a folder and those around it.
pub(crate) fn folder(path: &Path) -> Result<(), Fault> {
    match std::fs::metadata(path) {
        Ok(known) if !known.is_dir() => Err(refused(path, "it is no folder: name another one")),
        _ => std::fs::create_dir_all(path).map_err(about(path)),
    }
}

/// Writes to the standard output; a reader who has seen enough is no error.
pub(crate) fn print(text: &str) -> Result<(), Fault> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(about(Path::new("standard output"))(error)),
        _ => Ok(()),
    }
}

/// Says something beside the output. Nobody may be listening; that is no reason to break off.
pub(crate) fn tell(text: &str) {
    let mut out = std::io::stderr().lock();
    let _ = out.write_all(text.as_bytes()).and_then(|()| out.write_all(b"\n")).and_then(|()| out.flush());
}

/// A sentence of Raystep's own beside the output.
pub(crate) fn say(sentence: &str) {
    tell(&format!("raystep: {sentence}"));
}

/// What stands at a path, if it may be replaced; nothing stands there if it is new.
fn old(path: &Path) -> Result<Option<Metadata>, Fault> {
    let known = match std::fs::symlink_metadata(path) {
        Ok(known) => known,
        Err(error) if error.kind() == ErrorKind::NotFound => {
            let around = around(path);
            let missing = || Fault::new(format!("{}: there is no folder {}", path.display(), around.display()));
            return if around.is_dir() { Ok(None) } else { Err(missing()) };
        }
        Err(error) => return Err(about(path)(error)),
    };
    let kind = known.file_type();
    if kind.is_symlink() {
        let to = std::fs::read_link(path).map_err(about(path))?;
        return Err(refused(path, &format!("it is a link to {}: name the file itself", to.display())));
    }
    if kind.is_dir() {
        return Err(refused(path, "it is a folder: name a file"));
    }
    if !kind.is_file() {
        return Err(refused(path, "it is no plain file: leave it out and send the standard output there"));
    }
    // Opening it asks the system about everything that forbids to write; root may write where a mode says no.
    let protected = || refused(path, "it is write-protected: name another file, or allow writing");
    if known.permissions().readonly() {
        return Err(protected());
    }
    match File::options().write(true).open(path) {
        Ok(_) => Ok(Some(known)),
        Err(error) if error.kind() == ErrorKind::PermissionDenied => Err(protected()),
        Err(error) => Err(about(path)(error)),
    }
}

fn refused(path: &Path, why: &str) -> Fault {
    Fault::new(format!("{}: nothing is written there, since {why}", path.display()))
}

/// The folder that a path lies in.
fn around(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Whether both paths lead to one file, by whatever names.
fn is_same(a: &Path, b: &Path) -> bool {
    let real = |path: &Path| std::fs::canonicalize(path).ok();
    real(a).is_some_and(|a| real(b) == Some(a)) || is_same_inode(a, b)
}

#[cfg(unix)]
fn is_same_inode(a: &Path, b: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let inode = |path: &Path| std::fs::metadata(path).ok().map(|known| (known.dev(), known.ino()));
    inode(a).is_some_and(|a| inode(b) == Some(a))
}

#[cfg(not(unix))]
fn is_same_inode(_: &Path, _: &Path) -> bool {
    false
}

#[cfg(unix)]
fn is_device(kind: FileType) -> bool {
    use std::os::unix::fs::FileTypeExt;
    kind.is_char_device() || kind.is_block_device()
}

#[cfg(not(unix))]
fn is_device(_: FileType) -> bool {
    false
}

/// What is being written and not whole yet.
static UNDERWAY: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

fn underway() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    UNDERWAY.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Whether a file was written to its end.
static WHOLE: AtomicBool = AtomicBool::new(false);

/// Ends the program because it was told to, and says what became of its files.
pub(crate) fn stop(code: i32) -> ! {
    let left = if WHOLE.load(Ordering::Relaxed) { "what was finished by then is whole" } else { "no file was written" };
    say(&format!("stopped; {left}"));
    end(code)
}

/// Ends the program at once: what is not whole is removed first, and nothing is begun any more.
pub(crate) fn end(code: i32) -> ! {
    let underway = underway();
    for path in underway.iter() {
        let _ = if path.is_dir() { std::fs::remove_dir_all(path) } else { std::fs::remove_file(path) };
    }
    std::process::exit(code)
}

/// The name of something that is not whole yet.
struct Listed(PathBuf);

impl Drop for Listed {
    fn drop(&mut self) {
        underway().remove(&self.0);
    }
}

/// A file under a name that nobody else uses; it is removed unless it is put in its place.
struct Part {
    file: NamedTempFile,
    _listed: Listed,
}

impl Part {
    fn beside(path: &Path) -> Result<Part, Fault> {
        let mut underway = underway();
        let file = parts(0o666).tempfile_in(around(path)).map_err(about(path))?;
        underway.insert(file.path().to_path_buf());
        let _listed = Listed(file.path().to_path_buf());
        Ok(Part { file, _listed })
    }

    /// Writes all of it, with the owner and the permissions of the file that it replaces.
    fn fill(&mut self, bytes: &[u8], old: Option<&Metadata>) -> std::io::Result<()> {
        self.file.write_all(bytes)?;
        self.file.flush()?;
        if let Some(old) = old {
            keep_owner(self.file.as_file(), old);
            self.file.as_file().set_permissions(old.permissions())?;
        }
        Ok(())
    }

    /// Gives it its name; what had that name is gone.
    fn put(self, path: &Path) -> Result<(), Fault> {
        let _nobody_ends = underway();
        self.file.persist(path).map_err(|error| about(path)(error.error))?;
        WHOLE.store(true, Ordering::Relaxed);
        Ok(())
    }
}

/// Hidden names of which none comes twice, open to whom the user's mask allows.
#[cfg(unix)]
fn parts(mode: u32) -> Builder<'static, 'static> {
    use std::os::unix::fs::PermissionsExt;
    let mut builder = Builder::new();
    builder.prefix(".raystep-").suffix(".part").permissions(std::fs::Permissions::from_mode(mode));
    builder
}

#[cfg(not(unix))]
fn parts(_: u32) -> Builder<'static, 'static> {
    let mut builder = Builder::new();
    builder.prefix(".raystep-").suffix(".part");
    builder
}

/// Only root can give a file away; for everybody else it is their own already, or stays so.
#[cfg(unix)]
fn keep_owner(file: &File, old: &Metadata) {
    use std::os::unix::fs::{MetadataExt, fchown};
    if file.metadata().is_ok_and(|own| (own.uid(), own.gid()) != (old.uid(), old.gid())) {
        let _ = fchown(file, Some(old.uid()), Some(old.gid()));
    }
}

#[cfg(not(unix))]
fn keep_owner(_: &File, _: &Metadata) {}

/// Fills a folder under another name first: what stood at `path` stays until the new one is whole. It must hold
/// nothing but files for which `own` is true.
pub(crate) fn whole_folder(
    path: &Path,
    own: &dyn Fn(&str) -> bool,
    fill: impl FnOnce(&Path) -> Result<(), Fault>,
) -> Result<(), Fault> {
    let old = holds_only(path, own)?;
    let fresh = {
        let mut underway = underway();
        let fresh = parts(0o777).tempdir_in(around(path)).map_err(about(path))?;
        underway.insert(fresh.path().to_path_buf());
        fresh
    };
    let _listed = Listed(fresh.path().to_path_buf());
    fill(fresh.path())?;
    // Somebody may have put something there in the meantime.
    holds_only(path, own)?;
    let _nobody_ends = underway();
    let aside: Option<TempDir> =
        if old { Some(parts(0o777).tempdir_in(around(path)).map_err(about(path))?) } else { None };
    let aside = aside.map(|folder| (folder.path().join("old"), folder));
    if let Some((aside, _)) = &aside {
        std::fs::rename(path, aside).map_err(about(path))?;
    }
    match std::fs::rename(fresh.path(), path) {
        Ok(()) => {
            // It has another name now: nothing is left to be removed.
            let _ = fresh.keep();
            Ok(())
        }
        Err(error) => {
            if let Some((aside, _)) = &aside {
                let _ = std::fs::rename(aside, path);
            }
            Err(about(path)(error))
        }
    }
}

/// Whether a folder stands there; it must hold such files alone.
fn holds_only(path: &Path, own: &dyn Fn(&str) -> bool) -> Result<bool, Fault> {
    match std::fs::symlink_metadata(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(false),
        Err(error) => return Err(about(path)(error)),
        Ok(known) if !known.is_dir() => return Err(refused(path, "it is no folder: move it away")),
        Ok(_) => {}
    }
    for entry in std::fs::read_dir(path).map_err(about(path))? {
        let entry = entry.map_err(about(path))?;
        let plain = entry.file_type().is_ok_and(|kind| kind.is_file());
        if !plain || !entry.file_name().to_str().is_some_and(own) {
            let name = entry.file_name();
            return Err(refused(path, &format!("{} lies in it, which would be lost: move it away", name.display())));
        }
    }
    Ok(true)
}
