# SPDX-License-Identifier: MIT
"""What commands computed, kept by content in the folder kept of a build folder, so that no command computes it twice.

An entry is a file. Its name is its key: the SHA-256 of all that its content depends on, such as the program, the scene
image, the options and the version of the emulator. Its first line has the SHA-256 of all that follows, which is
checked whenever the entry is read. A file gets its name when it is whole. All entries together have at most MOST bytes;
the one that was used longest ago goes first. The shards of campaigns have a folder and a limit of their own.

Tests and continuous integration compute everything: with CI=true or FIXEL_KEPT=no in the environment nothing is read
from the folder, and nothing is put there.
"""

import contextlib
import fcntl
import hashlib
import json
import os
import pathlib
import re
import sys
import zlib

from fixel.base import scratch
from fixel.base.errors import one_line

MOST = 200_000_000      # bytes of all entries
FORMAT = b"fixel kept 1 "   # another number: what is kept has another meaning
NAME = re.compile("[0-9a-f]{64}")
BLOCK = 1 << 20
QUICK = 1               # of zlib's levels
SHARE = 8               # a command writes this part of the room there is before it looks again: others write too


def is_allowed(environment=None):
    """Whether this command may use what others kept."""
    environment = os.environ if environment is None else environment
    return environment.get("FIXEL_KEPT") != "no" and environment.get("CI", "") in ("", "0", "false")


def add_option(parser):
    """--fresh."""
    parser.add_argument("--fresh", action="store_true",
                        help="compute everything, also what an earlier command has kept (FRESH=1)")


def key_of(inputs):
    """The key of what is computed from these inputs: a path stands for the content of the file there, anything else for
    its text."""
    key = hashlib.sha256(FORMAT)
    for each in inputs:
        if isinstance(each, os.PathLike):
            with open(each, "rb") as file:
                part = b"content" + hashlib.file_digest(file, "sha256").digest()
        else:
            part = b"text   " + hashlib.sha256(repr(each).encode()).digest()
        key.update(part)
    return key.hexdigest()


class Kept:
    """The entries of a build folder. parts: names of what came from there and was not computed, in their order.
    most: bytes of all entries, MOST without; where some commands write at once it may be
    passed for a moment."""

    def __init__(self, build, fresh=False, folder="kept", most=None):
        self.folder, self.most = pathlib.Path(build) / folder, most or MOST
        self._room = 0      # bytes that may be written before the folder is looked at again
        self.writes = is_allowed()
        self.reads = self.writes and not fresh
        self.parts = []

    def obtain(self, part, inputs, files, compute):
        """Makes files: as an entry has them, or by compute(), and then they are kept. inputs: as for key_of; all that
        the files depend on."""
        if not self.writes:
            compute()
            return
        inputs = (part, *inputs)
        key = key_of(inputs)
        entry = self.folder / key
        if self.reads and self._read(entry, files):
            self.parts.append(part)
            return
        compute()
        try:
            if key_of(inputs) == key and sum(file.stat().st_size for file in files) <= self.most:
                self._write(entry, _pack(files))    # no other command has built the program anew meanwhile
        except OSError as error:
            self._cannot_write(error)

    def value(self, key):
        """What was kept by keep_value; None if there is nothing."""
        found = []
        if self.reads:
            self._open(self.folder / key, lambda body: found.append(json.loads(zlib.decompress(body))))
        return found[0] if found else None

    def keep_value(self, key, value):
        """Keeps what JSON holds and is not None. key: of key_of."""
        if self.writes:
            try:
                self._write(self.folder / key, zlib.compress(json.dumps(value).encode(), QUICK))
            except OSError as error:
                self._cannot_write(error)

    def _cannot_write(self, error):
        if self.writes:
            print(f"  {one_line(self.folder)}: cannot be written, so nothing is kept: {error.strerror}", file=sys.stderr)

    def _read(self, entry, files):
        """Whether the entry is there and whole, and files are made from it."""
        def unpack(body):
            sizes, _, packed = body.partition(b"\n")
            _unpack(json.loads(sizes), packed, files)
        return self._open(entry, unpack)

    def _open(self, entry, unpack):
        """Whether the entry is there and whole, and unpack(its content) has used it."""
        try:
            data = entry.read_bytes()
        except OSError:
            return False
        head, _, body = data.partition(b"\n")
        try:
            if head != FORMAT + hashlib.sha256(body).hexdigest().encode():
                raise ValueError
            unpack(body)
        except (ValueError, zlib.error):
            print(f"  {one_line(entry)} is damaged: it is thrown away, and what it held is computed anew", file=sys.stderr)
            entry.unlink(missing_ok=True)
            return False
        with contextlib.suppress(OSError):  # another command has just removed it
            os.utime(entry)
        return True

    def _write(self, entry, packed):
        self.folder.mkdir(parents=True, exist_ok=True)
        head = FORMAT + hashlib.sha256(packed).hexdigest().encode() + b"\n"
        with scratch.file("kept", self.folder) as (new, file):
            file.write(head + packed)
            file.flush()
            with self._locked():
                self._make_room(len(head) + len(packed))
                os.replace(new, entry)

    @contextlib.contextmanager
    def _locked(self):
        """One command at a time puts an entry in place."""
        with open(self.folder / ".lock", "ab") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            yield

    def _make_room(self, size):
        """Removes what was used longest ago until so many bytes have room. A campaign keeps a hundred thousand entries, so
        the folder is looked at only where it may be full."""
        self._room -= size
        if self._room >= 0:
            return
        there = []
        for file in self.folder.iterdir():
            with contextlib.suppress(FileNotFoundError):
                if NAME.fullmatch(file.name):   # anything else is somebody's work
                    state = file.stat()
                    there.append((state.st_mtime_ns, state.st_size, file))
        room = self.most - size - sum(each for _, each, _ in there)
        for _, bytes_, file in sorted(there):
            if room >= 0:
                break
            file.unlink(missing_ok=True)
            room += bytes_
        self._room = room // SHARE


def _pack(files):
    """The sizes of files, and their contents, compressed."""
    packer = zlib.compressobj(QUICK)
    out = [json.dumps([file.stat().st_size for file in files]).encode() + b"\n"]
    for file in files:
        with open(file, "rb") as content:
            while block := content.read(BLOCK):
                out.append(packer.compress(block))
    return b"".join([*out, packer.flush()])


def _unpack(sizes, packed, files):
    """Makes files of what _pack gave."""
    content = zlib.decompress(packed)
    if len(sizes) != len(files) or sum(sizes) != len(content):
        raise ValueError
    begin = 0
    for size, file in zip(sizes, files):
        file.write_bytes(content[begin:begin + size])
        begin += size
