# SPDX-License-Identifier: MIT
"""A live window's server with a board and a reference renderer made up here, and a page of it."""

import asyncio
import json
import struct

import aiohttp
import numpy

from fixel.board import dump
from fixel.view.view_server import Hub, Server

WIDTH, HEIGHT = 8, 4
HELLO = {"type": "hello", "board": "made-up", "judged": True}


def frame(number):
    pixels = numpy.full((HEIGHT, WIDTH), number & 255, numpy.uint8)
    return dump.Frame(number, (1, 2, 3), (4, 5, 6), pixels, dict.fromkeys(dump.COUNTERS, 9), 0, 1000 + number)


class Orders:
    """A pump that does nothing; what it was told is in lists."""

    def __init__(self):
        self.rates, self.others, self.pointed = [], [], set()

    def set_rate(self, rate):
        self.rates.append(rate)

    def pause(self, paused):
        self.others.append("pause" if paused else "go on")

    def step(self):
        self.others.append("step")

    def restart(self):
        self.others.append("restart")

    def point(self, pixels):
        self.pointed = pixels


class Bench:
    """A server with its hub; what the hub told board, reference and pump is in lists."""

    def __init__(self):
        self.held, self.asked = [], []
        self.hub = Hub(HELLO, self.held.append, lambda one, wants: self.asked.append((one.number, wants)))
        self.hub.pump = self.pump = Orders()
        self.server = Server(self.hub)

    async def __aenter__(self):
        await self.server.open()
        self.origin = f"http://127.0.0.1:{self.server.port}"
        self.base = self.server.address.removesuffix("/")
        self.session = aiohttp.ClientSession()
        return self

    async def __aexit__(self, *_):
        await self.session.close()
        await self.server.close()

    async def tab(self, **headers):
        """A page's websocket, greeted and told the state."""
        socket = await self.session.ws_connect(f"{self.base}/live", headers=headers)
        assert await socket.receive_json(timeout=None) == self.hub.hello
        assert await socket.receive_json(timeout=None) == self.hub.state
        await settled()
        return socket


async def settled():
    """Lets messages that are under way arrive: the loop looks that often for what has come, however busy the machine is."""
    for _ in range(20):
        await asyncio.sleep(0.0025)


async def read_frame(socket):
    data = await socket.receive_bytes(timeout=None)
    (length,) = struct.unpack_from("<I", data)
    told = json.loads(data[4:4 + length])
    parts, at = [], 4 + length
    for size in told["bytes"]:
        parts.append(data[at:at + size])
        at += size
    assert at == len(data)
    return told, parts


def bench_test(function):
    """A test that is a coroutine with a bench."""
    def test():
        async def run():
            async with Bench() as bench:
                await function(bench)
        asyncio.run(run())
    test.__name__ = function.__name__
    return test
