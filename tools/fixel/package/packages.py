# SPDX-License-Identifier: MIT
"""Writes the packages of Arduino, PlatformIO, ESP-IDF, Zephyr, Conan and Rust: the library's sources, and each one's own manifests.

All come from one table, layouts.toml. Exit: 0 written, 2 a file cannot be written or there is no such package.
"""

import argparse
import pathlib
import tomllib

from fixel.base import output
from fixel.base.errors import ToolError
from fixel.base.nearest import question
from fixel.base.version import version
from fixel.commands import late

one_file, rust_bindings = late("fixel.package", "one_file rust_bindings")
examples, making, image = late("fixel.report", "examples"), late("fixel.scene", "making"), late("fixel.image", "image")

ROOT = pathlib.Path(__file__).resolve().parents[3]
TABLE = pathlib.Path(__file__).with_name("layouts.toml")
ABOUT = "Fixed-point 3-D renderer for microcontrollers"
CONFIG = "fixel/config.h"
# Builds of packages give C another -O than assembly, or assembly none (Arduino: -Os to C alone); both read this.
NEVER_BY_O = ("#define FXL_CONFIG_H\n", """#define FXL_CONFIG_H

/* As packaged, the library is compact only if the build says so, to C and assembly alike. */
#ifndef FXL_COMPACT
#define FXL_COMPACT 0
#endif
""")


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--only", default="", metavar="PACKAGE", help="one of them: arduino, platformio, esp-idf, zephyr, conan or rust")
    made.add_argument("--out", type=pathlib.Path, default=pathlib.Path("build/packages"), metavar="FOLDER", help="where to (build/packages)")
    return made


def table():
    """The layouts of all packages."""
    return tomllib.loads(TABLE.read_text(encoding="utf-8"))


def before(options):
    """The layouts of all packages; refuses a name that none has."""
    known = table()
    if options.only and options.only not in known:
        raise ToolError(f"there is no package '{options.only}'{question(options.only, known)}; there are: {', '.join(known)}")
    return known


def library():
    """{path below a package's folder of sources: its text}: the tree of lib/ but for the study, with its public headers beside
    the rooms."""
    files = {file.relative_to(one_file.LIB): file for room in one_file.ROOMS for file in sorted((one_file.LIB / room).glob("*.[chS]"))}
    include = one_file.LIB / "include"
    files |= {file.relative_to(include): file for file in sorted(include.rglob("*.h"))}
    # Assembly finds what it includes by the place of the file alone: some builds give it no folders.
    found = {path.as_posix(): file.read_text(encoding="utf-8").replace('"../include/', '"../') for path, file in files.items()}
    found[CONFIG] = found[CONFIG].replace(*NEVER_BY_O, 1)
    return found


def texts(layout):
    """{path in a package: its text}."""
    source = layout["source"]
    found = {path: text.lstrip("\n").format(version=version(), about=ABOUT) for path, text in layout["files"].items()}
    found |= {f"{source}/{path}": text for path, text in library().items()}
    if layout.get("example"):
        found[f"{layout['example']}/main.c"] = examples.PROGRAM.read_text(encoding="utf-8")
    if layout.get("copy"):
        folder = ROOT / layout["copy"]
        found |= {file.relative_to(folder).as_posix(): file.read_text(encoding="utf-8") for file in sorted(folder.rglob("*")) if file.is_file()}
    if layout.get("crate"):
        bindings = rust_bindings.Bindings(one_file.header_text(version()))
        found[f"{layout['crate']}/src/bindings.rs"] = bindings.text()
        found[f"{source}/layouts.c"], found[f"{layout['crate']}/tests/layouts.rs"] = bindings.layouts()
    for name, sketch in layout.get("sketches", {}).items():
        found |= {f"examples/{name}/{file.name}": file.read_text(encoding="utf-8") for files in sketch["files"] for file in ROOT.glob(files)
                  if not file.name.endswith("_scene.h")}
    found["LICENSE"] = (ROOT / "LICENSE").read_text(encoding="utf-8")
    return found


def write(layout, folder):
    """Writes a package; the number of its files."""
    found = texts(layout)
    for path, text in found.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        output.write_file(folder / path, text)
    if layout.get("example"):
        examples.write_scene(folder / layout["example"])
    if layout.get("image"):
        output.write_file(folder / layout["image"], image.pack(examples.scene()))
    if layout.get("own_image"):
        examples.write_own_image(folder / layout["own_image"])
    for name, sketch in layout.get("sketches", {}).items():
        making.export(str(ROOT / sketch["scene"]), str(folder / "examples" / name / f"{pathlib.Path(sketch['scene']).stem}_scene.h"),
                      frames=sketch.get("frames"))
    return len(found) + len(layout.get("sketches", {}))


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    known = before(options)
    for name in [options.only] if options.only else known:
        count = write(known[name], options.out / name)
        print(f"{options.out / name}: {count} files")
    return 0
