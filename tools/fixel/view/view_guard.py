# SPDX-License-Identifier: MIT
"""Who may hold a connection to the live window's server, and how many.

A connection is a stranger until a request of it has named the token. Strangers are few and have little time, so that
processes which connect and say nothing take no connection from the page.
"""

import asyncio

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
