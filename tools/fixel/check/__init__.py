# SPDX-License-Identifier: MIT
"""What tests the project: unit tests, seeded bugs, mutants, kills, frozen frames.

What tests the project, for `fixel test`, `test-anywhere`, `breaks`, `corpus`, `coverage`, `equality`, `frame-hashes`, `fuzz`, `kills`, `places`, `size-of-tree`, `mutants`,
`rules`, `seeded-bugs` and `trace`. The command has the module of its name; `all_tests.py`, `anywhere.py`, `kernel_equality.py` and `killing.py` do the
work of those that need packages. `units.py` reads which unit tests a board has, `planting.py` reads the breaks of `host_tests/breaks` and plants breaks and mutants,
`clang_coverage.py` counts what tests reach, `gaps.py` has the reasons for the rest, `misra.py` asks cppcheck, `frozen_frames.py` has the frozen hashes, and `kill_campaign.py` kills
commands.

For `mutants`: `mutate.py` and `mutate_python.py` find the mistakes, `library_mutants.py` and `tool_mutants.py` try them as shards of campaigns,
`survivors.py` reads those that change no result. `trees.py` has copies of the checkout, whose tests `pytest_server.py`
runs, which `pytest_client.py` asks, for `all_tests.py` too; `lines.py` knows which test executes which line, as `recorder/` wrote it down.

For `breaks`: `break_commands.py` runs each command in copies of the checkout.

For `trace`: `clauses.py` reads the clauses of the specification and their record, `tags.py` finds which code and which tests
are about them, `trace_break.py` breaks them, and `trace_shards.py` many side by side.

For `places` and `size-of-tree`: `recipes.py` finds the files of a recipe and reads the tags of its places.
"""
