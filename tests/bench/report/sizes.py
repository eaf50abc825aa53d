"""Draws how time grows with size, as SVG on standard output, from the JSON of bench_sizes (standard input).

A panel a question; beside each method's name the power of the size with which its time grows, by least squares.
--table prints the same figures as a table in Markdown. Of repetitions the medians are taken.
"""
import json
import statistics
import sys

from size_curves import panel, picture, short, slope

# What a question's panel is called, what its sizes count, and whether its time is for each of these.
QUESTIONS = {
    "polygon": ("a point in a jagged polygon, ns", "corners", False),
    "convex": ("a point in a convex polygon, ns", "corners", False),
    "nearest": ("the nearest triangle of a mesh, ns", "triangles", False),
    "hull2": ("hull of points of a disk, ns a point", "points", True),
    "hull3": ("hull of points of a ball, ns a point", "points", True),
    "ball": ("smallest ball around points of a ball, ns a point", "points", True),
    "relate": ("do two convex polyhedra overlap? they do, ns", "vertices of each", False),
    "relate apart": ("do two convex polyhedra overlap? they are apart, ns", "vertices of each", False),
    "distance": ("how far apart are they? ns", "vertices of each", False),
    "pairs": ("triangles of two meshes that meet, ns a triangle", "triangles of each", True),
}


def figures(run):
    """{question: {method: [(size, ns), ...] ascending}}"""
    samples = {}
    for b in run["benchmarks"]:
        family, *rest = b.get("run_name", b["name"]).split("/")
        if family == "sizes" and b.get("run_type") != "aggregate" and b["ns"] > 0:
            samples.setdefault(rest[0], {}).setdefault(rest[2], {}).setdefault(int(rest[1]), []).append(b["ns"])
    return {question: {method: sorted((n, statistics.median(v)) for n, v in by.items()) for method, by in methods.items()}
            for question, methods in samples.items()}


def growth(question, curve):
    """n^1.02, where there is more than one size; a time for each of n is n times as much in all."""
    return f"n^{slope(curve) + QUESTIONS[question][2]:.2f}" if len(curve) > 1 else ""


def table(found):
    for question, methods in found.items():
        title, counted, _ = QUESTIONS[question]
        sizes = sorted({n for curve in methods.values() for n, _ in curve})
        print(f"| {title}, by {counted} | " + " | ".join(f"{n:,}" for n in sizes) + " | grows as |")
        print("| --- |" + " ---: |" * (len(sizes) + 1))
        for method, curve in methods.items():
            by = dict(curve)
            print(f"| {method} | " + " | ".join(short(by[n]) if n in by else "" for n in sizes)
                  + f" | {growth(question, curve)} |")
        print()


def main():
    try:
        run = json.load(sys.stdin)
        found = {q: m for q, m in figures(run).items() if q in QUESTIONS}
    except (ValueError, KeyError, TypeError, IndexError) as fault:
        sys.exit(f"sizes.py: this is not the JSON of bench_sizes: {fault}")
    if not found:
        sys.exit("sizes.py: there is no benchmark named sizes/...")
    if "--table" in sys.argv:
        return table(found)
    lines = []
    for i, question in enumerate(q for q in QUESTIONS if q in found):
        title, counted, _ = QUESTIONS[question]
        curves = {f"{method} {growth(question, curve)}": curve for method, curve in found[question].items()}
        lines += panel((70 + i % 3 * 380, 100 + i // 3 * 350, 290, 180), title, curves, counted)
    rows = (len(found) + 2) // 3
    print(picture(1180, 90 + 350 * rows, "How time grows with size", f"one thread; {run.get('context', {}).get('date', '')}", lines))


main()
