# SPDX-License-Identifier: MIT
"""An estimate of cycles from counted instructions and a table of costs (bench/cycles.toml)."""

import pathlib
import tomllib

from fixel.bench import thumb
from fixel.base.errors import ToolError

TABLE = pathlib.Path(__file__).resolve().parents[3] / "bench" / "cycles.toml"
# Instructions that cost less where they are not followed, or not made.
SKIPPED = "skipped"
LEAVING = {"branch conditional", "branch exchange", "pop to pc", "load to pc"}


def models(core):
    """{name: Model} of the cores that the code of one of the bench's cores can run on."""
    with TABLE.open("rb") as file:
        data = tomllib.load(file)
    return {name: Model(name, data) for name, entry in data.items() if core in entry["code"]}


def costs():
    """([title], {kind: [cost, one for each core]}) of the whole table; None where a core has no such kind."""
    with TABLE.open("rb") as file:
        data = tomllib.load(file)
    all_models = [Model(name, data) for name in data]
    kinds = [kind for kind in [*thumb.KINDS, SKIPPED] if any(kind in model.cost for model in all_models)]
    return [model.title for model in all_models], \
        {kind: [model.cost.get(kind) for model in all_models] for kind in kinds}


class Model:
    """The costs of one core."""

    def __init__(self, name, data):
        entry = data[name]
        self.name, self.title, self.code = name, entry["title"], entry["code"]
        self.cost = {**(data[entry["like"]]["cost"] if "like" in entry else {}), **entry["cost"]}
        for kind in self.cost:
            if kind not in thumb.KINDS and kind != SKIPPED:
                raise ToolError(f"{TABLE}: '{kind}' is no kind of instruction")

    def cycles(self, instruction, times, left):
        """(least, most) cycles of an instruction that ran so many times and was left so many times
        for another place than the one behind it."""
        kind = instruction.kind
        followed = left if kind in LEAVING else times
        least, most = self._of(kind, instruction.registers) if followed else (0, 0)
        skipped_least, skipped_most = self.cost[SKIPPED]
        skipped = times - followed
        return followed * least + skipped * skipped_least, followed * most + skipped * skipped_most

    def _of(self, kind, registers):
        if kind not in self.cost:
            raise ToolError(f"{TABLE}: {self.name} has no cost for '{kind}'")
        least, most, *each = self.cost[kind]
        more = registers * each[0] if each else 0
        return least + more, most + more
