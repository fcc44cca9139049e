# SPDX-License-Identifier: MIT
"""The inside of a process that computes shards: it reads a request a line, {"campaign", "parameters", "build"}, and answers
with a line: {"result", "seconds"}, {"error"} or {"defect"}. seconds: of CPU time, with those of its children."""

import json
import os
import pathlib
import resource
import signal
import sys
import traceback

if __name__ == "__main__":
    sys.path[0] = str(pathlib.Path(__file__).resolve().parents[2])

from fixel.base import limits
from fixel.base.errors import ToolError
from fixel.campaign import shards


def cpu_seconds():
    """Of this process and its children: of those that have ended, and of those that live from shard to shard."""
    return limits.cpu_of_descendants(os.getpid()) + sum(
        getattr(resource.getrusage(who), part) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)
        for part in ("ru_utime", "ru_stime"))


def answer(request):
    """The answer to a request."""
    begun = cpu_seconds()
    try:
        result = shards.module_of(request["campaign"]).run_shard(pathlib.Path(request["build"]), request["parameters"])
    except ToolError as error:
        return {"error": {"message": error.message, "exit_code": error.exit_code, "words": error.words}}
    except Exception as error:  # one sentence for whoever asked, whatever it was
        last = traceback.extract_tb(error.__traceback__)[-1]
        return {"defect": f"{type(error).__name__} in {os.path.basename(last.filename)}, line {last.lineno}: {error}"}
    return {"result": result, "seconds": round(cpu_seconds() - begun, 3)}


def serve():
    """Answers until the requests end. What is printed goes to the standard error."""
    out = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)
    for line in sys.stdin:
        out.write(json.dumps(answer(json.loads(line))) + "\n")
        out.flush()


if __name__ == "__main__":
    serve()
