# SPDX-License-Identifier: MIT
"""The claims of Fixel, and whether the measurements satisfy them.

A claim's bound says how far a pixel may be off. The record of averages (host_tests/judges/averages.json) has the means of an earlier
measurement, and a claim whose mean is larger fails. Means are compared where seed and number of samples are the record's: then the
samples are the same ones. Library and reference renderer are compared at the boundary of each stage, on the same input: the polygons
of a scene, and random input from the whole allowed range.
"""

import dataclasses
import json
import math
import pathlib

from fixel.base import output
from fixel.base.progress import Progress
from fixel.image import image
from fixel.report import report_shards

RECORD = pathlib.Path(__file__).resolve().parents[3] / "host_tests" / "judges" / "averages.json"
ROUNDING = 1e-9     # of a mean: sums of doubles on another machine
STAGES = ("sphere", "clip", "clip_world", "transform", "project", "list", "fill", "cover", "split", "light", "placement")
KEYS = ("stage", "input", "samples", "max", "mean", "unit", "measure", "bound", "beyond_bound", "mismatched")
# A stage gets one random sample for this many samples of the report.
SAMPLES_PER = 50


@dataclasses.dataclass(frozen=True)
class Claim:
    """A claim: its bound in its unit, its text, and the sentences of clauses that it measures, as a tag has them."""
    id: str
    bound: float
    unit: str
    words: str
    clause: str = ""


# place claim: bound and words
CLAIMS = (
    Claim("matrix_entry", 2, "2^-30", "An entry of the camera's matrix, against the exact value "
          "for the stated angles.", "accuracy 3.1b"),
    Claim("matrix_entry_instance", 5, "2^-30", "An entry of the matrix of a turned and scaled instance "
          "in the view, divided by the power of two not below the scale, against the exact value for the "
          "camera's and the instance's angles.", "accuracy 3.1c"),
    Claim("orientation_angles", 4, "2^-30", "An entry of an orientation made of three angles, against the exact value.", "accuracy 3.1d"),
    Claim("orientation_axis", 4, "2^-30", "An entry of an orientation made of an axis and an angle, against the exact "
          "value.", "accuracy 3.1d"),
    Claim("orientation_look_at", 4, "2^-30", "An entry of an orientation that looks along a direction, against the "
          "exact value.", "accuracy 3.1d"),
    Claim("orientation_product", 0.501, "2^-30", "An entry of a product of two orientations, against the rotation "
          "that is nearest to the exact product.", "accuracy 3.1e"),
    Claim("orientation_quaternion", 0.501, "2^-30", "An entry of an orientation made of a quaternion of any norm, against the exact "
          "rotation.", "accuracy 3.1v"),
    Claim("quaternion", 2, "2^-30", "A number of a quaternion made of an orientation, against that of the rotation that is nearest "
          "to the rows.", "accuracy 3.1w"),
    Claim("orientation_parents", 1, "of its bound", "The centre, the scale and the orientation of an instance with up "
          "to eight parents, against the exact ones, by the bounds for its depth.", "accuracy 3.1f"),
    Claim("sine_cosine", 0.51, "2^-30", "A sine or cosine, against the exact one.", "accuracy 3.1g, accuracy 1.1b"),
    Claim("vertex_unclipped", 0.55, "1/65536 pixel", "The place of an unclipped vertex on the screen, "
          "against the exact place, given its coordinates, the camera's position and matrix.", "accuracy 3.1h"),
    Claim("vertex_turned", 1, "of its bound", "A vertex of a turned and scaled instance in the view, against the exact "
          "product of the camera's rows, the orientation and the scale as given, by the bound of the matrix's rounding. "
          "Half of the orientations have rows at a corner of the tolerance.", "accuracy 3.1i"),
    Claim("outline_clipped", 1.25, "1/65536 pixel", "The outline of a polygon clipped to all six planes: "
          "distance to the exact outline, and back. Except polygons nearly parallel to a plane.", "accuracy 3.1j, accuracy 1.1q"),
    Claim("coverage", 0, "pixels", "Pixels that are covered wrongly, or wrongly not covered, given the "
          "vertices on the screen.", "accuracy 3.1k, accuracy 1.1t"),
    Claim("watertight", 0, "pixels", "Gaps between two polygons that share an edge, and pixels that "
          "both draw, clipped or not. Except pieces thinner than 1/65536 pixel that rounding "
          "turned over.", "accuracy 3.1l"),
    Claim("texel_divided", 1 / 256, "texel", "The texel that a pixel shows, divided at each pixel: how far it is "
          "from the exact texture coordinates, given corners and matrix.", "accuracy 3.1m"),
    Claim("texel_every_16", 0.33, "texel", "The same, divided every 16 columns or more often.", "accuracy 3.1n"),
    Claim("texel_every_8", 0.1, "texel", "The same, divided every 8 columns or more often.", "accuracy 3.1o"),
    Claim("texel_affine", 0.04, "texel", "The texel that a pixel shows without perspective: how far it is from the exact "
          "affine function of the three corners' points on the screen.", "accuracy 3.1p"),
    Claim("light_level", 1 / 256, "level", "The level of light that a pixel of a lit surface shows: how far it is from "
          "the exact light, given the lights, the corners and their normals.", "accuracy 3.1q"),
    Claim("corner_colour", 0.34, "level", "The red, green and blue that a pixel of 16 bits shows of a face with colours at its "
          "corners, divided every 16 columns or more often: how far they are from the exact ones.", "accuracy 3.1r"),
    Claim("depth_16", 1, "of its bound", "The face that a pixel shows with a depth buffer of 16 bits, of two that cover it: "
          "how much farther it is than the other, by the resolution of SPEC.md, section 10.6.", "accuracy 3.1s, SPEC 10.6b"),
    Claim("depth_32", 1, "of its bound", "The same with 32 bits.", "accuracy 3.1s, SPEC 10.6b"),
    Claim("horizon", 1, "2^-20", "The level of a horizon that a pixel shows, where it is not that of its ray: how far the sine of the ray's "
          "elevation is from the sine between, given the camera's rows. The horizon itself is exact.", "accuracy 3.1x, horizon 1.3a, horizon 1.3b"),
    Claim("orthographic_vertex", 0.5, "1/65536 pixel", "The place of a vertex on the screen with an orthographic lens, against the exact place, "
          "given its coordinates, the pose's position, and the camera's rows.", "accuracy 3.1y, orthographic 2.6a"),
    Claim("orthographic_texel", 0.04, "texel", "The texel that a pixel shows with an orthographic lens: how far it is from the exact affine function "
          "of the three corners' places.", "accuracy 3.1z, orthographic 2.10a"),
    Claim("orthographic_depth", 1, "of its bound", "The face that a pixel shows with an orthographic lens and a depth buffer of 16 bits, of two that "
          "cover it: how much farther it is than the other, by the resolution.", "accuracy 3.1aa, orthographic 2.11b"),
    Claim("frame", 1, "in 100,000 pixels", "Pixels of whole frames that differ from the reference "
          "renderer in double. Each must lie within 1/8192 pixel of an edge.", "accuracy 3.1t"),
    Claim("scale", 1, "in 100,000 pixels", "Pixels that change when W1 is scaled by 4, 16 or 64, with "
          "its camera. Instructions must stay within 10 %.", "accuracy 3.1u"),
)
# Samples that a claim is about; on fewer samples it does not hold (docs/accuracy.md, section 3).
FEWEST = {**{kind.what: kind.samples(report_shards.SAMPLES) for kind in report_shards.CLAIMS},
          "frame": 500, "scale": 4}
INSTRUCTIONS_PERCENT = 10
PER = 100_000


def _claim(claim, measured, samples, holds=True, **more):
    return {"id": claim.id, "bound": claim.bound, "measured": measured, "unit": claim.unit,
            "samples": samples, "holds": bool(measured <= claim.bound and holds), **more}


def _oracle_claim(claim, tally, build):
    return _claim(claim, tally["max"], tally["samples"], mean=tally["mean"], rms=tally["rms"],
                  worst_input=tally["worst_input"], histogram=tally["histogram"],
                  command=f"{build}/host/oracle {claim.id} --input \"{tally['worst_input']}\"")


def _frame_claim(claim, frames, pixels):
    differing = sum(frame["pixels_differing"] for frame in frames)
    unexplained = sum(frame["pixels_unexplained"] for frame in frames)
    tied = [frame["pixels_tied"] for frame in frames]   # null where the judge does not tell
    distances = [frame["max_edge_distance_px"] for frame in frames
                 if frame["max_edge_distance_px"] is not None]
    return _claim(claim, PER * differing / pixels, len(frames), unexplained == 0, pixels=pixels,
                  pixels_differing=differing, pixels_unexplained=unexplained,
                  pixels_tied=None if None in tied else sum(tied),
                  max_edge_distance_px=max(distances, default=None))


def _scale_claim(claim, rows):
    percent = max(row["instructions_percent"] for row in rows)
    return _claim(claim, max(PER * row["pixels_differing"] / row["pixels"] for row in rows),
                  sum(row["frames"] for row in rows), percent <= INSTRUCTIONS_PERCENT,
                  instructions_percent=percent, instructions_bound_percent=INSTRUCTIONS_PERCENT)


# accuracy 3.1
def judge(shards, frames, pixels, scales, build, fewer_asked):
    """claims[] of the report, in the order of the table. fewer_asked: the caller asked for fewer samples than the
    claims are about; otherwise a claim with too few samples fails."""
    found = []
    for claim in CLAIMS:
        if claim.id == "frame":
            found.append(_frame_claim(claim, frames, pixels))
        elif claim.id == "scale":
            found.append(_scale_claim(claim, scales))
        else:
            found.append(_oracle_claim(claim, report_shards.merge(shards[claim.id]), build))
    return _hold_to_samples(found, fewer_asked)


def judge_only(shards, build, fewer_asked):
    """claims[] of those claims alone that there are shards of."""
    return _hold_to_samples([_oracle_claim(claim, report_shards.merge(shards[claim.id]), build)
                             for claim in CLAIMS if claim.id in shards], fewer_asked)


def _hold_to_samples(found, fewer_asked):
    for each in found:
        each["samples_claimed"] = FEWEST[each["id"]]
        each["holds"] = each["holds"] and each["samples"] > 0 and (fewer_asked or not is_short(each))
    return found


def is_short(claim):
    """Whether there are fewer samples than the claim is about."""
    return claim["samples"] < claim["samples_claimed"]


def shortfall(report):
    """The claims with fewer samples than they are about, as text; "" if there are none."""
    return ", ".join(f"{claim['id']} {claim['samples']:,} of {claim['samples_claimed']:,}"
                     for claim in report["claims"] if is_short(claim))


def complaints(report):
    """What failed, as sentences."""
    found = [f"{claim['id']}: the bound is {claim['bound']:g}, the measured value is {claim['measured']:,.6g} "
             f"({claim['unit']}){_why(claim)}"
             for claim in report["claims"] if not claim["holds"]]
    third = report.get("third_judge")
    if third and third["pixels_unexplained"]:
        found.append(f"the ray-cast oracle disagrees with the reference renderer on {third['pixels_unexplained']:,} pixels "
                     f"of {third['scene']}")
    return found


def _why(claim):
    """The reason why a claim fails that is not its bound."""
    if is_short(claim):
        return f"; {claim['samples']:,} samples are fewer than the {claim['samples_claimed']:,} that it is about"
    if claim.get("mean", 0) > claim.get("mean_most", math.inf):
        return f"; the mean is {claim['mean']:.6g}, and the record's is {claim['mean_most']:.6g}"
    if claim.get("pixels_unexplained"):
        return f"; {claim['pixels_unexplained']:,} pixels are unexplained"
    if claim.get("instructions_percent", 0) > INSTRUCTIONS_PERCENT:
        return f"; instructions change by {claim['instructions_percent']:.1f} %"
    return ""


def record():
    """{seed, claims: {id: {samples, mean}}, scenes: what host_tests/judges/test_averages.py measures}."""
    return json.loads(RECORD.read_text(encoding="utf-8"))


# accuracy 3.5
def hold(claims, seed):
    """The same claims; those that the record has get "mean_most", and fail where their mean is larger."""
    known = record()
    for claim in claims:
        entry = known["claims"].get(claim["id"])
        if entry and (seed, claim["samples"]) == (known["seed"], entry["samples"]):
            claim["mean_most"] = entry["mean"]
            claim["holds"] = claim["holds"] and claim["mean"] <= entry["mean"] * (1 + ROUNDING)
    return claims


def measure(programs, walk, samples, seed, folder):
    """A row for each stage and input."""
    file = folder / "twins.fxls"
    output.write_file(file, image.pack(walk.scene))
    count = max(1000, samples // SAMPLES_PER)
    with Progress(f"stages against double: {walk.name} and {count:,} random samples each"):
        rows = programs.stage_errors(file, count, seed)
    order = {name: place for place, name in enumerate(STAGES)}
    rows.sort(key=lambda row: (order.get(row["stage"], len(order)), row["input"] != "scene"))
    # No row without samples: a scene without beams has none for light, an unclipped scene none for clip.
    return [{key: row[key] for key in KEYS} for row in rows if row["samples"] > 0]


def complaints_of_stages(rows):
    """What exceeded its bound, as sentences."""
    measured = {row["stage"] for row in rows if row["input"] == "random"}
    return [f"{stage}: no random sample was compared with double" for stage in STAGES if stage not in measured] + \
           [f"{row['stage']} on {row['input']} input: {row['beyond_bound'] + row['mismatched']:,} of "
            f"{row['samples']:,} samples exceed the bound ({row['bound']})"
            for row in rows if row["beyond_bound"] or row["mismatched"]]
