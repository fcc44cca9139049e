# SPDX-License-Identifier: MIT
"""A row that CBMC proves: the harness and the shipped text as one program, with contracts, every property of it checked."""

import os
import re

from fixel.base import children, limits, scratch
from fixel.base.errors import ToolError
from fixel.prove import functions

SECONDS = 120           # of CPU time a row
MEMORY = 6 << 30        # bytes of address space of a prover: two at a time leave a machine of 16 GB usable
DEFINES = ("-DFXL_PROVE", "-std=gnu11", "-Ilib/include", "-Ilib", "-Ihost_tests/proofs")
CHECKS = ("--bounds-check", "--pointer-check", "--pointer-overflow-check", "--signed-overflow-check", "--undefined-shift-check",
          "--div-by-zero-check", "--conversion-check", "--pointer-primitive-check", "--unwinding-assertions", "--slice-formula", "--object-bits", "12")
RESULT = "any statics, reached ends, calls come back"   # of what a result says: another text here, and nothing that was kept is used
REACHED = "the harness ends"        # PROOF_ENDS of proof.h: it must fail
ENDS = "insert-final-assert-false (should fail) "       # of a function's end: it fails if a call comes back from there
# Lines of goto-instrument --show-goto-functions: where a function begins, the place of an instruction, a call that is not by pointer.
BEGINS = re.compile(r"([\w$]+) /\* \1 \*/")
PLACE = re.compile(r"\s+// \d+ file (\S+) line ")
CALLS = re.compile(r"\s+(?:\d+: )?CALL (?:.*? := )?([A-Za-z_][\w$]*)\(")
NO_CONTRACT = "deriving empty"
# Lines of cbmc, which would write a trace of each failure as JSON: hundreds of megabytes.
HEADING = re.compile(r"(\S+) function \S+$")
PROPERTY = re.compile(r"\[(?P<id>\S+)\] (?:file \S+ )?(?:line (?P<line>\d+) )?(?P<what>.*): (?P<status>[A-Z]+)$")
SUMMARY = re.compile(r"^\*\* \d+ of \d+ failed", re.MULTILINE)


class Failed(Exception):
    """The row is not proved: why, in a line. Its text is kept, unless it took too long."""


class TooLong(Failed):
    """It may be proved by another run, so this one is not kept."""


def _run(programs, root, words, left):
    """Runs a prover; (what it said, its exit code, CPU seconds)."""
    environment = {**os.environ, "PATH": f"{programs}:{os.environ['PATH']}", "LC_ALL": "C"}
    try:
        done = limits.run(["prlimit", f"--as={MEMORY}", str(programs / words[0]), *map(str, words[1:])], max(1.0, left), merge=True,
                          text=True, cwd=root, env=environment)
    except limits.LimitError as error:
        raise TooLong(f"{words[0]} had not ended after {SECONDS} s of CPU time") from error
    return done.stdout, done.returncode, done.cpu


def preprocessed(root, row, case):
    """The text that is proved, as the compiler sees it: the key of what is kept."""
    return text_of(root, row, [*DEFINES, *_defines(row, case), "-xc"])


def text_of(root, row, flags):
    """What the compiler sees of a row's program."""
    words = ["gcc", "-E", "-P", *flags, str(row.place), *row.links]
    done = children.run(words, cwd=root)
    if done.returncode:
        raise ToolError(f"{row.id}: its text cannot be read", words=done.stderr.decode(errors="replace"))
    return done.stdout


def _checks(row):
    """A row may give the bits of objects itself: fewer make some proofs fast, and more let others have more objects."""
    some = CHECKS[:-2] if "--object-bits" in row.flags else CHECKS
    return tuple(check for check in some if check != "--conversion-check") if row.narrows else some


def _defines(row, case):
    """Macros of a row's text: flags of the row that begin with -D. The others are of cbmc itself."""
    return [*(flag for flag in row.flags if flag.startswith("-D")), *([] if case is None else [f"-DCASE={case}"]), *(["-DFXL_WITHOUT_EQUATIONS"] if row.equations else [])]


def prove(programs, root, row, case):
    """{"checks", "within", "lost", "seconds"} of a proved case; Failed where it is not proved. lost: what the function calls without any
    call that comes back."""
    spent = 0.0
    with scratch.folder("proof") as folder:
        program, ready = folder / "whole.goto", folder / "ready.goto"
        said, code, cpu = _run(programs, root, ["goto-cc", *DEFINES, *_defines(row, case), "--function", row.harness, "-o", program, row.place,
                                                *row.links], SECONDS)
        spent += cpu
        if code:
            raise Failed(f"goto-cc: {_last(said)}")
        said, code, cpu = _run(programs, root, ["goto-instrument", "--show-goto-functions", program], SECONDS - spent)
        spent += cpu
        within, direct = _within(said, row)
        within = _texts(root, row, case, folder, within)
        for name in within:
            ended = folder / f"ended_{name}.goto"
            said, code, cpu = _run(programs, root, ["goto-instrument", "--insert-final-assert-false", name, program, ended], SECONDS - spent)
            spent += cpu
            if code:
                raise Failed(f"goto-instrument: {_last(said)}")
            program.unlink()
            program = ended
        # a table that nobody fills would be zeros, and the row would speak of zeros alone
        any_static = folder / "any_static.goto"
        said, code, cpu = _run(programs, root, ["goto-instrument", "--nondet-static", program, any_static], SECONDS - spent)
        spent += cpu
        if code:
            raise Failed(f"goto-instrument: {_last(said)}")
        program = any_static
        if row.stands_in:
            # also where the function is called by a pointer
            replaced = [word for name, to in row.stands_in.items() for word in ("--replace-calls", f"{name}:{to}")]
            for step, words in enumerate((["--remove-function-pointers"], replaced)):
                called = folder / f"called_{step}.goto"
                said, code, cpu = _run(programs, root, ["goto-instrument", *words, program, called], SECONDS - spent)
                spent += cpu
                if code:
                    raise Failed(f"goto-instrument: {_last(said)}")
                program = called
        if row.contract or row.uses or row.loops:
            words = ["goto-instrument", "--dfcc", row.harness, *(["--enforce-contract", row.name] if row.contract else []),
                     *[word for name in row.uses for word in ("--replace-call-with-contract", name)],
                     *(["--apply-loop-contracts"] if row.loops else []), program, ready]
            said, code, cpu = _run(programs, root, words, SECONDS - spent)
            spent += cpu
            if code:
                raise Failed(f"goto-instrument: {_last(said)}")
            if NO_CONTRACT in said:
                raise Failed(next(line.strip() for line in said.splitlines() if NO_CONTRACT in line))
        else:
            ready = program
        unwound = ",".join(f"{loop}:{times}" for loop, times in row.unwindset.items())
        words = ["cbmc", "--drop-unused-functions", *_checks(row), *(flag for flag in row.flags if not flag.startswith("-D")), "--unwind", row.unwind, *(["--unwindset", unwound] if unwound else []), ready]
        said, _, cpu = _run(programs, root, words, SECONDS - spent)
    checks, ended = judge(said)
    lost = sorted(name for name in direct if name in within and name not in ended and name not in row.unreached)
    return {"checks": checks, "within": sorted({key for name, key in within.items() if name in ended}), "lost": lost, "seconds": spent + cpu}


def _last(said):
    """The line that says what was wrong."""
    lines = [line for line in said.splitlines() if line.strip()]
    return next((line for line in lines if "error" in line.lower()), lines[-1] if lines else "it said nothing")


def _within(shown, row):
    """({name in the program: (file, name)} of the functions that the harness, or one that it calls, calls by name, and that have
    their own text in the program; those that the row's function calls itself). One that a pointer of its type might mean is none of them."""
    calls, files, caller = {}, {}, None
    for line in shown.splitlines():
        if begins := BEGINS.match(line):
            caller = begins[1]
            calls[caller] = []
        elif place := PLACE.match(line):
            files.setdefault(caller, os.path.normpath(place[1]))
        elif called := CALLS.match(line):
            calls[caller].append(row.stands_in.get(called[1], called[1]))
    found, waiting = set(), [row.harness]
    while waiting:
        name = waiting.pop()
        if name not in found and name not in row.uses:
            found.add(name)
            waiting += calls.get(name, [])
    # of two static functions of a name, the linker adds to that of one
    return ({name: (files[name], name.partition("$")[0]) for name in found if name in files},
            {called for name in found if (files.get(name), name.partition("$")[0]) == (row.file, row.name) for called in calls[name]})


def _texts(root, row, case, folder, within):
    """{name in the program: FILE:NAME} of those that are functions of the library. Without FXL_PROVE the compiler takes the harness, too."""
    sources = [row.place, *row.links]
    flags = ("-w", "-Ihost_tests/proofs", *_defines(row, case))
    defined = {(file, name) for source in sources for file, _, _, name in functions.defined_in(root, source, folder, flags)}
    return {name: ":".join(place) for name, place in within.items() if place in defined}


def judge(said):
    """(how many properties hold, the functions whose ends are reached); Failed if one does not hold, or if the harness is not seen to end."""
    if not SUMMARY.search(said):
        refused = next((line for line in said.splitlines() if "error" in line.lower() or "out of memory" in line.lower()), None)
        if refused:
            raise Failed(f"cbmc: {refused}")
        raise TooLong(f"cbmc ended without a result: {_last(said)}")      # by a signal: another run may end
    file, results = "?", []
    for line in said.splitlines():
        if heading := HEADING.match(line):
            file = heading[1]
        elif found := PROPERTY.match(line):
            results.append({**found.groupdict(), "file": file})
    ends = [each for each in results if each["what"] == REACHED]
    if not ends:
        raise Failed("the harness has no PROOF_ENDS()")
    if not any(each["status"] == "FAILURE" for each in ends):
        raise Failed("nothing is proved: the harness never ends for any input (PROOF_ENDS() is not reached)")
    checks = [each for each in results if each["what"] not in (REACHED, ENDS)]
    bad = sorted((each for each in checks if each["status"] != "SUCCESS"), key=lambda each: each["status"] != "FAILURE")
    if bad:
        raise Failed(f"{bad[0]['file']}:{bad[0]['line'] or '?'}: {bad[0]['what']}: {bad[0]['status'].lower()}"
                     f"{f' (and {len(bad) - 1} more)' if len(bad) > 1 else ''}")
    return len(checks), {each["id"].partition(".")[0] for each in results if each["what"] == ENDS and each["status"] == "FAILURE"}
