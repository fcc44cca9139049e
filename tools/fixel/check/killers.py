# SPDX-License-Identifier: MIT
"""Which tests have killed mutants of a function: they are the likeliest to kill another one of it."""

import json

from fixel.base import output


class Killers:
    """The tests, by function; a file keeps them from run to run."""

    def __init__(self, path):
        self._path = path
        try:
            self._tests = {function: set(tests) for function, tests in json.loads(path.read_text(encoding="utf-8")).items()}
        except (OSError, ValueError):
            self._tests = {}

    def add(self, function, tests):
        self._tests.setdefault(function, set()).update(tests)

    def first(self, function, tests):
        """Tests in their order, with those that killed before the others."""
        killed = self._tests.get(function, set())
        return sorted(tests, key=lambda test: test not in killed)

    def write(self):
        output.write_json(self._path, {function: sorted(tests) for function, tests in self._tests.items()})
