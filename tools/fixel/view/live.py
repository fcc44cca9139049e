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
from fixel.view.view_board import Board
from fixel.view.view_pump import IDLE_RATE, Pump
from fixel.view.view_server import Hub, Server, hello
from fixel.view.view_reference import Reference
from fixel.image import image
from fixel.scene import scene_options


def open_page(file, address):
    """Opens a page by way of a file that only this user may read: any user sees what a command is told."""
    file.write_text(f'<!DOCTYPE html><meta http-equiv="refresh" content="0; url={address}">\n', encoding="ascii")
    webbrowser.open(file.as_uri())


async def serve(board, reference_program, scene_image, options):
    """Shows the board until it ends or a signal does; the error that it ended with, or None."""
    loop = asyncio.get_running_loop()

    def later(name):
        """A method of the hub, for other threads."""
        def call(argument):
            with contextlib.suppress(RuntimeError):     # the loop is closed: nobody wants it any more
                loop.call_soon_threadsafe(getattr(hub, name), argument)
        return call

    hub = Hub(hello(board.program, options.scene, board.head, options.program == methods.WALK), board.hold,
              lambda frame, wants: reference.ask(frame, wants))
    with contextlib.ExitStack() as stack:
        reference = stack.enter_context(contextlib.closing(
            Reference(reference_program, scene_image, later("compare"), later("end"), methods.judge_options(options))))
        hub.pump = stack.enter_context(contextlib.closing(Pump(board, IDLE_RATE, later("show"), later("end"))))
        for each in ENDINGS:
            loop.add_signal_handler(each, hub.end)
        server = Server(hub)
        try:
            await server.open(options.port)
            print(f"{board.program.board} ({board.program.cpu}) walks {one_line(options.scene)}: {server.address} "
                  "(Ctrl-C ends it)", flush=True)
            if options.open:
                open_page(board.folder / "open.html", server.address)
            await hub.ended.wait()
        finally:
            await server.close()
        return hub.error


def view(options):
    elf = methods.elf_of(options.board, options.build, methods.program(options))
    program = firmware.load(elf, options.board)
    output.make_folder(options.build)
    with scratch.folder("view", options.build) as folder:
        scene_image = model_look.scene_image(options, elf, folder)
        methods.check_scene(options, image.load(scene_image))
        flash_memory.flash(options.board, elf, scene_image, folder / "flash.bin")
        with contextlib.closing(Board(program, folder / "flash.bin", folder)) as board:
            try:
                error = asyncio.run(serve(board, pathlib.Path(options.build) / "host" / "live", scene_image, options))
            finally:
                for each in ENDINGS:    # whoever is impatient now would leave something behind
                    signal.signal(each, signal.SIG_IGN)
    if error:
        raise error
    return 0


def command(options):
    """The command; its exit code."""
    scene_options.check(options)
    methods.check(options)
    options.port = port_number(options.port) if options.port is not None else None
    return view(options)
