# SPDX-License-Identifier: MIT
"""What make bench measures and writes: instructions of the workloads and of the kernels."""

import os
import pathlib
import subprocess
import sys

from fixel.base import children, output, parallel, scratch
from fixel.bench import bench_budgets, bench_goals, bench_page, bench_plan, bench_plots, bench_rgb565, bench_rows, bench_run, bench_target, program_sizes
from fixel.board import qemu
from fixel.base.errors import ToolError, one_line
from fixel.scene import target

PATTERNS = ["bench.svg", "bench.png", "growth.svg", "growth.png", "bench.md", "bench.json"]
# The share of pixels in which a renderer may differ from the library: the listing has no near plane, and
# its outlines are not exact to 1/65536 pixel. Figures of a renderer that draws something else mean nothing.
DIFFERING_MAX = 0.002


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
        differing = int((each.pixels != drawn[core, workload, "fixel"].pixels).sum())
        if differing:
            raise ToolError(f"fixel-{name} on {core} draws {workload} unlike fixel: {differing:,} pixels",
                            exit_code=1)


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
            rows.append(bench_rows.frame_row(core, plan.workloads[workload], renderer, each, units[workload]))
        counted = parallel.run("running the kernels",
                               {core: (bench_run.kernels, plan, core) for core in cores})
        if plan.growth["core"] in cores:
            scenes = bench_run.growth_scenes(plan, folder)
            grown = parallel.run("growing the scenes", {number: (bench_run.grow, plan, entry)
                                                       for number, entry in enumerate(scenes)})
            growth = list(grown.values())
    for core in cores:
        kernels, bare = bench_rows.split_kernels(plan, core, counted[core])
        rows += kernels
        limits += bare
    sizes = bench_rows.sizes(plan, cores)
    bench_rows.add_ratios(plan, rows, limits)
    bench_rows.add_sizes(rows, sizes)
    result = {"compiler": tool_version(f"{os.environ.get('CROSS', 'arm-none-eabi-')}gcc"),
              "emulator": tool_version(qemu.QEMU), "cores": list(cores), "left_out": list(left_out),
              "rows": rows, "limits": limits, "sizes": sizes, "stages": bench_rows.stages(profiles),
              "renderer_bytes": bench_rows.renderer_bytes(plan, cores),
              "variants": bench_rows.variants(drawn, others), "cycles_estimate": bench_rows.estimates(profiles),
              "rgb565": bench_rgb565.measure(plan, cores), "budgets": bench_budgets.measure(plan, cores),
              "programs": program_sizes.measure(plan, cores),
              "growth": growth, "pictures": pictures, "peers": plan.peers}
    return {**result, "goals": bench_goals.measure(result)}


def command(options):
    """The command; its exit code."""
    plan = bench_plan.Plan(options.build)
    if options.workloads:
        plan.keep(options.workloads)
    qemu.find_qemu()
    asked = target.of_options(options)
    if asked:
        return bench_target.command(options, plan, asked)
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
