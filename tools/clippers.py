# SPDX-License-Identifier: MIT
"""Every clipper times everything that hides what: drawn on emulated cores, judged against double.

Writes clippers.json and clippers.html (one self-contained page). Exit: 0 all is explained and every
core drew what the host draws; 1 if not; 2 if it could not be run.
"""

import argparse
import pathlib
import sys
import tempfile

from fixel import clippers_page, clippers_plan, clippers_rows, clippers_run, output, parallel, qemu
from fixel.errors import run_main
from fixel.table import coloured

PATTERNS = ["clippers.html", "clippers.json"]
FRAMES_MAX = 100_000


def compile_scenes(plan, folder, frames):
    """{name: its entry with "file" and "image"} of the scenes that are there."""
    scenes = {}
    for name, entry in plan.scenes.items():
        compiled = clippers_plan.compile_scene(plan, entry, folder, frames)
        if compiled is None:
            print(f"left out, since it is not here: {entry['scene']}", file=sys.stderr)
        else:
            scenes[name] = {**entry, "file": compiled[0], "image": compiled[1]}
    return scenes


def measure(plan, cores, folder, frames):
    """(clippers.json, what the host drew)."""
    scenes = compile_scenes(plan, folder, frames)
    combinations = plan.combinations()
    hosts = parallel.run("drawing on the host, and judging", {
        (each.clipper, each.hidden, scene["name"]): (clippers_run.on_host, plan, each, scene, scene["file"], folder)
        for each in combinations for scene in scenes.values()})
    drawn = parallel.run("drawing on emulated cores", {
        (core, each, name): (clippers_run.on_core, plan, core, each, scene["file"])
        for core in cores for each in combinations for name, scene in scenes.items()})
    counting = plan.operations
    counted = {}
    if counting["core"] in cores and counting["hidden"] in plan.hidden:
        counted = parallel.run("counting multiplications and divisions", {
            (each.clipper, name): (clippers_run.operations, plan, counting["core"], each, scene["file"])
            for each in combinations if each.hidden == counting["hidden"] for name, scene in scenes.items()})
    sizes = {(core, each): clippers_run.size(plan, core, each) for core in cores for each in combinations}
    rows = [clippers_rows.row(plan, core, each, scenes[name], hosts[each.clipper, each.hidden, name], one,
                              sizes[core, each]) for (core, each, name), one in drawn.items()]
    result = {"frames": {name: scene["image"].frames for name, scene in scenes.items()}, "rows": rows,
              "operations": {**counting, "rows": clippers_rows.operation_rows(counted, hosts, counting["hidden"])}}
    return {**result, "complaints": clippers_rows.complaints(plan, result)}, hosts


def read_options(argv):
    """The command line, checked."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--cores", nargs="*", default=list(clippers_plan.CORES), help="of those that are built")
    parser.add_argument("--frames", type=int, help="of each scene, spread over its walk (FRAMES=)")
    parser.add_argument("--only", default="", help="names of clippers, methods, scenes, cores (ONLY=)")
    parser.add_argument("--out", default="build/clippers", help="folder for the results")
    parser.add_argument("--build", default="build", help="where make builds")
    options = parser.parse_args(argv)
    if options.frames is not None and not 1 <= options.frames <= FRAMES_MAX:
        parser.error(f"--frames {options.frames} is outside 1..{FRAMES_MAX}")
    return options


def main(argv):
    options = read_options(argv)
    plan = clippers_plan.Plan(options.build, options.only)
    qemu.find_qemu()
    cores = [core for core in plan.cores if core in options.cores]
    with output.replaced_folder(options.out, PATTERNS) as folder, \
            tempfile.TemporaryDirectory(prefix=".clippers-", dir=options.build) as work:
        result, hosts = measure(plan, cores, pathlib.Path(work), options.frames)
        output.write_json(folder / "clippers.json", result)
        output.write_file(folder / "clippers.html", clippers_page.render(plan, result, hosts))
    print(clippers_page.terminal(plan, result))
    for sentence in result["complaints"]:
        print(f"{coloured('FAIL', 'red')}: {sentence}")
    word = coloured("FAIL", "red") if result["complaints"] else coloured("pass", "green")
    print(f"{word}: {options.out}/clippers.html, {options.out}/clippers.json")
    return 1 if result["complaints"] else 0


if __name__ == "__main__":
    run_main(main)
