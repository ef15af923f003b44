//! A display of a test's own, and the memory of its program.

use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};

/// The memory of this program, in KiB; 0 where the system does not say.
pub(crate) fn resident() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find(|line| line.starts_with("VmRSS"));
    line.and_then(|line| line.split_whitespace().nth(1)?.parse().ok()).unwrap_or(0)
}

/// A display of its own.
pub(crate) struct Display {
    server: Child,
    name: String,
}

impl Drop for Display {
    fn drop(&mut self) {
        let _ = self.server.kill();
        let _ = self.server.wait();
    }
}

impl Display {
    /// A display, where there is also something that draws; else it steps aside with a printed line, unless
    /// `RAYSTEP_REQUIRE_GPU=1`.
    pub(crate) fn or_step_aside() -> Option<Display> {
        let required = std::env::var("RAYSTEP_REQUIRE_GPU").as_deref() == Ok("1");
        let driver = raystep_paint::Headless::new().map_err(|none| none.to_string());
        let display = Display::new().ok_or_else(|| "there is no Xvfb".to_owned());
        match driver.and(display) {
            Ok(display) => Some(display),
            Err(none) => {
                assert!(!required, "{none}");
                println!("stepping aside: {none}");
                None
            }
        }
    }

    /// What `DISPLAY` is to be.
    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    fn new() -> Option<Display> {
        let mut server = Command::new("Xvfb");
        server.args(["-displayfd", "1", "-screen", "0", "1600x1000x24", "-nolisten", "tcp"]);
        let mut server = server.stdout(Stdio::piped()).stderr(Stdio::null()).spawn().ok()?;
        let mut line = String::new();
        BufReader::new(server.stdout.take()?).read_line(&mut line).ok()?;
        Some(Display { server, name: format!(":{}", line.trim()) })
    }
}
