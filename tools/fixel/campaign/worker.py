# SPDX-License-Identifier: MIT
"""What a worker of a cluster does: it unpacks and builds the checkout of a campaign, once for all workers of its machine, and
computes shards by that checkout's own tools.

This module is sent to the workers as it stands, so it includes nothing of Fixel. A worker needs Python and Dask; what the
checkout needs to be built, tools/setup.sh of the checkout names. Nothing is installed on a worker's machine but the Python
packages in the checkout's own .venv. The answers are those of server.py, or {"refused": sentence}.
"""

import contextlib
import ctypes
import fcntl
import hashlib
import io
import json
import os
import pathlib
import shutil
import signal
import subprocess
import tarfile
import threading
import zlib

from distributed import WorkerPlugin, get_worker

MADE = {"build", "dist", ".git", ".venv", ".node", ".fixel-name"}      # what is no part of a checkout
KEEP = "fixel-checkout-"        # begins the names of folders here
PR_SET_PDEATHSIG = 1            # of Linux


class Refusal(Exception):
    """Why a worker does not compute a shard: a sentence."""


def files(root):
    """The paths of the files of a checkout without git, in order."""
    found = []
    for folder, inside, names in os.walk(root):
        here = pathlib.Path(folder).relative_to(root)
        inside[:] = [name for name in inside if name != "__pycache__" and (here / name).as_posix() not in MADE]
        found += [(here / name).as_posix() for name in names if (here / name).as_posix() not in MADE]
    return sorted(found)


def archive(root, names):
    """A tar file of files of a checkout: the same bytes for the same contents, whoever makes it and when."""
    made = io.BytesIO()
    with tarfile.open(fileobj=made, mode="w", format=tarfile.PAX_FORMAT) as tar:
        for name in names:
            data = (root / name).read_bytes()
            entry = tarfile.TarInfo(name)
            entry.size, entry.mode = len(data), 0o755 if os.access(root / name, os.X_OK) else 0o644
            tar.addfile(entry, io.BytesIO(data))
    return made.getvalue()


def name_of(tar):
    """The name of a checkout: the SHA-256 of its archive."""
    return hashlib.sha256(tar).hexdigest()


class Place:
    """A checkout on a worker's machine: the folder that its workers share. It stays locked while one of them lives."""

    def __init__(self, name, packed, parent):
        self.name, self._packed, self._parent = name, packed, pathlib.Path(parent)
        self.root = self._parent / f"{KEEP}{name[:16]}"
        self._guard, self._lock, self._built, self._free = threading.Lock(), None, set(), []

    def ready(self, setup, targets):
        """The folder, with what a shard needs built."""
        with self._guard:
            if self._lock is None:
                self._take()
            wanted = (setup, *targets)
            if wanted not in self._built:
                with self._alone():
                    self._install(setup)
                    if targets:
                        self._run(["make", *targets], "make")
                self._built.add(wanted)

    @contextlib.contextmanager
    def _alone(self):
        """One worker of the machine at a time builds."""
        with open(self.root.with_suffix(".building"), "ab") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            yield

    def _take(self):
        """Unpacks the checkout if no other worker has, and demands that it is the one that its name says."""
        self._parent.mkdir(parents=True, exist_ok=True)
        self._lock = open(self.root.with_suffix(".lock"), "ab")
        fcntl.flock(self._lock, fcntl.LOCK_SH)
        with self._alone():
            if not self.root.exists():
                self._remove_others()
                self._unpack()
            if name_of(archive(self.root, files(self.root))) != self.name:
                self._lock.close()
                self._lock = None
                raise Refusal(f"{self.root} holds another checkout than the campaign's ({self.name[:16]}): remove that folder there")

    def _unpack(self):
        new = self.root.with_suffix(f".{os.getpid()}")
        shutil.rmtree(new, ignore_errors=True)
        with tarfile.open(fileobj=io.BytesIO(zlib.decompress(self._packed))) as tar:
            tar.extractall(new, filter="data")
        new.rename(self.root)

    def _remove_others(self):
        """Those that no worker has locked: of campaigns that are over."""
        for lock in self._parent.glob(f"{KEEP}*.lock"):
            with open(lock, "ab") as other, contextlib.suppress(BlockingIOError):
                fcntl.flock(other, fcntl.LOCK_EX | fcntl.LOCK_NB)
                shutil.rmtree(lock.with_suffix(""), ignore_errors=True)

    def _install(self, setup):
        missing = self._run(["tools/setup.sh", "--missing", setup], "tools/setup.sh").strip()
        if missing:
            raise Refusal(f"its machine lacks {missing}: install these packages there")
        self._run(["tools/setup.sh", setup], "tools/setup.sh")

    def _run(self, command, what):
        kept = {name: value for name, value in os.environ.items() if name not in ("MAKEFLAGS", "MFLAGS", "MAKELEVEL", "FIXEL_SET_UP")}
        try:
            done = subprocess.run(command, cwd=self.root, env=kept, stdin=subprocess.DEVNULL, text=True, errors="replace", check=False,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, preexec_fn=_end_with_worker)
        except OSError as error:
            raise Refusal(f"{command[0]} cannot be started there: {error.strerror}") from error
        if done.returncode:
            said = (done.stderr.strip() or done.stdout.strip() or "it says nothing").splitlines()
            raise Refusal(f"{what} fails there: {' / '.join(said[-3:])}")
        return done.stdout

    def answer(self, request, setup, targets):
        """The answer to a request, or why there is none. Here, where its class is known: a worker has this module as often as
        commands have sent it, and a Refusal of one is none of another."""
        try:
            self.ready(setup, targets)
            return self._compute(request)
        except Refusal as refusal:
            return {"refused": str(refusal)}

    def _compute(self, request):
        """What a process of the checkout answers to a request."""
        with self._guard:
            server = self._free.pop() if self._free else None
        server = server or subprocess.Popen([self.root / ".venv/bin/python", self.root / "tools/fixel/campaign/server.py"],
                                            cwd=self.root, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
                                            encoding="utf-8", preexec_fn=_end_with_worker)
        server.stdin.write(json.dumps({**request, "build": "build"}) + "\n")
        server.stdin.flush()
        line = server.stdout.readline()
        if not line:
            raise Refusal(f"the process that computes the shard ended with {server.wait()}")
        with self._guard:
            self._free.append(server)
        return json.loads(line)

    def close(self):
        for server in self._free:
            server.kill()
            server.wait()


def _end_with_worker():
    """However the worker ends, so does what it has started."""
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, int(signal.SIGKILL))


class Checkout(WorkerPlugin):
    """Gives each worker, also one that comes later, the archive of a checkout."""

    idempotent = True       # a second campaign of the checkout leaves what the first one has built

    def __init__(self, name, packed):
        self.checkout, self.packed = name, packed
        self.name = f"{KEEP}{name[:16]}"

    def setup(self, worker):
        """As Dask calls it. A worker's own folder is removed with it; the one above it is that of its machine."""
        if not hasattr(worker, "fixel_places"):
            worker.fixel_places = {}
        worker.fixel_places[self.checkout] = Place(self.checkout, self.packed, pathlib.Path(worker.local_directory).parent)

    def teardown(self, worker):
        place = worker.fixel_places.pop(self.checkout, None)
        if place:
            place.close()


def compute(checkout, request, setup, targets):
    """The answer to the request of a shard of a checkout."""
    worker = get_worker()
    place = getattr(worker, "fixel_places", {}).get(checkout)
    answer = place.answer(request, setup, targets) if place else {"refused": f"it has no checkout {checkout[:16]}, of which the shard is"}
    if "refused" in answer:
        answer["refused"] = f"the worker {worker.address} refuses the shard: {answer['refused']}"
    return answer
