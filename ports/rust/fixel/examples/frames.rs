// SPDX-License-Identifier: MIT
//! Draws the frames of a scene's path, as entries of the palette, into a file: what a test compares.
//!
//!     cargo run --example frames -- plaza.fxls frames.raw
//!
//! The scene's path must be poses; else it draws the first frame alone.

use std::error::Error;
use std::io::Write;

use fixel::{target, Config, Error as Refused, Light, LightSettings, LitSurfaces, Renderer, Scene, SurfaceSet, Surfaces, Texture};

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
    let (width, height) = scene.size();
    let mut memory = vec![0_u64; 1 << 16];
    let mut textures = vec![Texture::EMPTY; 64];
    let set = match SurfaceSet::open(&scene, &mut textures) {
        Err(Refused::Argument) => None, // there are none
        other => Some(other?),
    };
    let (mut surfaces, mut lit, mut light) = (Surfaces::new(), LitSurfaces::new(), Light::new());
    let mut renderer = Renderer::<target::Palette>::new(&scene, Config::of(&scene), &mut memory)?;
    if let Some(set) = &set {
        renderer.attach_surfaces(&mut surfaces, set)?;
        renderer.attach_lit(&mut lit)?;
    }
    if let Some(settings) = LightSettings::of(&scene) {
        renderer.attach_light(&mut light, &settings)?;
    }
    let mut pixels = vec![0_u8; usize::from(width) * usize::from(height)];
    let mut file = std::fs::File::create(out)?;
    let start = [scene.start()];
    let poses = if scene.poses().is_empty() { &start } else { scene.poses() };
    for eye in poses {
        // By strips of 50 rows, of which the last may be shorter.
        let mut frame = renderer.begin(eye)?;
        for (first, strip) in (0..height).step_by(50).zip(pixels.chunks_mut(50 * usize::from(width))) {
            frame.draw_rows(strip, first, 50.min(height - first))?;
        }
        drop(frame);
        file.write_all(&pixels)?;
    }
    println!("{} frames of {width} x {height}", poses.len());
    Ok(())
}
