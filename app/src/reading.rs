//! Files are read up to a size: what has no end, or would fill the memory, gets a sentence.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// A mesh has at most so many bytes: about ten million triangles.
pub(crate) const MESH: u64 = 1 << 30;

/// A table has at most so many bytes, and so has what is no plain file and cannot say how long it is.
pub(crate) const TABLE: u64 = 1 << 28;

/// So many bytes are read between two looks at whether to go on.
const PART: u64 = 1 << 22;

/// Reads a file of at most `most` bytes, while `go_on` says so.
pub(crate) fn read(path: &Path, most: u64, go_on: &dyn Fn() -> bool) -> io::Result<Vec<u8>> {
    let file = File::open(path)?;
    let about = file.metadata()?;
    let most = if about.is_file() { most } else { most.min(TABLE) };
    let mut bytes = Vec::new();
    if about.is_file() && about.len() <= most {
        bytes.reserve_exact(about.len() as usize);
    }
    let mut more = !about.is_file() || about.len() <= most;
    while more {
        let before = bytes.len();
        (&file).take(PART).read_to_end(&mut bytes)?;
        if bytes.len() == before {
            return Ok(bytes);
        }
        more = bytes.len() as u64 <= most;
        if !go_on() {
            return Err(io::Error::other("reading was cancelled"));
        }
    }
    Err(io::Error::other(format!("there are more than {} MiB; no more is read", most >> 20)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(path: &str, most: u64) -> String {
        match read(Path::new(path), most, &|| true) {
            Ok(bytes) => format!("{} bytes", bytes.len()),
            Err(error) => error.to_string(),
        }
    }

    #[test]
    fn a_file_is_read_up_to_a_size() {
        let path = std::env::temp_dir().join(format!("raystep-reading-{}", std::process::id()));
        std::fs::write(&path, vec![b'v'; 3 << 20]).unwrap();
        let name = path.display().to_string();
        assert_eq!(said(&name, 3 << 20), "3145728 bytes");
        assert_eq!(said(&name, 2 << 20), "there are more than 2 MiB; no more is read");
        assert_eq!(read(&path, MESH, &|| false).unwrap_err().to_string(), "reading was cancelled");
        std::fs::remove_file(&path).unwrap();
        #[cfg(unix)]
        assert_eq!(said("/dev/zero", 5 << 20), "there are more than 5 MiB; no more is read");
    }
}
