# SPDX-License-Identifier: MIT
"""The inside of a process that fixel/base/bounded.py starts: it limits itself, does the job, and answers in lines of JSON."""

import contextlib
import errno
import gc
import json
import os
import resource
import sys
import time
import traceback

from fixel.base import interpreter, reading
from fixel.base.errors import ToolError

PAUSE = 0.1     # seconds between two words of one stage
_MEMORY = b'{"memory": true}\n'     # made while there is memory


class Quiet:
    """Hears what is being done, and tells nobody."""

    def stage(self, _text):
        """A stage begins."""

    def __call__(self, _text):
        """How far the stage is."""


class Report:
    """Tells the caller what is being done."""

    def __init__(self, send):
        self.send, self.last, self.next, self.result = send, None, 0.0, b""

    def give(self, data):
        """The bytes of a result, which go to the caller with the answer. They pass through no file, which somebody could remove or a limit of
        the system cut off."""
        self.result = data

    def stage(self, text):
        """A stage begins."""
        if text != self.last:
            self.send({"stage": text})
            self.last, self.next = text, time.monotonic() + PAUSE

    def __call__(self, text):
        """How far the stage is: told now and then."""
        if time.monotonic() >= self.next:
            self.stage(text)


def _limit(seconds, size):
    """Sets the limits of this process; answers which of them this system lacks. The hard limit of CPU time stays: the soft
    one ends the process, since nothing handles its signal."""
    lacking = []
    for kind, most, name in (("RLIMIT_CPU", seconds, "CPU time"), ("RLIMIT_AS", size, "memory")):
        try:
            number = getattr(resource, kind)
            resource.setrlimit(number, (most, resource.getrlimit(number)[1]))
        except (AttributeError, ValueError, OSError):
            lacking.append(name)
    resource.setrlimit(resource.RLIMIT_CORE, (0, resource.getrlimit(resource.RLIMIT_CORE)[1]))
    return lacking


def _place(error):
    """Where an unforeseen error arose, in few words."""
    last = traceback.extract_tb(error.__traceback__)[-1]
    return f"{type(error).__name__} in {os.path.basename(last.filename)}, line {last.lineno}"


def _is_of_memory(error):
    """Whether an error says that there is no memory. A package that is imported late, as Pillow's readers are, cannot be
    mapped then."""
    return isinstance(error, MemoryError) or isinstance(error, OSError) and error.errno == errno.ENOMEM or \
        isinstance(error, ImportError) and not isinstance(error, ModuleNotFoundError)


def _answer(do, request, report):
    """The last line: what the job answers, and behind it the bytes of its result; or how it failed."""
    try:
        answer = do(request, report)
        line = json.dumps({"opened": sorted(reading.opened()), "done": [answer, len(report.result)]})
        return [line.encode() + b"\n", report.result]
    except ToolError as error:
        line = json.dumps({"error": {"message": error.message, "exit_code": error.exit_code, "words": error.words}})
    except Exception as error:  # one sentence for the caller, whatever it was
        if _is_of_memory(error):
            return [_MEMORY]
        if interpreter.lacks_files(error):
            return [json.dumps({"error": {"message": interpreter.LACKING, "exit_code": 2, "words": ""}}).encode() + b"\n"]
        line = json.dumps({"defect": _place(error)})
    return [line.encode() + b"\n"]


def _write(pipe, data):
    data = memoryview(data)     # whose rest is no copy
    while data:
        data = data[os.write(pipe, data):]


def serve(do):
    """Does one job: do(request, Report) answers what JSON holds. What is printed goes to the standard error."""
    pipe = os.dup(1)
    os.dup2(2, 1)
    gc.disable()    # a scene makes a million small objects, and no cycles: looking for these takes a sixth of the time
    request = json.load(sys.stdin.buffer)
    if not request["outside"]:
        reading.confine(request["subject"])
    report = Report(lambda message: _write(pipe, json.dumps(message).encode() + b"\n"))
    lacking = _limit(request["seconds"], request["bytes"])
    if lacking:
        report.send({"without": " and of ".join(lacking)})
    with contextlib.suppress(BrokenPipeError):      # the caller is gone
        for part in _answer(do, request, report):
            _write(pipe, part)
    os._exit(0)     # the memory of a large scene need not be given back object by object
