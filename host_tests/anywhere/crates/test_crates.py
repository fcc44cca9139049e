# SPDX-License-Identifier: MIT
"""The crates fixel-sys and fixel: built and tested by cargo outside the checkout, and their pictures those of the library."""

import hashlib
import pathlib
import re

import numpy
import pytest
from PIL import Image

from board_programs import made
from conftest import CHECKOUT, run_cli
from fixel.base.version import version
from fixel.check import frame_hashes
from outside import cargo, first_program, need, need_cargo, run

HERE = pathlib.Path(__file__).parent
CARGO = (1, 82)     # as the manifests state


@pytest.fixture(scope="module", name="crates")
def fixture_crates(tmp_path_factory):
    """The package, whose own tests have passed."""
    need_cargo(CARGO)
    folder = tmp_path_factory.mktemp("crates")
    done = run_cli("packages", "--only", "rust", "--out", folder)
    assert done.returncode == 0, done.stderr
    return folder / "rust"


@pytest.fixture(scope="module", name="tested")
def fixture_tested(crates):
    """What cargo test said of both crates."""
    return cargo("test", "--workspace", folder=crates)


def test_the_tests_of_the_crates_pass(tested, record_property):
    """Unit tests, the records' sizes and places by both compilers, and each example of the documentation."""
    counts = [int(count) for count in re.findall(r"^test result: ok\. (\d+) passed; 0 failed; 0 ignored", tested, re.MULTILINE)]
    assert sum(counts) >= 50 and "test records_are_those_of_c ... ok" in tested and "FAILED" not in tested
    record_property("figure", f"cargo test: {sum(counts)} passed")


def test_there_is_no_warning(crates, tested):
    assert "warning" not in tested
    assert "warning" not in cargo("doc", "--no-deps", "-p", "fixel", folder=crates)
    assert "warning" not in cargo("build", "--release", folder=crates), "of the C compiler, by -O3"


def test_clippy_has_nothing_to_say(crates, tested):
    need("cargo-clippy")
    assert "ok" in tested and "warning" not in cargo("clippy", "--all-targets", folder=crates)


# Flat; lit, with motions; textured with light at the corners; a tree, also with what moves among it; beams; billboards; an off-centre
# lens; smooth, with a depth buffer.
@pytest.mark.parametrize("name, size", [("plaza", 320 * 240), ("lit", 320 * 240), ("room", 160 * 120), ("knot", 160 * 120),
                                        ("knot-moving", 160 * 120), ("beam", 320 * 240), ("grove", 160 * 120), ("window", 160 * 120),
                                        ("gallery", 240 * 180)])
def test_a_setup_draws_the_frozen_frames(crates, tested, tmp_path, name, size):
    assert "ok" in tested
    done = run_cli("build", CHECKOUT / "scenes" / f"{name}.toml", "-o", tmp_path / "scene.fxls")
    assert done.returncode == 0, done.stderr
    cargo("run", "--example", "frames", "--", tmp_path / "scene.fxls", tmp_path / "frames.raw", folder=crates)
    drawn, frozen = (tmp_path / "frames.raw").read_bytes(), frame_hashes.load()[name]["frames"]
    hashes = [hashlib.sha256(drawn[at:at + size]).hexdigest()[:frame_hashes.DIGITS] for at in range(0, len(drawn), size)]
    assert hashes == frozen


def test_a_model_has_its_textures_light_and_depth(crates, tested, tmp_path):
    """examples/model in RGB565, on the display of the simulator and as the library draws it on this machine."""
    assert "ok" in tested
    made("build/host/frames")
    frames = frame_hashes.drawn_by_host(crates / "fixel" / "examples" / "model.fxls", CHECKOUT / "build", tmp_path).frames
    cargo("run", "--example", "frames", "--", crates / "fixel" / "examples" / "model.fxls", tmp_path / "frames.raw", folder=crates)
    drawn = numpy.fromfile(tmp_path / "frames.raw", "<u2").reshape(-1, 240, 320)
    assert len(drawn) == len(frames) == 24 and all((one == other.pixels).all() for one, other in zip(drawn, frames))
    assert len(numpy.unique(drawn[0])) > 100, "texels and smooth light"
    cargo("run", "--example", "model", "--", tmp_path / "model.png", folder=crates)
    assert (shown_565(tmp_path / "model.png") == drawn[-1]).all()


def shown_565(file):
    """A picture of the simulator in RGB565."""
    picture = numpy.asarray(Image.open(file).convert("RGB")).astype(int)
    return picture[..., 0] >> 3 << 11 | picture[..., 1] >> 2 << 5 | picture[..., 2] >> 3


def test_the_picture_of_the_simulator_is_the_librarys(crates, tested, tmp_path):
    """0 pixels differ outside of the text; the text is there."""
    assert "ok" in tested
    cargo("run", "--example", "turning", "--", tmp_path / "turning.png", folder=crates)
    first_program(tmp_path)
    run("gcc", "-O1", f"-I{CHECKOUT / 'lib' / 'include'}", "-I.", HERE / "turned.c", CHECKOUT / "build" / "host" / "libfixel.a", "-o", "turned", folder=tmp_path)
    (tmp_path / "turned.raw").write_bytes(b"")
    run("sh", "-c", "./turned >turned.raw", folder=tmp_path)
    pixels = numpy.frombuffer((tmp_path / "turned.raw").read_bytes(), "<u2").reshape(240, 320).astype(int)
    shown = shown_565(tmp_path / "turning.png")
    differ = shown != pixels
    text = differ[8:20, 8:38]
    assert shown.shape == (240, 320) and len(set(pixels.flat)) >= 4
    assert text.sum() > 30 and (shown[8:20, 8:38][text] == 0xFFFF).all(), "the text is white, over the picture"
    assert differ.sum() == text.sum(), "pixels differ outside of the text"


def test_every_public_function_is_declared(crates, tmp_path):
    sources = crates / "fixel-sys" / "c"
    header = "".join(file.read_text(encoding="utf-8") for file in sorted(sources.glob("fixel/*.h")))
    header = re.sub(r"/\*.*?\*/", "", header, flags=re.DOTALL)
    run("gcc", "-O1", f"-I{sources}", "-c", *sorted(sources.glob("*/*.c")), folder=tmp_path)
    symbols = re.findall(r" [TDRB] (fxl_\w+)", run("nm", *sorted(tmp_path.glob("*.o"))))
    public = {name for name in (re.sub(r"_for_polygons_of_\d+$", "", symbol) for symbol in symbols) if re.search(rf"\b{name}\b", header)}
    bindings = (crates / "fixel-sys" / "src" / "bindings.rs").read_text(encoding="utf-8")
    declared = set(re.findall(r"pub (?:fn|static) (fxl_\w+)", bindings))
    assert len(public) > 150 and declared == public


def test_the_library_is_bare_and_never_panics_by_choice(crates):
    for crate in ("fixel-sys", "fixel"):
        manifest = (crates / crate / "Cargo.toml").read_text(encoding="utf-8")
        assert f'version = "{version()}"' in manifest and "#![no_std]" in (crates / crate / "src" / "lib.rs").read_text(encoding="utf-8")
    for file in (crates / "fixel" / "src").glob("*.rs"):
        code = "\n".join(line for line in file.read_text(encoding="utf-8").splitlines() if not line.lstrip().startswith("//"))
        assert not re.search(r"\.(unwrap|expect)\(|panic!|unreachable!|todo!|\b(f32|f64)\b|\balloc::", code), file.name
