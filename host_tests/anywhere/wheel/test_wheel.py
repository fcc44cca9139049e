# SPDX-License-Identifier: MIT
"""The wheel: built once, installed into an empty venv, and used in a folder that knows no checkout and no compiler."""

import contextlib
import email
import hashlib
import json
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import urllib.request
import zipfile

import pytest

from conftest import CHECKOUT, run_cli, without_progress
from fixel.base.version import version
from fixel.check import frame_hashes
from outside import need, run
from pages import drop_each, fixture_chromium, opened, shows     # one is a fixture


def pip(python, *words):
    """pip, which asks the registry; a test is not run where that does not answer."""
    done = subprocess.run([python, "-m", "pip", "--disable-pip-version-check", "-q", *map(str, words)], stdin=subprocess.DEVNULL, text=True,
                          capture_output=True, check=False)
    if done.returncode and re.search(r"No matching distribution|ConnectionError|Temporary failure|timed out", done.stdout + done.stderr):
        pytest.skip("needs the Python package registry")
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.fixture(scope="module", name="wheel")
def fixture_wheel(tmp_path_factory):
    need("make", "gcc", "cmake")
    folder = tmp_path_factory.mktemp("wheel")
    pip(sys.executable, "wheel", "--no-deps", "-w", folder, CHECKOUT)
    (file,) = folder.glob("*.whl")
    return file


# Python of Debian 12, of Debian 13, and what lies between.
PYTHONS = ("3.11", "3.12", "3.13")


def python_of(version_of_python):
    """A Python of a version that works, as a path: of the path, or of pyenv."""
    name = f"python{version_of_python}"
    found = [shutil.which(name), *sorted(pathlib.Path.home().glob(f".pyenv/versions/{version_of_python}.*/bin/{name}"))]
    for program in filter(None, (f"/usr/bin/{name}", *found)):
        # A name on the path may be a shim of pyenv that has no such Python; Debian's may be without venv.
        if pathlib.Path(program).exists() and subprocess.run([program, "-c", "import venv, ensurepip"], capture_output=True, check=False).returncode == 0:
            return program
    return pytest.skip(f"needs python{version_of_python} with venv")


def installed(folder, python, wheel):
    """What runs a command of a new venv in a folder with scenes and a model, without a compiler on its path."""
    venv, work, programs = folder / "venv", folder / "work", folder / "bin"
    run(python, "-m", "venv", venv)
    pip(venv / "bin" / "python", "install", wheel)
    shutil.copytree(CHECKOUT / "scenes", work / "scenes")
    shutil.copy(CHECKOUT / "examples" / "cube" / "cube.obj", work)
    programs.mkdir()
    for name in ("sh", "setpriv"):      # all that the tools start
        (programs / name).symlink_to(shutil.which(name))

    def use(*command, start=subprocess.run, **how):
        environment = {"PATH": f"{venv / 'bin'}:{programs}", "HOME": str(folder), "XDG_CACHE_HOME": str(folder / "cache")}
        return start([str(venv / "bin" / command[0]), *map(str, command[1:])], cwd=work, env=environment, stdin=subprocess.DEVNULL, text=True, **how)
    use.work = work
    return use


@pytest.fixture(scope="module", name="use")
def fixture_use(tmp_path_factory, wheel):
    return installed(tmp_path_factory.mktemp("use"), sys.executable, wheel)


def said(use, *command):
    done = use(*command, capture_output=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return "".join(f"{line}\n" for line in without_progress(done.stdout + done.stderr))


def test_the_metadata_has_ranges_and_the_version(wheel):
    assert wheel.name.startswith(f"fixel-{version()}-py3-none-linux_")
    with zipfile.ZipFile(wheel) as file:
        (name,) = [name for name in file.namelist() if name.endswith("/METADATA")]
        metadata = email.message_from_string(file.read(name).decode())
        names = file.namelist()
    needed = metadata.get_all("Requires-Dist")
    assert len(needed) >= 6 and all(re.fullmatch(r"[\w.-]+<[\d.]+,>=[\d.]+", each) for each in needed), needed
    assert not [name for name in names if "__pycache__" in name or name.endswith((".o", ".a")) or ".venv" in name]
    used = {line.split("==")[0].lower() for group in ("run", "view") for line in (CHECKOUT / "requirements" / f"{group}.txt").read_text().splitlines()
            if "==" in line}
    assert {re.split("<", each)[0].lower() for each in needed} <= used, "what the checkout pins is what the wheel asks for"


@pytest.mark.parametrize("version_of_python", PYTHONS)
def test_one_wheel_draws_the_frozen_frames_on_each_python(tmp_path, wheel, version_of_python):
    """It was built once, by another Python."""
    use = installed(tmp_path, python_of(version_of_python), wheel)
    assert said(use, "python", "--version").startswith(f"Python {version_of_python}.")
    assert_draws_the_frozen_frames(use)
    said(use, "fixel", "run", "cube.obj", "--frames", 2)
    said(use, "fixel", "export", "--c", "cube.obj", "-o", "cube_scene.h")
    summary = json.loads((use.work / "build" / "run" / "summary.json").read_text(encoding="utf-8"))
    assert summary["frames"] == 2 and summary["pixels_unexplained"] == 0 and (use.work / "cube_scene.h").stat().st_size > 3000


def test_render_draws_the_frozen_frames(use):
    assert_draws_the_frozen_frames(use)


def assert_draws_the_frozen_frames(use):
    hashes = said(use, "python", "-c", """import fixel, hashlib
for frame in fixel.render("scenes/plaza.toml", indices=True):
    print(hashlib.sha256(frame.tobytes()).hexdigest())
""")
    found = [word[:frame_hashes.DIGITS] for word in re.findall(r"^[0-9a-f]{64}$", hashes, re.MULTILINE)]
    assert found == frame_hashes.load()["plaza"]["frames"]


def test_render_answers_colours_and_refuses_in_sentences(use):
    text = said(use, "python", "-c", """import fixel
colours = fixel.render("scenes/tiny.toml", frames=2, size=(64, 48))
print(colours.shape, colours.dtype, len({tuple(pixel) for pixel in colours[0].reshape(-1, 3)}) > 2)
pixels = fixel.render("scenes/tiny.toml", frames=1, pixels="rgb565", depth=16, indices=True)
print(pixels.ndim, pixels.dtype)
for scene, options in (("none.toml", {}), ("scenes/tiny.toml", {"speed": 3}), ("scenes/tiny.toml", {"frames": 0})):
    try:
        fixel.render(scene, **options)
    except fixel.Error as error:
        print("refused:", error)
print(fixel.__version__)
""")
    assert "(2, 48, 64, 3) uint8 True" in text and "3 uint16" in text and text.count("refused: ") == 3 and text.rstrip().endswith(version())


def test_run_draws_and_compares(use):
    said(use, "fixel", "run", "scenes/plaza.toml", "--frames", 3)
    summary = json.loads((use.work / "build" / "run" / "summary.json").read_text(encoding="utf-8"))
    assert summary["frames"] == 3 and summary["board"] == "host"
    assert (use.work / "build" / "run" / "frame_0002.png").exists() or len(list((use.work / "build" / "run").glob("frame_*.png"))) == 3


def test_export_writes_the_scene_of_the_checkout(use):
    said(use, "fixel", "export", "--c", "cube.obj", "-o", "cube_scene.h")
    done = run_cli("export", "--c", CHECKOUT / "examples" / "cube" / "cube.obj", "-o", use.work / "same.h", "--name", "cube")
    assert done.returncode == 0, done.stderr
    ours, same = ((use.work / name).read_text(encoding="utf-8") for name in ("cube_scene.h", "same.h"))
    assert ours == same and "cube_scene" in ours


@contextlib.contextmanager
def viewing(use, scene):
    """fixel view of a scene; yields its page's address."""
    process = use("fixel", "view", scene, start=subprocess.Popen, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    try:
        line = process.stdout.readline()
        address = re.search(r"http://127\.0\.0\.1:\d+/[\w-]+/", line)
        assert address, line + process.stderr.read()
        yield address[0]
    finally:
        process.send_signal(signal.SIGINT)
        process.communicate()


def test_view_serves_its_page(use):
    with viewing(use, "scenes/tiny.toml") as address, urllib.request.urlopen(address) as page:
        assert page.status == 200 and "<title>" in page.read().decode()


def test_view_draws_in_the_browser_what_is_dropped(use, chromium, tmp_path):
    need("clang", "wasm-ld")    # of which the wheel was built
    with viewing(use, "scenes/tiny.toml") as address, opened(chromium, f"{address}draw.html") as page:
        shows(page, "#cost", r"^[\d,]+ instructions$")
        assert page.input_value("#scene") == "tiny"
        drop_each(page, tmp_path)


def test_what_the_wheel_cannot_do_is_a_sentence(use):
    for words, told in ((["bench"], "without a checkout"), (["rum"], "did you mean run"), (["run", "none.obj"], "none.obj")):
        done = use("fixel", *words, capture_output=True, check=False)
        assert done.returncode == 2 and "Traceback" not in done.stderr
        assert without_progress(done.stderr)[0].startswith("error: ") and told in done.stderr
    assert said(use, "fixel", "--version") == f"fixel {version()}\n"
    assert "run" in said(use, "fixel", "--help")
