# SPDX-License-Identifier: MIT
"""Mutants of the tools: in copies of the checkout below the build folder, tried with tests for pytest.

A mutant is tried with the tests that execute its line, the quickest first, then with others that execute its function
(lines.py), as many as take --enough seconds of CPU time; the first that fails ends it. A test that fails is run once
without the mutant: one that fails then too says nothing, and the mutant is tried without it. A mutant that no test
executes survives.
"""

from fixel.check import lines, trees

CPU_TIMES, CPU_MORE = 4, 15.0   # the tests may take so many times what they take without a mutant, and so many seconds
TESTS = 120                     # at most for a mutant
MISSING = (4, 5)                # pytest has not found a test


class Tools:
    """What mutants.py tries mutants of."""
    name = "tools"

    def __init__(self, options, scratch, checkout):
        self._enough, self._checkout = options.enough, checkout
        self._folders = [scratch / f"tools-{number}" for number in range(options.jobs)]
        self._records = lines.Records(scratch / "lines", checkout)
        self._good, self._bad = set(), set()    # tests that pass, or fail, without a mutant
        self._trees = []

    @staticmethod
    def add_options(parser):
        parser.add_argument("--enough", type=float, default=30.0, help="seconds of tests for a mutant of the tools")

    def files(self):
        """The files that mutants are made of."""
        return sorted((self._checkout / "tools" / "fixel").rglob("*.py"))

    def _make_trees(self):
        return [trees.Tree(folder, self._checkout) for folder in self._folders]

    def prepare(self):
        """The copies in which mutants are tried."""
        self._records.complete(self._make_trees)
        self._trees = self._make_trees()
        return self._trees

    def _tests(self, mutant, text):
        """The tests to try a mutant with, and their seconds."""
        found, seconds = [], 0.0
        for test in self._records.tests(mutant, text):
            if test not in self._bad:
                found.append(test)
                seconds += self._records.seconds[test]
            if seconds > self._enough or len(found) == TESTS:
                break
        return found, seconds

    def _passes(self, tree, tests, cpu):
        """Whether tests pass without a mutant."""
        if self._good.issuperset(tests):
            return True
        code, report = tree.run(tests, cpu)
        self._good.update(each["test"] for each in report if each["passed"])
        self._bad.update(each["test"] for each in report if not each["passed"])
        if code in MISSING:
            self._bad.update(tests)
        return code == 0

    def run(self, tree, mutant):
        """{"result", "tests", "words"} of a mutant; afterwards the tree is as it was."""
        text = (tree.folder / mutant.file).read_text(encoding="utf-8")
        while True:
            tests, seconds = self._tests(mutant, text)
            if not tests:
                return {"result": "survived", "tests": 0, "words": "no test that passes without it executes it"}
            cpu = CPU_TIMES * seconds + CPU_MORE
            try:
                tree.write(mutant.file, mutant.apply(text))
                code, report = tree.run(tests, cpu, "-x")
                said = tree.said()
            finally:
                tree.write(mutant.file, text)
            if code == 0:
                return {"result": "survived", "tests": len(tests)}
            failed = [each["test"] for each in report if not each["passed"]]
            before = len(self._bad)
            if self._passes(tree, failed or tests, cpu):
                words = code if isinstance(code, str) else failed[0] if failed else said.strip()[-200:]
                return {"result": "killed", "tests": len(report), "words": words}
            if len(self._bad) == before:
                return {"result": "survived", "tests": len(tests), "words": f"the tests do not pass without it: {code}"}

    def left_out(self):
        """The tests that fail without a mutant."""
        return sorted(self._bad)

    def close(self):
        for tree in self._trees:
            tree.close()
