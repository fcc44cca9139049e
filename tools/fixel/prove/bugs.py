# SPDX-License-Identifier: MIT
"""Shows that rows can fail: each entry of host_tests/breaks that names a row is put into a copy, and the row must fail there.

A row of Z3 or Gappa fails by the hash of its function, whatever the bug is, so that is not asked: the rows must fail that run its formula
beside the function.

host_tests/proofs/bugs.toml keeps which bugs were noticed, each with a hash of what was tried: the bug, its function and the row. The whole
campaign tries those alone that are not on record so, and goes on where it was stopped.
"""

import functools
import hashlib
import json
import pathlib
import shutil
import threading
import tomllib

from fixel.base import output, scratch
from fixel.base.errors import ToolError
from fixel.base.table import coloured, table
from fixel.check import mutate, planting
from fixel.prove import proving, provers, rows as records

COPIED = ("lib", "host_tests/proofs")
# What a row says where the bug shows nothing: the text does not compile, or the prover did not end.
NOTHING_SHOWN = ("goto-cc:", "gcc:", "its text cannot be read", "had not ended", "without a result")
RECORD = records.PROOFS / "bugs.toml"
HEAD = """# SPDX-License-Identifier: MIT
# Rows, and the bugs of host_tests/breaks that they notice, by `fixel prove --bugs`, which writes this. Behind each a hash of what was
# tried: the bug, its function and the row, without comments and white space.
"""


# --- the record --------------------------------------------------------------------------------

def load(root):
    """{row: {bug: hash of the text with which it was noticed}}."""
    path = pathlib.Path(root) / RECORD
    return tomllib.loads(path.read_text(encoding="utf-8")) if path.is_file() else {}


def save(root, pairs, found):
    """Writes the record: of those pairs of the ledgers that are in `found`, as it is of load()."""
    lines = sorted(f'{json.dumps(row.id, ensure_ascii=False)}.{bug.id} = "{found[row.id][bug.id]}"\n' for bug, row in pairs if bug.id in found.get(row.id, {}))
    (pathlib.Path(root) / RECORD).write_text(HEAD + "".join(lines), encoding="utf-8")


@functools.cache
def _lines(path):
    """[(the definition that a line is in, its text without comments)] of a file."""
    text = path.read_text(encoding="utf-8")
    code = mutate.code_of(text) if path.suffix in (".c", ".h") else text
    return list(zip(planting.functions(text), code.splitlines()))


def _definition(root, file, name):
    return [line for owner, line in _lines(pathlib.Path(root) / file) if owner == name]


def hash_of(root, bug, row):
    """Of what is tried with a bug and a row."""
    harness = [row.program] if row.program else [line for owner, line in _lines(row.place) if owner == row.harness]
    fields = [row.flags, row.cases, row.links, row.uses, row.stands_in, row.unwind, row.unwindset, row.text]
    texts = [bug.line, bug.becomes, *_definition(root, bug.file, bug.function), *_definition(root, row.file, row.name), *harness, *map(str, fields)]
    return hashlib.sha256(" ".join(" ".join(texts).split()).encode()).hexdigest()[:16]


def pairs_of(root, rows):
    """[(bug, row)] of the ledgers, for some rows."""
    by_id = {row.id: row for row in rows}
    return [(bug, by_id[row]) for bug in planting.of_rows(root) for row in bug.rows if row in by_id]


def stale(root, pairs):
    """Those pairs that the record does not have, or has of another text."""
    kept = load(root)
    return [(bug, row) for bug, row in pairs if kept.get(row.id, {}).get(bug.id) != hash_of(root, bug, row)]


# --- trying ------------------------------------------------------------------------------------

def make_copy(root, folder):
    """What the rows read."""
    for name in COPIED:
        shutil.copytree(root / name, folder / name)


def fails(programs, folder, bug, row, store, versions):
    """(whether the row fails with the bug, or mutant, how it ends)."""
    answers = []
    with planting.planted(folder, [bug]):
        asked = [each for each in records.read(folder) if each.formula == row.id] if row.of else [proving.placed(row, folder)]
        for each, case in [(each, case) for each in asked for case in each.cases]:
            answers.append((case, proving.prove_case(programs, folder, each, case, store, versions)))
            if "failed" in answers[-1][1]:
                break
    words = proving.failure(row, answers) or "nothing fails"
    return words != "nothing fails" and not any(each in words for each in NOTHING_SHOWN), words


def try_bug(programs, folder, bug, row, store, versions):
    """How the row ends with the bug: {"bug", "row", "noticed", "words"}."""
    noticed, words = fails(programs, folder, bug, row, store, versions)
    return {"bug": bug.id, "row": row.id, "noticed": noticed, "words": words}


def command(programs, root, jobs, rows, options, store):
    """fixel prove --bugs; its exit code."""
    by_id = {row.id for row in rows}
    unknown = [(bug, row) for bug in planting.of_rows(root) for row in bug.rows if not options.only and row not in by_id]
    if unknown:
        raise ToolError(f"{unknown[0][0].ledger}: {unknown[0][0]}: there is no row {unknown[0][1]}")
    every, some = pairs_of(root, records.read(root)), pairs_of(root, rows)
    bare = [row.id for row in rows if row.id not in {row.id for _, row in some}]
    some = sorted(some if options.only or options.fresh else stale(root, some), key=lambda pair: (pair[1].tool == "cbmc", pair[1].checks))
    versions, lock = provers.versions(programs), threading.Lock()

    def attempt(copy, pair):
        bug, row = pair
        found = try_bug(programs, copy, bug, row, store, versions)
        with lock:
            kept = load(root)
            of_row = kept.setdefault(row.id, {})
            of_row.pop(bug.id, None)
            if found["noticed"]:
                of_row[bug.id] = hash_of(copy, bug, proving.placed(row, copy))      # of what was tried
            save(root, every, kept)
        return found

    with scratch.folder("bugs") as folder:
        copies = [folder / str(number) for number in range(jobs)]
        for copy in copies:
            make_copy(root, copy)
        tried = planting.try_all("bugs of proofs", some, copies, attempt)
    output.write_json(pathlib.Path(options.build) / "prove/bugs.json", {"bugs": tried, "without": bare})
    print(table([[each["bug"], each["row"], each["words"][:90] if each["noticed"] else coloured(f"NOT NOTICED: {each['words'][:90]}", "red")]
                 for each in tried], ["bug", "row", "how the row fails"]))
    noticed = sum(each["noticed"] for each in tried)
    print(f"{noticed} of {len(tried)} bugs noticed, {len(every) - len(stale(root, every))} of {len(every)} are on record; "
          f"{len(bare)} of {len(rows)} rows have no bug of their own")
    return 1 if noticed < len(tried) else 0
