"""Draws how trees grow, as SVG on standard output, from the JSON of bench_growth (standard input).

Left: nanoseconds to build a triangle of the tree and to ask a ray, against the number of triangles. Right: bytes a
triangle that the tree keeps, and the most that the process held while it was built. Both axes are logarithmic.
--table prints the same figures as a table in Markdown. Of repetitions the medians are taken.
"""
import html
import json
import math
import statistics
import sys

TIMES = {"build_binned": "build, binned", "build_linear": "build, linear", "rays_random": "random rays, together",
         "rays_random_single": "random rays, one at a time", "rays_camera": "camera rays, together"}
BYTES = {"bytes": "the tree, mesh included", "peak": "most while it is built (binned)"}
COLORS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00"]
STYLE = """text{font:13px system-ui,sans-serif;fill:#222}.title{font-size:16px;font-weight:600}.small{font-size:12px;fill:#555}
.grid{stroke:#ddd}.page{fill:#fff}path{fill:none;stroke-width:2}
@media (prefers-color-scheme: dark){text{fill:#e8e8e8}.small{fill:#aaa}.grid{stroke:#3a3a3a}.page{fill:#181818}}"""


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


def short(x):
    return f"{x:.3g}" if x < 1000 else f"{x:,.0f}"


def table(found):
    sizes = sorted({n for points in found.values() for n, _ in points})
    print("| triangles | " + " | ".join(f"{n:,}" for n in sizes) + " |")
    print("| --- |" + " ---: |" * len(sizes))
    for name, label in {**TIMES, **BYTES}.items():
        if name in found:
            unit = "bytes a triangle" if name in BYTES else "ns a triangle" if name.startswith("build") else "ns a ray"
            by = dict(found[name])
            print(f"| {label}: {unit} | " + " | ".join(short(by[n]) if n in by else "" for n in sizes) + " |")


def panel(left, width, title, names, found):
    """The curves of these names over a grid of powers of ten."""
    top, bottom, right = 92, 420, left + width
    shown = {name: [p for p in found[name] if p[1] > 0] for name in names if name in found}
    points = [p for curve in shown.values() for p in curve]
    if not points:
        sys.exit(f"growth.py: nothing was measured for '{title}'")
    ends = [(math.log10(min(v)), math.log10(max(v))) for v in zip(*points)]
    (x0, x1), (y0, y1) = ends[0], (math.floor(ends[1][0]), math.ceil(ends[1][1]))
    x1, y1 = max(x1, x0 + 1), max(y1, y0 + 1)
    at = lambda n, v: (left + (math.log10(n) - x0) / (x1 - x0) * width, bottom - (math.log10(v) - y0) / (y1 - y0) * (bottom - top))
    out = [f'<text class="small" x="{left}" y="{top - 14}">{html.escape(title)}</text>']
    for power in range(y0, y1 + 1):
        y = at(10**x0, 10**power)[1]
        out.append(f'<line class="grid" x1="{left}" x2="{right}" y1="{y:.1f}" y2="{y:.1f}"/>'
                   f'<text class="small" x="{left - 8}" y="{y + 4:.1f}" text-anchor="end">{10**power:,g}</text>')
    for power in range(math.ceil(x0 - 0.05), math.floor(x1 + 0.05) + 1):
        x = min(max(at(10**power, 10**y0)[0], left), right)
        out.append(f'<line class="grid" x1="{x:.1f}" x2="{x:.1f}" y1="{top}" y2="{bottom}"/>'
                   f'<text class="small" x="{x:.1f}" y="{bottom + 18}" text-anchor="middle">10'
                   f'<tspan dy="-5" font-size="9">{power}</tspan></text>')
    out.append(f'<text class="small" x="{(left + right) / 2}" y="{bottom + 38}" text-anchor="middle">triangles</text>')
    for i, (name, curve) in enumerate(shown.items()):
        color, label = COLORS[i], html.escape({**TIMES, **BYTES}[name])
        places = [at(*p) for p in curve]
        out.append(f'<path stroke="{color}" d="M' + " L".join(f"{x:.1f} {y:.1f}" for x, y in places) + '"/>')
        for (x, y), (n, v) in zip(places, curve):
            out.append(f'<circle data-key="{name}" cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{color}">'
                       f"<title>{label}: {short(v)} at {n:,} triangles</title></circle>")
        y = bottom + 62 + 20 * i
        out.append(f'<circle cx="{left + 5}" cy="{y - 4}" r="5" fill="{color}"/><text x="{left + 18}" y="{y}">{label}</text>')
    return out


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
    date = html.escape(str(run.get("context", {}).get("date", "")))
    lines = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 980 590" width="980" height="590">',
             f"<style>{STYLE}</style>", '<rect class="page" width="980" height="590"/>',
             '<text class="title" x="70" y="34">How trees grow with the mesh</text>',
             f'<text class="small" x="70" y="54">a closed wavy ring, one thread; {date}</text>']
    lines += panel(70, 500, "nanoseconds a triangle built, a ray asked", TIMES, found)
    lines += panel(660, 290, "bytes a triangle", BYTES, found)
    print("\n".join(lines + ["</svg>"]))


main()
