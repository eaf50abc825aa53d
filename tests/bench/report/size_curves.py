"""Curves of time, or of anything, against size: panels of an SVG picture whose axes are logarithmic."""
import html
import math

COLORS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"]
STYLE = """text{font:13px system-ui,sans-serif;fill:#222}.title{font-size:16px;font-weight:600}.small{font-size:12px;fill:#555}
.grid{stroke:#ddd}.page{fill:#fff}path{fill:none;stroke-width:2}
@media (prefers-color-scheme: dark){text{fill:#e8e8e8}.small{fill:#aaa}.grid{stroke:#3a3a3a}.page{fill:#181818}}"""


def short(x):
    return f"{x:.3g}" if x < 1000 else f"{x:,.0f}"


def slope(curve):
    """The power of the size with which a curve grows, by least squares of the logarithms."""
    logs = [(math.log(n), math.log(v)) for n, v in curve]
    x, y = (sum(part) / len(logs) for part in zip(*logs))
    return sum((a - x) * (b - y) for a, b in logs) / sum((a - x) ** 2 for a, _ in logs)


def panel(box, title, curves, sizes):
    """Lines of SVG: in the box (left, top, width, height) the curves {label: [(size, value), ...]} over powers of ten,
    their labels below. `sizes` says what is counted along the axis."""
    left, top, width, height = box
    right, bottom = left + width, top + height
    points = [p for curve in curves.values() for p in curve]
    x0, x1 = (math.log10(end(n for n, _ in points)) for end in (min, max))
    y0, y1 = math.floor(math.log10(min(v for _, v in points))), math.ceil(math.log10(max(v for _, v in points)))
    x1, y1 = max(x1, x0 + 1), max(y1, y0 + 1)
    at = lambda n, v: (left + (math.log10(n) - x0) / (x1 - x0) * width,
                       bottom - (math.log10(v) - y0) / (y1 - y0) * height)
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
    out.append(f'<text class="small" x="{(left + right) / 2}" y="{bottom + 38}" text-anchor="middle">{sizes}</text>')
    for i, (label, curve) in enumerate(curves.items()):
        color, label = COLORS[i % len(COLORS)], html.escape(label)
        dashes = ' stroke-dasharray="6 4"' if i >= len(COLORS) else ""
        places = [at(*p) for p in curve]
        out.append(f'<path stroke="{color}"{dashes} d="M' + " L".join(f"{x:.1f} {y:.1f}" for x, y in places) + '"/>')
        for (x, y), (n, v) in zip(places, curve):
            out.append(f'<circle data-curve="{label}" cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{color}">'
                       f"<title>{label}: {short(v)} at {n:,}</title></circle>")
        y = bottom + 62 + 20 * i
        out.append(f'<path stroke="{color}"{dashes} d="M{left - 10} {y - 4} L{left + 12} {y - 4}"/>'
                   f'<text x="{left + 18}" y="{y}">{label}</text>')
    return out


def picture(width, height, title, about, lines):
    """The whole SVG, with the lines of its panels."""
    return "\n".join([f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}">',
                      f"<style>{STYLE}</style>", f'<rect class="page" width="{width}" height="{height}"/>',
                      f'<text class="title" x="70" y="34">{html.escape(title)}</text>',
                      f'<text class="small" x="70" y="54">{html.escape(about)}</text>', *lines, "</svg>"])
