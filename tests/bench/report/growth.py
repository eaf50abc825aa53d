"""Draws how indexes grow, as SVG on standard output, from the JSON of bench_growth or bench_crowd_growth (standard input).

growth.py FAMILY: 'growth' (trees of triangles), 'pairs_growth' (all pairs of boxes) or 'points_growth' (trees of points).
Left: nanoseconds, right: bytes, both for each thing, against the number of things; the axes are logarithmic.
--table prints the same figures as a table in Markdown. Of repetitions the medians are taken.
"""
import json
import statistics
import sys

from size_curves import panel, picture, short

# Of each family: the title, what is measured, what is counted (many, one, and what is asked), the times and the bytes by
# their names.  A name of bytes is BENCHMARK:COUNTER.
FAMILIES = {
    "growth": ("How trees grow with the mesh", "a closed wavy ring, one thread", ("triangles", "triangle", "ray"),
               {"build_binned": "build, binned", "build_linear": "build, linear", "rays_random": "random rays, together",
                "rays_random_single": "random rays, one at a time", "rays_camera": "camera rays, together"},
               {"build_binned:bytes": "the tree, mesh included", "build_binned:peak": "most while it is built (binned)"}),
    "pairs_growth": ("How long all pairs of boxes take", "uniform boxes, some 8 pairs each, one thread", ("boxes", "box", "box"),
                     {name: name.replace("_", " ") for name in (
                         "swept_columns", "sort_and_sweep", "static_grid", "hashed_grid", "hierarchical_grid", "octree",
                         "loose_octree", "box_tree", "implicit_grid", "lists_along_one", "brute_force")},
                     {f"{name}:peak": name.replace("_", " ") for name in (
                         "swept_columns", "sort_and_sweep", "static_grid", "hashed_grid", "hierarchical_grid", "octree",
                         "loose_octree", "box_tree")}),
    "points_growth": ("How trees of points grow", "uniform points, one thread", ("points", "point", "query"),
                      {"build_kd_tree": "build, k-d tree", "build_octree": "build, octree",
                       "nearest": "the nearest, one query at a time", "nearest_8": "the nearest 8"},
                      {"build_kd_tree:bytes": "the k-d tree, points included"}),
}


def figures(run, family, names):
    """{name: [(things, value), ...] ascending}, by `names`."""
    samples = {}
    for b in run["benchmarks"]:
        own, *rest = b.get("run_name", b["name"]).split("/")
        if own != family or b.get("run_type") == "aggregate":
            continue
        things, what = int(rest[0]), rest[1]
        values = {what: b["ns"]} | {f"{what}:{c}": b[c] / (things if c == "peak" else 1) for c in ("bytes", "peak") if c in b}
        for name in names & values.keys():
            samples.setdefault(name, {}).setdefault(things, []).append(values[name])
    return {name: sorted((n, statistics.median(v)) for n, v in by.items()) for name, by in samples.items()}


def table(found, times, sizes_of, counted, one, asked):
    sizes = sorted({n for points in found.values() for n, _ in points})
    print(f"| {counted} | " + " | ".join(f"{n:,}" for n in sizes) + " |")
    print("| --- |" + " ---: |" * len(sizes))
    for name, label in (times | sizes_of).items():
        if name in found:
            by = dict(found[name])
            unit = f"bytes a {one}" if name in sizes_of else f"ns a {one if name.startswith('build') else asked}"
            print(f"| {label}: {unit} | " + " | ".join(short(by[n]) if n in by else "" for n in sizes) + " |")


def shown(names, found, title):
    curves = {label: [p for p in found[name] if p[1] > 0] for name, label in names.items() if name in found}
    if not any(curves.values()):
        sys.exit(f"growth.py: nothing was measured for '{title}'")
    return curves


def main():
    asked = [a for a in sys.argv[1:] if a != "--table"]
    family = asked[0] if asked else "growth"
    if len(asked) > 1 or family not in FAMILIES:
        sys.exit(f"growth.py: one of {', '.join(FAMILIES)}, and --table")
    title, about, (counted, *single), times, sizes_of = FAMILIES[family]
    try:
        run = json.load(sys.stdin)
        found = figures(run, family, times.keys() | sizes_of.keys())
    except (ValueError, KeyError, TypeError, IndexError) as fault:
        sys.exit(f"growth.py: this is not the JSON of bench_growth or bench_crowd_growth: {fault}")
    if not found:
        sys.exit(f"growth.py: there is no benchmark named {family}/...")
    if "--table" in sys.argv:
        return table(found, times, sizes_of, counted, *single)
    lines = []
    for left, width, words, names in ((70, 500, f"nanoseconds a {' or '.join(dict.fromkeys(single))}", times),
                                      (660, 290, f"bytes a {single[0]}", sizes_of)):
        lines += panel((left, 92, width, 328), words, shown(names, found, words), counted)
    print(picture(980, 490 + 20 * max(len(times), len(sizes_of)), title,
                  f"{about}; {run.get('context', {}).get('date', '')}", lines))


main()
