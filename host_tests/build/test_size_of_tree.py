# SPDX-License-Identifier: MIT
"""What the project consists of, and that no count passes its record in silence."""

import json

from conftest import run_cli, write_files
from fixel.check import places, size_of_tree

BUILT_PROGRAMS = ()


def test_no_count_is_above_its_record(tmp_path):
    done = run_cli("size-of-tree", "--json", tmp_path / "tree.json")
    assert done.returncode == 0, done.stdout + done.stderr
    found = json.loads((tmp_path / "tree.json").read_text(encoding="utf-8"))
    assert found["above"] == [] and set(found["counts"]) == set(found["record"])
    assert found["counts"]["build steps of make test"] > found["counts"]["build steps of make run"] > 100


def test_growth_is_measured_from_the_record():
    """Two hundredths more pass, and a small number may not grow at all."""
    record = {"files": 1000, "public headers": 30}
    assert size_of_tree.grown({"files": 1020, "public headers": 30}, record) == []
    assert size_of_tree.grown({"files": 1021, "public headers": 31}, record) == ["files", "public headers"]
    assert size_of_tree.grown({"lines of lib, Zig": 1}, record) == ["lines of lib, Zig"]


def test_a_line_of_code_is_no_comment_no_docstring_and_not_blank(tmp_path):
    texts = {"lib/a.c": "/* one\n two */\nint a; /* three */\n\n// four\nint b;\n", "lib/a.S": "/* one */\n    nop\n", "lib/b_armv7m.h": "    nop\n",
             "tools/a.py": '"""One\n\ntwo."""\n\n# three\nA = """4\n5"""\ndef f():\n    """Six."""\n    return A\n',
             "host_tests/a.toml": "# one\na = 1\n", "docs/a.md": "no code\n",
             "host_tests/proofs/a/a.c": '/* [[row]]\n * function = "f"\n * checks = 1\n */\nvoid f(void);\n'}
    write_files(tmp_path, texts)
    assert size_of_tree.count_lines(texts, tmp_path) == {
        "lines of host_tests, C": 1, "lines of host_tests, TOML": 4, "lines of lib, C": 2, "lines of lib, assembly": 2, "lines of tools, Python": 4}


def test_functions_are_counted_once_wherever_they_are_declared(tmp_path):
    declared = "void fxl_one(int a);\nint fxl_two(void (*f)(int),\n            int b);\n"
    texts = {"lib/include/a.h": declared + "/* fxl_three(); */\n#define FXL_FOUR fxl_four(1);\n", "lib/include/b/c.h": declared,
             "lib/view/d.h": "void fxl_five(void);\n"}
    write_files(tmp_path, texts)
    assert size_of_tree.count_interface(texts, tmp_path) == {"public headers": 2, "public functions": 2}


def test_a_place_is_a_file_with_the_tag(tmp_path):
    """A file counts once, however many tags of the recipe it has."""
    record = '[one]\ntitle = "One"\nfinds = [{ pattern = "one" }]\n[one.no_comment]\n"a figure" = ["lib/c.json"]\n'
    tag = "/* place {}: what */\n"
    write_files(tmp_path, {places.RECORD: record, "lib/a.c": tag.format("one") * 2, "lib/b.c": "one\n", "lib/c.json": "one\n"})
    places.listed("init", "--quiet", folder=tmp_path)
    assert size_of_tree.count_places(tmp_path) == {"places of One": 2}
