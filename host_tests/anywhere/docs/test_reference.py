# SPDX-License-Identifier: MIT
"""make docs: the reference has each public function, and a type or a function without a comment is an error."""

import re

import pytest

from conftest import CHECKOUT
from fixel.package import docs
from outside import need, run

HEADER = """/* SPDX-License-Identifier: MIT */
/* A header. It is short. */
#ifndef SHORT_H
#define SHORT_H

/* A type: `x` and <y>. */
typedef struct {
    int first, second; /* in pixels */
} fxl_pair;

/* Adds. See fxl_pair.
 * FXL_E_RANGE: it is too large.
 * With each of these statuses: nothing is changed. */
int fxl_add(const fxl_pair *pair);
int fxl_add_again(const fxl_pair *pair);

#endif
"""


@pytest.fixture(scope="module", name="pages")
def fixture_pages(tmp_path_factory):
    need("doxygen")
    folder = tmp_path_factory.mktemp("docs") / "pages"
    run("make", "docs", f"OUT={folder}", folder=CHECKOUT)
    return {file.name: file.read_text(encoding="utf-8") for file in folder.glob("*.html")}


def made(folder, text):
    need("doxygen")
    wrong, *counts = docs.written({"fixel/short.h": text}, folder)
    return wrong, counts, (folder / "html" / "short_8h.html").read_text(encoding="utf-8")


def test_every_public_function_is_in_it(pages):
    texts = docs.headers(docs.HEADERS)
    named = {name for text in texts.values() for name in re.findall(r"^\w[\w ]*[ *](fxl_\w+)\(", text, re.MULTILINE)}
    listed = "".join(text for name, text in pages.items() if name.startswith("globals_func"))
    assert len(named) > 110 and not [name for name in named if not re.search(rf"<li>{name}\(\)", listed)]


def test_its_first_page_names_every_header(pages):
    for header in docs.headers(docs.HEADERS):
        assert f">{header}</a>: " in pages["index.html"]


def test_statuses_and_shared_comments_are_laid_out(tmp_path):
    wrong, counts, page = made(tmp_path, HEADER)
    assert not wrong and counts == [2, 1]
    assert page.count("<dt>Return values</dt>") == 2 and page.count("it is too large.") == 2 and page.count("nothing is changed.") == 2
    assert "structfxl__pair.html" in page
    members = (tmp_path / "html" / "structfxl__pair.html").read_text(encoding="utf-8")
    assert members.count("in pixels") == 2 and "<code>x</code> and &lt;y&gt;." in members


@pytest.mark.parametrize("before, after, said", [
    ("/* A type: `x` and <y>. */\n", "", "lib/include/fixel/short.h:6: Compound fxl_pair is not documented."),
    ("int fxl_add_again", "\nint fxl_add_again", "lib/include/fixel/short.h:16: Member fxl_add_again(const fxl_pair *pair) (function)"),
    ("/* Adds. See fxl_pair.", "/* Adds. See fxl_pair and #fxl_pears.", None),
    ("int fxl_add(const", "int fxl_plus(const", None)])
def test_what_has_no_comment_is_an_error(tmp_path, before, after, said):
    assert before in HEADER
    wrong, _, _ = made(tmp_path, HEADER.replace(before, after))
    assert [line for line in wrong if line.startswith(said)] if said else not wrong, wrong


def test_a_name_that_leads_nowhere_is_an_error(tmp_path):
    """It is in the text of a header, but Doxygen finds nothing that it could lead to."""
    wrong, _, _ = made(tmp_path, HEADER.replace("#endif\n", "typedef fxl_nowhere fxl_other;\n#endif\n").replace("See fxl_pair.", "See fxl_nowhere."))
    assert [line for line in wrong if "explicit link request to 'fxl_nowhere' could not be resolved" in line], wrong
