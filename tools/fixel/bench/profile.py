# SPDX-License-Identifier: MIT
"""Shows where the instructions of a workload go: by function, by line, and as a flame graph.

Counts are exact. A flame graph is one SVG: each function a bar over the one that called it, as wide as what it took with all that
it called (after Brendan Gregg's, who thought of them). Cycles are an ESTIMATE from a table of costs (bench/cycles.toml).
"""

import argparse
import html
import pathlib
import sys
import zlib

from fixel.base import output, scratch
from fixel.base.arguments import number
from fixel.base.errors import one_line, ToolError
from fixel.base.progress import Progress
from fixel.base.table import table
from fixel.bench import bench
from fixel.commands import late

bench_plan, bench_rgb565, bench_run, cycles, places = late("fixel.bench", "bench_plan bench_rgb565 bench_run cycles places")
qemu = late("fixel.board", "qemu")

PATTERNS = ["flame.svg", "stacks.txt", "profile.json"]
ROWS = 24       # of a table on the terminal; all are in profile.json
WIDTH, ROW, MARGIN, HEAD = 1280, 18, 10, 44
LETTER = 6.7            # pixels a letter of the font takes
NARROWEST = 0.4         # pixels; a narrower bar is left out, but not its width
HUES = ((28, 82, 66), (205, 62, 68), (152, 42, 62), (345, 60, 72), (262, 45, 73), (48, 78, 62), (186, 45, 60))
STYLE = ("text{font:11px 'DejaVu Sans Mono',Menlo,Consolas,monospace;fill:#1c2430}"
         ".t{font:bold 14px 'DejaVu Sans',Arial,sans-serif}.s{fill:#5b6675}"
         "rect{stroke:#fff;stroke-width:.5}.i{stroke:#5b6675;stroke-dasharray:2 2}"
         "g:hover rect{stroke:#1c2430;stroke-width:1;stroke-dasharray:none}")


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--workload", required=True)
    made.add_argument("--core", required=True)
    made.add_argument("--renderer", help="default: fixel, or fixel-native for what is drawn to RGB565")
    made.add_argument("--frames", type=number("FRAMES", 1, 1_000_000), help="number of frames (default: the whole path)")
    made.add_argument("--out", help="folder for the results")
    made.add_argument("--build", default="build", help="folder that make builds in")
    return made


def before(options):
    """Refuses a workload or a core that there is not."""
    bench.refuse_workload(options.workload)
    cores = (*bench.CORES, *bench.EXTRA_CORES)
    if options.core not in (None, *cores):
        raise ToolError(f"there is no core '{options.core}'; the cores are: {', '.join(cores)}")


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


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    plan = bench_plan.Plan(options.build)
    before(options)
    workload, renderer = chosen(plan, options)
    qemu.find_qemu()
    taken, frames = take(plan, workload, options.core, renderer, options.frames)
    data = {"workload": options.workload, "core": options.core, "renderer": renderer,
            **places.as_json(taken, frames)}
    title = f"{options.workload}, {renderer}, {bench_plan.NAMES[options.core]}"
    graph = svg({names: each.instructions for names, each in taken.stacks.items()}, title,
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


def tree(stacks):
    """{(names...): number} as nodes [number with children, {name: node}]."""
    root = [0, {}]
    for names, number in stacks.items():
        node = root
        node[0] += number
        for name in names:
            node = node[1].setdefault(name, [0, {}])
            node[0] += number
    return root


def _depth(node):
    return 1 + max(map(_depth, node[1].values()), default=0)


def _colour(name):
    """A function's colour: always the same one."""
    hue, saturation, light = HUES[zlib.crc32(name.split(" ")[0].encode()) % len(HUES)]
    return f"hsl({hue},{saturation}%,{light}%)"


def _bar(name, number, total, x, y, width, marked):
    share = f"{name}: {number:,} ({100 * number / total:.2f} %)"
    room = int((width - 6) / LETTER)
    label = name if len(name) <= room else name[:room - 1] + "…" if room > 3 else ""
    text = f'<text x="{x + 3:.1f}" y="{y + 13}">{html.escape(label)}</text>' if label else ""
    kind = ' class="i"' if marked in name else ""
    return (f'<g><title>{html.escape(share)}</title><rect x="{x:.2f}" y="{y}" width="{width:.2f}" '
            f'height="{ROW - 1}" rx="2" fill="{_colour(name)}"{kind}/>{text}</g>')


def _bars(node, total, x, level, height, scale, marked):
    for name, child in sorted(node[1].items()):
        width = child[0] * scale
        if width >= NARROWEST:
            yield _bar(name, child[0], total, x, height - MARGIN - (level + 1) * ROW, width, marked)
            yield from _bars(child, total, x, level + 1, height, scale, marked)
        x += width


def svg(stacks, title, subtitle, marked):
    """The graph of {(names, outermost first): number}; bars whose name holds `marked` are dashed."""
    root = tree(stacks)
    height = HEAD + _depth(root) * ROW + MARGIN
    scale = (WIDTH - 2 * MARGIN) / max(1, root[0])
    bars = "\n".join(_bars(root, max(1, root[0]), MARGIN, 0, height, scale, marked))
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" width="{WIDTH}" '
            f'height="{height}"><title>{html.escape(title)}</title><style>{STYLE}</style>'
            f'<rect width="100%" height="100%" fill="#fff"/>'
            f'<text class="t" x="{MARGIN}" y="20">{html.escape(title)}</text>'
            f'<text class="s" x="{MARGIN}" y="36">{html.escape(subtitle)}</text>\n{bars}\n</svg>\n')
