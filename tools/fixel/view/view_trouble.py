# SPDX-License-Identifier: MIT
"""What the live window's server says on stderr: one line for each kind of trouble, however often it happens.

A stranger decides what requests come and how many. So no request may print a traceback, or a line each time.
"""

import asyncio
import contextlib
import logging
import pathlib
import sys
import traceback

from fixel.base.reading import quoted

LOGGERS = ("aiohttp", "asyncio")    # what they and the loggers below them log comes here
OURS = pathlib.Path(__file__).resolve().parents[2]


class Troubles(logging.Handler):
    """Takes what aiohttp and asyncio log, from listen() to leave(), and the server's own complaints at any time."""

    def __init__(self):
        super().__init__(logging.WARNING)
        self._said = set()

    def listen(self):
        for logger in map(logging.getLogger, LOGGERS):
            logger.addHandler(self)
            logger.propagate = False

    def leave(self):
        for logger in map(logging.getLogger, LOGGERS):
            logger.removeHandler(self)
            logger.propagate = not any(isinstance(each, Troubles) for each in logger.handlers)

    def say(self, kind, words):
        """Prints a line, unless there was one of this kind."""
        if kind not in self._said:
            self._said.add(kind)
            with contextlib.suppress(OSError, ValueError):      # nobody reads stderr any more
                print(f"live window: {words}", file=sys.stderr, flush=True)

    def emit(self, record):
        """A kind is a type of error at a line of a program, so there are few kinds."""
        error = record.exc_info[1] if record.exc_info else None
        if error is None:
            self.say((record.pathname, record.lineno), quoted(record.getMessage()))
        elif not _is_of_the_wire(error):
            frame = _origin(error)
            name = type(error).__name__
            self.say((name, frame.filename, frame.lineno),
                     f"{name} at {pathlib.Path(frame.filename).name}:{frame.lineno}: {quoted(str(error))}")


def _is_of_the_wire(error):
    """A request that is none, or ends in the middle, is its sender's affair."""
    return isinstance(error, (ConnectionError, asyncio.CancelledError)) or \
        type(error).__module__ == "aiohttp.http_exceptions"


def _origin(error):
    """The innermost line of the tools that an error passed; of another program where it passed none."""
    frames = traceback.extract_tb(error.__traceback__) or [traceback.FrameSummary("unknown", 0, "")]
    return next((each for each in reversed(frames) if OURS in pathlib.Path(each.filename).parents), frames[-1])
