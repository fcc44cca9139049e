# SPDX-License-Identifier: MIT
"""Which part of a frame a count of bench/costs.json belongs to, and what an instruction of each part costs in cycles.

Programs of make costs draw scenes of its fit, and every place is counted (bench_run.profile). bench/stages.toml says of which part
an instruction is, bench/cycles.toml what it costs on a core. The cost of a count is divided among the parts so that the
scenes' parts are most likely what was counted: by expectation and maximisation, from equal shares, so the parts of a frame add up to
the instructions that are predicted. Cycles are those of a part's mean instruction: on a Cortex-M0+ one takes 1.3 to 1.5 cycles whatever is
drawn, on a Cortex-M3 1.5 to 2.1. They are an estimate without wait states: code in RAM."""

import functools

import numpy as np

from fixel.bench import bench_run, cycles, frame_costs, places
from fixel.base import parallel
from fixel.base.errors import ToolError

PARTS = ("cull", "transform", "clip", "scan", "paint")
EACH = 6            # of the scenes of the fit, every sixth one is profiled
# The others that have counts which these have not.
# place pixel-format: a scene in the new format
ALSO = ("scenes/horizon.toml", "bench/costs_parallel.toml", "bench/costs_parallel_textures.toml DEPTH=16", "bench/costs_lines.toml", "bench/costs_lines.toml DEPTH=0", "bench/costs_beams.toml",
        "bench/costs_lights.toml", "bench/costs_tree.toml", "bench/costs_texels.toml", "bench/costs_colours.toml",
        "bench/costs_glass.toml PIXELS=rgb565", "bench/costs_pane.toml PIXELS=rgb565", "bench/costs_surfaces.toml ORDER=tree DEPTH=0")
SMALL_EACH = 3      # of these, the program with the least memory draws every third one
FRAMES = 4          # of each
STEPS = 3000
LEAST = 5e-4        # a share below it is none


def profiled(plan, core, program, file, frames):
    """{part: places.Sum} of the frames of a scene image."""
    taken, _ = bench_run.profile(plan, core, program, file, frames, is_whole=False)
    found = {part: places.Sum() for part in PARTS}
    for stage, each in taken.by_stage.items():
        found[taken.pipeline.part_of(stage)].add(each.instructions, each.cycles)
    return found


def divide(spent, wanted):
    """Shares of each count in each part, the sum of a count's being 1. spent: instructions of a count in a scene, by the costs;
    wanted: of a part in a scene, as counted."""
    spent, wanted = (each / each.sum(axis=1, keepdims=True) for each in (spent, wanted))
    shares = np.tile(wanted.mean(axis=0), (spent.shape[1], 1))
    of_count = spent.sum(axis=0)[:, None]
    for _ in range(STEPS):
        ratio = wanted / np.maximum(spent @ shares, 1e-12)
        shares = np.where(of_count > 0, shares * (spent.T @ ratio) / np.maximum(of_count, 1e-12), shares)
        shares /= shares.sum(axis=1, keepdims=True)
    shares = np.where(shares < LEAST, 0, shares)
    return shares / shares.sum(axis=1, keepdims=True)


def paces(sums):
    """{model: [cycles of a mean instruction of each part]} of the Sums of scenes; each scene has the same weight."""
    found = {}
    for name in next(iter(sums))[PARTS[0]].cycles:
        weights = [1 / sum(each.instructions for each in scene.values()) for scene in sums]
        found[name] = [round(sum(weight * scene[part].cycles[name][0] for weight, scene in zip(weights, sums) if scene[part].cycles)
                             / sum(weight * scene[part].instructions for weight, scene in zip(weights, sums)), 4) for part in PARTS]
    return found


def of_core(costs, measured):
    """(shares, cycles, rows of errors) of a core: the share of the instructions that is in another part than was counted, and the error of an
    instruction's cycles. costs: of its counts; measured: {scene: (names, sums of counts, {part: Sum})}."""
    names = next(iter(measured.values()))[0]
    spent = np.array([counts for _, counts, _ in measured.values()]) * np.array([costs[name] for name in names])
    unseen = [name for name, total in zip(names, spent.sum(axis=0)) if total == 0 and costs[name] > 0]
    if unseen:
        raise ToolError(f"no scene of make costs that is profiled has {', '.join(unseen)}: name others in ALSO of stage_costs.py")
    wanted = np.array([[sums[part].instructions for part in PARTS] for *_, sums in measured.values()], dtype=float)
    shares, found = divide(spent, wanted), paces([sums for *_, sums in measured.values()])
    errors = []
    for scene, row, (*_, sums) in zip(measured, spent, measured.values()):
        mine, theirs = row @ shares / row.sum(), np.array([sums[part].instructions for part in PARTS]) / sum(sums[part].instructions for part in PARTS)
        spent = {name: sum(part.cycles[name][0] for part in sums.values() if part.cycles) / sum(part.instructions for part in sums.values()) for name in found}
        errors.append([scene, f"{50 * np.abs(mine - theirs).sum():.1f} %", *(f"{100 * (mine @ each / spent[name] - 1):+.1f} %" for name, each in found.items())])
    return {name: [round(float(each), 4) for each in row] for name, row in zip(names, shares)}, found, errors


def find(plan, sizes, sources, known, counted):
    """{"stages": {core: {count: [share of each part]}}, "cycles": {core of bench/cycles.toml: [cycles of an instruction of each part]}} of the
    known costs, and {core: rows of errors}. sizes: those of the programs, of which the first draws all, and the last some; sources: {name: image file};
    counted: (names, counts) of a scene file with a size's settings."""
    large, *_, small = sizes
    drawn = [*((large, source) for source in sources), *((small, source) for source in list(sources)[::SMALL_EACH])]
    counts = {(size, source): counted(sizes[size], sources[source], FRAMES) for size, source in drawn}
    jobs = {(core, size, source): (profiled, plan, core, f"costs-{size}", sources[source], len(counts[size, source][1])) for core in known for size, source in drawn}
    taken, stages, models, errors = parallel.run("profiling", jobs), {}, {}, {}
    for core, costs in known.items():
        measured = {f"{source}, {size}": (counts[size, source][0], counts[size, source][1].sum(axis=0), taken[core, size, source])
                    for size, source in drawn}
        stages[core], found, errors[core] = of_core(costs, measured)
        models.update({name: each for name, each in found.items() if core == next(code for code in cycles.models(core)[name].code if code in known)})
    return {"stages": stages, "cycles": models}, errors


# --- what they say of a scene ---------------------------------------------------------

@functools.cache
def table():
    """bench/costs.json."""
    return frame_costs.load()


def instructions(core, names, counts):
    """An array of a row for each frame: the instructions of each of PARTS, whole ones; None for a core whose parts are not known."""
    known = table()
    if core not in known["stages"]:
        return None
    costs, shares = known["cores"][core], known["stages"][core]
    return np.rint(counts @ np.array([[costs[name] * share for share in shares[name]] for name in names]))


def model_of(flags):
    """The core of bench/cycles.toml that a core with these compiler's flags is, or None: of others the cycles are not known."""
    words = {word.removeprefix("-mcpu=") for word in flags.split() if word.startswith("-mcpu=")}
    return next((name for name in table()["cycles"] if name in words), None)


def paces_of(model):
    """Cycles of an instruction of each of PARTS."""
    return table()["cycles"][model]
