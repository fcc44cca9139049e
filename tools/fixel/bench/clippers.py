# SPDX-License-Identifier: MIT
"""Compares every clipper with every visibility method: drawn on emulated cores, judged against double.

Writes clippers.json and clippers.html (one self-contained page). Exit: 0 every pixel is explained and
every core drew the frames of the host, 1 not, 2 the comparison could not be run.
"""

import argparse
import pathlib
import sys
import tomllib

from fixel.base import output, scratch
from fixel.base.arguments import number
from fixel.base.errors import ToolError, one_line
from fixel.base.table import coloured
from fixel.campaign import runner
from fixel.commands import late

parallel = late("fixel.base", "parallel")
clippers_page, clippers_plan, clippers_run = late("fixel.bench", "clippers_page clippers_plan clippers_run")
programs, qemu = late("fixel.board", "programs qemu")

PLAN = pathlib.Path(__file__).resolve().parents[3] / "bench" / "clippers.toml"
CORES = ("m3", "m0")
KINDS = ("clippers", "hidden", "scenes")
PATTERNS = ["clippers.html", "clippers.json"]
FRAMES_MAX = 100_000
KEPT, DOCUMENT = pathlib.Path("bench/clippers.json"), pathlib.Path("docs/clipping.md")


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--cores", nargs="*", help="cores to measure, whose programs are built; all without")
    made.add_argument("--frames", type=number("FRAMES", 1, 1_000_000), help="number of frames of each scene, spread over its path (FRAMES=)")
    made.add_argument("--only", default="", help="names of clippers, methods, scenes, cores (ONLY=)")
    made.add_argument("--out", default="build/clippers", help="folder for the results")
    made.add_argument("--build", default="build", help="folder that make builds in")
    made.add_argument("--accept", action="store_true",
                      help="only take the run in --out into docs/clipping.md and bench/clippers.json")
    runner.add_options(made)
    return made


def refuse_strange(words, names):
    """Refuses a word that is none of the names."""
    strange = [word for word in words if word not in names]
    if strange:
        raise ToolError(f"ONLY names '{strange[0]}'; the names are: {', '.join(sorted(names))}")


def before(options):
    """Refuses a name that nothing of the plan has."""
    plan = tomllib.loads(PLAN.read_text(encoding="utf-8"))
    names = {*CORES, *(each["name"] for kind in KINDS for each in plan[kind])}
    refuse_strange(options.only.replace(",", " ").split(), names)
    if options.frames is not None and options.frames < 1:
        raise ToolError(f"FRAMES is {options.frames}; it must be at least 1")


def compile_scenes(plan, folder, frames):
    """{(name, whether in a tree): the scene's entry with "file" and "image"} of the scenes that are there."""
    jobs = {}
    for name, entry in plan.scenes.items():
        if clippers_plan.is_here(entry):
            for tree in sorted({method["tree"] for method in plan.hidden.values()}):
                jobs[name, tree] = (clippers_plan.compile_scene, plan, entry, folder, tree, frames)
        else:
            print(f"left out, because the file is not here: {entry['scene']}", file=sys.stderr)
    return {key: {**plan.scenes[key[0]], "file": made[0], "image": made[1]}
            for key, made in parallel.run("compiling scenes", jobs).items()}


def shards_of(plan, cores, scenes):
    """{(core, "frames" or "operations", combination, scene's name): shard}."""
    tasks = [(each, scene) for each in plan.combinations() for (_, tree), scene in scenes.items()
             if tree == plan.hidden[each.hidden]["tree"]]
    first = next(iter(plan.hidden))
    cells = [(core, "frames", each, scene) for core in (clippers_run.HOST, *cores) for each, scene in tasks]
    if not plan.hidden[first]["tree"]:
        cells += [(core, "operations", each, scene) for core in cores for each, scene in tasks if each.hidden == first]
    return {(core, what, each, scene["name"]): clippers_run.shard_of(number, what, core, each, scene)
            for number, (core, what, each, scene) in enumerate(cells)}


def measure(plan, cores, folder, options):
    """(clippers.json, what the host drew)."""
    scenes = compile_scenes(plan, folder, options.frames)
    some = shards_of(plan, cores, scenes)
    done = runner.run("drawing on the host and on emulated cores, and judging", list(some.values()), options)
    results = dict(zip(some, runner.whole(done), strict=True))
    done.tell(options.build)
    hosts = {(each.clipper, each.hidden, name): result for (core, _, each, name), result in results.items() if core == clippers_run.HOST}
    drawn = {(core, each, name): result for (core, what, each, name), result in results.items()
             if core != clippers_run.HOST and what == "frames"}
    counted = {(core, each.clipper, name): result for (core, what, each, name), result in results.items() if what == "operations"}
    sizes = {(core, each): clippers_run.size(plan, core, each) for core, each, _ in drawn}
    images = {(each, name): scenes[name, plan.hidden[each.hidden]["tree"]] for _, each, name in drawn}
    rows = [clippers_run.row(plan, core, each, images[each, name], hosts[each.clipper, each.hidden, name], one,
                              sizes[core, each]) for (core, each, name), one in drawn.items()]
    result = {"frames": {name: scene["image"].frames for (name, _), scene in scenes.items()}, "rows": rows,
              "operations": clippers_run.operation_rows(counted, hosts, next(iter(plan.hidden)))}
    return {**result, "complaints": clippers_run.complaints(plan, result)}, hosts


def accept(plan, out):
    """Takes the run in `out` into docs/clipping.md and bench/clippers.json."""
    result = programs.read_json(pathlib.Path(out) / "clippers.json")
    if result["complaints"]:
        raise ToolError(f"{out}: the comparison failed: {result['complaints'][0]}")
    missing = {(each.clipper, each.hidden, scene, core) for each in plan.combinations() for scene in plan.scenes
               for core in plan.cores} - {tuple(row[key] for key in ("clipper", "hidden", "scene", "board"))
                                          for row in result["rows"]}
    if missing:
        raise ToolError(f"{out}: {len(missing)} combinations are missing, for example {' '.join(min(missing))}: "
                        f"run make clippers without ONLY=, on a machine that has all models")
    text = clippers_page.replace_tables(DOCUMENT.read_text(encoding="utf-8"), plan, result)
    output.write_file(KEPT, clippers_run.as_lines(result))
    output.write_file(DOCUMENT, text)
    print(f"{KEPT}, {DOCUMENT}: renewed", file=sys.stderr)


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    if options.frames is not None and not 1 <= options.frames <= FRAMES_MAX:
        raise ToolError(f"--frames {options.frames} is outside 1..{FRAMES_MAX:,}")
    runner.jobs_of(options)
    plan = clippers_plan.Plan(options.build, options.only)
    if options.accept:
        accept(plan, options.out)
        return 0
    qemu.find_qemu()
    cores = [core for core in plan.cores if options.cores is None or core in options.cores]
    with output.replaced_folder(options.out, PATTERNS) as folder, \
            scratch.folder("clippers", options.build) as work:
        result, hosts = measure(plan, cores, work, options)
        output.write_json(folder / "clippers.json", result)
        output.write_file(folder / "clippers.html", clippers_page.render(plan, result, hosts))
    print(clippers_page.terminal(plan, result))
    for sentence in result["complaints"]:
        print(f"{coloured('FAIL', 'red')}: {sentence}")
    word = coloured("FAIL", "red") if result["complaints"] else coloured("pass", "green")
    print(f"{word}: {one_line(options.out)}/clippers.html, {one_line(options.out)}/clippers.json")
    return 1 if result["complaints"] else 0
