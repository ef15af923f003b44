//! `raystep doctor`: what a window needs, what was found, what to do.

use std::path::Path;

use crate::fault::Fault;
use crate::files;

/// Libraries that a window loads when it opens, with the Debian packages that hold them.
const LIBRARIES: [(&str, &str); 7] = [
    ("libvulkan.so.1", "libvulkan1"),
    ("libEGL.so.1", "libegl1"),
    ("libxkbcommon-x11.so.0", "libxkbcommon-x11-0"),
    ("libX11-xcb.so.1", "libx11-xcb1"),
    ("libXcursor.so.1", "libxcursor1"),
    ("libXi.so.6", "libxi6"),
    ("libwayland-client.so.0", "libwayland-client0"),
];

/// Folders in which the loader looks, beside those of its cache.
const FOLDERS: [&str; 5] =
    ["/usr/lib", "/usr/lib64", "/lib", "/usr/lib/x86_64-linux-gnu", "/usr/lib/aarch64-linux-gnu"];

/// Says what was found.
pub(crate) fn run() -> Result<(), Fault> {
    let mut report = Report::default();
    report.displays();
    report.adapters();
    if cfg!(target_os = "linux") {
        report.libraries();
    }
    report.text.push_str(
        "\nwithout a window\n  raystep export and raystep trace need neither display nor driver: they always work\n",
    );
    report.text.push_str("\nwhat to do\n");
    if report.advice.is_empty() {
        report.advice.push("nothing: run raystep".to_owned());
    }
    for advice in std::mem::take(&mut report.advice) {
        report.line(&advice);
    }
    files::print(&report.text)
}

/// Whether a window could open somewhere.
pub(crate) fn has_display() -> bool {
    let set = |name: &str| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    !cfg!(target_os = "linux") || set("DISPLAY") || set("WAYLAND_DISPLAY")
}

#[derive(Default)]
struct Report {
    text: String,
    advice: Vec<String>,
}

impl Report {
    fn line(&mut self, text: &str) {
        self.text.push_str("  ");
        self.text.push_str(text);
        self.text.push('\n');
    }

    fn displays(&mut self) {
        self.text.push_str("display\n");
        for name in ["DISPLAY", "WAYLAND_DISPLAY", "XDG_SESSION_TYPE", "XDG_RUNTIME_DIR"] {
            let value = std::env::var(name).unwrap_or_default();
            let shown = if value.is_empty() { "not set" } else { &value };
            self.line(&format!("{name:<18} {shown}"));
        }
        if !has_display() {
            let say = "no display: start from a graphical session, or with `xvfb-run raystep`; without one, raystep \
                       writes the lecture as a page to read in a browser";
            self.advice.push(say.to_owned());
        }
    }

    fn adapters(&mut self) {
        self.text.push_str("\nadapters\n");
        for name in ["VK_DRIVER_FILES", "VK_ICD_FILENAMES", "WGPU_BACKEND"] {
            if let Ok(value) = std::env::var(name) {
                self.line(&format!("{name} = {value}"));
            }
        }
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle_from_env());
        let adapters = pollster::block_on(instance.enumerate_adapters(wgpu::Backends::all()));
        for adapter in &adapters {
            let info = adapter.get_info();
            self.line(&format!(
                "{} · {:?} · {:?} · driver {} {}",
                info.name, info.backend, info.device_type, info.driver, info.driver_info
            ));
        }
        if adapters.is_empty() {
            self.line("none found");
            let say = "no adapter: install the driver of the graphics card; software rendering does too (Debian: apt \
                       install mesa-vulkan-drivers libvulkan1)";
            self.advice.push(say.to_owned());
        } else if adapters.iter().all(|adapter| adapter.get_info().device_type == wgpu::DeviceType::Cpu) {
            self.advice
                .push("only software rendering was found: the window works, large scenes turn slowly".to_owned());
        }
    }

    fn libraries(&mut self) {
        self.text.push_str("\nlibraries\n");
        let cached = std::process::Command::new("ldconfig").arg("-p").output();
        let cached = cached.map(|output| String::from_utf8_lossy(&output.stdout).into_owned()).unwrap_or_default();
        let mut missing = Vec::new();
        for (library, package) in LIBRARIES {
            let found = cached.contains(library) || FOLDERS.iter().any(|at| Path::new(at).join(library).exists());
            self.line(&format!("{library:<24} {}", if found { "found" } else { "missing" }));
            if !found {
                missing.push(package);
            }
        }
        if !missing.is_empty() {
            self.advice.push(format!("missing libraries (Debian: apt install {})", missing.join(" ")));
        }
    }
}
