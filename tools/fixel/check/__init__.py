# SPDX-License-Identifier: MIT
"""What tests the project: unit tests, seeded bugs, mutants, kills, frozen frames.

The commands `fixel test`, `test-anywhere`, `breaks`, `changed`, `corpus`, `coverage`, `coverage-builds`, `equality`, `frame-hashes`, `fuzz`, `kills`,
`places`, `size-of-tree`, `mutants`, `rules`, `seeded-bugs` and `trace` have the modules of their names. `planting.py` reads the
breaks of `host_tests/breaks` and plants breaks and mutants.

For `mutants`: `mutate.py` and `mutate_python.py` find the mistakes, `library_mutants.py` and `tool_mutants.py` try them as
shards of campaigns. `pytest_server.py` runs the tests in their copies of the checkout, which `pytest_client.py` asks, for
`test` too; `lines.py` knows which test executes which line, as `recorder/` wrote it down.

For `trace`: `clauses.py` reads the clauses of the specification and their record, and which code and which tests are about
them, `sentences.py` what each of them says; `trace_break.py` breaks them.
"""
