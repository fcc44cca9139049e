# SPDX-License-Identifier: MIT
"""How a tool fails: one clear sentence on stderr and a non-zero exit."""

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
