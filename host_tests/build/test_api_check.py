# SPDX-License-Identifier: MIT
"""make api-check without abidiff: when there is no tag, what a version may break, and what of abidiff's words is a change.
host_tests/anywhere/release compares libraries."""

import subprocess

import pytest

from conftest import dry_run
from fixel.base.errors import ToolError
from fixel.package import api, repository

SAID = "Functions changes summary: {} Removed, {} Changed (7 filtered out), {} Added functions\n"


@pytest.fixture(name="root")
def fixture_root(tmp_path):
    """A repository with one commit."""
    for words in (["init", "--quiet"], ["commit", "--quiet", "--allow-empty", "-m", "All"]):
        subprocess.run(["git", "-c", "user.name=a", "-c", "user.email=a@b", *words], cwd=tmp_path, check=True)
    return tmp_path


def test_before_the_first_tag_there_is_nothing_to_compare(root, capsys):
    assert api.check(root) == 0
    assert capsys.readouterr().out == "api: no tag to compare\n"


def test_the_last_tag_is_that_of_a_version(root):
    for tag in ("v0.9.0", "vendor", "trial"):
        subprocess.run(["git", "tag", tag], cwd=root, check=True)
    assert repository.last_tag(root) == "v0.9.0"


def test_without_abidiff_it_is_not_run(root, monkeypatch):
    monkeypatch.setattr(api.shutil, "which", lambda name: None)
    with pytest.raises(ToolError, match="not run: needs abidiff"):
        api.compared(root, "v0.9.0")


def test_a_folder_without_git_is_refused(tmp_path):
    with pytest.raises(ToolError, match="needs a checkout of git"):
        api.check(tmp_path)


@pytest.mark.parametrize("before, now, allowed", [
    ("0.9.0", "0.9.1", False), ("0.9.0", "0.10.0", True), ("0.9.3", "1.0.0", True), ("1.2.0", "1.3.0", False), ("1.9.0", "2.0.0", True),
    ("0.9.0", "0.9.0", False), ("1.0.0", "0.10.0", False)])
def test_what_a_version_may_break(before, now, allowed):
    assert api.may_break(before, now) is allowed


@pytest.mark.parametrize("said, new", [
    (SAID.format(0, 0, 3), True), (SAID.format(1, 0, 3), False), (SAID.format(0, 12, 0), False), ("", False),
    (SAID.format(0, 0, 0) + "Unreachable types summary: 0 removed, 1 changed, 0 added type\n", False),
    (SAID.format(0, 0, 0) + "Unreachable types summary: 0 removed, 0 changed (1 filtered out), 1 added types\n", True)])
def test_what_is_new_alone_is_no_change(said, new):
    assert api.is_all_new(said) is new


def test_an_enumeration_without_a_name_gets_that_of_its_first_member():
    header = "typedef enum { A } a;\nenum { /* of b */\n    FXL_B, FXL_C };\nenum d { FXL_D };\n"
    assert api.with_names(header) == header.replace("enum { /* of b", "enum of_FXL_B { /* of b")


def test_make_installs_nothing_for_it_before_the_first_tag():
    assert "tools/setup.sh tools" in dry_run("api-check").stdout
