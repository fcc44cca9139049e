# SPDX-License-Identifier: MIT
"""Makes 24 models of the kinds that people have, draws each by its first command, and writes a page of them.

Exit: 0 the frames of every model are right, as those of make run are; 1 not; 2 a model could not be drawn."""

import argparse
import html
import json
import pathlib
import re
import shutil
import sys

from fixel.base import children, kept, output, scratch
from fixel.base.errors import ToolError, one_line
from fixel.base.progress import steps
from fixel.board import counted
from fixel.commands import late

showcase_models = late("fixel.report", "showcase_models")

MODELS = pathlib.Path(__file__).with_name("showcase_models.py")
LAUNCHER = pathlib.Path(__file__).resolve().parents[1] / "launcher.py"
FRAMES = 2              # of a model's circle: from the front, and from behind
# The last one says that the page is whole.
PATTERNS = ["*.png", "*.obj", "*.mtl", "*.jpg", "*.PNG", "*.stl", "*.ply", "*.glb", "summary.json", "index.html"]
_HEAD = """<!doctype html>
<meta charset="utf-8">
<title>Fixel: models as people have them</title>
<style>
body { font: 15px/1.45 sans-serif; margin: 2em auto; max-width: 1060px; color: #222 }
ul { display: grid; grid-template-columns: repeat(auto-fill, minmax(322px, 1fr)); gap: 22px; list-style: none; padding: 0 }
img { display: block; width: 320px; height: 240px; background: #1b2a38 }
code { background: #f0f0f0; overflow-wrap: anywhere }
p { margin: 4px 0 } .said { color: #666; font-size: 13px }
</style>
"""


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


def first_command(model, folder):
    """What a user types."""
    look = f" LOOK='{model.look}'" if model.look else ""
    return f"make run SCENE={folder}/{model.file}{look}"


def chosen(only):
    """The models with one of these words in their name."""
    words = [word for word in only.split(",") if word]
    found = [model for model in showcase_models.MODELS if not words or any(word in model.name for word in words)]
    if not found:
        raise ToolError(f"ONLY is {one_line(only)}; the models are: {', '.join(each.name for each in showcase_models.MODELS)}")
    return found


def _line(said, file):
    """What the tool chose, of all that it said."""
    return next((line.partition(f"{file.name}: ")[2] for line in said.splitlines() if " of RAM for pixels" in line), "")


def draw(model, folder, work, options):
    """Makes a model and draws it on a board; for summary.json. Its picture goes into the folder."""
    file, out = showcase_models.write(model, folder), work / model.name
    look = [f"--look={model.look}"] if model.look else []
    done = children.run([sys.executable, LAUNCHER, "run", "--board", options.board, "--scene", file, "--frames", FRAMES, *look,
                         "--out", out, "--build", options.build, *(["--fresh"] if options.fresh else [])])
    said = done.stderr.decode("utf-8", "replace")
    if done.returncode not in (0, 1):
        error = next((line for line in said.splitlines() if "error: " in line), said[-200:])
        raise ToolError(f"{model.file}: {error.partition('error: ')[2] or error}")
    summary = json.loads((out / "summary.json").read_text())
    shutil.copy(out / "frame_0000.png", folder / f"{model.name}_seen.png")
    return {"name": model.name, "file": model.file, "what": model.what, "look": model.look, "chosen": _line(said, file), "pass": done.returncode == 0,
            "differ": summary["pixels_differing"], "unexplained": summary["pixels_unexplained"],
            "wrong_by_order": summary["order_wrong_pixels"], "pixels": summary["pixels"],
            "instructions": summary["instructions_per_frame"]["mean"], "cycles": summary["cycles_per_frame"]["mean"],
            "took": ": ".join(counted.row(summary))}


def _entry(model, row, folder):
    text = html.escape
    wrong = f"{row['wrong_by_order']:,} pixels wrong by the order, " if row["wrong_by_order"] else ""
    verdict = f"{wrong}{row['differ']:,} of {row['pixels']:,} pixels differ from double, {row['unexplained']:,} unexplained"
    return f"""<li><img src="{text(model.name)}_seen.png" alt="{text(model.what)}">
<p><b>{text(model.what)}</b></p>
<p><code>{text(first_command(model, folder))}</code></p>
<p class="said">{text(row['chosen'])}</p>
<p class="said">{text(verdict)}</p>
<p class="said">{text(row['took'])}</p></li>
"""


def page(models, rows, board, folder):
    """The page's text."""
    head = f"""<h1>Models as people have them</h1>
<p>{len(models)} models, made by this project from the seed {showcase_models.SEED}, and drawn on {html.escape(board)} by the command that
stands with each: nothing else was given.</p>
"""
    return _HEAD + head + "<ul>\n" + "".join(_entry(model, row, folder) for model, row in zip(models, rows)) + "</ul>\n"


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    models, rows = chosen(options.only), []
    output.make_folder(options.build)
    with output.replaced_folder(options.out, PATTERNS) as folder, scratch.folder("showcase", options.build) as work:
        for model in steps("drawing models", models):
            rows.append(draw(model, folder, work, options))
        output.write_json(folder / "summary.json", {"seed": showcase_models.SEED, "board": options.board, "models": rows})
        output.write_file(folder / "index.html", page(models, rows, options.board, one_line(options.out)))
    wrong = [row["name"] for row in rows if not row["pass"]]
    print(f"models drawn           {len(rows)}, {sum(row['wrong_by_order'] or 0 for row in rows):,} pixels wrong by the order")
    print(f"{'FAIL: ' + ', '.join(wrong) if wrong else 'pass'}: {one_line(options.out)}/index.html")
    return 1 if wrong else 0
