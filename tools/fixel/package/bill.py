# SPDX-License-Identifier: MIT
"""The list of what is in a release (SBOM), as SPDX 2.3 in JSON.

Each artefact is a package with its hash. All of their text is Fixel's own; the Python package needs others, which pyproject.toml
names with the versions that it takes.
"""

import hashlib
import json
import re
import time
import tomllib

from fixel.base.version import version

LICENCE, HOLDER = "MIT", "Copyright (c) 2026 The Fixel authors"
SUPPLIER = "Organization: The Fixel authors"
NAMESPACE = "https://spdx.org/spdxdocs"     # the convention for names of documents; nothing need be there
OF_PIP = (".whl", ".tar.gz")


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


def text(root, made, commit, seconds):
    return json.dumps(document(root, made, commit, seconds), indent=2) + "\n"
