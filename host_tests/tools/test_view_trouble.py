# SPDX-License-Identifier: MIT
"""What reaches the live window's server from others: it answers, prints nothing or one line, and goes on."""

import asyncio
import base64
import contextlib
import io
import json
import logging
import os
import struct
import zlib

import pytest
from view_bench import Bench, bench_test, frame, read_frame, settled

from fixel.view import view_guard
from fixel.view.view_server import MESSAGE_MAX
from fixel.view.view_guard import Troubles

BUILT_PROGRAMS = ()
KEY = base64.b64encode(bytes(16))
UPGRADE = (b"Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: " + KEY +
           b"\r\n")
CONTINUED, TEXT, BINARY, CLOSE, PING, PONG = 0, 1, 2, 8, 9, 10
LAST, COMPRESSED = 0x80, 0x40


async def send(bench, data, whole=True):
    """The head of what the server answers to these bytes. whole: it is to answer, whatever else may come."""
    reader, writer = await asyncio.open_connection("127.0.0.1", bench.server.port)
    answer = b""
    with contextlib.suppress(ConnectionError):
        writer.write(data)
        if not whole:
            writer.write_eof()
        with contextlib.suppress(*(() if whole else (asyncio.IncompleteReadError,))):
            answer = await reader.readuntil(b"\r\n\r\n")
            if status(answer) == 100:   # it asks for the rest
                answer = await reader.readuntil(b"\r\n\r\n")
    writer.close()
    return answer


def status(answer):
    return int(answer.split(b" ", 2)[1])


def request(bench, line, *headers, host=None):
    host = f"127.0.0.1:{bench.server.port}".encode() if host is None else host
    return b"".join(each + b"\r\n" for each in (line + b" HTTP/1.1", b"Host: " + host, *headers, b""))


def masked(first, payload, length=None):
    """A frame as a browser sends it. first: kind and flags; length: another one than the payload's."""
    length = len(payload) if length is None else length
    size = struct.pack(">B", 0x80 | length) if length < 126 else struct.pack(">BH", 0xFE, length) \
        if length < 65536 else struct.pack(">BQ", 0xFF, length)
    return bytes([first]) + size + bytes(4) + payload      # a mask of zeros changes nothing


@contextlib.contextmanager
def heard():
    """What is printed on stderr meanwhile, also by loggers that have no handler."""
    said = io.StringIO()
    with contextlib.redirect_stderr(said):
        yield said


# --- requests -----------------------------------------------------------------------

@pytest.mark.parametrize("line", [b"OPTIONS *", b"CONNECT a:1", b"GET http://x"])
def test_a_path_without_a_slash_is_refused(line):
    async def run():
        async with Bench() as bench:
            for _ in range(3):
                assert status(await send(bench, request(bench, line))) == 403
    with heard() as said:
        asyncio.run(run())
    assert said.getvalue() == ""


LINES = (b"GET *", b"OPTIONS /", b"CONNECT /", b"CONNECT *", b"CONNECT a", b"CONNECT [::1]:1", b"CONNECT " + b"a" * 9000,
         b"TRACE /", b"QUERY /", b"PRI *", b"get /", b"G\x00T /", b"GET", b"GET  ", b"GET ?", b"GET #", b"GET x", b"GET //",
         b"GET ///", b"GET http:x", b"GET http://", b"GET http://[", b"GET http://[::1]", b"GET http://a:99999/",
         b"GET http://a:b@c", b"GET file:///etc/passwd", b"GET //x/", b"GET /%", b"GET /%zz", b"GET /%00", b"GET /%2f",
         b"GET /%ff%fe", b"GET /%ed%a0%80", b"GET /\xff", b"GET /\xed\xa0\x80", b"GET /\xc3\xa9", b"GET /" + b"%41" * 2000,
         b"GET /" + b"a" * 9000, b"GET /?" + b"&a=b" * 1000, b"GET /../../etc/passwd", b"GET /\t/", b"GET / HTTP/1.1 x")
HEADERS = ((b"Host: a",), (b"Host: \xff",), (b"Origin: \xff",), (b"Origin: http://",), (b"A: \x00",), (b"A : b",), (b": b",),
           (b"A: " + b"a" * 9000,), (b"a" * 9000 + b": b",), (b"A: b",) * 5000, (b" folded",), (b"A: b\r\n folded",),
           (b"Cookie: " + b"=;" * 1000,), (b"Cookie: a=\xff",), (b"Range: bytes=9-1",), (b"If-Modified-Since: x",),
           (b"Expect: 100-continue",), (b"Expect: x",), (b"Connection: close, upgrade, x",), (b"Upgrade: h2c",),
           (b"Content-Type: multipart/form-data",), (b"Content-Encoding: gzip", b"Content-Length: 3"),
           (b"Content-Length: -1",), (b"Content-Length: 1", b"Content-Length: 2"), (b"Content-Length: " + b"9" * 40,),
           (b"Transfer-Encoding: chunked",), (b"Transfer-Encoding: x",), (b"Transfer-Encoding: chunked", b"Content-Length: 1"),
           (b"Accept: text/html",), (b"X-Forwarded-For: \xff",))


def test_no_request_without_the_token_is_worth_a_line(capfd):
    async def run():
        async with Bench() as bench:
            watching = await bench.tab()
            for line in LINES:
                answer = await send(bench, request(bench, line))
                assert status(answer) in (400, 403), (line, answer[:99])
            for headers in HEADERS:
                for line in (b"GET /", b"POST /", b"OPTIONS *"):
                    answer = await send(bench, request(bench, line, *headers))
                    assert status(answer) in (400, 403, 417), (headers, answer[:99])
            for host in (b"", b"\xff", b"example.org", b"127.0.0.1", b"localhost", b"127.0.0.1:99999", b"a" * 5000):
                assert status(await send(bench, request(bench, b"GET /", host=host))) in (400, 403)
            for words in (b"", b"\r\n" * 1000, b"\x00" * 1000, os.urandom(1000), b"POST /\r\n\r\n5\r\n"):
                assert b" 200 " not in await send(bench, words, whole=False)
            bench.hub.show(frame(1))
            assert (await read_frame(watching))[0]["number"] == 1
    asyncio.run(run())
    assert capfd.readouterr().err == ""


def test_no_upgrade_without_the_token(capfd):
    async def run():
        async with Bench() as bench:
            for line in (b"GET /live", b"GET /", b"OPTIONS *", b"GET http://x", b"POST /live"):
                for tail in (b"", masked(LAST | TEXT, b"{}"), b"\xff" * 100, b"GET / HTTP/1.1\r\n\r\n", request(bench, b"OPTIONS *")):
                    assert status(await send(bench, request(bench, line, UPGRADE[:-2]) + tail)) == 403
            assert not bench.hub.tabs
    asyncio.run(run())
    assert capfd.readouterr().err == ""


@bench_test
async def test_requests_of_the_page_that_make_no_sense(bench):
    """They name the token. A warning of aiohttp's is one line, whatever the page asks for."""
    base = f"/{bench.server.token}".encode()
    with heard() as said:
        for line in (b"POST " + base + b"/", b"GET " + base, b"GET " + base + b"/%2e%2e/x", b"GET " + base + b"/view.js/x",
                     b"GET " + base + b"/\xff", b"GET " + base + b"//", b"GET " + base + b"/live"):
            assert status(await send(bench, request(bench, line))) in (400, 403, 404, 405), line
        assert status(await send(bench, request(bench, b"GET http://x" + base + b"/%76iew.js"))) == 200
        live = b"GET " + base + b"/live"
        for headers in (UPGRADE.replace(KEY, b"x"), UPGRADE.replace(KEY, b"\xff"), UPGRADE.replace(b"13", b"99"),
                        UPGRADE.replace(b"13", b"\xff"), UPGRADE.replace(b"websocket", b"\xff")):
            assert status(await send(bench, request(bench, live, headers[:-2]))) == 400, headers
        for number in range(5):
            protocol = b"Sec-WebSocket-Protocol: %d\xff\x1b[31m" % number + b"a" * 5000
            assert status(await send(bench, request(bench, live, UPGRADE + protocol))) in (101, 400)
            protocol = b"Sec-WebSocket-Protocol: %d, " % number + b"a" * 5000
            assert status(await send(bench, request(bench, live, UPGRADE + protocol))) == 101
    assert said.getvalue().count("\n") == 1 and len(said.getvalue()) < 200 and "\x1b" not in said.getvalue()


# --- frames -------------------------------------------------------------------------

KEYS = b'{"type": "keys", "held": 1}'
FRAMES = {      # what a tab sends -> the code that ends it, None where it goes on
    "text": (masked(LAST | TEXT, KEYS), None),
    "fragments": (masked(TEXT, KEYS[:9]) + masked(CONTINUED, b"") + masked(LAST | CONTINUED, KEYS[9:]), None),
    "ping between": (masked(TEXT, KEYS[:9]) + masked(LAST | PING, b"x") + masked(LAST | CONTINUED, KEYS[9:]), None),
    "pong": (masked(LAST | PONG, b"x") + masked(LAST | TEXT, KEYS), None),
    "many pings": (masked(LAST | PING, b"x" * 125) * 200 + masked(LAST | TEXT, KEYS), None),
    "binary": (masked(LAST | BINARY, KEYS), 1008),
    "no text": (masked(LAST | TEXT, b""), 1008),
    "not UTF-8": (masked(LAST | TEXT, b"\xff\xfe"), 1007),
    "surrogate": (masked(LAST | TEXT, b'{"type": "\xed\xa0\x80"}'), 1007),
    "escaped surrogate": (masked(LAST | TEXT, b'{"type": "\\ud800"}'), 1008),
    "long number": (masked(LAST | TEXT, b'{"type": "keys", "held": ' + b"9" * 4050 + b"}"), 1008),
    "list as a type": (masked(LAST | TEXT, b'{"type": []}'), 1008),
    "list as a rate": (masked(LAST | TEXT, b'{"type": "rate", "rate": []}'), 1008),
    "not a number": (masked(LAST | TEXT, b'{"type": "keys", "held": NaN}'), 1008),
    "compressed": (masked(LAST | COMPRESSED | TEXT, zlib.compress(KEYS, wbits=-15)), 1002),
    "compressed bomb": (masked(LAST | COMPRESSED | TEXT, zlib.compress(bytes(1 << 20), wbits=-15)), 1002),
    "reserved bits": (masked(LAST | 0x30 | TEXT, KEYS), 1002),
    "reserved kind": (masked(LAST | 3, KEYS), 1002),
    "reserved control": (masked(LAST | 11, KEYS), 1002),
    "nothing to continue": (masked(LAST | CONTINUED, KEYS), 1002),
    "text between": (masked(TEXT, KEYS[:9]) + masked(LAST | TEXT, KEYS), 1002),
    "ping in fragments": (masked(PING, b"x"), 1002),
    "long ping": (masked(LAST | PING, b"x" * 126), 1002),
    "too long": (masked(LAST | TEXT, KEYS.ljust(MESSAGE_MAX + 1)), 1009),
    "promises much": (masked(LAST | TEXT, KEYS, 1 << 62), 1009),
    "fragments too long": (masked(TEXT, b" " * 2000) + masked(CONTINUED, b" " * 2000) * 2 +
                           masked(LAST | CONTINUED, KEYS), 1009),
    "many empty fragments": (masked(TEXT, b"") + masked(CONTINUED, b"") * 5000 + masked(LAST | CONTINUED, KEYS), None),
    "close": (masked(LAST | CLOSE, struct.pack(">H", 1000)), 1000),
    "close without a code": (masked(LAST | CLOSE, b""), 1000),
    "close with half a code": (masked(LAST | CLOSE, b"\x03"), 1002),
    "close with another code": (masked(LAST | CLOSE, struct.pack(">H", 5)), 1002),
    "close that is not UTF-8": (masked(LAST | CLOSE, struct.pack(">H", 1000) + b"\xff"), 1007),
    "close with words": (masked(LAST | CLOSE, struct.pack(">H", 3000) + b"bye"), 1000),
    "random": (b"\xff" * 1000, 1002),
}


async def tab(bench):
    """A page's websocket without a browser's care, greeted."""
    reader, writer = await asyncio.open_connection("127.0.0.1", bench.server.port)
    writer.write(request(bench, f"GET /{bench.server.token}/live".encode(), UPGRADE[:-2]))
    assert status(await reader.readuntil(b"\r\n\r\n")) == 101
    assert json.loads((await receive(reader))[1]) == bench.hub.hello
    assert json.loads((await receive(reader))[1]) == bench.hub.state
    return reader, writer


async def receive(reader):
    """(kind, payload) of a frame of the server's; None at the end."""
    try:
        first, length = await reader.readexactly(2)
        if length == 126:
            (length,) = struct.unpack(">H", await reader.readexactly(2))
        return first & 15, await reader.readexactly(length)
    except (asyncio.IncompleteReadError, ConnectionError):
        return None


def test_frames_well_formed_and_not(capfd):
    async def run():
        async with Bench() as bench:
            for name, (data, ended_by) in FRAMES.items():
                bench.held.clear()
                reader, writer = await tab(bench)
                writer.write(data)
                if ended_by is None:
                    writer.write(masked(LAST | CLOSE, struct.pack(">H", 1000)))
                while (got := await receive(reader)) is not None and got[0] != CLOSE:
                    assert got[0] == PONG, name
                code = struct.unpack(">H", got[1][:2])[0] if got and got[1] else 1000
                assert got is not None and code == (ended_by or 1000), (name, got)
                writer.close()
                for _ in range(100):
                    await settled()
                    if not bench.hub.tabs:
                        break
                assert not bench.hub.tabs and bench.held == ([1, 0] if ended_by is None else [0]), (name, bench.held)
    asyncio.run(run())
    assert capfd.readouterr().err == ""


@bench_test
async def test_bytes_at_random_in_place_of_frames(bench):
    with heard() as said:
        for number in range(60):
            _, writer = await tab(bench)
            writer.write(os.urandom(200) if number % 2 else masked(os.urandom(1)[0], os.urandom(50)))
            await settled()
            writer.transport.abort()
        watching = await bench.tab()
        bench.hub.show(frame(1))
        assert (await read_frame(watching))[0]["number"] == 1
    assert said.getvalue() == ""


# --- one line a kind ------------------------------------------------------------------

@bench_test
async def test_an_error_of_the_server_itself_is_one_line(bench):
    """A defect that this file does not know must not fill the log either."""
    async def fail(*_):
        raise ZeroDivisionError("words of a stranger\n\x1b[31m" + "x" * 1000)
    bench.server._heed = lambda *_: 1 // 0
    bench.hub.join = lambda one: one.wake.set()
    with heard() as said:
        for _ in range(5):
            _, writer = await tab(bench)
            writer.write(masked(LAST | TEXT, KEYS))
            await settled()
            writer.close()
        assert said.getvalue().count("\n") == 1 and "ZeroDivisionError at view_server.py:" in said.getvalue()
        for _ in range(5):
            task = asyncio.create_task(fail())
            await settled()
            del task        # asyncio's "exception was never retrieved"
        asyncio.get_running_loop().call_soon(lambda: [].pop())
        await settled()
        assert (await bench.session.get(f"{bench.base}/")).status == 200
    lines = said.getvalue().splitlines()
    assert len(lines) == 3 and all(len(line) < 200 and line.isprintable() for line in lines), lines
    assert all(line.startswith("live window: ") for line in lines)


def test_the_loggers_are_given_back():
    def state():
        return [(logging.getLogger(name).propagate, len(logging.getLogger(name).handlers)) for name in view_guard.LOGGERS]

    before, one, other = state(), Troubles(), Troubles()
    one.listen()
    other.listen()
    one.leave()
    assert not any(propagates for propagates, _ in state())
    other.leave()
    other.leave()
    assert state() == before


def test_kinds_are_said_once_each():
    with heard() as said:
        troubles = Troubles()
        for _ in range(3):
            troubles.say("a", "one")
            troubles.say("b", "other")
    assert said.getvalue() == "live window: one\nlive window: other\n"
