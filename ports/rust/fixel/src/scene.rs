// SPDX-License-Identifier: MIT
use core::marker::PhantomData;
use core::mem::MaybeUninit;
use core::ptr;

use fixel_sys as sys;

use crate::error::{check, Error};
use crate::numbers::{rgb565, Pose};

/// A scene image, checked once and then used in place: in flash, it takes no RAM for its tables.
///
/// ```
/// use fixel::{include_image, Scene};
///
/// static CUBE: &[u8] = include_image!("../examples/cube.fxls");
/// let scene = Scene::open(CUBE)?;
/// assert_eq!(scene.instances(), 1);
/// # Ok::<(), fixel::Error>(())
/// ```
///
/// The image must outlive the scene:
///
/// ```compile_fail
/// let scene = {
///     let image = vec![0_u8; 4096];
///     fixel::Scene::open(&image)
/// };
/// drop(scene);
/// ```
pub struct Scene<'a> {
    pub(crate) image: sys::fxl_scene_image,
    pub(crate) fov: u32,
    _bytes: PhantomData<&'a [u8]>,
}

// SAFETY: nothing of a scene changes once it is open.
unsafe impl Send for Scene<'_> {}
unsafe impl Sync for Scene<'_> {}

impl<'a> Scene<'a> {
    /// Opens an image, which must be aligned to 4 bytes ([`include_image!`](crate::include_image)). Everything in
    /// it is checked before it is used.
    pub fn open(image: &'a [u8]) -> Result<Self, Error> {
        let mut opened = MaybeUninit::uninit();
        // SAFETY: the bytes live for 'a, and are as many as stated. An image that is refused leaves `opened` as it is.
        check(unsafe { sys::fxl_scene_open(image.as_ptr().cast(), image.len(), opened.as_mut_ptr(), ptr::null_mut()) })?;
        // SAFETY: FXL_OK: the record is written.
        let opened = unsafe { opened.assume_init() };
        Ok(Scene { image: opened, fov: field_of_view(image), _bytes: PhantomData })
    }

    /// Where the scene's path begins.
    ///
    /// ```
    /// # let scene = fixel::Scene::open(fixel::include_image!("../examples/cube.fxls"))?;
    /// let mut eye = scene.start();
    /// eye.yaw = eye.yaw.wrapping_add(fixel::degrees(10));
    /// # Ok::<(), fixel::Error>(())
    /// ```
    pub fn start(&self) -> Pose {
        self.image.start.pose
    }

    /// The poses of the scene's path, one a frame; none if the path is made of segments.
    ///
    /// ```
    /// # let scene = fixel::Scene::open(fixel::include_image!("../examples/cube.fxls"))?;
    /// for eye in scene.poses() {
    ///     println!("{eye:?}");
    /// }
    /// # Ok::<(), fixel::Error>(())
    /// ```
    pub fn poses(&self) -> &[Pose] {
        if self.image.poses.is_null() {
            return &[];
        }
        // SAFETY: the table has been checked, and is that long.
        unsafe { core::slice::from_raw_parts(self.image.poses, self.image.path_count as usize) }
    }

    /// How many instances the scene has.
    ///
    /// ```
    /// # let scene = fixel::Scene::open(fixel::include_image!("../examples/cube.fxls"))?;
    /// assert_eq!(scene.instances(), 1);
    /// # Ok::<(), fixel::Error>(())
    /// ```
    pub fn instances(&self) -> usize {
        self.image.scene.instance_count as usize
    }

    /// Width and height of the screen that the scene was made for.
    ///
    /// ```
    /// # let scene = fixel::Scene::open(fixel::include_image!("../examples/cube.fxls"))?;
    /// assert_eq!(scene.size(), (320, 240));
    /// # Ok::<(), fixel::Error>(())
    /// ```
    pub fn size(&self) -> (u16, u16) {
        (self.image.lens.width, self.image.lens.height)
    }

    /// Bits of a pixel that the scene was made for: 8, an entry of the palette, or 16, RGB565.
    ///
    /// ```
    /// # let scene = fixel::Scene::open(fixel::include_image!("../examples/cube.fxls"))?;
    /// assert_eq!((scene.pixel_bits(), scene.depth_bits()), (8, 0));
    /// # Ok::<(), fixel::Error>(())
    /// ```
    pub fn pixel_bits(&self) -> u8 {
        self.image.pixel_bits
    }

    /// Bits of a pixel in the depth buffer that the scene asks for: 0, 16 or 32.
    pub fn depth_bits(&self) -> u8 {
        self.image.depth_bits
    }

    /// The palette: 256 colours of red, green, blue.
    ///
    /// ```
    /// # let scene = fixel::Scene::open(fixel::include_image!("../examples/cube.fxls"))?;
    /// let [red, green, blue] = scene.palette()[1];
    /// # let _ = (red, green, blue);
    /// # Ok::<(), fixel::Error>(())
    /// ```
    pub fn palette(&self) -> &[[u8; 3]; 256] {
        // SAFETY: an image that was opened has a palette of 768 bytes.
        unsafe { &*self.image.palette.cast() }
    }

    /// The palette as an RGB565 target takes it.
    ///
    /// ```
    /// # let scene = fixel::Scene::open(fixel::include_image!("../examples/cube.fxls"))?;
    /// let palette: [u16; 256] = scene.palette_565();
    /// # let _ = palette;
    /// # Ok::<(), fixel::Error>(())
    /// ```
    pub fn palette_565(&self) -> [u16; 256] {
        self.palette().map(|[red, green, blue]| rgb565(red, green, blue))
    }
}

/// The field of view of an image that was opened, at its place of docs/formats.md: the record of the library has only the focal length.
fn field_of_view(image: &[u8]) -> u32 {
    image.get(20..24).and_then(|bytes| bytes.try_into().ok()).map_or(0, u32::from_le_bytes)
}
