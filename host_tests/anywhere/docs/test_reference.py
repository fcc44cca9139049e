# SPDX-License-Identifier: MIT
"""make docs: of the reference, a type or a function without a comment is an error."""

import pytest

from fixel.site import reference
from outside import need

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


def made(folder, text):
    need("doxygen")
    wrong, *counts = reference.written({"fixel/short.h": text}, folder)
    return wrong, counts, (folder / "xml" / "short_8h.xml").read_text(encoding="utf-8")


def test_a_page_for_each_header_and_one_that_lists_them():
    texts = reference.headers(reference.HEADERS)
    pages = reference.pages(texts)
    assert len(pages) == len(texts) + 1 > 30
    for header in texts:
        assert f"[{header}](" in pages["index.md"] and f".. doxygenfile:: {header.rsplit('/', maxsplit=1)[-1]}\n" in "".join(pages.values())


def test_statuses_and_shared_comments_are_laid_out(tmp_path):
    wrong, counts, page = made(tmp_path, HEADER)
    assert not wrong and counts == [2, 1]
    assert page.count('kind="retval"') == 2 and page.count("it is too large.") == 2 and page.count("nothing is changed.") == 2
    assert "structfxl__pair" in page
    members = (tmp_path / "xml" / "structfxl__pair.xml").read_text(encoding="utf-8")
    assert members.count("in pixels") == 2 and "<computeroutput>x</computeroutput> and &lt;y&gt;." in members


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
