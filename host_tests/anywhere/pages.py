# SPDX-License-Identifier: MIT
"""Pages in Debian's Chromium, for the tests of the site and of what draws in the browser."""

import contextlib
import re

import playwright.sync_api
import pytest

from conftest import CHECKOUT
from fixel.scene import making
from fixel.view import browser

AXE = CHECKOUT / ".node" / "node_modules" / "axe-core" / "axe.min.js"
DESKTOP, NARROW = (1366, 768), (390, 844)
PATIENCE = 60_000   # milliseconds for what comes by itself: it ends a test that hangs


@pytest.fixture(scope="module", name="chromium")
def fixture_chromium():
    with browser.chromium() as opened:
        yield opened


@contextlib.contextmanager
def opened(chromium, address, size=DESKTOP, waits=True, **how):
    """A page; .complaints has what its console says, .asked the addresses of its requests. At the end nothing was said, and nobody else asked."""
    with contextlib.closing(chromium.new_context(viewport=dict(zip(("width", "height"), size)), **how)) as context:
        page = context.new_page()
        page.set_default_timeout(PATIENCE)
        page.complaints, page.asked = [], []
        page.on("console", lambda message: page.complaints.append(message.text))
        page.on("pageerror", lambda error: page.complaints.append(str(error)))
        page.on("request", lambda request: page.asked.append(request.url))
        page.goto(address)
        if waits:
            page.wait_for_selector("#unserved", state="hidden")
        yield page
        assert page.complaints == []
        assert not [url for url in page.asked if not url.startswith(("/".join(address.split("/")[:3]), "file:", "data:", "blob:"))]


def shows(page, selector, pattern):
    """Waits until an element's text is as the pattern says."""
    playwright.sync_api.expect(page.locator(selector)).to_have_text(re.compile(pattern), timeout=PATIENCE)


def crc(page):
    return page.inner_text("#crc")


def paused(page):
    if page.get_attribute("#pause", "aria-pressed") == "false":
        page.click("#pause")
    return crc(page)


def drop(page, name, data):
    """A file dropped on the picture."""
    page.evaluate("""([name, bytes]) => {
        const transfer = new DataTransfer();
        transfer.items.add(new File([new Uint8Array(bytes)], name));
        document.getElementById("stage").dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, cancelable: true }));
    }""", [name, list(data)])


def drop_each(page, folder):
    """Drops a file of each kind on a page whose server compiles: each is drawn and predicted."""
    making.build(str(CHECKOUT / "scenes" / "tiny.toml"), str(folder / "tiny.fxls"))
    for file in (*(CHECKOUT / name for name in ("examples/cube/cube.obj", "examples/model/model.glb", "host_tests/tools/models/capitals.stl",
                                                "host_tests/breaks/scenes/colours.ply", "scenes/tiny.toml")), folder / "tiny.fxls"):
        drop(page, f"<b>{file.name}", file.read_bytes())
        shows(page, "#scene-name", f"^<b>{re.escape(file.name)}, a file of yours$")
        shows(page, "#cost", r"^[\d,]+ instructions$")
        assert page.inner_text("#banner") == "" and not page.query_selector("figcaption b")


def assert_accessible(chromium, address, scheme, waits=True):
    """By axe-core. It is put into the page, which the page's policy forbids."""
    with opened(chromium, address, waits=waits, bypass_csp=True, color_scheme=scheme) as page:
        page.add_script_tag(path=AXE)
        found = page.evaluate("async () => (await axe.run()).violations.filter(each => ['serious', 'critical'].includes(each.impact))")
    assert not [(each["id"], each["nodes"][0]["html"]) for each in found]
