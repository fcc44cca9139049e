# SPDX-License-Identifier: MIT
"""A job in a process of its own, under limits of the operating system on CPU time and memory.

The process is a fresh Python, no fork: the caller may have threads. It gets the request as JSON on its standard input and
answers in lines of JSON on its standard output (fixel/base/job.py). However it ends, the caller gets its answer or one
sentence that names the file, the stage, the limits and their options."""

import json
import os
import resource
import signal
import subprocess
import sys
import time
from dataclasses import dataclass

from fixel.base import children, reading
from fixel.base.errors import ToolError, one_line

CPU = 60                    # seconds
MEMORY = 2048               # MiB, and at most half of the machine's memory
CPU_MAX, MEMORY_MAX = 86_400, 1 << 20
MEMORY_MIN = 64             # MiB: less than Python itself takes is a mistake
QUIET_SECONDS = 2.0         # between two words about the progress
_MIB = 1 << 20

_told_without = False       # that this system lacks a limit, which is said once


def _default_memory():
    """MiB: the default, or half of the machine's memory if that is less."""
    try:
        machine = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    except (OSError, ValueError):
        return MEMORY
    return min(MEMORY, max(MEMORY_MIN, machine // 2 // _MIB))


def _at_most_present(kind, wanted):
    """A limit that is at most those that this process has itself, which its children inherit."""
    return min([wanted, *(limit for limit in resource.getrlimit(kind) if limit != resource.RLIM_INFINITY)])


@dataclass(frozen=True)
class Limits:
    """CPU time in seconds and memory in MiB that a job may take; None: the default. outside: whether it may open files
    outside the folder of its subject, and below."""
    cpu: int = None
    memory: int = None
    outside: bool = False

    def effective(self):
        """(seconds, bytes) that hold, with the limits that this process has itself."""
        return (_at_most_present(resource.RLIMIT_CPU, self.cpu or CPU),
                _at_most_present(resource.RLIMIT_AS, (self.memory or _default_memory()) * _MIB))


def add_options(parser):
    """The options of a command that runs such a job; limits_of reads them."""
    parser.add_argument("--cpu-limit", metavar="SECONDS",
                        help=f"CPU time in which the scene must be read and compiled ({CPU})")
    parser.add_argument("--memory-limit", metavar="MIB",
                        help=f"memory that this may take, in MiB ({MEMORY:,}, and at most half of the machine's)")
    parser.add_argument("--allow-outside", action="store_true",
                        help="let the scene or model name files outside its folder and the folders below")


def _whole(text, name, least, most):
    if text is None:
        return None
    if not (text.isascii() and text.isdigit() and len(text) < 10 and least <= int(text) <= most):
        raise ToolError(f"{name} is {text[:80]!r}; it must be a whole number from {least} to {most:,}")
    return int(text)


def limits_of(options):
    """The Limits that parsed options ask for."""
    return Limits(_whole(options.cpu_limit, "--cpu-limit", 1, CPU_MAX),
                  _whole(options.memory_limit, "--memory-limit", MEMORY_MIN, MEMORY_MAX), options.allow_outside)


class _Job:
    """A running job, as its caller sees it."""

    def __init__(self, subject, limits):
        self.subject, self.stage = subject, "its start"
        self.seconds, self.bytes = limits.effective()
        self.answered, self.answer, self.data, self.error = False, None, None, None
        self.next = time.monotonic() + QUIET_SECONDS

    def hear(self, line, pipe):
        """Takes a line of the process, and behind the answer the bytes of the result; what is damaged ends the listening."""
        self.pipe, message = pipe, json.loads(line)
        for kind, value in message.items():
            getattr(self, f"_hear_{kind}")(value)

    def _hear_stage(self, text):
        self.stage = text
        if time.monotonic() >= self.next:
            print(f"scene: {one_line(text)}", file=sys.stderr, flush=True)
            self.next = time.monotonic() + QUIET_SECONDS

    def _hear_without(self, names):
        global _told_without
        if not _told_without:
            print(f"note: this system has no limit of {names} for a process: scenes are compiled without", file=sys.stderr)
        _told_without = True

    def _hear_done(self, message):
        self.answer, size = message
        self.data = self.pipe.read(size)
        self.answered = len(self.data) == size

    def _hear_opened(self, files):
        reading.note_opened(files)

    def _hear_error(self, error):
        self.error = ToolError(error["message"], error["exit_code"], error["words"])

    def _hear_memory(self, _):
        self.error = self._ended(f"it needs more than the limit of {self.bytes // _MIB:,} MiB of memory")

    def _hear_defect(self, text):
        self.error = self._ended(f"this is a defect of the tool ({text}): please report it, with the file")

    def hear_nonsense(self):
        """The process wrote what is no message."""
        self.error = self._ended("its process sent a damaged answer")

    def _ended(self, why):
        return ToolError(f"{self.subject}: at the stage '{self.stage}' {why}; the limits are {self.seconds:,} s of CPU time "
                         f"(--cpu-limit) and {self.bytes // _MIB:,} MiB of memory (--memory-limit)")

    def result(self, code):
        """(the answer, the bytes of the result) of a process that ended with this code; or what stands for it is raised."""
        if self.error:
            raise self.error
        if self.answered:
            return self.answer, self.data
        if code == -signal.SIGXCPU:
            raise self._ended(f"it took the limit of {self.seconds:,} s of CPU time")
        if code == -signal.SIGKILL:
            raise self._ended("its process was killed, as a system does whose memory is full")
        if code < 0:
            raise self._ended(f"its process was ended by {signal.Signals(-code).name}")
        raise self._ended("its process ended without an answer")


def start(program, _limits):
    """The process of a job, with pipes."""
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}   # threads would reserve memory, for nothing
    return children.start([sys.executable, "-I", program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=environment)


def run(program, request, subject, limits=None):
    """Runs a job: (what it answers, the bytes that it gives). program: a Python file that calls job.serve. request: what it is asked, as
    JSON holds it. subject: the file that the job is about, for messages."""
    limits = limits or Limits()
    job = _Job(subject, limits)
    asked = json.dumps({**request, "seconds": job.seconds, "bytes": job.bytes, "subject": os.fspath(subject),
                        "outside": limits.outside}).encode()
    with start(program, limits) as process:
        try:
            _ask(process, asked)
            for line in process.stdout:
                job.hear(line, process.stdout)
        except (ValueError, AttributeError, KeyError, TypeError):   # no such message: the process writes nonsense
            job.hear_nonsense()
            process.kill()
        except BaseException:
            process.kill()
            raise
        process.kill()      # one that has closed its pipe has ended, or never will
    return job.result(process.returncode)


def _ask(process, asked):
    """The request; whoever is gone already needs none."""
    try:
        process.stdin.write(asked)
        process.stdin.close()
    except BrokenPipeError:
        pass
