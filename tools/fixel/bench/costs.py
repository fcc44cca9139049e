# SPDX-License-Identifier: MIT
"""Renews bench/costs.json: what a frame costs on the cores given, and what the walk takes on the boards given.

Counts what the library does in scenes of the bench and in some of its own, and the instructions that programs of the bench
execute for them, with the memory of a large board down to that of a small one. Fits a cost for each count, and for a core of
bench/cycles.toml what each part of a frame takes (stage_costs.py). Exit: 0 done, 1 a program failed.
"""

import argparse
import dataclasses
import pathlib
import sys

from fixel.base import kept, output, scratch
from fixel.base.arguments import number
from fixel.base.errors import ToolError
from fixel.base.table import table
from fixel.board import methods
from fixel.commands import late
from fixel.image import memory_needed
from fixel.scene import look as looks, target

parallel = late("fixel.base", "parallel")
bench, bench_plan, bench_run, cycles, frame_costs, stage_costs = late("fixel.bench", "bench bench_plan bench_run cycles frame_costs stage_costs")
emulator, fleet, qemu = late("fixel.board", "emulator fleet qemu")
image = late("fixel.image", "image")
showcase_models = late("fixel.report", "showcase_models")
making = late("fixel.scene", "making")
np = late("numpy")

OWN = ("", "_sphere", "_surfaces", "_rooms", "_lights", "_lamps", "_turned", "_turned_lit", "_depth", "_depth_textures", "_smooth",
       "_glass", "_pane", "_billboards", "_wood", "_beams", "_tree", "_parallel", "_parallel_textures", "_texels", "_colours", "_colours_wall", "_all")
LINES = ("bench/costs_lines.toml", "bench/scenes/lines.toml")
TEXTURED = ("bench/scenes/tqa.toml", "bench/scenes/tqp.toml", "bench/scenes/crates.toml")
MORE = (*(f"bench/costs{name}.toml" for name in OWN), *TEXTURED, "bench/scenes/boxes.toml", "scenes/tiny.toml", "scenes/cube.toml", "scenes/adversarial.toml",
        "scenes/landscape.toml", "scenes/horizon.toml", *LINES)
# place pixel-format: what is counted (wide_...), and what it costs
# Scenes of these drawn as something else: RGB565, with a depth buffer, and by a tree of all their layers.
WIDE = tuple(f"bench/costs{name}.toml" for name in ("", "_surfaces", "_rooms", "_lights", "_depth", "_smooth", "_glass", "_pane", "_billboards",
                                                    "_wood", "_texels", "_all")) + \
    (*TEXTURED, *LINES, "scenes/w1.toml", "scenes/w2.toml", "scenes/tiny.toml", "scenes/cube.toml", "scenes/horizon.toml")
DEEP = tuple(f"bench/costs{name}.toml" for name in ("_sphere", "_parallel", "_parallel_textures", "_surfaces", "_rooms", "_turned_lit", "_wood", "_beams")) + TEXTURED[1:]
TREES = (*(f"bench/costs{name}.toml" for name in ("", "_surfaces", "_rooms", "_lights")), "scenes/plaza.toml", "scenes/landscape.toml",
         "scenes/w1.toml")
# Models of the showcase by themselves: large smooth faces, large textures in RGB565, many parts.
BARE = ("crate", "village", "city", "bracket", "badge", "car", "character", "quilt", "gem", "rainbow", "vase", "knot", "cover", "plant",
        "lantern", "sign", "pawn", "column", "photo", "relief", "planets", "house")
BARE_FRAMES = 8
STACK_SCENES = ("scenes/tiny.toml", "bench/costs.toml", "scenes/plaza-turned.toml")
STACK_LOOKS = ("bench/costs_lights.toml", "bench/costs_surfaces.toml", "bench/costs_all.toml", "bench/costs_glass.toml",
               "bench/costs_beams.toml", "bench/costs_tree.toml", "bench/costs_deepest.toml", "bench/costs_deepest_tree.toml")
STACK_FRAMES = 4
# Few others of the fit are like these scenes: frames of few flat faces, and lines in RGB565. Each counts as several do.
RARE = ("scenes/tiny.toml", "scenes/w2.toml", "bench/costs_lines.toml PIXELS=rgb565", "bench/scenes/lines.toml PIXELS=rgb565")
RARE_WEIGHT = 4


def setting(text):
    """("SMALL", (8, 1024, 8, 0)) of "SMALL=8:1024:8:0"."""
    name, _, numbers = text.partition("=")
    return name, tuple(map(int, numbers.split(":")))


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--cores", nargs="*", default=[], help="others stay as they are in the file")
    made.add_argument("--sizes", nargs="+", type=setting, metavar="NAME=ROWS:WORDS:ENTRIES:MORE",
                      help="of the cores' programs: rows of a band, words of the list, entries of the cache, and how many more "
                           "entries of the order than a scene needs")
    made.add_argument("--only-new", action="store_true", help="find the costs that the file lacks, by the scenes that have some; "
                                                                 "those that it has stay")
    made.add_argument("--only-stages", action="store_true", help="divide the costs that the file has among the parts of a frame, and find their cycles")
    made.add_argument("--frames", type=number("FRAMES", 1, 1_000_000), default=30, help="of each scene, at most (30)")
    made.add_argument("--boards", nargs="*", default=[], help="others stay as they are in the file")
    made.add_argument("--build", default="build", help="folder that make builds in")
    return made


def room_of(words):
    """Bytes of a board's display list that leave so many words to it, whatever a scene has beside its faces:
    ROOM_BYTES of bench/firmware/draw_costs.c."""
    return 8 * words + 65536


@dataclasses.dataclass(frozen=True)
class Source:
    """A scene of the fit, and what it is drawn as. layers: of its tree, instead of what it says. look: of a model of the
    showcase, whose name the scene then is."""
    scene: str
    asked: target.Target = target.Target()
    layers: str = None
    look: looks.Look = None

    @property
    def name(self):
        """What people know it by."""
        return " ".join([self.scene, *([self.asked.text] if self.asked else []), *([f"by itself, {self.look.pixels}"] if self.look else [])])

    def build(self, file):
        """Writes the scene image."""
        if not self.look:
            making.build(self.scene, file, layers=self.layers, asked=self.asked)
            return
        with scratch.folder("costs") as folder:
            model = next(each for each in showcase_models.MODELS if each.name == self.scene)
            making.build(str(showcase_models.write(model, folder)), file, BARE_FRAMES, looks=(self.look,))


def scenes_of(plan):
    """The scenes of the fit."""
    return [each["scene"] for each in plan.workloads.values()] + list(MORE)


def sources_of(plan):
    """The scenes, and some of them drawn as something else."""
    return [*(Source(scene) for scene in dict.fromkeys(scenes_of(plan))), *(Source(scene, target.Target(pixels="rgb565")) for scene in WIDE),
            *(Source(scene, target.Target(depth="16")) for scene in DEEP), *(Source(scene, target.Target("rgb565", depth="16")) for scene in DEEP),
            *(Source(scene, target.Target(depth="0")) for scene in LINES),
            *(Source(scene, target.Target(order="tree", depth="0"), "all") for scene in TREES),
            *(Source(name, look=look) for name in BARE for look in (looks.Look(), looks.Look(pixels="palette")))]


def counted(plan, settings, file, frames):
    """(names, counts) of the frames of a scene image. settings: rows of a band, words of the list, entries of
    the cache, and of the order beside those that the scene needs. frames: at most."""
    scene = image.load(file)
    rows, words, cache, more = settings
    return frame_costs.count(plan.build, file, rows * scene.width * scene.pixel_bits // 8,
                             memory_needed.draw_list_needed(scene) + more, room_of(words), cache, 4 * words, frames)


def measure(plan, core, size, settings, file, frames):
    """(names, counts, instructions) of the frames of a scene image; counted has the settings."""
    names, counts = counted(plan, settings, file, frames)
    drawn = bench_run.draw(plan, core, f"costs-{size}", file, len(counts))
    return names, counts, np.array(drawn.instructions, dtype=float)


def fit(measured, known):
    """Costs of a core, and the error of each scene's mean frame; each program and scene has the same weight, but RARE ones. known:
    costs that stay."""
    names = next(iter(measured.values()))[0]
    rows = np.concatenate([counts for _, counts, _ in measured.values()])
    wanted = np.concatenate([taken for *_, taken in measured.values()])
    weights = np.concatenate([np.full(len(taken), (RARE_WEIGHT if scene in RARE else 1) / len(taken))
                              for (_, scene), (*_, taken) in measured.items()])
    found = frame_costs.fit(rows, wanted, weights, np.array([known.get(name, np.nan) for name in names]))
    errors = {key: float((counts @ found).mean() / taken.mean() - 1) for key, (_, counts, taken) in measured.items()}
    return dict(zip(names, (round(float(cost), 3) for cost in found))), errors


def counts_new(plan, file, known):
    """Whether the library does something in a scene image whose cost is not among the known."""
    names, counts = frame_costs.count(plan.build, file, 240 * image.load(file).width * 2, 0, room_of(4096), 64, 0, 4)
    return any(times > 0 and name not in known for name, times in zip(names, counts.sum(axis=0)))


def build_scenes(plan, folder, known):
    """{name: image file} of the scenes of the fit; of those in which a cost is not known, if some are."""
    files = {}
    for number, source in enumerate(sources_of(plan)):
        file = pathlib.Path(folder) / f"{number}.fxls"
        source.build(file)
        if not known or counts_new(plan, file, known):
            files[source.name] = file
    return files


def cores(plan, names, sizes, folder, known, frames):
    """{core: costs}, and a table of errors. known: {core: costs that stay}."""
    files = build_scenes(plan, folder, set.intersection(*(set(known.get(core, {})) for core in names)))
    jobs = {(core, size, source): (measure, plan, core, size, settings, file, frames)
            for core in names for size, settings in sizes.items() for source, file in files.items()}
    measured, result, rows = parallel.run("measuring", jobs), {}, []
    for core in names:
        own = {key[1:]: found for key, found in measured.items() if key[0] == core}
        result[core], errors = fit(own, known.get(core, {}))
        rows += [[core, source, *(f"{100 * errors[size, source]:+.1f} %" for size in sizes)] for source in files]
    return result, table(rows, ["core", "scene", *sizes])


def stages(plan, known, sizes, folder):
    """What stage_costs.find says of the known costs of cores, and a table of errors."""
    files = {}
    for number, source in enumerate(sources_of(plan)):
        if number % stage_costs.EACH and source.name not in stage_costs.ALSO:
            continue
        files[source.name] = pathlib.Path(folder) / f"stages-{number}.fxls"
        source.build(files[source.name])
    found, errors = stage_costs.find(plan, sizes, files, known, lambda settings, file, frames: counted(plan, settings, file, frames))
    return found, "\n".join(table(rows, [f"{core}: scene", "instructions in another part", *cycles.models(core)]) for core, rows in errors.items())


def deepest_stack(board, elf, sources, room, folder):
    """Bytes of the deepest stack that the walk saw in these scenes; None where it has room for none of them."""
    seen = []
    for source in sources:
        file = pathlib.Path(folder) / f"{board}-{pathlib.Path(source).stem}.fxls"
        making.build(source, file, frames=STACK_FRAMES)
        if file.stat().st_size > room:
            continue
        try:
            seen.append(fleet.stack_seen(board, elf, file, pathlib.Path(folder)))
        except ToolError as error:
            if error.exit_code != emulator.exit_code("CAPACITY"):   # no room for the scene's order, motions or surfaces
                raise
    return max(filter(None, seen), default=None)


def board_sizes(board, build, folder):
    """What the walk takes on a board, and the deepest stack that it saw: with flat colours alone, and with more."""
    elf = methods.elf_of(board, build)
    sizes = fleet.sizes(elf)
    plain = deepest_stack(board, elf, STACK_SCENES, sizes["scene_room"], folder)
    looks = deepest_stack(board, elf, STACK_LOOKS, sizes["scene_room"], folder)
    if plain is None:
        raise ToolError(f"{board}: no scene of {', '.join(STACK_SCENES)} fits", exit_code=1)
    return {**sizes, "stack_seen": plain, "stack_seen_looks": max(plain, looks or 0),
            "stack_reserved": fleet.stack_reserved(elf)}


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    plan = bench_plan.Plan(options.build)
    plan.store = kept.Kept(options.build, folder=bench.COUNTED, most=bench.COUNTED_MOST)
    qemu.find_qemu()
    if options.cores and not options.sizes:
        raise ToolError("--cores needs --sizes")
    known = frame_costs.load() if frame_costs.FILE.exists() else {"cores": {}, "boards": {}}
    sizes, errors = dict(options.sizes or []), ""
    with scratch.folder("costs") as folder:
        if options.cores and not options.only_stages:
            found, errors = cores(plan, options.cores, sizes, folder, known["cores"] if options.only_new else {}, options.frames)
            known["cores"].update(found)
        timed = {core: known["cores"][core] for core in options.cores if cycles.models(core)}
        found, more = stages(plan, timed, sizes, folder) if timed else ({}, "")
        for kind, each in found.items():
            known[kind] = {**known.get(kind, {}), **each}
        known["boards"].update((board, board_sizes(board, options.build, folder)) for board in options.boards)
    output.write_json(frame_costs.FILE, known)
    print(errors, more, sep="\n")
    print(f"{frame_costs.FILE}", file=sys.stderr)
    return 0
