# SPDX-License-Identifier: MIT
"""host_tests/fuzz/wraps.txt: each function and file that the fuzzer lets wrap is there, and has arithmetic; no other check is off
in them."""

import collections
import concurrent.futures
import functools
import itertools
import os
import re
import shlex
import shutil
import subprocess

import pytest
from conftest import CHECKOUT

BUILT_PROGRAMS = ()
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


# --- what the list turns off ------------------------------------------------------------------

INCLUDES = ["-I", CHECKOUT / "lib" / "include", "-I", CHECKOUT / "lib"]
CLANGS = [name for name in ("clang-19", "clang-14", "clang") if shutil.which(name)]
SUM = re.compile(r"__ubsan_handle_(add|sub|mul|negate)_overflow")     # of signed numbers, and of unsigned ones
# What clang writes of a source: the name of the source, the functions, and what they call of the sanitizers.
WRITTEN = re.compile(r'^source_filename = "(.*)"$|^define [^@]*@(\w+)\(|^  call void @(__asan_report\w+|__ubsan_handle\w+)\(', re.MULTILINE)


def calls_of(clang, sources, *flags):
    """How often each function of each source calls each report of the sanitizers, as (function, report): count. Nothing is
    optimised, so the calls of one check do not depend on another. One process compiles all, and writes no machine code:
    to start took half the time."""
    said = subprocess.run([clang, "-###", "-std=c11", "-O0", "-g0", "-S", "-emit-llvm", "-o", "-", *INCLUDES, "-fsanitize=address,undefined",
                           "-fno-sanitize-recover=all", "-mllvm", "-asan-opt=0", "-DFXL_ASSERT_HOOK", *flags, sources[0]], check=True,
                          text=True, capture_output=True).stderr
    words = shlex.split(said.splitlines()[-1])
    assert words[1] == "-cc1" and words[-1] == str(sources[0])
    done = subprocess.run([*words[:-1], *sources], check=True, text=True, capture_output=True)
    function, calls = "", {}
    for source, begun, call in WRITTEN.findall(done.stdout):
        if source:
            counted = calls[source] = collections.Counter()
        elif begun:
            function = begun
        else:
            counted[function, call] += 1
    return [calls[str(source)] for source in sources]


@functools.cache
def defined_in(file):
    return set(re.findall(DEFINITION.format(name=r"(\w+)"), file.read_text(encoding="utf-8"), re.MULTILINE))


def listed_functions(source):
    """Of a source: those by name, and those of listed files. What a listed file includes is not listed."""
    files = [CHECKOUT / name.removeprefix("*") for name in entries("src")]
    headers = set().union(*(defined_in(file) for file in files if file.suffix == ".h"))
    return set(entries("fun")) | (defined_in(source) if source in files else headers - defined_in(source))


@pytest.mark.parametrize("clang", CLANGS[:1] + [name for name in CLANGS[1:] if name != "clang"])
def test_the_list_turns_off_one_check(clang):
    """Each function of the library has the same calls with and without the list, but for those of unsigned overflow."""
    sources = sorted((CHECKOUT / "lib").glob("*/*.c"))
    ignored = ["-fsanitize=unsigned-integer-overflow", f"-fsanitize-ignorelist={LIST}"]

    processors = os.cpu_count() or 1
    parts = [sources[first::processors] for first in range(processors)]
    with concurrent.futures.ThreadPoolExecutor(processors) as pool:
        found = list(pool.map(lambda part: list(zip(part, calls_of(clang, part), calls_of(clang, part, *ignored))), parts))
    wrong, sums, seen = [], 0, set()
    for source, without, with_list in itertools.chain(*found):
        listed = listed_functions(source)
        for key in without | with_list:
            function, report = key
            more = with_list[key] - without[key]
            if function in listed:
                seen.add(function)
            elif SUM.match(report):     # the check of unsigned sums is on
                sums += more > 0
                more = min(more, 0)
            if more:
                wrong.append((source.name, function, report, without[key], with_list[key]))
    assert wrong == []
    assert sums > 100 and len(seen) > 60


PLANTED = {"": 0,
           "volatile int32_t most = INT32_MAX; most = most + (int32_t)(angle % 2 + 1);": 1,
           "static const uint8_t few[4] = {1, 2, 3, 4}; volatile uint8_t taken = few[angle % 2 + 4]; (void)taken;": 1,
           "volatile uint32_t moved = 1; moved = moved << (angle % 2 + 32);": 1}


@pytest.mark.skipif(not CLANGS, reason="no clang")
@pytest.mark.parametrize("planted", PLANTED)
def test_faults_in_a_listed_function_are_seen(planted, tmp_path):
    """A signed overflow, a bad index and a bad shift in fxl_cos, whose own sum wraps on purpose."""
    text = (CHECKOUT / "lib" / "math" / "angle.c").read_text(encoding="utf-8")
    body = "    return fxl_sin(angle + FXL_ANGLE_QUARTER);\n"
    assert text.count(body) == 1 and "fxl_cos" in entries("fun")
    (tmp_path / "main.c").write_text(text.replace('#include "', f'#include "{CHECKOUT}/lib/math/').replace(f"{CHECKOUT}/lib/math/fixel", "fixel")
                                     .replace(body, planted + "\n" + body) +
                                     "int main(int count, char **words)\n{\n    (void)words;\n"
                                     "    return fxl_cos(0xF0000000u + (uint32_t)count) == 0;\n}\n", encoding="utf-8")
    others = [CHECKOUT / "lib" / "math" / "arith.c"]
    flags = ["-fsanitize=undefined,unsigned-integer-overflow", "-fsanitize-trap=all"]     # needs no run-time library
    for ignored, ends in (([f"-fsanitize-ignorelist={LIST}"], bool(PLANTED[planted])), ([], True)):
        subprocess.run([CLANGS[0], "-std=c11", "-O1", *INCLUDES, *flags, *ignored, tmp_path / "main.c", *others, "-o", tmp_path / "main"], check=True)
        assert (subprocess.run([tmp_path / "main"]).returncode < 0) == ends
