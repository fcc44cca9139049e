# SPDX-License-Identifier: MIT
"""Prints an apt source (deb822) for another suite, taken from this machine's own sources.

usage: apt_mirror.py HAVE WANT [APT_DIR]

Looks for an entry of suite HAVE, component main, under APT_DIR (/etc/apt), in
either of apt's two formats, and prints the same entry for suite WANT: same
mirror, same key. Needs nothing but Python: it runs before the venv exists.
"""

import pathlib
import re
import sys

# Where a package can be fetched without somebody changing discs.
FETCHABLE = re.compile(r"(https?|ftp|file|copy|mirror(\+\w+)?|tor\+https?):", re.IGNORECASE)


def stanzas(text):
    """The stanzas of a deb822 file: dictionaries with lower-case keys; values may span lines."""
    stanza, key = {}, None
    for line in text.splitlines():
        if line.startswith("#"):
            continue
        if not line.strip():
            if stanza:
                yield stanza
            stanza, key = {}, None
        elif line[0] in " \t":
            if key:
                stanza[key] += "\n" + line
        elif ":" in line:
            key, value = line.split(":", 1)
            key = key.strip().lower()
            stanza[key] = value.strip()
    if stanza:
        yield stanza


def entries_of_sources(text):
    """Entries of a .sources file: (uri, suites, components, options)."""
    for stanza in stanzas(text):
        if stanza.get("enabled", "yes").lower() in ("no", "false", "0"):
            continue
        if "deb" not in stanza.get("types", "").split():
            continue
        options = {name: stanza[name] for name in ("signed-by", "trusted") if name in stanza}
        for uri in stanza.get("uris", "").split():
            yield uri, stanza.get("suites", "").split(), stanza.get("components", "").split(), options


def entries_of_list(text):
    """Entries of a one-line .list file: (uri, suites, components, options)."""
    for line in text.splitlines():
        match = re.match(r"\s*deb\s+(?:\[([^\]]*)\]\s*)?(cdrom:\[[^\]]*\]\S*|\S+)\s+(\S+)\s*([^#]*)", line)
        if not match:
            continue
        written = dict(item.split("=", 1) for item in (match[1] or "").split() if "=" in item)
        options = {name: written[name].replace(",", " ")
                   for name in ("signed-by", "trusted") if name in written}
        yield match[2], [match[3]], match[4].split(), options


def find(suites_wanted, apt_dir):
    """The first fetchable entry of one of the suites that has component main, or None."""
    files = [apt_dir / "sources.list", *sorted((apt_dir / "sources.list.d").glob("*.sources")),
             *sorted((apt_dir / "sources.list.d").glob("*.list"))]
    for file in files:
        try:
            text = file.read_text(encoding="utf-8", errors="replace")
        except OSError:
            continue
        entries = entries_of_sources(text) if file.suffix == ".sources" else entries_of_list(text)
        for uri, suites, components, options in entries:
            if FETCHABLE.match(uri) and "main" in components and set(suites) & set(suites_wanted):
                return uri, options
    return None


def source_for(have, want, apt_dir):
    """The text of an apt source for suite want, or None where no entry of suite have exists."""
    found = find([have, "stable", "oldstable"], apt_dir)
    if not found:
        return None
    uri, options = found
    lines = ["# Written by Fixel's tools/setup.sh, for the one package cmock.",
             "Types: deb", f"URIs: {uri}", f"Suites: {want}", "Components: main"]
    names = {"signed-by": "Signed-By", "trusted": "Trusted"}
    lines += [f"{names[name]}: {value}" for name, value in options.items()]
    return "\n".join(lines) + "\n"


def main(argv):
    have, want = argv[0], argv[1]
    apt_dir = pathlib.Path(argv[2] if len(argv) > 2 else "/etc/apt")
    text = source_for(have, want, apt_dir)
    if text is None:
        print(f"error: no apt source of suite {have} with component main under {apt_dir}: "
              f"add one, so that suite {want} can be found on the same mirror", file=sys.stderr)
        return 1
    sys.stdout.write(text)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
