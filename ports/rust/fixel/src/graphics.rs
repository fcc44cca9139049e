// SPDX-License-Identifier: MIT
//! What embedded-graphics draws with.

use core::cell::RefCell;
use core::convert::Infallible;

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Dimensions, OriginDimensions, Point, Size};
use embedded_graphics_core::pixelcolor::raw::RawU16;
use embedded_graphics_core::pixelcolor::{IntoStorage, Rgb565};
use embedded_graphics_core::primitives::Rectangle;
use embedded_graphics_core::{Drawable, Pixel};

use crate::error::Error;
use crate::frame::{Area, Frame};
use crate::target::Wide;

fn colour(pixel: &u16) -> Rgb565 {
    Rgb565::from(RawU16::new(*pixel))
}

/// A picture in memory of the caller's: a draw target for what is drawn over it, and a drawable for a display.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::{Circle, PrimitiveStyle}};
/// use fixel::{include_image, target, Config, Picture, Renderer, Scene};
///
/// let scene = Scene::open(include_image!("../examples/cube.fxls"))?;
/// let palette = scene.palette_565();
/// let mut memory = [0_u64; 512];
/// let mut renderer = Renderer::<target::Rgb565>::new(&scene, Config::new(64, 48).palette(&palette), &mut memory)?;
/// let mut pixels = [0; 64 * 48];
/// renderer.render(&scene.start(), &mut pixels)?;
///
/// let mut picture = Picture::new(&mut pixels, 64)?;
/// let style = PrimitiveStyle::with_fill(Rgb565::RED);
/// let Ok(()) = Circle::new(Point::new(0, 0), 9).into_styled(style).draw(&mut picture);
/// assert_eq!(picture.pixels()[4 * 64 + 4], Rgb565::RED.into_storage());
/// # Ok::<(), fixel::Error>(())
/// ```
pub struct Picture<'p> {
    pixels: &'p mut [u16],
    size: Size,
}

impl<'p> Picture<'p> {
    /// Pixels in rows of a width, without a gap. [`Error::Range`]: they are not whole rows.
    pub fn new(pixels: &'p mut [u16], width: u16) -> Result<Self, Error> {
        if width == 0 || pixels.len() % usize::from(width) != 0 {
            return Err(Error::Range);
        }
        let height = u32::try_from(pixels.len() / usize::from(width)).map_err(|_| Error::Range)?;
        Ok(Picture { pixels, size: Size::new(u32::from(width), height) })
    }

    /// The pixels.
    pub fn pixels(&self) -> &[u16] {
        self.pixels
    }

    /// The place of a pixel, if it is in the picture.
    fn at(&self, point: Point) -> Option<usize> {
        let (x, y) = (u32::try_from(point.x).ok()?, u32::try_from(point.y).ok()?);
        (x < self.size.width && y < self.size.height).then(|| y as usize * self.size.width as usize + x as usize)
    }
}

impl OriginDimensions for Picture<'_> {
    fn size(&self) -> Size {
        self.size
    }
}

impl DrawTarget for Picture<'_> {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(point, colour) in pixels {
            if let Some(place) = self.at(point) {
                self.pixels[place] = colour.into_storage();
            }
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, colour: Rgb565) -> Result<(), Infallible> {
        let part = area.intersection(&self.bounding_box());
        let width = part.size.width as usize;
        for row in part.rows() {
            if let Some(place) = self.at(Point::new(part.top_left.x, row)) {
                self.pixels[place..place + width].fill(colour.into_storage());
            }
        }
        Ok(())
    }
}

impl Drawable for Picture<'_> {
    type Color = Rgb565;
    type Output = ();

    fn draw<D: DrawTarget<Color = Rgb565>>(&self, target: &mut D) -> Result<(), D::Error> {
        target.fill_contiguous(&self.bounding_box(), self.pixels.iter().map(colour))
    }
}

/// A frame that is drawn strip by strip to any display of embedded-graphics: [`Frame::strips`].
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*};
/// use fixel::{include_image, target, Config, Renderer, Scene};
///
/// let scene = Scene::open(include_image!("../examples/cube.fxls"))?;
/// let palette = scene.palette_565();
/// let mut memory = [0_u64; 512];
/// let mut renderer = Renderer::<target::Rgb565>::new(&scene, Config::new(64, 48).palette(&palette), &mut memory)?;
///
/// let mut display = MockDisplay::<Rgb565>::new();
/// let mut strip = [0; 64 * 4]; // four rows
/// let Ok(drawn) = renderer.begin(&scene.start())?.strips(&mut strip).draw(&mut display);
/// drawn?;
/// # Ok::<(), fixel::Error>(())
/// ```
pub struct Strips<'s, 'r, 'a, T: Wide> {
    parts: RefCell<(&'s mut Frame<'r, 'a, T>, &'s mut [u16])>,
    place: Rectangle,
}

impl<'r, 'a, T: Wide> Frame<'r, 'a, T> {
    /// The frame as a drawable of embedded-graphics. It is drawn in as many rows at a time as the strip has room for.
    pub fn strips<'s>(&'s mut self, strip: &'s mut [u16]) -> Strips<'s, 'r, 'a, T> {
        let (width, height) = self.size();
        let place = Rectangle::new(Point::zero(), Size::new(width.into(), height.into()));
        Strips { parts: RefCell::new((self, strip)), place }
    }
}

impl<T: Wide> Strips<'_, '_, '_, T> {
    /// The same with its left upper corner elsewhere on the display.
    pub fn at(mut self, left: i32, top: i32) -> Self {
        self.place.top_left = Point::new(left, top);
        self
    }
}

impl<T: Wide> Dimensions for Strips<'_, '_, '_, T> {
    fn bounding_box(&self) -> Rectangle {
        self.place
    }
}

impl<T: Wide> Drawable for Strips<'_, '_, '_, T> {
    type Color = Rgb565;
    /// [`Error::Capacity`]: the strip is shorter than one row.
    type Output = Result<(), Error>;

    fn draw<D: DrawTarget<Color = Rgb565>>(&self, target: &mut D) -> Result<Self::Output, D::Error> {
        let shown = self.place.intersection(&target.bounding_box());
        if shown.is_zero_sized() {
            return Ok(Ok(()));
        }
        let Ok(mut parts) = self.parts.try_borrow_mut() else {
            return Ok(Err(Error::Order)); // the display draws the same frame from within
        };
        let (frame, strip) = &mut *parts;
        let width = shown.size.width;
        let rows = (strip.len() / width as usize) as u32;
        if rows == 0 {
            return Ok(Err(Error::Capacity));
        }
        let mut done = 0;
        while done < shown.size.height {
            let count = rows.min(shown.size.height - done);
            let part = Rectangle::new(shown.top_left + Point::new(0, done as i32), Size::new(width, count));
            let corner = part.top_left - self.place.top_left;
            // All are within the screen, whose sides are 1024 pixels at most.
            let area = Area { left: corner.x as u16, top: corner.y as u16, width: width as u16, height: count as u16 };
            if let Err(error) = frame.draw(strip, area.width, &area) {
                return Ok(Err(error));
            }
            target.fill_contiguous(&part, strip[..(width * count) as usize].iter().map(colour))?;
            done += count;
        }
        Ok(Ok(()))
    }
}
