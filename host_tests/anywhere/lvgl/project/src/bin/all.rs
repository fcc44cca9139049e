// SPDX-License-Identifier: MIT
use lightvgl_sys as _; // which links LVGL, and the C files with it

unsafe extern "C" {
    fn run_all_tests();
}

fn main() {
    // SAFETY: the function takes nothing, and is called once.
    unsafe { run_all_tests() }
}
