"""Prints a Markdown table of benchmarks' JSON (the files named, or standard input): ns for each predicate/class, one column a method.

With --benchmark_repetitions the medians are taken.  A method's column is followed by its ratio to the first and, where
there is an 'epick', by how many times faster than that it is.
"""
import json
import statistics
import sys

samples = {}
runs = [json.load(open(path))["benchmarks"] for path in sys.argv[1:]] or [json.load(sys.stdin)["benchmarks"]]
for run in sum(runs, []):
    if run.get("run_type") != "aggregate":
        samples.setdefault(tuple(run["run_name"].split("/")), []).append(run["ns"])
table = {}
for (predicate, inputs, method), ns in samples.items():
    table.setdefault((predicate, inputs), {})[method] = statistics.median(ns)
methods = list(dict.fromkeys(m for row in table.values() for m in row))
rival = "epick" in methods
print("| predicate | inputs | " + " | ".join(methods) + (" | plumb / bare | epick / plumb |" if rival else " |"))
print("| --- | --- |" + " ---: |" * (len(methods) + 2 * rival))
for (predicate, inputs), row in table.items():
    cells = [f"{row[m]:.1f}" if m in row else "" for m in methods]
    if rival:
        for over, under, digits in (("plumb", "bare", 2), ("epick", "plumb", 1)):
            cells.append(f"{row[over] / row[under]:.{digits}f}" if over in row and under in row else "")
    print(f"| {predicate} | {inputs} | " + " | ".join(cells) + " |")
