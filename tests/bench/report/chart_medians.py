"""Prints the figures of a `chart.json` (standard input) that are kept: wrong answers of how many, and median ns.

One object a machine: how it was measured, then for each "task, class" each method's [wrong, asked, ns]. The line of a
class is a line of the file, so that two runs differ where they differ.
"""
import json
import sys

run = json.load(sys.stdin)
trials = run.pop("trials")
rows = {}
for trial in trials:
    rows[f"{trial['task']}, {trial['class']}"] = {
        m["method"]: [m["wrong"], m["asked"], float(f"{m['query_ns']:.3g}")] for m in trial["methods"]
    }
head = ",\n".join(f"{json.dumps(key)}: {json.dumps(value)}" for key, value in run.items())
body = ",\n".join(f"{json.dumps(key)}: {json.dumps(value, separators=(',', ':'))}" for key, value in rows.items())
print(f"{{\n{head},\n\"medians\": {{\n{body}\n}}}}")
