// SPDX-License-Identifier: MIT
use core::marker::PhantomData;
use core::mem::MaybeUninit;
use core::ptr;

use fixel_sys as sys;

use crate::error::{check, Error};
use crate::scene::Scene;

/// Memory for a texture of a [`SurfaceSet`].
///
/// ```
/// let textures = [fixel::Texture::EMPTY; 8];
/// # let _ = textures;
/// ```
#[derive(Clone, Copy)]
#[repr(transparent)]
pub struct Texture(MaybeUninit<sys::fxl_texture>);

impl Texture {
    /// What memory is filled with before it is given to a set.
    pub const EMPTY: Self = Texture(MaybeUninit::uninit());
}

/// The surfaces of a scene: what its faces show instead of one colour.
///
/// ```
/// use fixel::{include_image, Error, Scene, SurfaceSet, Texture};
///
/// let scene = Scene::open(include_image!("../examples/cube.fxls"))?;
/// let mut textures = [Texture::EMPTY; 4];
/// assert_eq!(SurfaceSet::open(&scene, &mut textures).err(), Some(Error::Argument)); // it has none
/// # Ok::<(), Error>(())
/// ```
pub struct SurfaceSet<'a> {
    pub(crate) raw: sys::fxl_surface_set,
    /// Those of the scene that the set belongs to: its map has an entry for each.
    pub(crate) faces: *const sys::fxl_face,
    _memory: PhantomData<(&'a Scene<'a>, &'a [Texture])>,
}

impl<'a> SurfaceSet<'a> {
    /// Opens those of a scene, and checks them. [`Error::Argument`]: it has none. [`Error::Capacity`]: more textures than there is
    /// memory for.
    pub fn open(scene: &'a Scene<'a>, textures: &'a mut [Texture]) -> Result<Self, Error> {
        let mut set = MaybeUninit::uninit();
        let count = u32::try_from(textures.len()).unwrap_or(u32::MAX);
        // SAFETY: the scene is open; the memory is that long.
        let raw = unsafe {
            check(sys::fxl_surfaces_open(&scene.image, textures.as_mut_ptr().cast(), count, set.as_mut_ptr(), ptr::null_mut()))?;
            set.assume_init()
        };
        Ok(SurfaceSet { raw, faces: scene.image.scene.faces, _memory: PhantomData })
    }
}

/// What a renderer with surfaces keeps; the caller owns it.
///
/// ```
/// let surfaces = fixel::Surfaces::new();
/// # let _ = surfaces;
/// ```
pub struct Surfaces(pub(crate) MaybeUninit<sys::fxl_surfaces>);

impl Surfaces {
    /// One that is attached to no renderer.
    pub const fn new() -> Self {
        Surfaces(MaybeUninit::zeroed())
    }
}

impl Default for Surfaces {
    fn default() -> Self {
        Self::new()
    }
}

/// What a renderer with smooth light on its surfaces keeps; the caller owns it.
///
/// ```
/// let lit = fixel::LitSurfaces::new();
/// # let _ = lit;
/// ```
pub struct LitSurfaces(pub(crate) MaybeUninit<sys::fxl_lit_surfaces>);

impl LitSurfaces {
    /// One that is attached to no renderer.
    pub const fn new() -> Self {
        LitSurfaces(MaybeUninit::zeroed())
    }
}

impl Default for LitSurfaces {
    fn default() -> Self {
        Self::new()
    }
}

/// What a renderer with light keeps; the caller owns it.
///
/// ```
/// let light = fixel::Light::new();
/// # let _ = light;
/// ```
pub struct Light(pub(crate) MaybeUninit<sys::fxl_light>);

impl Light {
    /// One that is attached to no renderer.
    pub const fn new() -> Self {
        Light(MaybeUninit::zeroed())
    }
}

impl Default for Light {
    fn default() -> Self {
        Self::new()
    }
}

/// The light of a scene.
///
/// ```
/// # let scene = fixel::Scene::open(fixel::include_image!("../examples/cube.fxls"))?;
/// assert!(fixel::LightSettings::of(&scene).is_none()); // this scene has none
/// # Ok::<(), fixel::Error>(())
/// ```
pub struct LightSettings<'a> {
    pub(crate) raw: sys::fxl_light_settings,
    _ramp: PhantomData<&'a Scene<'a>>,
}

impl<'a> LightSettings<'a> {
    /// That of a scene; `None`: it has none.
    pub fn of(scene: &'a Scene<'_>) -> Option<Self> {
        if scene.image.light.base.is_null() {
            return None;
        }
        let mut raw = MaybeUninit::zeroed();
        // SAFETY: the image was opened, and has a light.
        unsafe {
            sys::fxl_light_settings_of(&scene.image.light, raw.as_mut_ptr());
            Some(LightSettings { raw: raw.assume_init(), _ramp: PhantomData })
        }
    }
}
