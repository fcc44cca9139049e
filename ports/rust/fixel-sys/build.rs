// SPDX-License-Identifier: MIT
//! Compiles the library for the target of the crate: its sources in C, and for an Arm core its kernels.

use std::{fs, io, path::{Path, PathBuf}};

/// The files of an extension in the rooms of the library.
fn sources(extension: &str) -> io::Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for room in fs::read_dir("c")?.collect::<io::Result<Vec<_>>>()? {
        if room.file_type()?.is_dir() {
            for file in fs::read_dir(room.path())?.collect::<io::Result<Vec<_>>>()? {
                if file.path().extension().is_some_and(|own| own == extension) {
                    found.push(file.path());
                }
            }
        }
    }
    found.sort();
    Ok(found)
}

fn main() -> io::Result<()> {
    let target = std::env::var("CARGO_CFG_TARGET_ARCH").unwrap_or_default();
    let mut build = cc::Build::new();
    build
        .files(sources("c")?)
        .file(Path::new("c/layouts.c"))
        .include("c")
        .std("c11")
        .flag_if_supported("-ffreestanding")
        .flag_if_supported("-ffunction-sections")
        .flag_if_supported("-fdata-sections");
    if target == "arm" {
        build.files(sources("S")?);
    }
    if std::env::var("OPT_LEVEL").is_ok_and(|level| level == "0" || level == "1") {
        build.opt_level(2); // a program that is debugged draws as fast
    }
    if std::env::var_os("CARGO_FEATURE_SMALL").is_some() {
        build.define("FXL_SMALL", None);
    }
    build.compile("fixel");
    println!("cargo::rerun-if-changed=c");
    Ok(())
}
