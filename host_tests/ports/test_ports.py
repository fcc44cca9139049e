# SPDX-License-Identifier: MIT
"""The ports to SDKs: each example compiles against declarations of the functions that it calls, and runs on doubles of them. The
order of its calls must be right, no byte may change while it is sent, and the display shows the frames as the library draws them."""

import re
import shutil
import subprocess

import numpy
import pytest

from conftest import CHECKOUT, run_cli
from fixel.base.errors import ToolError
from fixel.board import controllers, wires
from fixel.report import examples
from fixel.scene import making

BUILT_PROGRAMS = ("host/libfixel.a",)
PORTS, TESTS = CHECKOUT / "ports", CHECKOUT / "host_tests" / "ports"
FRAMES, WIDTH, HEIGHT = 3, 320, 240
CC = ["-O1", "-g", "-fsanitize=undefined", "-fno-sanitize-recover", "-Wall", "-Wextra", "-Werror"]
# The folder of an example: its sources, the controller, pins of select, data/command and reset.
EXAMPLES = {"pico_sdk": (["main.c", "fixel_pico.c"], "st7789", (17, 20, 21)),
            "stm32_hal": (["cube.c", "fixel_stm32.c"], "ili9341", (4, 3, 2)),
            "arduino/cube": (["cube.ino", "fixel_arduino.cpp"], "ili9341", (10, 9, 8)),
            "arduino/turn": (["turn.ino", "../cube/fixel_arduino.cpp"], "ili9341", (10, 9, 8)),
            "arduino/game": (["game.ino", "../cube/fixel_arduino.cpp", "../../../examples/game/game.c"], "ili9341", (10, 9, 8))}
# What draws the frames that a display must show; that of the cube draws for the others.
EXPECTED = {"arduino/turn": ["expected_turn.c"], "arduino/game": ["expected_game.c", "../../examples/game/game.c"]}
# Folders of headers that a sketch has beside it in its package (tools/fixel/package/layouts.toml).
BESIDE = {"arduino/turn": [PORTS / "arduino" / "cube"], "arduino/game": [PORTS / "arduino" / "cube", CHECKOUT / "examples" / "game"]}
# Those that hand bands to a display of the SDK's: their sources.
WINDOWS = {"esp_idf/main": ["main.c", "fixel_esp.c"], "zephyr/src": ["main.c", "fixel_zephyr.c"]}


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    """A folder with cube_scene.h, with a path of frames, with model_scene.h, which has textures, light and depth, and with game_scene.h."""
    folder = tmp_path_factory.mktemp("scene")
    making.export(str(CHECKOUT / "examples/game/game.toml"), str(folder / "game_scene.h"))
    done = run_cli("export", "--c", CHECKOUT / "examples/cube/cube.obj", "-o", folder / "cube_scene.h", "--frames", 96)
    assert done.returncode == 0, done.stderr
    examples.write_own_scene(folder)
    return folder


def built(folder, name, scene, sources, includes):
    """A program of the sources, C or C++, with the host's library."""
    objects = []
    for number, source in enumerate(sources):
        is_c = source.suffix == ".c"
        compiler = ["gcc", "-std=c11", "-Wconversion"] if is_c else ["g++", "-std=c++11", "-x", "c++"]
        objects.append(folder / f"{name}-{number}.o")
        # A sketch's functions and an exported object need no declaration of their own.
        before = ["-include", "Arduino.h"] if source.suffix == ".ino" else []
        subprocess.run([*compiler, *CC, *before, *(f"-I{each}" for each in (*includes, scene, TESTS, CHECKOUT / "lib/include")),
                        "-c", source, "-o", objects[-1]], check=True)
    program = folder / name
    subprocess.run(["g++", "-fsanitize=undefined", *objects, CHECKOUT / "build/host/libfixel.a", "-o", program], check=True)
    return program


def program_of(example, folder, scene):
    """The example with its doubles."""
    sources = WINDOWS[example] if example in WINDOWS else EXAMPLES[example][0]
    declarations = TESTS / example.split("/")[0]
    double = next(declarations.glob("double.*"))
    return built(folder, "example", scene, [*(PORTS / example / name for name in sources), double, TESTS / "diary.c"],
                    [declarations, PORTS / example, *BESIDE.get(example, ())])


def diary_of(example, folder, scene):
    """(word, argument) of each line that the example's doubles wrote."""
    done = subprocess.run([program_of(example, folder, scene)], stdout=subprocess.PIPE, text=True, timeout=60, check=False)
    faults = re.findall("^fault (.*)$", done.stdout, re.MULTILINE)
    assert not faults and done.returncode == 0, faults
    return [line.split(" ", 1) for line in done.stdout.splitlines()]


class Module:
    """A display at the wires: what the lines of a diary do to it."""

    def __init__(self, controller, pins):
        self.model, self.pins = controllers.start(controller), pins
        self.level, self.is_sending, self.resets, self.pictures, self.sent = {}, False, 0, [], 0

    def pin(self, number, level):
        assert not self.is_sending, "a pin changes while a transfer is under way"
        select, _, reset = self.pins
        assert number in self.pins
        if number == reset:
            assert self.level.get(select, True), "reset while selected"
            self.resets += self.level.get(reset) is False and level
        self.level[number] = level

    def take(self, data):
        select, is_data, reset = self.pins
        assert self.level[select] is False and self.level[reset] is True and self.resets == 1
        if self.level[is_data]:
            self.model.take_data(data)
            self.sent += len(data) if self.model.takes_pixels else 0
        else:
            assert len(data) == 1
            self.model.take_command(data)

    def play(self, diary):
        for word, rest in diary:
            if word == "pin":
                number, level = rest.split()
                self.pin(int(number), level == "1")
            elif word == "start":
                assert self.level[self.pins[0]] is False and self.level[self.pins[1]] is True
                self.is_sending = True
            elif word in ("bytes", "done"):
                assert self.is_sending == (word == "done")
                self.take(bytes.fromhex(rest))
                self.is_sending = False
                self.keep()
            elif word == "sleep":
                self.model.pause(int(rest))

    def keep(self):
        """A picture after each frame. Before the first one as many bytes of black come, while the glass is off."""
        frames, rest = divmod(self.sent, 2 * WIDTH * HEIGHT)
        if rest == 0 and frames - 1 > len(self.pictures):
            self.model.finish()
            self.pictures.append(self.model.picture(1))


def expected(folder, scene, example=""):
    """The glass after each of the first frames, in 16 bits a pixel."""
    program = built(folder, "expected", scene, [TESTS / name for name in EXPECTED.get(example, ["expected.c"])], BESIDE.get(example, ()))
    data = subprocess.run([program], stdout=subprocess.PIPE, check=True).stdout
    palette = numpy.frombuffer(data[:768], numpy.uint8).reshape(256, 3)
    if len(data) == 768 + 2 * FRAMES * HEIGHT * WIDTH:
        return list(numpy.frombuffer(data[768:], "<u2").reshape(FRAMES, HEIGHT, WIDTH))
    frames = numpy.frombuffer(data[768:], numpy.uint8).reshape(FRAMES, HEIGHT, WIDTH)
    return [wires.rgb565(palette)[frame] for frame in frames]


@pytest.mark.parametrize("example", EXAMPLES)
def test_a_display_shows_the_frames_of_the_library(example, scene, tmp_path):
    _, controller, pins = EXAMPLES[example]
    module = Module(controller, pins)
    module.play(diary_of(example, tmp_path, scene))
    wanted = expected(tmp_path, scene, example)
    assert len({frame.tobytes() for frame in wanted}) == FRAMES, "it turns"
    assert len(module.pictures) == FRAMES
    for shown, frame in zip(module.pictures, wanted):
        assert (shown == frame).all(), f"{(shown != frame).sum()} pixels differ"


@pytest.mark.parametrize("example", [name for name in (*EXAMPLES, *WINDOWS) if name != "arduino/game"])
def test_another_model_takes_its_name_alone(example, scene, tmp_path, monkeypatch):
    """model_scene.h has textures, light at corners and a depth buffer. What is compiled differs from the example in the name."""
    name = [("cube", "model"), ("CUBE", "MODEL")]
    copied(example, (WINDOWS.get(example) or EXAMPLES[example][0])[0], name, tmp_path, monkeypatch)
    source = EXPECTED.get(example, ["expected.c"])[0]
    (tmp_path / source).write_text(replaced((TESTS / source).read_text(encoding="utf-8"), name), encoding="utf-8")
    monkeypatch.setitem(EXPECTED, example, [tmp_path / source])
    assert all(len(numpy.unique(frame)) > 100 for frame in expected(tmp_path, scene, example)), "texels and smooth light"
    test = test_a_display_of_the_sdk_gets_the_frames_of_the_library if example in WINDOWS else test_a_display_shows_the_frames_of_the_library
    test(example, scene, tmp_path)


@pytest.mark.parametrize("pin", ["2", "3"])
def test_a_key_changes_the_speed_of_the_cube(pin, scene, tmp_path, monkeypatch):
    """The port and the program that draws what is expected both read which key is held."""
    without = expected(tmp_path, scene, "arduino/turn")
    monkeypatch.setenv("HELD_PIN", pin)
    assert any((one != other).any() for one, other in zip(without, expected(tmp_path, scene, "arduino/turn")))
    test_a_display_shows_the_frames_of_the_library("arduino/turn", scene, tmp_path)


def windows(diary):
    """The pictures of frames that came in windows of rows, in 16 bits a pixel with the high byte first."""
    glass, pictures, window, is_sending = numpy.zeros((HEIGHT, WIDTH), numpy.uint16), [], None, False
    for word, rest in diary:
        if word == "window":
            assert not is_sending
            window = [int(each) for each in rest.split()]
        elif word == "start":
            is_sending = True
        elif word in ("bytes", "done"):
            assert is_sending == (word == "done")
            is_sending = False
            left, top, right, bottom = window
            glass[top:bottom, left:right] = numpy.frombuffer(bytes.fromhex(rest), ">u2").reshape(bottom - top, right - left)
            if bottom == HEIGHT:
                pictures.append(glass.copy())
    return pictures


@pytest.mark.parametrize("example", WINDOWS)
def test_a_display_of_the_sdk_gets_the_frames_of_the_library(example, scene, tmp_path):
    diary = diary_of(example, tmp_path, scene)
    pictures, wanted = windows(diary), expected(tmp_path, scene, example)
    assert len(pictures) == FRAMES + 1 and all((shown == frame).all() for shown, frame in zip(pictures, wanted))
    assert any(word == "start" for word, _ in diary) == (example == "esp_idf/main")


@pytest.mark.parametrize("example, broken, found", [
    ("esp_idf/main", ("(void)xSemaphoreGiveFromISR(esp->is_done, &is_woken);", "(void)esp;"), "nobody was woken"),
    ("esp_idf/main", ("esp->is_sending = xSemaphoreTake(esp->is_done, esp->patience) != pdTRUE;", "esp->is_sending = false;"), "while another one is under way"),
    ("esp_idf/main", ("esp->patience)", "portMAX_DELAY)"), "another time than the bytes take"),
    ("zephyr/src", (" && display_blanking_off(display) == 0", ""), "the display is off")])
def test_a_broken_sink_is_found(example, broken, found, scene, tmp_path, monkeypatch):
    copied(example, WINDOWS[example][1], [broken], tmp_path, monkeypatch)
    with pytest.raises(AssertionError, match=found):
        diary_of(example, tmp_path, scene)


def replaced(text, pairs):
    for old, new in pairs:
        assert old in text
        text = text.replace(old, new)
    return text


def copied(example, name, pairs, folder, monkeypatch):
    """The ports in a copy in which texts of a source are replaced."""
    port = example.split("/")[0]
    shutil.copytree(PORTS / port, folder / "ports" / port)
    source = folder / "ports" / example / name
    source.write_text(replaced(source.read_text(encoding="utf-8"), pairs), encoding="utf-8")
    monkeypatch.setattr(f"{__name__}.PORTS", folder / "ports")


@pytest.mark.parametrize("example, seeks_dma", [("pico_sdk", True), ("stm32_hal", True), ("arduino/cube", False)])
def test_pixels_go_by_dma_where_there_is_some(example, seeks_dma, scene, tmp_path):
    starts = [int(rest) for word, rest in diary_of(example, tmp_path, scene) if word == "start"]
    assert (starts.count(2 * WIDTH * 20) >= FRAMES * HEIGHT // 20 - 1) == seeks_dma and bool(starts) == seeks_dma


@pytest.mark.parametrize("example, broken, found", [
    ("pico_sdk", ("dma_channel_is_busy(channel) || ", ""), "before the transfer's end"),
    ("pico_sdk", (" || spi_is_busy(spi0)", ""), "while bytes leave"),
    ("stm32_hal", ("HAL_SPI_GetState(&FIXEL_STM32_SPI) != HAL_SPI_STATE_READY", "0"), "while bytes leave"),
    ("arduino/cube", ("SPI.transfer(piece, count)", "SPI.transfer((void *)(uintptr_t)bytes, count)"), "")])
def test_a_broken_port_is_found(example, broken, found, scene, tmp_path, monkeypatch):
    """The test can fail: without a wait, or with the library's own buffer given away."""
    sources, controller, pins = EXAMPLES[example]
    copied(example, sources[1], [broken], tmp_path, monkeypatch)
    with pytest.raises((AssertionError, ToolError)) as error:
        module = Module(controller, pins)
        module.play(diary_of(example, tmp_path, scene))
        wanted = expected(tmp_path, scene)
        assert all((shown == frame).all() for shown, frame in zip(module.pictures, wanted)), "pixels differ"
    assert found in str(error.value)


@pytest.mark.parametrize("example, fault", [("esp_idf/main", "hang"), ("esp_idf/main", "error"), ("pico_sdk", "hang"), ("stm32_hal", "hang"),
                                            ("stm32_hal", "error"), ("zephyr/src", "error")])
def test_a_transfer_that_hangs_or_fails_ends_the_program(example, fault, scene, tmp_path):
    """docs/safety/constraints.md, T4: the pump answers FXL_E_DISPLAY, and each example returns then. Without a fault none returns."""
    program = program_of(example, tmp_path, scene)
    done = subprocess.run([program], env={"FAULT": fault}, stdout=subprocess.PIPE, text=True, timeout=60, check=False)
    assert done.returncode == 1 and "fault" not in done.stdout, done.stdout[-200:]
    pixels = sum(len(line) for line in re.findall("^(?:done|bytes) (.{33,})", done.stdout, re.MULTILINE)) // 4
    assert WIDTH * HEIGHT <= pixels < 2 * WIDTH * HEIGHT, "it ends in the frame of the fault, after the black one that opened the display"


@pytest.mark.parametrize("example", EXAMPLES)
def test_the_wiring_of_the_page_is_that_of_the_port(example):
    """Each pin of the port stands in the table of the README beside it."""
    text = (PORTS / example.split("/")[0] / "README.md").read_text(encoding="utf-8")
    select, is_data, reset = EXAMPLES[example][2]
    rows = dict(re.findall(r"^\| (CS|D/C|RESET) \| [^|\d]*(\d+)\b", text, re.MULTILINE))
    assert rows == {"CS": str(select), "D/C": str(is_data), "RESET": str(reset)}
