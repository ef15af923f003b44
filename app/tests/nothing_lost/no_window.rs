//! No window can be opened.

use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};

use super::inputs::{TWINS, lessons, with_inputs};
use super::{raystep, said};

/// A screen of its own, without any window manager.
struct Screen {
    server: Child,
    display: String,
}

impl Screen {
    /// None where there is no such server.
    fn new() -> Option<Screen> {
        let arguments = ["-displayfd", "1", "-screen", "0", "1280x800x24", "-nolisten", "tcp"];
        let mut server =
            Command::new("Xvfb").args(arguments).stdout(Stdio::piped()).stderr(Stdio::null()).spawn().ok()?;
        let mut number = String::new();
        BufReader::new(server.stdout.take()?).read_line(&mut number).ok()?;
        Some(Screen { server, display: format!(":{}", number.trim()) })
    }
}

impl Drop for Screen {
    fn drop(&mut self) {
        let _ = self.server.kill();
        let _ = self.server.wait();
    }
}

#[test]
fn without_a_window_the_reason_is_a_sentence() {
    let folder = with_inputs("no-window");
    lessons(&folder, &TWINS, ["own", "b", "c"]);
    let screen = Screen::new();
    let no_driver = [
        ("VK_DRIVER_FILES", "/nowhere"),
        ("VK_ICD_FILENAMES", "/nowhere"),
        ("__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere"),
        ("LIBGL_DRIVERS_PATH", "/nowhere"),
    ];
    let mut cases = vec![(":4711".to_owned(), "no window can be opened: ")];
    match &screen {
        Some(screen) => {
            cases.push((screen.display.clone(), "no graphics driver answers that could draw on this display"));
        }
        None => println!("stepping aside: there is no Xvfb"),
    }
    for (display, says) in cases {
        let call = |arguments: &[&str]| {
            let mut command = raystep(&folder, arguments);
            command.env("DISPLAY", &display).envs(no_driver).env("XDG_CONFIG_HOME", &folder).output().unwrap()
        };
        let output = call(&["--lessons", "lessons", "--only"]);
        let said_of_page = said(&output);
        assert!(output.status.success() && said_of_page.contains(says), "{display}: {said_of_page}");
        assert!(
            !said_of_page.contains('{') && said_of_page.lines().all(|line| line.starts_with("raystep: ")),
            "{said_of_page}"
        );
        let output = call(&["square.obj"]);
        assert_eq!(output.status.code(), Some(2), "{}", said(&output));
        assert!(said(&output).contains("square.obj is not shown") && said(&output).contains(says), "{}", said(&output));
    }
}
