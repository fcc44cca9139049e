# SPDX-License-Identifier: MIT
"""Kills run, flash, boot, view and report at random moments, and looks at what they leave.

After each kill another command runs. Then there must be no process and no file of theirs, and every result must be
whole, the old one or the new one. The commands work in a folder of their own: build/ (links to what make built), tmp/ (TMPDIR),
out/ (results). Their processes, and all that those start, are known by a word in their environment. Exit: 0 so it was, 1 not.
"""

import argparse
import dataclasses
import json
import os
import pathlib
import random
import secrets
import signal
import subprocess
import sys
import time

from fixel.base import children, interpreter, limits, output, scratch
from fixel.base.arguments import whole_number
from fixel.base.errors import ToolError
from fixel.base.progress import Progress
from fixel.base.table import coloured, table
from fixel.commands import late

dump = late("fixel.board", "dump")
Image = late("PIL.Image")
making = late("fixel.scene", "making")

KILLS_MAX = 1_000_000

COMMANDS = ("run", "flash", "boot", "view", "view-stream", "report")
SCENE = "scenes/tiny.toml"
MARK = "FIXEL_KILLS"            # in the environment of all that is started
HEEDING = ("env", "--default-signal=HUP,INT,TERM")  # nohup, and a shell in the background, have some ignored
SIGNALS = (signal.SIGKILL, signal.SIGTERM, signal.SIGHUP, signal.SIGINT)
AFTER_END = 1.1                 # of a command's own time: some signals come when it has ended
VIEWED = 1.5                    # of the time until a window is live
AT_CHILD, CHILD_WITHIN = 0.5, 0.5   # share of the kills that come after a child has begun, and within how many seconds
AGAIN, AGAIN_WITHIN = 0.25, 0.2 # share of the kills that SIGKILL follows, and within how many seconds
GONE_WITHIN = 60.0              # seconds for the kernel to end what it has killed
STUCK = 120.0                   # seconds of CPU time, or of sleep, for a command to end
FRAMES = {"old": 2, "new": 3}   # of the two scenes


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--kills", default="200", help="how many (KILLS=)")
    made.add_argument("--seed", default="1", help="of what is killed, by which signal, and when (SEED=)")
    made.add_argument("--commands", nargs="+", default=list(COMMANDS), choices=COMMANDS)
    made.add_argument("--board", required=True, help="an emulated board")
    made.add_argument("--streaming", required=True, help="one that streams its frames to the live window")
    made.add_argument("--samples", default="1000", help="of a report")
    made.add_argument("--build", default="build", help="folder that make builds in")
    return made


def before(options):
    """The options, as the command needs them."""
    options.kills = whole_number("KILLS", options.kills, 1, KILLS_MAX)
    options.seed = whole_number("SEED", options.seed, 0, 2 ** 64 - 1)
    return options


def make_campaign(options, folder):
    scenes = {}
    for name, frames in FRAMES.items():
        scenes[name] = folder / f"{name}.fxls"
        making.build(SCENE, str(scenes[name]), frames)
    with Progress("running each command undisturbed"):
        campaign = Campaign(folder, options.build, scenes, options.samples, options.board,
                                          options.streaming)
        campaign.prepare(options.commands)
    return campaign


def carry_out(options, campaign):
    """All kills; one that leaves something is told at once."""
    choose, kills = random.Random(options.seed), []
    with Progress("kills", options.kills) as progress:
        for number in range(options.kills):
            kills.append(campaign.kill(options.commands[number % len(options.commands)], choose))
            for sentence in kills[-1].complaints:
                print(f"kill {number}, {kills[-1].command} by {kills[-1].signal.name} after {kills[-1].seconds:.2f} s"
                      f"{' with a child' if kills[-1].at_child else ''}: {sentence}", file=sys.stderr, flush=True)
            progress(len(kills))
    return kills


def print_kills(kills, commands):
    rows = [[command, *(sum(kill.command == command and kill.signal == each for kill in kills)
                        for each in SIGNALS),
             sum(kill.command == command and kill.early for kill in kills),
             sum(kill.command == command and bool(kill.complaints) for kill in kills)] for command in commands]
    print(table(rows, ["kills of", *(each.name for each in SIGNALS), "at work", "left something"]))
    bad = sum(bool(kill.complaints) for kill in kills)
    print(f"{coloured('FAIL', 'red') if bad else coloured('pass', 'green')}: {len(kills) - bad} of {len(kills)} kills "
          "left no process, no file and nothing half-written")
    return bad


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    options = before(options)
    # A shell ignores it for what it starts in the background, and so would the commands.
    if signal.getsignal(signal.SIGINT) == signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)
    output.make_folder(options.build)
    with scratch.folder("kills", options.build) as folder:
        kills = carry_out(options, make_campaign(options, folder))
    return 1 if print_kills(kills, options.commands) else 0


@dataclasses.dataclass
class Kill:
    """What was done to a command. seconds: since its start, or, at_child, since it had a child. again: SIGKILL
    followed. early: it was still at work."""
    command: str
    signal: signal.Signals
    seconds: float
    at_child: bool
    again: bool
    early: bool = False
    complaints: list = dataclasses.field(default_factory=list)


class Campaign:
    """Commands, and what they print and write undisturbed. scenes: {"old", "new": scene image}. board: of all
    commands but view-stream, whose board is streaming."""

    def __init__(self, folder, build, scenes, samples, board, streaming):
        self.folder, self.scenes, self.board, self.streaming = pathlib.Path(folder), scenes, board, streaming
        self.word = secrets.token_hex(8)
        for name in ("build", "tmp", "out"):
            (self.folder / name).mkdir()
        for name in ("boards", "host"):
            (self.folder / "build" / name).symlink_to(pathlib.Path(build).resolve() / name)
        self.log = self.folder / "log.txt"
        kept = {name: value for name, value in os.environ.items()
                if name not in ("MAKEFLAGS", "MFLAGS", "MAKELEVEL", "MAKEOVERRIDES")}
        self.environment = {**kept, "FIXEL_KEPT": "no", "TMPDIR": str(self.folder / "tmp"), MARK: self.word}
        self.samples = samples
        self.images, self.frames, self.times = {}, {}, {}

    # --- the commands -----------------------------------------------------------------

    def words(self, command, scene="new"):
        """A command as it is typed."""
        build, out = self.folder / "build", self.folder / "out"
        elf, image = build / "boards" / self.board / "walk.elf", out / "flash" / "board.bin"
        return [*interpreter.command(command.split("-")[0]), *{
            "run": ["--board", self.board, "--scene", self.scenes[scene], "--out", out / "run", "--build", build],
            "flash": ["--board", self.board, "--elf", elf, "--scene", self.scenes[scene], "--image", image],
            "boot": ["--board", self.board, "--elf", elf, "--image", self.folder / "boot.bin", "--dump",
                     out / "boot" / "board.fxld"],
            "view": ["--board", self.board, "--scene", self.scenes[scene], "--build", build],
            "view-stream": ["--board", self.streaming, "--scene", self.scenes[scene], "--build", build],
            "report": ["--board", self.board, "--scene", self.scenes[scene], "--samples", self.samples, "--out",
                       out / "report", "--build", build],
            "info": [self.scenes[scene]]}[command]]

    def start(self, command, scene="new"):
        with self.log.open("wb") as log:
            return children.start([*HEEDING, *self.words(command, scene)], stdin=subprocess.DEVNULL, stdout=log,
                                  stderr=subprocess.STDOUT, env=self.environment)

    def wait(self, command, process, wanted=lambda: False):
        """Until a command ends, or wanted() is true."""
        watch = limits.Watch(process.pid, STUCK, STUCK)
        while process.poll() is None and not wanted():
            passed = watch.check()
            if passed:
                raise ToolError(f"{command} does not end: {passed}", exit_code=1, words=self.said())
            time.sleep(0.01)

    def said(self):
        return self.log.read_text(encoding="utf-8", errors="replace").strip()

    def measure(self, command):
        """How long a command takes, undisturbed; what it writes is what it must write ever after."""
        begun = time.monotonic()
        process = self.start(command)
        is_live = "(Ctrl-C ends it)"
        self.wait(command, process, lambda: command.startswith("view") and is_live in self.said())
        self.times[command] = time.monotonic() - begun
        if process.poll() is None:
            process.terminate()
        elif process.returncode:
            raise ToolError(f"{command} fails without a kill", exit_code=1, words=self.said())
        process.wait()

    def prepare(self, commands):
        """The flash images and frames of both scenes, and the time of each command."""
        for name in FRAMES:
            for command in ("flash", "run"):
                process = self.start(command, name)
                self.wait(command, process)
                if process.returncode:
                    raise ToolError(f"{command} fails without a kill", exit_code=1, words=self.said())
            self.images[name] = (self.folder / "out" / "flash" / "board.bin").read_bytes()
            self.frames[name] = hashes(self.folder / "out" / "run" / "board.fxld")
        (self.folder / "boot.bin").write_bytes(self.images["new"])
        for command in commands:
            self.measure(command)

    # --- a kill ---------------------------------------------------------------------------

    def kill(self, command, choose):
        """Kills a command once, and looks at what is left after the next one. choose: a random.Random."""
        at_child, times = choose.random() < AT_CHILD, VIEWED if command.startswith("view") else AFTER_END
        latest = CHILD_WITHIN if at_child else times * self.times[command]
        done = Kill(command, choose.choice(SIGNALS), choose.uniform(0, latest), at_child, choose.random() < AGAIN)
        later = choose.uniform(0, AGAIN_WITHIN)
        process = self.start(command, choose.choice(list(FRAMES)))
        if at_child:
            self.wait(command, process, lambda: len(self.marked()) > 1)
        time.sleep(done.seconds)
        done.early = process.poll() is None
        process.send_signal(done.signal)
        if done.again:
            time.sleep(later)
            process.kill()
        self.wait(command, process)
        if is_traceback(self.said()):
            done.complaints.append(f"it says: {self.said()}")
        self.wait("info", self.start("info"))
        done.complaints += self.left()
        for number in self.marked():    # told once, and no matter for the next kill
            os.kill(number, signal.SIGKILL)
        return done

    def left(self):
        """What is left, as sentences, and what is there without being whole."""
        found = [f"process {number} still runs: {command}" for number, command in self.processes().items()]
        found += [f"{path.relative_to(self.folder)} is left" for path in self.strangers()]
        inside = os.fsencode(self.folder) + b"/"
        found += [f"{path} is left" for path in scratch.JOURNALS.glob("*-*")
                  if inside in content(path) and not path.name.startswith(f"{os.getpid()}-")]
        return found + self.halves()

    def marked(self):
        """{number: command} of what runs of all that was started."""
        return marked(f"{MARK}={self.word}")

    def processes(self):
        """The same, after what was killed has ended."""
        until = time.monotonic() + GONE_WITHIN
        while (found := self.marked()) and time.monotonic() < until:
            time.sleep(0.02)
        return found

    def strangers(self):
        """Files and folders that are no result."""
        expected = {"build/boards", "build/host", "out/run", "out/flash", "out/flash/board.bin", "out/boot",
                    "out/boot/board.fxld", "out/report", "out/report/report.json", "out/report/report.html",
                    "build/campaigns", "build/campaigns/report.json"}
        every = [path for name in ("build", "tmp", "out") for path in (self.folder / name).rglob("*")]
        return [path for path in every if str(path.relative_to(self.folder)) not in expected
                and not (path.parent == self.folder / "out" / "run" and not path.name.startswith("."))]

    def halves(self):
        """Results that pass for whole ones and are none, as sentences."""
        out, found = self.folder / "out", []
        for name, check in (("flash/board.bin", self.check_flash), ("boot/board.fxld", self.check_boot),
                            ("run/summary.json", self.check_run), ("report/report.json", self.check_report)):
            try:
                if (out / name).exists() and not check(out / name):
                    found.append(f"out/{name} is not what the command writes")
            except (ToolError, OSError, ValueError, KeyError) as error:
                found.append(f"out/{name} is not whole: {error}")
        return found

    def check_flash(self, file):
        return file.read_bytes() in self.images.values()

    def check_boot(self, file):
        return hashes(file) == self.frames["new"]

    def check_run(self, file):
        folder, summary = file.parent, json.loads(file.read_text(encoding="utf-8"))
        frames = hashes(folder / "board.fxld")
        pictures = sorted(folder.glob("frame_*.png"))
        for picture in pictures:
            with Image.open(picture) as image:
                image.load()
        return frames in self.frames.values() and summary["frame_sha256"] == frames == hashes(folder / "double.fxld") \
            and len(pictures) == len(frames) and (folder / "walk.gif").stat().st_size > 0

    @staticmethod
    def check_report(file):
        page = file.with_suffix(".html").read_text(encoding="utf-8")
        return "claims" in json.loads(file.read_text(encoding="utf-8")) and page.rstrip().endswith("</html>")


def hashes(file):
    """The frames of a dump."""
    return [frame.sha256 for frame in dump.read_dump(file).frames]


def content(path):
    """The bytes of a file that may just vanish."""
    try:
        return path.read_bytes()
    except OSError:
        return b""


def is_traceback(text):
    """Whether a tool fell over; Python itself says so where Ctrl-C comes before its first line of ours."""
    return "Traceback" in text and not text.endswith("KeyboardInterrupt")


def marked(word):
    """{number: command} of the processes with a word in their environment; of one that has ended there is none."""
    found = {}
    for folder in pathlib.Path("/proc").glob("[0-9]*"):
        if word.encode() in content(folder / "environ").split(b"\0"):
            found[int(folder.name)] = content(folder / "cmdline").replace(b"\0", b" ").decode(errors="replace")
    return found
