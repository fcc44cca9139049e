# SPDX-License-Identifier: MIT
"""Compares a run of make bench with the baseline, or makes the run the new baseline.

Exit: 0 no figure of Fixel is worse by more than the threshold, 1 a figure is worse or missing, 2 there
is nothing to compare. --accept makes the run the baseline, and renews the tables of docs/performance.md, and docs/faces.md with its
picture beside it.
"""

import argparse
import pathlib
import sys

from fixel.base import output
from fixel.base.errors import ToolError, one_line
from fixel.base.table import coloured, table
from fixel.commands import late

bench_page, bench_plan, bench_plots = late("fixel.bench", "bench_page bench_plan bench_plots")
programs = late("fixel.board", "programs")

KEY = ("workload", "renderer", "core")
MEASURES = ("instructions", "text_bytes", "ram_bytes", "stack_bytes")
WORDS = {"instructions": ("slower", "faster"), "text_bytes": ("larger", "smaller"),
         "ram_bytes": ("larger", "smaller"), "stack_bytes": ("deeper", "shallower")}
OURS = "fixel"


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--baseline", default="bench/baseline.json")
    made.add_argument("--current", default="build/bench/bench.json")
    made.add_argument("--threshold", type=float, default=0.5, help="per cent that count as no change")
    made.add_argument("--accept", action="store_true", help="make the current run the baseline")
    made.add_argument("--document", default="docs/performance.md")
    return made


def read_rows(path):
    """(the whole file, {key: row}) of a bench.json."""
    if not pathlib.Path(path).exists():
        raise ToolError(f"{path} is not there: run make bench")
    data = programs.read_json(path)
    try:
        return data, {tuple(row[part] for part in KEY): row for row in data["rows"]}
    except (KeyError, TypeError) as error:
        raise ToolError(f"{path} is not a result of make bench: {error}") from error


def changes(before, after):
    """[(key, measure, old, new, percent)] of each figure that differs, the worst first. The code of a renderer
    is the same for all workloads, and is given once."""
    found = {}
    for key in before.keys() & after.keys():
        for measure in MEASURES:
            old, new = before[key][measure], after[key][measure]
            if old != new and None not in (old, new):
                named = ("all", *key[1:]) if measure == "text_bytes" else key
                found[named, measure] = (old, new, 100 * (new / old - 1) if old else float("inf"))
    return sorted(((*names, *figures) for names, figures in found.items()),
                  key=lambda change: (-change[4], change[0], change[1]))


def judge(found, missing, threshold):
    """Sentences: the figures of Fixel that are worse by more than the threshold, or missing."""
    worse = [f"{' '.join(key)}: {WORDS[measure][0]} by {percent:.2f} %"
             for key, measure, _, _, percent in found if key[1] == OURS and percent > threshold]
    return worse + [f"{' '.join(key)}: not measured any more" for key in sorted(missing)]


def print_changes(found, threshold):
    """A table for people."""
    if not found:
        print("nothing changed")
        return
    rows = [[*key, measure, old, new, f"{percent:+.2f} %",
             WORDS[measure][0 if percent > 0 else 1] + ("" if abs(percent) > threshold else ", hardly")]
            for key, measure, old, new, percent in found]
    print(table(rows, [*KEY, "measure", "before", "now", "change", ""]))


def compare(before, after, threshold):
    """Prints the comparison; the exit code."""
    (old, old_rows), (new, new_rows) = before, after
    for tool in ("compiler", "emulator"):
        if old.get(tool) != new.get(tool):
            print(f"note: another {tool}: '{old.get(tool)}' before, '{new.get(tool)}' now", file=sys.stderr)
    found = changes(old_rows, new_rows)
    print_changes(found, threshold)
    new_keys = sorted(new_rows.keys() - old_rows.keys())
    if new_keys:
        print(f"new: {', '.join(' '.join(key) for key in new_keys)}")
    lacking, left_out = old_rows.keys() - new_rows.keys(), new.get("left_out", ())
    passed_over = {key for key in lacking if key[2] in left_out}
    if passed_over:
        print(f"not compared, because no board has the core: {', '.join(sorted({key[2] for key in passed_over}))}")
    worse = judge(found, lacking - passed_over, threshold)
    for sentence in worse:
        print(f"{coloured('WORSE', 'red')}: {sentence}")
    if not worse:
        print(f"{coloured('pass', 'green')}: no figure of Fixel is worse by more than {threshold:g} %")
    return 1 if worse else 0


def accept(data, baseline, document, plan):
    """Makes a run the baseline."""
    if data.get("left_out"):
        raise ToolError(f"a baseline needs every core; left out were: {', '.join(data['left_out'])}")
    measured = {value for row in data["rows"] for value in (row["core"], row.get("workload"))}
    missing = [name for name in (*bench_plan.CORES, *bench_plan.EXTRA_CORES, *plan.workloads) if name not in measured]
    if missing:
        raise ToolError(f"a baseline needs every core and every workload; {missing[0]} was not measured: "
                        f"run make bench without CORE= and WORKLOAD=")
    faces = pathlib.Path(document).with_name("faces.md")
    texts = {file: bench_page.replace_tables(file.read_text(encoding="utf-8"), plan, data, sections)
             for file, sections in ((pathlib.Path(document), bench_page.DOCUMENT), (faces, bench_page.FACES_PAGE))}
    picture = bench_plots.files(plan, data)["faces.png"]
    output.write_json(baseline, data)
    for file, text in texts.items():
        output.write_file(file, text)
    output.write_file(faces.with_suffix(".png"), picture)
    print(f"{', '.join(one_line(each) for each in (baseline, *texts, faces.with_suffix('.png')))}: renewed", file=sys.stderr)


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    after = read_rows(options.current)
    if options.accept:
        accept(after[0], options.baseline, options.document, bench_plan.Plan("build"))
        return 0
    return compare(read_rows(options.baseline), after, options.threshold)
