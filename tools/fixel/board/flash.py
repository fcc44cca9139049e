# SPDX-License-Identifier: MIT
"""Writes a program and a scene to a board: to its persistent flash image, or by a debug probe to the real one."""

import argparse
import itertools
import pathlib

from fixel.base import bounded, output, scratch
from fixel.base.errors import ToolError, one_line
from fixel.base.table import table
from fixel.board import uf2
from fixel.commands import late
from fixel.model import suffixes
from fixel.scene import look, making, scene_options

controllers, firmware, flash_memory = late("fixel.board", "controllers firmware flash_memory")
model_look, own_run, probe, wires = late("fixel.board", "model_look own_run probe wires")
images = late("fixel.image", "image")

OPENOCD = "openocd"
PROBES = (OPENOCD,)


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__)
    made.add_argument("--board", required=True, help="the board of the program and the scene")
    made.add_argument("--elf", required=True, help="the program")
    scene_options.add(made)
    made.add_argument("--scenes", default="build/scenes", help="folder for the compiled scene image")
    made.add_argument("--image", required=True, help="the flash image to write")
    made.add_argument("--program", default="walk", help="the name of the program (walk)")
    made.add_argument("--driver", help="the display of a program that runs without a debugger")
    made.add_argument("--probe", default="", help="openocd: program the real board instead")
    made.add_argument("--dry-run", action="store_true", help="with --probe: only print the command")
    return made


def before(options):
    """Refuses a probe that there is not."""
    if options.probe and options.probe not in PROBES:
        raise ToolError(f"PROBE is '{options.probe}'; it may be {' or '.join(PROBES)}")
    if options.dry_run and not options.probe:
        raise ToolError("DRY_RUN needs a PROBE")


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
        return making.make_scene_image(options.scene, work, options.frames, options.screen, asked=options.target)
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
    result = flash_memory.flash(options.board, options.elf, scene, options.image)
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
    """Refuses a display that the board's wires do not fit, and frames that it has no room for. A program of the user's own has a size of its own."""
    if options.driver and issubclass(controllers.model(options.driver), controllers.MemoryLcd):
        raise ToolError(f"DRIVER={options.driver} wants a chip select that is high during a message, and BOARD={options.board} drives it low: "
                        "write a program of your own, whose port drives it (docs/displays.md, LCDs of one bit)")
    if options.driver and not own_run.is_own(options):
        drawn = images.load(scene)
        wires.check_size(options.driver, drawn.width, drawn.height)


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    scene_options.check(options)
    before(options)
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
