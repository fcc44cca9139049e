# SPDX-License-Identifier: MIT
"""How a board draws a model without a scene file: as its author made it where the board has the room, and else as much
of that as fits (scene/look.py has the steps).

A board draws a Look if it is the host or holds the whole frame; or bands of at least ROWS_MIN rows, with a display list that holds the
frame; or if its frames are predicted to take at most DEARER_MAX times those of a palette by distance. A program's file
says how much memory it has and what it draws. The predictions are those of make predict; where its program is not
built, the memory alone decides. Of a board whose code bench/costs.json has no costs of, those of CORE compare two looks, and no
instructions are told."""

import pathlib
import sys
from dataclasses import dataclass, replace

from fixel.base import bounded, output
from fixel.base.errors import ToolError, one_line
from fixel.bench import frame_costs
from fixel.board import firmware, fleet, order_check
from fixel.image import image as images, memory_needed
from fixel.image.fields import IMAGE_MAX
from fixel.model import suffixes
from fixel.scene import look as looks
from fixel.scene import making

ROWS_MIN = 16
DEARER_MAX = 2
CHEAPER_FACES_MAX = 8192    # of a model whose frames in a palette are predicted too, for the line alone
HOST_LIST_MOST = 4096       # WALK_LIST_MOST of the host
CORE = "m3"
_ARRAYS = {"band": "band_pixels", "order": "order", "list": "list", "cache": "cache"}
_ENTRY = {"order": 12, "cache": 40}     # bytes


@dataclass(frozen=True)
class Room:
    """What a program has room for: bytes of a band, of the display list and of a scene; entries of the order and of the
    cache; the targets that it draws, (bits of a pixel, bits of its depth); the core whose costs it has, or None;
    bytes of the board's RAM; whether it is the host's, which has room for any look and draws in narrow bands by choice."""
    band: int
    order: int
    list: int
    cache: int
    scene: int
    list_most: int
    has_surfaces: bool
    targets: frozenset
    core: str
    ram: int = 0
    is_host: bool = False


def _symbols(elf):
    table = firmware.open_elf(elf).get_section_by_name(".symtab")
    return {symbol.name: symbol for symbol in table.iter_symbols()} if table else {}


# place pixel-format: which boards have the room
def room_of(elf):
    """The Room of a program's file."""
    program, symbols = firmware.load(elf), _symbols(elf)
    sizes = {name: symbols[array]["st_size"] if array in symbols else 0 for name, array in _ARRAYS.items()}
    targets = {(8, 0)} | {(bits, depth) for bits, kind in ((8, "palette"), (16, "rgb565")) for depth in (0, 16, 32)
                          if f"fxl_{kind}" + (f"_depth_{depth}" if depth else "") in symbols}
    return Room(sizes["band"], sizes["order"] // _ENTRY["order"], sizes["list"], sizes["cache"] // _ENTRY["cache"],
                IMAGE_MAX if program.hosted else program.scene_size, HOST_LIST_MOST if program.hosted else 0,
                "fxl_attach_surfaces" in symbols, frozenset(targets), _core_of(program),
                0 if program.hosted else fleet.sizes(elf)["ram_size"], program.hosted)


def _core_of(program):
    """The core of bench/costs.json that has the code of a program, or None."""
    return None if program.code else frame_costs.core_of(f"-mcpu={program.cpu} -march={program.cpu} -mfloat-abi=soft")  # as all boards have


def band_of(room, scene, most=None):
    """(bytes, rows) of a band of a scene in a room. most: rows at most, or None."""
    row = scene.width * scene.pixel_bits // 8
    rows = min(scene.height, room.band // row, most or scene.height)
    return rows * row, rows


@dataclass(frozen=True)
class Drawn:
    """A Look as a board draws it: its scene image, rows of a band, whether the list holds every frame, instructions of a
    mean frame or None, whether they are the board's own, or why it cannot."""
    look: looks.Look
    image: object
    scene: object
    made: making.Made
    rows: int = 0
    is_held: bool = False
    instructions: float = None
    is_told: bool = True
    why_not: str = ""

    @property
    def cost(self):
        """The instructions for people, or ""."""
        return _short(self.instructions) if self.instructions and self.is_told else ""

    @property
    def is_whole(self):
        return self.rows >= self.scene.height


def _predicted(room, build, file):
    """(whether the list holds every frame, instructions of a mean frame) by make predict's program; (None, None) where it is
    not built. frame_costs.NoRoom where the board cannot."""
    if not (pathlib.Path(build) / "host" / "predict").exists():
        return None, None
    names, counts = frame_costs.count(build, file, room.band, room.order, room.list, room.cache, room.list_most)
    costs = frame_costs.load()["cores"][room.core or CORE]
    spilled = counts[:, [names.index("spilled_faces")]].sum()
    return spilled == 0, float(frame_costs.instructions(costs, names, counts).mean())


def _refusal(room, scene, size):
    """Why a program cannot draw a scene image at all, or ""."""
    if size > room.scene:
        return f"its image has {size:,} bytes, and the board has room for {room.scene:,}"
    if (scene.pixel_bits, scene.depth_bits) not in room.targets:
        return "the board's program does not draw " + ("RGB565" if scene.pixel_bits == 16 else "in a palette") + \
            (f" with {scene.depth_bits} bits of depth" if scene.depth_bits else "")
    if scene.surfaces and not room.has_surfaces:
        return "the board's program draws no surfaces"
    return _order_refusal(room, scene)


def _order_refusal(room, scene):
    """Why the order of drawing has no room for a scene's faces, or ""."""
    needed = memory_needed.draw_list_needed(scene)
    if room.order == 0 or needed <= room.order:
        return ""
    return f"its {_faces(scene):,} faces need {needed:,} entries of the order of drawing, and the board has {room.order:,}"


def _faces_that_fit(room, scene):
    """How many faces of a model's file the order of drawing has room for, of a scene that has too many. Faces that show from
    both sides are two."""
    largest = max(len(model.faces) for model in scene.models if model.kind == images.SORTED)
    sheets = sum(len({frozenset(face.corners) for face in model.faces}) for model in scene.models)
    found = max(room.order - len(scene.objects), 0) * sheets // largest
    step = 100 if found >= 1000 else 10
    return max(found // step * step, 4)


def _faces(scene):
    return sum(len(model.faces) for model in scene.models)


class _Chooser:
    """Tries Looks of one model on one board."""

    def __init__(self, options, room, build, folder):
        self.options, self.room, self.build, self.folder = options, room, build, pathlib.Path(folder)
        self.tried = {}
        self.has_too_many = False   # faces for the order of drawing: then no texture is too large

    def draw(self, look):
        """The Drawn of a Look, made once."""
        if look not in self.tried:
            self.tried[look] = self._draw(look)
        return self.tried[look]

    def _draw(self, look):
        options, file = self.options, self.folder / f"model-{len(self.tried)}.fxls"
        try:
            made = making.build(options.scene, file, options.frames, options.screen, limits=bounded.limits_of(options),
                                asked=options.target, looks=(look,), write=options.look.write, verbose=options.look.verbose)
        except ToolError as error:
            if look.texels == 0:
                raise
            return Drawn(look, None, None, None, why_not=str(error))    # such as an image of more than 16 MiB
        scene, size = images.load(file), file.stat().st_size
        drawn = {"look": look, "image": file, "scene": scene, "made": made, "rows": band_of(self.room, scene)[1]}
        why_not = _refusal(self.room, scene, size)
        if why_not:
            return Drawn(**drawn, why_not=why_not)
        try:
            is_held, instructions = _predicted(self.room, self.build, file)
        except frame_costs.NoRoom as error:
            return Drawn(**drawn, why_not=str(error).rpartition(": ")[2])
        return Drawn(**drawn, is_held=bool(is_held) if is_held is not None else drawn["rows"] >= ROWS_MIN,
                     instructions=instructions, is_told=self.room.core is not None)

    def largest(self, pixels, depth):
        """The first Look of a target that the board draws at all; else the last one."""
        wanted = looks.smaller(self.options.look, pixels, depth)
        flat = [each for each in wanted if not each.texels and not each.smooth]
        wanted = flat if self.has_too_many else wanted
        while True:
            drawn = self.draw(wanted[0])
            wanted = wanted[1:] if drawn.scene is None else looks.after(wanted, drawn.scene)
            if not drawn.why_not or not wanted:
                return drawn
            if drawn.scene and _order_refusal(self.room, drawn.scene):
                self.has_too_many, wanted = True, [each for each in wanted if each in flat]     # whose faces of many corners stay whole

    def is_good(self, drawn, plain):
        """Whether a board is to draw a Look. plain: answers the Drawn of a palette by distance."""
        if drawn.why_not:
            return False
        if self.room.is_host or drawn.is_whole or drawn.rows >= ROWS_MIN and drawn.is_held:
            return True
        other = plain()
        return bool(drawn.instructions and other.instructions) and drawn.instructions <= DEARER_MAX * other.instructions

    def choose(self):
        """The Drawn of the best Look that the board has room for; and why better ones are not drawn."""
        wanted, why = looks.targets(self.options.look, self.options.target, False), []
        for pixels, depth in wanted:
            found = self.largest(pixels, depth)
            if (pixels, depth) == wanted[-1] or self.is_good(found, lambda: self.largest(*wanted[-1])):
                return found, why + self.left_out(pixels, depth, found)
            why.append(f"in {_target_text(pixels, depth)}: {found.why_not or _dear(found)}")
        raise AssertionError("there is a last one")


    def left_out(self, pixels, depth, found):
        """[why a board draws less of a target than there is], or nothing. found: the Drawn that it draws."""
        first = next((self.tried[look] for look in looks.smaller(self.options.look, pixels, depth) if look in self.tried), found)
        if first is found or not first.why_not:
            return []
        there, less = (_parts(each.scene) + ["an animation"] * bool(each.scene.motions) if each.scene else
                       [f"textures of {each.look.texels} texels a side"] for each in (found, first))
        return [f"with {' and '.join(part for part in less if part not in there)}: {first.why_not}"] if less != there else []


def _dear(drawn):
    """What is against a Look that a board could draw."""
    how = "" if drawn.is_held else ", and the display list does not hold a frame"
    cost = f", {drawn.cost} instructions a frame" if drawn.cost else ""
    return f"bands of {drawn.rows} rows{how}{cost}"


def _short(number):
    """A number of two or three digits, as 1.9 M."""
    for unit, name in ((1e6, " M"), (1e3, " K")):
        if number >= unit:
            return f"{number / unit:.{0 if number >= 10 * unit else 1}f}{name}"
    return f"{number:.0f}"


def _kilobytes(number):
    """Bytes, upward, as 300 KB or 4 MB."""
    return f"{number >> 20:,} MB" if number and number % (1 << 20) == 0 else f"{-(-number // 1024):,} KB"


def _target_text(pixels, depth):
    return ("RGB565" if pixels == "rgb565" else "palette") + (f", depth {depth}" if depth else "")


def _parts(scene):
    """What is shown beside colours, as a list."""
    found = []
    if scene.surfaces and scene.surfaces.textures:
        most = max(1 << max(each.log_width, each.log_height) for each in scene.surfaces.textures)
        found.append(f"textures of at most {most} texels a side")
    if scene.light:
        found.append("light at run time")
    return found


def _line(drawn, cheaper, order, ram=0):
    """What was chosen, and what it takes. cheaper: the Drawn of a palette, or None. order: what there is to say of the order.
    ram: bytes of the board's."""
    scene = drawn.scene
    pixels = "rgb565" if scene.pixel_bits == 16 else "palette"
    taken = scene.width * drawn.rows * (scene.pixel_bits + scene.depth_bits) // 8
    bands = f"whole frame {scene.width}x{scene.height}" if drawn.is_whole else \
        f"bands of {drawn.rows} rows of {scene.width}x{scene.height}"
    text = f"{_target_text(pixels, scene.depth_bits)}, {', '.join([bands, *_parts(scene)])}: {_kilobytes(taken)}{f' of {_kilobytes(ram)}' if ram else ''} of RAM for pixels" \
        f"{' and depth' if scene.depth_bits else ''}, an image of {drawn.made.size:,} bytes"
    text += f"; {drawn.cost} instructions a frame" if drawn.cost else ""
    text += f"; --palette: {cheaper.cost}" if cheaper and cheaper.cost else ""
    return text + (f"; {order}" if order else "")


def _chosen(options, room, build, folder):
    """(_Chooser, the Drawn that it chose, why it is not a better one)."""
    chooser = _Chooser(options, room, build, folder)
    drawn, why = chooser.choose()
    if drawn.image is None:
        raise ToolError(drawn.why_not)
    too_many = _order_refusal(room, drawn.scene)
    if too_many:
        most = _faces_that_fit(room, drawn.scene)
        raise ToolError(f"{one_line(options.scene)}: {too_many}; LOOK='--simplify {most}' keeps {most} faces")
    for each in why:
        print(f"  {one_line(options.scene)}: not {each}", file=sys.stderr)
    return chooser, drawn


def drawn_for(options, room, build, folder):
    """The Drawn in which make run draws a bare model where there is so much room."""
    drawn = _chosen(options, room, build, folder)[1]
    print(f"  {one_line(options.scene)}: {_line(drawn, None, '', room.ram)}", file=sys.stderr)
    return drawn


def choose(options, room, build, folder):
    """The scene image of a bare model where there is so much room, with a line about what was chosen."""
    chooser, drawn = _chosen(options, room, build, folder)
    for note in drawn.made.notes:
        print(f"  {one_line(note)}", file=sys.stderr)
    cheaper = None
    is_small = _faces(drawn.scene) <= CHEAPER_FACES_MAX
    if drawn.cost and drawn.scene.pixel_bits == 16 and is_small and not options.target.pixels:
        cheaper = chooser.draw(replace(drawn.look, pixels="palette"))
    print(f"  {one_line(options.scene)}: {_line(drawn, cheaper, order_check.text(build, drawn.image), room.ram)}", file=sys.stderr)
    if options.look.write:
        output.write_new(options.look.write, drawn.made.text, "--write")
        print(f"  the same as a scene file: {one_line(options.look.write)}", file=sys.stderr)
    return drawn.image


def scene_image(options, elf, folder):
    """The scene image that a program draws of --scene. options.look: a look.Asked."""
    looks.check(options.look, options.scene, suffixes.is_model(options.scene))
    is_chosen = getattr(options, "visibility", None)
    if is_chosen and options.look:
        raise ToolError(f"VISIBILITY={is_chosen} stands for how a scene is drawn: leave out {options.look.text}")
    if is_chosen or not suffixes.is_model(options.scene):
        return making.make_scene_image(options.scene, pathlib.Path(folder), options.frames, options.screen, bounded.limits_of(options),
                                options.target, options.look.verbose)
    return choose(options, room_of(elf), pathlib.Path(elf).parents[2], folder)
