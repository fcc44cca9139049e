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

LIB = CHECKOUT / "lib"
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
    """By packages of pip: a program of theirs, in a venv of its own."""
    made = {}

    def tool(program, *asked):
        if asked in made:
            return made[asked] / "bin" / program
        venv = tmp_path_factory.mktemp("venv")
        run(sys.executable, "-m", "venv", venv)
        done = subprocess.run([venv / "bin" / "python", "-m", "pip", "install", "-q", "--disable-pip-version-check", *asked], text=True, capture_output=True,
                              check=False)
        if done.returncode and re.search(r"No matching distribution|ConnectionError|Temporary failure|timed out", done.stdout + done.stderr):
            pytest.skip(f"needs {' '.join(asked)} of the Python package registry")
        assert done.returncode == 0, done.stderr
        made[asked] = venv
        return venv / "bin" / program
    return tool


def sources_of_the_library():
    """{path in src/: file of lib/}: every source and header but the study's."""
    rooms = {file.relative_to(LIB): file for file in LIB.glob("*/*.[chS]") if file.parent.name not in ("study", "include")}
    return {path.as_posix(): file for path, file in {**rooms, **{file.relative_to(LIB / "include"): file for file in (LIB / "include").rglob("*.h")}}.items()}


@pytest.mark.parametrize("name", MANIFESTS)
def test_a_package_has_the_tree_of_the_library_and_its_version(packages, name):
    files = {str(file.relative_to(packages / name)) for file in (packages / name).rglob("*") if file.is_file()}
    library = sources_of_the_library()
    assert {path.removeprefix("src/") for path in files if path.startswith("src/")} == set(library)
    assert files >= {"LICENSE", MANIFESTS[name]} and len(library) > 250
    changed = {path for path, file in library.items() if (packages / name / "src" / path).read_bytes() != file.read_bytes()}
    assert changed == {"fixel/config.h", "math/family.h"}    # the switch for compact code; where assembly finds it
    if name != "zephyr":
        assert version() in (packages / name / MANIFESTS[name]).read_text(encoding="utf-8")


def test_arduino_layout(packages):
    lines = (packages / "arduino" / "library.properties").read_text(encoding="utf-8").splitlines()
    properties = dict(line.split("=", 1) for line in lines)
    assert set(properties) >= {"name", "version", "author", "maintainer", "sentence", "paragraph", "category", "architectures"}
    assert properties["version"] == version() and properties["includes"] == "fixel.h" and properties["category"] == "Display"
    assert not (packages / "arduino" / "utility").exists() and (packages / "arduino" / "src" / properties["includes"]).is_file()


def compiled(source, folder, flags, kernels=(), compiler="arm-none-eabi-gcc"):
    """The objects of a package's sources in a folder: of C by these flags and src/ as the only folder to include from, and where
    flags for kernels are given, of assembly by those alone."""
    folder.mkdir()
    run(compiler, *flags, f"-I{source}", "-c", *sorted(source.glob("*/*.c")), folder=folder)
    if kernels:
        run(compiler, *kernels, "-c", *sorted(source.glob("*/*.S")), folder=folder)
    return sorted(folder.glob("*.o"))


@pytest.mark.parametrize("core", ["cortex-m0plus", "cortex-m3", "cortex-m4"])
def test_src_alone_links_and_draws(packages, tmp_path, core):
    """As Arduino compiles it: C by -Os, assembly without an -O and without a folder to include from. The src/ of all packages is one."""
    need("arm-none-eabi-gcc")
    first_program(tmp_path)
    machine, source = [f"-mcpu={core}", "-mthumb"], packages / "arduino" / "src"
    sections = ["-ffunction-sections", "-fdata-sections", "-ffreestanding"]
    objects = compiled(source, tmp_path / "objects", [*machine, "-Os", "-std=gnu11", *sections], [*machine, "-g"])
    run("arm-none-eabi-gcc", *machine, "-Os", *sections, "-std=c11", f"-I{source}", "chip.c", "memory_functions.c", *objects, "-nostdlib", "-lgcc",
        *LINKED["arm"].split(), "-Wl,--gc-sections", "-o", "cube.elf", folder=tmp_path)
    assert emulated("arm-m4" if core == "cortex-m4" else "arm", tmp_path / "cube.elf") == expected()
    linked = run("arm-none-eabi-nm", tmp_path / "cube.elf")
    assert ("fxl_draw_outline_by_chains" in linked or "fxl_clip_by_view" in linked) and objects


def test_c_and_assembly_are_compact_alike_or_not(packages, tmp_path):
    """Of each kernel there is one text, whatever -O the build gives to C."""
    need("arm-none-eabi-gcc")
    machine, source = ["-mcpu=cortex-m3", "-mthumb"], packages / "arduino" / "src"
    by_way = {}
    for way, flags in {"O2": ["-O2"], "Os": ["-Os"], "compact": ["-Os", "-DFXL_COMPACT=1"]}.items():
        objects = compiled(source, tmp_path / way, [*machine, *flags], [*machine, *flags[1:]])
        names = [line.split()[-1] for line in run("arm-none-eabi-nm", "-g", "--defined-only", *objects).splitlines() if len(line.split()) == 3]
        assert len(names) == len(set(names)) > 200, way
        by_way[way] = {file.name: file.stat().st_size for file in objects}
    kernels = [name for name in by_way["O2"] if name.endswith("_armv7m.o")]
    assert kernels and all(by_way["Os"][name] == by_way["O2"][name] for name in kernels)
    assert any(by_way["compact"][name] < by_way["O2"][name] for name in kernels)


def test_a_16_bit_int_is_refused_in_words(packages):
    need("avr-gcc")
    source = packages / "arduino" / "src"
    done = subprocess.run(["avr-gcc", "-mmcu=atmega2560", "-ffreestanding", "-fsyntax-only", f"-I{source}", source / "draw" / "render.c"], text=True,
                          capture_output=True, check=False)
    assert done.returncode != 0 and "needs an int of at least 32 bits" in done.stderr


# What a sketch has beside its own file, its port and its scene: files and the scene's name.
SKETCHES = {"cube": (set(), "cube"), "turn": (set(), "cube"), "game": ({"game.c", "game.h"}, "game")}


@pytest.mark.parametrize("name", SKETCHES)
def test_a_sketch_is_whole(packages, name):
    """With what it includes. host_tests/ports/test_ports.py draws with it."""
    files = {file.name for file in (packages / "arduino" / "examples" / name).iterdir()}
    more, scene = SKETCHES[name]
    assert files == {f"{name}.ino", f"{scene}_scene.h", "fixel_arduino.cpp", "fixel_arduino.h"} | more


@pytest.mark.parametrize("name", SKETCHES)
def test_arduino_finds_library_and_headers_for_an_avr_and_stops_at_the_int(packages, tmp_path, name):
    need("arduino-builder", "avr-gcc")
    libraries, hardware, builder = tmp_path / "libraries", "/usr/share/arduino/hardware", "/usr/share/arduino-builder"
    shutil.copytree(packages / "arduino", libraries / "Fixel")
    (tmp_path / "build").mkdir()
    done = subprocess.run(["arduino-builder", "-compile", "-hardware", hardware, "-hardware", builder, "-tools", builder,
                           "-fqbn=arduino:avr:mega:cpu=atmega2560", "-libraries", libraries, "-build-path", tmp_path / "build", "-verbose",
                           libraries / "Fixel" / "examples" / name / f"{name}.ino"], text=True, capture_output=True, check=False)
    said = done.stdout + done.stderr
    assert done.returncode != 0 and "needs an int of at least 32 bits" in said and "No such file" not in done.stderr, said
    assert f"-I{libraries / 'Fixel' / 'src'}" in said and "not declared" not in said, said


@pytest.mark.parametrize("name", SKETCHES)
def test_a_sketch_compiles_for_a_cortex_m0_plus_with_src_alone(packages, tmp_path, name):
    """Against declarations of Arduino's own functions; the whole library is compiled as C++ above."""
    need("arm-none-eabi-g++")
    flags = ["-mcpu=cortex-m0plus", "-mthumb", "-Os", "-Wall", "-Werror", f"-I{packages / 'arduino' / 'src'}", f"-I{CHECKOUT / 'host_tests' / 'ports' / 'arduino'}"]
    for source in (packages / "arduino" / "examples" / name).glob("*.[cip]*"):
        how = ["arm-none-eabi-gcc", "-std=gnu11"] if source.suffix == ".c" else ["arm-none-eabi-g++", "-std=gnu++11", "-x", "c++", "-include", "Arduino.h"]
        run(how[0], *flags, *how[1:], "-c", source, "-o", tmp_path / f"{source.name}.o")


PLATFORMIO = ("platformio>=6.1,<7", "scons>=4.8,<5")
# A platform that compiles for this machine: the one of PlatformIO's registry is a download that this test does without.
PLATFORM = {
    "platform.json": '{"name": "native", "title": "Native", "version": "1.0.0", "license": "MIT", "description": "this machine", '
                     '"frameworks": {}, "packages": {}}',
    "platform.py": "from platformio.public import PlatformBase\n\n\nclass NativePlatform(PlatformBase):\n    pass\n",
    "builder/main.py": "from SCons.Script import Default, DefaultEnvironment\n\nDefault([DefaultEnvironment().BuildProgram()])\n"}
SCONS = "import sys\nfrom SCons.Script.Main import main\nsys.exit(main())\n"


def platformio_home(folder):
    """The environment of a pio that keeps its things in a folder and sends no reports."""
    return {"PLATFORMIO_CORE_DIR": str(folder / "core"), "PLATFORMIO_SETTING_ENABLE_TELEMETRY": "no"}


def test_platformio_builds_the_first_program(packages, tool, tmp_path):
    """It takes the library by library.json, and draws the picture of the README. SCons is pip's, in the place of PlatformIO's own package."""
    need("gcc")
    pio = tool("pio", *PLATFORMIO)
    asked = run(pio.parent / "python", "-c", "from platformio import dependencies as d; print(d.get_core_dependencies()['tool-scons'].lstrip('~^>='))").strip()
    builder = tmp_path / "core" / "packages" / "tool-scons"
    for file, text in {"scons.py": SCONS, "package.json": json.dumps({"name": "tool-scons", "version": asked}),
                       ".piopm": json.dumps({"type": "tool", "name": "tool-scons", "version": asked,
                                             "spec": {"owner": "platformio", "id": None, "name": "tool-scons", "requirements": None, "uri": None}})}.items():
        builder.mkdir(parents=True, exist_ok=True)
        (builder / file).write_text(text, encoding="utf-8")
    project = tmp_path / "project"
    for file, text in PLATFORM.items():
        (project / "platform" / file).parent.mkdir(parents=True, exist_ok=True)
        (project / "platform" / file).write_text(text, encoding="utf-8")
    first_program(project / "src")
    (project / "platformio.ini").write_text(f"[env:native]\nplatform = symlink://{project}/platform\nlib_deps = symlink://{packages}/platformio\n"
                                            "build_flags = -std=c11 -O1\nbuild_src_filter = +<host.c>\n", encoding="utf-8")
    run(pio, "run", "-d", project, **platformio_home(tmp_path))
    assert run(project / ".pio" / "build" / "native" / "program") == expected()


def test_platformio_packs_it(packages, tool, tmp_path):
    pio = tool("pio", *PLATFORMIO)
    copy = shutil.copytree(packages / "platformio", tmp_path / "fixel")
    manifest = json.loads((copy / "library.json").read_text(encoding="utf-8"))
    assert manifest.pop("license") == "MIT"     # which it looks up on the network
    (copy / "library.json").write_text(json.dumps(manifest), encoding="utf-8")
    said = run(pio, "pkg", "pack", copy, "-o", tmp_path / "fixel.tar.gz", **platformio_home(tmp_path))
    assert "fixel.tar.gz" in said and (tmp_path / "fixel.tar.gz").stat().st_size > 50_000


def test_esp_idf_accepts_the_manifest(packages, tool, tmp_path):
    compote = tool("compote", "idf-component-manager>=2,<4")
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
    for path in re.findall(r"\.\./src[^\s)]*(?=\))", recipe):
        assert list((folder / named["cmake"]).glob(path)), path
    options = set(re.findall(r"CONFIG_(\w+)", recipe)) - {"ARM"}    # Zephyr's own
    assert options == set(re.findall(r"^config (\w+)$", (folder / named["kconfig"]).read_text(encoding="utf-8"), re.MULTILINE))


def test_conan_has_the_kernels_of_the_core_that_the_flags_of_c_choose(packages, tmp_path):
    """Whatever the tool chain calls the processor, and where it gives flags to C alone, as Conan's cflags do."""
    need("cmake", "make", "arm-none-eabi-gcc")
    run("cmake", "-S", packages / "conan", "-B", tmp_path, "-G", "Unix Makefiles", "-DCMAKE_SYSTEM_NAME=Generic", "-DCMAKE_SYSTEM_PROCESSOR=thumbv7m",
        "-DCMAKE_C_COMPILER=arm-none-eabi-gcc", "-DCMAKE_C_FLAGS=-mcpu=cortex-m3 -mthumb", "-DCMAKE_BUILD_TYPE=Release",
        "-DCMAKE_TRY_COMPILE_TARGET_TYPE=STATIC_LIBRARY")
    run("make", "-C", tmp_path, "src/clip/clip_by_view_armv7m.obj")
    kernel, = tmp_path.rglob("clip_by_view_armv7m*.obj")
    assert " T fxl_clip_by_view" in run("arm-none-eabi-nm", kernel)


def test_conan_creates_it_and_its_consumer_runs(packages, tool, tmp_path):
    need("cmake", "gcc")
    conan = tool("conan", "conan>=2.0,<3")
    home = {"CONAN_HOME": str(tmp_path / "conan")}
    run(conan, "profile", "detect", **home)
    said = run(conan, "create", packages / "conan", "--no-remote", **home)
    assert f"fixel/{version()} (test package): Running test()" in said and f"fixel/{version()}" in run(conan, "list", "fixel/*", **home)
