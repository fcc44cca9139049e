// SPDX-License-Identifier: MIT
//! A model of one's own with its textures, smooth light and depth, on a display of embedded-graphics: the simulator's, without a
//! window. The last picture becomes a file. For another model: `fixel build my/model.glb -o model.fxls --frames 24`.
//!
//!     cargo run --example model -- model.png

use std::error::Error;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use fixel::{include_image, target, Scene, Setup, SetupRecord};

static MODEL: &[u8] = include_image!("model.fxls");
const ROWS: u16 = 16; // of a strip, and of the depth buffer

fn main() -> Result<(), Box<dyn Error>> {
    let scene = Scene::open(MODEL)?;
    let mut record = SetupRecord::new();
    let mut memory = [0_u64; 4096];
    let mut it = Setup::<target::Rgb565Depth16>::new(&scene, ROWS, &mut record, &mut memory)?;

    let mut display = SimulatorDisplay::<Rgb565>::new(Size::new(320, 240));
    let mut strip = [0; 320 * ROWS as usize];
    for number in 0..scene.poses().len() {
        let eye = it.play(number as u32);
        it.begin(&eye)?.strips(&mut strip).draw(&mut display)??;
    }
    if let Some(name) = std::env::args().nth(1) {
        display.to_rgb_output_image(&OutputSettings::default()).save_png(name)?;
    }
    Ok(())
}
