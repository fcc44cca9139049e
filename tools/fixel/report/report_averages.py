# SPDX-License-Identifier: MIT
"""How far textured, lit and depth-tested pixels are off on average, against a record (host_tests/judges/averages.json).

A claim's bound says how far a pixel may be off. The record has the means of an earlier measurement, and a claim whose mean is
larger fails. Means are compared where seed and number of samples are the record's: then the samples are the same ones.
"""

import json
import pathlib

RECORD = pathlib.Path(__file__).resolve().parents[3] / "host_tests" / "judges" / "averages.json"
ROUNDING = 1e-9     # of a mean: sums of doubles on another machine


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
