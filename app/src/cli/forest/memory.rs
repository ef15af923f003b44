//! How much memory this program has taken.

/// The most that was resident so far, in bytes; nothing where the system does not say so in a file.
pub(super) fn most_resident() -> Option<u64> {
    peak(&std::fs::read_to_string("/proc/self/status").ok()?)
}

/// The line `VmHWM:    123456 kB`.
fn peak(status: &str) -> Option<u64> {
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kilobytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kilobytes * 1024)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_peak_is_read() {
        assert_eq!(peak("VmPeak:\t  900 kB\nVmHWM:\t  512 kB\nVmRSS:\t 100 kB\n"), Some(512 * 1024));
        assert_eq!(peak("VmRSS:\t 100 kB\n"), None);
        assert_eq!(peak("VmHWM:\t many kB\n"), None);
    }
}
