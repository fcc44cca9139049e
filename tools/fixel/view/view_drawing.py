# SPDX-License-Identifier: MIT
"""The page beside the live window that draws in the browser, as the site's first page does: its modules as they stand, the library as
WebAssembly, and what compiles and predicts the files that are dropped on it.

A file is compiled in a folder of its own, by a process with limits, and opens no other file. A refusal is an answer like any other, as plain text."""

import asyncio
import contextlib
import json
import pathlib
import re
import shutil
import threading

from aiohttp import web

from fixel.base import bounded, interpreter, reading, scratch
from fixel.base.errors import ToolError
from fixel.commands import late
from fixel.model import suffixes
from fixel.view import view_own

making = late("fixel.scene", "making")
costs, site = late("fixel.site", "costs site")

SCENES = view_own.ROOT / "scenes"       # a wheel has none
MOST = 64 << 20         # bytes of a file; SECURITY.md says so
COMPILED = (".toml", *suffixes.READ)
ALONE = "make view SCENE= draws a file that needs others"
MODULES = ("walk", "judge", "counter")  # firmware/web/web.mk
WASI = pathlib.Path("/usr/include/wasm32-wasi/stdlib.h")
INSTALL = "sudo apt-get install clang lld wasi-libc libclang-rt-dev-wasm32"


class Drawing:
    """Answers what the page asks for. build: folder that make builds in; folder: for scenes that are compiled here. scene, image: the
    scene of the live window, and its image; None for a program of the user's own."""

    def __init__(self, build, folder, scene=None, image=None):
        self._build, self._folder = pathlib.Path(build), pathlib.Path(folder)
        self._images = {pathlib.Path(scene).stem: pathlib.Path(image)} if scene else {}
        self._kept = b""        # the file that was dropped on the live window last
        self._one_at_a_time = threading.Lock()

    def routes(self, place, headers):
        """Routes of aiohttp, below a place."""
        gets = {"draw.html": self._page, "costs.json": self._costs, "{module}.wasm": self._module, "scenes/{scene}.fxls": self._scene, "kept": self._keeps}
        posts = {"compile": self._compile, "predict": self._predict, "keep": self._keep}
        return [*(web.get(f"{place}/{path}", answering(work, headers)) for path, work in gets.items()),
                *(web.post(f"{place}/{path}", answering(work, headers)) for path, work in posts.items())]

    # --- what the page is made of -----------------------------------------------------

    def _page(self, _, __):
        files = {file.stem: file for file in site.scenes_of(SCENES)}
        scenes = [{"name": name, "said": site.title_of(files[name]) if name in files else ""} for name in dict.fromkeys((*self._images, *files))]
        return "text/html", site.page(scenes, costs.boards(self._build), is_live=True).encode()

    def _costs(self, _, __):
        return "application/json", json.dumps(costs.cores()).encode()

    def _module(self, words, _):
        if words["module"] not in MODULES:
            raise web.HTTPNotFound
        return "application/wasm", self._built(f"web/{words['module']}.wasm").read_bytes()

    def _scene(self, words, _):
        name = words["scene"]
        if name not in self._images:
            files = {file.stem: file for file in site.scenes_of(SCENES)}
            if name not in files:
                raise web.HTTPNotFound
            image = self._folder / f"draw-{name}.fxls"
            making.build(str(files[name]), str(image), limits=bounded.Limits())
            self._images[name] = image
        return "application/octet-stream", self._images[name].read_bytes()

    def _built(self, program):
        """A program of the build folder, which the makefile of a checkout brings up to date."""
        file = self._build / program
        if interpreter.INSTALLED.exists():
            if not file.exists():
                raise ToolError(f"this package has no {program}: it was built where clang, lld and the C library of WASI are not. Install these "
                                f"({INSTALL}) and build it again")
            return file
        if program.endswith(".wasm") and not (shutil.which("clang") and shutil.which("wasm-ld") and ("walk" in program or WASI.exists())):
            raise ToolError(f"{file.name} is compiled by clang for the browser, and a package for that is not installed: run '{INSTALL}', and reload this page")
        done = view_own.make(self._build, file)
        if done.returncode:
            raise ToolError(f"{program} was not built", words=done.stderr)
        return file

    # --- files of the user's ----------------------------------------------------------

    def _compile(self, words, data):
        """The scene image of a model or a scene file."""
        name = re.sub(r"[^\w.-]", "_", words.get("name", ""), flags=re.ASCII).lstrip(".-") or "file"
        if pathlib.Path(name).suffix.lower() not in COMPILED:
            raise ToolError(f"{name}: no model and no scene file; they end in {', '.join(COMPILED)}")
        with self._file(name, data) as file:
            image = file.with_name("scene.fxls")
            try:
                making.build(str(file), str(image), limits=bounded.Limits())
            except ToolError as error:
                raise ToolError(str(error).replace(f"{file.parent}/", "").replace(f"{file.parent}, ", "").replace(reading.ALLOW, ALONE)) from error
            return "application/octet-stream", image.read_bytes()

    def _predict(self, words, data):
        """What a scene image costs on a board."""
        if words.get("board") not in costs.boards(self._build):
            raise ToolError("no such board")
        self._built("host/predict")
        with self._file("scene.fxls", data) as file:
            return "application/json", json.dumps(costs.of_scene(file, file, words["board"], self._build)).encode()

    @contextlib.contextmanager
    def _file(self, name, data):
        with self._one_at_a_time, scratch.folder("dropped", self._folder) as folder:
            (folder / name).write_bytes(data)
            yield folder / name

    def _keep(self, _, data):
        """Takes a file that was dropped on the live window, for the page that is opened next."""
        self._kept = data
        return "text/html", b""

    def _keeps(self, _, __):
        return "application/octet-stream", self._kept


def answering(work, headers):
    """What answers a request: the kind and the bytes of work(the words of the address, the bytes of the request)."""
    async def answer(request):
        data = await request.read()
        try:
            kind, body = await in_thread(work, {**request.query, **request.match_info}, data)
        except ToolError as error:
            kind, body = "text/plain", error.shown().removeprefix("error: ").encode()
        return web.Response(body=body, content_type=kind, charset="utf-8" if kind.startswith("text/") else None, headers=headers)
    return answer


async def in_thread(work, *words):
    """What work answers, in a thread that nobody waits for once the page's server ends."""
    loop = asyncio.get_running_loop()
    done = loop.create_future()

    def tell(name, value):
        if not done.done():
            getattr(done, name)(value)

    def run():
        try:
            told = "set_result", work(*words)
        except Exception as error:      # of any kind: it is the request's
            told = "set_exception", error
        with contextlib.suppress(RuntimeError):     # the loop is closed
            loop.call_soon_threadsafe(tell, *told)

    threading.Thread(target=run, daemon=True).start()
    return await done
