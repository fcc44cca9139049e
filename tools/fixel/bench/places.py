# SPDX-License-Identifier: MIT
"""From the counts of every place to functions, lines, and stacks of calls."""

import collections
import dataclasses
import fnmatch
import pathlib
import re
import tomllib

from fixel.bench import cycles, thumb

# Groups of kinds, for people.
GROUPS = {"multiply": ("multiply", "multiply add"),
          "long multiply": ("long multiply", "long multiply add"), "divide": ("divide",),
          "load": ("load", "load multiple", "load to pc", "float load", "float load multiple"),
          "store": ("store", "store multiple", "float store", "float store multiple"),
          "branch": ("branch", "branch conditional", "branch exchange", "table branch", "call",
                     "call register", "pop to pc"),
          "float": ("float", "float multiply add", "float divide", "float root"), "vector": ("vector",)}
GROUP_OF = {kind: group for group, kinds in GROUPS.items() for kind in kinds}
INLINED = "(inlined)"
# A kernel in assembly has its core in its name, and the stage of the portable one.
CORES = re.compile(r"_(?:armv6m|armv7m|mve|portable)$")
LIBRARY, PUBLIC = map(pathlib.PurePath, ("lib", "lib/include"))
OTHERS = "beside the library"
STAGES = pathlib.Path(__file__).resolve().parents[3] / "bench" / "stages.toml"
BEFORE_RETURN = 2   # bytes: an address within the call


def stem_of(file):
    """The name of a source file of the library, without a core."""
    return CORES.sub("", pathlib.PurePath(file).stem)


@dataclasses.dataclass
class Sum:
    """Instructions, and estimated cycles {model: one for each of cycles.FIGURES}."""
    instructions: int = 0
    cycles: dict = dataclasses.field(default_factory=dict)

    def add(self, times, cycles):
        self.instructions += times
        for name, figures in cycles.items():
            self.cycles[name] = [old + new for old, new in zip(self.cycles.get(name, [0] * len(figures)), figures)]


class Stages:
    """The stages of the pipeline (bench/stages.toml)."""

    def __init__(self, path=STAGES):
        with open(path, "rb") as file:
            data = tomllib.load(file)
        entries = data["stages"]
        self.shared = set(data["shared"])
        self.what = {entry["name"]: entry["what"] for entry in entries}
        self.parts = {entry["name"]: entry["part"] for entry in entries}
        self.of_function = {name: entry["name"] for entry in entries for name in entry["functions"]}
        named = {stem: entry["name"] for entry in entries for stem in entry["files"]}
        self._of_files = sorted(named.items(), key=lambda each: "*" in each[0])     # names come before patterns

    def of_file(self, stem):
        """The stage of a source file; None if no stage names it."""
        return next((stage for pattern, stage in self._of_files if fnmatch.fnmatchcase(stem, pattern)), None)

    def part_of(self, stage):
        """The part of a frame that a stage belongs to: what is beside the library prepares the first one."""
        return self.parts.get(stage, next(iter(self.parts.values())))

    def of(self, names, files):
        """The stage of a stack of functions, innermost first; no more of them are asked for than decide. files: {function: its file}."""
        innermost = None
        for name in names:
            file = pathlib.PurePath(files.get(name, ""))
            stem = stem_of(file)
            if file.suffix == ".h" or stem in self.shared or LIBRARY not in file.parents or PUBLIC in file.parents:
                continue
            if innermost not in (None, stem):
                break
            innermost = stem
            if name in self.of_function:
                return self.of_function[name]
        return OTHERS if innermost is None else self.of_file(innermost) or innermost


class Profile:
    """What each function, line and stack took, over all frames together.

    own[name], inclusive[name]: itself, and with all that it calls; inlined[name]: how much of own was
    inlined into others; entered[name]: how often its first instruction ran. stacks[(names...)]: Sum. by_stage[name]: Sum of a stage of the
    pipeline; stages[name], staged[stage, name]: instructions of it, and of a function there.
    """

    def __init__(self, code, counts, lines, models, stages=None, is_whole=True):
        """is_whole: False finds by_stage and the total alone, in a tenth of the time."""
        self.total, self.is_whole = Sum(), is_whole
        self.groups = collections.Counter()
        self.taken = collections.Counter()
        self.own, self.inclusive = collections.defaultdict(Sum), collections.defaultdict(Sum)
        self.inlined, self.lines = collections.Counter(), collections.defaultdict(Sum)
        self.stacks, self.by_stage = collections.defaultdict(Sum), collections.defaultdict(Sum)
        self.staged = collections.Counter()
        self.pipeline = stages or Stages()
        self.code, self.debug, self.models = code, lines, models
        self.scopes, self.stage_of = {}, {}
        self.starts = {function.start for function in code.functions}
        self.entered = collections.Counter()
        for function in code.functions:
            lines.file_of(function.name, function.start)
        self.nodes = self._nodes(counts)
        paths = self._paths() if is_whole else {}
        for node, *executed in cycles.blocks(code, counts):
            self._add(node, paths.get(node), *executed)
        self.stages = collections.Counter({stage: each.instructions for stage, each in self.by_stage.items()})

    def _nodes(self, counts):
        """{node: (its parent, names that it adds to those of that one)}: functions, and what was inlined about each call."""
        nodes = {}
        for node, (parent, function, back) in counts.nodes.items():
            about = self._inlined_at(back - BEFORE_RETURN) if back else ()
            known = function < len(self.code.functions)
            nodes[node] = parent, (*about, self.code.functions[function].name if known else "?")
        return nodes

    def _paths(self):
        """{node: names from the root inward}."""
        paths = {0: ()}
        for node, (parent, names) in self.nodes.items():
            paths[node] = (*paths[parent], *names)
        return paths

    def _outward(self, node, inlined):
        """Names of functions from the innermost one to the root: a stack may be as deep as the emulator saw calls without a return."""
        yield from (name.removesuffix(f" {INLINED}") for name in reversed(inlined))
        while node:
            node, names = self.nodes[node]
            yield from (name.removesuffix(f" {INLINED}") for name in reversed(names))

    def _inlined_at(self, address):
        if address not in self.scopes:
            self.scopes[address] = tuple(f"{name} {INLINED}" for name in self.debug.inlined(address))
        return self.scopes[address]

    def _add(self, node, path, address, instruction, before, times, left):
        taken = {name: model.cycles(instruction, times, left, before) for name, model in self.models.items()}
        inlined = self._inlined_at(address)
        self.total.add(times, taken)
        stage = self._stage(node, inlined)
        self.by_stage[stage].add(times, taken)
        if self.is_whole:
            self._add_place(path, path + inlined, stage, address, instruction, times, left, taken)

    def _stage(self, node, inlined):
        if (node, inlined) not in self.stage_of:
            self.stage_of[node, inlined] = self.pipeline.of(self._outward(node, inlined), self.debug.files)
        return self.stage_of[node, inlined]

    def _add_place(self, path, stack, stage, address, instruction, times, left, taken):
        self.groups[GROUP_OF.get(instruction.kind, "other")] += times
        if instruction.kind == "branch conditional":
            self.taken["taken"] += left
            self.taken["not taken"] += times - left
        self.stacks[stack].add(times, taken)
        names = [name.removesuffix(f" {INLINED}") for name in stack]
        self.own[names[-1]].add(times, taken)
        if address in self.starts:
            self.entered[path[-1]] += times
        if stack[-1].endswith(INLINED):
            self.inlined[names[-1]] += times
        self.staged[stage, names[-1]] += times
        for name in set(names):
            self.inclusive[name].add(times, taken)
        line = self.debug.line(address)
        self.lines[line or f"{path[-1]} (no source)"].add(times, taken)


def in_order(pipeline, names):
    """Names of stages in the order of the pipeline, strange ones last."""
    known = list(pipeline.what)
    return sorted(names, key=lambda name: (known.index(name) if name in known else len(known), name))


def as_json(profile, frames):
    """Plain data, the largest first; numbers are of all frames together."""
    def rows(sums, key):
        ordered = sorted(sums.items(), key=lambda item: (-item[1].instructions, item[0]))
        return [{key: name, "instructions": each.instructions, "cycles_estimate": each.cycles}
                for name, each in ordered]
    functions = rows(profile.own, "function")
    for row in functions:
        row["inclusive"] = profile.inclusive[row["function"]].instructions
        row["inlined"] = profile.inlined[row["function"]]
        row["entered"] = profile.entered[row["function"]]
    for name in profile.inclusive.keys() - profile.own.keys():
        functions.append({"function": name, "instructions": 0, "cycles_estimate": {},
                          "inclusive": profile.inclusive[name].instructions, "inlined": 0,
                          "entered": profile.entered[name]})
    return {"frames": frames, "instructions": profile.total.instructions,
            "cycles_estimate": profile.total.cycles,
            "kinds": {group: profile.groups[group] for group in [*GROUPS, "other"]},
            "stages": [{"stage": name, "instructions": profile.stages[name]}
                       for name in in_order(profile.pipeline, profile.stages)],
            "branches_conditional": {"taken": profile.taken["taken"],
                                     "not_taken": profile.taken["not taken"]},
            "functions": functions, "lines": rows(profile.lines, "line")}


assert all(kind in thumb.KINDS for kind in GROUP_OF)
