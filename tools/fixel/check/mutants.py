# SPDX-License-Identifier: MIT
"""Tests the tests: puts small mistakes into the library and the tools, drawn at random, one at a time.

A mutant is killed where a test fails with it; it survives where all pass. library_mutants.py and tool_mutants.py say
how one is tried; both work in copies below --build, never in the checkout. Of each part --count mutants are drawn: each is
a shard of a campaign (fixel/campaign/shards.py), and where some do not count, the next ones of the seed's order follow.
host_tests/build/survivors.toml has mutants that change no result, with the reason of each. One of them that is drawn is
not counted, and is printed apart. Writes all mutants as JSON. Exit: 0 done, 1 a test fails without a mutant, or fewer
than --least per cent were killed, 2 could not run.
"""

import argparse
import os
import pathlib
import sys

from fixel.base import output, spent
from fixel.base.arguments import number
from fixel.base.errors import ToolError
from fixel.campaign import runner
from fixel.campaign.shards import Shard
from fixel.check import library_mutants, mutate, mutate_python, tool_mutants

CHECKOUT = pathlib.Path(__file__).resolve().parents[3]
KNOWN = "host_tests/build/survivors.toml"
PARTS = {"lib": library_mutants, "tools": tool_mutants}
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
            found += mutate.keyed(mutants_of(file, text), text)
    return sorted(found, key=lambda pair: mutate.place_of(seed, pair[0]))


def counted(tried):
    """How many of the mutants count."""
    return sum(result["result"] not in UNCOUNTED for _, result in tried)


def batch(drawn, count, known):
    """The beginning of what is drawn, up to so many that are not known."""
    some = []
    for key, mutant in drawn:
        if count == 0:
            break
        some.append((key, mutant))
        count -= key[:3] not in known
    return some


def try_all(drawn, count, known, compute):
    """[(mutant, result)] in the order in which they were drawn, until so many count. compute([(place, key, mutant)]): {place:
    result}."""
    tried = []
    while some := batch(drawn[len(tried):], count - counted(tried), known):
        results = compute([(len(tried) + number, key, mutant) for number, (key, mutant) in enumerate(some) if key[:3] not in known])
        tried += [(mutant, {"result": "known", "words": known[key[:3]]} if key[:3] in known else results[number])
                  for number, (key, mutant) in enumerate(some, len(tried))]
    return up_to(tried, count)


def up_to(tried, count):
    """The beginning of what was tried, with so many that count."""
    found = []
    for each in tried:
        if count == 0:
            break
        found.append(each)
        count -= counted([each])
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
    print(f"mutants: {len(drawn)} of the {part.NAME} to draw from", file=sys.stderr, flush=True)
    label = f"mutants of the {part.NAME}"
    plan, done = part.Plan(options), runner.Done(label, [])

    def compute(some):
        if not some:
            return {}
        made = runner.run(label, [Shard(part.CAMPAIGN, place, plan.parameters(key, mutant), "mutant", 0)
                                  for place, key, mutant in some], options)
        runner.whole(made)
        done.add(made)
        return made.results

    tried = try_all(drawn, options.count, known, compute)
    if done.shards:
        done.tell(options.build)
    return judge(tried, options.seed)


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--part", choices=sorted(PARTS), help="only the library's or the tools' mutants")
    made.add_argument("--seed", type=int, required=True, help="of the choice of mutants")
    made.add_argument("--count", type=number("COUNT", 1, 1_000_000), default=100, help="so many mutants of each part")
    made.add_argument("--only", default="", help="only of files with this in their path")
    made.add_argument("--least", type=float, default=0.0, help="per cent that must be killed")
    made.add_argument("--build", default="build", help="the build folder")
    library_mutants.Plan.add_options(made)
    runner.add_options(made)
    return made


def parts_of(options):
    """{the word of a part: it}, of those that are asked for."""
    return {word: PARTS[word] for word in ([options.part] if options.part else sorted(PARTS))}


def before(options):
    """Refuses a word that no file has in its path."""
    parts = parts_of(options).values()
    if not any(options.only in path.relative_to(CHECKOUT).as_posix() for part in parts for path in part.files(CHECKOUT)):
        raise ToolError(f"no file of the {' or the '.join(part.NAME for part in parts)} has '{options.only}' in its path")


def main(argv):
    options = parser().parse_args(argv)
    os.nice(NICE)
    known = mutate.load(CHECKOUT / KNOWN, CHECKOUT, mutants_of)
    scratch = pathlib.Path(options.build).resolve() / "mutants"
    parts = parts_of(options)
    drawn = {word: draw(part.files(CHECKOUT), options.only, options.seed) for word, part in parts.items()}
    if not any(drawn.values()):
        raise ToolError(f"no file of the {' or the '.join(part.NAME for part in parts.values())} has '{options.only}' in "
                        "its path and a mutant")
    results = {word: run(parts[word], drawn[word], options, known) for word in parts if drawn[word]}
    for word, result in results.items():
        output.write_json(scratch / f"{word}-seed-{options.seed}.json", result)
        print_result(parts[word].NAME, result)
    spent.tell()
    return 1 if any(result["percent"] < options.least for result in results.values()) else 0
