# SPDX-License-Identifier: MIT
"""Runs a command of the tools that is killed just before its N-th rename, unlink or link.

    killed_at.py N tools/fixel/launcher.py COMMAND ARGUMENT...      N = 0 counts them: the last line of stdout says how many there were
"""

import os
import pathlib
import runpy
import signal
import sys

CALLS = ("rename", "replace", "unlink", "remove", "link", "symlink", "rmdir")


def watch(number):
    """Wraps the calls of os; answers a list whose length says how many there were."""
    made = []

    def wrapped(real):
        def call(*arguments, **options):
            made.append(real.__name__)
            if len(made) == number:
                os.kill(os.getpid(), signal.SIGKILL)
            return real(*arguments, **options)
        return call

    for name in CALLS:
        setattr(os, name, wrapped(getattr(os, name)))
    return made


def main():
    number, program = int(sys.argv[1]), pathlib.Path(sys.argv[2])
    made, owner = watch(number), os.getpid()
    sys.argv = sys.argv[2:]
    sys.path.insert(0, str(program.parent))
    try:
        runpy.run_path(str(program), run_name="__main__")
    finally:
        if number == 0 and os.getpid() == owner:
            print(len(made))


if __name__ == "__main__":
    main()
