# SPDX-License-Identifier: MIT
"""Strangers at the live window's server: who may hold a connection, and how many, and what the server says of them on stderr: one line for each
kind of trouble, however often it happens.

A connection is a stranger until a request of it has named the token. Strangers are few and have little time, so that
processes which connect and say nothing take no connection from the page. A stranger decides what requests come and how many. So no
request may print a traceback, or a line each time.
"""

import asyncio
import contextlib
import logging
import pathlib
import sys
import traceback

from fixel.base.reading import quoted

STRANGERS_MAX = 32      # connections at a time; one more ends the oldest of them
TRUSTED_MAX = 64        # connections at a time; one more is refused
STRANGER_TIME = 5.0     # seconds
BACKLOG = 16            # connections that the kernel accepts before the server does


class Guard:
    """Makes connections for a server's protocols, as many as are allowed. For the thread of the event loop."""

    def __init__(self, protocol, troubles):
        self._protocol = protocol   # makes a protocol of the server's
        self._troubles = troubles
        self._strangers = {}        # transport -> what ends it when its time is over, the oldest first
        self._trusted = set()

    async def listen(self, host, port):
        return await asyncio.get_running_loop().create_server(lambda: _Door(self), host, port, backlog=BACKLOG)

    def admit(self, transport):
        """A new connection."""
        for each in [each for each in self._strangers if each.is_closing()]:
            self._end(each)
        if len(self._strangers) >= STRANGERS_MAX:
            self._end(next(iter(self._strangers)))
            self._troubles.say("strangers", f"more than {STRANGERS_MAX} connections without a request: "
                               "the oldest are closed")
        timer = asyncio.get_running_loop().call_later(STRANGER_TIME, self._end, transport)
        self._strangers[transport] = timer
        protocol = self._protocol()
        transport.set_protocol(protocol)
        protocol.connection_made(transport)

    def trust(self, transport):
        """A request of the connection has named the token."""
        timer = self._strangers.pop(transport, None)
        if timer is None:
            return
        timer.cancel()
        self._trusted = {each for each in self._trusted if not each.is_closing()}
        if len(self._trusted) >= TRUSTED_MAX:
            transport.abort()
            self._troubles.say("pages", f"more than {TRUSTED_MAX} connections of pages: close some tabs")
        else:
            self._trusted.add(transport)

    def _end(self, transport):
        timer = self._strangers.pop(transport, None)
        if timer is not None:
            timer.cancel()
            transport.abort()

    def close(self):
        for transport in list(self._strangers):
            self._end(transport)


class _Door(asyncio.Protocol):
    """What a connection meets first."""

    def __init__(self, guard):
        self._guard = guard

    def connection_made(self, transport):
        self._guard.admit(transport)


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
