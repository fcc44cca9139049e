# SPDX-License-Identifier: MIT
"""tools/scene.py texture: an image as a texture of RGB565 that C and C++ take."""

import random

import pytest
from PIL import Image

from conftest import assert_one_sentence, run_cli
from test_export import COMPILERS, compiled, printed

BUILT_PROGRAMS = ()


# Values of the texels, and members of the record.
PRINTER = """#include <stdio.h>
#include "made.h"
int main(void)
{
    const fxl_texture *t = &wood_texture;
    printf("%u %u %u %u %u %u\\n", t->log_width, t->log_height, t->format, t->flags, t->levels, t->key_565);
    for (unsigned i = 0; i < sizeof wood_texels / sizeof wood_texels[0]; i++) {
        printf("%u ", wood_texels[i]);
    }
    printf("%d\\n", t->texels == FXL_CAST(const uint8_t *, FXL_CAST(const void *, wood_texels)) && t->colours == NULL);
    return 0;
}
"""


def noise(folder, width, height, clear=0.0):
    """An image file of random pixels, some of them more clear than not; and its rows of (red, green, blue, alpha)."""
    chance = random.Random(width * height)
    rows = [[(*(chance.randrange(256) for _ in range(3)), chance.choice((0, 127)) if chance.random() < clear else 129 if clear else 255)
             for _ in range(width)] for _ in range(height)]
    image = Image.new("RGBA", (width, height))
    image.putdata([pixel for row in rows for pixel in row])
    image.save(folder / "noise.png")
    return rows


def made(folder, *options, compiler=("gcc", "-std=c11")):
    """(members of the record, texels) as a compiled program has them."""
    done = run_cli("texture", folder / "noise.png", "-o", folder / "made.h", "--name", "wood", *options)
    assert done.returncode == 0, done.stderr
    name = "main.cpp" if "++" in compiler[0] else "main.c"
    first, second = printed(compiled(folder, PRINTER, compiler=compiler, name=name)).splitlines()
    *texels, is_whole = map(int, second.split())
    assert is_whole and f"{2 * len(texels):,} bytes of texels" in done.stdout
    return tuple(map(int, first.split())), texels


def rgb565(red, green, blue):
    return red // 8 * 2048 + green // 4 * 32 + blue // 8


@pytest.mark.parametrize("compiler", COMPILERS, ids=" ".join)
def test_any_compiler_takes_it(tmp_path, compiler):
    """rgb565 3.5g-h."""
    rows = noise(tmp_path, 16, 8)
    record, texels = made(tmp_path, compiler=compiler)
    assert record == (4, 3, 2, 0, 1, 0)
    assert texels == [rgb565(*pixel[:3]) for row in rows for pixel in row]


def test_smaller_pictures(tmp_path):
    """Each texel of one is the mean of those of the one before, down to one texel."""
    rows = noise(tmp_path, 8, 2)
    record, texels = made(tmp_path, "--levels", 9, "--clamp")
    assert record == (3, 1, 2, 1, 4, 0) and len(texels) == 16 + 4 + 2 + 1
    level = [[pixel[:3] for pixel in row] for row in rows]
    expected = []
    while True:
        expected += [rgb565(*pixel) for row in level for pixel in row]
        if len(level) * len(level[0]) == 1:
            break
        high, wide = min(2, len(level)), min(2, len(level[0]))
        level = [[tuple(int(sum(level[high * y + j][wide * x + i][k] for j in range(high) for i in range(wide)) / (high * wide) + 0.5)
                        for k in range(3)) for x in range(len(level[0]) // wide)] for y in range(len(level) // high)]
    assert texels == expected


def test_what_is_clear_has_a_colour_of_its_own(tmp_path):
    """rgb565 3.5i."""
    rows = noise(tmp_path, 32, 32, clear=0.4)
    (_, _, _, flags, _, key), texels = made(tmp_path)
    drawn = {rgb565(*pixel[:3]) for row in rows for pixel in row if pixel[3] > 127}
    assert flags == 2 and key not in drawn
    assert texels == [rgb565(*pixel[:3]) if pixel[3] > 127 else key for row in rows for pixel in row]


def test_scaled(tmp_path):
    Image.new("RGB", (100, 60), (40, 200, 90)).save(tmp_path / "noise.png")
    record, texels = made(tmp_path, "--size", "64x32")
    assert record[:2] == (6, 5) and set(texels) == {rgb565(40, 200, 90)} and len(texels) == 64 * 32


@pytest.mark.parametrize("options, words", [
    ((), ["noise.png", "100 x 60", "--size 64x64"]), (("--size", "60x64"), ["60x64", "powers of two"]),
    (("--size", "512x4"), ["512x4"]), (("--size", "4"), ["must be like 64x32"]), (("--levels", 0), ["--levels is 0"]),
    (("--levels", 10, "--size", "4x4"), ["from 1 to 9"]), (("--size", "4x4", "--name", "2x"), ["--name"])])
def test_refused(tmp_path, options, words):
    Image.new("RGB", (100, 60)).save(tmp_path / "noise.png")
    done = run_cli("texture", tmp_path / "noise.png", "-o", tmp_path / "made.h", *options)
    assert_one_sentence(done, *words)
    assert not (tmp_path / "made.h").exists()


@pytest.mark.parametrize("content", [b"", b"\x89PNG\r\n\x1a\n" + b"\0" * 40, b"not an image"])
def test_no_image(tmp_path, content):
    (tmp_path / "noise.png").write_bytes(content)
    assert_one_sentence(run_cli("texture", tmp_path / "noise.png", "-o", tmp_path / "made.h"), "noise.png", "cannot be read")
    assert_one_sentence(run_cli("texture", tmp_path / "none.png", "-o", tmp_path / "made.h"), "none.png")
