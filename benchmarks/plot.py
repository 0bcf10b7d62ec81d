"""Curves over logarithmic axes, as SVG."""
import math
from xml.sax.saxutils import escape

WIDTH, HEIGHT = 440, 340  # of a chart [px]
LEFT, RIGHT, TOP, BOTTOM = 56, 12, 30, 112  # around its axes [px]
COLOURS = ("#0b6e99", "#c2571a", "#3d7d3d", "#8a3f8f", "#a08a1a", "#555555", "#e05080", "#2f4fb0", "#20b0a0", "#e0a040")


def plot(charts):
    """Charts side by side: (title, what is along x, {curve: [(x, seconds), ...]})."""
    body = "".join(
        f'<g transform="translate({i * WIDTH} 0)">{chart(*each)}</g>' for i, each in enumerate(charts)
    )
    size = f'width="{WIDTH * len(charts)}" height="{HEIGHT}"'
    style = 'font-family="sans-serif" font-size="11"'
    ground = '<rect width="100%" height="100%" fill="white"/>'
    return f'<svg xmlns="http://www.w3.org/2000/svg" {size} {style}>{ground}{body}</svg>\n'


def decades(values):
    low, high = math.floor(math.log10(min(values)) + 1e-9), math.ceil(math.log10(max(values)) - 1e-9)
    return low, max(high, low + 1)


def tick(value):
    return f"{value:g}" if 1e-3 <= value < 1e4 else f"1e{math.log10(value):.0f}"


def chart(title, along, curves):
    curves = {name: [(x, y) for x, y in points if y > 0] for name, points in curves.items()}
    points = [point for curve in curves.values() for point in curve]
    along_x = sorted({x for x, _ in points})
    left, right = math.log10(along_x[0]), max(math.log10(along_x[-1]), math.log10(along_x[0]) + 0.1)
    low, high = decades([y for _, y in points])

    def at(x, y):
        return (
            LEFT + (math.log10(x) - left) / (right - left) * (WIDTH - LEFT - RIGHT),
            HEIGHT - BOTTOM - (math.log10(y) - low) / (high - low) * (HEIGHT - TOP - BOTTOM),
        )

    parts = [f'<text x="{LEFT}" y="18" font-size="13">{escape(title)}</text>']
    for value in along_x:
        x, _ = at(value, 10.0**low)
        parts.append(f'<path d="M{x:.1f} {TOP}V{HEIGHT - BOTTOM}" stroke="#ddd"/>')
        parts.append(f'<text x="{x:.1f}" y="{HEIGHT - BOTTOM + 14}" text-anchor="middle">{tick(round(value))}</text>')
    for power in range(low, high + 1):
        _, y = at(10.0**left, 10.0**power)
        parts.append(f'<path d="M{LEFT} {y:.1f}H{WIDTH - RIGHT}" stroke="#ddd"/>')
        parts.append(f'<text x="{LEFT - 5}" y="{y + 4:.1f}" text-anchor="end">{tick(10.0**power)} s</text>')
    parts.append(f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - BOTTOM + 28}" text-anchor="middle">{escape(along)}</text>')
    for number, (name, curve) in enumerate(curves.items()):
        parts.append(line(number, name, [at(*point) for point in curve]))
    return "".join(parts)


def line(number, name, places):
    """A curve with its entry in the legend, of two columns."""
    colour = COLOURS[number % len(COLOURS)]
    path = "L".join(f"{x:.1f} {y:.1f}" for x, y in places)
    dots = "".join(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.5" fill="{colour}"/>' for x, y in places)
    x, y = LEFT - 40 + number % 2 * 200, HEIGHT - BOTTOM + 44 + number // 2 * 15
    curve = f'<path d="M{path}" fill="none" stroke="{colour}" stroke-width="1.5"/>' if places else ""
    key = f'<path d="M{x} {y - 4}h16" stroke="{colour}" stroke-width="3"/>'
    return f'{curve}{dots}{key}<text x="{x + 21}" y="{y}">{escape(name)}</text>'
