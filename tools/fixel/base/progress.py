# SPDX-License-Identifier: MIT
"""Says on stderr how far a long job is: one changing line on a terminal, few plain lines elsewhere."""

import sys
import time

from fixel.base.errors import one_line

PLAIN_INTERVAL = 5.0    # seconds between two lines where there is no terminal
TERMINAL_INTERVAL = 0.1
SHORT = 2.0             # seconds; a shorter job needs no word


class Progress:
    """A job of total steps (0: unknown). Use as a context manager; call with the steps done."""

    def __init__(self, label, total=0, stream=None):
        self.label = one_line(label)
        self.total = total
        self.stream = stream or sys.stderr
        self.terminal = self.stream.isatty()
        self.started = time.monotonic()
        self.last_shown = self.started
        self.width = 0

    def __enter__(self):
        if self.terminal:
            self._show(f"{self.label} ...")
        return self

    def __exit__(self, kind, error, trace):
        if self.terminal:
            self._show("")
        seconds = time.monotonic() - self.started
        if kind is None and seconds >= SHORT:
            print(f"{self.label}: {seconds:.1f} s", file=self.stream, flush=True)

    def __call__(self, done, total=None):
        self.total = total or self.total
        now = time.monotonic()
        if now - self.last_shown < (TERMINAL_INTERVAL if self.terminal else PLAIN_INTERVAL):
            return
        self.last_shown = now
        of_total = f" of {self.total} ({100 * done // self.total} %)" if self.total else ""
        self._show(f"{self.label}: {done}{of_total}")

    def _show(self, text):
        if self.terminal:
            self.stream.write("\r" + text.ljust(self.width) + ("\r" if not text else ""))
            self.width = len(text)
            self.stream.flush()
        else:
            print(text, file=self.stream, flush=True)


def steps(label, items, stream=None):
    """Iterates over a sequence and says how far it is."""
    with Progress(label, len(items), stream) as progress:
        for done, item in enumerate(items):
            progress(done)
            yield item
