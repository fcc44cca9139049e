# SPDX-License-Identifier: MIT
"""Limits for programs, the same on a slow or busy machine as on a fast one.

A limit is CPU time of a process and all that it started, or time for which they sleep: no thread
is ready to run or waits for a disk. A process that is ready but gets no processor does not sleep.
Wall time counts nowhere.
"""

import concurrent.futures
import os
import pathlib
import signal
import subprocess
import tempfile
import time

from fixel.base import children
from fixel.base.errors import ToolError

ASLEEP = 300.0      # seconds of sleep without output that are a hang
BUSY = 0.05         # of a processor; a process that uses less, such as one that polls, sleeps
LOOK = 1.0          # seconds between two looks: each reads what is known of every process
LOOK_MAX = 1.0      # seconds of sleep that one look counts: this process may have been stopped itself
FIRST_POLL = 0.0005 # seconds
POLL = 0.05
TICKS = os.sysconf("SC_CLK_TCK")


class LimitError(ToolError):
    """A program was stopped; output is what it had printed."""

    def __init__(self, message, output=""):
        super().__init__(message, exit_code=1)
        self.output = output


def _fields(path):
    """The fields of a stat file of /proc, from the state on; None where the process is gone."""
    try:
        return pathlib.Path(path).read_text(encoding="utf-8", errors="replace").rpartition(")")[2].split()
    except OSError:
        return None


def _tree(root):
    """{process: CPU seconds, those of its ended children included} of a process and its descendants."""
    children, cpu = {}, {}
    for name in filter(str.isdigit, os.listdir("/proc")):
        fields = _fields(f"/proc/{name}/stat")
        if fields:
            children.setdefault(int(fields[1]), []).append(int(name))
            cpu[int(name)] = sum(map(int, fields[11:15])) / TICKS
    found, waiting = {}, [root]
    while waiting:
        process = waiting.pop()
        if process in cpu:
            found[process] = cpu[process]
            waiting += children.get(process, [])
    return found


def _is_ready(process):
    """Whether a thread of a process runs, could run, or waits for a disk."""
    try:
        threads = os.listdir(f"/proc/{process}/task")
    except OSError:
        return False
    states = (_fields(f"/proc/{process}/task/{thread}/stat") for thread in threads)
    return any(state and state[0] in "RD" for state in states)


class Watch:
    """Tells when a process has used cpu seconds, or slept asleep seconds, since the last news."""

    def __init__(self, process, cpu, asleep=ASLEEP):
        self.process, self.cpu, self.asleep = process, cpu, asleep
        self.used = self.begun = 0.0    # CPU seconds now, and at the last news
        self.slept = 0.0
        self.fresh = False              # the next look is where the CPU time counts from
        self.news = False               # since the last look: it did not sleep all that time
        self.last = time.monotonic()

    def awake(self):
        """There are news: it does not sleep. Nor did it all the time since the last look, which may be
        long ago on a busy machine."""
        self.slept, self.news = 0.0, True

    def renew(self):
        """There are news: both limits count anew."""
        self.fresh, self.slept, self.news = True, 0.0, True

    def check(self):
        """None, or words that say which limit is passed. To be called again and again."""
        now = time.monotonic()
        elapsed = now - self.last
        if elapsed < min(LOOK, self.cpu / 4, self.asleep / 4):
            return None
        self.last = now
        tree = _tree(self.process)
        before, self.used = self.used, max(self.used, sum(tree.values()))
        if self.fresh:
            self.fresh, self.begun = False, self.used
        if self.news or self.used - before >= BUSY * elapsed or any(map(_is_ready, tree)):
            self.slept, self.news = 0.0, False
        else:
            self.slept += min(elapsed, LOOK_MAX)
        if self.used - self.begun > self.cpu:
            return f"it used {self.cpu:g} s of CPU time"
        if self.slept > self.asleep:
            return f"it slept for {self.asleep:g} s"
        return None


def kill_tree(process):
    """SIGKILL to a process and its descendants; the caller waits for the process itself."""
    for each in _tree(process):
        try:
            os.kill(each, signal.SIGKILL)
        except ProcessLookupError:
            pass


def run(command, cpu, asleep=ASLEEP, merge=False, **options):
    """subprocess.run with captured output and no input, under limits: LimitError where one is passed.
    merge: what it says on stderr comes with stdout. The answer has the CPU seconds, cpu, too."""
    text = options.pop("text", False)
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        process = children.start(command, stdin=subprocess.DEVNULL, stdout=out,
                                 stderr=subprocess.STDOUT if merge else err, **options)
        watch, why, size, pause = Watch(process.pid, cpu, asleep), None, 0, FIRST_POLL
        try:
            while not has_ended(process) and not why:
                time.sleep(pause)
                pause = min(2 * pause, POLL)
                new = os.fstat(out.fileno()).st_size + os.fstat(err.fileno()).st_size
                if new != size:
                    size = new
                    watch.awake()
                why = watch.check()
            taken = cpu_of(process.pid)
        finally:
            if not has_ended(process):
                kill_tree(process.pid)
            process.wait()
        said = [_content(file, text) for file in (out, err)]
    if why and process.returncode == -signal.SIGKILL:
        raise LimitError(f"{command[0]}: {why} and had not ended", said[0])
    done = subprocess.CompletedProcess(command, process.returncode, *said)
    done.cpu = taken
    return done


def has_ended(process):
    """Whether a child has ended. Until somebody waits for it, cpu_of still knows what it used."""
    return process.returncode is not None or \
        os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOHANG | os.WNOWAIT) is not None


def cpu_of(process):
    """CPU seconds of a process, and of those of its children that have ended."""
    fields = _fields(f"/proc/{process}/stat")
    return sum(map(int, fields[11:15])) / TICKS if fields else 0.0


def cpu_of_descendants(process):
    """CPU seconds of what a process has started and what lives, with those of its children that have ended."""
    return sum(cpu for each, cpu in _tree(process).items() if each != process)


def _content(file, text):
    file.seek(0)
    data = file.read()
    return data.decode("utf-8", "replace") if text else data


def wait_until(condition, process, cpu=60.0, asleep=60.0, what="it"):
    """The first true answer of condition(), which the work of a process brings about."""
    watch = Watch(process, cpu, asleep)
    while True:
        answer = condition()
        if answer:
            return answer
        why = watch.check()
        if why:
            raise LimitError(f"{what} does not come: process {process}: {why}")
        time.sleep(POLL / 5)


def wait_for(future, process, seconds):
    """Waits for a concurrent.futures.Future that the work of a process completes."""
    watch = Watch(process, seconds, seconds)
    while not concurrent.futures.wait([future], POLL).done:
        why = watch.check()
        if why:
            raise LimitError(why)
