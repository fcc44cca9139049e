# SPDX-License-Identifier: MIT
"""Where the instructions of a workload go: functions, lines, stacks, a flame graph."""

import pathlib
import sys

from fixel.base import output, scratch
from fixel.bench import bench_plan, bench_rgb565, bench_run, cycles, flame, places, profile
from fixel.board import qemu
from fixel.base.errors import ToolError, one_line
from fixel.base.progress import Progress
from fixel.base.table import table

PATTERNS = ["flame.svg", "stacks.txt", "profile.json"]
ROWS = 24       # of a table on the terminal; all are in profile.json


def take(plan, workload, core, renderer, frames):
    """(Profile, frames): a workload drawn with every place counted."""
    with scratch.folder("profile") as folder, \
            Progress(f"profiling {workload['name']} on {core}"):
        image, _ = bench_plan.compile_scene(workload, folder)
        return bench_run.profile(plan, core, renderer, image, frames)


def estimate(figures, frames):
    """Cycles a frame without and with wait states, for people."""
    return "-" if not figures else ", ".join(f"{round(each / frames):,} {name}" for each, name in zip(figures, cycles.FIGURES))


def print_profile(data, models):
    """Tables for people; numbers a frame."""
    frames, total = data["frames"], data["instructions"]
    print(f"{data['workload']}, {data['renderer']}, {data['core']}: {round(total / frames):,} instructions "
          f"a frame, mean of {frames}")
    print(table([[name, round(number / frames), f"{100 * number / total:.1f} %"]
                 for name, number in data["kinds"].items() if number], ["kind", "a frame", "share"]))
    branches = data["branches_conditional"]
    print(f"conditional branches: {round(branches['taken'] / frames):,} taken, "
          f"{round(branches['not_taken'] / frames):,} not taken")
    for name, model in models.items():
        print(f"ESTIMATE of cycles a frame, {model.title}: {estimate(data['cycles_estimate'][name], frames)}")
    print()
    print(table([[row["stage"], round(row["instructions"] / frames),
                  f"{100 * row['instructions'] / total:.1f} %"] for row in data["stages"]],
                ["stage", "a frame", "share"]))
    first = next(iter(models), None)
    header = ["function", "itself", "share", "with calls", "of itself inlined", "calls", "of each"] + \
        ([f"ESTIMATE of cycles, {first}, {cycles.FIGURES[0]}"] if first else [])
    print()
    print(table([[row["function"], round(row["instructions"] / frames),
                  f"{100 * row['instructions'] / total:.1f} %", round(row["inclusive"] / frames),
                  round(row["inlined"] / frames), round(row["entered"] / frames, 1) or None,
                  round(row["inclusive"] / row["entered"]) if row["entered"] else None,
                  *([round(row["cycles_estimate"].get(first, [0])[0] / frames)] if first else [])]
                 for row in data["functions"][:ROWS]], header))
    print()
    print(table([[row["line"], round(row["instructions"] / frames),
                  f"{100 * row['instructions'] / total:.1f} %"] for row in data["lines"][:ROWS]],
                ["line", "a frame", "share"]))


def folded(stacks):
    """The stacks as text, a line each, as other tools for flame graphs take them."""
    lines = [f"{';'.join(names)} {each.instructions}" for names, each in sorted(stacks.items())]
    return "\n".join(lines) + "\n"


def chosen(plan, options):
    """(workload, renderer). What is drawn to RGB565 is changed as the renderer's way wants it."""
    is_rgb565 = options.workload in plan.rgb565
    workload = plan.rgb565[options.workload] if is_rgb565 else plan.workload(options.workload)
    changes = bench_rgb565.changes_of_programs() if is_rgb565 else dict.fromkeys(plan.renderers, [])
    renderer = options.renderer or ("fixel-native" if is_rgb565 else "fixel")
    if renderer not in changes:
        raise ToolError(f"there is no renderer '{renderer}' of {options.workload}; the renderers are: {', '.join(changes)}")
    return {**workload, "with": [*workload.get("with", ()), *changes[renderer]]}, renderer


def command(options):
    """The command; its exit code."""
    plan = bench_plan.Plan(options.build)
    profile.before(options)
    workload, renderer = chosen(plan, options)
    qemu.find_qemu()
    taken, frames = take(plan, workload, options.core, renderer, options.frames)
    data = {"workload": options.workload, "core": options.core, "renderer": renderer,
            **places.as_json(taken, frames)}
    title = f"{options.workload}, {renderer}, {bench_plan.NAMES[options.core]}"
    graph = flame.svg({names: each.instructions for names, each in taken.stacks.items()}, title,
                      f"executed instructions, {frames} frames together: {data['instructions']:,}; "
                      "dashed: inlined into the function below", places.INLINED)
    out = options.out or f"{options.build}/profile/{options.workload}-{options.core}-{renderer}"
    with output.replaced_folder(out, PATTERNS) as folder:
        (folder / "flame.svg").write_text(graph, encoding="utf-8")
        (folder / "stacks.txt").write_text(folded(taken.stacks), encoding="utf-8")
        output.write_json(folder / "profile.json", data)
    print_profile(data, taken.models)
    print(f"flame graph, stacks, JSON: {one_line(pathlib.Path(out))}", file=sys.stderr)
    return 0
