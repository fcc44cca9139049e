# SPDX-License-Identifier: MIT
"""Counts the executed instructions of the workloads and of the library's kernels.

Writes the report bench.md, bench.json, and plots. Two runs give the same figures. With --pixels, --order or --depth it
draws the workloads so and as their scenes ask, with this library alone, and writes target.json and nothing else. Exit: 0 all was
measured, 1 a program of the bench failed or drew a wrong picture, 2 the bench could not be run.
"""

import argparse
import os
import pathlib
import subprocess
import sys
import tomllib

from fixel.base import children, kept, output, scratch
from fixel.base.errors import one_line, ToolError
from fixel.base.table import table
from fixel.commands import late
from fixel.scene import target

parallel = late("fixel.base", "parallel")
bench_budgets, bench_faces, bench_goals, bench_page, bench_plan = late("fixel.bench", "bench_budgets bench_faces bench_goals bench_page bench_plan")
bench_plots = late("fixel.bench", "bench_plots")
bench_rgb565, bench_rows, bench_run, linked_size = late("fixel.bench", "bench_rgb565 bench_rows bench_run linked_size")
qemu = late("fixel.board", "qemu")

CORES = ("m0", "m3", "m4f", "m55")
EXTRA_CORES = ("rv32",)    # whose tools make installs where they are asked for: the library's own frames alone
PLAN = pathlib.Path(__file__).resolve().parents[3] / "bench" / "bench.toml"
PATTERNS = ["bench.svg", "bench.png", "growth.svg", "growth.png", "faces.svg", "faces.png", "bench.md", "bench.json"]
# The share of pixels in which a renderer may differ from the library: the listing has no near plane, and
# its outlines are not exact to 1/65536 pixel. Figures of a renderer that draws something else mean nothing.
DIFFERING_MAX = 0.002
PROGRAM = "fixel-target"    # draws into any target
FACES = "faces"             # what WORKLOAD= calls faces of all sizes
COUNTED, COUNTED_MOST = "counted", 1_000_000_000    # the folder of what programs counted, and its bytes


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--cores", "--core", nargs="+", help="cores to measure, whose programs are built; all without")
    made.add_argument("--workloads", "--workload", nargs="+", help="workloads to draw; all without")
    made.add_argument("--left-out", nargs="*", default=[], help="cores that no board has")
    made.add_argument("--out", default="build/bench", help="folder for the results")
    made.add_argument("--build", default="build", help="folder that make builds in")
    kept.add_option(made)
    target.add_options(made)
    return made


def workloads():
    """The names of the workloads, in a palette and to RGB565."""
    plan = tomllib.loads(PLAN.read_text(encoding="utf-8"))
    return [each["name"] for kind in ("workloads", "rgb565") for each in plan.get(kind, ())]


def refuse_workload(name):
    """Refuses a name that no workload has."""
    if name not in (None, *workloads()):
        raise ToolError(f"there is no workload '{name}'; the workloads are: {', '.join(workloads())}")


def before(options):
    """Refuses a workload that there is not."""
    for name in options.workloads or ():
        refuse_workload(None if name == FACES else name)


def tool_version(*command):
    """The first line of a tool's --version."""
    try:
        done = children.run([*command, "--version"], text=True)
        done.check_returncode()
    except (OSError, subprocess.CalledProcessError) as error:
        raise ToolError(f"{command[0]} --version failed: {error}") from error
    return done.stdout.splitlines()[0]


def check_pictures(plan, pictures):
    """Refuses figures of a renderer that did not draw the scene."""
    for row in pictures:
        judged = "uncovered" if plan.workloads[row["workload"]].get("judged") == "covered" else "differing"
        if row[judged] > DIFFERING_MAX * row["pixels"]:
            raise ToolError(f"{row['renderer']} on {row['core']} draws {row['workload']} unlike the "
                            f"library: {row[judged]:,} of {row['pixels']:,} pixels", exit_code=1)


def check_variants(drawn, others):
    """Refuses figures of the library built otherwise, or in bands, if a pixel differs."""
    for (core, workload, name), each in others.items():
        bench_run.refuse_other_pixels(f"fixel-{name} on {core}", workload, each.pixels, drawn[core, workload, "fixel"].pixels)


def draw_all(plan, cores, folder):
    """{(core, workload, renderer): Drawn}, {workload: units of a frame}, and, of those that the plan asks
    for, {(core, workload): (Profile, frames)} by stage and {(core, workload, variant): Drawn}."""
    images, units = {}, {}
    for name, workload in plan.workloads.items():
        images[name], scene = bench_plan.compile_scene(workload, folder)
        units[name] = bench_plan.units_of(workload, scene)
    jobs = {key: (bench_run.draw, plan, key[0], key[2], images[key[1]]) for key in plan.runs(cores)}
    profiles = {(core, name): (bench_run.profile, plan, core, "fixel", images[name])
                for core, name in plan.planned(plan.stages, cores)}
    others = {key: (bench_run.draw, plan, key[0], f"fixel-{key[2]}", images[key[1]])
              for key in plan.variant_runs(cores)}
    wide = {name: bench_plan.compile_scene({**plan.rgb565[name], "with": [*plan.rgb565[name].get("with", ()), "rgb565"]}, folder)[0]
            for name in plan.variants_of_rgb565()}
    for (core, workload, name), (program, own) in plan.rgb565_variant_runs(cores).items():
        jobs[core, workload, bench_plan.OURS] = (bench_run.draw, plan, core, own, wide[workload])
        others[core, workload, name] = (bench_run.draw, plan, core, program, wide[workload])
    return (parallel.run("drawing the workloads", jobs), units, parallel.run("profiling the workloads", profiles),
            parallel.run("drawing with the library's variants", others))


def measure(plan, cores, left_out):
    """bench.json."""
    rows, limits, growth = [], [], []
    with scratch.folder("bench") as folder:
        drawn, units, profiles, others = draw_all(plan, cores, folder)
        check_variants(drawn, others)
        pictures = bench_rows.pictures(drawn)
        check_pictures(plan, pictures)
        for (core, workload, renderer), each in drawn.items():
            if workload in plan.workloads:
                rows.append(bench_rows.frame_row(core, plan.workloads[workload], renderer, each, units[workload]))
        counted = parallel.run("running the kernels",
                               {core: (bench_run.kernels, plan, core) for core in cores if core in CORES})
        if plan.growth["core"] in cores:
            scenes = bench_run.growth_scenes(plan, folder)
            grown = parallel.run("growing the scenes", {number: (bench_run.grow, plan, entry)
                                                       for number, entry in enumerate(scenes)})
            growth = list(grown.values())
    for core in counted:
        kernels, bare = bench_rows.split_kernels(plan, core, counted[core])
        rows += kernels
        limits += bare
    sizes = bench_rows.sizes(plan, counted)
    bench_rows.add_ratios(plan, rows, limits)
    bench_rows.add_sizes(rows, sizes)
    result = {"compiler": tool_version(f"{os.environ.get('CROSS', 'arm-none-eabi-')}gcc"),
              "emulator": tool_version(qemu.QEMU), "cores": list(counted), "extra_cores": [core for core in cores if core in EXTRA_CORES], "left_out": list(left_out),
              "rows": rows, "limits": limits, "sizes": sizes, "stages": bench_rows.stages(profiles),
              "renderer_bytes": bench_rows.renderer_bytes(plan, counted),
              "variants": bench_rows.variants(drawn, others), "cycles_estimate": bench_rows.estimates(profiles),
              "rgb565": bench_rgb565.measure(plan, cores), "budgets": bench_budgets.measure(plan, cores),
              "faces": bench_faces.measure(plan, cores),
              "programs": linked_size.measure_programs(plan, cores),
              "growth": growth, "pictures": pictures, "peers": plan.peers}
    return {**result, "goals": bench_goals.measure(result)}


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    plan = bench_plan.Plan(options.build)
    plan.store = kept.Kept(options.build, options.fresh, COUNTED, COUNTED_MOST)
    if options.workloads:
        plan.keep(options.workloads)
    qemu.find_qemu()
    asked = target.of_options(options)
    if asked:
        return write_asked(options, plan, asked)
    result = measure(plan, options.cores or list(bench_plan.CORES), options.left_out)
    with output.replaced_folder(options.out, PATTERNS) as folder:
        for name, data in bench_plots.files(plan, result).items():
            (folder / name).write_bytes(data)
        (folder / "bench.md").write_text(bench_page.report(plan, result), encoding="utf-8")
        output.write_json(folder / "bench.json", result)
    print(bench_page.terminal(plan, result))
    if options.left_out:
        print(f"left out, because no board has the core: {', '.join(options.left_out)}", file=sys.stderr)
    print(f"report, plots, JSON: {one_line(pathlib.Path(options.out))}", file=sys.stderr)
    return 0


# --- the workloads as PIXELS=, ORDER= and DEPTH= ask for, beside what their scenes ask for ---

def compile_scenes(plan, asked, folder):
    """{(workload, whether as asked): image file}."""
    files = {}
    for name, workload in plan.workloads.items():
        files[name, False], scene = bench_plan.compile_scene(workload, folder)
        target.apply(scene, scene.tree is not None, asked, workload["scene"])
        files[name, True] = bench_plan.save_scene(scene, pathlib.Path(folder) / f"{name}-asked.fxls")
    return files


def measure_asked(plan, cores, asked):
    """[{core, workload, instructions a frame as its scene asks, and as asked for}]."""
    with scratch.folder("bench") as folder:
        files = compile_scenes(plan, asked, folder)
        drawn = parallel.run("drawing the workloads", {(core, *key): (bench_run.draw, plan, core, PROGRAM, file)
                                                       for core in cores for key, file in files.items()})
    means = {key: round(sum(each.instructions) / len(each.instructions)) for key, each in drawn.items()}
    return [{"core": core, "workload": name, "scene": means[core, name, False], "asked": means[core, name, True]}
            for core in cores for name in plan.workloads]


def write_asked(options, plan, asked):
    """Draws them, and writes and prints what they took; the exit code."""
    rows = measure_asked(plan, options.cores or list(bench_plan.CORES), asked)
    file = pathlib.Path(options.out) / "target.json"
    output.make_folder(file.parent)
    output.write_json(file, {**vars(asked), "rows": rows})
    print(table([[row["core"], row["workload"], row["scene"], row["asked"], f"{row['asked'] / row['scene']:.2f}"] for row in rows],
                ["core", "workload", "as the scene asks", asked.text, "times"]))
    print(f"JSON: {one_line(file)}", file=sys.stderr)
    return 0
