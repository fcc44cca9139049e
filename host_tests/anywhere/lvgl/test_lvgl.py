# SPDX-License-Identifier: MIT
"""The widget lv_fixel in LVGL 9.5, which the crate lightvgl-sys brings and cargo builds, on a display in memory: lines of tests*.c."""

import json
import pathlib
import re
import shutil
import subprocess

import pytest

from conftest import CHECKOUT, environment, run_cli
from outside import cargo, need, need_cargo, run

HERE, PORT = pathlib.Path(__file__).parent, CHECKOUT / "ports" / "lvgl"
CARGO = (1, 85)     # the edition of lightvgl-sys
VIEW = 200 * 150    # pixels of the widget
STRICT = ["-std=gnu11", "-Wall", "-Wextra", "-Wconversion", "-Werror"]


@pytest.fixture(scope="module", name="folder")
def fixture_folder(tmp_path_factory):
    """The C files, the headers beside LVGL's settings, and the project of Rust."""
    from fixel.report import examples
    need_cargo(CARGO)
    need("gcc")
    folder = tmp_path_factory.mktemp("lvgl")
    sources, headers = folder / "sources", folder / "headers"
    shutil.copytree(HERE / "project", folder / "project")
    for place in (sources, headers):
        place.mkdir()
    done = run_cli("one-file", "--out", folder / "one")
    assert done.returncode == 0, done.stderr
    for file in (*HERE.glob("*.c"), *PORT.glob("*.c"), folder / "one" / "fixel.c"):
        shutil.copy(file, sources)
    for file in (*HERE.glob("*.h"), PORT / "lv_fixel.h", folder / "one" / "fixel.h"):
        shutil.copy(file, headers)
    examples.write_scene(headers)
    examples.write_own_scene(headers)
    (headers / "fixel").mkdir()
    for file in (CHECKOUT / "lib" / "include" / "fixel").glob("*.h"):
        (headers / "fixel" / file.name).write_text('#include "../fixel.h"\n', encoding="utf-8")
    return folder


@pytest.fixture(scope="module", name="lvgl")
def fixture_lvgl(folder):
    """The folder of LVGL's sources."""
    told = json.loads(cargo("metadata", "--format-version", "1", folder=folder / "project", CARGO_TERM_QUIET="true"))
    (package,) = [each for each in told["packages"] if each["name"] == "lightvgl-sys"]
    return pathlib.Path(package["manifest_path"]).parent / "vendor" / "lvgl"


def settings(folder):
    return {"DEP_LV_CONFIG_PATH": str(folder / "headers"), "LV_EXTRA_C_FILES": str(folder / "sources")}


def flags(folder, lvgl):
    return ["-DLV_CONF_INCLUDE_SIMPLE=1", "-DLV_LVGL_H_INCLUDE_SIMPLE=1", f"-I{folder / 'headers'}", "-isystem", lvgl]


@pytest.fixture(scope="module", name="programs")
def fixture_programs(folder):
    """The folder of the programs."""
    done = subprocess.run(["cargo", "build", "--release"], cwd=folder / "project", env=environment(CARGO_TERM_COLOR="never", **settings(folder)),
                          stdin=subprocess.DEVNULL, text=True, capture_output=True, check=False)
    if "Unable to find libclang" in done.stderr:
        pytest.skip("needs libclang")
    assert done.returncode == 0, done.stderr
    target = json.loads(cargo("metadata", "--format-version", "1", "--no-deps", folder=folder / "project", CARGO_TERM_QUIET="true"))["target_directory"]
    return pathlib.Path(target) / "release"


@pytest.fixture(scope="module", name="said")
def fixture_said(programs):
    text = run(programs / "all")
    print(text)
    return text


def figures(text, pattern):
    """The numbers of the one line that a pattern matches wholly."""
    (found,) = [match for match in (re.fullmatch(pattern, line) for line in text.splitlines()) if match]
    return [int(number) for number in found.groups()]


def test_port_and_tests_compile_without_a_warning(folder, lvgl):
    for file in (folder / "sources").glob("*.c"):
        if file.name != "fixel.c":
            run("gcc", *STRICT, "-fsyntax-only", *flags(folder, lvgl), file)


def test_the_program_of_the_page_compiles(folder, lvgl, tmp_path):
    page = (CHECKOUT / "docs" / "lvgl.md").read_text(encoding="utf-8")
    programs = re.findall(r"^```c\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    assert len(programs) >= 1 and "lv_fixel_create" in programs[0]
    (tmp_path / "program.c").write_text("\n".join(programs), encoding="utf-8")
    run("gcc", *STRICT, "-fsyntax-only", *flags(folder, lvgl), tmp_path / "program.c")


def test_a_dashboard_is_the_librarys_frame(said, record_property):
    """(a) 60 frames, each begun once."""
    frames, begun, tasks, pictures, differ, refused = figures(
        said, r"a: (\d+) frames, (\d+) begun, (\d+) tasks, (\d+) different pictures, (\d+) pixels differ, (\d+) refused")
    assert frames == begun == pictures == 60 and tasks > 2 * frames and differ == refused == 0
    record_property("figure", f"(a) 60 frames, {tasks} bands, {differ} pixels differ")


def test_a_label_alone_stores_no_more_than_its_rectangle(said, record_property):
    """(b) LVGL draws a label's letters as far as a quarter of a line beyond it; a panel of the label's size cuts that off."""
    line = r": (\d+) pixels stored by (\d+) task, invalid (\d+), rectangle (\d+), (\d+) changed, (\d+) outside, (\d+) differ, canaries intact"
    stored, tasks, invalid, rectangle, changed, outside, differ = figures(said, "b" + line)
    assert 0 < stored <= invalid and tasks == 1 and changed > 0 and outside == differ == 0 and stored < VIEW / 10
    in_panel, tasks, _, rectangle, changed, outside, differ = figures(said, "b in a panel" + line)
    assert 0 < in_panel <= rectangle and tasks == 1 and changed > 0 and outside == differ == 0
    record_property("figure", f"(b) {in_panel} pixels stored, rectangle {rectangle}; with LVGL's margin {stored}; canaries intact")


def test_a_frame_stores_each_pixel_once(said, record_property):
    """(c)"""
    assert figures(said, r"c: (\d+) to (\d+) pixels stored of (\d+)") == [VIEW, VIEW, VIEW]
    record_property("figure", f"(c) {VIEW} pixels stored of {VIEW}")


def test_what_it_cannot_draw_is_refused_and_counted(said, record_property):
    """(d) A plain rectangle of half of the background's colour; and a layer that LVGL blends as a whole is drawn."""
    found = re.search(r"d: opacity of 50 %: (\d+) stored, (\d+) refused, (\d+) of (\d+) pixels are a plain rectangle of (\w{4}) over (\w{4}): (.+)", said)
    stored, refused, plain, all_of_them = (int(number) for number in found.groups()[:4])
    assert stored == 0 and refused >= 1 and plain == all_of_them and "opacity" in found[7]
    for shift, mask in ((11, 31), (5, 63), (0, 31)):
        assert abs((int(found[5], 16) >> shift & mask) * 2 - (int(found[6], 16) >> shift & mask)) <= 2
    assert "d: rotation: 0 stored, refused yes: the layer is neither RGB565 nor L8" in said
    assert "d: recoloured: 0 stored, refused yes: a widget that is recoloured is not drawn" in said
    assert "d: a layer with alpha: 0 stored, refused yes: the layer is neither RGB565 nor L8" in said
    assert figures(said, r"d: a whole layer at 50 %: (\d+) stored, (\d+) refused, (\d+) pixels are not half of the frame's colour") == [VIEW, 0, 0]
    record_property("figure", f"(d) opacity of 50 %: {refused} refused, {plain} of {all_of_them} pixels a plain rectangle")


def test_the_clip_area_is_obeyed_on_all_sides(said):
    found = [[int(number) for number in each] for each in re.findall(r"^clip: (\d+) pixels differ, (\d+) stored of (\d+)$", said, re.MULTILINE)]
    assert len(found) == 6 and all(differ == 0 and stored == own for differ, stored, own in found)
    assert "broken" not in said and said.count("canaries intact") == 4


@pytest.mark.parametrize("name", ["RGB565", "RGB565 lit", "RGB565_SWAPPED", "RGB565_SWAPPED lit", "L8"])
def test_formats(said, name):
    assert figures(said, name + r": (\d+) pixels differ, (\d+) stored, (\d+) refused") == [0, 5 * VIEW, 0]


def test_other_formats_and_wrong_renderers_are_refused(said):
    assert "RGB565 in L8: 0 stored, refused yes, a layer of L8 needs" in said
    assert "no ramp: 24, no palette: 24, no renderer: 5" in said, "FXL_E_COMBINATION and FXL_E_ORDER"


def test_pointer_pose_and_snapshot(said):
    wrong, on_model, early, beside = figures(said, r"pick: (\d+) wrong, (\d+) on the model, early (\d+), beside (\d+)")
    assert wrong == 0 and on_model > 20 and (early, beside) == (5, 2)
    assert "click: 2 clicks, instance 0, then none" in said
    differ, frames = figures(said, r"anim: (\d+) pixels differ, yaw 10000000, (\d+) frames for 20 refreshes")
    assert differ == 0 and 8 <= frames <= 11, "a frame for each pose, and none where nothing has changed"
    assert f"flight: 0 0, half yaw 0 x {-3 * 65536 // 2}" in said
    assert "snapshot: 0 pixels differ, 1 begun, none afterwards" in said and "deleted: no frame yes" in said


def test_an_exported_model_is_shown_with_all_that_it_has(said):
    """Textures, light at corners and a depth buffer of the display's rows, in the bands of LVGL."""
    assert figures(said, r"setup: 0 0 0, (\d+) pixels differ, (\d+) frames, (\d+) refused") == [0, 4, 0]


def test_a_widget_follows_the_display_that_it_is_moved_to(said):
    """A frame is begun once a refresh there, and nothing of the widget stays with the display that it has left."""
    assert figures(said, r"another display: (\d+) pixels differ, (\d+) frames of 5, callbacks (\d+) and (\d+)") == [0, 5, 0, 2]
    assert "deleted: callbacks 0, no frame yes" in said


def test_sizes_beside_lvgl_alone(folder, lvgl, programs, record_property):
    """Text, data and RAM of a dashboard with the widget, and with a plain one in its place."""
    found = {}
    for name in ("with", "without"):
        text, data, bss = (int(number) for number in run("size", programs / name).splitlines()[1].split()[:3])
        heap = figures(run(programs / name), r"heap: (\d+) bytes for the widget, screen \d+")[0]
        found[name] = {"text": text, "data": data, "bss": bss, "heap": heap}
        record_property("figure", f"{name:8} text {text:,} data {data:,} bss {bss:,} heap of the widget {heap}")
    more = {what: found["with"][what] - found["without"][what] for what in found["with"]}
    record_property("figure", "more     " + " ".join(f"{what} {value:,}" for what, value in more.items()))
    assert 10_000 < more["text"] < 80_000 and 0 < more["bss"] < 40_000 and 0 < more["heap"] < 400
    need("arm-none-eabi-gcc")
    run("arm-none-eabi-gcc", "-mcpu=cortex-m4", "-mthumb", "-Os", *flags(folder, lvgl), "-c", folder / "sources" / "lv_fixel.c", "-o", folder / "lv_fixel.o")
    text, data, bss = (int(number) for number in run("arm-none-eabi-size", folder / "lv_fixel.o").splitlines()[1].split()[:3])
    record_property("figure", f"lv_fixel.c on a Cortex-M4 by -Os: text {text:,} data {data} bss {bss}")
    assert text < 4_000 and data == bss == 0
