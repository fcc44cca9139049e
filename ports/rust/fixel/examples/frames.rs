// SPDX-License-Identifier: MIT
//! Draws the frames of a scene's path with all that the scene has, as a program of C does, into a file: what a test compares.
//!
//!     cargo run --example frames -- plaza.fxls frames.raw
//!
//! Pixels are entries of the palette, or RGB565 with the low byte first. The scene's path must be poses; else it draws the first
//! frame alone.

use std::error::Error;
use std::io::Write;

use fixel::target::{Palette, PaletteDepth16, Rgb565, Rgb565Depth16, Target};
use fixel::{Scene, Setup, SetupRecord};

const ROWS: u16 = 50; // of a strip; the depth buffer has fewer, so strips are drawn in parts

fn draw<T: Target>(scene: &Scene<'_>, mut write: impl FnMut(&[T::Pixel]) -> std::io::Result<()>) -> Result<usize, Box<dyn Error>> {
    let mut record = SetupRecord::new();
    let mut memory = vec![0_u64; 1 << 16];
    let mut it = Setup::<T>::new(scene, 16, &mut record, &mut memory)?;
    let (width, height) = it.size();
    let mut pixels = vec![T::Pixel::default(); usize::from(width) * usize::from(height)];
    let count = scene.poses().len().max(1);
    for number in 0..count {
        let eye = it.play(u32::try_from(number)?);
        let mut frame = it.begin(&eye)?;
        for (first, strip) in (0..height).step_by(ROWS.into()).zip(pixels.chunks_mut(usize::from(ROWS) * usize::from(width))) {
            frame.draw_rows(strip, first, ROWS.min(height - first))?; // the last strip may be shorter
        }
        drop(frame);
        write(&pixels)?;
    }
    Ok(count)
}

fn main() -> Result<(), Box<dyn Error>> {
    let names: Vec<String> = std::env::args().skip(1).collect();
    let [image, out] = names.as_slice() else {
        return Err("usage: frames IMAGE OUT".into());
    };
    let bytes = std::fs::read(image)?;
    // A vector of bytes is not aligned as an image must be.
    let mut words = vec![0_u64; bytes.len().div_ceil(8)];
    for (word, chunk) in words.iter_mut().zip(bytes.chunks(8)) {
        let mut padded = [0; 8];
        padded[..chunk.len()].copy_from_slice(chunk);
        *word = u64::from_ne_bytes(padded);
    }
    // SAFETY: the words hold at least as many bytes, and live as long.
    let aligned = unsafe { core::slice::from_raw_parts(words.as_ptr().cast::<u8>(), bytes.len()) };
    let scene = Scene::open(aligned)?;
    let mut file = std::fs::File::create(out)?;
    let mut wide = |pixels: &[u16]| file.write_all(&pixels.iter().flat_map(|pixel| pixel.to_le_bytes()).collect::<Vec<u8>>());
    let count = match (scene.pixel_bits(), scene.depth_bits()) {
        (16, 0) => draw::<Rgb565>(&scene, &mut wide)?,
        (16, _) => draw::<Rgb565Depth16>(&scene, &mut wide)?,
        (_, 0) => draw::<Palette>(&scene, |pixels| file.write_all(pixels))?,
        _ => draw::<PaletteDepth16>(&scene, |pixels| file.write_all(pixels))?,
    };
    println!("{count} frames");
    Ok(())
}
