//! Files and the standard output, written so that nothing is lost half-way.

use std::io::{ErrorKind, Write};
use std::path::Path;

use crate::fault::{Fault, about};
use crate::reading;

/// Reads a table, or a text of that size.
pub(crate) fn read(path: &Path) -> Result<Vec<u8>, Fault> {
    reading::read(path, reading::TABLE, &|| true).map_err(about(path))
}

/// Reads a mesh.
pub(crate) fn read_mesh(path: &Path) -> Result<Vec<u8>, Fault> {
    reading::read(path, reading::MESH, &|| true).map_err(about(path))
}

/// Writes a file under another name first: what was there stays until the new one is whole.
pub(crate) fn write(path: &Path, bytes: &[u8]) -> Result<(), Fault> {
    let mut name = path.file_name().unwrap_or_default().to_os_string();
    name.push(".part");
    let part = path.with_file_name(name);
    std::fs::write(&part, bytes).and_then(|()| std::fs::rename(&part, path)).map_err(about(path))
}

/// Makes a folder and those around it.
pub(crate) fn folder(path: &Path) -> Result<(), Fault> {
    std::fs::create_dir_all(path).map_err(about(path))
}

/// Writes to the standard output; a reader who has seen enough is no error.
pub(crate) fn print(text: &str) -> Result<(), Fault> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Fault::new(format!("standard output: {error}"))),
        _ => Ok(()),
    }
}
