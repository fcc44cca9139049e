// SPDX-License-Identifier: MIT
//! Whole pictures, strips, areas, draw targets and refusals.

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use embedded_graphics_simulator::SimulatorDisplay;
use fixel::{
    include_image, target, units, Area, Config, Error, Instance, MovableScene, Orientation, Picture, Placement, Point as WorldPoint, Pose,
    Renderer, Scene, Setup, SetupRecord,
};

static CUBE: &[u8] = include_image!("../examples/cube.fxls");
const WIDTH: usize = 320;
const HEIGHT: usize = 240;

fn whole(scene: &Scene<'_>) -> Result<Vec<u16>, Error> {
    let palette = scene.palette_565();
    let mut memory = [0; 1024];
    let mut renderer = Renderer::<target::Rgb565>::new(scene, Config::of(scene).palette(&palette), &mut memory)?;
    let mut pixels = vec![0; WIDTH * HEIGHT];
    renderer.render(&scene.start(), &mut pixels)?;
    Ok(pixels)
}

#[test]
fn a_palette_and_rgb565_draw_the_same() -> Result<(), Error> {
    let scene = Scene::open(CUBE)?;
    let palette = scene.palette_565();
    let mut memory = [0; 1024];
    let mut renderer = Renderer::<target::Palette>::new(&scene, Config::of(&scene), &mut memory)?;
    let mut entries = vec![0; WIDTH * HEIGHT];
    renderer.render(&scene.start(), &mut entries)?;
    let colours: Vec<u16> = entries.iter().map(|entry| palette[usize::from(*entry)]).collect();
    assert_eq!(colours, whole(&scene)?);
    assert!(entries.iter().collect::<std::collections::BTreeSet<_>>().len() >= 4, "three sides before a background");
    Ok(())
}

#[test]
fn areas_are_parts_of_the_picture_and_touch_nothing_else() -> Result<(), Error> {
    let scene = Scene::open(CUBE)?;
    let (palette, picture) = (scene.palette_565(), whole(&scene)?);
    let mut depth = [0; target::Rgb565Depth16::depth_words(320, 24)];
    let mut memory = [0; 600];
    let config = Config::of(&scene).palette(&palette).depth(&mut depth);
    let mut renderer = Renderer::<target::Rgb565Depth16>::new(&scene, config, &mut memory)?;
    let mut frame = renderer.begin(&scene.start())?;
    for (left, top, width, height) in [(0, 0, 320, 240), (111, 77, 93, 81), (319, 239, 1, 1), (150, 0, 7, 240)] {
        let stride = width + 3;
        let mut pixels = vec![0xA5A5; usize::from(stride) * usize::from(height)];
        frame.draw(&mut pixels, stride, &Area { left, top, width, height })?;
        for (row, line) in pixels.chunks(usize::from(stride)).enumerate() {
            let first = (usize::from(top) + row) * WIDTH + usize::from(left);
            assert_eq!(line[..usize::from(width)], picture[first..first + usize::from(width)]);
            assert_eq!(line[usize::from(width)..], [0xA5A5; 3]);
        }
    }
    Ok(())
}

#[test]
fn a_picture_is_cleared_to_the_background() -> Result<(), Error> {
    let scene = Scene::open(CUBE)?;
    let mut memory = [0; 600];
    let config = Config::of(&scene).background(77);
    let mut renderer = Renderer::<target::Palette>::new(&scene, config, &mut memory)?;
    let mut pixels = vec![1; WIDTH * HEIGHT];
    renderer.render(&scene.start(), &mut pixels)?;
    assert_eq!((pixels[0], pixels[WIDTH * HEIGHT - 1]), (77, 77));
    let mut strip = [1; WIDTH];
    renderer.begin(&scene.start())?.draw_rows(&mut strip, 0, 1)?;
    assert_eq!(strip, [77; WIDTH]);
    Ok(())
}

#[test]
fn strips_are_a_drawable() -> Result<(), Error> {
    let scene = Scene::open(CUBE)?;
    let (palette, mut picture) = (scene.palette_565(), whole(&scene)?);
    let mut memory = [0; 600];
    let mut renderer = Renderer::<target::Rgb565>::new(&scene, Config::of(&scene).palette(&palette), &mut memory)?;
    let mut frame = renderer.begin(&scene.start())?;
    for (left, top, words) in [(0, 0, 320 * 7), (-100, 50, 220), (90, -33, 100_000)] {
        let mut display = SimulatorDisplay::<Rgb565>::new(Size::new(320, 240));
        let mut expected = SimulatorDisplay::<Rgb565>::new(Size::new(320, 240));
        let mut strip = vec![0; words];
        let Ok(drawn) = frame.strips(&mut strip).at(left, top).draw(&mut display);
        drawn?;
        let Ok(()) = Picture::new(&mut picture, 320)?.draw(&mut expected.translated(Point::new(left, top)));
        assert!(display.diff(&expected).is_none(), "at {left}, {top}");
    }
    let mut display = SimulatorDisplay::<Rgb565>::new(Size::new(320, 240));
    let Ok(drawn) = frame.strips(&mut [0; 319]).draw(&mut display);
    assert_eq!(drawn, Err(Error::Capacity));
    Ok(())
}

#[test]
fn a_picture_is_a_draw_target_that_clips() -> Result<(), Error> {
    let mut pixels = [0; 8 * 4];
    let mut picture = Picture::new(&mut pixels, 8)?;
    let Ok(()) = picture.fill_solid(&Rectangle::new(Point::new(-3, 2), Size::new(5, 9)), Rgb565::WHITE);
    let Ok(()) = picture.draw_iter([Pixel(Point::new(7, 0), Rgb565::WHITE), Pixel(Point::new(8, 0), Rgb565::WHITE)]);
    let white: Vec<usize> = picture.pixels().iter().enumerate().filter(|(_, pixel)| **pixel != 0).map(|(place, _)| place).collect();
    assert_eq!(white, [7, 16, 17, 24, 25]);
    assert_eq!(Picture::new(&mut [0; 9], 8).err(), Some(Error::Range));
    Ok(())
}

#[test]
fn instances_move_and_turn() -> Result<(), Error> {
    let scene = Scene::open(CUBE)?;
    let (palette, first) = (scene.palette_565(), whole(&scene)?);
    let (mut instances, mut placements) = ([Instance::EMPTY; 1], [Placement::NONE; 1]);
    assert_eq!(MovableScene::new(&scene, &mut instances[..0], &mut placements).err(), Some(Error::Capacity));
    let mut movable = MovableScene::new(&scene, &mut instances, &mut placements)?;
    let mut memory = [0; 600];
    let mut renderer = Renderer::<target::Rgb565>::new(&mut movable, Config::of(&scene).palette(&palette), &mut memory)?;
    let mut pixels = vec![0; WIDTH * HEIGHT];
    renderer.render(&scene.start(), &mut pixels)?;
    assert_eq!(pixels, first);
    renderer.place(0, &Placement::new(Orientation::from_axis(&WorldPoint { x: 0, y: 1, z: 0 }, fixel::degrees(20))?, units(1)))?;
    renderer.render(&scene.start(), &mut pixels)?;
    assert_ne!(pixels, first);
    let far_away = WorldPoint { x: units(8191), y: 0, z: 0 };
    assert_eq!(renderer.move_to(0, &far_away), Err(Error::Range));
    assert_eq!(renderer.place(0, &Placement::new(Orientation::NONE, 0)), Err(Error::Range));
    assert_eq!(renderer.place(7, &Placement::NONE), Err(Error::Index));
    renderer.place(0, &Placement::NONE)?;
    renderer.render(&scene.start(), &mut pixels)?;
    assert_eq!(pixels, first);
    Ok(())
}

#[test]
fn what_is_wrong_is_refused_with_its_error() -> Result<(), Error> {
    let scene = Scene::open(CUBE)?;
    let palette = scene.palette_565();
    let mut broken = include_bytes!("../examples/cube.fxls").to_vec();
    let last = broken.len() - 1;
    broken[last] ^= 1;
    let mut words = vec![0_u32; broken.len().div_ceil(4)];
    let mut open = |bytes: &[u8]| {
        for (word, part) in words.iter_mut().zip(bytes.chunks(4)) {
            let mut padded = [0; 4];
            padded[..part.len()].copy_from_slice(part);
            *word = u32::from_ne_bytes(padded);
        }
        // SAFETY: the words hold these bytes.
        Scene::open(unsafe { core::slice::from_raw_parts(words.as_ptr().cast(), bytes.len()) }).err()
    };
    assert_eq!(open(&broken), Some(Error::Crc));
    broken[0] ^= 1;
    assert_eq!(open(&broken), Some(Error::Magic));
    assert_eq!(open(&broken[..40]), Some(Error::Size));
    assert_eq!(Scene::open(&CUBE[1..]).err(), Some(Error::Alignment));

    let mut memory = [0; 600];
    type Wide<'a> = Renderer<'a, target::Rgb565>;
    assert_eq!(Wide::new(&scene, Config::of(&scene), &mut memory).err(), Some(Error::Argument), "no palette");
    assert_eq!(Wide::new(&scene, Config::of(&scene).palette(&palette), &mut []).err(), Some(Error::Capacity));
    assert_eq!(Wide::new(&scene, Config::new(0, 240).palette(&palette), &mut memory).err(), Some(Error::Range));
    type Deep<'a> = Renderer<'a, target::PaletteDepth32>;
    assert_eq!(Deep::new(&scene, Config::of(&scene), &mut memory).err(), Some(Error::Capacity), "no depth buffer");
    assert_eq!(Deep::new(&scene, Config::of(&scene).depth(&mut [0; 8]), &mut memory).err(), Some(Error::Capacity));

    let mut renderer = Wide::new(&scene, Config::of(&scene).palette(&palette), &mut memory)?;
    assert_eq!(renderer.place(0, &Placement::NONE), Err(Error::Order), "no movable scene");
    assert_eq!(renderer.render(&scene.start(), &mut [0; 100]), Err(Error::Capacity));
    let beyond = Pose { position: WorldPoint { x: i32::MAX, y: 0, z: 0 }, ..scene.start() };
    assert_eq!(renderer.begin(&beyond).err(), Some(Error::Range));
    let mut frame = renderer.begin(&scene.start())?;
    let mut pixels = [7; 64];
    for area in [
        Area { left: 0, top: 0, width: 0, height: 1 },
        Area { left: 0, top: 0, width: 1, height: 0 },
        Area { left: 300, top: 0, width: 21, height: 1 },
        Area { left: 0, top: 65535, width: 1, height: 1 },
    ] {
        assert_eq!(frame.draw(&mut pixels, 64, &area), Err(Error::Range));
    }
    assert_eq!(frame.draw(&mut pixels, 8, &Area { left: 0, top: 0, width: 9, height: 1 }), Err(Error::Range));
    assert_eq!(frame.draw(&mut pixels, 64, &Area { left: 0, top: 0, width: 1, height: 2 }), Err(Error::Capacity));
    assert_eq!(frame.pick(320, 0), Err(Error::Range));
    assert!(pixels.iter().all(|pixel| *pixel == 7), "a refused call leaves pixels as they are");
    Ok(())
}

#[test]
fn errors_are_sentences() {
    let errors: Vec<Error> = vec![Error::Range, Error::Crc, Error::Combination, Error::Unknown(99)];
    for error in errors {
        assert!(error.to_string().len() > 4, "{error:?}");
    }
    assert_eq!(Error::Unknown(99).status(), 99);
}

#[test]
fn a_setup_is_refused_with_a_sentence() -> Result<(), Error> {
    let scene = Scene::open(CUBE)?;
    let mut record = SetupRecord::new();
    let mut memory = vec![0; 4096];
    let wide = Setup::<target::Rgb565>::new(&scene, 8, &mut record, &mut memory).err();
    assert_eq!(wide.map(|each| each.error()), Some(Error::Combination));
    assert!(wide.is_some_and(|each| each.to_string().contains("palette")));
    for rows in [0, 241] {
        let refused = Setup::<target::PaletteDepth16>::new(&scene, rows, &mut record, &mut memory).err();
        assert_eq!(refused.map(|each| (each.error(), each.missing())), Some((Error::Range, 0)));
        assert!(refused.is_some_and(|each| each.to_string().contains("rows")), "{refused:?}");
    }
    // A word less than it needs is a word missing; and what was refused can be set up afterwards.
    let missing = |memory: &mut [u64], record: &mut SetupRecord| {
        Setup::<target::PaletteDepth16>::new(&scene, 8, record, memory).err().map(|each| (each.error(), each.missing()))
    };
    let Some((Error::Capacity, needed)) = missing(&mut [], &mut record) else {
        return Err(Error::Capacity);
    };
    assert_eq!(missing(&mut memory[..needed - 1], &mut record), Some((Error::Capacity, 1)));
    assert_eq!(missing(&mut memory[..needed], &mut record), None);
    Ok(())
}

#[test]
fn a_setup_of_a_model_that_was_moved_draws_the_same() -> Result<(), Error> {
    fn set_up<'a>(scene: &'a Scene<'_>, record: &'a mut SetupRecord, memory: &'a mut [u64]) -> Result<Box<Wide<'a>>, Error> {
        Ok(Box::new(Setup::new(scene, 16, record, memory)?)) // which is moved
    }
    type Wide<'a> = Setup<'a, target::Rgb565Depth16>;
    let scene = Scene::open(include_image!("../examples/model.fxls"))?;
    assert_eq!((scene.pixel_bits(), scene.depth_bits()), (16, 16));
    let (mut record, mut other) = (SetupRecord::new(), SetupRecord::new());
    let (mut memory, mut least) = (vec![0; 1 << 16], vec![]);
    let missing = Wide::new(&scene, 1, &mut other, &mut least).err().map(|each| each.missing());
    least.resize(missing.unwrap_or(0), 0);
    let (mut one, mut two) = (set_up(&scene, &mut record, &mut memory)?, Wide::new(&scene, 1, &mut other, &mut least)?);
    let (mut pixels, mut others) = (vec![0; WIDTH * HEIGHT], vec![0; WIDTH * HEIGHT]);
    for number in [0, 5, 24] {
        let (eye, same) = (one.play(number), two.play(number % 24));
        assert_eq!(eye, same, "the path begins again");
        one.render(&eye, &mut pixels)?;
        two.render(&same, &mut others)?;
        assert!(pixels == others && pixels.iter().collect::<std::collections::BTreeSet<_>>().len() > 100);
    }
    Ok(())
}
