// SPDX-License-Identifier: MIT
use core::marker::PhantomData;
use core::{ptr, slice};

use fixel_sys as sys;

use crate::error::{check, Error};
use crate::numbers::{Orientation, Point};
use crate::scene::Scene;

/// Memory for an instance of a [`MovableScene`].
///
/// ```
/// let instances = [fixel::Instance::EMPTY; 4];
/// # let _ = instances;
/// ```
#[derive(Clone, Copy)]
#[repr(transparent)]
pub struct Instance(sys::fxl_instance);

impl Instance {
    /// What memory is filled with before it is given to a scene.
    pub const EMPTY: Self = Instance(sys::fxl_instance { centre: Point { x: 0, y: 0, z: 0 }, model: 0, layer: 0, recolour: 0 });
}

/// How an instance is turned and scaled, and memory for it.
///
/// ```
/// use fixel::{degrees, units, Orientation, Placement};
///
/// let turned = Placement::new(Orientation::from_angles(degrees(30), 0, 0)?, units(1));
/// # let _ = turned;
/// # Ok::<(), fixel::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(transparent)]
pub struct Placement(sys::fxl_placement);

impl Placement {
    /// The one that neither turns nor scales.
    pub const NONE: Self = Self::new(Orientation::NONE, 65536);

    /// An orientation, and a scale in units of 1/65536.
    pub const fn new(orientation: Orientation, scale: i32) -> Self {
        Placement(sys::fxl_placement { orientation: orientation.0, scale })
    }
}

/// A scene whose instances move, turn and scale. The models stay where they are; the instances are copied into
/// memory of the caller's. [`Renderer::place`](crate::Renderer::place) changes them between frames.
///
/// ```
/// use fixel::{degrees, include_image, target, units, Config, Instance, MovableScene, Orientation, Placement, Renderer, Scene};
///
/// let scene = Scene::open(include_image!("../examples/cube.fxls"))?;
/// let (mut instances, mut placements) = ([Instance::EMPTY; 1], [Placement::NONE; 1]);
/// let mut movable = MovableScene::new(&scene, &mut instances, &mut placements)?;
/// let mut memory = [0_u64; 512];
/// let mut renderer = Renderer::<target::Palette>::new(&mut movable, Config::new(64, 48), &mut memory)?;
/// let mut pixels = [[0_u8; 64 * 48]; 2];
///
/// for (step, pixels) in pixels.iter_mut().enumerate() {
///     renderer.place(0, &Placement::new(Orientation::from_angles(degrees(30 * step as i32), 0, 0)?, units(1)))?;
///     renderer.render(&scene.start(), pixels)?;
/// }
/// assert_ne!(pixels[0], pixels[1]);
/// # Ok::<(), fixel::Error>(())
/// ```
pub struct MovableScene<'a> {
    scene: sys::fxl_scene,
    tables: Tables,
    _memory: PhantomData<(&'a Scene<'a>, &'a mut [Instance], &'a mut [Placement])>,
}

// SAFETY: the tables are borrowed by the scene alone.
unsafe impl Send for MovableScene<'_> {}

impl<'a> MovableScene<'a> {
    /// Takes memory for all instances of a scene. [`Error::Capacity`]: it is too small. [`Error::Bsp`]: the scene has a tree, whose
    /// instance cannot move.
    pub fn new(scene: &'a Scene<'a>, instances: &'a mut [Instance], placements: &'a mut [Placement]) -> Result<Self, Error> {
        let count = scene.instances();
        if instances.len() < count || placements.len() < count {
            return Err(Error::Capacity);
        }
        let mut made = scene.image.scene;
        if made.bsp_node_count != 0 {
            return Err(Error::Bsp);
        }
        // SAFETY: the tables of an open scene are as long as their counts.
        let theirs = unsafe { slice::from_raw_parts(made.instances, count) };
        for (own, instance) in instances.iter_mut().zip(theirs) {
            own.0 = *instance;
        }
        for (number, own) in placements[..count].iter_mut().enumerate() {
            *own = Placement::NONE;
            if !made.placements.is_null() && number >= made.first_turned as usize {
                // SAFETY: there is one for each instance from first_turned on.
                own.0 = unsafe { *made.placements.add(number - made.first_turned as usize) };
            }
        }
        let tables = Tables { instances: instances.as_mut_ptr().cast(), placements: placements.as_mut_ptr().cast() };
        made.instances = tables.instances;
        made.placements = tables.placements;
        made.first_turned = 0;
        // SAFETY: all tables are as long as their counts.
        check(unsafe { sys::fxl_scene_check_all(&mut made, ptr::null_mut()) })?;
        Ok(MovableScene { scene: made, tables, _memory: PhantomData })
    }
}

/// The instances that a renderer may change.
#[derive(Clone, Copy)]
#[doc(hidden)]
pub struct Tables {
    pub(crate) instances: *mut sys::fxl_instance,
    pub(crate) placements: *mut sys::fxl_placement,
}

mod sealed {
    pub trait Sealed {}
}

/// What a renderer draws: `&Scene`, which several may draw, or `&mut MovableScene`, which one draws and moves.
pub trait Drawn<'a>: sealed::Sealed {
    #[doc(hidden)]
    fn parts(self) -> (*const sys::fxl_scene, Option<Tables>);
}

impl sealed::Sealed for &Scene<'_> {}
impl sealed::Sealed for &mut MovableScene<'_> {}

impl<'a> Drawn<'a> for &'a Scene<'_> {
    fn parts(self) -> (*const sys::fxl_scene, Option<Tables>) {
        (&self.image.scene, None)
    }
}

impl<'a> Drawn<'a> for &'a mut MovableScene<'_> {
    fn parts(self) -> (*const sys::fxl_scene, Option<Tables>) {
        (&self.scene, Some(self.tables))
    }
}
