# SPDX-License-Identifier: MIT
"""Tests the tests: puts small mistakes into the library and the tools, drawn at random, one at a time.

A mutant is killed where a test fails with it; it survives where all pass. library_mutants.py and tool_mutants.py say
how one is tried; both work in copies below --build, never in the checkout. Of each part --count mutants are drawn.
host_tests/build/survivors.toml has mutants that change no result, with the reason of each. One of them that is drawn is
not counted, and is printed apart. Writes all mutants as JSON. Exit: 0 done, 1 a test fails without a mutant, or fewer
than --least per cent were killed, 2 could not run.
"""

import argparse
import concurrent.futures
import os
import pathlib
import queue
import sys
import threading

from fixel.base import output, spent
from fixel.base.errors import ToolError
from fixel.base.progress import Progress
from fixel.check import mutate, mutate_python, survivors
from fixel.check.library_mutants import Library
from fixel.check.tool_mutants import Tools

CHECKOUT = pathlib.Path(__file__).resolve().parents[3]
KNOWN = "host_tests/build/survivors.toml"
PARTS = {"lib": Library, "tools": Tools}
NICE = 5
UNCOUNTED = ("no mutant", "known")


def mutants_of(file, text):
    """All mutants of a file of the project."""
    return (mutate_python if file.endswith(".py") else mutate).mutants(file, text)


def draw(files, only, seed, checkout=CHECKOUT):
    """[(key, mutant)] of files with a word in their path, in the order of a seed."""
    found = []
    for path in files:
        file, text = path.relative_to(checkout).as_posix(), path.read_text(encoding="utf-8")
        if only in file:
            found += survivors.keyed(mutants_of(file, text), text)
    return sorted(found, key=lambda pair: survivors.place_of(seed, pair[0]))


def try_all(part, trees, drawn, count, known):
    """[(mutant, result)] in the order in which they were drawn, until so many count."""
    free, results, lock, places = queue.SimpleQueue(), {}, threading.Lock(), iter(range(len(drawn)))
    for tree in trees:
        free.put(tree)

    def counted():
        return sum(result["result"] not in UNCOUNTED for result in results.values())

    def work():
        tree = free.get()
        while True:
            with lock:
                place = next(places, None) if counted() < count else None
            if place is None:
                return
            key, mutant = drawn[place]
            result = {"result": "known", "words": known[key[:3]]} if key[:3] in known else part.run(tree, mutant)
            with lock:
                results[place] = result
                progress(min(counted(), count))
                if result["result"] == "survived":
                    print(f"survived: {mutant}", file=sys.stderr, flush=True)

    with Progress(f"mutants of the {part.name}", count) as progress, concurrent.futures.ThreadPoolExecutor(len(trees)) as pool:
        for future in [pool.submit(work) for _ in trees]:
            future.result()
    return up_to([(drawn[place][1], results[place]) for place in sorted(results)], count)


def up_to(tried, count):
    """The beginning of what was tried, with so many that count: trees that work side by side try some more."""
    found, counted = [], 0
    for mutant, result in tried:
        if counted == count:
            break
        found.append((mutant, result))
        counted += result["result"] not in UNCOUNTED
    return found


def judge(tried, seed):
    """The result as JSON has it."""
    of = {word: [(mutant, result) for mutant, result in tried if result["result"] == word]
          for word in ("killed", "survived", *UNCOUNTED)}
    count, killed = len(of["killed"]) + len(of["survived"]), len(of["killed"])
    return {"seed": seed, "count": count, "killed": killed, "percent": 100 * killed / max(1, count),
            "known": len(of["known"]), "not_counted": len(of["no mutant"]),
            "mutants": [{"mutant": str(mutant), **result} for mutant, result in tried]}


def print_result(name, result):
    """For people."""
    for word in ("known", "survived"):
        for each in result["mutants"]:
            if each["result"] == word:
                print(f"{'changes no result' if word == 'known' else word}: {each['mutant']}"
                      f"{' (' + each['words'] + ')' if each.get('words') else ''}")
    print(f"{result['killed']} of {result['count']} mutants of the {name} killed: {result['percent']:.1f} % (seed {result['seed']}). "
          f"Not counted: {result['known']} that change no result ({KNOWN})"
          f"{', ' + str(result['not_counted']) + ' that do not compile or leave the machine code as it was' if result['not_counted'] else ''}")


def run(part, drawn, options, known):
    """Tries the mutants of a part: the result as JSON has it."""
    print(f"mutants: {len(drawn)} of the {part.name} to draw from", file=sys.stderr, flush=True)
    try:
        tried = try_all(part, part.prepare(), drawn, options.count, known)
    finally:
        part.close()
    return {**judge(tried, options.seed), "left_out": part.left_out()}


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--part", choices=sorted(PARTS), help="only the library's or the tools' mutants")
    made.add_argument("--seed", type=int, required=True, help="of the choice of mutants")
    made.add_argument("--count", type=int, default=100, help="so many mutants of each part")
    made.add_argument("--only", default="", help="only of files with this in their path")
    made.add_argument("--least", type=float, default=0.0, help="per cent that must be killed")
    made.add_argument("--build", default="build", help="the build folder")
    made.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    for part in PARTS.values():
        part.add_options(made)
    return made


def main(argv):
    options = parser().parse_args(argv)
    os.nice(NICE)
    known = survivors.load(CHECKOUT / KNOWN, CHECKOUT, mutants_of)
    scratch = pathlib.Path(options.build).resolve() / "mutants"
    parts = {word: PARTS[word](options, scratch, CHECKOUT) for word in ([options.part] if options.part else sorted(PARTS))}
    drawn = {word: draw(part.files(), options.only, options.seed) for word, part in parts.items()}
    if not any(drawn.values()):
        raise ToolError(f"no file of the {' or the '.join(part.name for part in parts.values())} has '{options.only}' in "
                        "its path and a mutant")
    results = {word: run(parts[word], drawn[word], options, known) for word in parts if drawn[word]}
    for word, result in results.items():
        output.write_json(scratch / f"{word}-seed-{options.seed}.json", result)
        print_result(parts[word].name, result)
    spent.tell()
    return 1 if any(result["percent"] < options.least for result in results.values()) else 0
