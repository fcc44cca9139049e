# SPDX-License-Identifier: MIT
"""The README is true to the letter: its program is built outside the tree, as it says, and run."""

import re
import subprocess
from pathlib import Path

import pytest

BUILT_PROGRAMS = ("lib/*/libfixel.a",)
ROOT = Path(__file__).resolve().parents[2]
README, FEATURES, EVIDENCE = ((ROOT / name).read_text(encoding="utf-8") for name in ("README.md", "docs/features.md", "docs/evidence.md"))
LINES = 150     # of what a newcomer reads in ten minutes


def program():
    return re.search(r"```c\n(.*?)```", README, re.DOTALL).group(1)


def commands():
    """What the reader types to see the first program."""
    section = README.split("## A first program", 1)[1].split("\n## ", 1)[0]
    return re.findall(r"^    (\S.*)$", section.replace(program(), ""), re.MULTILINE)


@pytest.fixture(scope="module")
def library():
    """make lib, into a folder of its own, as somebody's firmware would."""
    def build(core):
        done = subprocess.run(["make", "lib", f"CORE={core}"], cwd=ROOT, text=True,
                              capture_output=True, check=False)
        assert done.returncode == 0, done.stderr
        return ROOT / "build" / "lib" / core
    return build


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    """A folder outside the tree with the header of the scene, written as the README says."""
    folder = tmp_path_factory.mktemp("first")
    done = subprocess.run(commands()[1], shell=True, cwd=linked(folder), text=True, capture_output=True, check=False)
    assert done.returncode == 0 and (folder / "cube_scene.h").exists(), done.stderr
    return folder


def linked(folder):
    """The folders that the README's commands name, seen from another one."""
    for name in ("build", "tools", "examples"):
        (folder / name).symlink_to(ROOT / name)
    return folder


def compile_outside(compiler, library, folder, *options):
    source = folder / "cube.c"
    source.write_text(program(), encoding="utf-8")
    done = subprocess.run([*compiler, source, f"-I{library / 'include'}", library / "libfixel.a",
                           "-o", folder / "cube", *options],
                          cwd=folder, text=True, capture_output=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    return folder / "cube"


def test_it_is_short():
    assert len(README.splitlines()) <= LINES


def test_program_is_short():
    assert len(program().splitlines()) <= 15


def test_the_commands_run_as_written(library, scene):
    setup, export, make, compile_and_run = commands()
    assert setup == "tools/setup.sh tools" and export.startswith("tools/scene.py export --c ") and make == "make lib CORE=host"
    library("host")
    done = subprocess.run(compile_and_run, shell=True, cwd=scene, text=True, capture_output=True, check=False)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


@pytest.mark.parametrize("core", ["cortex-m0", "cortex-m3"])
def test_program_links_for_a_microcontroller(library, scene, core):
    compile_outside(["arm-none-eabi-gcc", f"-mcpu={core}", "-mthumb", "--specs=nosys.specs", "-Wl,-w"],
                    library(core), scene)


def test_the_pictures_words_are_the_tables_figures():
    row = re.search(r"\| a vertex on the screen \| 1/65536 pixel \| ([\d,]+) \| ([\d,]+) \|", EVIDENCE)
    words = re.search(r"float32 up to ([\d.]+) pixels, plain 16\.16 up to ([\d.]+)", EVIDENCE)
    naive, float32 = (int(text.replace(",", "")) / 65536 for text in row.groups())
    assert words.groups() == (f"{float32:.3g}", f"{naive:.3g}")


def test_the_table_of_other_renderers_has_a_word_for_each_and_our_least_code():
    """Fixel's rows of "n" are as many as it loses; the bytes are those of docs/performance.md."""
    lines = FEATURES.split("| | Fixel | TGX |", 1)[1].split("\n\n", 1)[0].splitlines()[2:]
    rows = {cells[0]: cells[1:] for cells in ([cell.strip() for cell in line.strip("| ").split("|")] for line in lines)}
    assert all(len(cells) == 5 for cells in rows.values())
    assert sum(cells[0] in ("n", "none", "p") and "y" in cells for cells in rows.values()) >= 4
    performance = (ROOT / "docs" / "performance.md").read_text(encoding="utf-8")
    row = re.search(r"^\| fixel \| flash \| -Os -DFXL_SMALL \|.*$", performance, re.MULTILINE)[0].split("|")
    least = sum(int(part.replace(",", "")) for part in row[5].split("+"))
    (said,) = [cells[0] for name, cells in rows.items() if name.startswith("least code")]
    assert said == f"{least / 1000:.1f} KB"


def test_the_changelog_says_nothing_twice():
    paragraphs = [" ".join(text.split()) for text in
                  re.split(r"^- ", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), flags=re.MULTILINE)[1:]]
    assert len(paragraphs) > 20
    starts = [text[:60] for text in paragraphs]
    assert len(set(starts)) == len(starts)


def test_a_lopsided_window_is_a_lens_for_a_renderer():
    """A renderer draws it by its lens, with any clipper; the planes of a window are for the function."""
    lens = (ROOT / "lib" / "include" / "fixel" / "camera.h").read_text(encoding="utf-8")
    assert "fxl_status fxl_lens_from_window(" in lens and "fxl_status fxl_lens_set_centre(" in lens
    advice = (ROOT / "docs" / "clipping.md").read_text(encoding="utf-8").split("## Which to choose", 1)[1]
    row = next(line for line in advice.splitlines() if "lopsided" in line)
    assert "off-centre" in row and "camera.h" in row and "`half-spaces`" not in row
    assert "lopsided" not in README.split("## What Fixel does not do", 1)[1]


def test_each_claim_is_proved_or_measured_and_names_what_shows_it():
    section = EVIDENCE.split("\n## What shows it\n", 1)[1].split("\n## ", 1)[0]
    rows = [line.strip("| ").split(" | ") for line in section.splitlines() if line.startswith("| ")][2:]
    claims = set(re.findall(r"`([a-z_0-9]+)`", (ROOT / "docs/accuracy.md").read_text(encoding="utf-8").split("## 3. ")[1].split("**3.2")[0]))
    commands = set(re.findall(r"^([a-z-]+):.*## ", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE))
    assert len(rows) > 15
    for claim, how, shown in rows:
        assert re.match(r"(proved|measured)\b", how), claim
        named = re.findall(r"`(?:make )?([a-z_0-9]+)[^`]*`", shown)
        assert named or "](" in shown, claim
        assert set(named) <= claims | commands, (claim, named)


def test_files_named_exist():
    for target in re.findall(r"\]\(([^)#]+)\)", README):
        assert (ROOT / target).exists(), target
