// SPDX-License-Identifier: MIT
//! Fixel draws 3-D scenes on microcontrollers: integers only, no heap, and the same picture bit for
//! bit on every core. This crate is the safe interface to its C library.
//!
//! A [`Scene`] is a scene image, which `fixel build model.glb -o model.fxls` makes on the host, used
//! in place. A [`Renderer`] draws it, in memory of the caller's, with what the program attaches; a
//! [`Setup`] draws it with all that it has: textures, light, depth, motions. A [`Frame`] is one
//! picture, drawn whole or in strips. All borrow what they use, so nothing is copied and nothing can
//! be freed early.
//!
//! ```
//! use fixel::{degrees, include_image, target, units, Config, Pose, Renderer, Scene};
//!
//! static CUBE: &[u8] = include_image!("../examples/cube.fxls");
//!
//! fn main() -> Result<(), fixel::Error> {
//!     let scene = Scene::open(CUBE)?;
//!     let palette = scene.palette_565();
//!     let mut memory = [0_u64; 1024];
//!     let config = Config::new(160, 120).fov(degrees(60)).palette(&palette);
//!     let mut renderer = Renderer::<target::Rgb565>::new(&scene, config, &mut memory)?;
//!
//!     let mut pixels = [0_u16; 160 * 120];
//!     renderer.render(&scene.start(), &mut pixels)?;
//!     assert!(pixels.iter().any(|pixel| *pixel != pixels[0]));
//!
//!     // Without memory for a whole picture: in strips of 8 rows.
//!     let mut strip = [0_u16; 160 * 8];
//!     let mut frame = renderer.begin(&scene.start())?;
//!     for first in (0..120).step_by(8) {
//!         frame.draw_rows(&mut strip, first, 8)?; // then send the strip to the display
//!         assert_eq!(strip[..], pixels[160 * usize::from(first)..][..160 * 8]);
//!     }
//!     Ok(())
//! }
//! ```
//!
//! # Numbers
//!
//! World coordinates are integers in units of 1/65536 ([`units`], [`ratio`]), angles are binary: a full
//! turn is 2³² ([`degrees`]). x goes right, y up, z forward.
//!
//! # embedded-graphics
//!
//! [`Frame::strips`] is a [`Drawable`](embedded_graphics_core::Drawable), which any display of
//! embedded-graphics takes, and [`Picture`] is a [`DrawTarget`](embedded_graphics_core::draw_target::DrawTarget),
//! so that text and shapes can be drawn over the 3-D picture.
#![no_std]
#![warn(missing_docs)]

mod error;
mod frame;
mod graphics;
mod movable;
mod numbers;
mod renderer;
mod scene;
mod setup;
mod surfaces;
pub mod target;

pub use error::Error;
pub use fixel_sys as sys;
pub use frame::{Area, Counters, Frame, Picked};
pub use graphics::{Picture, Strips};
pub use movable::{Drawn, Instance, MovableScene, Placement};
pub use numbers::{degrees, ratio, rgb565, units, Orientation, Point, Pose};
pub use renderer::{Config, Renderer};
pub use scene::Scene;
pub use setup::{Setup, SetupError, SetupRecord};
pub use surfaces::{Light, LightSettings, LitSurfaces, SurfaceSet, Surfaces, Texture};

/// The version of the C library, as in `"0.9.0"`: that of the crate.
///
/// ```
/// assert_eq!(fixel::VERSION.split('.').count(), 3);
/// ```
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// The bytes of a file, aligned as [`Scene::open`] needs them: `include_bytes!` alone aligns nothing.
///
/// ```
/// static CUBE: &[u8] = fixel::include_image!("../examples/cube.fxls");
/// assert_eq!(CUBE.as_ptr() as usize % 8, 0);
/// ```
#[macro_export]
macro_rules! include_image {
    ($path:expr) => {{
        #[repr(C, align(8))]
        struct Aligned<Bytes: ?Sized>(Bytes);
        static ALIGNED: &Aligned<[u8]> = &Aligned(*include_bytes!($path));
        &ALIGNED.0
    }};
}
