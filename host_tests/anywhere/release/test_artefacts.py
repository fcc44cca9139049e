# SPDX-License-Identifier: MIT
"""make release in two clones in different folders, with what builds the Python package: the same bytes, and a list that SPDX's own tool
accepts."""

import json
import re
import subprocess
import sys

import pytest

from conftest import CHECKOUT, environment
from fixel.base.version import version
from outside import need, run


def install(folder, *packages):
    """Packages of pip in a folder of their own; a test is not run where the registry does not answer."""
    done = subprocess.run([sys.executable, "-m", "pip", "--disable-pip-version-check", "-q", "install", "--target", folder, *packages],
                          stdin=subprocess.DEVNULL, text=True, capture_output=True, check=False)
    if done.returncode and re.search(r"No matching distribution|ConnectionError|Temporary failure|timed out", done.stdout + done.stderr):
        pytest.skip("needs the Python package registry")
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.fixture(scope="module", name="releases")
def fixture_releases(tmp_path_factory):
    """The folders of two releases of the last commit, each built in a clone of its own."""
    need("git", "gcc", "make", "cmake")
    folder, made = tmp_path_factory.mktemp("release"), []
    install(folder / "backend", "scikit-build-core>=0.10,<2")
    for name in ("one", "the-other"):
        clone = folder / name / "fixel"
        run("git", "clone", "--quiet", CHECKOUT, clone)
        (clone / ".venv").symlink_to(CHECKOUT / ".venv")
        (clone / ".git" / "info" / "exclude").write_text(".venv\n", encoding="utf-8")
        run(clone / ".venv" / "bin" / "python", clone / "tools" / "fixel" / "launcher.py", "release", folder=clone, PYTHONPATH=str(folder / "backend"))
        assert run("git", "status", "--porcelain", folder=clone) == "", "a release leaves the checkout clean"
        made.append(clone / "dist")
    return made


def test_the_same_commit_gives_the_same_bytes(releases):
    one, other = ({file.name: file.read_bytes() for file in folder.iterdir()} for folder in releases)
    assert set(one) == set(other)
    assert [name for name in sorted(one) if one[name] != other[name]] == []


def test_every_artefact_is_there(releases):
    names = {file.name for file in releases[0].iterdir()}
    packages = ("one-file", "arduino", "platformio", "esp-idf", "zephyr", "conan", "rust")
    (wheel,) = [name for name in names if name.endswith(".whl")]
    assert names == {f"fixel-{version()}-source.tar.gz", f"fixel-{version()}.tar.gz", f"fixel-{version()}.spdx.json", "SHA256SUMS", wheel,
                     *(f"fixel-{version()}-{name}.zip" for name in packages)}
    run("sha256sum", "--check", "--strict", "SHA256SUMS", folder=releases[0])


def test_spdx_accepts_the_list(releases, tmp_path):
    install(tmp_path / "tool", "spdx-tools>=0.8,<1")
    file, wrong = releases[0] / f"fixel-{version()}.spdx.json", tmp_path / "wrong.spdx.json"
    command = [sys.executable, "-m", "spdx_tools.spdx.clitools.pyspdxtools", "-i"]
    run(*command, file, PYTHONPATH=str(tmp_path / "tool"))
    document = json.loads(file.read_text(encoding="utf-8"))
    document["documentNamespace"] = "none"
    wrong.write_text(json.dumps(document), encoding="utf-8")
    done = subprocess.run([*command, wrong], env=environment(PYTHONPATH=str(tmp_path / "tool")), capture_output=True, text=True, check=False)
    assert done.returncode != 0, "a wrong list passes"
