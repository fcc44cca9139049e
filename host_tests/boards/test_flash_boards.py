# SPDX-License-Identifier: MIT
"""Flash, power on, read the frames: on every board there is."""

import pytest

from board_programs import EVERY_BOARD, ROOT, built, scene_bytes, tiny_scene
from fixel.board import dump, emulator, firmware, flash_memory
from fixel.base.errors import ToolError

BOARDS = sorted([firmware.HOST, *EVERY_BOARD])
EMULATED = [board for board in BOARDS if board != firmware.HOST]
FRAMES = 2


def walk(board):
    return built(f"{board}/walk" if board == firmware.HOST else f"{board}/walk.elf")


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    return tiny_scene(tmp_path_factory.mktemp("scene"))


@pytest.fixture(scope="module")
def of_the_host(tmp_path_factory, scene):
    folder = tmp_path_factory.mktemp("host")
    flash_memory.flash(firmware.HOST, walk(firmware.HOST), scene, folder / "host.bin")
    emulator.run(firmware.HOST, folder / "host.bin", walk(firmware.HOST), folder / "host.fxld", FRAMES)
    return dump.read_dump(folder / "host.fxld")


@pytest.mark.parametrize("board", BOARDS)
def test_flash_and_boot(board, scene, of_the_host, tmp_path):
    image = tmp_path / "flash.bin"
    result = flash_memory.flash(board, walk(board), scene, image)
    program = firmware.load(walk(board))
    assert result.verified == image.stat().st_size == (program.image_size or scene.stat().st_size)
    emulator.run(board, image, walk(board), tmp_path / "board.fxld", FRAMES)
    drawn = dump.read_dump(tmp_path / "board.fxld")
    assert [frame.pixels.tobytes() for frame in drawn.frames] == \
        [frame.pixels.tobytes() for frame in of_the_host.frames]


@pytest.mark.parametrize("board", EMULATED)
def test_a_scene_larger_than_the_partition(board, scene, tmp_path):
    program = firmware.load(walk(board))
    large = tmp_path / "large.fxls"
    large.write_bytes(scene_bytes(program.scene_size + 4))
    with pytest.raises(ToolError, match="does not fit"):
        flash_memory.flash(board, walk(board), large, tmp_path / "flash.bin")
    assert not (tmp_path / "flash.bin").exists()


@pytest.mark.parametrize("board", EMULATED)
def test_the_program_of_every_other_board_is_refused(board, scene, tmp_path):
    for other in BOARDS:
        if other != board:
            with pytest.raises(ToolError, match=f"is for board {other}, not for {board}"):
                flash_memory.flash(board, walk(other), scene, tmp_path / "flash.bin")
    assert not (tmp_path / "flash.bin").exists()


@pytest.mark.parametrize("board", EMULATED)
def test_the_map_of_the_flash(board):
    program = firmware.load(walk(board))
    assert sum(program.sectors) == program.image_size
    first, last = program.offset(program.scene_base), program.offset(program.scene_base + program.scene_size - 1)
    assert first in flash_memory.sector_starts(program) and last - first == program.scene_size - 1
    assert [program.offset(program.address(offset)) for offset in (0, first, last)] == [0, first, last]
    for base, size, _ in program.banks:
        assert program.offset(base - 1) is None and program.offset(base + size) is None


@pytest.mark.parametrize("board", EMULATED)
def test_a_byte_of_the_image_that_went_bad(board, scene, tmp_path):
    """In the program the tool sees it, in the scene the board does."""
    image = tmp_path / "flash.bin"
    flash_memory.flash(board, walk(board), scene, image)
    good = image.read_bytes()
    program = firmware.load(walk(board))
    for address, words in ((program.segments[0][0] + 1000, "does not hold"),
                           (program.scene_base + 300, "the scene image was refused")):
        bad = bytearray(good)
        bad[program.offset(address)] ^= 0x10
        image.write_bytes(bad)
        with pytest.raises(ToolError, match=words):
            emulator.run(board, image, walk(board), tmp_path / "board.fxld", FRAMES)
    assert not (tmp_path / "board.fxld").exists()
