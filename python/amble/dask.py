"""Batches on a Dask cluster.

    from distributed import Client
    import amble.dask
    rows = amble.dask.plan_many(Client("scheduler:8786"), "job.yaml", "/shared/walks")

Needs `distributed` (Debian: python3-distributed) here, and the program `amble` on the workers' PATH.
"""

from __future__ import annotations

import json
import os
import pathlib
import re
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

from ._errors import Error, InputError

Path = Union[str, "os.PathLike[str]"]

#: Shards for each thread of the cluster: so small a part is lost with a worker, and so late may the last one be.
SHARDS_PER_THREAD = 4


def plan_many(client: Any, job: Path, directory: Path, *, shards: Optional[int] = None, threads: int = 1,
              program: Path = "amble") -> List[Dict[str, Any]]:
    """Makes the walks of a batch on a cluster: the files of `amble batch JOB -o DIRECTORY`, byte for byte.

    client:    a distributed.Client
    job:       a batch's YAML file (docs/batch.md), and
    directory: where the walks go; both on a disk that the workers see by the same path
    shards:    parts that workers take one after another; None: four for each thread of the cluster
    threads:   walks that a worker makes at a time in a shard
    program:   on the workers

    Where a worker dies its shard is given to another, which makes what is missing; a batch that was
    interrupted goes on where it was. Returns the rows of index.jsonl, in the job's order: one a walk,
    refused ones too. Raises InputError where job or directory are wrong.
    """
    job, directory, program = (os.path.abspath(os.fspath(job)), os.path.abspath(os.fspath(directory)), os.fspath(program))
    if shards is None:
        shards = SHARDS_PER_THREAD * max(1, sum(client.nthreads().values()))
    import distributed

    run = _runner()
    shard_options = [["--shard", f"{index}/{shards}", "--threads", str(threads)] for index in range(1, shards + 1)]
    batch = [program, "batch"]
    made = client.map(run, [[*batch, job, "-o", directory, *options] for options in shard_options], key="amble-batch", pure=False)
    try:
        for _, ended in distributed.as_completed(made, with_results=True):
            _expect_success(*ended)
    finally:
        client.cancel(made)
    _expect_success(*client.submit(run, [*batch, "merge", job, "-o", directory], pure=False).result())
    with (pathlib.Path(directory) / "index.jsonl").open(encoding="utf-8") as lines:
        return [json.loads(line) for line in lines]


def _runner() -> Callable[[Sequence[str]], Tuple[int, str]]:
    """What a worker does. Made here, so that it is sent along: workers need not have this module."""

    def run(command: Sequence[str]) -> Tuple[int, str]:
        import subprocess

        ended = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True)
        return ended.returncode, (ended.stderr.strip().splitlines() or [""])[-1]

    return run


def _expect_success(status: int, line: str) -> None:
    """By the program's exit status, and the last line that it said."""
    if status == 2:
        said = re.fullmatch(r"(?P<file>.*?):(?P<line>\d+)?:? (?P<problem>.*?)(; expected (?P<expected>.*))?", line)
        parts = said.groupdict("") if said else {}
        raise InputError(line, parts.get("file", ""), int(parts.get("line") or 0) or None, parts.get("problem", line),
                         parts.get("expected", ""))
    if status != 0:
        raise Error(f"a shard ended with {status}: {line}")
