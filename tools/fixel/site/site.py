# SPDX-License-Identifier: MIT
"""Writes the site: a page that draws scenes as the library does on a board, what their frames cost, and all documents.

Exit: 0 written; 2 it could not be.
"""

import argparse
import contextlib
import dataclasses
import html
import inspect
import io
import json
import pathlib
import re
import shutil
import zlib

from fixel.base import children, kept, output, progress, scratch, version
from fixel.base.errors import ToolError
from fixel.commands import late

badge, predict, stage_costs = late("fixel.bench", "badge predict stage_costs")
costs, docs, gallery, packing, pages = late("fixel.site", "costs docs gallery packing pages")
image_file = late("fixel.image", "image")
making, scene_options = late("fixel.scene", "making scene_options")
showcase, showcase_models = late("fixel.report", "showcase showcase_models")
dump, emulator, firmware, model_look, rp2040 = late("fixel.board", "dump emulator firmware model_look rp2040")

ROOT = pathlib.Path(__file__).resolve().parents[3]
TEMPLATES = ROOT / "tools" / "templates"
ESBUILD = ROOT / ".node" / "node_modules" / ".bin" / "esbuild"
PICO = "pico"
GAME = ROOT / "examples" / "game" / "game.toml"
FIRST = "plaza"         # the scene of the first page
MODELS = ROOT / "tools" / "fixel" / "report" / "showcase_models.py"
SHOWCASE = "build/showcase"     # of make showcase
# Bytes of a model's image; a larger one is drawn with small textures, then with fewer faces too.
MODEL_MOST, SMALL, FEWER, SIMPLER = 64 << 10, "--texture 32", "--simplify 500", re.compile(r"--simplify \d+ ?")
LEFT_OUT = ("adversarial", "tiny", "knot-moving", "f32p", "w3b", "g2000")   # scenes for tests and for the bench, in which a person sees nothing
DESCRIPTION = "Fixel draws 3-D on microcontrollers without a floating-point unit, with integers alone, the same picture on every core."
# What stands in the page of the live window alone, and in that of the site alone.
OF_THE_OTHER = [re.compile(rf" *<!-- {word} alone -->.*?<!-- end -->\n", re.DOTALL) for word in ("live", "site")]


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--module", type=pathlib.Path, default=pathlib.Path("build/web/walk.wasm"), metavar="FILE", help="the walk as WebAssembly (build/web/walk.wasm)")
    made.add_argument("--judge", type=pathlib.Path, default=pathlib.Path("build/web/judge.wasm"), metavar="FILE", help="the reference renderer as WebAssembly (build/web/judge.wasm)")
    made.add_argument("--counter", type=pathlib.Path, default=pathlib.Path("build/web/counter.wasm"), metavar="FILE", help="what counts a frame, as WebAssembly (build/web/counter.wasm)")
    made.add_argument("--own", type=pathlib.Path, default=pathlib.Path("build/web/own"), metavar="FOLDER", help="what a program of examples/ links as WebAssembly (build/web/own)")
    made.add_argument("--pico", type=pathlib.Path, default=pathlib.Path("build/boards/pico/walk-on-st7789-alone.elf"), metavar="ELF", help="the program of a Pico that needs no host (build/boards/pico/walk-on-st7789-alone.elf)")
    made.add_argument("--game", type=pathlib.Path, default=pathlib.Path("build/boards/pico/game-on-st7789-alone.elf"), metavar="ELF", help="its game (build/boards/pico/game-on-st7789-alone.elf)")
    made.add_argument("--game-here", type=pathlib.Path, default=pathlib.Path("build/boards/host/game"), metavar="FILE", help="the game as a program of this machine (build/boards/host/game)")
    made.add_argument("--out", type=pathlib.Path, default=pathlib.Path("build/site"), metavar="FOLDER", help="where to (build/site)")
    made.add_argument("--build", default="build", help="folder that make builds in")
    return made


def title_of(scene):
    """What a scene file says first of itself, as a sentence, or nothing."""
    lines = scene.read_text(encoding="utf-8").splitlines()
    words = []
    for line in lines[1:]:
        if not line.startswith("# "):
            break
        words.append(line[2:])
    said = " ".join(words)
    return said[:said.index(". ") + 1] if ". " in said else said


def scenes_of(folder):
    """The scene files of a folder that a person looks at, the first page's first."""
    return sorted((file for file in folder.glob("*.toml") if file.stem not in LEFT_OUT), key=lambda file: (file.stem != FIRST, file.stem))


def placed(name, image, folder, build, **more):
    """A compiled scene of the site: its image in folder/scenes, with what it costs on each board in a file beside it; what gallery.write takes."""
    file = folder / "scenes" / f"{name}.fxls"
    if image != file:
        shutil.copyfile(image, file)
    cost = {board: costs.of_scene(pathlib.Path(name), file, board, build) for board in costs.boards(build)}
    for board, each in cost.items():
        if (name, board) != (FIRST, costs.FIRST):
            each.pop("instructions", None)      # which the page counts
    file.with_suffix(".json").write_text(json.dumps(cost, separators=(",", ":")), encoding="utf-8")
    scene = image_file.load(file)
    return {"name": name, "bytes": file.stat().st_size, "frames": scene.frames, "faces": sum(len(model.faces) for model in scene.models), "cost": cost[costs.FIRST], **more}


def write_scenes(folder, build, say):
    """Compiles each scene of scenes/ into folder/scenes."""
    scenes = scenes_of(ROOT / "scenes")
    found = []
    for number, file in enumerate(scenes):
        say(number, len(scenes))
        image = folder / "scenes" / f"{file.stem}.fxls"
        making.build(str(file), str(image))
        name = f"scenes/{file.name}"
        made = placed(file.stem, image, folder, build, title=file.stem, said=title_of(file), file=name, code=file.read_text(encoding="utf-8"))
        board = costs.FIRST if "mean" in made["cost"] else gallery.LARGE_BOARD
        found.append({**made, "command": f"make run BOARD={board} SCENE={name}"})
    return found


def write_models(folder, build, work, say):
    """Makes each model of make showcase, and compiles it into folder/scenes as the first page's board draws it. work: a folder."""
    found = []
    for number, model in enumerate(showcase_models.MODELS):
        say(number, len(showcase_models.MODELS))
        file = showcase_models.write(model, work)
        look, image = kept_image_of(model, file, build, work / model.name)
        command = showcase.first_command(dataclasses.replace(model, look=look), SHOWCASE).replace("make run", f"make showcase ONLY={model.name} && make run BOARD={costs.FIRST}", 1)
        found.append(placed(f"model-{model.name}", image, folder, build, title=model.name, said=f"{model.what[0].upper()}{model.what[1:]}.", command=command,
                            file=f"{MODELS.relative_to(ROOT)}, which makes it", code=inspect.getsource(model.make)))
    return found


def kept_image_of(model, file, build, folder):
    """The same as image_of, kept from one site to the next: the models change with the tools alone."""
    tools = [each for name in ("scene", "model", "image", "report") for each in sorted((ROOT / "tools" / "fixel" / name).glob("*.py"))]
    image, look = folder.with_suffix(".fxls"), folder.with_suffix(".txt")

    def compute():
        used, made = image_of(model, file, build, folder)
        shutil.copyfile(made, image)
        look.write_text(used, encoding="utf-8")
    kept.Kept(build).obtain("model of the site", [model.name, *tools, predict.COSTS, pathlib.Path(build) / "host" / "predict", *costs.boards(build)[costs.FIRST]["settings"]],
                            [image, look], compute)
    return look.read_text(encoding="utf-8"), image


def image_of(model, file, build, folder):
    """(options of look, the scene image that the first page's board draws by these of a model of make showcase). folder: one that is not there yet."""
    folder.mkdir()
    fewest = f"{SIMPLER.sub('', model.look)} {FEWER} {SMALL}".strip()
    for look in (model.look, f"{model.look} {SMALL}".strip(), fewest):
        options = predict.parser().parse_args(["--board", costs.FIRST, "--scene", str(file), *([f"--look={look}"] if look else []), "--build", str(build)])
        scene_options.check(options)
        predict.complete(options)
        if (options.look.simplify or 0) > options.order:
            continue        # more faces than the board orders: to try each way to draw so large a model takes minutes
        with contextlib.suppress(ToolError), contextlib.redirect_stderr(io.StringIO()):
            image = pathlib.Path(model_look.drawn_for(options, predict.room_of(options), build, folder).image)
            if look == fewest or image.stat().st_size <= MODEL_MOST:
                return look, image
    raise ToolError(f"{model.file}: {costs.FIRST} has no room for it")


def bundle(folder, *files):
    """Each file of tools/templates, and what it imports, as one file of the folder."""
    done = children.run([ESBUILD, *(TEMPLATES / file for file in files), "--bundle", "--minify", "--format=esm", "--charset=utf8",
                         "--legal-comments=none", "--log-level=warning", f"--alias:rp2040js={rp2040.PACKAGE}", f"--outdir={folder}"], text=True)
    if done.returncode or done.stderr:
        raise ToolError("esbuild: failed", words=(done.stdout or "") + (done.stderr or ""))


def page(scenes, boards, is_live=False):
    """The first page. is_live: beside a live window, whose server compiles what is dropped on it, and has no other page of the site."""
    options = "".join(f'<option value="{html.escape(board)}">{html.escape(board)} ({html.escape(each["core"])})</option>' for board, each in boards.items())
    data = {"first": scenes[0]["name"], "scenes": [{"name": each["name"], "said": each["said"]} for each in scenes], "boards": boards, "compiles": is_live, "parts": stage_costs.PARTS,
            "badge": {"picture": badge.TEMPLATE.read_text(encoding="utf-8"), "letter": badge.LETTER, "beside": badge.BESIDE}}
    return OF_THE_OTHER[is_live].sub("", pages.filled("site.html", "Fixel: 3-D for microcontrollers without an FPU", DESCRIPTION, "site.js", data,
                                                      version=html.escape(version.version()), boards=options))


def flash_of(elf, file):
    """Writes what a program of the Pico has in its flash; where a scene stands there."""
    program = firmware.load(elf, PICO)
    end = max(program.offset(address) + len(content) for address, content in program.segments)
    file.write_bytes(rp2040.image_of(program)[:end])
    return program.offset(program.scene_base)


def crcs_of_game(program, image, folder):
    """The CRC of each frame of the recorded play as the pixels of a display, by the program of this machine."""
    emulator.run(firmware.HOST, image, program, folder / "game.fxld")
    drawn = dump.read_dump(folder / "game.fxld")
    red, green, blue = drawn.palette[:, 0].astype(int), drawn.palette[:, 1].astype(int), drawn.palette[:, 2].astype(int)
    words = ((red & 0xF8) << 8 | (green & 0xFC) << 3 | blue >> 3).astype(">u2")     # as fxl_pixels_rgb565
    return [f"{zlib.crc32(words[frame.pixels].tobytes()):08x}" for frame in drawn.frames]


def write_pico(folder, options, scenes, work):
    """The page of the emulated Pico, with its programs: one draws each scene, the other one plays the game."""
    scene_at = flash_of(options.pico, folder / "pico.bin")
    flash_of(options.game, folder / "pico-game.bin")
    game = folder / "scenes" / "game.fxls"
    making.build(str(GAME), str(game))
    names = sorted((scene["name"] for scene in scenes), key=lambda name: name != FIRST)
    data = {"scenes": names, "game": crcs_of_game(options.game_here, game, work), "sceneAt": scene_at}
    (folder / "pico.html").write_text(pages.filled("pico.html", "Fixel on an emulated Raspberry Pi Pico", "The program of a Raspberry Pi Pico, run by an emulator in this page.", "pico.js", data),
                                      encoding="utf-8")


def sentence():
    """What the first page says that Fixel is."""
    return html.unescape(re.search(r"<h1>Fixel</h1>\s*<p>(.*?)</p>", pages.template("site.html"))[1])


def sizes(folder):
    """What packing.sizes says of all files, and of what the first page loads."""
    first = [folder / name for name in ("index.html", "site.css", "site.js", "walk.wasm", f"scenes/{FIRST}.fxls", f"scenes/{FIRST}.json")]
    return packing.sizes(file for file in folder.rglob("*") if file.is_file()), packing.sizes(first)


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    if not ESBUILD.exists():
        raise ToolError("not run: needs esbuild: run 'tools/setup.sh site'")
    output.make_folder(options.out.parent)
    with scratch.folder("site", options.out.parent) as made:
        folder, work = pathlib.Path(made) / "site", pathlib.Path(made) / "models"
        (folder / "scenes").mkdir(parents=True)
        work.mkdir()
        bundle(folder, "site.js", "site.css", "judge_worker.js", "pico.js", "pico_worker.js", "program.js")
        with progress.Progress("scenes") as say:
            scenes = write_scenes(folder, options.build, say)
        with progress.Progress("models") as say:
            models = write_models(folder, options.build, work, say)
        with progress.Progress("programs") as say:
            examples = gallery.write_programs(folder, options.own, say)
        with progress.Progress("pictures") as say:
            gallery.write(folder, scenes, models, examples, options.build, say)
        with progress.Progress("documents"):
            count, functions, _ = docs.write(folder / "documents", pathlib.Path(made))
        write_pico(folder, options, scenes, pathlib.Path(made))
        shutil.copyfile(options.module, folder / "walk.wasm")
        shutil.copyfile(options.judge, folder / "judge.wasm")
        shutil.copyfile(options.counter, folder / "counter.wasm")
        (folder / "costs.json").write_text(json.dumps(costs.cores(), separators=(",", ":")), encoding="utf-8")
        shutil.copyfile(ROOT / "docs" / "plaza.png", folder / "plaza.png")
        (folder / "index.html").write_text(page([*scenes, *models], costs.boards(options.build)), encoding="utf-8")
        (folder / "llms.txt").write_text(docs.for_models(docs.grouped(docs.of_the_tree()), sentence(), "documents/"), encoding="utf-8")
        packing.pack_pictures(folder)
        total, first = sizes(folder)
        packing.check(*total)
        docs.put(folder, options.out)
    print(f"site: {count} documents, {functions} functions, {len(scenes)} scenes, {len(models)} models, {len(examples)} programs\n"
          f"  {total[0]:,} bytes, {total[1]:,} as a server packs them; of these the first page loads {first[0]:,}, {first[1]:,} packed\n"
          f"  {options.out / 'index.html'}; to see it draw: python3 -m http.server --directory {options.out} 8066")
    return 0
