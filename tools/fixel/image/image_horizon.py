# SPDX-License-Identifier: MIT
"""The horizon of a scene image: what the library asks of it (docs/formats.md, section 1.15)."""

from typing import NamedTuple

from fixel.image.c_text import record, table
from fixel.image.fields import SECTIONS, KINDS, entry
from fixel.image.image_tree import fail

ONE = 1 << 30
LEVELS_MAX = SECTIONS[KINDS["horizon"] - 1].most    # sines
SINE = entry("horizon")
INCLUDE = "fixel/horizon.h"


class Horizon(NamedTuple):
    """sines: in 2.30, ascending; colours: one more, from the nadir up."""
    sines: tuple
    colours: tuple


def tables(horizon):
    """A horizon as packed bytes, by name; nothing without one."""
    return {"horizon": [SINE.pack(sine) for sine in horizon.sines], "horizon colours": bytes(horizon.colours)} if horizon else {}


def read(found):
    """The horizon of an image; None: it has none. found: {name of a table: its entries}."""
    sines, colours = tuple(sine for sine, in found["horizon"]), tuple(found["horizon colours"])
    if not sines:
        return None
    for number, (low, sine) in enumerate(zip((-ONE, *sines), sines)):
        if not low <= sine <= ONE:
            fail("range", f"sine {number} of the horizon is outside -1..1, or below the one before it")
    return Horizon(sines, colours)


def text(scene, name):
    """The tables and the record of a scene's horizon as text of C; nothing without."""
    if not scene.horizon:
        return []
    return [table("fxl_q2_30", f"{name}_horizon_sines", [str(sine) for sine in scene.horizon.sines], "Sines of elevations in 2.30."),
            table("uint8_t", f"{name}_horizon_colours", [str(colour) for colour in scene.horizon.colours], "Of each level, that of the nadir first."),
            record("fxl_horizon", f"{name}_horizon", [f"{name}_horizon_sines, {name}_horizon_colours, {len(scene.horizon.sines)}"],
                   "For fxl_attach_horizon.")]
