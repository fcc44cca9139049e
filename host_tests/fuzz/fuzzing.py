# SPDX-License-Identifier: MIT
"""Tests by random input with a fixed seed. FUZZ_EXAMPLES (make fuzz) asks for more examples, FUZZ_SEED for others."""

import collections
import contextlib
import os

from hypothesis import HealthCheck, seed, settings

from fixel.base.errors import ToolError

EXAMPLES = int(os.environ.get("FUZZ_EXAMPLES", "150"))
FIXED_SEED = 13
SEED = int(os.environ.get("FUZZ_SEED", FIXED_SEED))
FEW = 1000              # examples of any seed, below which their share of sound ones says nothing
MESSAGE_MAX = 600       # characters: two quotes, the known keys, the file's name

taken = collections.Counter()   # what became of the inputs of a test


def fuzzed(least):
    """A test with a fixed number of examples by a fixed seed. least: the share of them that must be sound, or what
    comes behind the checks is not tried: about two thirds of the share of any seed. A few examples of another seed than
    the fixed one may have any share."""
    quiet = [HealthCheck.too_slow, HealthCheck.data_too_large, HealthCheck.filter_too_much]

    def of(test):
        run = seed(SEED)(settings(max_examples=EXAMPLES, deadline=None, database=None, derandomize=False,
                                  suppress_health_check=quiet)(test))

        def whole():
            taken.clear()
            run()
            if SEED == FIXED_SEED or EXAMPLES >= FEW:
                assert taken["sound"] >= least * taken.total(), taken

        whole.__name__ = test.__name__
        return whole

    return of


def assert_short(text, folder):
    """A message is a line that quotes little of the input, escaped. folder: the test's own."""
    text = text.replace(folder, "")
    assert 0 < len(text) <= MESSAGE_MAX and text.isprintable(), text


@contextlib.contextmanager
def short_refusals(folder):
    """What is done within ends well, or in one ToolError with a short message. Yields a list for its notes, which are
    short too."""
    notes = []
    try:
        yield notes
        taken["sound"] += 1
    except ToolError as error:
        taken["refused"] += 1
        assert_short(str(error), folder)
    for note in notes:
        assert_short(note, folder)
