// SPDX-License-Identifier: MIT
use fixel_sys as sys;

use crate::error::{check, Error};

/// A point or a distance vector of the world, in units of 1/65536.
///
/// ```
/// use fixel::{units, Point};
///
/// let eye = Point { x: 0, y: units(2), z: units(-8) };
/// assert_eq!(eye.y, 131_072);
/// ```
pub type Point = sys::fxl_point;

/// Position and direction of the eye. Yaw turns from +z towards +x, pitch raises the view, roll turns it.
///
/// ```
/// use fixel::{degrees, units, Point, Pose};
///
/// let eye = Pose { position: Point { x: 0, y: units(2), z: units(-8) }, yaw: degrees(5), pitch: 0, roll: 0 };
/// assert_eq!(eye.yaw, 59_652_324);
/// ```
pub type Pose = sys::fxl_pose;

/// `n` world units.
///
/// ```
/// assert_eq!(fixel::units(-3), -196_608);
/// ```
pub const fn units(n: i16) -> i32 {
    n as i32 * 65536
}

/// `n / d` world units, to the nearest 1/65536. `d` must be above 0; the result saturates.
///
/// ```
/// assert_eq!(fixel::ratio(1, 4), 16_384);
/// ```
pub const fn ratio(n: i32, d: u32) -> i32 {
    let d = if d == 0 { 1 } else { d as i64 };
    let value = (131_072 * n as i64 + d).div_euclid(2 * d);
    if value > i32::MAX as i64 {
        i32::MAX
    } else if value < i32::MIN as i64 {
        i32::MIN
    } else {
        value as i32
    }
}

/// `n` degrees as a binary angle, of which a full turn is 2³²; it wraps.
///
/// ```
/// assert_eq!(fixel::degrees(90), 0x4000_0000);
/// assert_eq!(fixel::degrees(-90), fixel::degrees(270));
/// ```
pub const fn degrees(n: i32) -> u32 {
    (n as i64 * 8_589_934_592 + 360).div_euclid(720) as u32
}

/// A colour of three bytes as a pixel of RGB565.
///
/// ```
/// assert_eq!(fixel::rgb565(255, 0, 255), 0xF81F);
/// ```
pub const fn rgb565(red: u8, green: u8, blue: u8) -> u16 {
    (red as u16 / 8) << 11 | (green as u16 / 4) << 5 | (blue as u16 / 8)
}

/// How an instance is turned.
///
/// ```
/// use fixel::{degrees, Orientation};
///
/// let quarter = Orientation::from_angles(degrees(90), 0, 0)?;
/// let half = quarter.after(&quarter)?;
/// assert_eq!(half, Orientation::from_angles(degrees(180), 0, 0)?);
/// # Ok::<(), fixel::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Orientation(pub(crate) sys::fxl_orientation);

impl Orientation {
    /// The one that turns nothing.
    pub const NONE: Self = {
        const ONE: i32 = sys::FXL_Q2_30_ONE;
        Orientation(sys::fxl_orientation {
            x: sys::fxl_direction { x: ONE, y: 0, z: 0 },
            y: sys::fxl_direction { x: 0, y: ONE, z: 0 },
            z: sys::fxl_direction { x: 0, y: 0, z: ONE },
        })
    };

    /// By the angles of a [`Pose`]: a model's z axis goes to where such a camera looks.
    pub fn from_angles(yaw: u32, pitch: u32, roll: u32) -> Result<Self, Error> {
        let mut made = Self::NONE;
        // SAFETY: the pointer is that of a record of ours.
        check(unsafe { sys::fxl_orientation_from_angles(yaw, pitch, roll, &mut made.0) })?;
        Ok(made)
    }

    /// By an angle about an axis of any length above 0.
    pub fn from_axis(axis: &Point, angle: u32) -> Result<Self, Error> {
        let mut made = Self::NONE;
        // SAFETY: as above.
        check(unsafe { sys::fxl_orientation_from_axis(axis, angle, &mut made.0) })?;
        Ok(made)
    }

    /// By a quaternion `[w, x, y, z]` of any norm above 0, each number at most 2³⁰ in magnitude.
    pub fn from_quaternion([w, x, y, z]: [i32; 4]) -> Result<Self, Error> {
        let mut made = Self::NONE;
        // SAFETY: as above.
        check(unsafe { sys::fxl_orientation_from_quaternion(&sys::fxl_quaternion { w, x, y, z }, &mut made.0) })?;
        Ok(made)
    }

    /// Its quaternion `[w, x, y, z]` in units of 2⁻³⁰, with w not below 0.
    pub fn to_quaternion(&self) -> Result<[i32; 4], Error> {
        let mut made = sys::fxl_quaternion { w: 0, x: 0, y: 0, z: 0 };
        // SAFETY: as above.
        check(unsafe { sys::fxl_orientation_to_quaternion(&self.0, &mut made) })?;
        Ok([made.w, made.x, made.y, made.z])
    }

    /// The rotation that applies `first` and then this one.
    pub fn after(&self, first: &Self) -> Result<Self, Error> {
        let mut made = Self::NONE;
        // SAFETY: as above.
        check(unsafe { sys::fxl_orientation_multiply(&self.0, &first.0, &mut made.0) })?;
        Ok(made)
    }
}
