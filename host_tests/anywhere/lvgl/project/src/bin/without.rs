// SPDX-License-Identifier: MIT
use lightvgl_sys as _; // which links LVGL, and the C files with it

unsafe extern "C" {
    fn run_dashboard_without();
}

fn main() {
    // SAFETY: the function takes nothing, and is called once.
    unsafe { run_dashboard_without() }
}
