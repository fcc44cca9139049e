# SPDX-License-Identifier: MIT
"""Starts a board and shows its frames live on a web page of this machine.

Keys go from the page to the firmware; the page shows the frame of the reference renderer beside it.
Ctrl-C ends everything. Exit: 0 after Ctrl-C, 2 the board could not be started; else the board ended by
itself, with the exit code of its program.
"""

import argparse
import contextlib
import pathlib
import signal

from fixel.base import output, scratch
from fixel.base.errors import ENDINGS, ToolError, one_line
from fixel.board import methods
from fixel.commands import late
from fixel.scene import making, scene_options

asyncio, webbrowser = late("asyncio"), late("webbrowser")
firmware, flash_memory, model_look = late("fixel.board", "firmware flash_memory model_look")
image = late("fixel.image", "image")
view_board, view_drawing, view_own, view_reference, view_server = late("fixel.view", "view_board view_drawing view_own view_reference view_server")

OWN_SCENE = "scenes/tiny.toml"      # what store_scene of a program of the user's own has, as in make run


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    scene_options.add_board(made)
    scene_options.add(made, frames=False)
    methods.add_options(made)
    made.add_argument("--source", help="C file, or folder of C files, of a program of your own, which is --program")
    made.add_argument("--port", help="port on 127.0.0.1 (default: 8065, or a free one)")
    made.add_argument("--open", action="store_true", help="open the page in this machine's browser")
    made.add_argument("--build", default="build", help="folder that make builds in")
    return made


def port_number(text):
    """A port from a command line."""
    if not (text.isascii() and text.isdigit() and 1 <= int(text) <= 65535):
        raise ToolError(f"PORT is '{text}'; it must be a whole number from 1 to 65535")
    return int(text)


def before(options):
    """Refuses what is no port."""
    if options.port is not None:
        port_number(options.port)


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
    return view_server.hello(board.program, scene or board.source.path, head, judged, scene is None)


async def serve(board, reference, scene, drawing, options):
    """Shows the board until it ends or a signal does; the error that it ended with, or None. reference(found, failed): makes a
    Reference; None without one. scene: its name, None for a program of the user's own. drawing: the page beside the window's."""
    loop = asyncio.get_running_loop()

    def later(name):
        """A method of the hub, for other threads."""
        def call(*arguments):
            with contextlib.suppress(RuntimeError):     # the loop is closed: nobody wants it any more
                loop.call_soon_threadsafe(getattr(hub, name), *arguments)
        return call

    hub = view_server.Hub(greeting(board, board.head, scene, reference is not None and options.program == methods.WALK), board.hold,
              lambda frame, wants: beside.ask(frame, wants))
    with contextlib.ExitStack() as stack:
        if reference is not None:
            beside = stack.enter_context(contextlib.closing(reference(later("compare"), later("end"))))
        failed, picked = (later("end"), None) if scene else own_program(board, hub, later, stack)
        hub.pump = stack.enter_context(contextlib.closing(view_board.Pump(board, view_board.IDLE_RATE, later("show"), failed, picked)))
        for each in ENDINGS:
            loop.add_signal_handler(each, hub.end)
        server = view_server.Server(hub, drawing)
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


def watch(board, reference, scene, drawing, options):
    """Serves the board until it ends."""
    with contextlib.closing(board):
        try:
            error = asyncio.run(serve(board, reference, scene, drawing, options))
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
            return view_reference.Reference(pathlib.Path(options.build) / "host" / "live", scene_image, found, failed, methods.judge_options(options))
        drawing = view_drawing.Drawing(options.build, folder, options.scene, scene_image)
        return watch(view_board.Board(program, folder / "flash.bin", folder), reference, options.scene, drawing, options)


def view_own_program(options):
    """The same of a program of the user's own, which chooses itself what it draws."""
    output.make_folder(options.build)
    source = view_own.Source(options.source, options.program, options.build)
    with scratch.folder("view", options.build) as folder:
        making.build(OWN_SCENE, folder / "scene.fxls")
        view_own.first_build(source)
        return watch(view_own.start(source, folder / "scene.fxls", folder), None, None, view_drawing.Drawing(options.build, folder), options)


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    options.port = port_number(options.port) if options.port is not None else None
    if options.source is not None:
        return view_own_program(options)
    scene_options.check(options)
    methods.check(options)
    return view(options)
