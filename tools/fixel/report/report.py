# SPDX-License-Identifier: MIT
"""Measures every claim about accuracy, and compares Fixel with plain 16.16 and float32.

Writes report.json and report.html (one self-contained page). The same seed and number of samples give the
same report on every machine. --only measures some claims, with as many samples as you like, and writes
claims.json. Exit: 0 every claim holds and the ray-cast oracle agrees, 1 not, 2 the report could not be made.
"""

import argparse
import pathlib
import sys

from fixel.base import bounded, kept, output, scratch, spent
from fixel.base.arguments import whole_number
from fixel.base.errors import ToolError, one_line
from fixel.base.table import coloured, table
from fixel.campaign import runner
from fixel.commands import late
from fixel.report import report_shards

host_programs = late("fixel.board", "programs")
report_claims, report_frames, report_page, report_plots = late("fixel.report", "report_claims report_frames report_page report_plots")

SAMPLES_MAX = 10 ** 12
MINUTES_MAX = 60 * 24 * 366
PATTERNS = ["report.html", "report.json"]
RAY_FRAMES = 12         # about how many frames the ray-cast oracle judges
# Below the default number of samples paths are cut in proportion, to no fewer frames than this.
FEWEST_FRAMES = 2


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--samples", help="number of vertices, ten million without; the other samples are in proportion (SAMPLES=)")
    made.add_argument("--seed", default="1", help="seed of the random samples (SEED=)")
    made.add_argument("--only", default="", help="measure these claims alone, like \"texel_affine depth_16\"; no page (ONLY=)")
    made.add_argument("--scene", help="judge only the frames of this .toml, .obj or .fxls (SCENE=)")
    bounded.add_options(made)
    made.add_argument("--board", default="mps2-an385", help="board that counts instructions for the claim scale")
    made.add_argument("--minutes", help="of two cores that samples beyond ten million may take: 20, and on a cluster any number; 0: any number "
                                        "(MINUTES=)")
    made.add_argument("--out", default="build/report")
    made.add_argument("--build", default="build", help="folder that make builds in")
    runner.add_options(made)
    made.add_argument("--picture", metavar="FILE",
                      help="only write the README's picture, from the report in --out")
    return made


def before(options):
    """The options, as the command needs them."""
    options.samples = report_shards.SAMPLES if options.samples is None else \
        whole_number("SAMPLES", options.samples, 1, SAMPLES_MAX)
    options.seed = whole_number("SEED", options.seed, 0, 2 ** 64 - 1)
    runner.jobs_of(options)
    minutes = "0" if options.cluster and options.minutes is None else options.minutes or report_shards.MINUTES
    options.minutes = whole_number("MINUTES", minutes, 0, MINUTES_MAX)
    options.only = options.only.split()
    known = [kind.what for kind in report_shards.CLAIMS]
    for word in options.only:
        if word not in known:
            raise ToolError(f"ONLY names '{word}'; the claims that have samples are: {', '.join(known)}")
    return options


def frame_limit(samples):
    """How many frames of each walk a report of so many samples looks at; None: all."""
    if samples >= report_shards.SAMPLES:
        return None
    return max(FEWEST_FRAMES, report_frames.VIEWS * samples // report_shards.SAMPLES)


def gather(options, work):
    """Everything measured: the report as a dictionary, and the frames to show."""
    build, limit = pathlib.Path(options.build), frame_limit(options.samples)
    about = report_shards.list_designs(build)
    kinds = (*report_shards.CLAIMS, *report_shards.STAGES, *report_shards.SWEEPS)
    shards = report_shards.draw(options, kinds)
    sources = [options.scene] if options.scene else report_frames.default_sources()
    found = report_frames.walks(sources, work, limit, bounded.limits_of(options))
    programs = host_programs.HostPrograms(build, kept.Kept(build, options.fresh))
    frames, pixels, shown = report_frames.judge_walks(programs, found, work)
    twins = report_claims.measure(programs, found[0], options.samples, options.seed, work)
    third = report_frames.cast_rays(programs, found[0], work, RAY_FRAMES)
    w1 = report_frames.walks([report_frames.SCENE], work, limit)[0].scene
    scales = report_frames.measure(programs, options.board, w1, work)
    report = {
        "samples": options.samples, "seed": options.seed, "board": options.board,
        "claims": report_claims.hold(report_claims.judge(
            shards, frames, pixels, scales, options.build,
            options.samples < report_shards.SAMPLES or bool(options.scene)), options.seed),
        "stages": [{**row, "measure": each["measure"]} for each in about["stages"]
                   for row in report_shards.merge_stage(options.build, each, shards[each["stage"]])],
        "sweeps": [row for each in about["sweeps"] for row in
                   report_shards.merge_sweep(each, shards[f"sweep:{each['parameter']}"])],
        "depths": report_shards.merge_depths(shards["vertex"]),
        "twins": twins, "frames": frames, "scales": scales, "third_judge": third}
    return report, shown


def measure_only(options):
    """A report of the claims that ONLY= names."""
    wanted = [kind for kind in report_shards.CLAIMS if kind.what in options.only]
    shards = report_shards.draw(options, wanted)
    return {"samples": options.samples, "seed": options.seed,
            "claims": report_claims.hold(report_claims.judge_only(shards, options.build, options.samples < report_shards.SAMPLES),
                                           options.seed)}


def complaints(report):
    """Everything that failed, as sentences."""
    return report_claims.complaints(report) + report_claims.complaints_of_stages(report["twins"])


def print_claims(report):
    """Their table."""
    print(table([[claim["id"], claim["bound"], float(claim["measured"]), claim["unit"],
                  claim["samples"], claim["samples_claimed"], claim["holds"]] for claim in report["claims"]],
                ["claim", "bound", "measured", "unit", "samples", "claimed for", "holds"]))


def print_verdict(report, found, files):
    """What failed, how to see it again, and which files hold the report."""
    for sentence in found:
        print(f"{coloured('FAIL', 'red')}: {sentence}")
    for claim in report["claims"]:
        if not claim["holds"] and "command" in claim:
            print(f"  again: {claim['command']}")
    short = report_claims.shortfall(report)
    if short and not found:
        print(f"the report was asked for fewer samples than the claims are about: {short}")
    word = coloured("FAIL", "red") if found else coloured("pass", "green")
    print(f"{word}: {one_line(files)}")


def print_report(report, out):
    """For people."""
    print_claims(report)
    print()
    print(table([[row["stage"], report_plots.NAMES[row["design"]], float(row["max"]),
                  float(row["mean"]), float(row["rms"]), row["unit"]] for row in report["stages"]],
                ["stage", "design", "largest", "mean", "rms", "unit"]))
    print()
    print(table([[row["stage"], row["input"], float(row["max"]), float(row["mean"]), row["unit"]]
                 for row in report["twins"]],
                ["against double", "input", "largest", "mean", "unit"]))
    third = report["third_judge"]
    print(f"\nray-cast oracle: {third['frames_judged']} frames of {third['scene']}, "
          f"{third['pixels_unexplained']:,} pixels unexplained")
    print_verdict(report, complaints(report), f"{out}/report.html, {out}/report.json")


def write_picture(options):
    """The README's picture from a report that is there."""
    file = pathlib.Path(options.out) / "report.json"
    entries = host_programs.read_json(file).get("depths", [])
    if not entries:
        raise ToolError(f"{file}: holds no errors of vertices by depth; make report writes them")
    output.write_file(options.picture, report_plots.picture_bytes(entries))
    print(one_line(options.picture))


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    options = before(options)
    if options.picture:
        write_picture(options)
        return 0
    if options.only:
        told = measure_only(options)
        output.write_json(pathlib.Path(options.out) / "claims.json", told)
        print_claims(told)
        print_verdict(told, report_claims.complaints(told), f"{options.out}/claims.json")
        return 0 if all(claim["holds"] for claim in told["claims"]) else 1
    with output.replaced_folder(options.out, PATTERNS) as folder, \
            scratch.folder("report", options.build) as work:
        told, shown = gather(options, work)
        print("writing the page", file=sys.stderr)
        output.write_json(folder / "report.json", told)
        output.write_file(folder / "report.html", report_page.render(told, shown))
    print_report(told, options.out)
    spent.tell()
    return 1 if complaints(told) else 0
