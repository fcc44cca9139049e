# SPDX-License-Identifier: MIT
"""How many bytes the site has, and as a server packs it; and its pictures in fewer: each as lossless WebP where that is smaller, and once."""

import gzip
import os
import pathlib
import re
import urllib.parse

from fixel.base.errors import ToolError
from fixel.commands import late

Image = late("PIL.Image")

MOST, MOST_PACKED = 12 << 20, 4 << 20   # bytes of the site
IS_PACKED = (".png", ".webp")
LEVEL = 9               # of gzip
PICTURE = re.compile(r'\b(src|href)="([^":?#]+\.png)"')
OF_THE_THEME = "_static"    # whose pictures its styles name too


def packed(file):
    """Bytes of a file as a server packs it."""
    return file.stat().st_size if file.suffix in IS_PACKED else len(gzip.compress(file.read_bytes(), LEVEL))


def sizes(files):
    """(bytes of files, the same as a server packs them)."""
    files = list(files)
    return sum(file.stat().st_size for file in files), sum(map(packed, files))


def check(total, as_packed):
    """Refuses a site that is too large."""
    for has, most, how in ((total, MOST, "bytes"), (as_packed, MOST_PACKED, "bytes as a server packs it")):
        if has > most:
            raise ToolError(f"the site has {has:,} {how}, of at most {most:,}")


def _smaller(file):
    """The picture as WebP in its place where that is smaller; its file."""
    made = file.with_suffix(".webp")
    with Image.open(file) as picture:
        picture.convert("RGBA" if "A" in picture.mode or "transparency" in picture.info else "RGB").save(made, "WEBP", lossless=True, exact=True)
    kept, left = (made, file) if made.stat().st_size < file.stat().st_size else (file, made)
    left.unlink()
    return kept


def pack_pictures(folder):
    """Each PNG of the folder becomes smaller, and those that are equal become one; the pages name what there is then."""
    seen, moved = {}, {}
    for file in sorted(folder.rglob("*.png")):
        if OF_THE_THEME in file.parts:
            continue
        content = file.read_bytes()
        if content in seen:
            file.unlink()
        else:
            seen[content] = _smaller(file)
        moved[file] = seen[content]
    for page in folder.rglob("*.html"):
        def named(found, page=page):
            file = pathlib.Path(os.path.normpath(page.parent / urllib.parse.unquote(found[2])))
            return f'{found[1]}="{urllib.parse.quote(os.path.relpath(moved[file], page.parent))}"' if file in moved else found[0]
        page.write_text(PICTURE.sub(named, page.read_text(encoding="utf-8")), encoding="utf-8")
