# SPDX-License-Identifier: MIT
"""make release: what it refuses, that the same commit gives the same bytes, and the list of what is in them; the files that a release and its
readers need; and make api-check without abidiff. host_tests/anywhere/release builds the Python package and compares libraries."""

import hashlib
import io
import json
import re
import subprocess
import tarfile
import time
import zipfile

import pytest

from conftest import CHECKOUT, dry_run
from fixel.base.errors import ToolError
from fixel.base.version import version
from fixel.package import api_check, release, repository
from fixel.package.packages import table

BUILT_PROGRAMS = ()
SECONDS = 1_900_000_000
COMMIT = "0123456789abcdef0123456789abcdef01234567"
PIP = {f"fixel-{version()}.tar.gz": b"sdist", f"fixel-{version()}-py3-none-linux_x86_64.whl": b"wheel"}


def git(folder, *words):
    subprocess.run(["git", "-c", "user.name=a", "-c", "user.email=a@b", *words], cwd=folder, check=True, capture_output=True)


@pytest.fixture(name="root")
def fixture_root(tmp_path):
    """A repository with one commit of one file."""
    root = tmp_path / "fixel"
    root.mkdir()
    (root / "one.c").write_text("int one;\n", encoding="utf-8")
    git(root, "init", "--quiet")
    git(root, "add", "one.c")
    git(root, "commit", "--quiet", "-m", "One")
    return root


@pytest.fixture(scope="module", name="packages")
def fixture_packages():
    return release.packages(CHECKOUT, SECONDS)


def test_a_clean_checkout_is_taken(root):
    release.refuse_changes(root)
    git(root, "tag", f"v{version()}")
    git(root, "tag", "v0.0.1")
    release.refuse_changes(root)


@pytest.mark.parametrize("name", ["one.c", "new.c"])
def test_a_file_that_differs_from_the_commit_is_named(root, name):
    (root / name).write_text("int two;\n", encoding="utf-8")
    with pytest.raises(ToolError, match=f"these files differ from it: {name}$"):
        release.refuse_changes(root)


def test_of_many_files_five_are_named(root):
    for number in range(7):
        (root / f"{number}.c").touch()
    with pytest.raises(ToolError, match="0.c, 1.c, 2.c, 3.c, 4.c and 2 more$"):
        release.refuse_changes(root)


def test_a_tag_of_another_version_is_refused(root):
    git(root, "tag", "v0.0.1")
    with pytest.raises(ToolError, match=f"tag v0.0.1, and .* says {version()}"):
        release.refuse_changes(root)


def test_a_folder_without_git_is_refused(tmp_path):
    with pytest.raises(ToolError, match="needs a checkout of git"):
        release.refuse_changes(tmp_path)


def test_the_same_commit_gives_the_same_source(root):
    seconds = release.time_of(root)
    made = release.source(root, seconds)
    assert made == release.source(root, seconds)
    (content,) = made.values()
    with tarfile.open(fileobj=io.BytesIO(content)) as archive:
        (member,) = [each for each in archive.getmembers() if each.isfile()]
    assert member.name == f"fixel-{version()}/one.c" and member.mtime == seconds
    assert abs(time.time() - seconds) < 3600


def test_the_same_texts_give_the_same_packages(packages):
    assert set(packages) == {f"fixel-{version()}-{name}.zip" for name in ("one-file", *table())}
    assert packages == release.packages(CHECKOUT, SECONDS)
    later = release.packages(CHECKOUT, SECONDS + 60)
    assert not [name for name in packages if packages[name] == later[name]], "the time of the commit is in each"


def test_an_archive_has_one_folder_with_the_licence(packages):
    for name, content in packages.items():
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            assert archive.testzip() is None
            members = archive.infolist()
        assert [member.filename for member in members] == sorted(member.filename for member in members)
        assert {member.filename.split("/")[0] for member in members} == {"fixel"}
        assert {"fixel/LICENSE"} < {member.filename for member in members}, name
        assert {member.date_time for member in members} == {time.gmtime(SECONDS)[:6]}


def test_the_hashes_are_those_of_the_files(packages, tmp_path):
    release.write(packages, tmp_path)
    assert {file.name for file in tmp_path.iterdir()} == {*packages, release.SUMS}
    subprocess.run(["sha256sum", "--check", "--strict", "--quiet", release.SUMS], cwd=tmp_path, check=True)
    (tmp_path / min(packages)).write_bytes(b"")
    assert subprocess.run(["sha256sum", "--check", "--quiet", release.SUMS], cwd=tmp_path, check=False, capture_output=True).returncode == 1


def test_what_an_earlier_release_wrote_goes_and_other_files_stay(tmp_path):
    release.write({"fixel-0.0.1-a.zip": b"a", "fixel-0.0.1-b.zip": b"b", "fixel-c.zip": b"c"}, tmp_path)
    (tmp_path / "fixel-0.0.1-b.zip").write_bytes(b"of the user")
    (tmp_path / "fixel-notes.txt").touch()
    release.write({"fixel-c.zip": b"new"}, tmp_path)
    assert {file.name for file in tmp_path.iterdir()} == {"fixel-0.0.1-b.zip", "fixel-c.zip", "fixel-notes.txt", release.SUMS}
    assert (tmp_path / "fixel-c.zip").read_bytes() == b"new" and release.earlier(tmp_path) == {"fixel-c.zip"}


def faults(document, made):
    """What SPDX 2.3 demands of a document and this one lacks, as words."""
    packages = document["packages"]
    names = [each["SPDXID"] for each in packages]
    found = [f"{key} is missing" for key in ("spdxVersion", "dataLicense", "SPDXID", "name", "documentNamespace", "creationInfo") if key not in document]
    found += [f"{name} is no identifier" for name in names if not re.fullmatch(r"SPDXRef-[A-Za-z0-9.-]+", name)]
    found += ["two packages have one identifier"] * (len(set(names)) != len(names))
    found += [f"{each['SPDXID']} lacks {key}" for each in packages for key in ("name", "downloadLocation", "filesAnalyzed") if key not in each]
    found += [f"{relation['relatedSpdxElement']} is not there" for relation in document["relationships"]
              if not {relation["spdxElementId"], relation["relatedSpdxElement"]} <= {*names, "SPDXRef-DOCUMENT"}]
    listed = {each["packageFileName"]: each["checksums"][0]["checksumValue"] for each in packages if "packageFileName" in each}
    return found + ["the hashes are others"] * (listed != {name: hashlib.sha256(content).hexdigest() for name, content in made.items()})


def test_the_list_names_each_artefact_with_its_hash(packages):
    made = {**packages, **PIP}
    document = json.loads(release.spdx_text(CHECKOUT, made, COMMIT, SECONDS))
    assert faults(document, made) == []
    assert document["spdxVersion"] == "SPDX-2.3" and document["documentNamespace"].endswith(COMMIT)
    assert document["creationInfo"]["created"] == "2030-03-17T17:46:40Z"
    described = [each["relatedSpdxElement"] for each in document["relationships"] if each["relationshipType"] == "DESCRIBES"]
    assert described == [release.identifier(name) for name in sorted(made)]


def test_the_list_names_what_the_python_package_needs(packages):
    document = release.document(CHECKOUT, {**packages, **PIP}, COMMIT, SECONDS)
    needed = release.needed(CHECKOUT)
    assert needed["numpy"] == ">=2.0,<3" and len(needed) >= 6
    pairs = [(each["spdxElementId"], each["relatedSpdxElement"]) for each in document["relationships"] if each["relationshipType"] == "DEPENDS_ON"]
    assert sorted(pairs) == sorted((release.identifier(name), release.identifier(f"pypi-{other}")) for name in PIP for other in needed)
    without = release.document(CHECKOUT, packages, COMMIT, SECONDS)
    assert {each["name"] for each in without["packages"]} == {"fixel"}, "nothing in the packages is of others"


def test_a_fault_of_the_list_is_seen(packages):
    document = release.document(CHECKOUT, packages, COMMIT, SECONDS)
    assert faults(document, {**packages, "fixel-more.zip": b""}) == ["the hashes are others"]
    del document["name"]
    document["relationships"][0]["relatedSpdxElement"] = "SPDXRef-none"
    assert faults(document, packages) == ["name is missing", "SPDXRef-none is not there"]


# --- the files of a release: the changelog, the citation, the issue templates, the way to report a defect 

TEMPLATES = sorted((CHECKOUT / ".github" / "ISSUE_TEMPLATE").glob("*.md"))
KINDS = {"Added", "Changed", "Deprecated", "Removed", "Fixed", "Security"}
FIRST = "0.9.0"     # its changes stand by subject


def page(name):
    return (CHECKOUT / name).read_text(encoding="utf-8")


def complaints(changelog, current):
    """What is wrong with the headings of a changelog, as sentences."""
    found = re.findall(r"^## (.*)$", changelog, re.MULTILINE)
    wrong = [] if found[:1] == ["[Unreleased]"] else ["[Unreleased] is not the first heading"]
    numbers = []
    for heading in found[1:]:
        parts = re.fullmatch(r"\[(\d+)\.(\d+)\.(\d+)\] - (\d{4}-\d\d-\d\d|not released)", heading)
        if not parts:
            wrong.append(f"{heading} is no version with a date")
            continue
        numbers.append(tuple(map(int, parts.groups()[:3])))
        if parts[4] == "not released" and len(numbers) > 1:
            wrong.append(f"{heading}: a later version has been released")
    if not numbers or ".".join(map(str, numbers[0])) != current:
        wrong.append(f"{current} is not the newest version")
    if numbers != sorted(set(numbers), reverse=True):
        wrong.append("the versions do not go down")
    later = changelog.split(f"\n## [{FIRST}]", 1)[0]
    wrong += [f"{name} is no kind of change" for name in re.findall(r"^### (.*)$", later, re.MULTILINE) if name not in KINDS]
    return wrong


def test_the_changelog_has_the_headings_of_keep_a_changelog():
    assert complaints(page("CHANGELOG.md"), version()) == []


@pytest.mark.parametrize("text, wrong", [
    ("## [0.9.0] - 2030-01-02\n", "[Unreleased] is not the first heading"),
    ("## [Unreleased]\n\n## 0.9.0\n", "0.9.0 is no version with a date"),
    ("## [Unreleased]\n\n## [0.8.0] - 2030-01-02\n", "0.9.0 is not the newest version"),
    ("## [Unreleased]\n\n## [0.9.0] - 2030-01-02\n\n## [0.10.0] - 2030-01-02\n", "the versions do not go down"),
    ("## [Unreleased]\n\n## [0.9.0] - 2030-01-02\n\n## [0.8.0] - not released\n", "[0.8.0] - not released: a later version has been released"),
    ("## [Unreleased]\n\n### Models\n\n## [0.9.0] - 2030-01-02\n\n### Models\n", "Models is no kind of change"),
])
def test_a_wrong_heading_is_seen(text, wrong):
    assert wrong in complaints(f"# Changelog\n\n{text}", "0.9.0")


def test_the_citation_has_what_the_format_demands_and_the_version():
    found = dict(re.findall(r"^([a-z-]+):(?: +(.*))?$", page("CITATION.cff"), re.MULTILINE))
    assert {"cff-version", "message", "title", "authors"} <= set(found), "the format's required keys"
    assert found["cff-version"] == "1.2.0" and found["type"] == "software"
    assert found["version"] == version() and found["license"] == "MIT"
    assert re.search(r"^authors:\n  - name: \S", page("CITATION.cff"), re.MULTILINE)


@pytest.mark.parametrize("template", TEMPLATES, ids=lambda file: file.stem)
def test_an_issue_template_begins_with_its_name(template):
    head, body = re.fullmatch(r"---\n(.*?)\n---\n\n(.*)", template.read_text(encoding="utf-8"), re.DOTALL).groups()
    fields = dict(line.split(": ", 1) for line in head.splitlines())
    assert set(fields) == {"name", "about", "labels"} and all(fields.values())
    assert body.count("**") >= 6, "it asks for three things at least"
    for name in re.findall(r"\b(?:[\w-]+/)*[\w-]+\.md\b", body + head):
        assert (CHECKOUT / name).is_file(), name


def test_a_defect_that_others_could_attack_by_is_told_in_private():
    assert [file.stem for file in TEMPLATES] == ["defect", "result", "wish"]
    assert "SECURITY.md" in TEMPLATES[0].read_text(encoding="utf-8")
    told = page("SECURITY.md").split("\n## Telling us\n", 1)[1]
    assert "Report a vulnerability" in told and re.search(r"^2\. ", told, re.MULTILINE)


# --- make api-check: what a version may break, and what of abidiff's words is a change 

SAID = "Functions changes summary: {} Removed, {} Changed (7 filtered out), {} Added functions\n"


@pytest.fixture(name="empty")
def fixture_empty(tmp_path):
    """A repository with one commit."""
    for words in (["init", "--quiet"], ["commit", "--quiet", "--allow-empty", "-m", "All"]):
        subprocess.run(["git", "-c", "user.name=a", "-c", "user.email=a@b", *words], cwd=tmp_path, check=True)
    return tmp_path


def test_before_the_first_tag_there_is_nothing_to_compare(empty, capsys):
    assert api_check.check(empty) == 0
    assert capsys.readouterr().out == "api: no tag to compare\n"


def test_the_last_tag_is_that_of_a_version(empty):
    for tag in ("v0.9.0", "vendor", "trial"):
        subprocess.run(["git", "tag", tag], cwd=empty, check=True)
    assert repository.last_tag(empty) == "v0.9.0"


def test_without_abidiff_it_is_not_run(empty, monkeypatch):
    monkeypatch.setattr(api_check.shutil, "which", lambda name: None)
    with pytest.raises(ToolError, match="not run: needs abidiff"):
        api_check.compared(empty, "v0.9.0")


def test_api_check_refuses_a_folder_without_git(tmp_path):
    with pytest.raises(ToolError, match="needs a checkout of git"):
        api_check.check(tmp_path)


@pytest.mark.parametrize("before, now, allowed", [
    ("0.9.0", "0.9.1", False), ("0.9.0", "0.10.0", True), ("0.9.3", "1.0.0", True), ("1.2.0", "1.3.0", False), ("1.9.0", "2.0.0", True),
    ("0.9.0", "0.9.0", False), ("1.0.0", "0.10.0", False)])
def test_what_a_version_may_break(before, now, allowed):
    assert api_check.may_break(before, now) is allowed


@pytest.mark.parametrize("said, new", [
    (SAID.format(0, 0, 3), True), (SAID.format(1, 0, 3), False), (SAID.format(0, 12, 0), False), ("", False),
    (SAID.format(0, 0, 0) + "Unreachable types summary: 0 removed, 1 changed, 0 added type\n", False),
    (SAID.format(0, 0, 0) + "Unreachable types summary: 0 removed, 0 changed (1 filtered out), 1 added types\n", True)])
def test_what_is_new_alone_is_no_change(said, new):
    assert api_check.is_all_new(said) is new


def test_an_enumeration_without_a_name_gets_that_of_its_first_member():
    header = "typedef enum { A } a;\nenum { /* of b */\n    FXL_B, FXL_C };\nenum d { FXL_D };\n"
    assert api_check.with_names(header) == header.replace("enum { /* of b", "enum of_FXL_B { /* of b")


def test_make_installs_nothing_for_it_before_the_first_tag():
    assert "tools/setup.sh tools" in dry_run("api-check").stdout
