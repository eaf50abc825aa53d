"""Checks a folder of very many models by the program plumb, in shards that Dask shares out.

    python -m plumb.corpus FOLDER --out DIR                              # on the processors of this machine
    python -m plumb.corpus FOLDER --out DIR --scheduler tcp://host:8786  # on the workers that are there

Each shard is a run of `plumb check FOLDER --shard I/N --out DIR`, or of clash or repair in place of check, which goes on
where it was stopped: a shard whose worker is lost is given to another, which waits for what is left of the first and does
the rest.  Every worker sees FOLDER and DIR under the same paths, and has the program.  In the end `plumb collect DIR` tells what was found.
"""

import argparse
import importlib
import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any, List, NamedTuple, Optional, Sequence, Tuple

__all__ = ["Shards", "run_shards"]

NO_DASK = ("plumb.corpus: Dask's distributed is needed and is not here; Debian has it as python3-distributed "
           "('apt-get install python3-distributed'), pip as distributed")


class Shards(NamedTuple):
    """How the shards of a corpus ended: how many there are, and the number and the reason of each that is not done."""

    total: int
    failed: List[Tuple[int, str]]


def _distributed() -> Any:
    try:
        return importlib.import_module("distributed")
    except ImportError as error:
        raise ImportError(NO_DASK) from error


def _processors() -> int:
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _client(distributed: Any, scheduler: Optional[str], workers: Optional[int]) -> Any:
    if scheduler is not None:
        try:
            return distributed.Client(scheduler, timeout=10)
        except (OSError, ValueError) as error:
            raise ConnectionError(f"plumb.corpus: no scheduler of Dask answers at {scheduler}: {error}") from error
    # Each shard is a process of its own already, so threads do to wait for them.
    cluster = distributed.LocalCluster(n_workers=1, threads_per_worker=workers or _processors(), processes=False,
                                       dashboard_address=None, memory_limit=0)
    return distributed.Client(cluster)


def _tell(distributed: Any, futures: Sequence[Any], shown: bool) -> None:
    """Waits for all: with Dask's bar on a terminal, else with a line for each tenth."""
    if shown and sys.stdout.isatty():
        distributed.progress(list(futures), notebook=False)
        print()
    done, told = 0, 0
    for _ in distributed.as_completed(futures):
        done += 1
        if shown and not sys.stdout.isatty() and done * 10 // len(futures) > told:
            told = done * 10 // len(futures)
            print(f"{done} of {len(futures)} shards", flush=True)


def run_shards(folder: str, out: str, *, shards: Optional[int] = None, scheduler: Optional[str] = None,
               program: str = "plumb", time_limit: float = 600, memory_limit: Optional[int] = None,
               workers: Optional[int] = None, command: str = "check", options: Sequence[str] = (),
               shown: bool = False) -> Shards:
    """Runs all shards of a folder of models, and says which could not be done.

    `shards` is how many there are; when not given eight for each thread of a worker.  `scheduler` is the address of one that
    is there; without it this process is one, for `workers` shards at once, or as many as there are processors.  `program`
    is plumb's, by its path on the workers; `time_limit` (seconds) and `memory_limit` (MiB) are of each model; `command` is
    check, clash or repair, whose `options` go to the program as they are.  Raises ImportError where Dask is not installed,
    ConnectionError where no scheduler answers, and ValueError where a number is none that can be.
    """
    if shards is not None and shards < 1:
        raise ValueError(f"shards is {shards}, and at least 1 is needed")
    if workers is not None and workers < 1:
        raise ValueError(f"workers is {workers}, and at least 1 is needed")
    distributed = _distributed()
    # A shard may lose several workers before it is given up; what they did of it is kept.
    importlib.import_module("dask").config.set({"distributed.scheduler.allowed-failures": 10})
    client = _client(distributed, scheduler, workers)
    try:
        threads = sum(client.nthreads().values())
        count = shards or 8 * max(1, threads)
        words = [program, command, str(Path(folder).resolve()), "--out", str(Path(out).resolve()), "--quiet",
                   "--time-limit", str(time_limit)]
        if memory_limit is not None:
            words += ["--memory-limit", str(memory_limit)]
        words += options

        def run_shard(number: int) -> str:
            # It is sent to workers as it stands, which need not have this package.
            import subprocess  # pylint: disable=redefined-outer-name,reimported

            try:
                run = subprocess.run([*words, "--shard", f"{number}/{count}"], stdin=subprocess.DEVNULL,
                                     stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, check=False)
            except OSError as error:
                return f"{words[0]} cannot be run on this worker: {error}"
            if run.returncode == 0:
                return ""
            said = run.stderr.decode(errors="replace").strip()
            return f"plumb ended with {run.returncode}: {said[-500:]}"

        futures = [client.submit(run_shard, i, key=f"plumb-shard-{i}-of-{count}-{os.getpid()}", pure=False, retries=1)
                   for i in range(1, count + 1)]
        _tell(distributed, futures, shown)
        failed = []
        for number, future in enumerate(futures, 1):
            try:
                why = future.result()
            except Exception as error:  # pylint: disable=broad-except  # whatever ended it, the others are told
                why = f"{type(error).__name__}: {error}"
            if why:
                failed.append((number, why))
        return Shards(count, failed)
    finally:
        cluster = client.cluster
        client.close()
        if scheduler is None and cluster is not None:
            cluster.close()


def _arguments(words: Optional[Sequence[str]]) -> Tuple[argparse.Namespace, List[str]]:
    words = list(sys.argv[1:] if words is None else words)
    rest: List[str] = []
    if "--" in words:
        at = words.index("--")
        words, rest = words[:at], words[at + 1:]
    parser = argparse.ArgumentParser(prog="python -m plumb.corpus",
                                     description="Check a folder of very many models, in shards that Dask shares out.",
                                     epilog="What follows '--' are options of the command.")
    parser.add_argument("folder", metavar="FOLDER", help="the models")
    parser.add_argument("--out", required=True, metavar="DIR", help="where the lines of the shards go")
    parser.add_argument("--command", default="check", choices=("check", "clash", "repair"),
                        help="what plumb does with each model; else check")
    parser.add_argument("--shards", type=int, metavar="N", help="how many parts; else eight for each thread of a worker")
    parser.add_argument("--scheduler", metavar="ADDRESS", help="of a Dask cluster that is there; else this machine")
    parser.add_argument("--workers", type=int, metavar="N", help="shards at once on this machine; else as it has processors")
    parser.add_argument("--program", default="plumb", metavar="FILE", help="plumb on the workers; else found on the path")
    parser.add_argument("--time-limit", type=float, default=600, metavar="SECONDS", help="of each model; else 600")
    parser.add_argument("--memory-limit", type=int, metavar="MIB", help="of each model; else none")
    parser.add_argument("--page", metavar="FILE", help="write the worst models as one page")
    parser.add_argument("--quiet", action="store_true", help="show no progress")
    return parser.parse_args(words), rest


def main(words: Optional[Sequence[str]] = None) -> int:
    """0 when every shard is done, 1 where one is not, 2 where nothing could be begun."""
    asked, options = _arguments(words)
    here = shutil.which(asked.program)
    if asked.scheduler is None and here is None:
        print(f"plumb.corpus: there is no program {asked.program}; install Plumb, or name it by '--program FILE'",
              file=sys.stderr)
        return 2
    try:
        shards = run_shards(asked.folder, asked.out, shards=asked.shards, scheduler=asked.scheduler,
                            program=os.path.abspath(here) if here and asked.scheduler is None else asked.program,
                            time_limit=asked.time_limit, memory_limit=asked.memory_limit, workers=asked.workers,
                            command=asked.command, options=options, shown=not asked.quiet)
    except (ImportError, ConnectionError, ValueError) as error:
        print(error, file=sys.stderr)
        return 2
    for number, why in shards.failed[:10]:
        print(f"plumb.corpus: shard {number}/{shards.total}: {why}", file=sys.stderr)
    if len(shards.failed) == shards.total:
        return 2
    page = ["--page", asked.page] if asked.page else []
    if here is not None:
        sys.stdout.flush()
        collected = subprocess.run([here, "collect", asked.out, *page], check=False).returncode
        return max(collected, 1 if shards.failed else 0)
    print(f"{shards.total - len(shards.failed)} of {shards.total} shards are done; 'plumb collect {asked.out}' tells")
    return 1 if shards.failed else 0


if __name__ == "__main__":
    sys.exit(main())
