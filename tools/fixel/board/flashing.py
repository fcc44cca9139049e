# SPDX-License-Identifier: MIT
"""A program and a scene written to a board: to its flash image, or by a debug probe to the real one."""

import itertools
import pathlib

from fixel.scene import look, making
from fixel.board import firmware, flash as flash_command, model_look, probe, uf2
from fixel.model import suffixes
from fixel.base import bounded, output, scratch
from fixel.base.errors import one_line
from fixel.board.flash_memory import flash
from fixel.base.table import table
from fixel.scene import scene_options
from fixel.scene.scene_image import make_scene_image


def sectors(sizes):
    """Sectors in words, as "4 of 16384 and 1 of 65536 bytes"."""
    runs = [(len(list(run)), size) for size, run in itertools.groupby(sizes)]
    return " and ".join(f"{count} of {size}" for count, size in runs) + " bytes"


def scene_image(options, work):
    """The scene image of --scene: itself, a copy in the folder work that is drawn as something else, or the one that is
    compiled into the folder of --scenes."""
    scene = pathlib.Path(options.scene)
    if scene.suffix == ".fxls":
        look.check(options.look, options.scene, False)
        return make_scene_image(options.scene, work, options.frames, options.screen, asked=options.target)
    image = pathlib.Path(options.scenes) / f"{scene.stem}.fxls"
    output.make_folder(image.parent)
    if suffixes.is_model(scene):
        output.write_file(image, model_look.scene_image(options, options.elf, work).read_bytes())
        return image
    look.check(options.look, options.scene, False)
    making.tell(image, making.build(options.scene, image, options.frames, options.screen,
                                    limits=bounded.limits_of(options), asked=options.target, verbose=options.look.verbose))
    return image


def write_image(options, scene):
    result = flash(options.board, options.elf, scene, options.image)
    rows = [(part.name, f"{part.address:#010x}", part.size, part.room) for part in result.parts]
    print(table(rows, ("part", "address", "bytes", "of")))
    if result.sectors_erased:
        print(f"{len(result.sectors_erased)} sectors erased and programmed: {sectors(result.sectors_erased)}")
    print(f"{result.verified} bytes verified: {one_line(result.image)}")
    if result.uf2:
        program = firmware.load(options.elf, options.board)
        file = result.image.with_suffix(".uf2")
        print(f"{uf2.write(program, result.image.read_bytes(), file)} blocks of UF2: {one_line(file)}")


def command(options):
    """The command; its exit code."""
    scene_options.check(options)
    flash_command.before(options)
    with scratch.folder("flash") as work:
        scene = scene_image(options, work)
        if options.probe:
            probe.program_board(options.board, options.elf, scene, options.dry_run)
            if not options.dry_run:
                print(f"{options.board}: program and scene programmed and verified")
        else:
            write_image(options, scene)
    return 0
