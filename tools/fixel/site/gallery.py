# SPDX-License-Identifier: MIT
"""The gallery of the site: the scenes of scenes/, the programs of examples/ and the models of make showcase, each with its picture, and a page of
its own with its code and its command."""

import html
import pathlib
import shutil

from fixel.base import picture, scratch
from fixel.board import dump, own_run, programs as host_programs
from fixel.site import costs, pages, programs

LARGE_BOARD = "mps2-an385"      # where the board that the page begins with has no room
WORKLOAD = "Workload"           # so begins what a scene of the bench says of itself: these come last
PLAYS = "game"                  # what the page of the emulated board runs
PLAYED = ' <a href="../pico.html">The emulated Pico</a> plays it.'
DOCUMENTS = "documents/docs/{}.html"
DRAWN = f"""<figure><div id="stage"><canvas id="screen" width="320" height="240" role="img" aria-label="What the program draws"></canvas>
<p id="unserved">Nothing runs here yet. A browser runs this page only when it is served, and with scripts on.</p>
<noscript><img src="{{name}}.png" alt="A frame of {{name}}"></noscript></div>
<figcaption><span>frame <output id="number">–</output></span> <span>CRC <output id="crc">–</output></span></figcaption>
<p id="banner" role="alert" hidden></p>
<div class="choice" role="group" aria-label="Frames"><button id="pause">pause</button><button id="step">step</button><button id="save" title="this frame">save PNG</button></div>
<p>It runs here as it stands, to its own end or for {own_run.FRAMES} frames. Each CRC is the one that the command says.</p></figure>"""


def draw(image, build):
    """The frame in the middle of a scene's path, as PNG."""
    with scratch.folder("gallery") as folder:
        out = pathlib.Path(folder) / "frames.fxld"
        host_programs.run_program([pathlib.Path(build) / "host" / "frames", image, out])
        drawn = dump.read_dump(out)
    frame = drawn.frames[len(drawn.frames) // 2]
    return picture.png_bytes(picture.palette_image(frame.pixels, drawn.palette))


def page(title, words, links, kind, main, up="", **more):
    """A page; links: {what it is: address}. main: markup; all else is text, and what pages.filled takes."""
    made = " ".join(f'<a href="{html.escape(up + address)}">{html.escape(name)}</a>' for name, address in links.items())
    return pages.filled("gallery.html", f"{title}: Fixel", words, up=up, heading=html.escape(title), links=made, kind=kind, main=main, **more)


def code(text):
    """A listing, which keys reach."""
    return f'<pre tabindex="0"><code>{html.escape(text)}</code></pre>'


def of_scene(scene, facts):
    """The page of a scene, or of a model. facts: [(what, how much)]."""
    rows = "".join(f"<div><dt>{html.escape(what)}</dt><dd>{html.escape(much)}</dd></div>" for what, much in facts)
    name = scene["name"]
    main = f"""<figure><a href="../index.html#scene={name}"><img src="{name}.png" alt="A frame of {name}"></a></figure>
<section><h2>On a board</h2>{code(scene["command"])}
<h2>Here</h2><p><a href="../index.html#scene={name}">Draw it, and walk in it</a>. In a page of yours, with the place of this site before it:</p>
{code(f'<iframe src="index.html?embed#scene={name}" title="{name}" width="320" height="272"></iframe>')}
<dl>{rows}</dl></section>
<section class="wide"><h2>{html.escape(scene["file"])}</h2>{code(scene["code"])}</section>"""
    return page(scene["title"], scene["said"] or f"A scene of Fixel: {name}.",
                {"Gallery": "gallery.html", "What a scene file says": DOCUMENTS.format("scenes"), "Fixel": "index.html"}, "scene", main, "../")


def of_program(program):
    """The page of a program of examples/."""
    shown = f'<figure><img src="{program.name}.png" alt="A frame of {program.name}"><p>It does not run in a page: {html.escape(program.why_not)}.{PLAYED if program.name == PLAYS else ""}</p></figure>' \
        if program.why_not else DRAWN.format(name=program.name)
    texts = "".join(f'<section class="wide"><h2>{html.escape(str(file.relative_to(programs.ROOT)))}</h2>{code(file.read_text(encoding="utf-8"))}</section>'
                    for file in program.files)
    main = f"{shown}<section><h2>On a board</h2>{code(programs.command(program, costs.FIRST))}</section>{texts}"
    script = {} if program.why_not else {"script": "program.js", "data": {"name": program.name, "frames": own_run.FRAMES}}
    return page(program.name, f"{program.said[0].upper()}{program.said[1:]}.",
                {"Gallery": "gallery.html", "Examples in C": DOCUMENTS.format("examples"), "Fixel": "index.html"}, "scene", main, "../", **script)


def card(place, name, title, said):
    """What the gallery has of a page."""
    return (f'<article class="card"><a href="{place}/{name}.html"><img src="{place}/{name}.png" alt="" loading="lazy">'
            f'<b>{html.escape(title)}</b></a><p>{html.escape(said)}</p></article>')


def of_all(scenes, models, examples):
    """The page of all that there is. scenes and models: what write takes."""
    groups = {"Scenes": [card("scenes", each["name"], each["title"], each["said"]) for each in sorted(scenes, key=lambda each: each["said"].startswith(WORKLOAD))],
              "Programs": [card("examples", each.name, each.name, each.said) for each in examples],
              "Models without a scene file": [card("scenes", each["name"], each["title"], each["said"]) for each in models]}
    main = "".join(f'<section><h2 id="{name.split()[0].lower()}">{name}</h2><div class="gallery">{"".join(cards)}</div></section>' for name, cards in groups.items())
    return page("Gallery", "Scenes are files of text, programs are C, models are as people have them. Each draws the same picture here and on every board.",
                {"Fixel": "index.html", "Programs": "gallery.html#programs", "Models": "gallery.html#models", "What there is for what you want": DOCUMENTS.format("features")},
                "all", main)


def write_programs(folder, own, say):
    """Writes the programs of examples/ with their pages into folder/examples, and answers them. own: the folder in which make has what they link."""
    place, found = folder / "examples", programs.of_the_tree()
    place.mkdir()
    for number, each in enumerate(found):
        say(number, len(found))
        made = programs.compiled(each, own, place / f"{each.name}.wasm")
        shutil.copyfile(made.picture, place / f"{made.name}.png")
        (place / f"{made.name}.html").write_text(of_program(made), encoding="utf-8")
        found[number] = made
    return found


def write(folder, scenes, models, examples, build, say):
    """Writes the gallery. scenes, models: [{name, title, said, file, code, command, bytes, faces, frames, cost}] of site.py, cost: on the first page's board,
    in folder/scenes; examples: of write_programs."""
    for number, each in enumerate([*scenes, *models]):
        say(number, len(scenes) + len(models))
        name, place, cost = each["name"], folder / "scenes", each["cost"]
        (place / f"{name}.png").write_bytes(draw(place / f"{name}.fxls", build))
        facts = [("faces", f"{each['faces']:,}"), ("frames of its path", f"{each['frames']:,}"), ("bytes of flash", f"{each['bytes']:,}"),
                 (f"instructions a frame on {costs.FIRST}, mean, an estimate", f"{cost['mean']['instructions']:,}" if "mean" in cost else cost["why_not"])]
        (place / f"{name}.html").write_text(of_scene(each, facts), encoding="utf-8")
    (folder / "gallery.html").write_text(of_all(scenes, models, examples), encoding="utf-8")
