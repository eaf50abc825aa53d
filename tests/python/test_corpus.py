"""Shards of a corpus on Dask: on this machine, on a scheduler with two workers of which one is lost; what is missing; by
the job files for Slurm and GNU parallel."""

import getpass
import os
import shutil
import signal
import socket
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
    clashes = corpus.run_shards(str(models), str(tmp_path / "clashes"), shards=2, program=program(), time_limit=1,
                                command="clash", options=["--ignore", "touching"])
    assert clashes == corpus.Shards(2, [])
    assert "endless1.obj" in (tmp_path / "clashes" / "clash.1-of-2.jsonl").read_text() + (
        tmp_path / "clashes" / "clash.2-of-2.jsonl").read_text()


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


JOBS = TREE / "docs" / "examples" / "corpus"


def job_settings(models, out):
    return {**os.environ, "MODELS": str(models), "FOUND": str(out), "SHARDS": "3", "PLUMB": program()}


@pytest.mark.parametrize("name", ["slurm.sh", "parallel.sh"])
def test_job_files_are_scripts(name):
    subprocess.run(["bash", "-n", str(JOBS / name)], check=True)
    empty = subprocess.run(["bash", str(JOBS / name)], capture_output=True, text=True, check=False, env={"PATH": os.environ["PATH"]})
    assert empty.returncode != 0 and "the folder of models" in empty.stderr


def without_pipes(models):
    """The job files allow ten minutes a model."""
    for pipe in models.glob("endless*"):
        pipe.unlink()
        pipe.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")


def test_by_parallel(models, tmp_path):
    if shutil.which("parallel") is None:
        pytest.skip("GNU parallel is not installed")
    without_pipes(models)
    out = tmp_path / "out"
    run = subprocess.run([str(JOBS / "parallel.sh"), str(models), str(out), "3"], capture_output=True, text=True,
                         check=False, env=job_settings(models, out))
    assert run.returncode == 0, run.stderr
    assert run.stdout.splitlines()[-1] == digest_of_one(models, tmp_path / "one")


def slurm_on_loopback(folder, log):
    """A controller and a machine, this one; the configuration's path."""
    with socket.socket() as first, socket.socket() as second:
        first.bind(("127.0.0.1", 0))
        second.bind(("127.0.0.1", 0))
        ports = first.getsockname()[1], second.getsockname()[1]
    host, user = socket.gethostname().split(".")[0], getpass.getuser()
    for name in ("state", "spool"):
        (folder / name).mkdir()
    configuration = folder / "slurm.conf"
    configuration.write_text(f"""ClusterName=loopback
SlurmctldHost={host}(127.0.0.1)
AuthType=auth/none
CredType=cred/none
SlurmUser={user}
SlurmdUser={user}
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/controller.pid
SlurmdPidFile={folder}/machine.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
MpiDefault=none
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 RealMemory=8000 State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
""")
    return configuration, [subprocess.Popen([daemon, "-D", "-f", str(configuration)], stdout=log, stderr=log)
                           for daemon in ("slurmctld", "slurmd")]


def test_by_slurm(models, tmp_path):
    if any(shutil.which(name) is None for name in ("slurmctld", "slurmd", "sbatch", "sinfo")):
        pytest.skip("slurmctld and slurmd are not installed")
    without_pipes(models)
    out = tmp_path / "out"
    with open(tmp_path / "log", "w", encoding="utf-8") as log:
        configuration, daemons = slurm_on_loopback(tmp_path, log)
        environment = {**job_settings(models, out), "SLURM_CONF": str(configuration)}
        try:
            until, state = time.monotonic() + 30, ""
            while "idle" not in state:
                if time.monotonic() > until:
                    pytest.skip("Slurm does not start here: " + (tmp_path / "log").read_text()[-300:])
                time.sleep(0.5)
                state = subprocess.run(["sinfo", "-h"], capture_output=True, text=True, check=False, env=environment).stdout
            job = [str(JOBS / "slurm.sh")]
            tried = subprocess.run(["sbatch", "--test-only", "--array=1-3", *job], capture_output=True, text=True,
                                   check=False, env=environment, cwd=tmp_path)
            assert tried.returncode == 0, tried.stderr
            run = subprocess.run(["sbatch", "--wait", "--array=1-3", *job], capture_output=True, text=True, check=False,
                                 env=environment, cwd=tmp_path, timeout=120)
            assert run.returncode == 0, run.stderr + "".join(p.read_text() for p in tmp_path.glob("plumb-*.txt"))
        finally:
            for daemon in reversed(daemons):
                daemon.terminate()
                daemon.wait()
    assert digest(out) == digest_of_one(models, tmp_path / "one")
