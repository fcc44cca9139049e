# SPDX-License-Identifier: MIT
"""Builds every artefact of a version into dist/: the source, the one file, the packages, the Python package, an SPDX list of
what is in them, and their hashes. The same commit gives the same bytes. Nothing is published.

In the list (SBOM, SPDX 2.3 in JSON) each artefact is a package with its hash. All of their text is Fixel's own; the Python package
needs others, which pyproject.toml names with the versions that it takes.
Exit: 0 written, 2 the checkout has changes, its tag is that of another version, or a file cannot be written.
"""

import argparse
import gzip
import hashlib
import importlib.util
import io
import json
import os
import pathlib
import re
import sys
import time
import tomllib

from fixel.base import children, output, scratch
from fixel.base.errors import one_line, ToolError
from fixel.base.version import version
from fixel.commands import late
from fixel.package import one_file, repository

package_table = late("fixel.package", "packages")
zipfile = late("zipfile")

ROOT = pathlib.Path(__file__).resolve().parents[3]
SUMS = "SHA256SUMS"
SHOWN = 5       # changed files that a refusal names
# What builds the Python package (pyproject.toml); it is no part of the set-up.
BACKEND = "scikit_build_core"
BUILDER = "from scikit_build_core.build import build_{0}; build_{0}(__import__('sys').argv[1])"
LICENCE, HOLDER = "MIT", "Copyright (c) 2026 The Fixel authors"
SUPPLIER = "Organization: The Fixel authors"
NAMESPACE = "https://spdx.org/spdxdocs"     # the convention for names of documents; nothing need be there
OF_PIP = (".whl", ".tar.gz")


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--out", type=pathlib.Path, default=pathlib.Path("dist"), metavar="FOLDER", help="where to (dist)")
    return made


def refuse_changes(root):
    """Refuses a checkout with changes or files that git does not know, and a tag of another version."""
    repository.require(root)
    changed = [line[3:] for line in repository.git(root, "status", "--porcelain").decode("utf-8", "replace").splitlines()]
    if changed:
        more = f" and {len(changed) - SHOWN} more" if len(changed) > SHOWN else ""
        raise ToolError(f"a release is built from a commit, and these files differ from it: {', '.join(changed[:SHOWN])}{more}")
    tags = repository.text(root, "tag", "--points-at", "HEAD", "--list", "v[0-9]*").split()
    if tags and f"v{version()}" not in tags:
        raise ToolError(f"this commit has the tag {tags[0]}, and lib/include/fixel/version.h says {version()}")


def time_of(root):
    """When the commit was made, in seconds since 1970."""
    return int(repository.text(root, "log", "-1", "--format=%ct"))


def zipped(files, seconds):
    """A ZIP archive of {path: bytes}."""
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for path in sorted(files):
            member = zipfile.ZipInfo(path, time.gmtime(seconds)[:6])
            member.compress_type, member.create_system, member.external_attr = zipfile.ZIP_DEFLATED, 3, 0o100644 << 16
            archive.writestr(member, files[path])
    return made.getvalue()


def of_folder(folder, prefix):
    """{path below a prefix: bytes} of the files in a folder."""
    return {f"{prefix}/{file.relative_to(folder).as_posix()}": file.read_bytes() for file in sorted(folder.rglob("*")) if file.is_file()}


def source(root, seconds):
    """The files of the commit."""
    name = f"fixel-{version()}"
    archive = repository.git(root, "archive", "--format=tar", f"--prefix={name}/", "HEAD")
    return {f"{name}-source.tar.gz": gzip.compress(archive, 9, mtime=seconds)}


def packages(root, seconds):
    """The one file, and the package of each package manager."""
    texts = {"fixel.h": one_file.header_text(version()), "fixel.c": one_file.source_of_all(version())}
    texts = {**texts, "LICENSE": (root / "LICENSE").read_text(encoding="utf-8")}
    made = {f"fixel-{version()}-one-file.zip": zipped({f"fixel/{name}": text.encode() for name, text in texts.items()}, seconds)}
    with scratch.folder("release") as folder:
        for name, layout in package_table.table().items():
            place = pathlib.Path(folder) / name
            package_table.write(layout, place)
            made[f"fixel-{version()}-{name}.zip"] = zipped(of_folder(place, "fixel"), seconds)
    return made


def python_package(root, seconds):
    """The source and the wheel for pip; {} where what builds them is not installed."""
    if importlib.util.find_spec(BACKEND) is None:
        return {}
    with scratch.folder("release") as folder:
        for kind in ("sdist", "wheel"):
            done = children.run([sys.executable, "-c", BUILDER.format(kind), folder], cwd=root, text=True,
                                env={**os.environ, "SOURCE_DATE_EPOCH": str(seconds)})
            if done.returncode:
                raise ToolError(f"{kind} of the Python package: failed", words=done.stdout + done.stderr)
        return {file.name: file.read_bytes() for file in sorted(pathlib.Path(folder).iterdir())}


def all_of(root):
    """{name: bytes} of every artefact of a commit but the hashes."""
    seconds = time_of(root)
    made = {**source(root, seconds), **packages(root, seconds), **python_package(root, seconds)}
    made[f"fixel-{version()}.spdx.json"] = spdx_text(root, made, repository.text(root, "rev-parse", "HEAD"), seconds).encode()
    return made


def sums(made):
    """The hashes as sha256sum -c reads them."""
    return "".join(f"{hashlib.sha256(made[name]).hexdigest()}  {name}\n" for name in sorted(made))


def earlier(folder):
    """The artefacts that a release has written into a folder and nobody has changed, by its hashes."""
    sums_file = folder / SUMS
    lines = sums_file.read_text(encoding="utf-8", errors="replace").splitlines() if sums_file.is_file() else []
    listed = [(parts[1], parts[0]) for parts in (line.split("  ", 1) for line in lines) if len(parts) == 2 and "/" not in parts[1]]
    return {name for name, digest in listed if (folder / name).is_file() and hashlib.sha256((folder / name).read_bytes()).hexdigest() == digest}


def write(made, folder):
    """Writes the artefacts, and removes those of an earlier release that have other names. Other files stay."""
    output.make_folder(folder)
    gone = earlier(folder) - set(made)
    for name in sorted(made):
        output.write_file(folder / name, made[name])
        print(f"{folder / name}: {len(made[name]) // 1000} KB")
    output.write_file(folder / SUMS, sums(made))
    for name in sorted(gone):
        (folder / name).unlink()
        print(f"{one_line(str(folder / name))}: removed, of an earlier release")


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    refuse_changes(ROOT)
    made = all_of(ROOT)
    write(made, options.out)
    if not any(name.endswith(".whl") for name in made):
        print("not built: sdist and wheel: need scikit-build-core (docs/packages.md, section 6)")
    return 0


def identifier(name):
    """What stands for a package in the document: letters, digits, dots and hyphens alone."""
    return "SPDXRef-" + re.sub(r"[^A-Za-z0-9.-]", "-", name)


def artefact(name, content):
    return {"SPDXID": identifier(name), "name": "fixel", "versionInfo": version(), "packageFileName": name, "supplier": SUPPLIER,
            "downloadLocation": "NOASSERTION", "filesAnalyzed": False, "licenseConcluded": LICENCE, "licenseDeclared": LICENCE,
            "copyrightText": HOLDER, "checksums": [{"algorithm": "SHA256", "checksumValue": hashlib.sha256(content).hexdigest()}]}


def needed(root):
    """{name: the versions that it takes} of the Python packages that the Python package needs."""
    project = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    return dict(re.fullmatch(r"([\w.-]+?)([<>=].*)", each).groups() for each in project["dependencies"])


def dependency(name, versions):
    """A package that is not in a release. Which version it has, the user's pip decides."""
    return {"SPDXID": identifier(f"pypi-{name}"), "name": name, "downloadLocation": "NOASSERTION", "filesAnalyzed": False,
            "licenseConcluded": "NOASSERTION", "licenseDeclared": "NOASSERTION", "copyrightText": "NOASSERTION",
            "comment": f"versions {versions}",
            "externalRefs": [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
                              "referenceLocator": f"pkg:pypi/{re.sub('[-_.]+', '-', name).lower()}"}]}


def is_of_pip(name):
    return name.endswith(OF_PIP) and not name.endswith("-source.tar.gz")


def document(root, made, commit, seconds):
    """The document. made: {name of an artefact: bytes}."""
    others = needed(root) if any(map(is_of_pip, made)) else {}
    packages = [artefact(name, made[name]) for name in sorted(made)] + [dependency(*each) for each in others.items()]
    relations = [("SPDXRef-DOCUMENT", "DESCRIBES", identifier(name)) for name in sorted(made)]
    relations += [(identifier(name), "DEPENDS_ON", identifier(f"pypi-{other}")) for name in sorted(made) if is_of_pip(name) for other in others]
    return {"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"fixel-{version()}",
            "documentNamespace": f"{NAMESPACE}/fixel-{version()}-{commit}",
            "creationInfo": {"created": time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime(seconds)), "creators": ["Tool: fixel-release"]},
            "packages": packages,
            "relationships": [{"spdxElementId": a, "relationshipType": kind, "relatedSpdxElement": b} for a, kind, b in relations]}


def spdx_text(root, made, commit, seconds):
    return json.dumps(document(root, made, commit, seconds), indent=2) + "\n"
