# SPDX-License-Identifier: MIT
"""From what was counted to bench.json: rows, limits, sizes, growth, and how pictures compare."""

from fixel.bench import bench_goals, bench_plan, linked_size, places

FLAGS = {"O2": "-O2", "Os": "-Os"}
SIZED = ("m0", "m3")    # cores by -Os and for few bytes too: BENCH_SIZED_CORES of bench/bench.mk
SMALL = {"small": "-Os -DFXL_SMALL", "small-flto": "-Os -DFXL_SMALL -flto"}     # the library alone
LIMIT = "limit-"
BANDS = "fixel-bands"


def _ratio(value, other):
    return None if other in (None, 0) else round(value / other, 4)


def frame_row(core, workload, renderer, drawn, units):
    """A row of a workload; its ratios are filled in later."""
    total, frames = sum(drawn.instructions), len(drawn.instructions)
    return {"workload": workload["name"], "renderer": renderer, "core": core, "instructions": total,
            "frame": {"min": min(drawn.instructions), "mean": round(total / frames),
                      "max": max(drawn.instructions)},
            "per_unit": round(total / frames / units, 4), "unit": workload["unit"],
            "ratio_to_listing_double": None, "ratio_to_limit": None, "text_bytes": None,
            "ram_bytes": drawn.memory, "stack_bytes": drawn.stack}


def kernel_row(core, entry, instructions, units):
    """A row of a kernel."""
    return {"workload": entry["name"], "renderer": "fixel", "core": core, "instructions": instructions,
            "frame": None, "per_unit": round(instructions / units, 4), "unit": entry["unit"],
            "ratio_to_listing_double": None, "ratio_to_limit": None, "text_bytes": None,
            "ram_bytes": None, "stack_bytes": None}


def add_ratios(plan, rows, limits):
    """Ratios to the listing in double on the same core, and to the bare work of one unit."""
    doubles = {(row["core"], row["workload"]): row["instructions"] for row in rows
               if row["renderer"] == bench_plan.DOUBLE}
    bare = {(limit["core"], limit["name"]): limit["per_unit"] for limit in limits}
    for row in rows:
        name = row["workload"]
        row["ratio_to_listing_double"] = _ratio(row["instructions"], doubles.get((row["core"], name)))
        entry = plan.workloads.get(name) or plan.kernels[name]
        limit = bare.get((row["core"], entry.get("limit")))
        row["ratio_to_limit"] = _ratio(row["per_unit"], limit and limit * entry.get("limit_units", 1))


def add_sizes(rows, sizes):
    """Each renderer's bytes of flash as it was measured, to the rows of the workloads."""
    text = {(size["core"], size["renderer"]): size["code"] + size["constants"] + size["run_time"] for size in sizes
            if size["flags"] == "-O2"}
    for row in rows:
        if row["frame"] is not None:
            row["text_bytes"] = text.get((row["core"], row["renderer"]))


def sizes(plan, cores):
    """[{core, renderer, flags, code, constants, run_time, ram, helpers}] of each renderer linked by itself."""
    programs = [(renderer, folder, flags) for renderer in plan.renderers
                for folder, flags in ({**FLAGS, **SMALL} if renderer == bench_goals.OURS else FLAGS).items()]
    return [{"core": core, "renderer": renderer, "flags": flags,
             **linked_size.sizes_of_map(plan.build / "bench" / core / "size" / folder / f"{renderer}.map")}
            for core in cores for renderer, folder, flags in programs if folder == "O2" or core in SIZED]


def renderer_bytes(plan, cores):
    """{core: bytes} of RAM of a renderer by itself: the variable of that name in the map of the program that draws in bands."""
    return {core: sum(size for section, size, _ in
                      linked_size.sections_of_map(plan.program(core, BANDS).with_suffix(".map"))
                      if section == ".bss.renderer") for core in cores}


def pictures(drawn):
    """[{core, workload, renderer, pixels, differing, uncovered}]: the others' pixels against the library's, and
    how many only one of both has drawn over the background, which is 0."""
    rows = []
    for (core, workload, renderer), each in drawn.items():
        if renderer == "fixel":
            continue
        ours = drawn[core, workload, "fixel"].pixels
        rows.append({"core": core, "workload": workload, "renderer": renderer,
                     "pixels": int(ours.size), "differing": int((ours != each.pixels).sum()),
                     "uncovered": int(((ours != 0) != (each.pixels != 0)).sum())})
    return rows


def variants(drawn, others):
    """[{variant, workload, core, frame, fixel, by_fixel, ram_bytes, stack_bytes}] of the library built otherwise, or with
    other memory: a mean frame, the library's as measured, and the first by that."""
    rows = []
    for (core, workload, name), each in others.items():
        ours, theirs = sum(each.instructions), sum(drawn[core, workload, "fixel"].instructions)
        rows.append({"variant": name, "workload": workload, "core": core,
                     "frame": round(ours / len(each.instructions)), "fixel": round(theirs / len(each.instructions)), "by_fixel": _ratio(ours, theirs),
                     "ram_bytes": each.memory, "stack_bytes": each.stack})
    return rows


def stages(profiles):
    """[{core, workload, frames, stage, instructions, functions{name: instructions}}] in the order of the
    pipeline, instructions of all frames together."""
    return [{"core": core, "workload": workload, "frames": frames, "stage": stage,
             "instructions": taken.stages[stage], "functions": _functions(taken, stage)}
            for (core, workload), (taken, frames) in profiles.items()
            for stage in places.in_order(taken.pipeline, taken.stages)]


def estimates(profiles):
    """[{core, workload, model, title, cycles}]: an ESTIMATE of cycles (cycles.FIGURES) of a mean frame, on each model by the
    code of the nearest core that was profiled."""
    cores = {core for core, _ in profiles}
    return [{"core": core, "workload": workload, "model": name, "title": model.title,
             "cycles": [round(each / frames) for each in taken.total.cycles[name]]}
            for (core, workload), (taken, frames) in profiles.items() for name, model in taken.models.items()
            if core == next(each for each in model.code if each in cores)]


def _functions(taken, stage):
    """What each function took in a stage, the most first."""
    found = [(number, name) for (where, name), number in taken.staged.items() if where == stage]
    return {name: number for number, name in sorted(found, key=lambda item: (-item[0], item[1]))}


def split_kernels(plan, core, counted):
    """Rows of the kernels, and the limits [{core, name, unit, instructions, per_unit}]."""
    rows, limits = [], []
    for name, (instructions, units) in counted.items():
        row = kernel_row(core, plan.kernels[name], instructions, units)
        if name.startswith(LIMIT):
            limits.append({"core": core, "name": name, "unit": row["unit"],
                           "instructions": instructions, "per_unit": row["per_unit"]})
        else:
            rows.append(row)
    return rows, limits
