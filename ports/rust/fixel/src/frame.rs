// SPDX-License-Identifier: MIT
use core::mem::MaybeUninit;

use fixel_sys as sys;

use crate::error::{check, Error};
use crate::renderer::Renderer;
use crate::target::Target;

/// A rectangle of the screen in pixels.
///
/// ```
/// let corner = fixel::Area { left: 0, top: 0, width: 16, height: 16 };
/// # let _ = corner;
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Area {
    /// The first column.
    pub left: u16,
    /// The first row.
    pub top: u16,
    /// Columns, 1 or more.
    pub width: u16,
    /// Rows, 1 or more.
    pub height: u16,
}

/// What happened to the faces of a frame.
///
/// ```
/// let counters: fixel::Counters = unsafe { core::mem::zeroed() };
/// assert_eq!(counters.drawn, 0);
/// ```
pub type Counters = sys::fxl_counters;

/// What is shown at a pixel.
///
/// ```
/// let picked = fixel::Picked { instance: 0, face: 2, colour: 5 };
/// # let _ = picked;
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Picked {
    /// The instance's number in the scene.
    pub instance: u16,
    /// The face's number in its model.
    pub face: u16,
    /// An entry of the palette.
    pub colour: u8,
}

/// A frame that has begun. The scene stays as it is until the frame is dropped.
///
/// ```
/// use fixel::{include_image, target, Area, Config, Renderer, Scene};
///
/// let scene = Scene::open(include_image!("../examples/cube.fxls"))?;
/// let mut memory = [0_u64; 512];
/// let mut renderer = Renderer::<target::Palette>::new(&scene, Config::of(&scene), &mut memory)?;
/// let mut frame = renderer.begin(&scene.start())?;
/// let mut corner = [0_u8; 32 * 16];
/// frame.draw(&mut corner, 32, &Area { left: 144, top: 112, width: 32, height: 16 })?;
/// assert_eq!(frame.pick(160, 120)?.map(|picked| picked.instance), Some(0));
/// assert_eq!(frame.pick(0, 0)?, None);
/// assert!(frame.counters().drawn > 0);
/// # Ok::<(), fixel::Error>(())
/// ```
pub struct Frame<'r, 'a, T: Target> {
    renderer: &'r mut Renderer<'a, T>,
}

impl<'r, 'a, T: Target> Frame<'r, 'a, T> {
    pub(crate) fn new(renderer: &'r mut Renderer<'a, T>) -> Self {
        Frame { renderer }
    }

    /// Width and height of the screen in pixels.
    ///
    /// ```
    /// # use fixel::*;
    /// # let scene = Scene::open(include_image!("../examples/cube.fxls"))?;
    /// # let mut memory = [0_u64; 512];
    /// # let mut renderer = Renderer::<target::Palette>::new(&scene, Config::of(&scene), &mut memory)?;
    /// assert_eq!(renderer.begin(&scene.start())?.size(), (320, 240));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn size(&self) -> (u16, u16) {
        self.renderer.size()
    }

    /// Clears a rectangle and draws it. The first pixel is that of the left upper corner; rows are `stride` pixels apart.
    /// The pixels are the same whatever a frame is cut into. [`Error::Range`]: the area is not on the screen, or wider than
    /// the stride. [`Error::Capacity`]: there are too few pixels.
    pub fn draw(&mut self, pixels: &mut [T::Pixel], stride: u16, area: &Area) -> Result<(), Error> {
        let (width, height) = self.size();
        let fits = |first: u16, count: u16, end: u16| count != 0 && u32::from(first) + u32::from(count) <= u32::from(end);
        if !fits(area.left, area.width, width) || !fits(area.top, area.height, height) || area.width > stride {
            return Err(Error::Range);
        }
        if pixels.len() < usize::from(area.height - 1) * usize::from(stride) + usize::from(area.width) {
            return Err(Error::Capacity);
        }
        let band = sys::fxl_band {
            pixels: pixels.as_mut_ptr().cast(),
            width,
            stride,
            first_row: area.top,
            rows: area.height,
            palette: self.renderer.raw.palette,
            first_column: area.left,
            columns: area.width,
        };
        // SAFETY: the band lies on the screen, and its pixels are there.
        unsafe {
            sys::fxl_frame_fill(&self.renderer.raw, &band, self.renderer.raw.frame.background);
            check(sys::fxl_frame_draw(&mut self.renderer.raw, &band))
        }
    }

    /// Clears rows of the whole width and draws them.
    ///
    /// ```
    /// # use fixel::*;
    /// # let scene = Scene::open(include_image!("../examples/cube.fxls"))?;
    /// # let mut memory = [0_u64; 512];
    /// # let mut renderer = Renderer::<target::Palette>::new(&scene, Config::of(&scene), &mut memory)?;
    /// let mut frame = renderer.begin(&scene.start())?;
    /// let mut strip = [0_u8; 320 * 8];
    /// assert_eq!(frame.draw_rows(&mut strip, 240, 1), Err(Error::Range));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn draw_rows(&mut self, pixels: &mut [T::Pixel], first: u16, rows: u16) -> Result<(), Error> {
        let (width, _) = self.size();
        self.draw(pixels, width, &Area { left: 0, top: first, width, height: rows })
    }

    /// What is shown at a pixel; `None`: the background.
    pub fn pick(&mut self, x: u16, y: u16) -> Result<Option<Picked>, Error> {
        let mut picked = MaybeUninit::<sys::fxl_picked>::uninit();
        // SAFETY: the pointers are those of records of ours.
        let picked = unsafe {
            check(sys::fxl_pick_face(&mut self.renderer.raw, x, y, picked.as_mut_ptr()))?;
            picked.assume_init()
        };
        let found = Picked { instance: picked.instance, face: picked.face, colour: picked.colour };
        Ok((u32::from(picked.instance) != sys::FXL_PICK_NONE).then_some(found))
    }

    /// What happened to its faces.
    pub fn counters(&self) -> Counters {
        self.renderer.raw.workspace.counters
    }
}

impl<T: Target> Drop for Frame<'_, '_, T> {
    fn drop(&mut self) {
        // SAFETY: the renderer is there. It answers an error for a null pointer alone.
        unsafe { sys::fxl_frame_end(&mut self.renderer.raw) };
    }
}
