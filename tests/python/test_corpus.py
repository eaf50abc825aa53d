"""Shards of a corpus on Dask: on this machine, on a scheduler with two workers of which one is lost; what is missing."""

import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from plumb import corpus

TREE = Path(__file__).resolve().parents[2]


def program():
    """The one that is tested, or a build's; what is not there is told by its name."""
    named = os.environ.get("PLUMB_TESTED_PROGRAM")
    places = [named] if named else [TREE / "build" / preset / "src/tool/plumb" for preset in ("test", "release")]
    for place in places:
        if Path(place).exists():
            return str(place)
    found = shutil.which("plumb")
    if found is None:
        pytest.skip("the program plumb is not built here: PLUMB_TESTED_PROGRAM names one")
    return found


def distributed():
    return pytest.importorskip("distributed", reason="python3-distributed is not installed")


MODELS = 24


@pytest.fixture(name="models")
def small_models(tmp_path):
    """Sheets, one file that is no mesh, and three that hang: nobody ever writes into these pipes."""
    folder = tmp_path / "models"
    (folder / "more").mkdir(parents=True)
    for k in range(MODELS - 4):
        name = folder / ("more" if k % 2 else "") / f"sheet{k}.obj"
        name.write_text(f"v 0 0 0\nv {k + 1} 0 0\nv 0 1 0\nf 1 2 3\n")
    (folder / "broken.stl").write_text("solid none\nfacet\n")
    for k in range(3):
        os.mkfifo(folder / f"endless{k}.obj")
    return folder


LIMITS = ["--time-limit", "1"]


def digest(out):
    told = subprocess.run([program(), "collect", str(out)], capture_output=True, text=True, check=False)
    assert told.returncode == 0, told.stdout + told.stderr
    last = told.stdout.splitlines()[-1]
    assert f"of {MODELS} models" in last
    return last


def digest_of_one(models, out):
    subprocess.run([program(), "check", str(models), "--shard", "1/1", "--out", str(out), "--quiet", *LIMITS], check=True)
    return digest(out)


def run_module(*words, env=None):
    package = str(Path(corpus.__file__).resolve().parents[1])
    return subprocess.run([sys.executable, "-m", "plumb.corpus", *map(str, words)], capture_output=True, text=True,
                          check=False, env={**os.environ, "PYTHONPATH": package, **(env or {})})


def test_on_this_machine(models, tmp_path):
    distributed()
    run = run_module(models, "--out", tmp_path / "out", "--program", program(), "--shards", 5, "--workers", 2, *LIMITS,
                     "--page", tmp_path / "page.html")
    assert run.returncode == 0, run.stderr
    assert "5 of 5 shards" in run.stdout
    assert run.stdout.splitlines()[-1] == digest_of_one(models, tmp_path / "one")
    assert "endless1.obj" in (tmp_path / "page.html").read_text()
    again = corpus.run_shards(str(models), str(tmp_path / "out"), shards=5, program=program(), time_limit=1)
    assert again == corpus.Shards(5, [])  # nothing was left to do


def started(words, log):
    # A session of its own, so that all of it is lost at once.
    return subprocess.Popen([sys.executable, "-m", *words], stdout=log, stderr=log, start_new_session=True)


def end(process):
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass
    process.wait()


@pytest.mark.parametrize("lost", ["the worker alone", "the worker and its shard"])
def test_outlives_a_worker(models, tmp_path, lost):
    distributed()
    address = tmp_path / "scheduler.json"
    processes = []
    with open(tmp_path / "log", "w", encoding="utf-8") as log:
        try:
            processes.append(started(["distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", "0",
                                      "--no-dashboard", "--scheduler-file", str(address)], log))
            until = time.monotonic() + 60
            while not address.exists() or not address.read_text():
                assert time.monotonic() < until, (tmp_path / "log").read_text()
                time.sleep(0.1)
            for _ in range(2):
                processes.append(started(["distributed.cli.dask_worker", "--no-nanny", "--nthreads", "1", "--no-dashboard",
                                          "--memory-limit", "0", "--scheduler-file", str(address)], log))
            client = distributed().Client(scheduler_file=str(address), timeout=60)
            client.wait_for_workers(2, timeout=60)
            at = client.scheduler.address
            client.close()
            out = tmp_path / "out"
            package = str(Path(corpus.__file__).resolve().parents[1])
            run = subprocess.Popen([sys.executable, "-m", "plumb.corpus", str(models), "--out", str(out), "--scheduler", at,
                                    "--program", program(), "--shards", "6", *LIMITS], stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True, env={**os.environ, "PYTHONPATH": package})
            until = time.monotonic() + 60
            while not list(out.glob("check.*.jsonl")):
                assert time.monotonic() < until and run.poll() is None, (tmp_path / "log").read_text()
                time.sleep(0.02)
            assert run.poll() is None  # in the middle
            if lost == "the worker alone":
                os.kill(processes[1].pid, signal.SIGKILL)
            else:
                end(processes[1])
            said, errors = run.communicate(timeout=240)
            assert run.returncode == 0, said + errors
            assert said.splitlines()[-1] == digest_of_one(models, tmp_path / "one")
        finally:
            for process in processes:
                end(process)


def test_tells_what_is_missing(models, tmp_path):
    (tmp_path / "without").mkdir()
    (tmp_path / "without" / "distributed.py").write_text("raise ImportError('no module')\n")
    package = str(Path(corpus.__file__).resolve().parents[1])
    run = run_module(models, "--out", tmp_path / "out", "--program", program(),
                     env={"PYTHONPATH": f"{tmp_path / 'without'}:{package}"})
    assert run.returncode == 2
    assert "python3-distributed" in run.stderr and "Traceback" not in run.stderr
    run = run_module(models, "--out", tmp_path / "out", "--program", tmp_path / "nothing")
    assert run.returncode == 2 and "there is no program" in run.stderr


def test_refuses_what_cannot_be(models, tmp_path):
    distributed()
    with pytest.raises(ValueError, match="shards is 0"):
        corpus.run_shards(str(models), str(tmp_path / "out"), shards=0)
    with pytest.raises(ValueError, match="workers is -1"):
        corpus.run_shards(str(models), str(tmp_path / "out"), workers=-1)
    run = run_module(models, "--out", tmp_path / "out", "--program", program(), "--scheduler", "tcp://127.0.0.1:1")
    assert run.returncode == 2 and "no scheduler of Dask answers" in run.stderr
    nowhere = corpus.run_shards(str(tmp_path / "nowhere"), str(tmp_path / "out"), shards=2, program=program(), workers=1)
    assert [number for number, _ in nowhere.failed] == [1, 2]
    assert "of a folder" in nowhere.failed[0][1]
    run = run_module(models, "--out", tmp_path / "out", "--program", program(), "--shards", 1, "--", "--nobody")
    assert run.returncode == 2 and "--nobody" in run.stderr
