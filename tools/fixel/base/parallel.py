# SPDX-License-Identifier: MIT
"""Jobs side by side, with a word about how far they are."""

import concurrent.futures
import os

from fixel.base.progress import Progress


def run(label, jobs):
    """{key: result} of {key: (function, arguments...)}, as many at a time as there are processors."""
    results = {}
    with Progress(label, len(jobs)) as progress, \
            concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        waiting = {pool.submit(*job): key for key, job in jobs.items()}
        try:
            for future in concurrent.futures.as_completed(waiting):
                results[waiting[future]] = future.result()
                progress(len(results))
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
    return {key: results[key] for key in jobs}
