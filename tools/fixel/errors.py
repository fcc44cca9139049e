# SPDX-License-Identifier: MIT
"""How a tool fails: one clear sentence on stderr and a non-zero exit.

What exit codes mean, for every tool:
  0       done
  1       the result is bad: frames differ, verification failed, a test failed,
          the emulator ended without the program's code
  2       refused: an argument, a file, a missing program; nothing was changed
  10..50  a board's program ended with that code (boards/contract/system.h)
  124     a board's program hung: nothing new came within its limit of CPU time
  130     interrupted
  134     the core locked up
"""

import sys


class ToolError(Exception):
    """What was wrong, where, and what to do about it; shown to the user as is."""

    def __init__(self, message, exit_code=2):
        super().__init__(message)
        self.exit_code = exit_code


def run_main(main):
    """Runs a tool's main(argv) -> exit code and turns ToolError into a sentence."""
    try:
        code = main(sys.argv[1:])
    except ToolError as error:
        print(f"error: {error}", file=sys.stderr)
        code = error.exit_code
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
        code = 130
    sys.exit(code)
