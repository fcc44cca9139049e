# SPDX-License-Identifier: MIT
"""Compares all boards: sizes, stack, speed, and whether their frames equal the host's.

Draws the scenes and runs the unit tests on all boards. The first scene must run on every board, as it asks to be drawn. If
a board has no room for another scene, or for what --pixels, --order and --depth ask for, the table says why. Exit: 0 all frames equal the host's and no unit test failed,
1 not, 2 there was nothing to compare with.
"""

import argparse
import collections
import os
import pathlib
import sys
import threading

from fixel.base import output, scratch
from fixel.base.errors import ToolError, one_line
from fixel.base.progress import Progress
from fixel.base.table import coloured, table
from fixel.board import crc, methods, unit_tests
from fixel.commands import late
from fixel.scene import target

concurrent_futures = late("concurrent.futures")
dump, emulator, firmware, fleet = late("fixel.board", "dump emulator firmware fleet")
making = late("fixel.scene", "making")


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--boards", nargs="+", required=True, help="the boards; the host, which they are compared with, is not one of them")
    made.add_argument("--scene", nargs="+", required=True, help="scenes; the first must run on every board")
    unit_tests.add_options(made)
    made.add_argument("--not-run", nargs="+", action="append", default=[], metavar="BOARD", help="a board that is left out, and the packages that it needs")
    made.add_argument("--build", default="build", help="folder that make builds in")
    made.add_argument("--out", default="build/boards.json", help="the JSON file to write")
    target.add_options(made)
    made.add_argument("--workers", type=int, default=os.cpu_count() or 1)
    return made


def make_scenes(sources, build, folder, asked):
    """Scene images, and the host's frames of them."""
    scenes = []
    for source in sources:
        name = pathlib.Path(source).stem
        image, file = folder / f"{name}.fxls", folder / f"{name}.fxld"
        making.build(source, image, None, asked=asked)
        with Progress(f"drawing {name} on the host") as progress:
            emulator.run(firmware.HOST, image, methods.elf_of(firmware.HOST, build), file, progress=progress)
        host = dump.read_dump(file)
        if not host.frames:
            raise ToolError(f"{source}: the path has no frames")
        scenes.append(fleet.Scene(name, image, host))
    return scenes


class Reporter:
    """A line on stderr for each board as its last job ends."""

    def __init__(self, jobs):
        self.left = collections.Counter(board for board, _ in jobs)
        self.total, self.done = len(self.left), 0
        self.lock = threading.Lock()

    def end(self, board):
        with self.lock:
            self.left[board] -= 1
            if self.left[board] == 0:
                self.done += 1
                print(f"[{self.done:{len(str(self.total))}}/{self.total}] {board}", file=sys.stderr, flush=True)


def run_jobs(jobs, workers):
    """What each job (board, function) answered, by board; side by side."""
    reporter = Reporter(jobs)

    def one(board, function):
        result = function()
        reporter.end(board)
        return board, result

    answers = collections.defaultdict(list)
    with concurrent_futures.ThreadPoolExecutor(workers) as pool:
        try:
            for future in [pool.submit(one, *job) for job in jobs]:
                board, result = future.result()
                answers[board].append(result)
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
    return answers


def all_jobs(options, scenes, folder):
    """The walks of all boards, the longest scene first; then their unit tests."""
    jobs = [(board, lambda board=board, scene=scene: fleet.walk(board, options.build, scene, folder))
            for scene in sorted(scenes, key=lambda scene: -scene.host.width * len(scene.host.frames))
            for board in options.boards]
    return jobs + [(board, lambda elf=elf, names=names: unit_tests.run(elf, names))
                   for board, elf, names in unit_tests.of_boards(options) if board in options.boards]


def row(board, options, scenes, answers):
    """boards[] of boards.json: one board. Top-level figures of a walk are of the scene that all run."""
    walks = {answer.scene: answer for answer in answers if isinstance(answer, fleet.Walk)}
    tested = [file for answer in answers if isinstance(answer, list) for file in answer]
    no_room = {**unit_tests.left_out(options, board), **{file.name: file.no_room for file in tested if file.no_room}}
    walks = [walks[scene.name] for scene in scenes]
    drawn = [walk for walk in walks if walk.why_not is None]
    elf = methods.elf_of(board, options.build)
    size = fleet.sizes(elf)
    largest = max((scene.image.stat().st_size for scene, walk in zip(scenes, walks) if walk in drawn), default=0)
    return {"name": board, "core": firmware.load(elf, board).cpu, **size,
            "flash_free": size["flash_size"] - size["flash_bytes"] - largest,
            "stack_bytes": max((walk.stack_bytes for walk in walks if walk.stack_bytes), default=None),
            "stack_reserved": max((walk.stack_reserved for walk in walks if walk.stack_reserved), default=None),
            "instructions_per_frame": walks[0].instructions_per_frame, "frames": walks[0].frames,
            "hash_equal": (walks[0] in drawn or bool(target.of_options(options))) and all(walk.hash_equal is True for walk in drawn),
            "unit_tests_passed": sum(file.passed for file in tested),
            "unit_tests_failed": sum(file.failed for file in tested),
            "unit_tests_left_out": sorted(no_room), "unit_tests_no_room": no_room,
            "scenes": [vars(walk) for walk in walks],
            "failures": [f"{file.name}:\n{file.output.rstrip()}" for file in tested if file.failed]}


def per_million(walk):
    """Frames in a million instructions, to three digits."""
    count = walk["instructions_per_frame"]
    return float(f"{1e6 / count:.3g}") if count else None


def print_rows(rows, scenes):
    """The table, and below it what does not go into one."""
    header = ["board", "core", "flash", "free", "RAM", "free", "stack",
              *(f"{scene.name}/M" for scene in scenes), "equal to host", "tests", "failed"]
    print(table([[each["name"], each["core"], each["flash_bytes"], each["flash_free"], each["ram_bytes"],
                  each["ram_free"], each["stack_bytes"], *map(per_million, each["scenes"]),
                  each["hash_equal"], each["unit_tests_passed"], each["unit_tests_failed"]]
                 for each in rows], header))
    print("flash: the program; free beside it and the largest scene walked. RAM: with its stacks.\n"
          "stack: the deepest that was seen. .../M: frames in a million instructions.")
    for scene in scenes:
        print(f"CRC of all frames of {scene.name}: {crc.both(crc.drawn(scene.host.frames).all, None)}")
    for each in rows:
        for note in notes(each):
            print(f"{each['name']}: {note}")


def notes(each):
    """What has to be said about a board beside its figures."""
    said = []
    for walk in each["scenes"]:
        if walk["why_not"]:
            said.append(f"{walk['scene']} does not fit: {walk['why_not']}")
        if walk["error"]:
            said.append(f"{coloured('FAIL', 'red')}: {walk['scene']}: {walk['error']}")
        if walk["first_different"] is not None:
            said.append(f"{coloured('FAIL', 'red')}: {walk['scene']}: frame {walk['first_different']} "
                        "is not the host's")
    if each["unit_tests_left_out"]:
        said.append(f"left out, no room: {unit_tests.with_reasons(each['unit_tests_no_room'])}")
    if not each["unit_tests_passed"] + each["unit_tests_failed"]:
        said.append(f"no unit tests were run: make test BOARD={each['name']} runs them")
    return said + [f"{coloured('FAIL', 'red')}: {failure}" for failure in each["failures"]]


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    emulator.find_qemu()
    output.make_folder(options.build)
    with scratch.folder("boards", options.build) as folder:
        scenes = make_scenes(options.scene, options.build, folder, target.of_options(options))
        answers = run_jobs(all_jobs(options, scenes, folder), max(1, options.workers))
        rows = [row(board, options, scenes, answers[board]) for board in options.boards]
    output.write_json(options.out, {"reference": firmware.HOST, "scenes": [scene.name for scene in scenes],
                                    "boards": rows, "not_run": {board: needs for board, *needs in options.not_run}})
    print_rows(rows, scenes)
    for board, *needs in options.not_run:
        print(f"{board}: not run: needs {' '.join(needs)}")
    good = all(each["hash_equal"] and not each["unit_tests_failed"] for each in rows)
    print(f"{coloured('pass', 'green') if good else coloured('FAIL', 'red')}: {one_line(options.out)}")
    return 0 if good else 1
