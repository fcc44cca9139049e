# SPDX-License-Identifier: MIT
"""An estimate of cycles from counted instructions and a table of costs (bench/cycles.toml)."""

import pathlib
import tomllib

from fixel.bench import thumb
from fixel.base.errors import ToolError

TABLE = pathlib.Path(__file__).resolve().parents[3] / "bench" / "cycles.toml"
# Instructions that cost less where they are not followed, or not made.
SKIPPED = "skipped"
NEXT = "load next"      # a load right after another one
WAITING = "waiting"     # what wait states add
LEAVING = {"branch conditional", "branch exchange", "pop to pc", "load to pc"}
ALWAYS = {"branch", "table branch", *thumb.CALLS}      # taken whenever they are executed
FIGURES = ("without wait states", "at 72 MHz with two wait states")


def _read():
    """(the cores' entries, what wait states add)."""
    with TABLE.open("rb") as file:
        data = tomllib.load(file)
    return data, data.pop(WAITING)


def models(core):
    """{name: Model} of the cores that the code of one of the bench's cores can run on."""
    data, waiting = _read()
    return {name: Model(name, data, waiting) for name, entry in data.items() if core in entry["code"]}


def costs():
    """([title], {kind: [cost, one for each core]}) of the whole table; None where a core has no such kind."""
    data, waiting = _read()
    all_models = [Model(name, data, waiting) for name in data]
    kinds = [kind for kind in [*thumb.KINDS, NEXT, SKIPPED] if any(kind in model.cost for model in all_models)]
    return [model.title for model in all_models], \
        {kind: [model.cost.get(kind) for model in all_models] for kind in kinds}


def blocks(code, counts):
    """(node, address, instruction, the kind before it in its block, times executed, times left) of everything that ran."""
    for node, block, times, left in counts.visits:
        address, sizes = counts.blocks[block]
        before = None
        for place, size in enumerate(sizes):
            instruction = code.instruction(address)
            yield node, address, instruction, before, times, left if place + 1 == len(sizes) else 0
            before = instruction.kind
            address += size


class Model:
    """The costs of one core."""

    def __init__(self, name, data, waiting):
        entry = data[name]
        self.name, self.title, self.code, self.waiting = name, entry["title"], entry["code"], waiting
        self.cost = {**(data[entry["like"]]["cost"] if "like" in entry else {}), **entry["cost"]}
        for kind in self.cost:
            if kind not in (*thumb.KINDS, NEXT, SKIPPED):
                raise ToolError(f"{TABLE}: '{kind}' is no kind of instruction")

    def cycles(self, instruction, times, left, before=None):
        """Cycles (FIGURES) of an instruction that ran so many times and was left so many times for another place than
        the one behind it. before: the kind of the instruction before it."""
        kind = instruction.kind
        followed = left if kind in LEAVING else times
        still = (times - followed) * self.cost[SKIPPED] + \
            (followed * self._of(NEXT if kind == before == "load" else kind, instruction.registers) if followed else 0)
        taken = followed if kind in LEAVING | ALWAYS else 0
        return still, still + taken * self.waiting["taken"] + (times * self.waiting["literal"] if instruction.is_literal else 0)

    def total(self, code, counts):
        """Cycles (FIGURES) of all that was counted."""
        parts = [self.cycles(instruction, times, left, before)
                 for _, _, instruction, before, times, left in blocks(code, counts)]
        return tuple(map(sum, zip(*parts)))

    def _of(self, kind, registers):
        if kind not in self.cost:
            raise ToolError(f"{TABLE}: {self.name} has no cost for '{kind}'")
        cost = self.cost[kind]
        return cost[0] + registers * cost[1] if isinstance(cost, list) else cost
