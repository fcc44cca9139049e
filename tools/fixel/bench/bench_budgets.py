# SPDX-License-Identifier: MIT
"""What single steps of a frame cost, as differences of whole frames and as stages of one: [[budgets]] of bench/bench.toml.

They need no name of a function of the library, so that they mean the same after a change of it. Only what no difference shows
is counted by the calls of a function.
"""

from fixel.base import parallel, scratch
from fixel.base.errors import ToolError
from fixel.bench import bench_plan, bench_rgb565, bench_run, bench_changes, places

WIDE, NARROW, SHORT = (320, 64), (32, 64), (32, 32)     # screens of a wall that covers all of them


class _Frames:
    """Draws what a budget is computed from."""

    def __init__(self, plan, entry, folder):
        self.plan, self.entry, self.folder = plan, entry, folder

    def image(self, *changes):
        """The image of the budget's scene, with changes."""
        return bench_plan.compile_scene({**self.entry, "with": [*self.entry.get("with", ()), *changes]}, self.folder)

    def mean(self, *changes):
        """Instructions of a mean frame."""
        file, _ = self.image(*changes)
        counts = bench_run.draw(self.plan, bench_rgb565.CORE, self.entry.get("program", "fixel"), file).instructions
        return sum(counts) / len(counts)

    def on(self, screen):
        """Instructions of a mean frame on a screen."""
        return self.mean("x".join(map(str, screen)))

    def staged(self, file):
        """Instructions of the budget's stage in a mean frame."""
        taken, frames = bench_run.profile(self.plan, bench_rgb565.CORE, "fixel", file)
        return taken.stages[self.entry["stage"]] / frames


def _pixel(frames):
    (wide, height), (narrow, _) = WIDE, NARROW
    return (frames.on(WIDE) - frames.on(NARROW)) / ((wide - narrow) * height)


def _row(frames):
    """A row before its pixels."""
    (width, height), (_, less) = NARROW, SHORT
    return (frames.on(NARROW) - frames.on(SHORT)) / (height - less) - width * _pixel(frames)


def _added(frames):
    return (frames.mean(frames.entry["more"]) - frames.mean()) / frames.entry["per"]


def _taken(frames):
    """What the scene has more than with the changes `less`."""
    return (frames.mean() - frames.mean(frames.entry["less"])) / frames.entry["per"]


def _frame(frames):
    return frames.mean() / frames.entry["per"]


def _times(frames):
    return frames.mean(frames.entry["more"]) / frames.mean()


def _stage(frames):
    return frames.staged(frames.image()[0]) / frames.entry["per"]


def _calls(frames):
    """A call of a function, with what it calls."""
    taken, _ = bench_run.profile(frames.plan, bench_rgb565.CORE, frames.entry["program"], frames.image()[0])
    rows = {row["function"]: row for row in places.as_json(taken, 1)["functions"]}
    row = rows.get(frames.entry["function"])
    if row is None:
        raise ToolError(f"{frames.entry['name']}: no frame calls {frames.entry['function']}; bench/bench.toml names a function")
    return row["inclusive"] / row["entered"] / frames.entry["per"]


def _terrain(frames):
    """A stage in a frame of a terrain, for each face of it."""
    scene = bench_changes.terrain(frames.image()[1], frames.entry["faces"])
    file = bench_plan.save_scene(scene, f"{frames.folder}/terrain.fxls")
    return frames.staged(file) / frames.entry["faces"] / frames.entry["per"]


KINDS = {"pixel": _pixel, "row": _row, "added": _added, "taken": _taken, "frame": _frame, "times": _times, "stage": _stage, "calls": _calls, "terrain": _terrain}


def _measure(plan, entry):
    with scratch.folder("budget") as folder:
        return round(KINDS[entry["kind"]](_Frames(plan, entry, folder)), 4)


def measure(plan, cores):
    """{name: figure}; nothing where the core was not measured, or workloads were named."""
    if bench_rgb565.CORE not in cores or plan.kept:
        return {}
    return parallel.run("measuring steps", {entry["name"]: (_measure, plan, entry) for entry in plan.budgets})
