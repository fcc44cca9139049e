# SPDX-License-Identifier: MIT
"""Records which lines of the tools a test executes, in its process and in all that it starts.

The Python of the tests imports this module when it starts (fixel.check.tool_mutants, Tree.record), by a name of its own: a module
sitecustomize may be there already, as on Debian. FIXEL_LINES_OF is the folder whose lines are recorded, FIXEL_LINES the file to
which each process adds "FILE:LINE", once for each line. A process that starts without FIXEL_LINES records nothing before
begin(): to import packages would be slow.
"""

import os
import sys
import threading

ROOT = os.environ.get("FIXEL_LINES_OF", "")
FUNCTION = 1        # a flag of code that is not a module's or class's own (inspect.CO_OPTIMIZED)
QUIET = 500         # lines of one function without a new one, after which it is no longer followed: loops are slow


class _Recorder:
    """What one process has executed since begin()."""

    def __init__(self):
        self.files, self.functions, self.handle = {}, {}, None

    def begin(self):
        """All lines are new again, and go to the file that FIXEL_LINES names now."""
        threading.settrace(self)
        sys.settrace(self)
        self.functions.clear()
        if self.handle is not None:
            os.close(self.handle)
        self.handle = None

    def write(self, file, line):
        if self.handle is None:
            self.handle = os.open(os.environ.get("FIXEL_LINES", os.devnull), os.O_WRONLY | os.O_CREAT | os.O_APPEND)
        os.write(self.handle, f"{file}:{line}\n".encode())

    def follow(self, code):
        """(the code, its lines that are new, the trace function) of a function that begins for the first time."""
        file = os.path.relpath(code.co_filename, ROOT)
        new, quiet = {line for _, _, line in code.co_lines() if line}, 0
        self.write(file, code.co_firstlineno)

        def trace(frame, event, _argument):
            nonlocal quiet
            quiet += 1
            if event == "line" and frame.f_lineno in new:
                new.discard(frame.f_lineno)
                self.write(file, frame.f_lineno)
                quiet = 0
            if quiet > QUIET:
                new.clear()
            frame.f_trace_lines = bool(new)
            return trace

        return code, new, trace

    def __call__(self, frame, _event, _argument):
        code = frame.f_code
        wanted = self.files.get(code.co_filename)
        if wanted is None:
            wanted = self.files[code.co_filename] = code.co_filename.startswith(ROOT)
        if not wanted or not code.co_flags & FUNCTION:
            return None
        found = self.functions.get(id(code))
        if found is None:
            found = self.functions[id(code)] = self.follow(code)
        return found[2] if found[1] else None


if ROOT:
    recorder = _Recorder()
    os.register_at_fork(after_in_child=lambda: "FIXEL_LINES" in os.environ and recorder.begin())
    if "FIXEL_LINES" in os.environ:
        recorder.begin()
