# SPDX-License-Identifier: MIT
"""The clippers that commands take, so that a test with all of them has no list of its own."""

import re

from conftest import CHECKOUT


def clipper_names(but=()):
    """The names that CLIPPER= takes, in their order, without those of `but`."""
    makefile = (CHECKOUT / "firmware" / "firmware.mk").read_text(encoding="utf-8")
    names = re.search(r"^CLIPPERS := (.*)$", makefile, re.MULTILINE)[1].split()
    assert set(but) <= set(names), f"{sorted(set(but) - set(names))} are no clippers"
    return [name for name in names if name not in but]
