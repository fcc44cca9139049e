# SPDX-License-Identifier: MIT
"""Serves the site on this machine, and compiles the models and scene files that are dropped on its page.

The address holds a random token, which every request must name: another page of the browser does not know it. A file is compiled in a
folder of its own, by a process with limits, and names no file beside it."""

import functools
import http.server
import json
import pathlib
import re
import secrets
import threading
import urllib.parse

from fixel.base import bounded, scratch
from fixel.base.errors import ToolError
from fixel.model import suffixes
from fixel.scene import making
from fixel.site import costs

HOST = "127.0.0.1"
TOKEN_BYTES = 16        # 128 random bits
MOST = 64 << 20         # bytes of a file
COMPILED = (".toml", *suffixes.READ)
REFUSED = "text/plain; charset=utf-8"     # a sentence in the place of what was asked for
STATIC, COMPILES = '"compiles":false', '"compiles":true'      # what the first page knows of its server


class Handler(http.server.SimpleHTTPRequestHandler):
    """The files of a folder below the token, and what the page asks for."""
    one_at_a_time = threading.Lock()

    def __init__(self, *words, build, token, **more):
        self.build, self.root = build, f"/{token}/"
        super().__init__(*words, **more)

    def translate_path(self, path):
        return super().translate_path("/" + path.removeprefix(self.root)) if path.startswith(self.root) else str(pathlib.Path(self.directory) / "no such file")

    def log_message(self, *_):
        pass

    def do_GET(self):
        if urllib.parse.urlsplit(self.path).path in (self.root, self.root + "index.html"):
            text = (pathlib.Path(self.directory) / "index.html").read_text(encoding="utf-8")
            self.answer(200, "text/html; charset=utf-8", text.replace(STATIC, COMPILES).encode())
        else:
            super().do_GET()

    def do_POST(self):
        asked = urllib.parse.urlsplit(self.path)
        size, words = self.headers.get("Content-Length", ""), dict(urllib.parse.parse_qsl(asked.query))
        what = {self.root + "compile": compiled, self.root + "predict": predicted}.get(asked.path)
        if what is None or not (size.isascii() and size.isdigit() and int(size) <= MOST):
            self.close_connection = True
            self.answer(404 if what is None else 413, "text/plain", b"")
            return
        data = self.rfile.read(int(size))
        try:
            with self.one_at_a_time, scratch.folder("site") as folder:
                kind, found = what(pathlib.Path(folder), words, data, self.build)
            self.answer(200, kind, found)
        except ToolError as error:
            self.answer(200, REFUSED, str(error).encode())

    def answer(self, code, kind, data):
        self.send_response(code)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(data)))
        self.end_headers()
        self.wfile.write(data)


def compiled(folder, words, data, _):
    """The scene image of a model or a scene file."""
    name = re.sub(r"[^\w.-]", "_", words.get("name", ""), flags=re.ASCII).lstrip(".-") or "file"
    if pathlib.Path(name).suffix.lower() not in COMPILED:
        raise ToolError(f"{name}: no model and no scene file; they end in {', '.join(COMPILED)}")
    (folder / name).write_bytes(data)
    try:
        making.build(str(folder / name), str(folder / "scene.fxls"), limits=bounded.Limits())
    except ToolError as error:
        raise ToolError(str(error).replace(f"{folder}/", "")) from error
    return "application/octet-stream", (folder / "scene.fxls").read_bytes()


def predicted(folder, words, data, build):
    """What a scene image costs on a board."""
    if words.get("board") not in costs.boards(build):
        raise ToolError("no such board")
    (folder / "scene.fxls").write_bytes(data)
    return "application/json", json.dumps(costs.of_scene(folder / "scene.fxls", folder / "scene.fxls", words["board"], build)).encode()


def server_of(folder, port, build):
    """(a server of a site, its address)."""
    token = secrets.token_urlsafe(TOKEN_BYTES)
    handler = functools.partial(Handler, directory=str(folder), build=build, token=token)
    try:
        server = http.server.ThreadingHTTPServer((HOST, port), handler)
    except OSError as error:
        raise ToolError(f"port {port} of {HOST} cannot be used ({error.strerror}): choose another with SERVE=") from error
    return server, f"http://{HOST}:{server.server_port}/{token}/"


def serve(folder, port, build):
    """Serves a site until Ctrl-C."""
    server, address = server_of(folder, port, build)
    with server:
        print(f"site: {address}  Ctrl-C ends it", flush=True)
        server.serve_forever()
