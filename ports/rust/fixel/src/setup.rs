// SPDX-License-Identifier: MIT
use core::ffi::{c_char, CStr};
use core::fmt;
use core::marker::PhantomData;
use core::mem::{size_of, MaybeUninit};
use core::{ptr, slice};

use fixel_sys as sys;

use crate::error::{check, Error};
use crate::frame::Frame;
use crate::numbers::Pose;
use crate::renderer::Renderer;
use crate::scene::Scene;
use crate::surfaces::{Light, LightSettings};
use crate::target::Target;

/// What [`Setup::new`] writes: first the C library's setup, behind it what its plan points to.
#[repr(C)]
struct Parts {
    setup: sys::fxl_setup,
    plan: sys::fxl_setup_plan,
    config: sys::fxl_config,
    light: sys::fxl_light_settings,
    surfaces: sys::fxl_surface_set,
    billboards: sys::fxl_billboard_set,
    horizon: sys::fxl_horizon,
    palette: [u16; 256],
}

/// Memory of a fixed size for a [`Setup`]; the caller owns it.
///
/// ```
/// let record = fixel::SetupRecord::new();
/// # let _ = record;
/// ```
pub struct SetupRecord(MaybeUninit<Parts>);

impl SetupRecord {
    /// One that nothing was set up in.
    pub const fn new() -> Self {
        SetupRecord(MaybeUninit::zeroed())
    }
}

impl Default for SetupRecord {
    fn default() -> Self {
        Self::new()
    }
}

/// Why a [`Setup`] was refused: the error, and a sentence that names what was wrong and its range.
///
/// ```
/// use fixel::{include_image, target, Error, Scene, Setup, SetupRecord};
///
/// let scene = Scene::open(include_image!("../examples/cube.fxls"))?;
/// let mut record = SetupRecord::new();
/// let refused = Setup::<target::Palette>::new(&scene, 16, &mut record, &mut []).err();
/// let (error, missing) = refused.map(|each| (each.error(), each.missing())).unwrap_or((Error::Range, 0));
/// assert_eq!(error, Error::Capacity);
/// assert!(Setup::<target::Palette>::new(&scene, 16, &mut record, &mut vec![0; missing]).is_ok());
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SetupError {
    error: Error,
    sentence: &'static str,
    missing: usize,
}

impl SetupError {
    /// The error; with [`Error::Combination`] the scene may also be for pixels of another size than the target's.
    pub fn error(&self) -> Error {
        self.error
    }

    /// Words of 64 bits that the memory lacks; 0 unless the error is [`Error::Capacity`].
    pub fn missing(&self) -> usize {
        self.missing
    }

    fn new(error: Error, sentence: &'static str) -> Self {
        SetupError { error, sentence, missing: 0 }
    }

    /// With a sentence of the C library's.
    ///
    /// # Safety
    ///
    /// `sentence` is null or a constant string that ends in 0.
    unsafe fn explained(error: Error, sentence: *const c_char) -> Self {
        let text = if sentence.is_null() { None } else { CStr::from_ptr(sentence).to_str().ok() };
        Self::new(error, text.unwrap_or(error.to_str()))
    }
}

impl fmt::Display for SetupError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.sentence)
    }
}

impl core::error::Error for SetupError {}

impl From<SetupError> for Error {
    fn from(refused: SetupError) -> Self {
        refused.error
    }
}

/// A scene that is set up with all that its image has: textures and light, billboards, beams, a tree, an off-centre lens, a depth
/// buffer, and what moves. The target's pixels are those that the scene asks for; a depth buffer is the target's. A program that
/// names a `Setup` links the code of all of these; a [`Renderer`] links what the program attaches.
///
/// ```
/// use fixel::{include_image, target, Scene, Setup, SetupRecord};
///
/// static CUBE: &[u8] = include_image!("../examples/cube.fxls");
///
/// let scene = Scene::open(CUBE)?;
/// let mut record = SetupRecord::new();
/// let mut memory = [0_u64; 2048];
/// let mut it = Setup::<target::PaletteDepth16>::new(&scene, 8, &mut record, &mut memory)?;
/// let mut strip = [0_u8; 320 * 8];
/// for number in 0..2 {
///     let eye = it.play(number);
///     let mut frame = it.begin(&eye)?;
///     for first in (0..240).step_by(8) {
///         frame.draw_rows(&mut strip, first, 8)?; // then send the strip to the display
///     }
/// }
/// # Ok::<(), fixel::Error>(())
/// ```
pub struct Setup<'a, T: Target> {
    renderer: Renderer<'a, T>,
    parts: *mut Parts,
    _borrowed: PhantomData<(&'a Scene<'a>, &'a mut SetupRecord)>,
}

// SAFETY: what a setup changes it alone has borrowed; what it shares does not change.
unsafe impl<T: Target> Send for Setup<'_, T> {}

impl<'a, T: Target> Setup<'a, T> {
    /// Sets a scene up. `rows`: of a depth buffer, those of the largest strip that is drawn in one part. The memory is divided
    /// among all that the scene has, and what is left is the renderer's: more of it takes fewer instructions, and changes no pixel.
    /// [`Error::Capacity`]: [`SetupError::missing`] says how many words the memory lacks. [`Error::Range`]: `rows` is none or more
    /// than the screen has, where there is a depth buffer. [`Error::Combination`]: the target's pixels are not those that the scene
    /// asks for. Any other error is that of a part of the image.
    pub fn new(scene: &'a Scene<'_>, rows: u16, record: &'a mut SetupRecord, memory: &'a mut [u64]) -> Result<Self, SetupError> {
        let image = &scene.image;
        // place pixel-format: which target a scene asks for
        if usize::from(image.pixel_bits) != 8 * size_of::<T::Pixel>() {
            let sentence = if image.pixel_bits == 16 {
                "the scene asks for pixels of RGB565: the target must be one of RGB565"
            } else {
                "the scene asks for entries of its palette: the target must be one of a palette"
            };
            return Err(SetupError::new(Error::Combination, sentence));
        }
        let parts = record.0.as_mut_ptr();
        let tables = words_of_tables(image);
        // SAFETY: the record is there for 'a, and a plan of zeros has nothing. The scene was opened, and lives for 'a.
        unsafe {
            ptr::write_bytes(parts, 0, 1);
            plan::<T>(parts, scene);
            // Without memory: it says how much is missing.
            let least = match sys::fxl_setup_init(&mut (*parts).setup, &(*parts).plan, rows, memory.as_mut_ptr().cast(), 0) {
                sys::FXL_E_CAPACITY => (*parts).setup.memory_missing.div_ceil(8),
                status => return Err(refused(parts, status, rows, memory)),
            };
            if memory.len() < tables + least {
                let mut found = refused(parts, sys::FXL_E_CAPACITY, rows, &mut []);
                found.missing = tables + least - memory.len();
                return Err(found);
            }
            let (first, rest) = memory.split_at_mut(tables);
            open_tables::<T>(parts, image, first)?;
            if has_movers(image) {
                (*parts).plan.pieces_size = u32::try_from((rest.len() - least) / 2 * 8).unwrap_or(0);
            }
            let status = sys::fxl_setup_init(&mut (*parts).setup, &(*parts).plan, rows, rest.as_mut_ptr().cast(), rest.len() * 8);
            if status != sys::FXL_OK {
                return Err(refused(parts, status, rows, rest));
            }
            // The library's renderer may be moved; what it points to stays in the record and the memory.
            let renderer = Renderer::of(ptr::read(&(*parts).setup.renderer));
            Ok(Setup { renderer, parts, _borrowed: PhantomData })
        }
    }

    /// Moves what the scene moves to where it is in a frame, and answers the eye's pose in it: that of the scene's path, which begins
    /// again after its last pose. Without a path of poses it is [`Scene::start`].
    pub fn play(&mut self, frame: u32) -> Pose {
        // SAFETY: the setup is complete, so the pose is one of the scene's. No frame is drawn: it would borrow the setup.
        unsafe { *sys::fxl_setup_frame(&mut (*self.parts).setup, frame) }
    }

    /// Begins a frame, which is then drawn in parts. It ends when it is dropped.
    pub fn begin(&mut self, eye: &Pose) -> Result<Frame<'_, 'a, T>, Error> {
        self.renderer.begin(eye)
    }

    /// Draws a whole picture, as [`Renderer::render`] does.
    ///
    /// ```
    /// # use fixel::{include_image, target, Scene, Setup, SetupRecord};
    /// # let scene = Scene::open(include_image!("../examples/cube.fxls"))?;
    /// # let (mut record, mut memory) = (SetupRecord::new(), [0_u64; 512]);
    /// # let mut it = Setup::<target::Palette>::new(&scene, 1, &mut record, &mut memory)?;
    /// let mut pixels = vec![0_u8; 320 * 240];
    /// let eye = it.play(0);
    /// it.render(&eye, &mut pixels)?;
    /// # Ok::<(), fixel::Error>(())
    /// ```
    pub fn render(&mut self, eye: &Pose, pixels: &mut [T::Pixel]) -> Result<(), Error> {
        self.renderer.render(eye, pixels)
    }

    /// Another light in the place of the scene's own. The record is memory of the caller's.
    pub fn attach_light(&mut self, light: &'a mut Light, settings: &LightSettings<'a>) -> Result<(), Error> {
        self.renderer.attach_light(light, settings)
    }

    /// Width and height of the screen in pixels.
    pub fn size(&self) -> (u16, u16) {
        self.renderer.size()
    }
}

/// Why a part was refused.
///
/// # Safety
///
/// The plan of the parts is complete, and the memory is that of the call that was refused.
unsafe fn refused(parts: *const Parts, status: sys::fxl_status, rows: u16, memory: &mut [u64]) -> SetupError {
    let error = check(status).err().unwrap_or(Error::Order);
    let text = sys::fxl_setup_explain(&(*parts).setup, &(*parts).plan, rows, memory.as_ptr().cast(), memory.len() * 8);
    SetupError::explained(error, text)
}

const TEXTURE: usize = size_of::<sys::fxl_texture>();
const BILLBOARD: usize = size_of::<sys::fxl_billboard>();
const SPRITE: usize = size_of::<sys::fxl_sprite>();

/// Words of the records of textures, billboards and sprites, each kind from a whole word on.
fn words_of_tables(image: &sys::fxl_scene_image) -> usize {
    let (textures, billboards) = (image.surfaces.texture_count as usize, image.billboards.count as usize);
    (textures * TEXTURE).div_ceil(8) + (billboards * BILLBOARD).div_ceil(8) + (billboards * SPRITE).div_ceil(8)
}

/// Writes what a scene has but for surfaces and billboards, and what sets each part up.
///
/// # Safety
///
/// The parts are all zeros; the image was opened.
unsafe fn plan<T: Target>(parts: *mut Parts, scene: &Scene<'_>) {
    let image = &scene.image;
    (*parts).config = sys::fxl_config_for(image.lens.width, image.lens.height, T::target());
    (*parts).config.fov = scene.fov;
    (*parts).config.near_z = image.lens.near_z;
    (*parts).config.far_z = image.lens.far_z;
    (*parts).config.inset = image.lens.inset;
    (*parts).config.background = image.background;
    if size_of::<T::Pixel>() == 2 {
        let palette: &[[u8; 3]; 256] = &*image.palette.cast();
        (*parts).palette = palette.map(|[red, green, blue]| crate::rgb565(red, green, blue));
        (*parts).config.palette = (&raw const (*parts).palette).cast();
    }
    let plan = &mut (*parts).plan;
    plan.scene = &image.scene;
    plan.config = &raw const (*parts).config;
    plan.init_renderer = Some(sys::fxl_renderer_init);
    plan.palette = image.palette;
    plan.start = &image.start.pose;
    if !image.poses.is_null() {
        plan.path = image.poses;
        plan.path_count = image.path_count;
    }
    if !image.lens.off_centre.is_null() {
        plan.centre_x = image.lens.centre_x;
        plan.centre_y = image.lens.centre_y;
        plan.set_centre = Some(sys::fxl_renderer_set_centre);
    }
    if image.scale != 0 {
        plan.scale = image.scale;
        plan.set_orthographic = Some(sys::fxl_renderer_set_orthographic);
    }
    if !image.scene.bsp_nodes.is_null() && !image.by_distance {
        plan.order = &raw const sys::fxl_by_tree;
    }
    if image.motion.motion_count != 0 {
        plan.motions = &image.motion;
        plan.begin_motions = Some(sys::fxl_motion_begin);
        plan.play_motions = Some(sys::fxl_motion_play);
    }
    if image.scene.beam_count != 0 {
        plan.beam_memory_size = Some(sys::fxl_beam_light_workspace_size);
        plan.attach_beams = Some(sys::fxl_attach_beams);
    }
    if !image.light.base.is_null() {
        sys::fxl_light_settings_of(&image.light, &raw mut (*parts).light);
        plan.light = &raw const (*parts).light;
        plan.attach_light = Some(sys::fxl_attach_light);
    }
    if !image.horizon.sines.is_null() {
        (*parts).horizon = image.horizon;
        plan.horizon = &raw const (*parts).horizon;
        plan.attach_horizon = Some(sys::fxl_attach_horizon);
    }
}

/// Opens surfaces and billboards in memory of `words_of_tables`, and adds them to the plan.
///
/// # Safety
///
/// The image was opened; image and memory live as long as the parts are used.
unsafe fn open_tables<T: Target>(parts: *mut Parts, image: &sys::fxl_scene_image, memory: &mut [u64]) -> Result<(), SetupError> {
    let (textures, billboards) = (image.surfaces.texture_count as usize, image.billboards.count as usize);
    let (first, rest) = memory.split_at_mut((textures * TEXTURE).div_ceil(8));
    let (boards, sprites) = rest.split_at_mut((billboards * BILLBOARD).div_ceil(8));
    let plan = &mut (*parts).plan;
    if !image.surfaces.face_map.is_null() {
        let (own, count) = (&raw mut (*parts).surfaces, image.surfaces.texture_count);
        let status = sys::fxl_surfaces_open(image, first.as_mut_ptr().cast(), count, own, ptr::null_mut());
        explain(status, &raw const sys::fxl_surfaces_reasons)?;
        plan.surfaces = own;
        plan.painter = T::surfaces();
        plan.attach_surfaces = Some(sys::fxl_attach_surfaces);
        if !image.light.base.is_null() {
            plan.attach_lit = Some(sys::fxl_attach_lit);
        }
    }
    if !image.billboards.model_map.is_null() {
        let (own, count) = (&raw mut (*parts).billboards, image.billboards.count);
        let status = sys::fxl_billboards_open(image, sprites.as_mut_ptr().cast(), boards.as_mut_ptr().cast(), count, own, ptr::null_mut());
        explain(status, &raw const sys::fxl_billboards_reasons)?;
        plan.billboards = own;
        plan.sprite_painter = T::sprites();
        plan.attach_billboards = Some(sys::fxl_attach_billboards);
    }
    Ok(())
}

/// A status with the sentence that a header has for it.
fn explain<R>(status: sys::fxl_status, reasons: *const R) -> Result<(), SetupError> {
    // SAFETY: the reasons are a constant list of the library's.
    check(status).map_err(|error| unsafe { SetupError::explained(error, sys::fxl_explain(reasons.cast(), status)) })
}

/// Whether instances are cut to the leaves of the scene's tree.
fn has_movers(image: &sys::fxl_scene_image) -> bool {
    let scene = &image.scene;
    if scene.bsp_nodes.is_null() || image.by_distance {
        return false;
    }
    // SAFETY: the tables of an open scene are as long as their counts, and the tree's instance is one of them.
    let instances = unsafe { slice::from_raw_parts(scene.instances, scene.instance_count as usize) };
    let layer = instances.get(scene.bsp_instance as usize).map(|each| each.layer);
    instances.iter().filter(|each| Some(each.layer) == layer).count() > 1
}
