# SPDX-License-Identifier: MIT
"""host_tests/fuzz/wraps.txt: each function and file that the fuzzer lets wrap is there, and has arithmetic."""

import re

from conftest import CHECKOUT

LIST = CHECKOUT / "host_tests" / "fuzz" / "wraps.txt"
# A definition begins a line with its type, whose name may stand on the next one, and is followed by a body, before which
# contracts may stand.
DEFINITION = r"^(?!return|else)[A-Za-z][\w (),]*[ *\n]{name}\((?:[^()]|\([^()]*\))*\)(?:\s+FXL_[A-Z]+\([^;{{]*\))?\s*\{{"


def entries(kind):
    return re.findall(rf"^{kind}:(\S+)$", LIST.read_text(encoding="utf-8"), re.MULTILINE)


def test_each_function_that_may_wrap_is_defined():
    sources = "\n".join(file.read_text(encoding="utf-8") for file in sorted((CHECKOUT / "lib").rglob("*.[ch]")))
    missing = [name for name in entries("fun") if not re.search(DEFINITION.format(name=re.escape(name)), sources, re.MULTILINE)]
    assert missing == [] and len(entries("fun")) > 60


def test_each_file_that_may_wrap_is_there():
    files = [str(file.relative_to(CHECKOUT)) for file in (CHECKOUT / "lib").rglob("*.[ch]")]
    assert [name for name in entries("src") if name.removeprefix("*") not in files] == []


def test_what_wraps_on_purpose_is_listed():
    """A sum of light that falls along a row, and the count of cached instances."""
    assert {"fxl_segment_weight", "next_tag"} <= set(entries("fun"))
