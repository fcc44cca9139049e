# SPDX-License-Identifier: MIT
"""A program of the user's own on a board: its pictures, and whether the host draws the same (make run PROGRAM=my.c)."""

import argparse
import pathlib
import re
import sys

import numpy
from elftools.elf.elffile import ELFFile

from fixel.base import output, picture, reading, scratch
from fixel.base.errors import one_line
from fixel.base.progress import Progress, steps
from fixel.base.table import coloured, count_of, table
from fixel.board import counted, dump, emulator, firmware, flash_memory, crc, methods, model_look, sent_bytes, spilled, wires

PREFIX = "own-"     # of the programs' names: firmware/firmware.mk
FRAMES = 120        # after which a program without an end is ended
TIMEOUT = 60.0      # seconds of CPU time without a new frame
PALETTE = "_palette"
OURS = re.compile(r"^(?:own: done \d+ frames|stack: \d+ of \d+ bytes\b.*)\n?", re.MULTILINE)


def name_of(path):
    """A path as the name of a file, which no other path has: OWN_NAME_OF of firmware/firmware.mk."""
    return str(path).translate({ord("/"): "_", ord("."): "-", ord("_"): "._", ord("-"): ".-"})


def is_own(options):
    """Whether a command is to run a program of the user's own."""
    return options.program.startswith(PREFIX)


def _palettes(made):
    """The symbols of the palettes of exported scenes in an ELF file."""
    symbols = made.get_section_by_name(".symtab")
    return [symbol for symbol in (symbols.iter_symbols() if symbols else ())
            if symbol.name.endswith(PALETTE) and symbol["st_info"]["type"] == "STT_OBJECT" and symbol["st_size"] == 768]


def exported_name(elf):
    """What the names of the program's exported scene begin with; "" where it has none."""
    with reading.open_file(elf) as file:
        return next((symbol.name.removesuffix(PALETTE) for symbol in _palettes(ELFFile(file))), "")


def palette_of(elf):
    """The palette that an exported scene of the program has, 256 x 3; None where it has none."""
    with reading.open_file(elf) as file:
        made = ELFFile(file)
        found = _palettes(made)
        if not found:
            return None
        address, section = found[0]["st_value"], made.get_section(found[0]["st_shndx"])
        offset = address - section["sh_addr"]
        return numpy.frombuffer(section.data()[offset:offset + 768], numpy.uint8).reshape(256, 3)


def greys():
    """Colours of palette indices that nobody knows."""
    return numpy.repeat(numpy.arange(256, dtype=numpy.uint8)[:, None], 3, 1)


def draw(board, options, image, folder, record=None):
    """What the program draws on a board, and what it prints: (Dump, text). record: where the wires' is to be."""
    elf = methods.elf_of(board, options.build, methods.program(options))
    program = firmware.load(elf, board)
    file, flashed = folder / f"{board}.fxld", folder / f"{board}.bin"
    flash_memory.flash(board, elf, image, flashed)
    with Progress(f"running on {board} ({program.cpu})") as progress:
        done = emulator.run(board, flashed, elf, file, options.frames or FRAMES, TIMEOUT, progress, at_most=True, record=record)
    return dump.read_dump(file), done.output


def same(one, other):
    """Whether two boards drew the same pictures."""
    return (one.width, one.height, len(one.frames)) == (other.width, other.height, len(other.frames)) and \
        all(numpy.array_equal(a.pixels, b.pixels) for a, b in zip(one.frames, other.frames))


def boxes_of(frames):
    """The boxes of each frame, if a frame has some; else None."""
    if all(frame.boxes is None for frame in frames):
        return None
    height, width = frames[0].pixels.shape
    return [[(0, width, 0, height)] if frame.boxes is None else frame.boxes for frame in frames]


def summarise(options, program, drawn, equal, sent):
    """summary.json."""
    return {"board": options.board, "cpu": program.cpu, "program": options.program, "width": drawn.width, "height": drawn.height,
            "frames": len(drawn.frames),
            **counted.summary(drawn.frames, program),
            "host_frames_equal": equal, "polygons_spilled": sum(frame.counters["spilled"] for frame in drawn.frames),
            "driver": options.driver, **sent_bytes.told(options.driver, drawn.width, drawn.height, boxes_of(drawn.frames))} | sent


def passes(summary):
    """Whether the host draws the same, and a display shows it."""
    return summary["host_frames_equal"] and summary["wires_frames_equal"] in (None, summary["frames"])


def line_to_open(out):
    """What to open of a result."""
    return f"open {one_line(pathlib.Path(out) / 'walk.gif')}: the frames as an animation; beside it each as frame_NNNN.png"


def print_summary(summary, options):
    """A short table for people."""
    print(table([["board", f"{summary['board']} ({summary['cpu']})"],
                 ["program", summary["program"]],
                 ["pictures", f"{summary['width']}x{summary['height']}, {count_of(summary['frames'], 'frame')}"
                              + ("" if options.frames or summary["frames"] < FRAMES else f", then it was ended: FRAMES= takes more than {FRAMES}")],
                 counted.row(summary),
                 ["equal to host", summary["host_frames_equal"]],
                 ["CRC of all frames", crc.both(summary["frame_crc_all"], summary["sent_crc_all"])],
                 sent_bytes.row(summary, are_sent=True),
                 *wires.rows(summary)]))
    if summary["polygons_spilled"]:
        print(spilled.of_own(summary["polygons_spilled"], exported_name(methods.elf_of(options.board, options.build, methods.program(options)))))
    good = passes(summary)
    print(f"{coloured('pass', 'green') if good else coloured('FAIL', 'red')}: {one_line(options.out)}")
    print(line_to_open(options.out))


def run(options, folder):
    """The whole run; its files go into folder. The summary."""
    output.make_folder(options.build)
    with scratch.folder("run", options.build) as work:
        elf = methods.elf_of(options.board, options.build, methods.program(options))
        program = firmware.load(elf, options.board)
        if not program.hosted:
            emulator.find_qemu(program.emulator)
        # The board's start wants some scene; of what the program draws, frames have nothing to do with its path.
        image = model_look.scene_image(argparse.Namespace(**vars(options) | {"frames": None}), elf, work)
        record = work / wires.NAME if options.driver else None
        drawn, said = draw(options.board, options, image, work, record)
        print(OURS.sub("", said), end="", flush=True)
        hosted = drawn if options.board == firmware.HOST else draw(firmware.HOST, options, image, work)[0]
        sent = wires.told(options.driver, record, drawn)
        palette = palette_of(elf) if drawn.frames[0].pixels.itemsize == 1 else drawn.palette
        if palette is None:
            print("  the program has no palette of an exported scene: its colours are shown as greys", file=sys.stderr)
            palette = greys()
        for frame in steps("writing pictures", drawn.frames):
            picture.palette_image(frame.pixels, palette).save(folder / f"frame_{frame.number:04d}.png")
        (folder / "walk.gif").write_bytes(picture.animation_bytes([frame.pixels for frame in drawn.frames], palette))
        (work / f"{options.board}.fxld").rename(folder / "board.fxld")
    return summarise(options, program, drawn, same(drawn, hosted), sent)


def command(options, patterns):
    """make run of such a program; its exit code. patterns: the files of a result."""
    with output.replaced_folder(options.out, patterns) as folder:
        summary = run(options, folder)
        output.write_json(folder / "summary.json", summary)
    print_summary(summary, options)
    return 0 if passes(summary) else 1
