//! Embree takes part where Debian's libembree-dev is installed.

use std::path::Path;

fn main() {
    println!("cargo:rerun-if-changed=src/peers/embree.c");
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rustc-check-cfg=cfg(embree)");
    println!("cargo:rerun-if-changed=/usr/include/embree3/rtcore.h");
    if !Path::new("/usr/include/embree3/rtcore.h").exists() {
        println!("cargo:warning=Embree is not installed (Debian: libembree-dev): it does not take part");
        return;
    }
    cc::Build::new().file("src/peers/embree.c").flag_if_supported("-march=native").opt_level(3).compile("race");
    println!("cargo:rustc-link-lib=embree3");
    println!("cargo:rustc-cfg=embree");
}
