# SPDX-License-Identifier: MIT
"""Mutants of the tools: in copies of the checkout below the build folder, tried with tests for pytest.

A mutant is tried with the tests that execute its line, the quickest first, then with others that execute its function
(lines.py), as many as take --enough seconds of CPU time; the first that fails ends it. Tests that killed a mutant of its
function before, in an earlier run too, come before all others. The first few run by themselves: they kill most mutants,
and pytest imports no file of the others. A test that fails is run once without the mutant: one that fails then too says
nothing, and the mutant is tried without it. A mutant that no test executes survives.
"""

from fixel.check import killers, lines, trees

CPU_TIMES, CPU_MORE = 4, 15.0   # the tests may take so many times what they take without a mutant, and so many seconds
TESTS = 120                     # at most for a mutant
FIRST = 5                       # tests that run before the others are imported
MISSING = (4, 5)                # pytest has not found a test


class Tools:
    """What mutants.py tries mutants of."""
    name = "tools"

    def __init__(self, options, scratch, checkout):
        self._enough, self._checkout = options.enough, checkout
        self._folders = [scratch / f"tools-{number}" for number in range(options.jobs)]
        self._records = lines.Records(scratch / "lines", checkout)
        self._good, self._bad = set(), set()    # tests that pass, or fail, without a mutant
        self._killers = killers.Killers(scratch / "killers.json")
        self._trees = []

    @staticmethod
    def add_options(parser):
        parser.add_argument("--enough", type=float, default=15.0, help="seconds of tests for a mutant of the tools")

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
        """The tests to try a mutant with."""
        found, seconds = [], 0.0
        for test in self._killers.first(self._function(mutant, text), self._records.tests(mutant, text)):
            if test not in self._bad:
                found.append(test)
                seconds += self._records.seconds[test]
            if seconds > self._enough or len(found) == TESTS:
                break
        return found

    def _function(self, mutant, text):
        """The name of a mutant's function, with its file."""
        return f"{mutant.file}:{(self._records.place(mutant, text) or ('',))[0]}"

    def _cpu(self, tests):
        """The CPU time that tests may take."""
        return CPU_TIMES * sum(self._records.seconds[test] for test in tests) + CPU_MORE

    def _passes(self, tree, tests):
        """Whether tests pass without a mutant."""
        if self._good.issuperset(tests):
            return True
        code, report = tree.run(tests, self._cpu(tests))
        self._good.update(each["test"] for each in report if each["passed"])
        self._bad.update(each["test"] for each in report if not each["passed"])
        if code in MISSING:
            self._bad.update(tests)
        if isinstance(code, str):   # of a limit, which the test that ran last has passed
            self._bad.update([test for test in tests if test not in [each["test"] for each in report]][:1])
        return code == 0

    def _try(self, tree, mutant, text, tests):
        """(exit code, report, output) of tests with a mutant; afterwards the tree is as it was."""
        tried = []
        try:
            tree.write(mutant.file, mutant.apply(text))
            for some in filter(None, (tests[:FIRST], tests[FIRST:])):
                code, report = tree.run(some, self._cpu(some), "-x")
                tried += report
                if code != 0:
                    break
            return code, tried, tree.said()
        finally:
            tree.write(mutant.file, text)

    def run(self, tree, mutant):
        """{"result", "tests", "words"} of a mutant."""
        text = (tree.folder / mutant.file).read_text(encoding="utf-8")
        while True:
            tests = self._tests(mutant, text)
            if not tests:
                return {"result": "survived", "tests": 0, "words": "no test that passes without it executes it"}
            code, report, said = self._try(tree, mutant, text, tests)
            if code == 0:
                return {"result": "survived", "tests": len(tests)}
            failed = [each["test"] for each in report if not each["passed"]]
            before = len(self._bad)
            if self._passes(tree, failed or tests):
                self._killers.add(self._function(mutant, text), failed)
                words = code if isinstance(code, str) else failed[0] if failed else said.strip()[-200:]
                return {"result": "killed", "tests": len(report), "words": words}
            if len(self._bad) == before:
                return {"result": "survived", "tests": len(tests), "words": f"the tests do not pass without it: {code}"}

    def left_out(self):
        """The tests that fail without a mutant."""
        return sorted(self._bad)

    def close(self):
        self._killers.write()
        for tree in self._trees:
            tree.close()
