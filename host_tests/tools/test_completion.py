# SPDX-License-Identifier: MIT
"""fixel completion: what a real bash completes by it, and that zsh takes its script."""

import shutil
import subprocess

import pytest
from conftest import CHECKOUT, environment, run_cli
from fixel.commands import COMMANDS

BUILT_PROGRAMS = ()


# What bash does at a Tab: it calls the function that `complete` names, and reads COMPREPLY.
COMPLETE = """
source "$1"; shift
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); COMP_LINE="$*"; COMP_POINT=${#COMP_LINE}
"$(complete -p fixel | sed 's/.* -F \\([^ ]*\\) fixel$/\\1/')"
printf '%s\\n' "${COMPREPLY[@]}"
"""


@pytest.fixture(scope="module", name="script")
def fixture_script(tmp_path_factory):
    """A function that writes the script of a shell."""
    def write(shell):
        done = run_cli("completion", shell)
        assert done.returncode == 0 and done.stderr == "", done.stderr
        file = tmp_path_factory.mktemp("completion") / shell
        file.write_text(done.stdout, encoding="utf-8")
        return file
    return write


@pytest.fixture(scope="module", name="completed")
def fixture_completed(script):
    """A function: what bash completes the last of these words to."""
    file = script("bash")

    def complete(*words, folder=CHECKOUT):
        done = subprocess.run(["bash", "--norc", "-c", COMPLETE, "bash", file, *words], cwd=folder, capture_output=True, text=True,
                              check=True, env=environment())
        return done.stdout.splitlines()
    return complete


def test_bash_completes_a_command(completed):
    assert completed("fixel", "ru") == ["run", "rules"]
    assert set(COMMANDS) <= set(completed("fixel", ""))


@pytest.mark.parametrize("command, options", [
    ("run", {"--board", "--scene", "--fresh", "--memory-limit"}), ("info", {"--json"}), ("report", {"--samples", "--only"}),
    ("view", {"--port", "--open"}), ("pictures", {"--run", "--dumps"})])
def test_bash_completes_the_options_of_a_command(completed, command, options):
    found = completed("fixel", command, "--")
    assert options <= set(found) and "--characters" not in found


def test_bash_completes_what_has_few_values(completed):
    assert completed("fixel", "completion", "") == ["bash", "zsh"]


@pytest.mark.parametrize("words", [["run", "--scene"], ["build"], ["info"], ["flash", "--scene"], ["compare", "--a"]])
def test_bash_completes_files(completed, tmp_path, words):
    (tmp_path / "my scene.toml").write_bytes(b"")
    assert completed("fixel", *words, "my", folder=tmp_path) == ["my scene.toml"]


@pytest.mark.skipif(shutil.which("zsh") is None, reason="zsh is not installed")
def test_zsh_takes_its_script(script):
    done = subprocess.run(["zsh", "-n", script("zsh")], capture_output=True, text=True, check=False)
    assert done.returncode == 0 and done.stderr == ""


def test_the_script_for_zsh_has_each_command(script):
    text = script("zsh").read_text(encoding="utf-8")
    assert text.startswith("#compdef fixel\n") and all(f'"{command}:' in text or f"\n{command})" in text.replace(" ", "") for command in COMMANDS)


def test_a_shell_that_is_not_known_is_refused():
    done = run_cli("completion", "fish")
    assert done.returncode == 2 and "invalid choice: 'fish'" in done.stderr


def test_without_its_package_it_says_what_to_install(tmp_path):
    (tmp_path / "shtab.py").write_text("raise ModuleNotFoundError('no shtab', name='shtab')\n")
    done = run_cli("completion", "bash", PYTHONPATH=str(tmp_path))
    assert done.returncode == 2 and done.stderr == \
        "error: the package shtab is missing, which makes completions: run 'tools/setup.sh completion'\n"
