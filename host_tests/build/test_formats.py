# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: The Fixel authors
"""The fields of a scene image are stated once: what C and docs/formats.md say of them is written of their table."""

import pytest
from conftest import CHECKOUT

from fixel.image import fields, formats


@pytest.mark.parametrize("file", list(formats.texts()))
def test_what_was_written_is_what_the_table_says(file):
    assert (CHECKOUT / file).read_text(encoding="utf-8") == formats.texts()[file], "fixel formats renews it"


# place field: that fixel formats has been run
def test_another_field_changes_all_that_is_written(monkeypatch):
    other = fields.Section("other", "other table", (fields.Field("3i", "x", "an x"),), 7, record="fxl_point")
    before = formats.texts()
    monkeypatch.setattr(formats, "SECTIONS", (*fields.SECTIONS, other))
    after = formats.texts()
    assert "SECTION_OTHER = 31," in after["lib/scene/scene_sections.h"] and "| 31 | other | yes | 1..7 | i32 × 3 an x | 12 |" in \
        after["docs/formats.md"]
    assert before["lib/paint/surface_sections.h"] == after["lib/paint/surface_sections.h"]


def test_kinds_and_limits_fit_those_of_the_library():
    assert len(fields.SECTIONS) < 32
    limits = {(section.limit, section.most) for section in fields.SECTIONS if section.limit}
    assert len(limits) == len(dict(limits))     # a limit of C is one number
    assert fields.HEAD.size % 4 == 0 and fields.ENTRY.size % 4 == 0
