# SPDX-License-Identifier: MIT
"""The gallery of the site: each scene of scenes/ with its picture, and a page of its own with its code and its commands."""

import html
import pathlib

from fixel.base import picture, scratch
from fixel.board import dump, programs

ROOT = pathlib.Path(__file__).resolve().parents[3]
TEMPLATE = ROOT / "tools" / "templates" / "gallery.html"
LARGE_BOARD = "mps2-an385"      # where the board that the page begins with has no room
WORKLOAD = "Workload"           # so begins what a scene of the bench says of itself: these come last
DOCUMENTS = "documents/docs/{}.html"


def draw(image, build):
    """The frame in the middle of a scene's path, as PNG."""
    with scratch.folder("gallery") as folder:
        out = pathlib.Path(folder) / "frames.fxld"
        programs.run_program([pathlib.Path(build) / "host" / "frames", image, out])
        drawn = dump.read_dump(out)
    frame = drawn.frames[len(drawn.frames) // 2]
    return picture.png_bytes(picture.palette_image(frame.pixels, drawn.palette))


def page(title, words, links, kind, main, up=""):
    """A page; links: {what it is: address}. main: markup; all else is text."""
    text = TEMPLATE.read_text(encoding="utf-8")
    made = " ".join(f'<a href="{html.escape(up + address)}">{html.escape(name)}</a>' for name, address in links.items())
    for name, value in {"title": html.escape(title), "words": html.escape(words), "links": made, "kind": kind, "up": up, "main": main}.items():
        text = text.replace("{{" + name + "}}", value)
    return text


def of_scene(name, said, code, facts, board):
    """The page of a scene. facts: [(what, how much)]."""
    rows = "".join(f"<div><dt>{html.escape(what)}</dt><dd>{html.escape(much)}</dd></div>" for what, much in facts)
    main = f"""<figure><a href="../index.html#scene={name}"><img src="{name}.png" alt="A frame of {name}"></a></figure>
<section><h2>On a board</h2><pre tabindex="0"><code>make run BOARD={board} SCENE=scenes/{name}.toml</code></pre>
<h2>Here</h2><p><a href="../index.html#scene={name}">Draw it, and walk in it</a>. In a page of yours, with the place of this site before it:</p>
<pre tabindex="0"><code>{html.escape(f'<iframe src="index.html?embed#scene={name}" title="{name}" width="320" height="272"></iframe>')}</code></pre>
<dl>{rows}</dl></section>
<section class="wide"><h2>scenes/{name}.toml</h2><pre tabindex="0"><code>{html.escape(code)}</code></pre></section>"""
    return page(name, said or f"A scene of Fixel: {name}.", {"All scenes": "gallery.html", "What a scene file says": DOCUMENTS.format("scenes"), "Fixel": "index.html"},
                "scene", main, "../")


def of_scenes(scenes):
    """The page of all scenes."""
    cards = "".join(f'<article class="card"><a href="scenes/{each["name"]}.html"><img src="scenes/{each["name"]}.png" alt="" loading="lazy">'
                    f'<b>{html.escape(each["name"])}</b></a><p>{html.escape(each["said"])}</p></article>' for each in sorted(scenes, key=lambda each: each["said"].startswith(WORKLOAD)))
    return page("Scenes", "Each is a file of text, which draws the same picture here and on every board.",
                {"Fixel": "index.html", "Examples in C": DOCUMENTS.format("examples"), "What there is for what you want": DOCUMENTS.format("features")}, "gallery", cards)


def write(folder, scenes, build, say):
    """Writes the gallery. scenes: [{name, said, bytes, faces, frames, cost}] of site.py, cost: on the first page's board, in folder/scenes."""
    for number, each in enumerate(scenes):
        say(number, len(scenes))
        name, place, cost = each["name"], folder / "scenes", each["cost"]
        (place / f"{name}.png").write_bytes(draw(place / f"{name}.fxls", build))
        facts = [("faces", f"{each['faces']:,}"), ("frames of its path", f"{each['frames']:,}"), ("bytes of flash", f"{each['bytes']:,}"),
                 (f"instructions a frame on {each['board']}, mean, an estimate", f"{cost['mean']['instructions']:,}" if "mean" in cost else cost["why_not"])]
        board = each["board"] if "mean" in cost else LARGE_BOARD
        code = (ROOT / "scenes" / f"{name}.toml").read_text(encoding="utf-8")
        (place / f"{name}.html").write_text(of_scene(name, each["said"], code, facts, board), encoding="utf-8")
    (folder / "gallery.html").write_text(of_scenes(scenes), encoding="utf-8")
