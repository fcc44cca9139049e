# SPDX-License-Identifier: MIT
"""A campaign on a cluster: three Dask workers on this machine, of which one is killed, give the bytes that one process gives and
eight give; and what does not fit is refused in a sentence. make test-campaigns installs what this needs."""

import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

import pytest
from conftest import CHECKOUT, LAUNCHER, assert_one_sentence, environment, run_cli

distributed = pytest.importorskip("distributed", reason="needs Dask, which make test-campaigns installs")

from fixel.base import kept
from fixel.base.errors import ToolError
from fixel.campaign import cluster, worker
from fixel.report import report_shards

DASK = pathlib.Path(sys.executable).with_name("dask")
CLAIMS = ("outline_clipped", "coverage", "depth_16", "orientation_product")
SAMPLES = 600_000
LONG = 1500             # seconds in which a cluster does something


def shards_there(build):
    """How many shards are kept."""
    return sum(bool(kept.NAME.fullmatch(file.name)) for file in build.glob("shards/*"))


class Cluster:
    """A scheduler, and workers that live as long as it does."""

    def __init__(self, folder):
        self.folder, self.running = folder, []
        self._file = folder / "scheduler.json"
        self.start("scheduler", "--host", "127.0.0.1", "--port", "0", "--no-show", "--scheduler-file", self._file)
        wait_until(self._file.exists)
        with distributed.Client(scheduler_file=str(self._file), set_as_default=False) as client:
            self.address = client.scheduler.address

    def start(self, what, *options, **changes):
        log = open(self.folder / f"{what}-{len(self.running)}.log", "wb")
        process = subprocess.Popen([DASK, what, "--no-dashboard", *map(str, options)], cwd=self.folder, stdin=subprocess.DEVNULL,
                                   stdout=log, stderr=subprocess.STDOUT, env=environment(**changes))
        self.running.append(process)
        return process

    def worker(self, scratch, **changes):
        """A worker with one thread, whose files go below a folder."""
        return self.start("worker", "--scheduler-file", self._file, "--nthreads", "1", "--no-nanny", "--memory-limit", "0",
                          "--local-directory", scratch, **changes)

    def end(self, process):
        """Kills a process, and waits until the scheduler knows it."""
        process.kill()
        process.wait()
        with distributed.Client(self.address, set_as_default=False) as client:
            wait_until(lambda: len(client.scheduler_info(n_workers=-1)["workers"]) ==
                       sum(each.poll() is None for each in self.running) - 1)

    def close(self):
        for process in reversed(self.running):
            process.kill()
            process.wait()


def wait_until(condition):
    until = time.monotonic() + LONG
    while not condition():
        assert time.monotonic() < until
        time.sleep(0.05)


@pytest.fixture(name="started", scope="module")
def fixture_started(tmp_path_factory):
    started = Cluster(tmp_path_factory.mktemp("cluster"))
    yield started
    started.close()


@pytest.fixture(name="programs", scope="module")
def fixture_programs(tmp_path_factory):
    """A build folder with the real oracle, in which nothing is kept."""
    build = tmp_path_factory.mktemp("build")
    (build / "host").symlink_to(CHECKOUT / "build" / "host")
    return build


def words(build, out, *more):
    return list(map(str, ["report", "--only", " ".join(CLAIMS), "--samples", SAMPLES, "--build", build, "--out", out, *more]))


def test_three_workers_of_which_one_is_killed_give_the_same_bytes(started, programs, tmp_path):
    for jobs in (1, 8):
        done = run_cli(*words(programs, tmp_path / str(jobs), "--jobs", jobs))
        assert done.returncode == 0, done.stdout + done.stderr
    workers = [started.worker(started.folder / "scratch") for _ in range(3)]
    some, _ = report_shards.plan([kind for kind in report_shards.CLAIMS if kind.what in CLAIMS], SAMPLES, 1)
    with open(tmp_path / "said", "wb") as said:
        command = subprocess.Popen([sys.executable, LAUNCHER, *words(programs, tmp_path / "cluster", "--cluster", started.address)],
                                   cwd=CHECKOUT, stdout=said, stderr=subprocess.STDOUT, env=environment(FIXEL_KEPT="", CI=""))
    wait_until(lambda: shards_there(programs) >= len(some) // 4 or command.poll() is not None)
    workers[1].send_signal(signal.SIGKILL)
    at_kill = shards_there(programs)
    assert command.wait(LONG) == 0, (tmp_path / "said").read_text()
    assert len(some) // 4 <= at_kill < len(some) == shards_there(programs), "it was killed midway, and all shards are there"
    assert [each.poll() for each in workers] == [None, -signal.SIGKILL, None]
    one, eight, three = ((tmp_path / name / "claims.json").read_bytes() for name in ("1", "8", "cluster"))
    assert one == eight == three
    assert f"{len(some)} of {len(some)} shards done, 0 of them by earlier commands" in (tmp_path / "said").read_text()


def a_shard():
    return report_shards.plan([report_shards.CLAIMS[0]], 1000, 1)[0][0]


def answer(pool):
    return list(pool.compute([a_shard()], lambda: True))


def test_a_shard_of_another_checkout_is_refused(started):
    with cluster.Pool(started.address) as pool:
        assert answer(pool)[0][1]["result"]["samples"] == 200
        pool.checkout = "0" * 64
        with pytest.raises(ToolError, match="refuses the shard: it has no checkout 0000000000000000, of which the shard is"):
            answer(pool)


def test_a_folder_that_holds_another_checkout_is_refused(started):
    """A file of it is changed; the workers that are there have looked before, and a new one looks."""
    for process in started.running[1:]:
        if process.poll() is None:
            started.end(process)
    (root,) = (each for each in (started.folder / "scratch").glob(f"**/{worker.KEEP}*") if each.is_dir())
    with open(root / "lib/math/arith.h", "a", encoding="utf-8") as file:
        file.write("\n")
    fresh = started.worker(started.folder / "scratch")
    with cluster.Pool(started.address) as pool:
        with pytest.raises(ToolError, match="holds another checkout than the campaign's .*: remove that folder there"):
            answer(pool)
        shutil.rmtree(root / "lib")
    started.end(fresh)


def test_a_worker_without_a_compiler_is_a_sentence(started, tmp_path):
    (tmp_path / "bin").mkdir()
    for folder in ("/bin", "/usr/bin", str(pathlib.Path(sys.base_prefix) / "bin")):
        for file in pathlib.Path(folder).iterdir():
            if not any(word in file.name for word in ("gcc", "cc", "clang", "++")) and not (tmp_path / "bin" / file.name).exists():
                (tmp_path / "bin" / file.name).symlink_to(file)
    bare = started.worker(tmp_path / "scratch", PATH=str(tmp_path / "bin"))
    with cluster.Pool(started.address) as pool, \
            pytest.raises(ToolError, match="report, oracle .*: the worker tcp://.* refuses the shard: its machine lacks gcc.*: install"):
        answer(pool)
    started.end(bare)


def test_a_cluster_that_is_not_there_is_a_sentence(started, programs, tmp_path, monkeypatch):
    assert_one_sentence(run_cli(*words(programs, tmp_path / "out", "--cluster", "here")), "CLUSTER is 'here'", "tcp://")
    monkeypatch.setattr(cluster, "PATIENCE", 2)
    with pytest.raises(ToolError, match="CLUSTER=tcp://127.0.0.1:9: no Dask scheduler answers there"):
        cluster.connect("tcp://127.0.0.1:9")
    with pytest.raises(ToolError, match="has no worker; start some: dask worker tcp://"):
        cluster.connect(started.address)


def test_an_archive_is_the_same_whoever_makes_it(tmp_path):
    """Of the checkout with git, and of what a worker unpacks, without it."""
    names = cluster.files()
    assert "Makefile" in names and not [name for name in names if name.startswith(("build/", ".venv/", ".git/"))]
    for name in names:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(CHECKOUT / name, tmp_path / name)
        os.chmod(tmp_path / name, 0o700 if os.access(CHECKOUT / name, os.X_OK) else 0o600)
    (tmp_path / "build").mkdir()
    (tmp_path / "build" / "made").write_text("no part of it")
    assert cluster.files(tmp_path) == names
    assert worker.name_of(worker.archive(tmp_path, names)) == worker.name_of(worker.archive(CHECKOUT, names))
