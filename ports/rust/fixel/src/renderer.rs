// SPDX-License-Identifier: MIT
use core::marker::PhantomData;
use core::mem::{size_of, MaybeUninit};
use core::ptr;

use fixel_sys as sys;

use crate::error::{check, Error};
use crate::frame::Frame;
use crate::movable::{Drawn, Placement, Tables};
use crate::numbers::{Point, Pose};
use crate::scene::Scene;
use crate::surfaces::{Light, LightSettings, LitSurfaces, SurfaceSet, Surfaces};
use crate::target::Target;

/// What a renderer is made with.
///
/// ```
/// use fixel::{degrees, units, Config};
///
/// let palette = [0_u16; 256];
/// let config = Config::new(320, 240).fov(degrees(75)).far(units(100)).background(3).palette(&palette);
/// # let _ = config;
/// ```
pub struct Config<'a> {
    raw: sys::fxl_config,
    lens: Option<sys::fxl_lens>,
    _borrowed: PhantomData<(&'a [u16; 256], &'a mut [u64])>,
}

impl<'a> Config<'a> {
    /// For a screen of so many pixels: a field of view of 60 degrees, near at 1/4, far at 256 world units, background 0.
    pub fn new(width: u16, height: u16) -> Self {
        // SAFETY: the function looks at nothing behind its pointers.
        let raw = unsafe { sys::fxl_config_for(width, height, ptr::null()) };
        Config { raw, lens: None, _borrowed: PhantomData }
    }

    /// As the scene was made for: its screen, lens and background.
    ///
    /// ```
    /// # use fixel::{Config, Scene};
    /// # let scene = Scene::open(fixel::include_image!("../examples/cube.fxls"))?;
    /// let config = Config::of(&scene);
    /// # let _ = config;
    /// # Ok::<(), fixel::Error>(())
    /// ```
    pub fn of(scene: &Scene<'_>) -> Self {
        let (width, height) = scene.size();
        Config { lens: Some(scene.image.lens), ..Self::new(width, height).background(scene.image.background) }
    }

    /// The horizontal field of view, 10 to 150 degrees.
    pub fn fov(mut self, angle: u32) -> Self {
        self.raw.fov = angle;
        self.lens = None;
        self
    }

    /// What is nearer is clipped away.
    pub fn near(mut self, distance: i32) -> Self {
        self.raw.near_z = distance;
        self.lens = None;
        self
    }

    /// What is farther is clipped away.
    pub fn far(mut self, distance: i32) -> Self {
        self.raw.far_z = distance;
        self.lens = None;
        self
    }

    /// The entry of the palette that a picture is cleared to.
    pub fn background(mut self, entry: u8) -> Self {
        self.raw.background = entry;
        self
    }

    /// The colours of an RGB565 target.
    pub fn palette(mut self, colours: &'a [u16; 256]) -> Self {
        self.raw.palette = colours.as_ptr();
        self
    }

    /// The memory of the target's depth buffer: [`depth_words`](crate::target::Rgb565Depth16::depth_words) of a row at least.
    pub fn depth(mut self, memory: &'a mut [u64]) -> Self {
        self.raw.depth = memory.as_mut_ptr().cast();
        self.raw.depth_size = u32::try_from(memory.len() * 8).unwrap_or(u32::MAX);
        self
    }

    fn lens(&self) -> Result<sys::fxl_lens, Error> {
        if let Some(lens) = self.lens {
            return Ok(lens);
        }
        let mut lens = MaybeUninit::uninit();
        let raw = &self.raw;
        // SAFETY: the pointer is that of a record of ours.
        check(unsafe { sys::fxl_lens_from_fov(raw.width, raw.height, raw.fov, raw.near_z, raw.far_z, raw.inset, lens.as_mut_ptr()) })?;
        // SAFETY: FXL_OK: the lens is written.
        Ok(unsafe { lens.assume_init() })
    }
}

/// A renderer: it draws one scene into pixels of the caller's, and works in memory of the caller's. It may be moved.
///
/// ```
/// use fixel::{include_image, target, Config, Renderer, Scene};
///
/// let scene = Scene::open(include_image!("../examples/cube.fxls"))?;
/// let mut memory = [0_u64; 512];
/// let mut renderer = Renderer::<target::Palette>::new(&scene, Config::of(&scene), &mut memory)?;
/// let mut pixels = vec![0_u8; 320 * 240];
/// renderer.render(&scene.start(), &mut pixels)?;
/// # Ok::<(), fixel::Error>(())
/// ```
///
/// It borrows its scene and its memory for as long as it lives:
///
/// ```compile_fail
/// # use fixel::{include_image, target, Config, Renderer, Scene};
/// # let scene = Scene::open(include_image!("../examples/cube.fxls"))?;
/// let mut memory = [0_u64; 512];
/// let mut renderer = Renderer::<target::Palette>::new(&scene, Config::of(&scene), &mut memory)?;
/// memory[0] = 1;
/// renderer.begin(&scene.start())?;
/// # Ok::<(), fixel::Error>(())
/// ```
pub struct Renderer<'a, T: Target> {
    pub(crate) raw: sys::fxl_renderer,
    tables: Option<Tables>,
    _borrowed: PhantomData<(&'a mut [u64], T)>,
}

// SAFETY: what a renderer changes it alone has borrowed; what it shares does not change.
unsafe impl<T: Target> Send for Renderer<'_, T> {}

impl<'a, T: Target> Renderer<'a, T> {
    /// Ties a renderer to a scene, a screen and memory. The memory must hold [`Renderer::memory_needed`]; a larger one
    /// changes no pixel. With room for every polygon, strips are drawn without a look at the scene.
    pub fn new<S: Drawn<'a>>(scene: S, config: Config<'a>, memory: &'a mut [u64]) -> Result<Self, Error> {
        let (scene, tables) = scene.parts();
        let lens = config.lens()?;
        // SAFETY: the scene lives for 'a, and was checked.
        let entries = unsafe { (*scene).draw_list_needed };
        let parts = divide(entries, memory)?;
        let mut raw = MaybeUninit::<sys::fxl_renderer>::zeroed();
        // SAFETY: scene, memory and palette live for 'a. A renderer of zeros is one that was never initialised.
        let raw = unsafe {
            check(sys::fxl_renderer_init_bare(raw.as_mut_ptr(), scene, &lens, &parts))?;
            check(sys::fxl_renderer_set_clipper(raw.as_mut_ptr(), &raw const sys::fxl_clipper_view, ptr::null_mut(), 0))?;
            let config = sys::fxl_config { target: T::target(), ..config.raw };
            check(sys::fxl_renderer_choose(raw.as_mut_ptr(), &config))?;
            (*raw.as_mut_ptr()).frame.background = config.background;
            raw.assume_init()
        };
        Ok(Renderer { raw, tables, _borrowed: PhantomData })
    }

    /// One that the library has set up; what it points to lives for 'a.
    pub(crate) fn of(raw: sys::fxl_renderer) -> Self {
        Renderer { raw, tables: None, _borrowed: PhantomData }
    }

    /// Words of memory that a renderer of a scene needs at least.
    ///
    /// ```
    /// # use fixel::{target, Renderer, Scene};
    /// # let scene = Scene::open(fixel::include_image!("../examples/cube.fxls"))?;
    /// assert!(Renderer::<target::Palette>::memory_needed(&scene) < 512);
    /// # Ok::<(), fixel::Error>(())
    /// ```
    pub fn memory_needed(scene: &Scene<'_>) -> usize {
        words_of(scene.image.scene.draw_list_needed)
    }

    /// Width and height of the screen in pixels.
    ///
    /// ```
    /// # use fixel::{target, Config, Renderer, Scene};
    /// # let scene = Scene::open(fixel::include_image!("../examples/cube.fxls"))?;
    /// # let mut memory = [0; 512];
    /// # let renderer = Renderer::<target::Palette>::new(&scene, Config::of(&scene), &mut memory)?;
    /// assert_eq!(renderer.size(), (320, 240));
    /// # Ok::<(), fixel::Error>(())
    /// ```
    pub fn size(&self) -> (u16, u16) {
        (self.raw.frame.view.lens.width, self.raw.frame.view.lens.height)
    }

    /// Draws a whole picture: clears it, then draws. Rows go downward, without a gap. [`Error::Capacity`]: there are fewer
    /// pixels than the screen has.
    pub fn render(&mut self, eye: &Pose, pixels: &mut [T::Pixel]) -> Result<(), Error> {
        let (width, height) = self.size();
        if pixels.len() < usize::from(width) * usize::from(height) {
            return Err(Error::Capacity);
        }
        // SAFETY: there are pixels for all rows.
        check(unsafe { sys::fxl_render(&mut self.raw, eye, pixels.as_mut_ptr().cast(), width) })?;
        // SAFETY: the frame is drawn.
        check(unsafe { sys::fxl_frame_end(&mut self.raw) })
    }

    /// Begins a frame, which is then drawn in parts. It ends when it is dropped.
    pub fn begin(&mut self, eye: &Pose) -> Result<Frame<'_, 'a, T>, Error> {
        // SAFETY: what the renderer was given lives for 'a.
        check(unsafe { sys::fxl_frame_begin(&mut self.raw, eye) })?;
        Ok(Frame::new(self))
    }

    /// Turns and scales an instance of a [`MovableScene`](crate::MovableScene). [`Error::Order`]: the scene is no such one.
    pub fn place(&mut self, instance: usize, placement: &Placement) -> Result<(), Error> {
        let (tables, record) = self.movable(instance)?;
        // SAFETY: `movable` has found the instance; a Placement is an fxl_placement. No frame is drawn: it would borrow the renderer.
        unsafe {
            let placement: sys::fxl_placement = *(placement as *const Placement).cast();
            check(sys::fxl_placement_check(&placement, &record.centre, self.radius(record.model)))?;
            *tables.placements.add(instance) = placement;
        }
        Ok(())
    }

    /// Moves an instance of a [`MovableScene`](crate::MovableScene).
    ///
    /// ```
    /// # use fixel::*;
    /// # let scene = Scene::open(include_image!("../examples/cube.fxls"))?;
    /// # let (mut instances, mut placements, mut memory) = ([Instance::EMPTY; 1], [Placement::NONE; 1], [0; 512]);
    /// # let mut movable = MovableScene::new(&scene, &mut instances, &mut placements)?;
    /// # let mut renderer = Renderer::<target::Palette>::new(&mut movable, Config::of(&scene), &mut memory)?;
    /// renderer.move_to(0, &Point { x: units(1), y: 0, z: 0 })?;
    /// assert_eq!(renderer.move_to(1, &Point { x: 0, y: 0, z: 0 }), Err(Error::Index));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn move_to(&mut self, instance: usize, centre: &Point) -> Result<(), Error> {
        let (tables, record) = self.movable(instance)?;
        // SAFETY: as in `place`.
        unsafe {
            check(sys::fxl_placement_check(tables.placements.add(instance), centre, self.radius(record.model)))?;
            (*tables.instances.add(instance)).centre = *centre;
        }
        Ok(())
    }

    /// Shows the surfaces of the renderer's scene: textures and more. The record is memory of the caller's.
    /// [`Error::Combination`]: they are another scene's.
    pub fn attach_surfaces(&mut self, surfaces: &'a mut Surfaces, set: &'a SurfaceSet<'_>) -> Result<(), Error> {
        // SAFETY: the scene lives for 'a.
        if unsafe { (*self.raw.scene).faces } != set.faces {
            return Err(Error::Combination);
        }
        // SAFETY: both live for 'a, and the set has an entry for each face of the scene.
        check(unsafe { sys::fxl_attach_surfaces(&mut self.raw, surfaces.0.as_mut_ptr(), &set.raw, T::surfaces()) })
    }

    /// Lights flat faces. The record is memory of the caller's.
    pub fn attach_light(&mut self, light: &'a mut Light, settings: &LightSettings<'a>) -> Result<(), Error> {
        // SAFETY: the record and the ramp live for 'a; the settings are copied.
        check(unsafe { sys::fxl_attach_light(&mut self.raw, light.0.as_mut_ptr(), &settings.raw) })
    }

    /// Has surfaces that are lit take the light at their corners. The record is memory of the caller's.
    pub fn attach_lit(&mut self, lit: &'a mut LitSurfaces) -> Result<(), Error> {
        // SAFETY: the record lives for 'a.
        check(unsafe { sys::fxl_attach_lit(&mut self.raw, lit.0.as_mut_ptr()) })
    }

    fn movable(&self, instance: usize) -> Result<(Tables, sys::fxl_instance), Error> {
        let tables = self.tables.ok_or(Error::Order)?;
        // SAFETY: the scene lives for 'a; the table is as long as its count.
        unsafe {
            if instance >= (*self.raw.scene).instance_count as usize {
                return Err(Error::Index);
            }
            Ok((tables, *tables.instances.add(instance)))
        }
    }

    /// Of a model that an instance has.
    unsafe fn radius(&self, model: u16) -> i32 {
        (*(*self.raw.scene).models.add(usize::from(model))).radius
    }
}

const ENTRY: usize = size_of::<sys::fxl_draw_entry>();

/// Words that the order of drawing takes.
fn words_of(entries: u32) -> usize {
    (entries as usize * ENTRY).div_ceil(8)
}

/// Divides memory: first the order of drawing, then for vertices that faces share a quarter of what is left, then the display list.
fn divide(entries: u32, memory: &mut [u64]) -> Result<sys::fxl_memory, Error> {
    let order = words_of(entries);
    if memory.len() < order {
        return Err(Error::Capacity);
    }
    let (draw_list, rest) = memory.split_at_mut(order);
    let cached = rest.len() * 8 / 4 / size_of::<sys::fxl_cached_vertex>();
    let (cache, display_list) = rest.split_at_mut(cached * size_of::<sys::fxl_cached_vertex>() / 8);
    Ok(sys::fxl_memory {
        draw_list: draw_list.as_mut_ptr().cast(),
        draw_list_capacity: entries,
        display_list: display_list.as_mut_ptr().cast(),
        display_list_capacity: u32::try_from(display_list.len() * 2).unwrap_or(u32::MAX),
        cache: cache.as_mut_ptr().cast(),
        cache_capacity: u32::try_from(cached).unwrap_or(u32::MAX),
    })
}
