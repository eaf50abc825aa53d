"""Runs the benchmarks that two builds have in common by turns, and prints what takes longer in the second.

  python3 tests/bench/report/old_and_new.py OLD/build/bench build/bench [ROUNDS [bench_NAME...]]

The least of ROUNDS runs (2 if nothing is said) of each counts, in processor time, on one core; rivals are not asked.
"""
import json
import pathlib
import statistics
import subprocess
import sys

RIVALS = "cgal|embree|bullet|fcl|boost|nanoflann|eigen|qhull|ccd_rival|libccd|epick|epeck|Cgal|Nanoflann"


def run(build, program):
    command = ["taskset", "-c", "0", build / "tests/bench" / program, "--benchmark_min_time=0.04",
               "--benchmark_format=json", f"--benchmark_filter=-({RIVALS})"]
    out = subprocess.run(command, capture_output=True, text=True, cwd=build.parents[1]).stdout
    if "{\n" not in out:  # it prints a table of its own
        return {}
    rows = json.loads(out[out.index("{\n"):])["benchmarks"]
    return {r["name"]: r["cpu_time"] for r in rows if "cpu_time" in r and not r.get("error_occurred")}


old, new = (pathlib.Path(a).resolve() for a in sys.argv[1:3])
rounds = int(sys.argv[3]) if len(sys.argv) > 3 else 2
names = {p.name for p in (old / "tests/bench").glob("bench_*") if (new / "tests/bench" / p.name).exists()}
ratios = {}
for program in sorted(names & set(sys.argv[4:]) if sys.argv[4:] else names):
    least = ({}, {})
    for _ in range(rounds):
        for times, build in zip(least, (old, new)):
            for name, time in run(build, program).items():
                times[name] = min(time, times.get(name, time))
    own = {f"{program}: {n}": least[1][n] / t for n, t in least[0].items() if t > 0 and n in least[1]}
    ratios.update(own)
    if own:
        print(f"{program:28} {len(own):4}  median {statistics.median(own.values()):.2f}", flush=True)
if not ratios:
    sys.exit("old_and_new.py: the two builds have no benchmark in common")
print(f"{len(ratios)} benchmarks, median {statistics.median(ratios.values()):.2f}; more than 1.05 times as long:")
for name, ratio in sorted(ratios.items(), key=lambda item: -item[1]):
    if ratio > 1.05:
        print(f"{ratio:6.2f}  {name}")
