# SPDX-License-Identifier: MIT
"""fixel COMMAND: the tools as one program."""

import ast
import os
import re
import resource
import subprocess
import sys

import pytest
import warm_start

from conftest import CHECKOUT, LAUNCHER, TOOLS, environment
from fixel import commands

BUILT_PROGRAMS = ()
SCRIPTS = {"apt_mirror.py", "scene.py"}     # what set-up calls, and SCENE by another name


def fixel(*words, options=()):
    return subprocess.run([sys.executable, *options, str(LAUNCHER), *words], capture_output=True, text=True, check=False,
                          env=environment(), stdin=subprocess.DEVNULL)


def test_each_module_with_a_main_is_a_command():
    assert {file.name for file in TOOLS.glob("*.py")} == SCRIPTS
    found = {str(file.relative_to(TOOLS).with_suffix("")).replace("/", ".") for file in TOOLS.glob("fixel/*/*.py")
             if re.search(r"^(def main\(argv\):|main = )", file.read_text(encoding="utf-8"), re.MULTILINE)}
    assert found == set(commands.COMMANDS.values())


def test_a_command_is_found_by_its_name():
    """A reader of fixel --help finds the module."""
    for name, module in commands.COMMANDS.items():
        assert module == commands.SCENE or module.split(".")[2] == name.replace("-", "_")


def test_the_script_of_scenes_is_the_command():
    """Documents and programs know it by this name."""
    for name in ("build", "export", "texture", "info"):
        done = subprocess.run([TOOLS / "scene.py", name, "--help"], capture_output=True, text=True, check=True, env=environment())
        assert done.stdout.replace("scene.py", "fixel").split() == fixel(name, "--help").stdout.split()


def test_help_lists_each_command_once():
    text = fixel("--help").stdout
    for room, members in commands.ROOMS.items():
        assert f"\n{room}:\n" in text
        for name, (_, what) in members.items():
            line, = [line for line in text.splitlines() if line.startswith(f"  {name} ")]
            assert line.endswith(what)


@pytest.mark.parametrize("options", [(), ("-u",)], ids=["at the end", "at once"])
@pytest.mark.parametrize("words", [("--help",), ("info", "SCENE"), ("run", "--help")])
def test_a_command_whose_output_nobody_reads_ends_without_a_word(tmp_path, words, options):
    """fixel ... | head. Help of one command comes from argparse, of which some versions pass over that nobody reads it."""
    scene = tmp_path / "tiny.fxls"
    if "SCENE" in words:
        assert fixel("build", str(CHECKOUT / "scenes/tiny.toml"), "-o", str(scene)).returncode == 0
    reader, writer = os.pipe()
    os.close(reader)
    done = subprocess.run([sys.executable, *options, str(LAUNCHER), *(str(scene) if word == "SCENE" else word for word in words)],
                          stdin=subprocess.DEVNULL, stdout=writer, stderr=subprocess.PIPE, text=True, check=False,
                          env=environment(PYTHONUNBUFFERED=""))
    os.close(writer)
    assert (done.returncode, done.stderr) == (141, "")


def test_a_refusal_whose_output_nobody_reads_stays_one():
    reader, writer = os.pipe()
    os.close(reader)
    done = subprocess.run([sys.executable, str(LAUNCHER), "run", "--no-such"], stdin=subprocess.DEVNULL, stdout=writer, stderr=subprocess.PIPE,
                          text=True, check=False, env=environment())
    os.close(writer)
    assert done.returncode == 2 and "error: unrecognized arguments: --no-such" in done.stderr


def test_a_command_needs_no_output():
    done = subprocess.run(["sh", "-c", f"exec {sys.executable} {LAUNCHER} --help >&-"], capture_output=True, text=True, check=False,
                          env=environment())
    assert (done.returncode, done.stderr) == (0, "")


def test_another_pipe_that_is_broken_is_no_end_of_the_reader():
    program = "import sys; sys.path.insert(0, 'tools')\nfrom fixel.base.errors import run_main\ndef main(_): raise BrokenPipeError\nrun_main(main)"
    done = subprocess.run([sys.executable, "-c", program], cwd=CHECKOUT, capture_output=True, text=True, check=False, env=environment())
    assert done.returncode == 1 and "BrokenPipeError" in done.stderr


def test_no_command_is_a_request_for_help():
    assert fixel().stdout == fixel("--help").stdout


# Refuses what is neither Python's own nor fixel's.
WITHOUT_PACKAGES = """
import importlib.abc, sys
class Refuse(importlib.abc.MetaPathFinder):
    def find_spec(self, name, path, target=None):
        if name.split(".")[0] not in sys.stdlib_module_names and name.split(".")[0] != "fixel":
            raise ModuleNotFoundError(f"{name} is refused")
sys.meta_path.insert(0, Refuse())
sys.path.insert(0, sys.argv[1])
sys.argv[1:] = sys.argv[2:]
from fixel import launcher
launcher.main(sys.argv[1:])
"""


@pytest.mark.parametrize("name", commands.COMMANDS)
def test_help_needs_no_package(name):
    done = warm_start.cold([LAUNCHER, str(TOOLS), name, "--help"], CHECKOUT, environment(), WITHOUT_PACKAGES)
    assert done.returncode == 0 and done.stdout.startswith(f"usage: fixel {name} "), done.stderr


def test_the_control_needs_packages():
    done = warm_start.cold([LAUNCHER, str(TOOLS), "info", "x.fxls"], CHECKOUT, environment(), WITHOUT_PACKAGES)
    assert done.returncode != 0 and "numpy is refused" in done.stderr


def test_an_unknown_command_is_answered_by_the_one_that_was_meant():
    done = fixel("biuld", "x.toml")
    assert done.returncode == 2
    assert "error: fixel has no command 'biuld'; did you mean build? (see fixel --help)" in done.stderr


def test_the_exit_code_is_the_tools():
    done = fixel("info", "no such.fxls")
    assert done.returncode == 2 and "no such.fxls" in done.stderr


def test_each_package_says_its_modules_and_commands():
    told = set()
    for package in (TOOLS / "fixel").glob("*/__init__.py"):
        text = ast.get_docstring(ast.parse(package.read_text(encoding="utf-8")))
        modules = re.findall(r"`(\w+\.py)`", text)
        assert modules and all((package.parent / module).exists() for module in modules), package
        told |= set(re.findall(r"`([a-z-]+)`", text.replace("`fixel ", "`")))
    assert told >= set(commands.COMMANDS)


def test_set_up_makes_it():
    done = subprocess.run([CHECKOUT / ".venv" / "bin" / "fixel", "--help"], capture_output=True, text=True, check=True,
                          env=environment(), cwd="/")
    assert done.stdout == fixel("--help").stdout


@pytest.mark.parametrize("optimize", ["1", "2"])
def test_a_python_that_drops_docstrings_and_asserts_is_left(optimize):
    """PYTHONOPTIMIZE, and python -O: the texts of help are docstrings."""
    plain = fixel("build", "--help")
    changed = subprocess.run([sys.executable, str(LAUNCHER), "build", "--help"], capture_output=True, text=True, check=False,
                             env=environment(PYTHONOPTIMIZE=optimize))
    option = fixel("build", "--help", options=["-" + int(optimize) * "O"])
    assert plain.returncode == 0 and [(done.returncode, done.stdout, done.stderr) for done in (changed, option)] == [(0, plain.stdout, "")] * 2


@pytest.mark.parametrize("words", [["build", CHECKOUT / "scenes/tiny.toml", "--frames", "1", "-o"], ["texture", CHECKOUT / "docs/looks/mean.png", "--size", "8x8", "-o"]],
                         ids=lambda words: words[0])
def test_few_open_files_are_enough_or_one_sentence(tmp_path, words):
    """ulimit -n: from 5 on, with which Python itself can start."""
    codes = []
    for most in range(5, 16):
        done = warm_start.cold([str(LAUNCHER), *map(str, words), str(tmp_path / "out")], CHECKOUT, environment(), limits=[(resource.RLIMIT_NOFILE, most)])
        codes.append(done.returncode)
        assert "Traceback" not in done.stderr and done.returncode in (0, 2), done.stderr
        assert sum(line.startswith("error: ") for line in done.stderr.splitlines()) == bool(done.returncode), done.stderr
    assert codes[0] == 2 and codes[-1] == 0
