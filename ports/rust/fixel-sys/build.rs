// SPDX-License-Identifier: MIT
//! Compiles fixel.c, the whole library in one file, for the target of the crate.

fn main() {
    let mut build = cc::Build::new();
    build
        .files(["c/fixel.c", "c/layouts.c"])
        .include("c")
        .std("c11")
        .flag_if_supported("-ffreestanding")
        .flag_if_supported("-ffunction-sections")
        .flag_if_supported("-fdata-sections");
    if std::env::var_os("CARGO_FEATURE_SMALL").is_some() {
        build.define("FXL_SMALL", None);
    }
    build.compile("fixel");
    println!("cargo::rerun-if-changed=c");
}
