# SPDX-License-Identifier: MIT
"""Writes all documents: the Markdown of the tree as pages, by Sphinx with MyST and Furo, and the reference of all public functions.

The Markdown stays as it stands in the tree. Sphinx reads a copy, in which a link to a file that is no document leads to a copy of that
file, as text; the link of a folder leads to its README, or to a list of what is in it. Warnings of Sphinx are errors: a link that leads
nowhere is one.

Exit: 0 written; 1 a comment of a header is missing, or names what is not there; 2 a document that Sphinx warns of, or something is missing.
"""

import argparse
import fnmatch
import html
import os
import pathlib
import re
import shutil
import sys

from fixel.base import children, output, progress, scratch, version
from fixel.base.errors import ToolError
from fixel.package import repository
from fixel.site import reference

ROOT = pathlib.Path(__file__).resolve().parents[3]
# {what a reader wants: its documents, in this order}: a pattern takes those that no line above it has named.
GROUPS = {
    "Begin": ["README.md", "docs/hello.md", "docs/tutorials/README.md", "docs/tutorials/*.md", "docs/features.md", "docs/examples.md", "docs/looks.md"],
    "Do": ["docs/commands.md", "docs/scenes.md", "docs/boards.md", "docs/view.md", "docs/site.md", "docs/displays.md", "docs/flashing.md", "docs/setup.md", "docs/packages.md", "docs/rust.md",
           "docs/lvgl.md", "docs/opengl.md", "docs/crc.md", "docs/results.md", "docs/campaigns.md", "ports/*.md", "boards/*.md", "examples/*.md"],
    "Look up": ["SPEC.md", "docs/accuracy.md", "docs/evidence.md", "docs/formats.md", "docs/extras/*.md", "docs/performance.md", "docs/faces.md", "docs/clipping.md",
                "docs/seeds.md"],
    "Understand": ["DESIGN.md", "SOUNDNESS.md", "docs/safety/*.md", "CONTRIBUTING.md", "lib/*.md", "host_tests/*.md", "SECURITY.md", "CHANGELOG.md"],
}
BELOW = ("ports/*/*.md", "host_tests/*/*.md")   # documents that the list of contents leaves to a page which names them
REFERENCE, REFERENCE_IN = "reference/index", "Look up"  # the reference's page, and its group
NO_DOCUMENTS = (".github/*", "tools/*")     # forms, and what programs are made of
LINK = re.compile(r"(!?\[[^\]]*\]\()([^)\s#:]+)((?:#[^)\s]*)?\))")
FENCE = re.compile(r"^(?:```.*?^```$|    .*?$)", re.MULTILINE | re.DOTALL)
PICTURES = (".png", ".webp", ".svg")
UNNAMED = re.compile(r'<p class="breathe-sectiondef-title[^>]*>Unnamed Group</p>')     # functions that share a comment
STYLE = re.compile(r"<style>(.*?)</style>", re.DOTALL)       # that of the theme is the same in each page
# A function or type has the id that Sphinx gives it, and one of Doxygen's, which is long.
TARGET = re.compile(r'(<dt class="sig sig-object c" id="([^"]+)">)\s*<span class="target" id="([^"]+)"></span>')
PLACE = re.compile(r'#(\w+)"')
SYMBOL = re.compile(r'<symbol id="([\w-]+)".*?</symbol>\s*', re.DOTALL)      # of the theme's pictures a page uses some: these, in fewer strokes
STROKES = {"svg-toc": "M4 6h16M4 12h16M4 18h10", "svg-menu": "M3 6h18M3 12h18M3 18h18", "svg-arrow-right": "M9 18l6-6-6-6", "svg-moon": "M20 14A8 8 0 1 1 10 4a7 7 0 0 0 10 10z",
           "svg-sun": "M17 12a5 5 0 1 1-10 0 5 5 0 0 1 10 0M12 2v2M12 20v2M2 12h2M20 12h2M5 5l1 1M18 18l1 1M5 19l1-1M18 6l1-1"}
STROKED = '<symbol id="{}" viewBox="0 0 24 24"><path d="{}" fill="none" stroke="currentColor" stroke-width="1.5"/></symbol>\n'
# Of the theme: two pictures for a mode that its words name too, and a class that it gives no look. A line of the list of contents has no class.
SHORTER = {'"#svg-sun-with-moon"': '"#svg-sun"', '"#svg-moon-with-sun"': '"#svg-moon"', 'class="reference internal"': 'class="reference"',
           '<li class="toctree-l1"><a class="reference"': "<li><a"}
UNCOLOURED = re.compile(r'<span class="[npw]">([^<]*)</span>')      # names, punctuation and blanks of code have the colour of all of it
LITERAL = re.compile(r'<code class="docutils literal notranslate">((?:<span class="pre">[^<]*</span>\s*)+)</code>')
WORD = re.compile(r'<span class="pre">([^<]*)</span>')
LAST_STYLES = "_static/styles/furo-extensions.css"
# So the theme's rules name what these leave.
STYLES = {"_static/styles/furo.css": {"code.literal": "code", ".toctree-l1>.reference": "li>a", ".sidebar-tree .reference": ".sidebar-tree li>a",
                                      "current-page>.reference": "current-page>a", "current>.reference": "current>a"},
          "_static/basic.css": {"span.pre {": "code:not(:has(span)), code span {"}}
FOR_KEYS = {'<p class="caption" role="heading">': '<p class="caption" role="heading" aria-level="2">', "<pre>": '<pre tabindex="0">',
            '<div class="table-wrapper': '<div tabindex="0" class="table-wrapper'}
FILES = "files"     # the folder of the copies of files
LISTED_MOST = 96 << 10     # bytes of a folder whose list leads to copies of its files; that of a larger one names them
SETTINGS = """
project = "Fixel"
html_title = "Fixel {version}"
copyright = "the authors of Fixel"
extensions = ["myst_parser", "breathe"]
breathe_projects = {{"fixel": "{read}"}}
breathe_default_project = "fixel"
breathe_domain_by_extension = {{"h": "c"}}
breathe_show_include = False
suppress_warnings = ["duplicate_declaration.c"]     # a function whose symbol a macro renames
myst_heading_anchors = 6
myst_url_schemes = {{"http": None, "https": None, "tree": "{{{{path}}}}"}}
root_doc = "index"
exclude_patterns = ["{files}"]
html_theme = "furo"
html_favicon = "docs/cube.png"
html_copy_source = False
html_use_index = False
html_show_sourcelink = False
html_show_search_summary = False    # it would fetch pages, which a browser refuses where these are files
html_theme_options = {{"navigation_with_keys": True}}
html_extra_path = ["{extra}"]


def setup(app):
    from pygments.lexers.special import TextLexer
    for name in ("ld", "obj", "mtl"):   # of fences, which have no colours
        app.add_lexer(name, TextLexer)
"""


def of_the_tree():
    """All files of the tree, from its root."""
    names = repository.git(ROOT, "ls-files", "-z", "--cached", "--others", "--exclude-standard").decode().split("\0")
    return [name for name in names if name and (ROOT / name).is_file()]


def grouped(names):
    """{group: documents}; a document that no group takes is refused."""
    left = [name for name in names if name.endswith(".md") and not any(fnmatch.fnmatch(name, pattern) for pattern in NO_DOCUMENTS)]
    found = {}
    for group, patterns in GROUPS.items():
        found[group] = []
        for pattern in patterns:
            taken = sorted(name for name in left if fnmatch.fnmatch(name, pattern))
            found[group] += taken
            left = [name for name in left if name not in taken]
    if left:
        raise ToolError(f"{left[0]}: no group of the site's documents takes it; tools/fixel/site/docs.py lists them")
    return found


class Tree:
    """The tree's files, and the copies of those that documents name."""

    def __init__(self, names, folder):
        self.names = set(names)
        self.folder = folder / FILES    # below html_extra_path: the site's documents have it as FILES
        self.folders = {str(parent) for name in names for parent in pathlib.PurePosixPath(name).parents}

    def leads_to(self, document, link):
        """Where the link of a document leads in the copy; the link itself where it is a document, or nothing of the tree."""
        place = os.path.normpath(os.path.join(os.path.dirname(document), link))
        up = "../" * document.count("/")
        if place in self.names:
            return link if place.endswith((".md", *PICTURES)) else f"tree:{up}{self.copy(place)}"
        if place in self.folders:
            readme = os.path.join(place, "README.md")
            return os.path.join(link, "README.md") if readme in self.names else f"tree:{up}{self.listed(place)}"
        return link

    def copy(self, name):
        """A copy of a file as text. Its place in the site's documents."""
        made = self.folder / FILES / (name + ".txt")
        if not made.exists():
            made.parent.mkdir(parents=True, exist_ok=True)
            made.write_bytes((ROOT / name).read_bytes())
        return f"{FILES}/{name}.txt"

    def listed(self, place):
        """A page that lists the files of a folder, with their copies where it is not too large. Its place in the site's documents."""
        page = self.folder / FILES / place / "list.html"
        if not page.exists():
            page.parent.mkdir(parents=True, exist_ok=True)
            names = sorted(name for name in self.names if name.startswith(place + "/"))
            up = "../" * (place.count("/") + 2)
            is_copied = sum((ROOT / name).stat().st_size for name in names) <= LISTED_MOST
            rows = "".join(f"<li>{self.row(name, up, is_copied)}</li>" for name in names)
            page.write_text(f'<!DOCTYPE html><html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width">'
                            f"<title>{html.escape(place)}</title><h1>{html.escape(place)}</h1><ul>{rows}</ul></html>\n", encoding="utf-8")
        return f"{FILES}/{place}/list.html"

    def row(self, name, up, is_copied):
        """A file's line of a list: a document leads to its page."""
        text = html.escape(name)
        if not name.endswith(".md") and not is_copied:
            return text
        return f'<a href="{html.escape(up + (name.removesuffix(".md") + ".html" if name.endswith(".md") else self.copy(name)))}">{text}</a>'


def copied(text, document, tree):
    """The text of a document as Sphinx reads it. What is code stays."""
    made, end = [], 0

    def led(part):
        return LINK.sub(lambda found: found[1] + tree.leads_to(document, found[2]) + found[3], part)
    for code in FENCE.finditer(text):
        made += [led(text[end:code.start()]), code[0]]
        end = code.end()
    return "".join(made) + led(text[end:])


def is_below(name):
    """Whether the list of contents leaves a document out."""
    return any(fnmatch.fnmatch(name, pattern) for pattern in BELOW)


def contents(groups):
    """The page of all documents."""
    parts = ["# Documents\n"]
    for group, names in groups.items():
        lines = "\n".join(name.removesuffix(".md") for name in names if not is_below(name)) + (f"\n{REFERENCE}" if group == REFERENCE_IN else "")
        parts.append(f"```{{toctree}}\n:maxdepth: 1\n:caption: {group}\n\n{lines}\n```\n")
    return "\n".join(parts)


def for_models(groups, sentence, up):
    """llms.txt: what there is to read, for who reads by a model. up: where the documents are."""
    parts = [f"# Fixel\n\n> {sentence}\n"]
    for group, names in groups.items():
        lines = "\n".join(f"- [{title_of(name)}]({up}{name.removesuffix('.md')}.html)" for name in names)
        parts.append(f"## {group}\n\n{lines}\n")
    return "\n".join([*parts, f"## Each public function and type\n\n- [Reference]({up}{REFERENCE}.html)\n"])


def title_of(name):
    """The first heading of a document, as text."""
    found = re.search(r"^# (.+)$", (ROOT / name).read_text(encoding="utf-8"), re.MULTILINE)
    return found[1].replace("`", "") if found else name


def _stage(folder):
    """What Sphinx reads, in folder/source: how many documents, functions and types."""
    names = of_the_tree()
    groups = grouped(names)
    source, tree = folder / "source", Tree(names, folder)
    for name in [name for group in groups.values() for name in group]:
        place = source / name
        place.parent.mkdir(parents=True, exist_ok=True)
        text = copied((ROOT / name).read_text(encoding="utf-8"), name, tree)
        place.write_text(("---\norphan: true\n---\n" if is_below(name) else "") + text, encoding="utf-8")
    for name in names:
        if name.startswith("docs/") and name.endswith(PICTURES):
            (source / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / name, source / name)
    pages, functions, types = reference.read(folder)
    (source / "reference").mkdir()
    for name, text in pages.items():
        (source / "reference" / name).write_text(text, encoding="utf-8")
    (source / "index.md").write_text(contents(groups), encoding="utf-8")
    (source / "conf.py").write_text(SETTINGS.format(version=version.version(), files=FILES, extra=tree.folder, read=folder / "xml"), encoding="utf-8")
    return sum(map(len, groups.values())), functions, types


def write(out, folder):
    """Makes the documents in out. folder: one for what Sphinx reads. How many documents, functions and types there are."""
    counts = _stage(folder)
    done = children.run([sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-d", folder / "kept", folder / "source", out], text=True)
    if done.returncode:
        raise ToolError("the documents: Sphinx warns", words=(done.stdout or "") + (done.stderr or ""))
    for file in [*out.rglob("*.map"), out / ".buildinfo", out / "objects.inv"]:
        file.unlink()
    with open(out / LAST_STYLES, "a", encoding="utf-8") as styles:
        styles.write(STYLE.search((out / "index.html").read_text(encoding="utf-8"))[1])
    texts = {page: page.read_text(encoding="utf-8") for page in out.rglob("*.html")}
    places = {target: place for text in texts.values() for _, place, target in TARGET.findall(text)}
    for page, text in texts.items():
        page.write_text(finished(text, places), encoding="utf-8")
    for name, changes in STYLES.items():
        (out / name).write_text(replaced((out / name).read_text(encoding="utf-8"), changes), encoding="utf-8")
    return counts


def replaced(text, changes):
    """A text with each of the changes, {what stands there: what shall}."""
    for before, after in changes.items():
        text = text.replace(before, after)
    return text


def literal(found):
    """Code in a sentence: a word of several has an element, so that no line ends in it."""
    words = WORD.findall(found[1])
    return "<code>" + (words[0] if len(words) == 1 else WORD.sub(r"<span>\1</span>", found[1])) + "</code>"


def finished(text, places):
    """A page without the blanks at the beginning of its lines, but in what is laid out, and without what it needs not; what scrolls is reached
    by keys, and a caption of contents has a level. places: {an id of Doxygen's: that which stays}."""
    text = PLACE.sub(lambda found: f'#{places.get(found[1], found[1])}"', TARGET.sub(r"\1", text))
    text = replaced(STYLE.sub("", UNNAMED.sub("", text)), {**FOR_KEYS, **SHORTER})
    text = UNCOLOURED.sub(r"\1", WORD.sub(r"\1", LITERAL.sub(literal, text)))
    text = SYMBOL.sub(lambda found: STROKED.format(found[1], STROKES[found[1]]) if f'"#{found[1]}"' in text else "", text)
    parts = re.split(r"(<pre\b.*?</pre>)", text, flags=re.DOTALL)
    return "".join(part if number % 2 else re.sub(r"\n\s+", "\n", part) for number, part in enumerate(parts))


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    made.add_argument("--out", type=pathlib.Path, default=pathlib.Path("build/docs"), metavar="FOLDER", help="where to (build/docs)")
    return made


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    output.make_folder(options.out.parent)
    with scratch.folder("docs", options.out.parent) as made, progress.Progress("documents"):
        folder = pathlib.Path(made)
        documents, functions, types = write(folder / "out", folder)
        put(folder / "out", options.out)
    print(f"docs: {documents} documents, {functions} functions and {types} types: {options.out / 'index.html'}")
    return 0


def put(made, out):
    """A finished folder takes the place of an earlier one of the same kind; any other is refused."""
    if out.exists() and any(out.iterdir()) and not (out / "index.html").is_file():
        raise ToolError(f"{out}: has files that are no site; name another folder")
    if out.exists():
        shutil.rmtree(out)
    made.rename(out)
