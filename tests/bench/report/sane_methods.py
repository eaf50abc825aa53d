"""Is any method wrong on half of what is harmless? Reads a `chart.json` (standard input), of class `uniform`.

Who is, is asked in the wrong way, or told what it does not understand, and says nothing of the method. Of numbers that are
not the nearest double one is wrong that is far off: by more than 2^42 doubles, one part in a thousand, in the mean.
"""
import json
import sys

trials = [t for t in json.load(sys.stdin)["trials"] if t["class"] == "uniform"]
broken = [f"{t['task']}: {m['method']}" for t in trials for m in t["methods"]
          if (m["mean_ulps"] > 2**42 if t["answer"] == "number" else 2 * m["wrong"] > m["asked"])]
if not trials:
    sys.exit("sane_methods.py: nothing was asked of the class uniform")
if broken:
    sys.exit("sane_methods.py: wrong on half of the class uniform: " + "; ".join(broken))
print(f"{sum(len(t['methods']) for t in trials)} methods of {len(trials)} tasks are sane")
