# SPDX-License-Identifier: MIT
"""Set-up: what it says and does where something is missing, without installing anything."""

import itertools
import os
import pathlib
import re
import shutil
import stat
import subprocess
import sys

import pytest
from conftest import CHECKOUT, dry_run, environment

import apt_mirror

BUILT_PROGRAMS = ()
SOURCES = """\
# A comment
Types: deb
# http://snapshot.invalid/within a stanza
URIs: http://mirror.invalid/debian
Suites: bookworm bookworm-updates
Components: main contrib
Signed-By: /usr/share/keyrings/some-keyring.gpg

Types: deb
URIs: http://mirror.invalid/debian-security
Suites: bookworm-security
Components: main
"""


def apt_dir(folder, **files):
    (folder / "sources.list.d").mkdir(parents=True, exist_ok=True)
    for name, text in files.items():
        name = name.replace("__", ".")
        place = folder if name == "sources.list" else folder / "sources.list.d"
        (place / name).write_text(text)
    return folder


def source(folder):
    text = apt_mirror.source_for("bookworm", "trixie", folder)
    return text and dict(line.split(": ", 1) for line in text.splitlines() if not line.startswith(("#", " ")))


# --- the mirror ---------------------------------------------------------------

def test_deb822(tmp_path):
    assert source(apt_dir(tmp_path, debian__sources=SOURCES)) == {
        "Types": "deb", "URIs": "http://mirror.invalid/debian", "Suites": "trixie",
        "Components": "main", "Signed-By": "/usr/share/keyrings/some-keyring.gpg"}


def test_one_line_with_options(tmp_path):
    text = "deb [arch=amd64 signed-by=/etc/apt/keyrings/a.gpg] https://mirror.invalid/d bookworm main non-free # x\n"
    assert source(apt_dir(tmp_path, sources__list=text)) == {
        "Types": "deb", "URIs": "https://mirror.invalid/d", "Suites": "trixie", "Components": "main",
        "Signed-By": "/etc/apt/keyrings/a.gpg"}


def test_discs_sources_other_suites_and_comments_are_passed_over(tmp_path):
    text = ("deb cdrom:[Debian GNU/Linux 12.5.0 _Bookworm_ - Official amd64 DVD]/ bookworm main\n"
            "# deb http://comment.invalid/debian bookworm main\n"
            "deb-src http://source.invalid/debian bookworm main\n"
            "deb http://updates.invalid/debian bookworm-updates main\n"
            "deb http://flat.invalid/ ./\n"
            "deb http://contrib.invalid/debian bookworm contrib\n"
            "deb http://right.invalid/debian bookworm main\n")
    assert source(apt_dir(tmp_path, sources__list=text))["URIs"] == "http://right.invalid/debian"


def test_disc_in_deb822_and_a_stanza_that_is_off(tmp_path):
    text = ("Types: deb\nURIs: cdrom:[Debian]/\nSuites: bookworm\nComponents: main\n\n"
            "Enabled: no\nTypes: deb\nURIs: http://off.invalid/d\nSuites: bookworm\nComponents: main\n\n"
            "Types: deb-src deb\nURIs: http://right.invalid/d\nSuites: bookworm\nComponents: main\n")
    assert source(apt_dir(tmp_path, a__sources=text))["URIs"] == "http://right.invalid/d"


def test_key_within_the_source(tmp_path):
    key = "Signed-By:\n -----BEGIN PGP PUBLIC KEY BLOCK-----\n .\n abc\n -----END PGP PUBLIC KEY BLOCK-----"
    text = SOURCES.replace("Signed-By: /usr/share/keyrings/some-keyring.gpg", key)
    written = apt_mirror.source_for("bookworm", "trixie", apt_dir(tmp_path, debian__sources=text))
    assert " -----BEGIN PGP PUBLIC KEY BLOCK-----\n .\n abc\n" in written


def test_files_that_apt_does_not_read_are_not_read(tmp_path):
    assert source(apt_dir(tmp_path, debian__sources__disabled=SOURCES)) is None


def test_no_mirror_is_said(tmp_path, capsys):
    assert apt_mirror.main(["bookworm", "trixie", str(apt_dir(tmp_path))]) == 1
    assert "no apt source of suite bookworm" in capsys.readouterr().err


def test_no_mirror_is_written_down_in_the_project():
    for file in (CHECKOUT / "Makefile", *(CHECKOUT / "requirements").iterdir(), CHECKOUT / "tools" / "setup.sh",
                 CHECKOUT / "tools" / "apt_mirror.py"):
        assert "://" not in file.read_text().replace("SPDX", ""), file


# --- the script -----------------------------------------------------------------

HIDDEN = ("qemu-system-arm", "sudo", "apt-get", "apt-cache", "id")


@pytest.fixture(scope="module", name="others")
def fixture_others(tmp_path_factory):
    """A folder with all commands of this machine but those."""
    others = tmp_path_factory.mktemp("others")
    for folder in os.environ["PATH"].split(os.pathsep):
        for file in pathlib.Path(folder).glob("*") if folder else ():
            link = others / file.name
            if file.name not in HIDDEN and not link.is_symlink():
                link.symlink_to(file)
    return others


@pytest.fixture
def machine(tmp_path, others):
    """A checkout and a PATH with everything but QEMU and sudo, with an apt that is only played."""
    root = tmp_path / "checkout"
    (root / "tools").mkdir(parents=True)
    for name in ("tools/setup.sh", "tools/apt_mirror.py"):
        shutil.copy(CHECKOUT / name, root / name)
    shutil.copytree(CHECKOUT / "requirements", root / "requirements")
    commands = tmp_path / "bin"
    commands.mkdir()
    (tmp_path / "others").symlink_to(others)
    play(commands, "apt-cache", 'echo "$2:"; echo "  Candidate: 1.0"')
    play(commands, "apt-get", f'echo "$*" >>{tmp_path}/apt.txt; exit 0')
    play(commands, "id", "echo 1000")
    return tmp_path


def play(commands, name, script):
    file = commands / name
    file.write_text(f"#!/bin/sh\n{script}\n")
    file.chmod(file.stat().st_mode | stat.S_IXUSR)


def setup(machine, *what, **changes):
    return subprocess.run([str(machine / "checkout" / "tools" / "setup.sh"), *what],
                          stdin=subprocess.DEVNULL, capture_output=True, text=True,
                          check=False, env=environment(PATH=f"{machine}/bin:{machine}/others", **changes))


def test_nothing_missing_is_silent(machine):
    done = setup(machine, "lib")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert not (machine / "checkout" / "build").exists()


def test_without_root_the_exact_command(machine):
    done = setup(machine, "--packages-only", "run")
    assert done.returncode == 1
    assert done.stderr.splitlines()[-1].strip() == \
        "setup:   su -c 'apt-get install -y --no-install-recommends qemu-system-arm'".strip()
    assert not (machine / "apt.txt").exists(), "apt-get ran without root"


def test_without_root_sudo_where_there_is_one(machine):
    play(machine / "bin", "sudo", "exit 9")
    done = setup(machine, "--packages-only", "run")
    assert "setup:   sudo apt-get install -y --no-install-recommends qemu-system-arm" in done.stderr


def test_without_root_and_without_lists_the_script_itself(machine):
    play(machine / "bin", "apt-cache", 'echo "$2:"; echo "  Candidate: (none)"')
    done = setup(machine, "run")
    assert done.returncode == 1
    assert f"su -c '{machine}/checkout/tools/setup.sh --packages-only run'" in done.stderr


def test_as_root_says_what_and_installs_only_that(machine):
    play(machine / "bin", "id", "echo 0")
    play(machine / "bin", "apt-get", f"""echo "$*" >>{machine}/apt.txt
case "$*" in *assume-no*) echo "Need to get 12.3 MB of archives."
    echo "After this operation, 45.6 MB of additional disk space will be used." ;;
*) ln -sf /bin/true {machine}/bin/qemu-system-arm ;; esac""")
    done = setup(machine, "--packages-only", "run")
    assert done.returncode == 0, done.stderr
    assert "installing qemu-system-arm (12.3 MB to fetch, 45.6 MB on disk)" in done.stderr
    asked = (machine / "apt.txt").read_text().splitlines()
    assert [line for line in asked if "install" in line and "assume-no" not in line] == \
        [asked[-1]] and asked[-1].endswith("install qemu-system-arm")
    before = (machine / "apt.txt").read_text()
    again = setup(machine, "--packages-only", "run")
    assert (again.returncode, again.stderr) == (0, "") and (machine / "apt.txt").read_text() == before


def test_apt_that_fails_is_shown(machine):
    play(machine / "bin", "id", "echo 0")
    play(machine / "bin", "apt-get", 'echo "E: no room left" >&2; exit 100')
    done = setup(machine, "--packages-only", "run")
    assert done.returncode == 1
    assert "no room left" in done.stderr and "apt-get" in done.stderr


def test_installing_that_does_not_help_is_said(machine):
    play(machine / "bin", "id", "echo 0")
    done = setup(machine, "--packages-only", "run")
    assert done.returncode == 1
    assert "still missing after installing: qemu-system-arm" in done.stderr


def test_no_apt_at_all(machine):
    (machine / "bin" / "apt-get").unlink()
    done = setup(machine, "--packages-only", "run")
    assert done.returncode == 1 and "qemu-system-arm" in done.stderr and "no apt-get" in done.stderr


@pytest.mark.parametrize("words, code", [(["run"], 0), (["test", "probe"], 0), (["run", "fuzz"], 1)])
def test_what_make_test_has_set_up_is_not_looked_for_again(machine, words, code):
    """In its own checkout; QEMU is missing here."""
    assert setup(machine, *words, FIXEL_SET_UP=str(machine / "checkout")).returncode == code
    assert setup(machine, *words, FIXEL_SET_UP=str(machine)).returncode == 1


def test_unknown_set_up(machine):
    assert setup(machine, "everything", FIXEL_SET_UP=str(machine / "checkout")).returncode == 1
    assert "unknown set-up 'everything'" in setup(machine, "everything").stderr


# --- Python packages ----------------------------------------------------------

PYTHON = """case "$*" in
*"-m venv --clear "*) mkdir -p .venv/bin; ln -sf {bin}/python3 .venv/bin/python ;;
*"-m pip install "*) echo "$*" >>{log}; echo "Collecting numpy==1" ;;
*) exec {real} "$@" ;;
esac"""


@pytest.fixture
def pip(machine):
    """The machine with QEMU, and a Python whose pip is only played; the log of what pip was told."""
    log = machine / "pip.txt"
    play(machine / "bin", "qemu-system-arm", "exit 0")
    play(machine / "bin", "python3", PYTHON.format(bin=machine / "bin", log=log, real=sys.executable))
    return log


def groups(log):
    return re.findall(r"requirements/(\w+)\.txt", log.read_text()) if log.exists() else []


def test_a_run_installs_the_packages_of_a_run_alone(machine, pip):
    done = setup(machine, "run")
    assert done.returncode == 0 and groups(pip) == ["run"], done.stderr
    assert "setup:   numpy==1" in done.stderr
    assert setup(machine, "tools").stderr == "" and groups(pip) == ["run"]


def test_another_command_adds_what_is_missing(machine, pip):
    setup(machine, "run")
    setup(machine, "view")
    assert groups(pip) == ["run", "view"]
    (machine / "checkout" / "requirements" / "run.txt").write_text("numpy==2\n")
    setup(machine, "view")
    assert groups(pip) == ["run", "view", "run"]


def test_groups_are_whole_and_pin_alike():
    pins = [re.fullmatch(r"([\w.-]+)==([\w.]+)((?: --hash=sha256:[0-9a-f]{64})+)", line)
            for file in (CHECKOUT / "requirements").glob("*.txt")
            for line in re.sub(r" \\\n +", " ", file.read_text()).splitlines() if line and not line.startswith("#")]
    assert pins and all(pins)
    assert "--require-hashes" in (CHECKOUT / "tools" / "setup.sh").read_text()
    # A package with code of its own has a wheel for each Python and processor, or one for each processor.
    assert {pin[1]: pin[3].count("--hash") for pin in pins if pin[1] in ("numpy", "pillow", "aiohttp", "playwright", "pytest")} == \
        {"numpy": 4, "pillow": 4, "aiohttp": 4, "playwright": 2, "pytest": 1}
    assert len({pin[1]: pin[2] for pin in pins}) == len({pin.group() for pin in pins})


@pytest.mark.parametrize("words", [["tools/scene.py"], ["/usr/bin/env", "python3", "tools/fixel/launcher.py", "run"]], ids=["scene", "run"])
def test_a_tool_runs_by_the_python_of_the_venv(words, tmp_path):
    """Called as the documents do, by whatever Python there is; and says what to do where there is no venv."""
    env = environment(PATH="/usr/bin:/bin")
    done = subprocess.run([*words, "--help"], cwd=CHECKOUT, env=env, capture_output=True, text=True, check=False)
    assert done.returncode == 0 and "usage" in done.stdout, done.stderr
    shutil.copytree(CHECKOUT / "tools", tmp_path / "tools")
    done = subprocess.run([*words, "--help"], cwd=tmp_path, env=env, capture_output=True, text=True, check=False)
    assert done.returncode == 2 and "tools/setup.sh tools" in done.stderr
    assert len(done.stderr.splitlines()) == 1


# --- make -----------------------------------------------------------------------

PICTURES = ["A=docs/cube.png", "B=docs/cube.png"]   # that make compare needs
ALONE = {"help", "clean"}   # commands that need nothing


def commands():
    text = (CHECKOUT / "Makefile").read_text()
    return sorted(set(re.findall(r"^([a-z-]+):.* ## ", text, re.MULTILINE)) - ALONE)


@pytest.mark.parametrize("command", commands())
def test_each_command_begins_with_set_up(command, tmp_path):
    """Nothing is built or run before it, and reading the Makefile installs nothing. A build folder far away makes
    no command longer than Linux takes: 128 KiB."""
    done = dry_run(command, f"BUILD={tmp_path / ('b' * 200)}", *(PICTURES if command == "compare" else []))
    assert done.returncode == 0, done.stderr
    assert re.match(rf"((python3|\.venv/bin/python) -S tools/fixel/base/before\.py {command} && )?tools/setup\.sh [a-z]+( [a-z]+)*\n", done.stdout), done.stdout[:500]


@pytest.mark.parametrize("goals", [["run"], ["lib"], ["wire", "lib"], ["compare", *PICTURES]])
def test_set_up_is_over_before_anything_starts(goals, tmp_path):
    """In a fresh clone and with many jobs."""
    root, log, commands = tmp_path / "checkout", tmp_path / "log.txt", tmp_path / "bin"
    shutil.copytree(CHECKOUT, root, ignore=shutil.ignore_patterns("build", ".venv", ".git", "corpus"))
    (root / "tools" / "setup.sh").write_text(f"#!/bin/sh\nsleep 0.3\necho set-up >>{log}\n")
    commands.mkdir()
    for name in ("gcc", "ar", "arm-none-eabi-gcc", "arm-none-eabi-ar"):
        play(commands, name, f'echo compile >>{log}; for each; do file=$each; done; touch "$file"')
    (root / ".venv" / "bin").mkdir(parents=True)
    # What looks at the variables before set-up is no tool.
    play(root / ".venv" / "bin", "python", f'case "$*" in *base/before.py*) ;; *) echo tool >>{log};; esac')
    done = subprocess.run(["make", "-C", root, "-j8", *goals], capture_output=True, text=True, check=False,
                          env=environment(PATH=f"{commands}:{os.environ['PATH']}"))
    steps = [step for step, _ in itertools.groupby(log.read_text().split())]
    assert steps[0] == "set-up" and len(steps) >= 2, done.stdout + done.stderr


def test_help_lists_every_command():
    text = subprocess.run(["make", "-C", str(CHECKOUT), "--no-print-directory"], capture_output=True,
                          text=True, check=True, env=environment()).stdout
    for verb in ("run", "flash", "boot", "compare", "report", "lib", "test", "size", "format", "clean",
                 "help"):
        assert f"make {verb} " in text
