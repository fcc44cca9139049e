# SPDX-License-Identifier: MIT
"""No value of a make variable runs as code, and each reaches its tool as it was given.

The recipes run, with a stand-in for the tools' Python that writes down what it was called with; nothing is built."""

import json
import re
import shutil
import subprocess
import sys

import pytest

from conftest import CHECKOUT, LAUNCHER, environment, run_make
from fixel.base import make, nearest

BUILT_PROGRAMS = ("boards/host/walk", "host/judge", "host/raycast")
LAUNCHED = str(LAUNCHER.relative_to(CHECKOUT))
COMMANDS = make.variables()
# make itself compares these with the names that there are, and refuses any other value.
CHECKED = {"SIZE", "BOARD", "PROGRAM", "VISIBILITY", "CLIPPER", "ROWS", "DRIVER", "PIXELS", "ORDER", "DEPTH", "COSTS_CORES", "COSTS_BOARDS", "LIB_FLAGS"}
# Read by make in the commands that are named here, and by a tool in the others.
CHECKED_IN = {"CORE": ["lib", "bench", "size"], "ONLY": ["coverage", "coverage-builds", "pictures"], "RENDERER": ["profile"]}
# For each variable the first command that has it.
TAKEN_BY = {name: next(command for command in COMMANDS if name in COMMANDS[command]) for name in make.names()}
# Commands that call none of the tools.
WITHOUT_TOOL = {"help", "lib", "all", "format", "clean", "test-campaigns"}

# Recorded: the options, and the variables that make exported.
RECORDER = """#!/usr/bin/env python3
import json, os, sys
with open({log!r}, "a") as log:
    print(json.dumps([sys.argv[1:], dict(os.environ)]), file=log)
"""


@pytest.fixture
def stand_in(tmp_path):
    """A function that runs a command of make, and returns the process and what its tools were called with."""
    log, python = tmp_path / "log.jsonl", tmp_path / "python"
    python.write_text(RECORDER.format(log=str(log)), encoding="ascii")
    python.chmod(0o755)

    def run(command, *settings, **changes):
        log.unlink(missing_ok=True)
        log.touch()
        done = run_make(command, f"PY={python}", f"BUILD={tmp_path / 'build'}", "MAKE=:", *settings, **changes)
        return done, [json.loads(line) for line in log.read_text().splitlines()]
    return run


def hostile(marker):
    """Values of which a shell or make would run a part: each would write the marker."""
    return [f"2; touch {marker}", f"x'; touch {marker}; '", f'x"; touch {marker}; "', f"$(shell touch {marker})x.toml",
            f"`touch {marker}`", f"$$(touch {marker})", f"${{shell touch {marker}}}", f"x\ntouch {marker}\n",
            f"x & touch {marker} #", f"x\\'; touch {marker}; '"]


def free(command):
    """A command's variables that may have any value."""
    return [name for name in COMMANDS[command]
            if name not in CHECKED and not {name, f"{command} {name}"} & make.FLAGS and command not in CHECKED_IN.get(name, ())]


@pytest.mark.parametrize("command", [command for command in COMMANDS if free(command)])
def test_no_value_runs_and_each_reaches_the_tool(stand_in, tmp_path, command):
    """All of a command's variables at once, each with another of the values; another command begins with another one."""
    marker = tmp_path / "marker"
    values, first = hostile(marker), list(COMMANDS).index(command)
    given = {name: values[(at + first) % len(values)] for at, name in enumerate(free(command))}
    done, called = stand_in(command, *(f"{name}={value}" for name, value in given.items()))
    assert done.returncode == 0, done.stderr
    assert not marker.exists(), given
    (words, variables), = [each for each in called if each[0][:3] == [LAUNCHED, "make", command]]
    assert not any("touch" in word for word in words)
    assert {name: variables[name] for name in given} == given
    for name, value in given.items():
        option, = make.option(command, name, value)
        assert option[option.index("=") + 1:] == value


@pytest.mark.parametrize("name", sorted(CHECKED | set(CHECKED_IN)))
def test_a_checked_variable_refuses_such_values(tmp_path, name):
    marker = tmp_path / "marker"
    for command in CHECKED_IN.get(name, [TAKEN_BY[name]]):
        for value in hostile(marker):
            done = run_make(command, f"{name}={value}")
            assert done.returncode == 2 and name in done.stderr.upper() and not marker.exists(), (value, done.stderr)
            assert done.stdout == ""


def test_the_marker_is_made_by_a_value_that_runs(tmp_path):
    """The control: with recipes that name a variable, as anybody would write them, the same values do run."""
    marker = tmp_path / "marker"
    (tmp_path / "Makefile").write_text("all:\n\t@: '$(X)' \"$(X)\"\n\t@: $(X)\n", encoding="ascii")
    for value in hostile(marker)[:4]:
        subprocess.run(["make", "-C", tmp_path, f"X={value}"], capture_output=True, check=False, env=environment())
        assert marker.exists(), value
        marker.unlink()


def test_a_value_of_the_environment_does_not_run_either(stand_in, tmp_path):
    marker = tmp_path / "marker"
    value = f"$(shell touch {marker})'; touch {marker}; '"
    done, called = stand_in("run", SCENE=value)
    assert done.returncode == 0 and called[-1][1]["SCENE"] == value and not marker.exists()


@pytest.mark.parametrize("name", ["HOSTCC", "HOSTAR", "CROSS", "CMOCK_DIR", "UNITY_DIR", "BUILD", "PY", "MAKE"])
def test_a_command_or_folder_that_is_more_than_words_is_refused(tmp_path, name):
    marker = tmp_path / "marker"
    for value in hostile(marker):
        done = run_make("-n", "predict", f"{name}={value}")
        assert done.returncode == 2 and f'{name} is "' in done.stderr and not marker.exists(), (value, done.stderr)


def test_a_folder_that_make_would_take_apart_is_refused():
    for value in ("a b", "a%b", "a:b"):
        done = run_make("help", f"BUILD={value}")
        assert done.returncode == 2 and f'BUILD is "{value}"' in done.stderr


def test_every_command_has_a_tool_or_is_known_to_have_none(stand_in):
    """So a new command cannot be forgotten above: each that has variables reads them from the environment."""
    for command in COMMANDS:
        done = run_make("-n", command, "MAKE=:") if not free(command) else None
        assert done is None or (f".venv/bin/python {LAUNCHED}" in done.stdout) == (command not in WITHOUT_TOOL), command


# --- a bad value is refused before anything is installed or built ------------------

BEFORE = CHECKOUT / "tools" / "fixel" / "base" / "before.py"
# For each variable a value that no tool takes, and what the sentence must carry beside it.
BAD = {"SCENE": ("nothere.glb", "cannot be read"), "CPU_LIMIT": ("0", "from 1 to"), "MEMORY_LIMIT": ("x", "whole number"), "SCREEN": ("axb", "128x64"),
       "FRAMES": ("x", "FRAMES"), "LOOK": ("--nothing", "--palette"), "PORT": ("x", "65535"), "OUT": ("/proc/x", "cannot be written"),
       "PICTURE": ("/proc/x.png", "cannot be written"), "KEEP": ("/proc/x", "cannot be written"), "PROBE": ("jlink", "openocd"),
       "A": ("nothere.png", "no such file"), "B": ("nothere.png", "B="), "TOLERANCE": ("256", "255"), "SAMPLES": ("-5", "SAMPLES"),
       "SEED": ("-1", "SEED"), "ONLY": ("nonexistent", "nonexistent"), "MINUTES": ("x", "whole number"), "JOBS": ("x", "from 0 to"),
       "CLUSTER": ("x", "tcp://"), "GDB_COMMANDS": ("nothere", "cannot be read"), "CORE": ("m9", "m55"), "WORKLOAD": ("w9", "w1"), "THRESHOLD": ("x", "threshold"),
       "THOUSANDS": ("0", "from 1 to"), "RUNS": ("0", "from 1 to"), "EXAMPLES": ("x", "examples"), "HARNESS": ("x", "pipeline"), "ADD": ("nothere", "harness"),
       "KILLS": ("0", "from 1 to"), "SAMPLE": ("-1", "negative"), "PART": ("x", "tools"), "DRAW": ("0", "DRAW"),
       "JSON": ("/proc/x", "cannot be written"), "STEPS": ("0", "from 1 to"), "CLOCK": ("0", "from 1 to"), "BADGE": ("/proc/x.svg", "cannot be written")}
BAD |= {flag.rpartition(" ")[2]: ("0", "must be 1") for flag in make.FLAGS if " " not in flag} | {"DEVICE": ("a/b", "ssd0303")}
BAD_OF = {("compare", "JSON"): ("0", "must be 1"), ("mutants", "COUNT"): ("0", "from 1 to"), ("costs", "FRAMES"): ("0", "from 1 to")}
# Any text is one: a word that draws breaks, a reason.
ANY = {"breaks SEED", "REASON"}
GIVEN = [(command, name) for command in COMMANDS if command not in WITHOUT_TOOL for name in COMMANDS[command]
         if name not in CHECKED and command not in CHECKED_IN.get(name, ()) and not {name, f"{command} {name}"} & ANY]
LET_THROUGH = [command for command in COMMANDS if command not in WITHOUT_TOOL | {"compare", "boot", "gdb"}]


def settings_of(command, name):
    """The variables that a bad value of one comes with."""
    if name == "TOLERANCE":
        return {"A": str(CHECKOUT / "docs/cube.png"), "B": str(CHECKOUT / "docs/cube.png"), name: BAD[name][0]}
    if (command, name) == ("compare", "B"):
        return {"A": str(CHECKOUT / "docs/cube.png"), name: ""}
    return {name: BAD_OF.get((command, name), BAD.get(name))[0]}


# Looks at each of many commands in a fork of its own: to start Python for each would take most of the time.
LOOK_AT_EACH = """
import importlib, json, os, sys
sys.path.insert(0, sys.argv[1])
from fixel import commands
from fixel.base import before
from fixel.base.errors import run_main
for command in {command for command, _, _ in json.loads(sys.argv[2])} & set(commands.COMMANDS):
    importlib.import_module(commands.COMMANDS[command])
for command, changes, said in json.loads(sys.argv[2]):
    process = os.fork()
    if process == 0:
        for stream in (1, 2):
            os.dup2(os.open(f"{said}.{stream}", os.O_WRONLY | os.O_CREAT), stream)
        os.environ.update(changes)
        sys.argv[1:] = [command]
        run_main(before.look_at_command)
    print(os.waitstatus_to_exitcode(os.waitpid(process, 0)[1]), flush=True)
"""


@pytest.fixture(name="looked", scope="module")
def fixture_looked(tmp_path_factory):
    """{(command, variable or None): (exit code, standard output, standard error)} of before.py, without a Python package: -S has none."""
    folder = tmp_path_factory.mktemp("looked")
    cases = [(command, name, settings_of(command, name)) for command, name in GIVEN] + [(command, None, {}) for command in LET_THROUGH]
    asked = [(command, changes, str(folder / str(number))) for number, (command, _, changes) in enumerate(cases)]
    done = subprocess.run([sys.executable, "-I", "-S", "-c", LOOK_AT_EACH, CHECKOUT / "tools", json.dumps(asked)], cwd=CHECKOUT, env=environment(),
                          text=True, capture_output=True, check=True)
    return {(command, name): (int(code), *((folder / f"{number}.{stream}").read_text(encoding="utf-8") for stream in (1, 2)))
            for number, ((command, name, _), code) in enumerate(zip(cases, done.stdout.split(), strict=True))}


@pytest.mark.parametrize("command, name", GIVEN)
def test_a_bad_value_of_every_variable_of_every_command_is_refused(looked, command, name):
    """One sentence, exit 2, and nothing on standard output."""
    code, out, err = looked[command, name]
    assert code == 2 and out == "" and re.fullmatch("error: .*\n", err), err
    assert BAD_OF.get((command, name), BAD.get(name))[1].lower() in err.lower()


@pytest.mark.parametrize("command", LET_THROUGH)
def test_a_command_without_a_variable_is_let_through(looked, command):
    assert looked[command, None] == (0, "", "")


@pytest.mark.parametrize("command, settings, code", [("report", {"SAMPLES": "-5"}, 2), ("report", {}, 0)])
def test_it_is_a_program_of_its_own(command, settings, code):
    """As the recipes start it."""
    done = subprocess.run([sys.executable, "-I", "-S", BEFORE, command], cwd=CHECKOUT, env=environment(**settings), text=True, capture_output=True, check=False)
    assert (done.returncode, done.stdout, done.stderr.startswith("error: ")) == (code, "", bool(settings)), done.stderr


@pytest.mark.parametrize("words", [["run", "SCENE=nothere.glb", "BOARD=pico"], ["report", "SAMPLES=-5"], ["report", "ONLY=nothing"], ["test", "ONLY=nothing"],
                                   ["flash", "PROBE=jlink"], ["boot", "BOARD=rv32"], ["docs", "OUT=/proc/x"], ["predict", "BOARD=netduino2"], ["compare"],
                                   ["run", "SCENE=README.md"], ["run", "SCENE=scenes/tiny.toml", "LOOK=--flat"], ["screen", "PICTURE=docs"],
                                   ["screen", "DEVICE=no-such"], ["lib", "SIZE=0"], ["lib", "LIB_FLAGS=x"], ["flash", "PROBE=openocd", "BOARD=mps3-an547"],
                                   ["flash", "DRIVER=st7789", "BOARD=rv32"], ["flash", "DRIVER=no-such", "BOARD=pico"],
                                   ["screen", "BOARD=host"], ["view", "BOARD=pico"], ["compare", "A=nothere.png", "B=docs/cube.png"]])
def test_make_refuses_it_before_set_up_and_builds_nothing(tmp_path, words):
    done = run_make(*words, f"BUILD={tmp_path / 'build'}")
    assert done.returncode == 2 and done.stdout == "" and not (tmp_path / "build" / "host").exists() and not (tmp_path / "build" / "boards").exists()
    assert "setup:" not in done.stderr and done.stderr.count("\n") <= 2, done.stderr
    said = [line for line in done.stderr.splitlines() if not re.fullmatch(r"make: \*\*\* \[.*\] Error 2", line)]
    assert len(said) == 1, done.stderr


@pytest.mark.parametrize("command", [command for command in COMMANDS if command not in WITHOUT_TOOL])
def test_every_command_is_looked_at_before_its_set_up(command):
    """So a new command cannot be forgotten."""
    steps = run_make("-n", command, "MAKE=:", *(["A=docs/cube.png", "B=docs/cube.png"] if command == "compare" else [])).stdout
    looked, set_up = steps.find(f"base/before.py {command} &&"), steps.find("tools/setup.sh")
    assert 0 <= looked < set_up, steps


# --- no recipe names a variable ---------------------------------------------------

def test_no_recipe_names_a_users_variable():
    """But LIB_FLAGS, which make refuses where it is more than words."""
    named = re.compile(rf"\$\(({'|'.join(sorted(make.names() - {'LIB_FLAGS'}))})[):]")
    for file in [CHECKOUT / "Makefile", *CHECKOUT.glob("tools/**/*.mk"), *CHECKOUT.glob("*/*.mk"), *CHECKOUT.glob("*/*/*.mk")]:
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
            if line.startswith("\t"):
                assert not named.search(line), f"{file}:{number}: {line}"


# --- names of files, with the real tools --------------------------------------------

# Each character that a shell or make reads in its own way is in one of them.
NAMES = ["bob's  scene", 'has#hash double"quote', "-dash per%cent", "new\nline $(shell exit)", "back\\slash; $HOME"]


@pytest.fixture
def named(tmp_path):
    """A function that makes a scene of a name."""
    def make(name):
        return shutil.copy(CHECKOUT / "scenes" / "tiny.toml", tmp_path / f"{name}.toml")
    return make


@pytest.mark.parametrize("name", NAMES)
def test_a_scene_of_any_name_is_drawn(build, tmp_path, named, name):
    out = tmp_path / f"out {name}"
    done = run_make("run", "BOARD=host", f"SCENE={named(name)}", "FRAMES=1", f"OUT={out}")
    assert done.returncode == 0, done.stderr
    assert json.loads((out / "summary.json").read_text())["frames"] == 1
    again = run_make("compare", f"A={out}", f"B={out}", f"OUT={tmp_path / 'compared'}{name}")
    assert again.returncode == 0 and (tmp_path / f"compared{name}" / "compare.json").exists(), again.stderr


@pytest.mark.parametrize("name", ["bob's  $HOME", "new\nline"])
def test_other_commands_take_such_a_name(build, tmp_path, named, name):
    scene = named(name)
    for command, *settings in (("wire", f"OUT={tmp_path / name}"), ("predict", f"JSON={tmp_path / name}.json"), ("flash",)):
        done = run_make(command, f"SCENE={scene}", "FRAMES=1", *settings)
        assert done.returncode == 0, (command, done.stderr)
    assert (tmp_path / name / "summary.json").exists() and (tmp_path / f"{name}.json").exists()
    assert (CHECKOUT / "build" / "scenes" / f"{name}.fxls").exists()
    (CHECKOUT / "build" / "scenes" / f"{name}.fxls").unlink()


# --- what is refused ----------------------------------------------------------------

@pytest.mark.parametrize("value", ["%", "host mps2-an385", "host,mps2-an385", "", "mps2-%"])
def test_a_board_is_exactly_one(value):
    done = run_make("run", f"BOARD={value}", "SCENE=scenes/tiny.toml")
    assert done.returncode == 2 and f'there is no board "{value}"; the boards are: host ' in done.stderr
    assert done.stdout == ""


# place pixel-format: the values that make takes
@pytest.mark.parametrize("setting", ["PROGRAM=%", "PROGRAM=walk game", "CLIPPER=%", "CLIPPER=view world", "VISIBILITY=%",
                                     "VISIBILITY=box spans", "PIXELS=%", "PIXELS=palette rgb565", "ORDER=%", "ORDER=distance tree", "DEPTH=%", "DEPTH=0 16", "ROWS=%", "ROWS=8 16", "DRIVER=%", "DRIVER=ssd1306 sh1106",
                                     "CORE=%", "CORE=cortex-m0 cortex-m3", "COSTS_CORES=%", "COSTS_BOARDS=%"])
def test_patterns_and_lists_are_refused(setting):
    name, value = setting.split("=")
    done = run_make(CHECKED_IN.get(name, [TAKEN_BY[name]])[0], setting)
    assert done.returncode == 2 and name in done.stderr and (f'"{value.split()[0]}' in done.stderr or setting in done.stderr)
    assert done.stdout == ""


@pytest.mark.parametrize("arguments, sentence", [
    (["predict", "SCEEN=x"], "no command has a variable SCEEN=; did you mean SCENE= or SCREEN=?"),
    (["run", "OUTPUT=x"], "no command has a variable OUTPUT="),
    (["viewer"], 'there is no command "viewer"; did you mean view?'),
    (["clean", "cleen"], 'there is no command "cleen"; did you mean clean?'),
    (["it's"], 'there is no command "it\'s" (see make help)'),
])
def test_an_unknown_name_is_answered_by_the_one_that_was_meant(arguments, sentence):
    done = run_make(*arguments)
    assert done.returncode == 2 and sentence in done.stderr
    assert done.stdout == "" and len(done.stderr.splitlines()) == 1


@pytest.mark.parametrize("name", sorted(TAKEN_BY))
def test_a_variable_of_another_command_is_refused(name):
    """Before set-up, by a sentence with the commands that have it; with one of them on the command line, it is theirs."""
    others = [command for command in COMMANDS if name not in COMMANDS[command]]
    for goals in (others[:1], others[-2:]):
        done = run_make(*goals, f"{name}={'-g' if name == 'LIB_FLAGS' else 1}")
        assert done.returncode == 2 and done.stdout == "" and len(done.stderr.splitlines()) == 1, done.stderr
        assert f"{name}=" in done.stderr and set(goals) <= set(done.stderr.split(";")[0].split())
        assert set(re.findall("[a-z-]+", done.stderr.rpartition(":")[2].removesuffix("  Stop.\n"))) == set(COMMANDS) - set(others)


def test_a_variable_belongs_to_one_of_the_commands_or_to_the_environment():
    assert run_make("-n", "clean", "equality", "JOBS=1").returncode == 0
    assert run_make("-n", "clean", JOBS="1").returncode == 0
    assert run_make("-n", "clean", "V=1").returncode == 0
    assert run_make("-n", "build/host/judge", "JOBS=1").returncode == 0     # what a command calls has its variables


def test_unknown_names_do_not_run(tmp_path):
    marker = tmp_path / "marker"
    for goal in (f"$(shell touch {marker})", f"x'; touch {marker}; '", f"x';touch${{IFS}}{marker};'"):
        assert run_make(goal).returncode == 2 and not marker.exists()


def test_make_and_the_tools_find_the_same_variables():
    """The Makefile finds them by sed, the tools by a regular expression."""
    line, = re.findall(r"^VARIABLES := (.*)$", run_make("-pn", "help").stdout, re.MULTILINE)
    assert set(line.split()) == make.names()
    assert {"SCENE", "A", "GDB_COMMANDS", "COSTS_BOARDS"} <= make.names()


# --- words ----------------------------------------------------------------------------

def test_distances():
    for one, other, steps in (("", "", 0), ("a", "", 1), ("abc", "abc", 0), ("abc", "abd", 1), ("abc", "acb", 1), ("abc", "bc", 1),
                              ("sceen", "scene", 1), ("sceen", "screen", 1), ("kitten", "sitting", 3)):
        assert nearest.distance(one, other) == nearest.distance(other, one) == steps


def test_the_nearest_words():
    assert nearest.nearest("viewer", ["view", "wire", "report"]) == ["view"]
    assert nearest.nearest("xyz", ["view", "wire"]) == []
    assert nearest.nearest("x", []) == []
