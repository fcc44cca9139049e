# SPDX-License-Identifier: MIT
"""A live window in a headless browser, for its test and for its recording: Debian's Chromium, driven
by Playwright."""

import contextlib
import pathlib
import re
import signal
import subprocess

from fixel.base import children, interpreter
from fixel.base.errors import ToolError

CHROMIUM = pathlib.Path("/usr/bin/chromium")
ADDRESS = re.compile(r"http://127\.0\.0\.1:\d+/[\w-]+/")
ENDING = 20     # seconds


@contextlib.contextmanager
def viewing(board, scene, build="build", options=(), **how):
    """Runs fixel view as a user would: yields its process and the page's address; ends it by Ctrl-C where
    it still runs. scene: None for a program of the user's own. options: more words for it; how: for subprocess.Popen."""
    how.setdefault("stdin", subprocess.DEVNULL)
    how.setdefault("stderr", subprocess.PIPE)
    process = children.start([*interpreter.command("view"), "--board", board, *(["--scene", scene] if scene else []),
                              "--build", build, *options],
                             signal.SIGTERM, stdout=subprocess.PIPE, text=True, **how)
    try:
        address = ADDRESS.search(process.stdout.readline())
        if address is None:
            process.wait(ENDING)
            raise ToolError("fixel view did not start", exit_code=1, words=process.stderr.read() if process.stderr else "")
        yield process, address[0]
    finally:
        with contextlib.suppress(ProcessLookupError):
            process.send_signal(signal.SIGINT)
        try:
            process.wait(ENDING)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
        for pipe in (process.stdout, process.stderr):
            if pipe is not None:
                pipe.close()


@contextlib.contextmanager
def chromium():
    """A browser, for as many pages as are wanted."""
    # Here, so that whoever does not want a browser need not wait for it.
    from playwright.sync_api import Error, sync_playwright
    if not CHROMIUM.exists():
        raise ToolError(f"{CHROMIUM} is not installed: run 'sudo apt-get install chromium'")
    with sync_playwright() as playwright:
        try:
            browser = playwright.chromium.launch(executable_path=str(CHROMIUM), args=["--no-sandbox"])
        except Error as error:
            raise ToolError(f"{CHROMIUM} does not start: {error}", exit_code=1) from error
        with contextlib.closing(browser):
            yield browser


@contextlib.contextmanager
def page(browser, address, width, height):
    """The window in a tab that shares nothing with another; what its console says is in the list
    page.complaints."""
    with contextlib.closing(browser.new_page(viewport={"width": width, "height": height})) as opened:
        opened.complaints = []
        opened.on("console", lambda message: opened.complaints.append(message.text))
        opened.on("pageerror", lambda error: opened.complaints.append(str(error)))
        opened.goto(address)
        opened.wait_for_selector("#state.live")
        yield opened
