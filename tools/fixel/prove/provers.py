# SPDX-License-Identifier: MIT
"""The provers: packages of Debian 13, unpacked below the build folder and started by that release's own loader.

Debian 12 has no CBMC, so the packages come from suite trixie of this machine's own mirror, on every machine the same.
They are fetched by apt-get as an ordinary user, with lists and a status of its own: nothing of the machine changes.
apt checks what it fetches against the key of the machine's own source.
"""

import hashlib
import os
import pathlib
import platform
import shutil
import subprocess

from fixel.base import children, scratch
from fixel.base.errors import ToolError

CHECKOUT = pathlib.Path(__file__).resolve().parents[3]
SUITE = "trixie"
PACKAGES = ("cbmc", "minisat", "z3", "gappa", "libc6", "libgcc-s1", "libstdc++6", "libgmp10", "libmpfr6")
PROGRAMS = ("cbmc", "goto-cc", "goto-instrument", "z3", "gappa")
CBMC = "6.6"        # proofs are known to end with this version
LOADER, LIBRARIES = "usr/lib64/ld-linux-x86-64.so.2", ("usr/lib/x86_64-linux-gnu", "usr/lib")


def _refuse(why):
    return ToolError(f"make prove needs CBMC {CBMC}, and it cannot be had here: {why}")


def _codename():
    words = {}
    try:
        for line in pathlib.Path("/etc/os-release").read_text(encoding="utf-8").splitlines():
            name, _, value = line.partition("=")
            words[name] = value.strip('"')
    except OSError:
        pass
    return words.get("VERSION_CODENAME", "") if words.get("ID") == "debian" else ""


def _source():
    """The machine's own source of Debian, for another suite, as a file of apt's."""
    codename = _codename()
    if not codename:
        raise _refuse("this is not Debian, and the packages are Debian's")
    done = children.run(["python3", CHECKOUT / "tools/apt_mirror.py", codename, SUITE], text=True)
    if done.returncode:
        raise _refuse(done.stderr.strip().removeprefix("error: "))
    # Its first line says that set-up wrote it for a package of its own.
    return "".join(f"{line}\n" for line in done.stdout.splitlines() if not line.startswith("#"))


def _apt(folder, *words):
    """apt-get with nothing of the machine's but its keys and its way to the network."""
    options = {"Dir::State": folder / "state", "Dir::State::status": folder / "status", "Dir::Cache": folder / "cache",
               "Dir::Etc::sourcelist": folder / "prove.sources", "Dir::Etc::sourceparts": "/dev/null",
               "Dir::Etc::preferences": "/dev/null", "Dir::Etc::preferencesparts": "/dev/null",
               "Acquire::Languages": "none", "Acquire::IndexTargets::deb::DEP-11::DefaultEnabled": "false",
               "APT::Sandbox::User": "", "APT::Architecture": "amd64", "APT::Architectures": "amd64"}
    command = ["apt-get", "-q", "-y", *(f"-o{name}={value}" for name, value in options.items()), *words]
    done = children.run(command, cwd=folder, text=True, errors="replace", stderr=subprocess.STDOUT,
                        env={**os.environ, "LC_ALL": "C"})
    if done.returncode:
        raise _refuse(f"apt-get {words[0]} failed: {' '.join(done.stdout.split()[-40:])}")


def _unpack(folder):
    """Fetches the packages into a folder and unpacks them there; what the scripts of bin start."""
    for each in ("state/lists/partial", "cache/archives/partial"):
        (folder / each).mkdir(parents=True)
    (folder / "status").touch()
    (folder / "prove.sources").write_text(_source(), encoding="utf-8")
    _apt(folder, "update")
    _apt(folder, "download", *PACKAGES)
    for package in sorted(folder.glob("*.deb")):
        done = children.run(["dpkg-deb", "-x", package, folder / "root"], text=True)
        if done.returncode:
            raise _refuse(f"{package.name} cannot be unpacked: {done.stderr.strip()}")
        package.unlink()
    for each in ("state", "cache", "root/usr/share"):
        shutil.rmtree(folder / each)


def _write_scripts(folder, final):
    """A program of the packages runs by their own loader, with their own libraries."""
    (folder / "bin").mkdir()
    root = final / "root"
    path = ":".join(str(root / each) for each in LIBRARIES)
    for name in PROGRAMS:
        script = folder / "bin" / name
        script.write_text(f"#!/bin/sh\nexec '{root / LOADER}' --library-path '{path}' '{root / 'usr/bin' / name}' \"$@\"\n",
                          encoding="utf-8")
        script.chmod(0o755)


def _stamp(folder):
    """What says that a folder is whole, and made by this file for this place."""
    return hashlib.sha256(pathlib.Path(__file__).read_bytes() + str(folder).encode()).hexdigest()


def obtain(build, say):
    """The folder of the provers' programs, fetched where it is not there. say(text) tells that it takes a while."""
    if platform.machine() != "x86_64":
        raise _refuse(f"this is {platform.machine()}, and the packages are unpacked for x86_64 alone")
    for program in ("apt-get", "dpkg-deb", "gcc"):
        if shutil.which(program) is None:
            raise _refuse(f"there is no {program}")
    home = pathlib.Path(build).resolve() / "prove" / "tools"
    stamp = home / "made"
    if not stamp.is_file() or stamp.read_text(encoding="utf-8") != _stamp(home):
        say(f"fetching CBMC, Z3 and Gappa of Debian 13 into {home} (about 40 MB to fetch, 190 MB on disk)")
        home.parent.mkdir(parents=True, exist_ok=True)
        with scratch.folder("provers", home.parent) as new:
            _unpack(new)
            _write_scripts(new, home)
            (new / "made").write_text(_stamp(home), encoding="utf-8")
            shutil.rmtree(home, ignore_errors=True)
            new.rename(home)
    said = children.run([home / "bin/cbmc", "--version"], text=True).stdout.strip()
    if not said.startswith(CBMC):
        raise _refuse(f"the one that was fetched says that it is {said or 'nothing'}")
    return home / "bin"


def versions(programs):
    """What the provers say that they are: part of the key of what is kept."""
    return [children.run([programs / name, "--version"], text=True).stdout.strip() for name in ("cbmc", "z3", "gappa")]
