# SPDX-License-Identifier: MIT
"""Shows that a function's rows state its result: of five small mistakes in the function, by each of three seeds, they must fail on four.

A mistake is one of mutate.py. Those that leave the machine code as it was, and those of host_tests/build/survivors.toml, are replaced
by the next ones of the seed. Only provers that read the library's text are asked: a transcription has a hash of it, and a text that
merely differs shows nothing. host_tests/proofs/mutants.toml keeps what was found, with a hash of each function's text.
"""

import json
import pathlib
import tomllib

from fixel.base import children, scratch
from fixel.base.errors import ToolError
from fixel.base.table import coloured, table
from fixel.check import mutants as drawing, mutate, planting
from fixel.prove import bugs, functions, provers, proving, rows as records

COUNT, SEEDS, LEAST = 5, (1, 2, 3), 4
TOOLS = ("cbmc", "enumeration", "recomputed")
RECORD = records.PROOFS / "mutants.toml"
HEAD = f"""# SPDX-License-Identifier: MIT
# Of {COUNT} mutants of a function, by the seeds {', '.join(map(str, SEEDS))}, how many its rows notice, and which they do not: written by
# `fixel prove --mutants --only FUNCTION`. text: a hash of the function, without comments and white space.
"""
CODE = ("gcc", *functions.FLAGS, "-w", "-O2", "-fkeep-static-functions", "-fkeep-inline-functions", "-S", "-o", "-", "-xc")


def load(root):
    """{FILE:NAME: {"text", "noticed", "missed"}} of the record."""
    path = pathlib.Path(root) / RECORD
    found = tomllib.loads(path.read_text(encoding="utf-8")) if path.is_file() else {}
    return {f"{file}:{name}": entry for file, named in found.items() for name, entry in named.items()}


def save(root, found):
    """Writes the record."""
    out = [HEAD]
    for function, entry in sorted(found.items()):
        file, _, name = function.rpartition(":")
        missed = "".join(f"\n    {json.dumps(each, ensure_ascii=False)}," for each in entry["missed"])
        out.append(f'["{file}".{name}]\ntext = "{entry["text"]}"\nnoticed = {entry["noticed"]}\nmissed = [{missed}{chr(10) * bool(missed)}]\n')
    (pathlib.Path(root) / RECORD).write_text("\n".join(out), encoding="utf-8")


def _machine_code(folder, file):
    done = children.run([*CODE, file], cwd=folder)
    return None if done.returncode else done.stdout


def draw(folder, function, seed, known):
    """The first mutants of a function, in the order of a seed, that are another program, and that nothing says to change no result."""
    file, _, name = function.rpartition(":")
    text = (folder / file).read_text(encoding="utf-8")
    owners, before, found = planting.functions(text), _machine_code(folder, file), []
    every = [pair for pair in mutate.keyed(mutate.mutants(file, text), text) if owners[pair[1].line - 1] == name]
    for key, mutant in sorted(every, key=lambda pair: mutate.place_of(seed, pair[0])):
        if key[:3] in known:
            continue
        with planting.planted(folder, [mutant]):
            after = _machine_code(folder, file)
        if after not in (None, before):
            found.append(mutant)
        if len(found) == COUNT:
            break
    return found


def command(programs, root, jobs, rows, options, store):
    """fixel prove --mutants; its exit code. rows: those of the functions that are asked for."""
    by_function, kept = {}, load(root)
    for row in rows:
        if row.tool in TOOLS and (options.only or row.function in kept):
            by_function.setdefault(row.function, []).append(row)
    for some in by_function.values():
        some.sort(key=lambda row: (row.tool != "enumeration", row.checks))      # those that end soon come first
    known = mutate.load(root / drawing.KNOWN, root, drawing.mutants_of)
    versions = provers.versions(programs)
    with scratch.folder("mutants") as folder:
        copies = [folder / str(number) for number in range(jobs)]
        for copy in copies:
            bugs.make_copy(root, copy)
        for row in [each for rows in by_function.values() for each in rows]:
            for case in row.cases:      # a row that fails without a mistake would notice each
                answer = proving.prove_case(programs, root, proving.placed(row, root), case, store, versions)
                if "failed" in answer:
                    raise ToolError(f"{row.id} is not proved: {answer['failed']}")
        some = [(function, seed, mutant) for function in by_function for seed in SEEDS for mutant in draw(copies[0], function, seed, known)]

        def attempt(copy, each):
            function, _, mutant = each
            for row in by_function[function]:
                if bugs.fails(programs, copy, mutant, row, store, versions)[0]:
                    return row.id
            return None

        answers = list(zip(some, planting.try_all("mutants of proofs", some, copies, attempt)))
    kept = load(root)       # as another command may have left it meanwhile
    for function in by_function:
        own = [(seed, mutant, by) for (of, seed, mutant), by in answers if of == function]
        kept[function] = {"text": functions.text_of(root, function), "noticed": [sum(at == seed and by is not None for at, _, by in own) for seed in SEEDS],
                          "missed": sorted({str(mutant).partition(": ")[2] + f" in '{_line(root, mutant)}'" for _, mutant, by in own if by is None})}
    save(root, kept)
    for function in by_function:
        for words in kept[function]["missed"]:
            print(f"{function}: {coloured('not noticed', 'red')}: {words}")
    print(table([[function, *kept[function]["noticed"]] for function in by_function], [f"of {COUNT} mutants", *(f"seed {seed}" for seed in SEEDS)]))
    return 1 if any(min(kept[function]["noticed"]) < LEAST for function in by_function) else 0


def _line(root, mutant):
    return " ".join((root / mutant.file).read_text(encoding="utf-8").splitlines()[mutant.line - 1].split())
