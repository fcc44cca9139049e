# SPDX-License-Identifier: MIT
"""Campaigns: the same shards give the same bytes on one process and on eight, also where a run was killed and went on.

The program that draws samples is a script here, which writes down each shard that it is asked for; the command is
fixel report, as a user calls it."""

import json
import signal
import subprocess
import sys
import time

import pytest
from conftest import CHECKOUT, LAUNCHER, assert_one_sentence, environment, run_cli

from fixel.base import kept
from fixel.base.errors import ToolError
from fixel.campaign import runner, sent, shards
from fixel.report import report_shards

BUILT_PROGRAMS = ("host/oracle",)
CLAIMS = "orientation_axis matrix_entry depth_16"
SHARDS = 20 + 40 + 40       # of ten million samples
# Figures that another order of additions would change.
ORACLE = """#!/bin/sh
echo "$1 $7" >>{log}
test -z "{slow}" || sleep {slow}
printf '{{"id": "%s", "samples": %s, "max": 0.1%s, "sum": 0.1%s7, "sum_of_squares": 0.01%s, "worst_input": "%s", \
"histogram": [{{"upto": 1, "count": %s}}]}}' "$1" "$3" "$7" "$7" "$7" "$7" "$3"
"""


@pytest.fixture(name="command")
def fixture_command(tmp_path):
    """A build folder of its own: command(out, options...) is a finished report."""
    return Command(tmp_path)


class Command:
    """fixel report with a program of ours."""

    def __init__(self, folder):
        self.folder, self.build, self.log = folder, folder / "build", folder / "log"
        (self.build / "host").mkdir(parents=True)
        self.install()

    def install(self, slow=""):
        oracle = self.build / "host" / "oracle"
        oracle.write_text(ORACLE.format(log=self.log, slow=slow))
        oracle.chmod(0o755)
        self.log.write_text("")

    def words(self, out, *more):
        return ["report", "--only", CLAIMS, "--build", self.build, "--out", self.folder / out, *map(str, more)]

    def __call__(self, out, *more, **changes):
        done = run_cli(*self.words(out, *more), **changes)
        assert done.returncode == 0, done.stdout + done.stderr
        return done

    def report(self, out):
        return (self.folder / out / "claims.json").read_bytes()

    def asked(self):
        """The shards that the program was asked for since the last time."""
        lines = self.log.read_text().splitlines()
        self.log.write_text("")
        return lines

    def rates(self):
        return json.loads((self.build / "campaigns" / "report.json").read_text())


ALLOWED = {"FIXEL_KEPT": "", "CI": ""}      # to keep what is done


def test_one_process_and_eight_give_the_same_bytes(command):
    done = command("one", "--jobs", 1)
    asked = command.asked()
    assert len(asked) == len(set(asked)) == SHARDS
    assert f"{SHARDS} of {SHARDS} shards done, 0 of them by earlier commands" in done.stderr
    command("eight", "--jobs", 8)
    again = command.asked()
    assert sorted(again) == sorted(asked) and not (command.build / "shards").exists()
    assert command.report("one") == command.report("eight")


def test_a_killed_campaign_goes_on(command):
    command("whole")
    command.asked()
    command.install(slow="0.02")
    process = subprocess.Popen([sys.executable, str(LAUNCHER), *map(str, command.words("killed", "--jobs", 3))], cwd=CHECKOUT,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=environment(**ALLOWED))
    while process.poll() is None and len(command.log.read_text().splitlines()) < SHARDS // 3:
        time.sleep(0.01)
    process.send_signal(signal.SIGKILL)
    process.wait()
    begun = command.asked()
    assert SHARDS // 3 <= len(begun) < SHARDS and not (command.folder / "killed").exists()
    command("after", "--jobs", 8, **ALLOWED)
    rest, there = command.asked(), command.rates()
    assert there["done"] == there["shards"] == SHARDS
    # Each of the three processes of the killed command may ask for one more shard before it finds itself alone.
    assert SHARDS <= there["kept"] + len(rest) <= SHARDS + 3
    assert abs(there["kept"] - len(begun)) <= 3, "what was under way is all that was lost"
    assert set(begun) | set(rest) == {f"{kind.what} {number}" for kind in report_shards.CLAIMS if kind.what in CLAIMS.split()
                                      for number, _ in report_shards.shards_of(kind, report_shards.SAMPLES)}
    assert command.report("after") == command.report("whole")
    command("once more", **ALLOWED)
    assert command.asked() == [] and command.report("once more") == command.report("whole")
    command("fresh", "--fresh", **ALLOWED)
    assert len(command.asked()) == SHARDS


def test_other_programs_and_other_parameters_are_other_shards(command):
    command("one", **ALLOWED)
    command.asked()
    command("seed", "--seed", 2, **ALLOWED)
    assert len(command.asked()) == SHARDS
    command("more", "--samples", 20_000_000, **ALLOWED)
    assert len(command.asked()) == SHARDS, "the first half is there"
    oracle = command.build / "host/oracle"
    oracle.write_text(oracle.read_text() + "# another program\n")
    command("other", **ALLOWED)
    assert len(command.asked()) == SHARDS


def test_a_report_of_many_samples_ends_after_its_minutes(command, monkeypatch, capsys):
    """With a budget that is spent at once only the first ten million samples are drawn, and the report is about them."""
    monkeypatch.setattr(report_shards, "CORES", 0)
    monkeypatch.chdir(CHECKOUT)
    options = ["--samples", "30000000", "--minutes", "1"]
    monkeypatch.setattr(report_shards.runner.Budget, "is_left", lambda self: False)
    from fixel.report import report
    assert report.main([*map(str, command.words("short")[1:]), *options]) == 0
    said = capsys.readouterr().err
    assert "after 1 minutes of 0 cores the report is about the shards that are done" in said
    assert len(command.asked()) == SHARDS
    claims = json.loads(command.report("short"))["claims"]
    assert [claim["samples"] for claim in claims] == [2_000_000, 10_000_000, 2_000_000]
    assert command.rates()["shards"] == 3 * SHARDS and command.rates()["done"] == SHARDS


def test_a_shard_that_fails_is_one_sentence(command):
    (command.build / "host/oracle").write_text("#!/bin/sh\necho 'oracle: out of luck' >&2\nexit 2\n")
    assert_one_sentence(run_cli(*command.words("out"), "--jobs", 8), "out of luck")
    (command.build / "host/oracle").write_text("#!/bin/sh\necho '[1'\n")
    assert_one_sentence(run_cli(*command.words("out")), "JSON")
    (command.build / "host/oracle").write_text("#!/bin/sh\nkill -9 $(ps -o ppid= -p $$)\nexec sleep 9\n")
    assert_one_sentence(run_cli(*command.words("out"), "--jobs", 2), "report, oracle", "was killed")


def test_a_program_that_is_not_built_is_one_sentence(command):
    (command.build / "host/oracle").unlink()
    for changes in ({}, ALLOWED):
        assert_one_sentence(run_cli(*command.words("out"), **changes), "host/oracle", "make all builds")


def test_a_damaged_shard_is_computed_anew(command):
    command("one", **ALLOWED)
    command.asked()
    damaged = next(file for file in (command.build / "shards").iterdir() if kept.NAME.fullmatch(file.name))
    damaged.write_bytes(damaged.read_bytes()[:-1])
    assert "is damaged" in command("two", **ALLOWED).stderr
    assert len(command.asked()) == 1 and command.report("one") == command.report("two")


def test_the_rate_and_the_hours_of_large_campaigns():
    done = [shards.Shard("report", number, {}, "a", 500) for number in range(4)]
    (row,) = runner.rates_of(done, {0: 1.0, 1: 1.0, 2: 2.0, 3: 0.0})
    assert row == {"kind": "a", "shards": 4, "samples": 2000, "seconds": 4.0, "shard_seconds": 1.0, "samples_a_second": 500.0,
                   "core_hours": {"10^9": 555.556, "10^10": 5555.556, "10^12": 555555.556}}
    assert runner.rate_of_whole([row], done[:2], 100) == {"kind": "all, in proportion", "shards": 2, "samples": 100, "seconds": 2.0,
                                                 "shard_seconds": 1.0, "samples_a_second": 50.0,
                                                 "core_hours": {"10^9": 5555.556, "10^10": 55555.556, "10^12": 5555555.556}}
    assert "core hours of 10^12" in runner.rates_as_text([row]) and "5.556e+05" in runner.rates_as_text([row])


def test_large_campaigns_have_longer_shards_and_no_more_of_them():
    kind = next(kind for kind in report_shards.CLAIMS if kind.what == "orientation_axis")
    for total in (report_shards.SAMPLES, 10 ** 9, 10 ** 10, 10 ** 12):
        some = report_shards.shards_of(kind, total)
        assert len(some) <= report_shards.MOST_SHARDS
        assert sum(samples for _, samples in some) == total and all(samples > 0 for _, samples in some)
    assert report_shards.shards_of(kind, 10 ** 9)[:40] == report_shards.shards_of(kind, report_shards.SAMPLES)


def test_the_first_shards_of_a_plan_are_those_of_the_default():
    kinds = report_shards.CLAIMS[:3]
    default, all_of_it = report_shards.plan(kinds, report_shards.SAMPLES, 1)
    more, first = report_shards.plan(kinds, 3 * report_shards.SAMPLES, 1)
    assert all_of_it == len(default) == first and more[:first] == default
    assert [shard.number for shard in more] == list(range(len(more)))


def test_jobs_are_a_number():
    assert runner.JOBS_MAX == 1024
    assert_one_sentence(run_cli("report", "--jobs=1025"), "--jobs", "1025")


def test_no_link_out_of_the_checkout_is_sent_to_a_cluster(tmp_path):
    root, secret = tmp_path / "checkout", tmp_path / "secret"
    secret.write_text("mine")
    root.mkdir()
    subprocess.run(["git", "init", "-q", root], check=True)
    (root / "file").write_text("x")
    (root / "link").symlink_to("file")
    (root / "folder").symlink_to(tmp_path)
    assert sent.of_git(root) == ["file", "link"]
    (root / "out").symlink_to("../secret")
    with pytest.raises(ToolError, match="checkout/out: leads to .*secret, outside"):
        sent.of_git(root)
    (root / ".gitignore").write_text("out\n")
    assert sent.of_git(root) == [".gitignore", "file", "link"]
