# SPDX-License-Identifier: MIT
"""A file of tests for pytest names in BUILT_PROGRAMS what it runs below build/, and make test ONLY= has that built alone. Here a
process refuses to start a program below build/ that the file does not name: otherwise the name would be missed only where
nothing else is built. A name with a * is of what the tests make themselves, or look at where it is there: nothing is built for
it."""

import fnmatch
import os
import pathlib
import sys

BUILD = pathlib.Path(__file__).resolve().parents[1] / "build"
ANYWHERE = pathlib.Path(__file__).resolve().parent / "anywhere"
NAMED = "FIXEL_BUILT_PROGRAMS"    # of the environment, which the tools that a test starts get too
MADE = {".elf", ".a", ".so", ".json"}
READ = (".elf", ".a", ".so")      # a program that is opened, not run, must be named too


_module, _asked_for = None, set()


def of(module):
    """What the tests of a module may run. For make test-anywhere all is built, and its files name nothing."""
    global _module
    if module is _module:
        return
    programs = getattr(module, "BUILT_PROGRAMS", None)
    if programs is None and ANYWHERE in pathlib.Path(module.__file__).parents:
        os.environ.pop(NAMED, None)
    elif programs is None:
        raise RuntimeError(f"{module.__file__} has no BUILT_PROGRAMS: the programs below build/ that its tests run")
    else:
        os.environ[NAMED] = " ".join([*programs, *_asked_for])
    _module = module


def add(file):
    """A test has asked make for a file: it may be run too, also by the next module, whose test does not ask again."""
    if BUILD not in pathlib.Path(file).parents:
        return      # what make knows for several files, which a module names
    name = os.path.relpath(file, BUILD)
    _asked_for.add(name)
    if NAMED in os.environ:
        os.environ[NAMED] += f" {name}"


def missing():
    """The programs that are named and not built."""
    return [name for name in os.environ.get(NAMED, "").split() if "*" not in name and not (BUILD / name).exists()]


def below_build(word, folder):
    """The path below build/ of a program that make builds there, or None."""
    path = pathlib.Path(os.path.normpath(os.path.join(folder or os.getcwd(), os.fsdecode(word))))
    if BUILD not in path.parents or not path.is_file() or path.suffix not in MADE and not os.access(path, os.X_OK):
        return None
    return str(path.relative_to(BUILD))


def _refuse(event, arguments):
    if event == "subprocess.Popen":
        _, words, folder, _ = arguments
    elif event == "open" and isinstance(arguments[0], str) and arguments[0].endswith(READ):
        words, folder = arguments[0], None
    else:
        return
    if NAMED not in os.environ:
        return
    for word in [words] if isinstance(words, (str, bytes, os.PathLike)) else words:
        name = below_build(word, folder)
        if name and not any(fnmatch.fnmatchcase(name, each) for each in os.environ[NAMED].split()):
            raise RuntimeError(f"this test runs build/{name}, which the BUILT_PROGRAMS of its file do not name")


def heed():
    """From now on this process, and each fork of it, refuses."""
    sys.addaudithook(_refuse)
