// SPDX-License-Identifier: MIT
use core::ffi::CStr;
use core::fmt;

use fixel_sys as sys;

macro_rules! errors {
    ($($name:ident = $status:ident: $about:literal,)*) => {
        /// Why a call was refused: one for each status of the C library. The call has changed nothing.
        ///
        /// ```
        /// use fixel::{Error, Scene};
        ///
        /// static CUBE: &[u8] = fixel::include_image!("../examples/cube.fxls");
        /// assert_eq!(Scene::open(&CUBE[..40]).err(), Some(Error::Size));
        /// assert!(!Error::Size.to_str().is_empty());
        /// ```
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum Error {
            $(#[doc = $about] $name,)*
            /// A status that this version of the crate does not know.
            Unknown(u32),
        }

        impl Error {
            /// The status of the C library.
            ///
            /// ```
            /// assert_eq!(fixel::Error::Range.status(), fixel::sys::FXL_E_RANGE);
            /// ```
            pub fn status(self) -> sys::fxl_status {
                match self {
                    $(Error::$name => sys::$status,)*
                    Error::Unknown(status) => status,
                }
            }

            fn from_status(status: sys::fxl_status) -> Self {
                match status {
                    $(sys::$status => Error::$name,)*
                    other => Error::Unknown(other),
                }
            }
        }
    };
}

errors! {
    Argument = FXL_E_ARGUMENT: "An argument is missing, such as the palette of an RGB565 target.",
    Range = FXL_E_RANGE: "A number is outside its stated range.",
    Capacity = FXL_E_CAPACITY: "Memory of the caller's is too small.",
    Degenerate = FXL_E_DEGENERATE: "Fewer than three vertices, or vertices on one line.",
    Order = FXL_E_ORDER: "A call out of order.",
    Alignment = FXL_E_ALIGNMENT: "Memory or an image is not aligned.",
    Size = FXL_E_SIZE: "An image is cut off.",
    Magic = FXL_E_MAGIC: "This is no scene image.",
    Version = FXL_E_VERSION: "A scene image of another version.",
    Crc = FXL_E_CRC: "The checksum does not match.",
    Offset = FXL_E_OFFSET: "A table of an image is not where it must be.",
    Count = FXL_E_COUNT: "A count is outside its stated range.",
    Index = FXL_E_INDEX: "A number is past the end of its table.",
    Normal = FXL_E_NORMAL: "A normal is not of unit length.",
    Planarity = FXL_E_PLANARITY: "A vertex lies off the plane of its face.",
    Reserved = FXL_E_RESERVED: "A reserved field holds an unknown value.",
    Radius = FXL_E_RADIUS: "A vertex is outside the sphere that must hold it.",
    FaceBounds = FXL_E_FACE_BOUNDS: "The bounds of a face are not those of its vertices.",
    Bsp = FXL_E_BSP: "A tree is too deep, or an instance may not be with it.",
    Cluster = FXL_E_CLUSTER: "A face of a cluster may be seen from the cluster's cone.",
    Placement = FXL_E_PLACEMENT: "An orientation is no rotation.",
    Display = FXL_E_DISPLAY: "A display, or the wires to it, failed.",
    Stale = FXL_E_STALE: "The handle of an instance that was removed.",
    Combination = FXL_E_COMBINATION: "Two things that a renderer has do not go together.",
}

impl Error {
    /// One English sentence, as the C library has it.
    ///
    /// ```
    /// println!("{}", fixel::Error::Crc.to_str());
    /// ```
    pub fn to_str(self) -> &'static str {
        // SAFETY: the function takes any number, and answers a constant string that ends in 0.
        let text = unsafe { CStr::from_ptr(sys::fxl_status_text(self.status())) };
        text.to_str().unwrap_or("an unknown status")
    }
}

impl fmt::Display for Error {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.to_str())
    }
}

impl core::error::Error for Error {}

/// What a status means.
pub(crate) fn check(status: sys::fxl_status) -> Result<(), Error> {
    match status {
        sys::FXL_OK => Ok(()),
        other => Err(Error::from_status(other)),
    }
}
