# SPDX-License-Identifier: MIT
"""Which tests of the tools are likeliest to see a mistake in a module: by what they import, near or far, and by name."""

import ast
import pathlib
import re

from fixel.commands import COMMANDS

CLI = re.compile(r'run_cli\(\s*"([\w-]+)"')
FAR = 99


def module_files(checkout):
    """{name that an import says: file} of the tools and of what their tests share."""
    checkout, found = pathlib.Path(checkout), {}
    rooms = sorted(file.parent.relative_to(checkout) for file in checkout.glob("host_tests/*/README.md"))
    for folder, pattern in (("tools", "*.py"), ("tools", "fixel/**/*.py"), *((room, "*.py") for room in ["host_tests", *rooms])):
        for file in (checkout / folder).glob(pattern):
            name = file.relative_to(checkout / folder).with_suffix("").as_posix().replace("/", ".")
            found[name.removesuffix(".__init__")] = file
    return found


def imported(file, names):
    """The files that a file imports, or runs as a command."""
    text, found = file.read_text(encoding="utf-8"), set()
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import):
            found.update(alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and not node.level:
            found.update([node.module, *(f"{node.module}.{alias.name}" for alias in node.names)])
    found.update(COMMANDS[command] for command in CLI.findall(text) if command in COMMANDS)
    return {names[name] for name in found if name in names and names[name] != file}


def distances(test, graph):
    """{file: over how many imports a test reaches it}."""
    found, edge = {test: 0}, [test]
    for step in range(1, FAR):
        edge = [each for file in edge for each in graph[file] if each not in found]
        found.update(dict.fromkeys(edge, step))
        if not edge:
            break
    return found


class Map:
    """Of a checkout; made once."""

    def __init__(self, checkout):
        names = module_files(checkout)
        self._checkout = pathlib.Path(checkout)
        graph = {file: imported(file, names) for file in names.values()}
        tests = sorted(file for file in graph if file.name.startswith("test_"))
        self._reached = {test: distances(test, graph) for test in tests}

    def tests(self, file):
        """The tests that reach a file of the checkout, the likeliest first."""
        file = self._checkout / file
        words = set(file.stem.split("_"))
        near = {test: reached[file] for test, reached in self._reached.items() if file in reached}
        return sorted(near, key=lambda test: (min(near[test], 2) - 2 * len(words & set(test.stem.split("_"))),
                                              near[test], len(self._reached[test]), test.name))
