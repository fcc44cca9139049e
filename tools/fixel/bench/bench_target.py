# SPDX-License-Identifier: MIT
"""The workloads of the bench drawn as PIXELS=, ORDER= and DEPTH= ask for, beside what their scenes ask for."""

import pathlib
import sys

from fixel.base import output, parallel, scratch
from fixel.base.errors import one_line
from fixel.base.table import table
from fixel.bench import bench_plan, bench_run
from fixel.scene import target

PROGRAM = "fixel-target"    # draws into any target


def compile_scenes(plan, asked, folder):
    """{(workload, whether as asked): image file}."""
    files = {}
    for name, workload in plan.workloads.items():
        files[name, False], scene = bench_plan.compile_scene(workload, folder)
        target.apply(scene, scene.tree is not None, asked, workload["scene"])
        files[name, True] = bench_plan.save_scene(scene, pathlib.Path(folder) / f"{name}-asked.fxls")
    return files


def measure(plan, cores, asked):
    """[{core, workload, instructions a frame as its scene asks, and as asked for}]."""
    with scratch.folder("bench") as folder:
        files = compile_scenes(plan, asked, folder)
        drawn = parallel.run("drawing the workloads", {(core, *key): (bench_run.draw, plan, core, PROGRAM, file)
                                                       for core in cores for key, file in files.items()})
    means = {key: round(sum(each.instructions) / len(each.instructions)) for key, each in drawn.items()}
    return [{"core": core, "workload": name, "scene": means[core, name, False], "asked": means[core, name, True]}
            for core in cores for name in plan.workloads]


def command(options, plan, asked):
    """The command; its exit code."""
    rows = measure(plan, options.cores or list(bench_plan.CORES), asked)
    file = pathlib.Path(options.out) / "target.json"
    output.make_folder(file.parent)
    output.write_json(file, {**vars(asked), "rows": rows})
    print(table([[row["core"], row["workload"], row["scene"], row["asked"], f"{row['asked'] / row['scene']:.2f}"] for row in rows],
                ["core", "workload", "as the scene asks", asked.text, "times"]))
    print(f"JSON: {one_line(file)}", file=sys.stderr)
    return 0
