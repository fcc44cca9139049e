# SPDX-License-Identifier: MIT
"""Scene images: written, read and checked; scenes and fonts as C.

For `fixel build`, `info`, `export` and `font`. `image.py` packs and reads a whole image, and the modules `image_*.py` its sections. The
modules `c_*.py` write scenes and fonts as C, and `bdf.py` reads fonts. `font.py` is the command. `fields.py` states every field of an image
once; `formats.py`, the command `fixel formats`, writes of it what C and docs/formats.md say."""
