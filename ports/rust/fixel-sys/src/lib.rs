// SPDX-License-Identifier: MIT
//! The C interface of Fixel, a fixed-point 3-D renderer for
//! microcontrollers: all records, constants and functions of its public headers, with their
//! documentation. The C library itself is in the crate, and the build compiles it for the target.
//!
//! The crate `fixel` is the safe interface.
//!
//! ```
//! // The sine of 30 degrees, in units of 2^-30: one half.
//! let sine = unsafe { fixel_sys::fxl_sin(0x1555_5555) };
//! assert!((sine - (1 << 29)).abs() <= 2);
//! ```
#![no_std]
#![allow(non_camel_case_types, non_snake_case, non_upper_case_globals)]
#![allow(rustdoc::all, clippy::all)]

mod bindings;

pub use bindings::*;
