# SPDX-License-Identifier: MIT
"""The live window's server with a board and a reference renderer made up here: who may look on, what a slow tab
gets, whose keys count, how it ends."""

import asyncio
import contextlib
import io
import time

import aiohttp
import pytest
from view_bench import Bench, HEIGHT, HELLO, WIDTH, bench_test, frame, read_frame, settled

from fixel.view import view_guard
from fixel.base.errors import ToolError
from fixel.view.view_board import Pump
from fixel.view.view_server import MESSAGE_MAX, Server, UNSEEN_MAX
from fixel.view.view_reference import Answer

BUILT_PROGRAMS = ()


# --- who may look on ----------------------------------------------------------------

@bench_test
async def test_the_page_and_its_files(bench):
    for path, kind, word in (("/", "text/html", "Fixel live"), ("/view.js", "text/javascript", "WebSocket"),
                             ("/view_picture.js", "text/javascript", "putDifference"),
                             ("/view_pixel.js", "text/javascript", "pixelAt"), ("/view_zoom.js", "text/javascript", "FACTORS"),
                             ("/view_keys.js", "text/javascript", "Held"), ("/view.css", "text/css", "page.css"),
                             ("/page.css", "text/css", "--paper")):
        async with bench.session.get(bench.base + path) as answer:
            text = await answer.text()
            assert answer.status == 200 and answer.content_type == kind and word in text
            assert "default-src 'self'" in answer.headers["Content-Security-Policy"]
            assert "http://" not in text.replace("ws://${location.host}${location.pathname}live", "") and "https://" not in text
    for path in ("/Makefile", "/%2e%2e/Makefile", "/../Makefile"):
        async with bench.session.get(bench.base + path) as answer:
            assert answer.status in (403, 404)


@bench_test
async def test_pages_of_other_origins_are_refused(bench):
    for headers in ({"Host": "example.org"}, {"Origin": "http://example.org"}, {"Origin": "null"}):
        async with bench.session.get(bench.base, headers=headers) as answer:
            assert answer.status == 403
        with pytest.raises(aiohttp.WSServerHandshakeError):
            await bench.tab(**headers)
    await bench.tab(Origin=bench.origin)
    assert len(bench.hub.tabs) == 1


@bench_test
async def test_it_listens_on_this_machine_alone(bench):
    assert [socket.getsockname()[0] for socket in bench.server._listening.sockets] == ["127.0.0.1"]


@bench_test
async def test_a_second_server_finds_another_port(bench):
    async with Bench() as other:
        assert other.server.port != bench.server.port
    with pytest.raises(ToolError, match=f"port {bench.server.port} .*PORT="):
        await Server(bench.hub).open(bench.server.port)


@bench_test
async def test_who_has_not_the_token_is_refused(bench):
    wrong = bench.server.token[:-1] + ("A" if bench.server.token[-1] != "A" else "B")
    for path in ("/", "/live", "/view.js", f"/{wrong}/", f"/{wrong}/live", "//", f"/x/{bench.server.token}/"):
        async with bench.session.get(bench.origin + path) as answer:
            assert answer.status == 403 and "the address that make view printed" in await answer.text(), path
    with pytest.raises(aiohttp.WSServerHandshakeError):
        await bench.session.ws_connect(f"{bench.origin}/live")
    assert not bench.hub.tabs
    async with Bench() as other:
        assert other.server.token != bench.server.token and len(other.server.token) >= 20


@bench_test
async def test_a_message_beyond_the_limit_ends_its_tab(bench):
    """Messages are bounded (SECURITY.md)."""
    tab, other = await bench.tab(), await bench.tab()
    words = '{"type": "keys", "held": 1}'
    await tab.send_str(words.ljust(MESSAGE_MAX - 1))
    await settled()
    assert bench.held == [1] and len(bench.hub.tabs) == 2
    await tab.send_str(words.ljust(MESSAGE_MAX + 1))
    assert (await tab.receive(timeout=None)).data == aiohttp.WSCloseCode.MESSAGE_TOO_BIG
    await settled()
    assert bench.held == [1, 0] and len(bench.hub.tabs) == 1
    bench.hub.show(frame(1))
    assert (await read_frame(other))[0]["number"] == 1


@bench_test
async def test_the_reference_is_asked_about_each_frame_while_a_tab_wants_its_answer(bench):
    tab = await bench.tab()
    for number, wants, asked in ((1, 0, []), (2, 1, [(1, 1), (2, 1)]), (3, 5, [(2, 5), (3, 5)]), (4, 0, [])):
        bench.asked.clear()
        await tab.send_json({"type": "wants", "wants": wants})
        await settled()
        bench.hub.show(frame(number))
        assert bench.asked == asked


@bench_test
async def test_connections_that_say_nothing_are_few(bench):
    """1,138 of them brought 14,346 lines with tracebacks."""
    held, said = [], io.StringIO()
    watching = await bench.tab()
    with contextlib.redirect_stderr(said):
        try:
            for number in range(1138):
                opened = await asyncio.open_connection("127.0.0.1", bench.server.port)
                opened[1].write(b"GET / HTTP/1.1\r\n" if number % 2 else b"")
                held.append(opened)
            await settled()
            assert len(bench.server._runner.server.connections) <= view_guard.STRANGERS_MAX + 1
            assert (await bench.session.get(f"{bench.base}/")).status == 200    # the page is served all the same
            bench.hub.show(frame(1))
            assert (await read_frame(watching))[0]["number"] == 1
        finally:
            for _, writer in held:
                writer.close()
    assert said.getvalue().count("\n") == 1 and "more than 32 connections without a request" in said.getvalue()


@bench_test
async def test_a_connection_that_says_nothing_ends(bench):
    view_guard_time, view_guard.STRANGER_TIME = view_guard.STRANGER_TIME, 0.05
    try:
        reader, writer = await asyncio.open_connection("127.0.0.1", bench.server.port)
        with contextlib.suppress(ConnectionResetError):
            assert await reader.read() == b""
        writer.close()
    finally:
        view_guard.STRANGER_TIME = view_guard_time


@bench_test
async def test_connections_of_pages_are_bounded(bench):
    said = io.StringIO()
    with contextlib.redirect_stderr(said):
        tabs = [await bench.tab() for _ in range(view_guard.TRUSTED_MAX)]
        with pytest.raises(aiohttp.ClientError):
            await bench.tab()
        await tabs[0].close()
        await settled()
        await bench.tab()
    assert said.getvalue() == "live window: more than 64 connections of pages: close some tabs\n"


def test_what_is_no_request_is_not_worth_a_line(capfd):
    async def run():
        async with Bench() as bench:
            for words in (b"\x16\x03\x01 hello\r\n\r\n", b"GET\r\n\r\n", b"GET / HTTP/9.9\r\n\r\n", b"GET / HTTP/1.1\r\n" +
                          b"A: " + b"a" * 100000 + b"\r\n\r\n", b"POST / HTTP/1.1\r\nContent-Length: -1\r\n\r\n"):
                reader, writer = await asyncio.open_connection("127.0.0.1", bench.server.port)
                with contextlib.suppress(ConnectionError):
                    writer.write(words)
                    await reader.read()
                writer.close()
    asyncio.run(run())
    assert capfd.readouterr().err == ""


@bench_test
async def test_what_makes_no_sense_ends_the_tab(bench):
    for words in ("{", "[]", '{"type": "keys"}', '{"type": "keys", "held": 256}', '{"type": "keys", "held": true}',
                  '{"type": "rate", "rate": 31}', '{"type": "rate", "rate": false}', '{"type": "rate", "rate": 30.0}',
                  '{"type": "rate"}', "[" * 4000, '{"type":' * 500, '{"type": "wants", "wants": 16}', '{"type": "what"}',
                  '{"type": "pause"}', '{"type": "pause", "paused": 1}'):
        socket = await bench.tab()
        await socket.send_str(words)
        assert (await socket.receive(timeout=None)).type == aiohttp.WSMsgType.CLOSE, words
        assert socket.close_code == 1008
    await settled()
    assert not bench.hub.tabs and not any(bench.held)


# --- frames -------------------------------------------------------------------------

@bench_test
async def test_a_frame_as_a_tab_gets_it(bench):
    socket = await bench.tab()
    bench.hub.show(frame(7))
    told, parts = await read_frame(socket)
    assert (told["number"], told["position"], told["angles"]) == (7, [1, 2, 3], [4, 5, 6])
    assert told["instructions"] == 1007 and told["counters"]["drawn"] == 9
    assert parts == [bytes([7]) * (WIDTH * HEIGHT)]


@bench_test
async def test_a_tab_that_comes_late_gets_the_newest(bench):
    bench.hub.show(frame(1))
    bench.hub.show(frame(2))
    told, _ = await read_frame(await bench.tab())
    assert told["number"] == 2


@bench_test
async def test_a_slow_tab_gets_newer_frames_and_no_backlog(bench):
    slow, quick = await bench.tab(), await bench.tab()
    for number in range(50):
        bench.hub.show(frame(number))
        assert (await read_frame(quick))[0]["number"] == number
        await quick.send_json({"type": "seen"})
        await settled()
    got = [(await read_frame(slow))[0]["number"] for _ in range(UNSEEN_MAX)]
    assert got == [0, 1]
    with pytest.raises(TimeoutError):
        await slow.receive(timeout=0.1)
    await slow.send_json({"type": "seen"})
    assert (await read_frame(slow))[0]["number"] == 49


@bench_test
async def test_no_frame_comes_twice(bench):
    socket = await bench.tab()
    bench.hub.show(frame(3))
    await read_frame(socket)
    await socket.send_json({"type": "seen"})
    await socket.send_json({"type": "keys", "held": 0})
    with pytest.raises(TimeoutError):
        await socket.receive(timeout=0.1)


# --- the reference renderer ---------------------------------------------------

@bench_test
async def test_beside_each_other_is_always_the_same_frame(bench):
    socket = await bench.tab()
    await socket.send_json({"type": "wants", "wants": 1})
    await settled()
    bench.hub.show(frame(10))
    bench.hub.show(frame(11))
    assert bench.asked == [(10, 1), (11, 1)]
    bench.hub.show(frame(12))
    with pytest.raises(TimeoutError):
        await socket.receive(timeout=0.1)   # not without the reference
    bench.hub.compare(Answer(frame(11), 1, (bytes([99]) * (WIDTH * HEIGHT), b"", b"", b"")))
    told, (pixels, double, *_) = await read_frame(socket)
    assert told["number"] == 11 and told["given"] == 1
    assert set(pixels) == {11} and set(double) == {99}


@bench_test
async def test_each_tab_gets_what_it_wants(bench):
    plain, double, lines = [await bench.tab() for _ in range(3)]
    await double.send_json({"type": "wants", "wants": 1})
    await lines.send_json({"type": "wants", "wants": 2})
    await settled()
    bench.hub.show(frame(1))
    assert bench.asked[-1] == (1, 3)
    assert (await read_frame(plain))[0]["given"] == 0
    bench.hub.compare(Answer(frame(1), 3, (bytes(WIDTH * HEIGHT), b"lines", b"", b"")))
    assert (await read_frame(double))[0]["given"] & 1
    assert (await read_frame(lines))[1][2] == b"lines"


@bench_test
async def test_the_reference_rests_if_nobody_wants_it(bench):
    socket = await bench.tab()
    bench.hub.show(frame(1))
    await socket.send_json({"type": "wants", "wants": 2})
    await settled()
    assert bench.asked == [(1, 2)]      # at once: the board may stand still
    await socket.close()
    await settled()
    bench.hub.show(frame(2))
    assert len(bench.asked) == 1


@bench_test
async def test_no_reference_for_what_it_does_not_know(bench):
    bench.hub.hello = {**HELLO, "judged": False}
    socket = await bench.tab()
    bench.hub.show(frame(1))
    await socket.send_json({"type": "wants", "wants": 3})
    await settled()
    assert not bench.asked


# --- keys and rate --------------------------------------------------------------------

@bench_test
async def test_keys_of_all_tabs_count(bench):
    one, other = await bench.tab(), await bench.tab()
    await one.send_json({"type": "keys", "held": 1})
    await settled()
    await other.send_json({"type": "keys", "held": 9})
    await settled()
    assert bench.held == [1, 9]
    await other.send_json({"type": "keys", "held": 8})
    await settled()
    assert bench.held[-1] == 9
    await one.close()
    await settled()
    assert bench.held[-1] == 8          # whoever leaves lets go
    await other.close()
    await settled()
    assert bench.held[-1] == 0


@bench_test
async def test_the_rate_is_slow_while_nobody_looks_on(bench):
    socket = await bench.tab()
    assert bench.pump.rates == [30]
    await socket.send_json({"type": "rate", "rate": 0})
    await settled()
    await socket.close()
    await settled()
    assert bench.pump.rates == [30, 0, 1]
    await bench.tab()
    assert bench.pump.rates[-1] == 0


@bench_test
async def test_every_tab_is_told_the_rate_and_the_pause(bench):
    one, other = await bench.tab(), await bench.tab()
    for words, state in (({"type": "rate", "rate": 60}, (60, False)), ({"type": "pause", "paused": True}, (60, True)),
                         ({"type": "pause", "paused": False}, (60, False)), ({"type": "step"}, (60, True))):
        await one.send_json(words)
        for socket in (one, other):
            assert await socket.receive_json(timeout=None) == {"type": "state", "rate": state[0], "paused": state[1], "stopped": False, "trouble": ""}
    await other.send_json({"type": "restart"})
    await settled()
    assert bench.pump.others == ["pause", "go on", "pause", "step", "restart"]


@bench_test
async def test_the_frame_after_a_restart_may_have_the_number_of_the_one_before(bench):
    socket = await bench.tab()
    for _ in range(2):
        bench.hub.show(frame(0))
        assert (await read_frame(socket))[0]["number"] == 0


# --- the end --------------------------------------------------------------------------

def test_every_tab_is_told_why_it_ended():
    async def run():
        async with Bench() as bench:
            tabs = [await bench.tab() for _ in range(2)]
            bench.hub.end(ToolError("the board fell over"))
            bench.hub.end(ToolError("a later one"))
            assert bench.hub.ended.is_set()
            closing = asyncio.create_task(bench.server.close())
            for tab in tabs:
                assert await tab.receive_json(timeout=None) == {"type": "ended", "message": "the board fell over"}
                assert (await tab.receive(timeout=None)).type == aiohttp.WSMsgType.CLOSE
            await closing
    asyncio.run(run())


# --- the pump -------------------------------------------------------------------------

class Drawn:
    """A board that draws at once; it ends after so many frames."""

    def __init__(self, frames, error=None):
        self.frames, self.error, self.waits, self.stopped = frames, error, [], False
        self.number, self.looks = 0, 0

    def frame(self, waits):
        self.waits.append(waits)
        if self.stopped:
            return None
        if len(self.waits) > self.frames:
            raise self.error or ToolError("it ended")
        self.number += 1
        return self.number

    def restart(self):
        self.number = 0

    def look(self):
        self.looks += 1
        if self.error:
            raise self.error

    def stop(self):
        self.stopped = True


def test_the_pump_keeps_time():
    shown, failed = [], []
    board = Drawn(1000)
    started = time.monotonic()
    pump = Pump(board, 50, lambda one: shown.append(time.monotonic() - started), failed.append)
    while len(shown) < 30 and not failed:   # later on a busy machine, but never sooner
        time.sleep(0.01)
    pump.close()
    assert not failed and shown[29] >= 28 / 50, shown
    assert all(board.waits)


def test_the_pump_as_fast_as_it_goes():
    board, failed = Drawn(2000), []
    pump = Pump(board, 1, lambda one: None, failed.append)
    while not board.waits:
        time.sleep(0.01)
    pump.set_rate(0)    # at once, not after the second that it waits
    while not failed:
        time.sleep(0.01)
    pump.close()
    assert len(failed) == 1 and board.waits[0] and not board.waits[-1]


def wait_for(condition):
    """However long it takes."""
    while not condition():
        time.sleep(0.002)


def test_a_pump_that_is_paused_shows_a_frame_for_each_step():
    shown, failed = [], []
    board = Drawn(10 ** 9)
    pump = Pump(board, 30, shown.append, failed.append)
    wait_for(lambda: shown)
    pump.pause(True)
    pump.step()
    pump.restart()      # and its first frame
    wait_for(lambda: board.number == 1 and shown[-1] == 1)
    for number in range(2, 20):
        pump.step()
        wait_for(lambda: shown[-1] == number)
    wait_for(lambda: board.looks)       # while it waits, it sees whether the board has ended
    assert shown[-1] == board.number == 19
    pump.pause(False)
    wait_for(lambda: shown[-1] > 25)
    pump.close()
    assert not failed


def test_a_pump_without_a_limit_stops_at_a_frame_that_it_shows():
    shown = []
    board = Drawn(10 ** 9)
    pump = Pump(board, 0, shown.append, shown.append)
    wait_for(lambda: shown)
    pump.pause(True)
    wait_for(lambda: board.looks)
    assert board.waits[-1] and not board.waits[-2] and shown[-1] == board.number
    pump.close()


def test_a_board_that_ends_while_it_is_paused():
    failed = []
    board = Drawn(10 ** 9)
    pump = Pump(board, 30, lambda one: None, failed.append)
    pump.pause(True)
    board.error = ToolError("it ended")
    wait_for(lambda: failed)
    pump.close()
    assert failed == [board.error]
