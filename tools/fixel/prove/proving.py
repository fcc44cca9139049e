# SPDX-License-Identifier: MIT
"""What fixel prove does: the rows, each case of them a shard of a campaign (fixel/campaign/shards.py), then the table of all
functions."""

import dataclasses
import functools
import json
import os
import pathlib
import re
import sys

from fixel.base import kept, output, scratch
from fixel.base.errors import ToolError
from fixel.base.table import coloured, table
from fixel.campaign import runner
from fixel.campaign.shards import AGAIN, Shard
from fixel.check import equality
from fixel.prove import cbmc, functions, others, prove, provers, recomputed, rows as records

PROVERS = {"cbmc": cbmc, "z3": others, "gappa": others, "enumeration": others, "recomputed": recomputed}


def placed(row, root):
    """The row with the text of another checkout."""
    return dataclasses.replace(row, place=root / records.PROOFS / row.place.parent.name / row.place.name)


def _inputs(root, row, case, versions):
    """All that the result of a case depends on."""
    words = (row.function, row.unreached, row.harness, row.contract, row.uses, row.unwind, row.unwindset, row.flags, row.loops, row.text, *([row.stands_in] if row.stands_in else []), *([row.of] if row.of else []),
             bool(row.narrows))
    return [versions, words, cbmc.CHECKS, cbmc.DEFINES, cbmc.RESULT, PROVERS[row.tool].preprocessed(root, row, case)]


def prove_case(programs, root, row, case, store, versions):
    """The result of a case, computed or as it is kept: {"checks", "within", "lost", "seconds"}, or {"failed", "seconds"}."""
    def compute():
        try:
            found.update(PROVERS[row.tool].prove(programs, root, row, case))
        except cbmc.TooLong:
            raise
        except cbmc.Failed as error:
            found.update({"failed": str(error), "seconds": 0.0})
        result.write_text(json.dumps(found), encoding="utf-8")

    found = {}
    with scratch.folder("result") as folder:
        result = folder / "result.json"
        try:
            store.obtain(f"proof of {row.id}", _inputs(root, row, case, versions), [result], compute)
        except cbmc.TooLong as error:
            return {"failed": str(error), "seconds": float(cbmc.SECONDS)}
        except ToolError as error:
            return {"failed": error.shown().replace("\n", " "), "seconds": 0.0}
        return json.loads(result.read_text(encoding="utf-8"))


def failure(row, cases):
    """Why a row of such cases is not proved, or None: one fails, or its function calls what no case comes back from."""
    failed = next((f"{'' if case is None else f'case {case}: '}{each['failed']}" for case, each in cases if "failed" in each), None)
    lost = set.intersection(*(set(each.get("lost", [])) for _, each in cases)) if cases else set()
    return failed or (f"{row.name} calls {min(lost)}, and for no input does that call come back" if lost else None)


def _summed(row, cases):
    """The result of a row: of all its cases."""
    failed = failure(row, cases)
    seconds = sum(each["seconds"] for _, each in cases)
    result = {"row": row.id, "function": row.function, "property": row.property, "tool": row.tool, "whole": row.is_whole, "seconds": round(seconds, 1)}
    if failed:
        return {**result, "state": "not proved", "why": failed, "checks": 0, "within": []}
    checks = sum(each["checks"] for _, each in cases)
    within = sorted({name for _, each in cases for name in each["within"]})
    if checks < row.checks:
        return {**result, "state": "lost a check", "why": f"{checks} checks, and {row.checks} are on record", "checks": checks, "within": within}
    if row.checks == 0:
        return {**result, "state": "no record", "why": f"{checks} checks: write checks = {checks} into its row, or run fixel prove --tidy",
                "checks": checks, "within": within}
    return {**result, "state": "proved", "checks": checks, "within": within}


# --- as a campaign ---------------------------------------------------------------------

SHARD_SETUP = "predict"


def _say(words):
    print(f"prove: {words}", file=sys.stderr, flush=True)


@functools.cache
def _programs(build):
    """(the provers' programs, what they say that they are)."""
    programs = provers.obtain(build, _say)
    return programs, provers.versions(programs)


@functools.cache
def _rows(root):
    return {row.id: row for row in records.read(root)}


def _root(parameters):
    return pathlib.Path(parameters["root"]) if parameters["root"] else provers.CHECKOUT


def run_shard(build, parameters):
    """{"checks", "within", "lost"} of a proved case, or {"failed"}: of one that took too long only for now."""
    cbmc.SECONDS = parameters["seconds"]
    root, row = _root(parameters), _rows(_root(parameters))[parameters["row"]]
    try:
        found = PROVERS[row.tool].prove(_programs(build)[0], root, row, parameters["case"])
    except cbmc.TooLong as error:
        return {"failed": str(error), AGAIN: True}
    except cbmc.Failed as error:
        return {"failed": str(error)}
    except ToolError as error:
        return {"failed": error.shown().replace("\n", " "), AGAIN: True}
    return {key: found.get(key, []) for key in ("checks", "within", "lost")}


def shard_inputs(build, parameters):
    try:
        return list(map(repr, _inputs(_root(parameters), _rows(_root(parameters))[parameters["row"]], parameters["case"], _programs(build)[1])))
    except ToolError:       # the shard says so once more, and what it says is of this text alone
        return [os.urandom(16).hex()]


def shard_targets(_build, _parameters):
    return []


def prove_all(root, rows, options):
    """The results of rows, in their order."""
    work = [(row, case) for row in rows for case in row.cases]
    place = None if root == provers.CHECKOUT else str(root)
    some = [Shard("prove", number, {"row": row.id, "case": case, "root": place, "seconds": options.seconds}, row.tool, 0)
            for number, (row, case) in enumerate(work)]
    done = runner.run("proofs", some, options)
    answers = zip(work, runner.whole(done), strict=True)
    found = [(case, {**answer, "seconds": done.seconds[number]}) for number, ((_, case), answer) in enumerate(answers)]
    done.tell(options.build)
    cases = iter(found)
    return [_summed(row, [next(cases) for _ in row.cases]) for row in rows]


# --- the table of all functions --------------------------------------------------------

def state_of_all(all_functions, results, measured):
    """([{"function", "external", "state", "by", "why"}], what is wrong with the table)."""
    own = {}
    for result in results:
        own.setdefault(result["function"], []).append(result)
    inside = {}
    for result in results:
        if result["state"] in ("proved", "no record") and result["tool"] == "cbmc":
            for key in result["within"]:
                inside.setdefault(key, []).append(result["row"])
    wrong = [f"{result['row']}: there is no function {function}" for function, some in own.items() for result in some
             if function not in all_functions and result["tool"] not in ("enumeration", "recomputed")]
    own = {key: some for key, some in own.items() if any(each["whole"] for each in some)}
    shown = []
    for key, external in all_functions.items():
        state, by, why = "no row", "", ""
        if key in own:
            state = "proved" if all(each["state"] in ("proved", "no record") for each in own[key]) else "not proved"
            by = ", ".join(each["row"] for each in own[key])
        elif key in inside:
            state, by = "proved within", ", ".join(sorted(inside[key])[:3])
        elif key in measured:
            state, (by, why) = "measured", measured[key]
        if key in measured and state in ("proved", "proved within"):
            wrong.append(f"{key} is {state} now: take it out of measured.toml, so that it stays proved")
        shown.append({"function": key, "external": external, "state": state, "by": by, "why": why})
    wrong += [f"{key} has no row: prove it, or say in measured.toml by which campaign it is measured and why" for key in
              (each["function"] for each in shown if each["state"] == "no row")]
    wrong += [f"measured.toml has {key}, and there is no such function" for key in measured if key not in all_functions]
    return shown, wrong


def state_of_assembly(root):
    """([{"entry", "by": {kernel: fewest random inputs on record of a core}}], what is wrong with the list)."""
    entries, listed, least = functions.assembly(root), records.assembly(root), {}
    for (_, kernel, *_), inputs in equality.recorded(pathlib.Path(root) / "firmware/equality/record.txt").items():
        least[kernel] = min(inputs, least.get(kernel, inputs))
    files = {path.relative_to(root).as_posix() for path in pathlib.Path(root).glob("lib/*/*.S")}
    wrong = [f"{file} is assembly: say in measured.toml which kernel of make equality compares it with the C text" for file in sorted(files - set(listed))]
    wrong += [f"measured.toml has {file}, and there is no such file" for file in sorted(set(listed) - files)]
    wrong += [f"measured.toml: {file} is compared as {kernel}, and firmware/equality/record.txt has no such kernel"
              for file, kernels in listed.items() for kernel in kernels if kernel not in least]
    return [{"entry": key, "by": {kernel: least.get(kernel, 0) for kernel in listed.get(key.partition(":")[0], ())}} for key in sorted(entries)], wrong


def numbers(root):
    """(those of the sentence of SOUNDNESS.md that begins "it printed:", how many functions there are, how many of them a row proves). A
    function that neither a row proves nor measured.toml names counts as proved within a row: where it is not, make prove says so."""
    rows, measured, every = records.read(root), set(records.measured(root)[0]), functions.find(root)
    own, external = {row.function for row in rows if row.is_whole}, {key for key, is_external in every.items() if is_external}
    entries = state_of_assembly(root)[0]
    counts = [count for some in (set(every), external) for count in (len(some), len(some & own), len(some - own - measured), len(some & measured))]
    return [len(rows), len(rows), sum(row.tool == "cbmc" for row in rows), sum(row.checks for row in rows if row.tool == "cbmc"), *counts,
            len(entries), len({each["entry"].partition(":")[0] for each in entries}),
            len({kernel for each in entries for kernel in each["by"]})], len(every), len(set(every) - measured)


def renew_numbers(root, said, every, proved):
    """Writes what numbers gives into the sentence of SOUNDNESS.md and that of docs/evidence.md, whose words stay."""
    for name, pattern, new in (("SOUNDNESS.md", r"(?s)(?<=it printed: ).*?(?= All rows take)", said),
                               ("docs/evidence.md", r"[\d,]+ of the\s+[\d,]+(?= functions of `lib/`)", [proved, every])):
        path, left = root / name, list(new)
        text = path.read_text(encoding="utf-8")
        sentence = re.search(pattern, text)
        places = re.findall(r"\b[\d,]*\d\b", sentence[0]) if sentence else []
        if len(places) != len(new):
            raise ToolError(f"{path}: the sentence with the {len(new)} numbers of fixel prove is not there, or has other numbers: {pattern}")
        written = re.sub(r"\b[\d,]*\d\b", lambda _: f"{left.pop(0):,}", sentence[0])
        output.write_file(path, text[:sentence.start()] + written + text[sentence.end():])
        print(f"{name}: {' '.join(written.split())}")


def _print(results, shown, assembly, wrong):
    bad = [result for result in results if result["state"] != "proved"]
    for result in bad:
        print(f"{result['row']}: {coloured(result['state'], 'red')}: {result['why']}")
    for words in wrong:
        print(coloured(words, "red"))
    if shown:
        rooms = list(dict.fromkeys(each["function"].split("/")[1] for each in shown))
        states = ("proved", "proved within", "measured", "not proved", "no row")
        counts = [[room, *(sum(each["function"].split("/")[1] == room and each["state"] == state for each in shown) for state in states),
                   sum(each["function"].split("/")[1] == room and each["external"] and each["state"] == "proved" for each in shown),
                   sum(each["entry"].split("/")[1] == room for each in assembly)]
                  for room in rooms]
        counts.append(["all", *(sum(column) for column in list(zip(*counts))[1:])])
        print(table(counts, ["functions of", *states, "external proved", "entries in assembly"]))
        kernels = {kernel: inputs for each in assembly for kernel, inputs in each["by"].items()}
        print(f"{sum(bool(each['by']) for each in assembly)} of {len(assembly)} entries in assembly are compared with the C text, by {len(kernels)} kernels of "
              f"make equality: each on {min(kernels.values(), default=0):,} random inputs or more, as on record")
    tools = {tool: [result for result in results if result["tool"] == tool] for tool in records.TOOLS}
    print(table([[tool, len(some), sum(each["state"] == "proved" for each in some), f"{sum(each['checks'] for each in some):,}",
                  f"{sum(each['seconds'] for each in some):.0f}"] for tool, some in tools.items() if some],
                ["tool", "rows", "proved", "checks, or inputs", "CPU seconds"]))
    print(f"{len(results) - len(bad)} of {len(results)} rows proved; the seconds are those when they were computed")


def command(options):
    """The command; its exit code."""
    root = pathlib.Path(options.root).resolve()
    rows = records.read(root)
    chosen = prove.before(options)
    if options.accept:
        records.accept(root, chosen, functions.text_of)
        options.accept = False
        return command(options)
    if options.numbers:
        wrong = records.measured(root)[1]
        if wrong:
            raise ToolError(wrong[0])
        renew_numbers(root, *numbers(root))
        return 0
    records.check_assumptions(root, rows)
    jobs = runner.jobs_of(options)
    from fixel.prove import bugs, mutants    # which use this module
    if options.bugs or options.mutants:
        cbmc.SECONDS = options.seconds
        return (bugs if options.bugs else mutants).command(_programs(options.build)[0], root, jobs, chosen, options, kept.Kept(options.build, options.fresh))
    if not options.cluster:
        _programs(options.build)    # fetched once, before the processes ask for them
    results = prove_all(root, chosen, options)
    gone = set()
    shown, assembly, wrong = [], [], records.circles(rows) + records.lemmas(root, rows) + records.unrun(rows)
    if not options.only:
        measured, more = records.measured(root)
        shown, most = state_of_all(functions.find(root), results, measured)
        assembly, unbound = state_of_assembly(root)
        wrong += more + most + unbound
        every = {each["function"] for each in shown}
        gone = {key for key in measured if key not in every}
    if options.tidy:
        proved = [result for result in results if result["checks"]]
        records.record_checks(root, {result["row"]: result["checks"] for result in proved})
        records.tidy(root, gone | {key for result in proved if result["whole"] for key in (result["function"], *result["within"])})
    output.write_json(pathlib.Path(options.build) / "prove/prove.json", {"rows": results, "functions": shown, "assembly": assembly, "wrong": wrong})
    _print(results, shown, assembly, wrong)
    stale = bugs.stale(root, bugs.pairs_of(root, chosen))
    if stale:
        print(f"of another text are the bugs of {', '.join(sorted({row.id for _, row in stale}))}: make prove BUGS=1 tries them anew")
    return 1 if wrong or any(result["state"] != "proved" for result in results) else 0
