# SPDX-License-Identifier: MIT
"""The pages of the site, but for its documents: templates with one head."""

import html
import json
import pathlib

TEMPLATES = pathlib.Path(__file__).resolve().parents[2] / "templates"
HEAD = "head.html"


def template(name):
    """The text of a template."""
    return (TEMPLATES / name).read_text(encoding="utf-8")


def filled(name, title, description, script="", data=None, up="", **values):
    """A page of a template. script: its module; data: what that takes as JSON. up: where the site's first page is. values: markup; title and
    description are text."""
    scripts = ""
    if script:
        text = json.dumps(data, separators=(",", ":")).replace("<", "\\u003c")
        scripts = f'<script type="application/json" id="data">{text}</script>\n<script type="module" src="{up}{script}"></script>'
    values |= {"title": html.escape(title), "description": html.escape(description), "up": up}
    text = template(HEAD) + template(name).partition("\n")[2]       # without the licence, which the head has
    for each, value in {**values, "scripts": scripts}.items():
        text = text.replace("{{" + each + "}}", value)
    return text
