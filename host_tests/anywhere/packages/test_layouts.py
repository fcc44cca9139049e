# SPDX-License-Identifier: MIT
"""The packages of Arduino, PlatformIO, ESP-IDF, Zephyr and Conan: their layout, and what of their own tools runs here."""

import json
import re
import shutil
import subprocess
import sys

import pytest

from conftest import CHECKOUT, run_cli
from fixel.base.version import version
from outside import LINKED, emulated, expected, first_program, need, run

SOURCES = {"src/fixel.h", "src/fixel.c"}
MANIFESTS = {"arduino": "library.properties", "platformio": "library.json", "esp-idf": "idf_component.yml", "zephyr": "zephyr/module.yml", "conan": "conanfile.py"}


@pytest.fixture(scope="module", name="packages")
def fixture_packages(tmp_path_factory):
    folder = tmp_path_factory.mktemp("packages")
    done = run_cli("packages", "--out", folder)
    assert done.returncode == 0, done.stderr
    assert {each.name for each in folder.iterdir()} == {*MANIFESTS, "rust"}    # the crates have a part of their own
    return folder


@pytest.fixture(scope="module", name="tool")
def fixture_tool(tmp_path_factory):
    """By a package of pip: a program of it, in a venv of its own."""
    def tool(package, program):
        venv = tmp_path_factory.mktemp("venv")
        run(sys.executable, "-m", "venv", venv)
        done = subprocess.run([venv / "bin" / "python", "-m", "pip", "install", "-q", "--disable-pip-version-check", package], text=True, capture_output=True,
                              check=False)
        if done.returncode and re.search(r"No matching distribution|ConnectionError|Temporary failure|timed out", done.stdout + done.stderr):
            pytest.skip(f"needs {package} of the Python package registry")
        assert done.returncode == 0, done.stderr
        return venv / "bin" / program
    return tool


@pytest.mark.parametrize("name", MANIFESTS)
def test_a_package_has_its_files_and_its_version(packages, name):
    files = {str(file.relative_to(packages / name)) for file in (packages / name).rglob("*") if file.is_file()}
    forwards = {f"src/fixel/{file.name}" for file in (CHECKOUT / "lib" / "include" / "fixel").glob("*.h")}
    assert files >= SOURCES | forwards | {"LICENSE", MANIFESTS[name]}
    if name != "zephyr":
        assert version() in (packages / name / MANIFESTS[name]).read_text(encoding="utf-8")


def test_arduino_layout(packages):
    lines = (packages / "arduino" / "library.properties").read_text(encoding="utf-8").splitlines()
    properties = dict(line.split("=", 1) for line in lines)
    assert set(properties) >= {"name", "version", "author", "maintainer", "sentence", "paragraph", "category", "architectures"}
    assert properties["version"] == version() and properties["includes"] == "fixel.h" and properties["category"] == "Display"
    assert not (packages / "arduino" / "utility").exists() and (packages / "arduino" / "src" / properties["includes"]).is_file()


@pytest.mark.parametrize("name, compiler, language", [("arduino", "arm-none-eabi-g++", "c++"), *((name, "arm-none-eabi-gcc", "c") for name in MANIFESTS)])
def test_src_alone_links_for_a_cortex_m0_plus_and_draws(packages, tmp_path, name, compiler, language):
    """src/ is the only folder of the include path; every source in it is compiled, in C and in C++."""
    need(compiler)
    first_program(tmp_path)
    source = packages / name / "src"
    assert sorted(file.name for file in source.rglob("*.c")) == ["fixel.c"]
    flags = ["-mcpu=cortex-m0plus", "-mthumb", "-Os", "-ffunction-sections", "-fdata-sections", "-ffreestanding", f"-I{source}"]
    own = ["-fno-exceptions", "-std=gnu++17"] if language == "c++" else ["-std=c11"]
    run(compiler, *flags, *own, "-x", language, "-c", source / "fixel.c", "-o", tmp_path / "fixel.o")
    run("arm-none-eabi-gcc", *flags, "-std=c11", "chip.c", "memory_functions.c", "fixel.o", "-nostdlib", "-lgcc", *LINKED["arm"].split(),
        "-Wl,--gc-sections", "-o", "cube.elf", folder=tmp_path)
    assert emulated("arm", tmp_path / "cube.elf") == expected()


def test_a_16_bit_int_is_refused_in_words(packages, tmp_path):
    need("avr-gcc")
    done = subprocess.run(["avr-gcc", "-mmcu=atmega2560", "-ffreestanding", "-fsyntax-only", packages / "arduino" / "src" / "fixel.c"], text=True, capture_output=True,
                          check=False)
    assert done.returncode != 0 and "needs an int of at least 32 bits" in done.stderr


def test_platformio_packs_it(packages, tool, tmp_path):
    pio = tool("platformio>=6.1,<7", "pio")
    copy = shutil.copytree(packages / "platformio", tmp_path / "fixel")
    manifest = json.loads((copy / "library.json").read_text(encoding="utf-8"))
    assert manifest.pop("license") == "MIT"     # which it looks up on the network
    (copy / "library.json").write_text(json.dumps(manifest), encoding="utf-8")
    said = run(pio, "pkg", "pack", copy, "-o", tmp_path / "fixel.tar.gz", PLATFORMIO_CORE_DIR=str(tmp_path / "core"), PLATFORMIO_SETTING_ENABLE_TELEMETRY="no")
    assert "fixel.tar.gz" in said and (tmp_path / "fixel.tar.gz").stat().st_size > 50_000


def test_esp_idf_accepts_the_manifest(packages, tool, tmp_path):
    compote = tool("idf-component-manager>=2,<4", "compote")
    copy = shutil.copytree(packages / "esp-idf", tmp_path / "fixel")
    run(compote, "manifest", "lint", "idf_component.yml", folder=copy)
    text = (copy / "idf_component.yml").read_text(encoding="utf-8")
    (copy / "idf_component.yml").write_text(text.replace(version(), "nine"), encoding="utf-8")
    done = subprocess.run([compote, "manifest", "lint", "idf_component.yml"], cwd=copy, text=True, capture_output=True, check=False)
    assert done.returncode != 0, "a wrong version passes"


def test_zephyr_module_names_what_is_there(packages):
    page = (CHECKOUT / "docs" / "packages.md").read_text(encoding="utf-8")
    assert [name for name in re.findall(r"^\| `([a-z-]+)` \| ", page, re.MULTILINE) if name in MANIFESTS] == list(MANIFESTS)
    folder = packages / "zephyr"
    named = dict(re.findall(r"^  (cmake|kconfig): (\S+)$", (folder / "zephyr" / "module.yml").read_text(encoding="utf-8"), re.MULTILINE))
    assert (folder / named["cmake"] / "CMakeLists.txt").is_file() and (folder / named["kconfig"]).is_file()
    recipe = (folder / named["cmake"] / "CMakeLists.txt").read_text(encoding="utf-8")
    for path in re.findall(r"\.\./src\S*(?=\))", recipe):
        assert (folder / named["cmake"] / path).exists()
    options = set(re.findall(r"CONFIG_(\w+)", recipe))
    assert options == set(re.findall(r"^config (\w+)$", (folder / named["kconfig"]).read_text(encoding="utf-8"), re.MULTILINE))


def test_conan_creates_it_and_its_consumer_runs(packages, tool, tmp_path):
    need("cmake", "gcc")
    conan = tool("conan>=2.0,<3", "conan")
    home = {"CONAN_HOME": str(tmp_path / "conan")}
    run(conan, "profile", "detect", **home)
    said = run(conan, "create", packages / "conan", "--no-remote", **home)
    assert f"fixel/{version()} (test package): Running test()" in said and f"fixel/{version()}" in run(conan, "list", "fixel/*", **home)
