"""Panels of curves over logarithmic axes as SVG; the same numbers make the same file, byte by byte."""
import math

COLUMNS, WIDTH, HEIGHT = 4, 190, 150  # panels per row, size of a panel without its margins
LEFT, TOP, RIGHT, BOTTOM, HEAD = 46, 22, 10, 24, 34


def decades(values):
    return math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))


def line(x1, y1, x2, y2, colour, extra=""):
    return f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{colour}"{extra}/>'


def text(x, y, what, anchor="middle"):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{what}</text>'


def power(decade):
    return f"{10**decade}" if 0 <= decade <= 3 else f"1e{decade}"


def dashes(pattern):
    return f' stroke-dasharray="{pattern}"' if pattern else ""


def panel(left, top, title, curves, methods, x_range, y_range):
    def x(value):
        return left + WIDTH * (math.log10(value) - x_range[0]) / (x_range[1] - x_range[0])

    def y(value):
        return top + HEIGHT * (y_range[1] - math.log10(value)) / (y_range[1] - y_range[0])

    yield text(left + WIDTH / 2, top - 6, title)
    for low, high, is_x in ((*x_range, True), (*y_range, False)):
        for decade in range(low, high + 1):
            for digit in range(1, 10 if decade < high else 2):
                value = digit * 10.0**decade
                colour = "#bbbbbb" if digit == 1 else "#eeeeee"
                if is_x:
                    yield line(x(value), top, x(value), top + HEIGHT, colour)
                else:
                    yield line(left, y(value), left + WIDTH, y(value), colour)
            if is_x:
                yield text(x(10.0**decade), top + HEIGHT + 14, power(decade))
            else:
                yield text(left - 4, y(10.0**decade) + 4, power(decade), "end")
    for name, _, colour, pattern in methods:
        points = curves.get(name, [])
        places = " ".join(f"{x(a):.1f},{y(b):.1f}" for a, b in points)
        if points:
            yield f'<polyline points="{places}" fill="none" stroke="{colour}" stroke-width="1.5"{dashes(pattern)}/>'
        for a, b in points:
            yield f'<circle cx="{x(a):.1f}" cy="{y(b):.1f}" r="2" fill="{colour}"/>'


def draw(name, panels, methods):
    """panels: {title: {method: [(x, y)]}}; methods: (name, text, colour, dashes) of each curve."""
    points = [p for curves in panels.values() for curve in curves.values() for p in curve]
    x_range, y_range = decades([p[0] for p in points]), decades([p[1] for p in points])
    columns = min(COLUMNS, len(panels))
    step_x, step_y = LEFT + WIDTH + RIGHT, TOP + HEIGHT + BOTTOM
    width, height = columns * step_x, HEAD + (len(panels) + columns - 1) // columns * step_y
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
           f'viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="11">',
           f'<rect width="{width}" height="{height}" fill="white"/>']
    at = LEFT
    for _, label, colour, pattern in methods:
        out += [line(at, 16, at + 24, 16, colour, ' stroke-width="2"' + dashes(pattern)),
                text(at + 30, 20, label, "start")]
        at += 46 + 6 * len(label)
    for k, (title, curves) in enumerate(panels.items()):
        left, top = LEFT + k % columns * step_x, HEAD + TOP + k // columns * step_y
        out += panel(left, top, title, curves, methods, x_range, y_range)
    out.append("</svg>\n")
    with open(name, "w", encoding="utf-8", newline="\n") as file:
        file.write("\n".join(out))
