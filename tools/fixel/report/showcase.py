# SPDX-License-Identifier: MIT
"""Makes 24 models of the kinds that people have, draws each by its first command, and writes a page of them.

Exit: 0 the frames of every model are right, as those of make run are; 1 not; 2 a model could not be drawn."""

import argparse
import pathlib
import re

from fixel import commands
from fixel.base import kept
from fixel.base.errors import ToolError, one_line

MODELS = pathlib.Path(__file__).with_name("showcase_models.py")


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--board", required=True)
    made.add_argument("--only", default="", help="models with one of these words in their name, with commas between")
    made.add_argument("--out", default="build/showcase", help="folder for the page, the pictures and the models")
    made.add_argument("--build", default="build", help="folder that make builds in")
    kept.add_option(made)
    return made


def before(options):
    """Refuses what is in the name of no model. The models are made with NumPy, so their list is read and not imported."""
    listed = re.search(r"^MODELS = \[$(.*?)^\]$", MODELS.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)[1]
    names = [pathlib.PurePath(file).stem for file in re.findall(r"^    Model\(\"([^\"]+)\"", listed, re.MULTILINE)]
    words = [word for word in options.only.split(",") if word]
    if words and not any(word in name for word in words for name in names):
        raise ToolError(f"ONLY is {one_line(options.only)}; the models are: {', '.join(names)}")


main = commands.main_of(parser, "fixel.report.showcase_page")
