# SPDX-License-Identifier: MIT
"""A tool runs by the Python of .venv, which has the packages that it needs."""

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
    if INSTALLED.exists():
        return
    if pathlib.Path(sys.prefix).resolve() == VENV.resolve():
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


def explain(kind, error, trace):
    """A missing package as one sentence; any other error as Python shows it."""
    if issubclass(kind, ModuleNotFoundError):
        print(f"error: {VENV} has no {error.name}: run 'tools/setup.sh test' in {TOOLS.parent}, which "
              "installs the Python packages of every tool", file=sys.stderr)
        return
    sys.__excepthook__(kind, error, trace)
