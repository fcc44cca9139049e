# SPDX-License-Identifier: MIT
"""The checker of scene images in Python and the loader in C say the same of every image."""

import random
import struct
import subprocess

import pytest

import section_mutants
from conftest import CHECKOUT
# place field: images that all refuse alike
from scene_sections import bodies, entries, joined, replaced, sealed, section
from section_mutants import put
from fixel.scene import making
from fixel.image import fields, image
from fixel.base.errors import ToolError

BUILT_PROGRAMS = ("host/loader",)
SEED, MUTANTS = 13, 600     # mutants of each image
SCENES = (("host_tests/fuzz/scenes/beam_surfaces", "all"), ("scenes/horizon", None), ("scenes/tiny", None), ("scenes/cube", None), ("scenes/w2", None), ("scenes/beam", None),
          ("scenes/knot", "none"), ("scenes/knot", "all"), ("scenes/beam", "all"), ("host_tests/fuzz/scenes/clusters", None),
          ("host_tests/fuzz/scenes/placements", None), ("host_tests/fuzz/scenes/placements", "0"),
          ("host_tests/fuzz/scenes/light", None), ("host_tests/fuzz/scenes/surfaces", None),
          ("host_tests/fuzz/scenes/texels", None), ("host_tests/fuzz/scenes/billboards", None))
# fxl_status of lib/include/fixel/types.h, as the checker in Python calls it.
STATUSES = dict(enumerate(["ok", "argument", "range", "capacity", "degenerate", "order", "alignment", "size", "magic",
                           "version", "crc", "offset", "count", "index", "normal", "planarity", "reserved", "radius",
                           "face bounds", "bsp", "cluster", "placement"]))


# Of ranges of docs/formats.md: counts, coordinates, texels, parts of one; and the numbers just beyond.
ENDS = sorted({end + step for end in (0, 4, 64, 8191 << 16, 16383 << 16, 1 << 30) for step in (0, 1)} |
              {-1, -(8191 << 16), -(8191 << 16) - 1, -(1 << 30), -(1 << 30) - 1})


def mutant(blob, chance, changes=1):
    """An image with so many numbers that are something else, mostly in a table."""
    blob = bytearray(blob)
    for _ in range(changes):
        where = chance.random()
        if where < 0.25:
            put(blob, chance.randrange(16, fields.HEAD.size), chance)
            continue
        kind, (at, offset, count) = chance.choice(list(entries(blob).items()))
        known = 1 <= kind <= len(fields.SECTIONS)
        if where < 0.4 or count == 0 or not known or offset >= len(blob):
            put(blob, at + chance.choice((0, 2, 4, 8)), chance)
        else:
            size = min(count, 1 << 16) * fields.SECTIONS[kind - 1].entry.size
            put(blob, min(offset + chance.randrange(size), len(blob) - 1), chance)
    return sealed(blob)


def at_the_ends(blob):
    """Images in which one field of a table's first entry has a number at the end of a range, or just beyond it."""
    for kind, (_, offset, count) in entries(blob).items():
        size = fields.SECTIONS[kind - 1].entry.size
        width = min(size, 4)
        for place in range(offset, offset + size - width + 1, width) if count and offset + size <= len(blob) else ():
            old = int.from_bytes(blob[place:place + width], "little")
            for new in {end % (1 << 8 * width) for end in (*ENDS, old - 1, old + 1)} - {old}:
                yield sealed(bytearray(blob[:place] + new.to_bytes(width, "little") + blob[place + width:]))


def with_overlaps(blob):
    """Images whose models share vertices or faces, leave some out, or come in another order."""
    models, count = section(blob, "models")
    made = []
    for number in range(min(count, 4)):
        for field in range(0, 16, 4):
            for step in (-3, -1, 1):
                new = bytearray(blob)
                at = models + 28 * number + field
                struct.pack_into("<I", new, at, (struct.unpack_from("<I", new, at)[0] + step) % (1 << 32))
                made.append(sealed(new))
        made.append(sealed(bytearray(blob[:models + 28 * number] + blob[models:models + 28] +
                                     blob[models + 28 * number + 28:])))
    return made


def python_says(blob):
    """The status by the checker in Python."""
    try:
        image.unpack(blob)
    except ToolError as error:
        return str(error).split(":")[0]
    return "ok"


def loader_says(build, blobs, folder):
    """The statuses by the loader."""
    file = folder / "images"
    file.write_bytes(b"".join(struct.pack("<I", len(blob)) + blob for blob in blobs))
    done = subprocess.run([build / "host" / "loader", file], capture_output=True, text=True, check=True)
    return [STATUSES[int(line.split()[0])] for line in done.stdout.splitlines()]


@pytest.fixture(scope="module", params=SCENES, ids=lambda item: item[0].split("/")[-1] + ("-tree" if item[1] else ""), name="blob")
def fixture_blob(request, tmp_path_factory):
    """A scene's image."""
    name, layers = request.param
    file = tmp_path_factory.mktemp("image") / "scene.fxls"
    making.build(str(CHECKOUT / f"{name}.toml"), str(file), layers=layers)
    return file.read_bytes()


def assert_agreement(build, blobs, folder, same=lambda one, other: one == other):
    """Both say the same of each, and refuse some and take some."""
    ours, theirs = [python_says(blob) for blob in blobs], loader_says(build, blobs, folder)
    assert len(ours) == len(theirs)
    different = [(i, one, other) for i, (one, other) in enumerate(zip(ours, theirs)) if not same(one, other)]
    assert not different, f"{len(different)} of {len(blobs)}: (image, Python, loader): {different[:8]}"
    assert len(set(ours)) > 1


def test_both_say_the_same_of_mutated_images(build, blob, tmp_path):
    chance = random.Random(SEED)
    assert_agreement(build, [blob, *(mutant(blob, chance) for _ in range(MUTANTS))], tmp_path)


def test_both_take_or_refuse_images_with_several_faults(build, blob, tmp_path):
    """Which of the faults comes first may differ."""
    chance = random.Random(SEED + 1)
    blobs = [blob, *(mutant(blob, chance, chance.choice((2, 3))) for _ in range(MUTANTS))]
    assert_agreement(build, blobs, tmp_path, lambda one, other: (one == "ok") == (other == "ok"))


# These have every table.
@pytest.mark.parametrize("blob", [("scenes/beam", "all"), SCENES[1], *SCENES[-6:-5], *SCENES[-4:]], indirect=True, ids=lambda item: item[0])
def test_both_say_the_same_at_the_ends_of_ranges(build, blob, tmp_path):
    assert_agreement(build, [blob, *at_the_ends(blob)], tmp_path)


def test_both_say_the_same_of_models_that_overlap(build, blob, tmp_path):
    made = with_overlaps(blob)
    assert_agreement(build, [blob, *made], tmp_path)
    assert python_says(blob) == "ok"


def test_both_refuse_more_placed_vertices_than_four_million(build, tmp_path):
    square = [(0, 0, 0), (0, 0, 65536), (65536, 0, 65536), (65536, 0, 0)]
    for vertices, objects, status in ((400, 10_000, "ok"), (400, 10_001, "count")):
        model = image.Model(square + [(0, 0, 0)] * (vertices - 4), [image.Face((0, 1 << 30, 0), (0, 1, 2, 3), 1)])
        made = image.SceneImage(320, 240, 1 << 30, 65536, 64 << 16, 0, 0, [(0, 0, 0)] * 256, [model],
                                [image.Object((0, 0, 0), 0)], image.POSES, [(0,) * 6])
        one = image.pack(made)
        blob = with_instances(one, objects)
        assert python_says(blob) == status
        assert loader_says(build, [blob], tmp_path) == [status]


def with_instances(blob, count):
    """An image with so many copies of its first instance."""
    offset, _ = section(blob, "objects")
    return replaced(blob, objects=blob[offset:offset + 16] * count)


def readers_say(build, blobs, folder):
    """Whether each image's header and sections are taken: by the loader, the reference, the ray-cast judge."""
    file = folder / "images"
    file.write_bytes(b"".join(struct.pack("<I", len(blob)) + blob for blob in blobs))
    done = subprocess.run([build / "host" / "loader", "--three", file], capture_output=True, text=True, check=True)
    return [tuple(word == "ok" for word in line.split()) for line in done.stdout.splitlines()]


def test_three_readers_refuse_the_same_of_ten_thousand_images(build, tmp_path_factory):
    """Readers that share no line: the library's, the reference's, the ray-cast judge's."""
    chance, blobs = random.Random(SEED + 2), []
    for name, layers in SCENES:
        file = tmp_path_factory.mktemp("image") / "scene.fxls"
        making.build(str(CHECKOUT / f"{name}.toml"), str(file), layers=layers)
        blob = file.read_bytes()
        blobs += [blob, *(chance.choice(section_mutants.KINDS)(blob, chance) for _ in range(10_000 // len(SCENES)))]
    said = readers_say(build, blobs, tmp_path_factory.mktemp("images"))
    assert len(said) == len(blobs) >= 10_000
    different = [(i, one) for i, one in enumerate(said) if len(set(one)) > 1]
    assert not different, f"{len(different)}: (image, (library, reference, rays)): {different[:8]}"
    taken = sum(one[0] for one in said)
    assert len(SCENES) < taken < 9_000


def test_a_section_that_no_reader_knows(build, blob, tmp_path):
    """One that is not needed is passed over and told, one that is needed is refused; the last one may have any length."""
    parts = bodies(blob)
    kind = len(fields.SECTIONS) + 1
    blobs = [joined(blob, {**parts, kind: (needed, 7, b"abcd" * 3)}) for needed in (False, True)]
    assert image.unpack(blobs[0]).unknown == [kind]
    assert [python_says(one) for one in blobs] == loader_says(build, blobs, tmp_path) == ["ok", "version"]
    assert readers_say(build, blobs, tmp_path) == [(True,) * 3, (False,) * 3]


def test_sections_that_must_be_there(build, blob, tmp_path):
    """formats 1.2at."""
    for name in ("palette", "vertices", "faces", "models", "objects"):
        without = {kind: part for kind, part in bodies(blob).items() if fields.SECTIONS[kind - 1].name != name}
        assert len(without) == len(bodies(blob)) - 1
        said = loader_says(build, [joined(blob, without)], tmp_path)
        assert said == [python_says(joined(blob, without))] and said != ["ok"], name


def test_an_older_image_is_to_be_built_again(build, blob, tmp_path):
    for version in (1, 2, 8, 10):
        old = bytearray(blob)
        struct.pack_into("<H", old, 4, version)
        old = sealed(old)
        with pytest.raises(ToolError, match=f"version {version}; this tool knows version 9: build it again"):
            image.unpack(old)
        assert loader_says(build, [old], tmp_path) == ["version"]
