# SPDX-License-Identifier: MIT
"""Whole frames as pixels of RGB565, in each way in which the library can make them: [[rgb565]] of bench/bench.toml.

Counted is from the pose to the pixels. The clear of the colours is not counted, that of a depth buffer is.
"""

from fixel.base import parallel, scratch
from fixel.bench import bench_changes, bench_plan, bench_run, cycles
from fixel.bench.machine_code import MachineCode, read_once

TEXELS = "16 bits"
# The program, and what is changed in the scene. Pixels of a palette are converted after they are drawn.
WAYS = {"palette, converted": ("fixel-rgb565", []), "RGB565": ("fixel-native", ["rgb565"]),
        "RGB565, its texels too": ("fixel-native", ["rgb565", TEXELS])}
BANDS, BITS = "bands of 8", "4 bits"    # variants: another program; texels that cannot be of RGB565
CORE = "m3"                             # of workloads that name none, and of variants


def named(workload, variant=None):
    """What a row is called: a workload, or a variant of it."""
    return f"{workload}, {variant}" if variant else workload


def changes_of_programs():
    """{program: changes of the scene}: of its first way."""
    return {program: changes for program, changes in reversed(WAYS.values())}


def pixels_of(variant):
    """How many times the pixels of a frame of the workload a variant of it has, at least 1."""
    width, height = bench_changes.SCREENS.get(variant, (320, 240))
    return max(1, width * height / (320 * 240))


def _jobs(plan, cores):
    """(core, entry, variant, way) of what is drawn."""
    for entry in plan.rgb565.values():
        textured, wide = bench_changes.has_textures(entry), bench_changes.is_rgb565(entry)
        variants = [*plan.rgb565_variants["moved"], *(plan.rgb565_variants["textured"] if textured else ())] \
            if plan.kept else ()
        for core in entry.get("cores", [CORE]):
            for variant in [None, *(variants if core == CORE else ())]:
                for way, (_, changes) in WAYS.items():
                    if core in cores and not (TEXELS in changes and (not textured or variant == BITS)) and (changes or not wide):
                        yield core, entry, variant, way


def _draw(plan, core, entry, variant, way):
    """A row: instructions and cycles of a mean frame."""
    program, changes = WAYS[way]
    wanted = [*entry.get("with", ()), *([variant] if variant and variant != BANDS else []), *changes]
    elf = plan.program(core, program + ("-bands" if variant == BANDS else ""))
    with scratch.folder("bench") as folder:
        file, _ = bench_plan.compile_scene({**entry, "with": wanted}, folder)
        code = read_once(MachineCode, elf)
        _, counts = bench_run.count(plan, elf, folder, file, detail=True)
    frames = len(counts.regions)
    return {"workload": named(entry["name"], variant), "core": core, "way": way, "frames": frames,
            "frame": round(sum(counts.regions) / frames),
            "cycles": {name: [round(each / frames) for each in model.total(code, counts)]
                       for name, model in cycles.models(core).items()}}


def measure(plan, cores):
    """The rows of all workloads that the plan has."""
    return list(parallel.run("drawing to RGB565", {number: (_draw, plan, *job)
                                                   for number, job in enumerate(_jobs(plan, cores))}).values())


def best(result, workload, core):
    """The row of the way that takes the fewest instructions; None where none was measured."""
    return min((row for row in result["rgb565"] if (row["workload"], row["core"]) == (workload, core)),
               key=lambda row: row["frame"], default=None)


HEADER = ["to RGB565", "core", "best way", "a frame", *(f"ESTIMATE of cycles, {name}" for name in cycles.FIGURES), *WAYS]


def cells(result):
    """For each workload and core: the best way, its cycles on the core itself, and what each way takes."""
    made = []
    for workload, core in dict.fromkeys((row["workload"], row["core"]) for row in result["rgb565"]):
        ways = {row["way"]: row["frame"] for row in result["rgb565"] if (row["workload"], row["core"]) == (workload, core)}
        shown = best(result, workload, core)
        made.append([workload, core, shown["way"], shown["frame"], *next(iter(shown["cycles"].values()), [None] * len(cycles.FIGURES)),
                     *[ways.get(way) for way in WAYS]])
    return made
