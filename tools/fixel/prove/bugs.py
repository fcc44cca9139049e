# SPDX-License-Identifier: MIT
"""Shows that rows can fail: each entry of host_tests/breaks that names a row is put into a copy, and the row must fail there.

A row of Z3 or Gappa fails by the hash of its function, whatever the bug is, so that is not asked: the rows must fail that run its formula
beside the function."""

import pathlib
import shutil

from fixel.base import output, scratch
from fixel.base.errors import ToolError
from fixel.base.table import coloured, table
from fixel.check import planting
from fixel.prove import proving, provers, rows as records

COPIED = ("lib", "host_tests/proofs")
# What a row says where the bug shows nothing: the text does not compile, or the prover did not end.
NOTHING_SHOWN = ("goto-cc:", "gcc:", "its text cannot be read", "had not ended", "without a result")


def make_copy(root, folder):
    """What the rows read."""
    for name in COPIED:
        shutil.copytree(root / name, folder / name)


def fails(programs, folder, bug, row, store, versions):
    """(whether the row fails with the bug, or mutant, how it ends)."""
    words = "nothing fails"
    with planting.planted(folder, [bug]):
        asked = [each for each in records.read(folder) if each.formula == row.id] if row.of else [proving.placed(row, folder)]
        for each, case in [(each, case) for each in asked for case in each.cases]:
            answer = proving.prove_case(programs, folder, each, case, store, versions)
            if "failed" in answer:
                words = answer["failed"]
                break
    return words != "nothing fails" and not any(each in words for each in NOTHING_SHOWN), words


def try_bug(programs, folder, bug, row, store, versions):
    """How the row ends with the bug: {"bug", "row", "noticed", "words"}."""
    noticed, words = fails(programs, folder, bug, row, store, versions)
    return {"bug": bug.id, "row": row.id, "noticed": noticed, "words": words}


def command(programs, root, jobs, rows, options, store):
    """fixel prove --bugs; its exit code."""
    by_id = {row.id: row for row in rows}
    some = [(bug, row) for bug in planting.of_rows(root) for row in bug.rows]
    unknown = [(bug, row) for bug, row in some if not options.only and row not in by_id]
    if unknown:
        raise ToolError(f"{unknown[0][0].ledger}: {unknown[0][0]}: there is no row {unknown[0][1]}")
    some = [(bug, by_id[row]) for bug, row in some if row in by_id]
    versions = provers.versions(programs)
    with scratch.folder("bugs") as folder:
        copies = [folder / str(number) for number in range(jobs)]
        for copy in copies:
            make_copy(root, copy)
        tried = planting.try_all("bugs of proofs", some, copies, lambda copy, pair: try_bug(programs, copy, *pair, store, versions))
    bare = [row.id for row in rows if row.id not in {row.id for _, row in some}]
    output.write_json(pathlib.Path(options.build) / "prove/bugs.json", {"bugs": tried, "without": bare})
    print(table([[each["bug"], each["row"], each["words"][:90] if each["noticed"] else coloured(f"NOT NOTICED: {each['words'][:90]}", "red")]
                 for each in tried], ["bug", "row", "how the row fails"]))
    noticed = sum(each["noticed"] for each in tried)
    print(f"{noticed} of {len(tried)} bugs noticed; {len(bare)} of {len(rows)} rows have no bug of their own")
    return 1 if noticed < len(tried) else 0
