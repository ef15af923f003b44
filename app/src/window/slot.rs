//! In which file a window keeps where it stands: each that is open in one of its own.

use std::fs::{File, OpenOptions, TryLockError};
use std::path::{Path, PathBuf};

/// A file that no other open window keeps its place in.
pub(super) struct Slot {
    /// The file.
    pub(super) file: PathBuf,
    /// Locked as long as this lives, whatever ends the program; nothing where the system knows no locks.
    pub(super) lock: Option<File>,
}

/// So many windows are told apart; further ones share a file.
const MOST: usize = 16;

impl Slot {
    /// The first in a folder that is free: `last.toml`, then `last-2.toml`, and so on.
    pub(super) fn free(folder: &Path) -> Slot {
        // What cannot be written is told when it is.
        let _ = std::fs::create_dir_all(folder);
        let names = (1..=MOST).map(|place| if place == 1 { "last".to_owned() } else { format!("last-{place}") });
        for name in names {
            let file = folder.join(format!("{name}.toml"));
            let lock = folder.join(format!("{name}.lock"));
            let opened = OpenOptions::new().write(true).create(true).truncate(false).open(lock);
            match opened.map(|lock| (lock.try_lock(), lock)) {
                Ok((Ok(()), lock)) => return Slot { file, lock: Some(lock) },
                Ok((Err(TryLockError::WouldBlock), _)) => {}
                Ok((Err(TryLockError::Error(_)), _)) | Err(_) => break,
            }
        }
        Slot { file: folder.join("last.toml"), lock: None }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_open_window_has_a_file_of_its_own() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path().join("deep");
        let name = |slot: &Slot| slot.file.file_name().unwrap().to_str().unwrap().to_owned();
        let [first, second, third] = [(); 3].map(|()| Slot::free(&folder));
        assert_eq!([&first, &second, &third].map(name), ["last.toml", "last-2.toml", "last-3.toml"]);
        assert!([&first, &second, &third].iter().all(|slot| slot.lock.is_some()));
        drop((first, third));
        let [next, after] = [(); 2].map(|()| Slot::free(&folder));
        assert_eq!([&next, &after].map(name), ["last.toml", "last-3.toml"]);
        drop(second);
        // Where nothing can be written, nothing is told apart.
        let nowhere = Slot::free(&folder.join("last.lock/inside"));
        assert!(nowhere.lock.is_none() && name(&nowhere) == "last.toml");
    }
}
