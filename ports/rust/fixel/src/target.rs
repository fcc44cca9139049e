// SPDX-License-Identifier: MIT
//! What a renderer draws: the format of its pixels, and whether it has a depth buffer. A program links only
//! the targets that it names.
//!
//! ```
//! use fixel::target::{Rgb565Depth16, Target};
//!
//! // 64-bit words of a depth buffer for 8 rows of 320 pixels; more rows are drawn in parts.
//! const DEPTH: usize = Rgb565Depth16::depth_words(320, 8);
//! assert_eq!(DEPTH, 641);
//! assert_eq!(Rgb565Depth16::DEPTH_BITS, 16);
//! ```

use fixel_sys as sys;

mod sealed {
    pub trait Sealed {}
}

// place pixel-format: a target of it in Rust
/// A target. Only the types of this module are targets.
pub trait Target: sealed::Sealed {
    /// A pixel: `u8`, an entry of the palette, or `u16`, RGB565.
    type Pixel: Copy + Default;
    /// Bits of a pixel in the depth buffer: 0, 16 or 32.
    const DEPTH_BITS: u32;
    #[doc(hidden)]
    fn target() -> *const sys::fxl_target;
    #[doc(hidden)]
    fn surfaces() -> *const sys::fxl_painter;
    #[doc(hidden)]
    fn sprites() -> *const sys::fxl_sprite_painter;
}

/// A target of RGB565: its pixels are `u16`.
pub trait Wide: Target<Pixel = u16> {}

macro_rules! targets {
    ($($(#[$about:meta])* $name:ident: $pixel:ty, $bits:literal, $target:ident, $surfaces:ident, $sprites:ident;)*) => {$(
        $(#[$about])*
        #[derive(Clone, Copy, Debug)]
        pub struct $name;

        impl sealed::Sealed for $name {}

        impl Target for $name {
            type Pixel = $pixel;
            const DEPTH_BITS: u32 = $bits;
            fn target() -> *const sys::fxl_target {
                &raw const sys::$target
            }
            fn surfaces() -> *const sys::fxl_painter {
                &raw const sys::$surfaces
            }
            fn sprites() -> *const sys::fxl_sprite_painter {
                &raw const sys::$sprites
            }
        }

        impl $name {
            /// Words of 64 bits of a depth buffer for so many rows; 0 without one.
            pub const fn depth_words(width: u16, rows: u16) -> usize {
                if $bits == 0 { 0 } else { 1 + (width as usize * rows as usize * ($bits / 8)).div_ceil(8) }
            }
        }
    )*};
}

targets! {
    /// A byte a pixel, which is an entry of the palette.
    Palette: u8, 0, fxl_palette, fxl_palette_surfaces, fxl_palette_sprites;
    /// The same, and at each pixel the nearest face, by 16 bits of depth.
    PaletteDepth16: u8, 16, fxl_palette_depth_16, fxl_palette_depth_16_surfaces, fxl_palette_depth_16_sprites;
    /// The same, by 32 bits of depth.
    PaletteDepth32: u8, 32, fxl_palette_depth_32, fxl_palette_depth_32_surfaces, fxl_palette_depth_32_sprites;
    /// 16 bits a pixel: five of red above six of green above five of blue.
    Rgb565: u16, 0, fxl_rgb565, fxl_rgb565_surfaces, fxl_rgb565_sprites;
    /// The same, and at each pixel the nearest face, by 16 bits of depth.
    Rgb565Depth16: u16, 16, fxl_rgb565_depth_16, fxl_rgb565_depth_16_surfaces, fxl_rgb565_depth_16_sprites;
    /// The same, by 32 bits of depth.
    Rgb565Depth32: u16, 32, fxl_rgb565_depth_32, fxl_rgb565_depth_32_surfaces, fxl_rgb565_depth_32_sprites;
}

impl Wide for Rgb565 {}
impl Wide for Rgb565Depth16 {}
impl Wide for Rgb565Depth32 {}
