# SPDX-License-Identifier: MIT
"""Shows that rows can fail: each seeded bug that names a row (prove = "...") is put into a copy, and the row must fail there."""

import concurrent.futures
import pathlib
import queue
import shutil
import threading

from fixel.base import output, scratch
from fixel.base.errors import ToolError
from fixel.base.progress import Progress
from fixel.base.table import coloured, table
from fixel.check import bugs as records
from fixel.prove import proving, provers

COPIED = ("lib", "host_tests/proofs")
# What a row says where the bug shows nothing: the text does not compile, or the prover did not end.
NOTHING_SHOWN = ("goto-cc:", "gcc:", "its text cannot be read", "had not ended", "without a result")


def make_copy(root, folder):
    """What the rows read."""
    for name in COPIED:
        shutil.copytree(root / name, folder / name)


def try_bug(programs, folder, bug, row, store, versions):
    """How the row ends with the bug: {"bug", "row", "noticed", "words"}."""
    file = folder / bug.file
    good = file.read_text(encoding="utf-8")
    file.write_text(bug.seed(good), encoding="utf-8")
    here = proving.placed(row, folder)
    words = "nothing fails"
    try:
        for case in row.cases:
            answer = proving.prove_case(programs, folder, here, case, store, versions)
            if "failed" in answer:
                words = answer["failed"]
                break
    finally:
        file.write_text(good, encoding="utf-8")
    noticed = words != "nothing fails" and not any(each in words for each in NOTHING_SHOWN)
    return {"bug": bug.id, "row": row.id, "noticed": noticed, "words": words}


def command(programs, root, jobs, rows, options, store):
    """fixel prove --bugs; its exit code."""
    by_id = {row.id: row for row in rows}
    some = records.of_proofs(root)
    unknown = [bug for bug in some if not options.only and bug.prove not in by_id]
    if unknown:
        raise ToolError(f"{records.PROOFS_BUGS}: bug '{unknown[0].id}': there is no row {unknown[0].prove}")
    some = [bug for bug in some if bug.prove in by_id]
    versions, free, done, lock = provers.versions(programs), queue.SimpleQueue(), [], threading.Lock()

    def one(bug):
        folder = free.get()
        try:
            return try_bug(programs, folder, bug, by_id[bug.prove], store, versions)
        finally:
            free.put(folder)
            with lock:
                done.append(bug)
                progress(len(done))

    with scratch.folder("bugs") as copies, Progress("bugs of proofs", len(some)) as progress:
        for number in range(jobs):
            make_copy(root, copies / str(number))
            free.put(copies / str(number))
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            tried = list(pool.map(one, some))
    bare = [row.id for row in rows if row.id not in {bug.prove for bug in some}]
    output.write_json(pathlib.Path(options.build) / "prove/bugs.json", {"bugs": tried, "without": bare})
    print(table([[each["bug"], each["row"], each["words"][:90] if each["noticed"] else coloured(f"NOT NOTICED: {each['words'][:90]}", "red")]
                 for each in tried], ["bug", "row", "how the row fails"]))
    noticed = sum(each["noticed"] for each in tried)
    print(f"{noticed} of {len(tried)} bugs noticed; {len(bare)} of {len(rows)} rows have no bug of their own")
    return 1 if noticed < len(tried) else 0
