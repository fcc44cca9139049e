# SPDX-License-Identifier: MIT
"""fixel test-anywhere: what it says of a file of tests, and that what was not run is never told as passed."""

import pytest
from conftest import CHECKOUT, assert_one_sentence, dry_run, run_cli

from fixel.base.errors import ToolError
from fixel.check import anywhere


def outcome_of(folder, text):
    """The outcome of a file of tests, run by pytest as the command does."""
    file = folder / "test_one.py"
    file.write_text(text, encoding="utf-8")
    code, said, report = anywhere.run_file(file, folder)
    return anywhere.outcome(code, report), said


@pytest.mark.parametrize("text, line", [
    ("def test_a(): pass\ndef test_b(): pass\n", "p: passed: 2 tests"),
    ("import pytest\ndef test_a(): pass\ndef test_b(): pytest.skip('needs conan')\n", "p: passed: 1 tests; not run: needs conan (1 tests)"),
    ("import pytest\ndef test_b(): pytest.skip('needs conan')\n", "p: not run: needs conan (1 tests)"),
    ("import pytest\npytest.importorskip('no_such', reason='needs Dask')\n", "p: not run: needs Dask (1 tests)"),
    ("import pytest\npytest.skip('not today', allow_module_level=True)\n", "p: FAILED: 1 of 1 tests"),
    ("import pytest\ndef test_a(): pass\ndef test_b(): pytest.skip('not today')\n", "p: FAILED: 1 of 2 tests"),
    ("def test_a(): assert 1 == 2\n", "p: FAILED: 1 of 1 tests"),
    ("import no_such_module\n", "p: FAILED: 1 of 1 tests"),
    ("x = 1\n", "p: not run: needs a test"),
])
def test_what_a_line_says(tmp_path, text, line):
    found, said = outcome_of(tmp_path, text)
    assert anywhere.line("p", found) == line, said


def test_figures_of_tests_are_kept(tmp_path):
    found, said = outcome_of(tmp_path, "def test_a(record_property): record_property('figure', '3 pixels')\ndef test_b(): pass\n")
    assert found == {"passed": 2, "failed": 0, "needs": [], "figures": ["3 pixels"]}, said


def test_parts_are_folders_and_make_test_has_none_of_them():
    found = anywhere.files()
    assert "packages/test_cmake" in found
    assert not list((CHECKOUT / "host_tests" / "anywhere").glob("test_*.py")), "make test would run it"
    assert list(anywhere.chosen("packages/test_cmake", found)) == ["packages/test_cmake"]
    assert set(anywhere.chosen("packages", found)) < set(anywhere.chosen("", found)) or set(found) == set(anywhere.chosen("packages", found))
    with pytest.raises(ToolError, match="no part 'package'; did you mean packages"):
        anywhere.chosen("package", found)


def test_an_unknown_part_is_one_sentence():
    assert_one_sentence(run_cli("test-anywhere", "--only", "nowhere"), "nowhere", "packages")


def test_make_passes_the_part_on():
    assert "fixel/launcher.py make test-anywhere" in dry_run("test-anywhere", "ONLY=packages").stdout
