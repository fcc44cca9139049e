# SPDX-License-Identifier: MIT
"""The live window's web server, for this machine alone: a page, and a websocket for each tab.

To a tab: text messages {"type": "hello" | "state" | "picked" | "ended", ...}, and frames as
binary messages: u32 length of a JSON text, the text, the frame's pixels, and the
parts of the reference renderer's answer (view_reference.py); the text says how
many bytes each of these has.
From a tab: {"type": "keys", "held": bits}, {"type": "rate", "rate": frames a
second}, {"type": "pause", "paused": bool}, {"type": "step"}, {"type": "restart"},
{"type": "wants", "wants": bits}, {"type": "point", "pixel": [x, y] | null}, {"type": "seen"} for each frame that it has
shown. A tab is sent the newest frame, and another only when it has seen the one
before the last: where it is slow it misses frames and lags behind none.

Whoever has the address may look on: it holds a random token, which every request must name.
"""

import asyncio
import base64
import hmac
import json
import pathlib
import secrets
import struct

from aiohttp import WSCloseCode, WSMsgType, web

from fixel.view import view_drawing, view_reference
from fixel.base.errors import ToolError
from fixel.view.view_guard import Guard
from fixel.view.view_board import IDLE_RATE
from fixel.view.view_guard import Troubles

HOST = "127.0.0.1"
PORT = 8065             # after the chapter, where it is free and no other is asked for
RATES = (30, 60, 0)     # frames a second; 0: as fast as it goes
KEYS_ALL = 0xFF         # FXL_KEY_ALL of fixel/player.h
UNSEEN_MAX = 2          # frames on their way to a tab
MESSAGE_MAX = 4096      # bytes from a tab; SECURITY.md says so
HEARTBEAT = 20.0        # seconds
FAREWELL = 1.0          # seconds for the last words to a tab
TOKEN_BYTES = 16        # 128 random bits
PAGE = pathlib.Path(__file__).resolve().parents[2] / "templates"
FILES = {"/": ("view.html", "text/html"), **{f"/{name}": (name, "text/css") for name in ("page.css", "view.css", "site.css")},
         **{f"/{file.name}": (file.name, "text/javascript") for file in sorted(PAGE.glob("*.*js")) if not file.name.startswith("pico")}}
HEADERS = {"Content-Security-Policy": "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; img-src 'self' data:", "Cache-Control": "no-store",
           "X-Content-Type-Options": "nosniff", "Referrer-Policy": "no-referrer"}


class Tab:
    """One page that looks on."""

    def __init__(self, socket):
        self.socket = socket
        self.keys = self.wants = self.unseen = 0
        self.sent = None    # the frame that was sent last, and the parts of the reference that came with it
        self.told = None    # the state that it was told last
        self.greeting = None    # the hello that it was told last
        self.pointed = self.picked = None   # a pixel, and what it was told last of what is there
        self.wake = asyncio.Event()

    def take(self, message, hub):
        """What the page says; ValueError where it makes no sense."""
        kind = message.get("type")
        if kind == "keys":
            self.keys = bits(message.get("held"), KEYS_ALL)
            hub.keys_changed()
        elif kind == "wants":
            wants = bits(message.get("wants"), view_reference.WANTS_ALL)
            self.wants = wants if hub.hello["judged"] else 0
            hub.wants_changed()
        elif kind == "point":
            self.pointed = pixel_of(message.get("pixel"), hub.hello)
            hub.points_changed()
        elif kind == "rate":
            hub.choose_rate(one_of(message.get("rate"), RATES))
        elif kind == "pause":
            hub.pause(truth(message.get("paused")))
        elif kind == "step":
            hub.step()
        elif kind == "restart":
            hub.restart()
        elif kind == "seen":
            self.unseen = max(0, self.unseen - 1)
        else:
            raise ValueError("not a message of the page's")
        self.wake.set()


def bits(value, every):
    if type(value) is not int or value & ~every:    # a bool is an int, too
        raise ValueError("not bits of that kind")
    return value


def pixel_of(value, head):
    """(x, y), or None; a pixel of a frame of a board that says which face is there."""
    if value is None:
        return None
    if not (head.get("picks") and isinstance(value, list) and len(value) == 2 and all(type(each) is int for each in value)
            and 0 <= value[0] < head["width"] and 0 <= value[1] < head["height"]):
        raise ValueError("not a pixel")
    return tuple(value)


def one_of(value, every):
    if type(value) is not int or value not in every:    # False == 0, 30.0 == 30
        raise ValueError("not one of these numbers")
    return value


def truth(value):
    if type(value) is not bool:
        raise ValueError("not true or false")
    return value


def first_part(path):
    """What is between the first two slashes. A request may have a path without one: OPTIONS *, CONNECT host:port."""
    return (path.split("/", 2) + [""])[1]


class Hub:
    """What the tabs share: the board's newest frame, the reference's newest answer, keys, rate, whether it is paused.
    For the thread of the event loop only. The pump (view_board.py) is set before a tab joins."""

    def __init__(self, hello, hold, ask):
        self.hello = hello
        self.pump = None
        self._hold, self._ask = hold, ask
        self.tabs = set()
        self.rate, self.paused = RATES[0], False
        self.frame = self.answer = None
        self.picks = {}     # pixel that is pointed at -> what is there, as a message
        self._troubles = {}     # of the program: "build" or "run" -> what is wrong with it
        self._wants = 0
        self._packed = None     # frame, parts of the reference, message: the last that was made
        self.error = None
        self.ended = asyncio.Event()

    # --- from the board ---------------------------------------------------------------

    def show(self, frame):
        """A new frame of the board's."""
        self.frame = frame
        if self._wants:
            self._ask(frame, self._wants)
        self._wake_all()

    def compare(self, answer):
        """The reference renderer's answer about a frame."""
        self.answer = answer
        self._wake_all()

    def picked(self, number, pixel, answer):
        """What the board's own renderer says is at a pixel of a frame: (status, instance, face)."""
        self.picks[pixel] = {"type": "picked", "number": number, "pixel": pixel,
                             **dict(zip(("status", "instance", "face"), answer))}
        self._wake_all()

    def stumble(self, kind, error):
        """What is wrong with the program; None: nothing any more. The last frame stays."""
        self._troubles[kind] = error.shown() if error else ""
        self._wake_all()

    def begin(self, hello):
        """The program runs anew, and may draw frames of another size: then no frame stays."""
        if hello != self.hello:
            self.hello, self.frame, self.answer, self._packed = hello, None, None, None
            for tab in self.tabs:
                tab.pointed = None      # the page says it again
        self.picks.clear()
        self.points_changed()
        self.stumble("run", None)

    def end(self, error=None):
        """No more frames will come."""
        if not self.ended.is_set():
            self.error = error
            self.ended.set()

    # --- from the tabs ----------------------------------------------------------------

    def keys_changed(self):
        held = 0
        for tab in self.tabs:
            held |= tab.keys
        self._hold(held)

    def wants_changed(self):
        self._wants = 0
        for tab in self.tabs:
            self._wants |= tab.wants
        if self._wants and self.frame:
            self._ask(self.frame, self._wants)

    def points_changed(self):
        pointed = {tab.pointed for tab in self.tabs if tab.pointed}
        self.picks = {pixel: said for pixel, said in self.picks.items() if pixel in pointed}
        if self.hello.get("picks"):
            self.pump.point(pointed)

    def choose_rate(self, rate):
        self.rate = rate
        self._pace()

    def pause(self, paused):
        """Whether the board waits until it is told to go on."""
        self.paused = paused
        self.pump.pause(paused)
        self._wake_all()

    def step(self):
        """One frame; then the board is paused."""
        self.pause(True)
        self.pump.step()

    def restart(self):
        """Back to the start: the board is powered on anew. Where it is paused it draws its first frame."""
        self.pump.restart()

    def _pace(self):
        self.pump.set_rate(self.rate if self.tabs else IDLE_RATE)
        self._wake_all()

    @property
    def state(self):
        """What a tab is told whenever it has changed."""
        return {"type": "state", "rate": self.rate, "paused": self.paused,
                "stopped": bool(self._troubles.get("run")), "trouble": "\n".join(filter(None, self._troubles.values()))}

    def join(self, tab):
        self.tabs.add(tab)
        self._pace()
        tab.wake.set()

    def leave(self, tab):
        self.tabs.discard(tab)
        self.keys_changed()
        self.wants_changed()
        self.points_changed()
        self._pace()

    def _wake_all(self):
        for tab in self.tabs:
            tab.wake.set()

    # --- to the tabs ------------------------------------------------------------------

    def newest(self, tab):
        """(what identifies it, message) of the newest that a tab can be shown; None where there is none
        that it has not got."""
        answer = self.answer if tab.wants else view_reference.Answer(self.frame, 0, ())
        if answer is None or answer.frame is None or tab.wants & ~answer.given:
            return None     # the board or the reference renderer is drawing it
        frame = answer.frame
        if tab.sent is not None and tab.sent[0] is frame and tab.sent[1] == answer.given:
            return None
        if self._packed is None or self._packed[0] is not frame or self._packed[1] != answer.given:
            self._packed = frame, answer.given, pack(answer)
        return (frame, answer.given), self._packed[2]


def pack(answer):
    """A frame, and what the reference renderer says of it, as a binary message."""
    frame = answer.frame
    text = json.dumps({"number": frame.number, "position": frame.position, "angles": frame.angles,
                       "counters": frame.counters, "clamped": frame.clamped, "instructions": frame.instructions,
                       "given": answer.given,
                       "bytes": [frame.pixels.nbytes, *map(len, answer.parts)]}).encode()
    return b"".join((struct.pack("<I", len(text)), text, frame.pixels.tobytes(), *answer.parts))


def hello(program, scene, head, judged=True, picks=False):
    """What a tab must know before the first frame. judged: the reference renderer can draw what the board draws. picks: the
    board says which face is at a pixel."""
    return {"type": "hello", "board": program.board, "cpu": program.cpu, "scene": str(scene), "width": head.width,
            "height": head.height, "palette": base64.b64encode(head.palette).decode(), "rates": RATES,
            "judged": judged, "picks": picks}


class Server:
    """The server on a port of this machine. drawing: a view_drawing.Drawing, the page beside the window's."""

    def __init__(self, hub, drawing=None):
        self.hub = hub
        self.port = None
        self.token = secrets.token_urlsafe(TOKEN_BYTES)
        application = web.Application(middlewares=[self._only_invited], client_max_size=view_drawing.MOST)
        for path in FILES:
            application.router.add_get(f"/{self.token}{path}", self._file)
        application.router.add_get(f"/{self.token}/live", self._live)
        if drawing:
            application.add_routes(drawing.routes(f"/{self.token}", HEADERS))
        self._runner = web.AppRunner(application, access_log=None, handle_signals=False,
                                     shutdown_timeout=FAREWELL)
        self._troubles = Troubles()
        self._guard = self._listening = None

    @property
    def address(self):
        """The page's."""
        return f"http://{HOST}:{self.port}/{self.token}/"

    async def open(self, port=None):
        """Listens. port: None for the usual one, or any that is free."""
        await self._runner.setup()
        self._guard = Guard(self._runner.server, self._troubles)
        for choice in ([port] if port else [PORT, 0]):
            try:
                self._listening = await self._guard.listen(HOST, choice)
            except OSError as error:
                if choice == port:
                    raise ToolError(f"cannot listen on port {port} of {HOST}: {error.strerror}; "
                                    "choose another with PORT=") from error
                continue
            self.port = self._listening.sockets[0].getsockname()[1]
            self._troubles.listen()
            return
        raise ToolError(f"no port of {HOST} is free")

    async def close(self):
        """Says good-bye to the tabs and ends."""
        error = self.hub.error
        words = json.dumps({"type": "ended", "message": str(error) if error else ""})
        if self._listening is not None:
            self._listening.close()
        await asyncio.gather(*(self._part(tab, words) for tab in list(self.hub.tabs)))
        if self._guard is not None:
            self._guard.close()
        await self._runner.cleanup()
        self._troubles.leave()

    @staticmethod
    async def _part(tab, words):
        try:
            async with asyncio.timeout(FAREWELL):
                await tab.socket.send_str(words)
                await tab.socket.close(code=WSCloseCode.GOING_AWAY)
        except (TimeoutError, ConnectionError):
            pass    # it went first

    # --- requests ---------------------------------------------------------------------

    @web.middleware
    async def _only_invited(self, request, handler):
        """Refuses who has not the token, pages of other origins, and names of ours that others made up."""
        names = {f"{HOST}:{self.port}", f"localhost:{self.port}"}
        origin = request.headers.get("Origin")
        if request.headers.get("Host") not in names or \
                (origin is not None and origin.removeprefix("http://") not in names):
            raise web.HTTPForbidden(text="this window is for this machine's own browser\n")
        if not hmac.compare_digest(first_part(request.path).encode(errors="replace"), self.token.encode()):
            raise web.HTTPForbidden(text="open the address that make view printed: it ends with a token\n")
        self._guard.trust(request.transport)
        return await handler(request)

    @staticmethod
    async def _file(request):
        name, kind = FILES["/" + request.path.rsplit("/", 1)[1]]
        return web.Response(text=(PAGE / name).read_text(encoding="utf-8"), content_type=kind, charset="utf-8",
                            headers=HEADERS)

    async def _live(self, request):
        socket = web.WebSocketResponse(heartbeat=HEARTBEAT, max_msg_size=MESSAGE_MAX, compress=False)
        try:
            await socket.prepare(request)
        except ValueError as error:     # of base64: a key that is not ASCII
            raise web.HTTPBadRequest(text="not a websocket's key\n") from error
        tab = Tab(socket)
        self.hub.join(tab)
        feeder = asyncio.create_task(self._feed(tab))
        try:
            async for message in socket:
                if not self._heed(tab, message):
                    await socket.close(code=WSCloseCode.POLICY_VIOLATION, message=b"not understood")
        finally:
            feeder.cancel()
            self.hub.leave(tab)
        return socket

    def _heed(self, tab, message):
        """Whether a message of a tab's made sense."""
        try:
            said = json.loads(message.data) if message.type == WSMsgType.TEXT else None
            if not isinstance(said, dict):
                return False
            tab.take(said, self.hub)
        except (ValueError, RecursionError):    # the latter of JSON that is nested too deeply
            return False
        return True

    async def _feed(self, tab):
        """Sends a tab the newest, for as long as it is there."""
        try:
            while True:
                await tab.wake.wait()
                tab.wake.clear()
                if tab.greeting is not self.hub.hello:
                    tab.greeting = self.hub.hello
                    await tab.socket.send_str(json.dumps(tab.greeting))
                if tab.told != self.hub.state:
                    tab.told = self.hub.state
                    await tab.socket.send_str(json.dumps(tab.told))
                newest = self.hub.newest(tab) if tab.unseen < UNSEEN_MAX else None
                if newest:
                    tab.sent, message = newest
                    tab.unseen += 1
                    await tab.socket.send_bytes(message)
                picked = self.hub.picks.get(tab.pointed)
                if picked is not tab.picked:
                    tab.picked = picked
                    if picked:
                        await tab.socket.send_str(json.dumps(picked))
        except ConnectionError:
            pass    # it is gone; the other side of the socket sees to it
