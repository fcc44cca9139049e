# SPDX-License-Identifier: MIT
"""Runs the host's programs: each ends in its result or in one ToolError."""

import json
import pathlib
import subprocess
import sys
import tempfile

from fixel.base import children, kept
from fixel.board import dump
from fixel.base.errors import ToolError


def run_program(command):
    """Standard output of a program that must end with 0.

    Its progress on stderr is passed on as it comes; its last words there make
    the error where it fails.
    """
    name = pathlib.Path(command[0]).name
    # stdout goes to a file, so that nothing waits on a full pipe while stderr is read.
    with tempfile.TemporaryFile() as out:
        try:
            process = children.start(command, stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.PIPE, text=True,
                                     errors="replace")
        except OSError as error:
            raise ToolError(f"{command[0]}: cannot be started: {error.strerror}; "
                            f"make all builds it") from error
        last = ""
        with process:
            for line in process.stderr:
                held, last = last, line.rstrip()
                if held:
                    print(held, file=sys.stderr, flush=True)
        if process.returncode:
            said = last.removeprefix("error: ") or f"ended with {process.returncode}"
            raise ToolError(said if said.startswith(name) else f"{name}: {said}")
        if last:
            print(last, file=sys.stderr, flush=True)
        out.seek(0)
        return out.read().decode(errors="replace")


class HostPrograms:
    """The programs under a build folder. store: a base.kept.Kept, which has what they gave earlier."""

    def __init__(self, build, store=None):
        self.build, self.host = pathlib.Path(build), pathlib.Path(build) / "host"
        self.kept = store or kept.Kept(build)

    def judge(self, scene, file, report, twin, options=(), names=None):
        """The judge's verdict on the dump in a file; the reference renderer's frames go to the dump twin.

        options: of the judge, such as those that name the clipper and the visibility method of the dump. names: a dump
        that gets the names of the faces that the pixels show.
        """
        program = self.host / "judge"
        more = [*options, *(["--names", names] if names else [])]
        # Boards that draw the same pictures share the double frames: not the bytes of the dump, which has what it cost too.
        self.kept.obtain(
            "double", [program, pathlib.Path(scene), dump.read_dump(file).pictures_sha256, [*options], bool(names)],
            [report, twin, *([names] if names else [])],
            lambda: run_program([program, scene, file, "--json", report, "--twin", twin, *more]))
        return read_json(report)

    def raycast(self, scene, twin, report, every=1, names=None):
        """The ray-cast oracle's verdict on the reference frames, on one of `every`. names: "all" or "opaque", where twin
        has the names of such faces."""
        program = self.host / "raycast"
        self.kept.obtain(
            "rays", [program, pathlib.Path(scene), pathlib.Path(twin), every, names], [report],
            lambda: run_program([program, scene, twin, "--json", report, "--every", str(every),
                                 *(["--names", names] if names else [])]))
        return read_json(report)

    def wire(self, scene, file, report, frames=None):
        """A scene's path as wireframes into the dump in a file; what the comparison with double found, which goes to
        the file report too."""
        program = self.host / "wire"
        self.kept.obtain("wireframes", [program, pathlib.Path(scene), frames or 0], [file, report],
                         lambda: report.write_text(run_program(
                             [program, scene, file, *(["--frames", str(frames)] if frames else [])]), encoding="utf-8"))
        return read_json(report)

    def stage_errors(self, scene, samples, seed):
        """Differences between the library and the reference renderer at every stage boundary."""
        text = run_program([self.host / "stage_errors", scene, "--samples", str(samples),
                            "--seed", str(seed)])
        try:
            return json.loads(text)["stages"]
        except (ValueError, KeyError) as error:
            raise ToolError(f"stage_errors: its output is not the JSON agreed on: {error}") from error


def read_json(path):
    """A JSON file."""
    try:
        return json.loads(pathlib.Path(path).read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise ToolError(f"{path}: cannot be read as JSON: {error}") from error
