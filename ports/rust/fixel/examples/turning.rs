// SPDX-License-Identifier: MIT
//! A turning cube on a display of embedded-graphics, with a line of text over it. The display is the simulator's, without
//! a window: the last picture becomes a file.
//!
//!     cargo run --example turning -- turning.png

use std::error::Error;

use embedded_graphics::mono_font::{ascii::FONT_6X10, MonoTextStyle};
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics::text::Text;
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use fixel::{degrees, include_image, target, units, Config, Instance, MovableScene, Orientation, Placement, Renderer, Scene};

static CUBE: &[u8] = include_image!("cube.fxls");
const STEPS: i32 = 12;

fn main() -> Result<(), Box<dyn Error>> {
    let scene = Scene::open(CUBE)?;
    let palette = scene.palette_565();
    let (mut instances, mut placements) = ([Instance::EMPTY; 1], [Placement::NONE; 1]);
    let mut movable = MovableScene::new(&scene, &mut instances, &mut placements)?;
    let mut memory = [0_u64; 1024];
    let config = Config::of(&scene).palette(&palette);
    let mut renderer = Renderer::<target::Rgb565>::new(&mut movable, config, &mut memory)?;

    let mut display = SimulatorDisplay::<Rgb565>::new(Size::new(320, 240));
    let mut strip = [0; 320 * 16];
    for step in 0..STEPS {
        let turn = Orientation::from_angles(degrees(10 * step), degrees(5 * step), 0)?;
        renderer.place(0, &Placement::new(turn, units(1)))?;
        renderer.begin(&scene.start())?.strips(&mut strip).draw(&mut display)??;
        Text::new("Fixel", Point::new(8, 16), MonoTextStyle::new(&FONT_6X10, Rgb565::WHITE)).draw(&mut display)?;
    }
    if let Some(name) = std::env::args().nth(1) {
        display.to_rgb_output_image(&OutputSettings::default()).save_png(name)?;
    }
    Ok(())
}
