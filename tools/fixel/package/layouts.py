# SPDX-License-Identifier: MIT
"""The work of fixel packages: every file of a package, by layouts.toml."""

import pathlib

from fixel.base import output
from fixel.base.version import version
from fixel.image import image
from fixel.package import one_text, packages, rust_bindings
from fixel.report import examples
from fixel.scene import making

ROOT = pathlib.Path(__file__).resolve().parents[3]
ABOUT = "Fixed-point 3-D renderer for microcontrollers"


def texts(layout, one_file):
    """{path in a package: its text}. one_file: {"fixel.h": text, "fixel.c": text}."""
    source = layout["source"]
    found = {path: text.lstrip("\n").format(version=version(), about=ABOUT) for path, text in layout["files"].items()}
    found |= {f"{source}/{name}": text for name, text in one_file.items()}
    if layout.get("forward"):
        # So #include <fixel/surfaces.h> stays right: the documents have it.
        found |= {f"{source}/fixel/{header.name}": f'{one_text.LICENCE}#include "../fixel.h"\n'
                  for header in sorted((one_text.LIB / "include" / "fixel").glob("*.h"))}
    if layout.get("example"):
        found[f"{layout['example']}/main.c"] = examples.PROGRAM.read_text(encoding="utf-8")
    if layout.get("copy"):
        folder = ROOT / layout["copy"]
        found |= {file.relative_to(folder).as_posix(): file.read_text(encoding="utf-8") for file in sorted(folder.rglob("*")) if file.is_file()}
    if layout.get("crate"):
        bindings = rust_bindings.Bindings(one_file["fixel.h"])
        found[f"{layout['crate']}/src/bindings.rs"] = bindings.text()
        found[f"{source}/layouts.c"], found[f"{layout['crate']}/tests/layouts.rs"] = bindings.layouts()
    for name, sketch in layout.get("sketches", {}).items():
        found |= {f"examples/{name}/{file.name}": file.read_text(encoding="utf-8") for files in sketch["files"] for file in ROOT.glob(files)
                  if not file.name.endswith("_scene.h")}
    found["LICENSE"] = (ROOT / "LICENSE").read_text(encoding="utf-8")
    return found


def write(layout, folder, one_file):
    """Writes a package; the number of its files."""
    found = texts(layout, one_file)
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


def command(options):
    """The command; its exit code."""
    known = packages.before(options)
    one_file = {"fixel.h": one_text.header_text(version()), "fixel.c": one_text.source_of_all(version())}
    for name in [options.only] if options.only else known:
        count = write(known[name], options.out / name, one_file)
        print(f"{options.out / name}: {count} files")
    return 0
