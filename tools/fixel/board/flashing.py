# SPDX-License-Identifier: MIT
"""A program and a scene written to a board: to its flash image, or by a debug probe to the real one."""

import itertools
import pathlib

from fixel.scene import look, making
from fixel.board import controllers, firmware, flash as flash_command, model_look, own_run, probe, uf2, wires
from fixel.model import suffixes
from fixel.base import bounded, output, scratch
from fixel.base.errors import one_line
from fixel.board.flash_memory import flash
from fixel.base.table import table
from fixel.image import image as images
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
        tell_of_real_board(program, options.driver, file)


def tell_of_real_board(program, driver, file):
    """What a person needs to know who copies the UF2 file to a real board."""
    if driver is None:
        print(f"this program uses semihosting: a real {program.board} needs a debug probe for it, and without one stops at its first "
              f"word.\nDRIVER= writes one that needs none and draws on a display: {' '.join(drivers())}, or a module of docs/displays.md")
        return
    print(table([*program.wires.items()], (driver, "GPIO")))
    print(f"VCC and backlight go to 3V3, GND to GND. The core runs at {program.clock / 1e6:g} MHz, the display's SPI at "
          f"{program.spi / 1e6:g} MHz. What fails is said on UART0, GPIO {program.uart}, at 115,200 baud.\n"
          f"No debug probe is needed: hold BOOTSEL while you connect the board, and copy {one_line(file)} to the drive that appears")


def drivers():
    """The drivers that DRIVER= takes beside the modules."""
    return sorted(name for name in controllers.MODULES if "_" not in name)


def check_display(options, scene):
    """Refuses frames that the display of DRIVER= has no room for. A program of the user's own has a size of its own."""
    if options.driver and not own_run.is_own(options):
        drawn = images.load(scene)
        wires.check_size(options.driver, drawn.width, drawn.height)


def command(options):
    """The command; its exit code."""
    scene_options.check(options)
    flash_command.before(options)
    with scratch.folder("flash") as work:
        scene = scene_image(options, work)
        check_display(options, scene)
        if options.probe:
            probe.program_board(options.board, options.elf, scene, options.dry_run)
            if not options.dry_run:
                print(f"{options.board}: program and scene programmed and verified")
        else:
            write_image(options, scene)
    return 0
