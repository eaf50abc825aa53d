"""Draws how trees grow, as SVG on standard output, from the JSON of bench_growth (standard input).

Left: nanoseconds to build a triangle of the tree and to ask a ray, against the number of triangles. Right: bytes a
triangle that the tree keeps, and the most that the process held while it was built. Both axes are logarithmic.
--table prints the same figures as a table in Markdown. Of repetitions the medians are taken.
"""
import json
import statistics
import sys

from size_curves import panel, picture, short

TIMES = {"build_binned": "build, binned", "build_linear": "build, linear", "rays_random": "random rays, together",
         "rays_random_single": "random rays, one at a time", "rays_camera": "camera rays, together"}
BYTES = {"bytes": "the tree, mesh included", "peak": "most while it is built (binned)"}

def figures(run):
    """{name: [(triangles, value), ...] ascending}, by the names of TIMES and BYTES."""
    samples = {}
    for b in run["benchmarks"]:
        family, *rest = b.get("run_name", b["name"]).split("/")
        if family != "growth" or b.get("run_type") == "aggregate":
            continue
        triangles, what = int(rest[0]), rest[1]
        values = {what: b["ns"]}
        if what == "build_binned":
            values |= {"bytes": b["bytes"], "peak": b["peak"] / triangles}
        for name, value in values.items():
            samples.setdefault(name, {}).setdefault(triangles, []).append(value)
    return {name: sorted((n, statistics.median(v)) for n, v in by.items()) for name, by in samples.items()}


def table(found):
    sizes = sorted({n for points in found.values() for n, _ in points})
    print("| triangles | " + " | ".join(f"{n:,}" for n in sizes) + " |")
    print("| --- |" + " ---: |" * len(sizes))
    for name, label in {**TIMES, **BYTES}.items():
        if name in found:
            unit = "bytes a triangle" if name in BYTES else "ns a triangle" if name.startswith("build") else "ns a ray"
            by = dict(found[name])
            print(f"| {label}: {unit} | " + " | ".join(short(by[n]) if n in by else "" for n in sizes) + " |")


def shown(names, found, title):
    curves = {label: [p for p in found[name] if p[1] > 0] for name, label in names.items() if name in found}
    if not any(curves.values()):
        sys.exit(f"growth.py: nothing was measured for '{title}'")
    return curves


def main():
    try:
        run = json.load(sys.stdin)
        found = figures(run)
    except (ValueError, KeyError, TypeError, IndexError) as fault:
        sys.exit(f"growth.py: this is not the JSON of bench_growth: {fault}")
    if not found:
        sys.exit("growth.py: there is no benchmark named growth/...")
    if "--table" in sys.argv:
        return table(found)
    lines = []
    for left, width, title, names in ((70, 500, "nanoseconds a triangle built, a ray asked", TIMES),
                                      (660, 290, "bytes a triangle", BYTES)):
        lines += panel((left, 92, width, 328), title, shown(names, found, title), "triangles")
    print(picture(980, 590, "How trees grow with the mesh",
                  f"a closed wavy ring, one thread; {run.get('context', {}).get('date', '')}", lines))


main()
