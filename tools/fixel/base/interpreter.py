# SPDX-License-Identifier: MIT
"""A tool runs by the Python of .venv, which has the packages that it needs."""

import errno
import os
import pathlib
import signal
import sys

TOOLS = pathlib.Path(__file__).resolve().parents[2]
LAUNCHER = TOOLS / "fixel" / "launcher.py"
VENV = TOOLS.parent / ".venv"
INSTALLED = TOOLS.parent / "installed"      # a wheel has this file: the Python that runs has the packages (tools/wheel)


def choose():
    """Starts the program that the user called once more, by the Python of .venv, unless it runs there
    already. The program calls this before it imports a package."""
    # NumPy's linear algebra starts a thread for each processor when it is imported: a third of the time that a tool
    # takes to start. The matrices here are small.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    # Until fixel.base.errors takes over there is nothing to tidy up: Ctrl-C ends the tool without a traceback.
    if signal.getsignal(signal.SIGINT) == signal.default_int_handler:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    if sys.flags.optimize:      # Python drops docstrings, which the texts of help come from, and each assert
        os.environ.pop("PYTHONOPTIMIZE", None)
        os.execv(sys.executable, [sys.executable, *sys.argv])
    if INSTALLED.exists() or pathlib.Path(sys.prefix).resolve() == VENV.resolve():
        sys.excepthook = explain
        return
    python = VENV / "bin" / "python"
    if not python.exists():
        print(f"error: {VENV} with the tools' Python packages is missing: run 'tools/setup.sh tools' "
              f"in {TOOLS.parent}", file=sys.stderr)
        sys.exit(2)
    os.execv(python, [str(python), *sys.argv])


def command(name):
    """The words that start a command of fixel."""
    return [sys.executable, str(LAUNCHER), name]


def lacks_files(error):
    """Whether an error says that a process, or the system, may open no more files."""
    return isinstance(error, OSError) and error.errno in (errno.EMFILE, errno.ENFILE)


LACKING = "this process may open too few files: raise the limit, as by 'ulimit -n 256', and run the command again"


def explain(kind, error, trace):
    """A missing package, or too few files that may be open, as one sentence; any other error as Python shows it."""
    if lacks_files(error):
        print(f"error: {LACKING}", file=sys.stderr)
        return
    if issubclass(kind, ModuleNotFoundError) and not INSTALLED.exists():
        print(f"error: {VENV} has no {error.name}: run 'tools/setup.sh test' in {TOOLS.parent}, which "
              "installs the Python packages of every tool", file=sys.stderr)
        return
    sys.__excepthook__(kind, error, trace)
