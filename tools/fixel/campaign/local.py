# SPDX-License-Identifier: MIT
"""Shards on this machine: processes that live as long as the campaign, each with a shard at a time."""

import concurrent.futures
import json
import os
import pathlib
import queue
import signal
import subprocess
import sys

from fixel.base import children
from fixel.base.errors import ToolError

SERVER = pathlib.Path(__file__).with_name("server.py")


class Server:
    """A process that computes shards."""

    def __init__(self, build):
        self._build = os.fspath(build)
        self._process = children.start([sys.executable, SERVER], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
                                       encoding="utf-8")

    def compute(self, shard):
        """{"result", "seconds"} of a shard."""
        try:
            self._process.stdin.write(json.dumps({"campaign": shard.campaign, "parameters": shard.parameters,
                                                  "build": self._build}) + "\n")
            self._process.stdin.flush()
            said = json.loads(self._process.stdout.readline())
        except (OSError, ValueError):
            raise ToolError(f"{describe(shard)}: its process {self._ended()}") from None
        return checked(shard, said)

    def _ended(self):
        code = self._process.wait()
        if code == -signal.SIGKILL:
            return "was killed, as a system does whose memory is full"
        return f"was ended by {signal.Signals(-code).name}" if code < 0 else f"ended with {code}"

    def close(self):
        self._process.kill()
        with self._process:
            pass


def describe(shard):
    """A shard, for people."""
    return f"{shard.campaign}, {shard.kind}, shard {shard.number}"


def checked(shard, said):
    """An answer of a server, if it is no error."""
    if "error" in said:
        error = said["error"]
        raise ToolError(error["message"], error["exit_code"], error["words"])
    if "defect" in said:
        raise ToolError(f"{describe(shard)}: this is a defect of the tool ({said['defect']}): please report it")
    return said


class Pool:
    """So many processes. compute(shards, go_on) gives (shard, answer) as they are done, until go_on() is false."""

    def __init__(self, build, jobs):
        self._servers = [Server(build) for _ in range(jobs)]
        self._free = queue.SimpleQueue()
        for server in self._servers:
            self._free.put(server)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for server in self._servers:
            server.close()

    def _compute(self, shard):
        server = self._free.get()
        try:
            return shard, server.compute(shard)
        finally:
            self._free.put(server)

    def compute(self, todo, go_on):
        todo, waiting = iter(todo), set()
        with concurrent.futures.ThreadPoolExecutor(len(self._servers)) as threads:
            try:
                while True:
                    while len(waiting) < len(self._servers) and go_on():
                        shard = next(todo, None)
                        if shard is None:
                            break
                        waiting.add(threads.submit(self._compute, shard))
                    if not waiting:
                        return
                    done, waiting = concurrent.futures.wait(waiting, return_when=concurrent.futures.FIRST_COMPLETED)
                    for future in done:
                        yield future.result()
            except BaseException:
                self.__exit__()     # a thread may wait for an hour's shard
                raise
