# SPDX-License-Identifier: MIT
"""The live window while it runs: a board, the server of its page, the reference beside it."""

import asyncio
import contextlib
import pathlib
import signal
import webbrowser

from fixel.base import output, scratch
from fixel.board import firmware, flash_memory, methods, model_look
from fixel.base.errors import ENDINGS, one_line
from fixel.view.view import port_number
from fixel.view import view_own
from fixel.view.view_board import Board
from fixel.view.view_board import IDLE_RATE, Pump
from fixel.view.view_server import Hub, Server, hello
from fixel.view.view_reference import Reference
from fixel.image import image
from fixel.scene import making, scene_options

OWN_SCENE = "scenes/tiny.toml"      # what store_scene of a program of the user's own has, as in make run


def open_page(file, address):
    """Opens a page by way of a file that only this user may read: any user sees what a command is told."""
    file.write_text(f'<!DOCTYPE html><meta http-equiv="refresh" content="0; url={address}">\n', encoding="ascii")
    webbrowser.open(file.as_uri())


def own_program(board, hub, later, stack):
    """Has the page follow a program of the user's own; what the pump is told besides."""
    source = board.source

    def built(is_new, words):
        if words:
            print(words, end="", flush=True)
        later("stumble")("build", None)
        if is_new:
            print(f"{one_line(source.name)} was built: it starts again", flush=True)
            hub.pump.restart()

    def failed(kind):
        def tell(error):
            print(error.shown(), flush=True)
            later("stumble")(kind, error)
        return tell

    board.begun = lambda head: later("begin")(greeting(board, head))
    stack.enter_context(contextlib.closing(view_own.Watcher(source, built, failed("build"))))
    return failed("run"), later("picked")


def greeting(board, head, scene=None, judged=False):
    """What a tab is told first. scene: None for a program of the user's own."""
    return hello(board.program, scene or board.source.path, head, judged, scene is None)


async def serve(board, reference, scene, options):
    """Shows the board until it ends or a signal does; the error that it ended with, or None. reference(found, failed): makes a
    Reference; None without one. scene: its name, None for a program of the user's own."""
    loop = asyncio.get_running_loop()

    def later(name):
        """A method of the hub, for other threads."""
        def call(*arguments):
            with contextlib.suppress(RuntimeError):     # the loop is closed: nobody wants it any more
                loop.call_soon_threadsafe(getattr(hub, name), *arguments)
        return call

    hub = Hub(greeting(board, board.head, scene, reference is not None and options.program == methods.WALK), board.hold,
              lambda frame, wants: beside.ask(frame, wants))
    with contextlib.ExitStack() as stack:
        if reference is not None:
            beside = stack.enter_context(contextlib.closing(reference(later("compare"), later("end"))))
        failed, picked = (later("end"), None) if scene else own_program(board, hub, later, stack)
        hub.pump = stack.enter_context(contextlib.closing(Pump(board, IDLE_RATE, later("show"), failed, picked)))
        for each in ENDINGS:
            loop.add_signal_handler(each, hub.end)
        server = Server(hub)
        try:
            await server.open(options.port)
            print(f"{board.program.board} ({board.program.cpu}) {'walks' if scene else 'runs'} {one_line(scene or board.source.path)}: "
                  f"{server.address} (Ctrl-C ends it)", flush=True)
            if options.open:
                open_page(board.folder / "open.html", server.address)
            await hub.ended.wait()
        finally:
            await server.close()
        return hub.error


def watch(board, reference, scene, options):
    """Serves the board until it ends."""
    with contextlib.closing(board):
        try:
            error = asyncio.run(serve(board, reference, scene, options))
        finally:
            for each in ENDINGS:    # whoever is impatient now would leave something behind
                signal.signal(each, signal.SIG_IGN)
    if error:
        raise error
    return 0


def view(options):
    elf = methods.elf_of(options.board, options.build, methods.program(options))
    program = firmware.load(elf, options.board)
    output.make_folder(options.build)
    with scratch.folder("view", options.build) as folder:
        scene_image = model_look.scene_image(options, elf, folder)
        methods.check_scene(options, image.load(scene_image))
        flash_memory.flash(options.board, elf, scene_image, folder / "flash.bin")

        def reference(found, failed):
            return Reference(pathlib.Path(options.build) / "host" / "live", scene_image, found, failed, methods.judge_options(options))
        return watch(Board(program, folder / "flash.bin", folder), reference, options.scene, options)


def view_own_program(options):
    """The same of a program of the user's own, which chooses itself what it draws."""
    output.make_folder(options.build)
    source = view_own.Source(options.source, options.program, options.build)
    with scratch.folder("view", options.build) as folder:
        making.build(OWN_SCENE, folder / "scene.fxls")
        view_own.first_build(source)
        return watch(view_own.start(source, folder / "scene.fxls", folder), None, None, options)


def command(options):
    """The command; its exit code."""
    options.port = port_number(options.port) if options.port is not None else None
    if options.source is not None:
        return view_own_program(options)
    scene_options.check(options)
    methods.check(options)
    return view(options)
