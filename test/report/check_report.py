#!/usr/bin/env python3
"""Usage: check_report.py FIT_MESH MAP_MESH MESHES WORK

Opens reports of the three canonical surfaces in a browser: nothing is complained about and nothing loaded, all
views are drawn, every switch changes the picture and back, pointer and keys work, the values at a point are those
of map.ply, folds are marked, and the page fits a phone. Status 77 where no browser is installed.
"""
import colorsys
import itertools
import json
import math
import pathlib
import re
import struct
import subprocess
import sys
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from browser import Browser  # noqa: E402

failures = []


def check(holds, what):
    if not holds:
        failures.append(what)
        print("FAILED:", what)


def pixels(png):
    """The rows of a PNG file with 8 bits per channel, each a list of tuples."""
    at, data = 8, b""
    while at < len(png):
        size, kind = struct.unpack(">I4s", png[at:at + 8])
        body = png[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, _, depth, colour = struct.unpack(">IIBB", body[:10])
        elif kind == b"IDAT":
            data += body
        at += 12 + size
    assert depth == 8 and colour in (2, 6)
    n = 3 if colour == 2 else 4
    raw, before, rows = zlib.decompress(data), bytes(n * width), []
    for start in range(0, len(raw), n * width + 1):
        kind, row = raw[start], bytearray(raw[start + 1:start + 1 + n * width])
        for i in range(n * width):
            left, up, corner = (row[i - n], before[i], before[i - n]) if i >= n else (0, before[i], 0)
            if kind == 4:
                distances = [abs(up - corner), abs(left - corner), abs(left + up - 2 * corner)]
                guess = (left, up, corner)[distances.index(min(distances))]
            else:
                guess = (0, left, up, (left + up) // 2)[kind]
            row[i] = (row[i] + guess) & 255
        before = row
        rows.append([tuple(row[i:i + 3]) for i in range(0, n * width, n)])
    return rows


def read_map(path):
    """(vertex names, vertices, faces as (a, b, c, chart)) of a map.ply, the binary file that fit_mesh writes."""
    header, data = path.read_bytes().split(b"end_header\n", 1)
    lines = [line.split() for line in header.decode().splitlines()]
    counts = {line[1]: int(line[2]) for line in lines if line[0] == "element"}
    names = [line[2] for line in lines if line[:2] == ["property", "double"]]
    vertex = struct.Struct(f"<{len(names)}d")
    vertices = [vertex.unpack_from(data, i * vertex.size) for i in range(counts["vertex"])]
    face, first = struct.Struct("<Biiii"), counts["vertex"] * vertex.size
    return names, vertices, [face.unpack_from(data, first + i * face.size)[1:] for i in range(counts["face"])]


def join(path, files):
    """An OFF file with the bodies of some OFF files, one beside the other."""
    points, faces = [], []
    for k, file in enumerate(files):
        words = file.read_text().split()[1:]
        n, m = int(words[0]), int(words[1])
        first, words = len(points), words[3:]
        points += [f"{float(words[3 * i]) + 5 * k} {words[3 * i + 1]} {words[3 * i + 2]}" for i in range(n)]
        words = words[3 * n:]
        for _ in range(m):
            size = int(words[0])
            faces.append(" ".join([words[0], *(str(int(v) + first) for v in words[1:size + 1])]))
            words = words[size + 1:]
    path.write_text("\n".join(["OFF", f"{len(points)} {len(faces)} 0", *points, *faces]) + "\n")


def numbers(text):
    text = re.sub(r"\s", "", text.replace("−", "-"))
    return [float(x) for x in re.findall(r"-?\d+(?:\.\d+)?(?:e-?\d+)?", text)]


def distance_from_triangle_plane_and_outside(p, a, b, c):
    """How far p is from the plane of a triangle, and its least barycentric coordinate there."""
    sub = lambda x, y: [i - j for i, j in zip(x, y)]
    dot = lambda x, y: sum(i * j for i, j in zip(x, y))
    u, v, w = sub(b, a), sub(c, a), sub(p, a)
    uu, uv, vv, wu, wv = dot(u, u), dot(u, v), dot(v, v), dot(w, u), dot(w, v)
    s, t = (vv * wu - uv * wv) / (uu * vv - uv * uv), (uu * wv - uv * wu) / (uu * vv - uv * uv)
    rest = [w[k] - s * u[k] - t * v[k] for k in range(3)]
    return dot(rest, rest) ** 0.5, min(s, t, 1 - s - t), max(uu, vv) ** 0.5


def tile(charts, p):
    """The tile of a domain point of the square (1), the sphere (6) or the torus (9 charts)."""
    if charts == 1:
        return 0
    if charts == 6:
        k = max(range(3), key=lambda k: abs(p[k]))
        return 2 * (1, 0, 2).index(k) + (p[k] < 0)
    return sum(m * math.floor((p[k] - 1 / 6) % 1 * 3) for k, m in ((0, 1), (1, 3)))


def chart_point(charts, chart, p):
    """The coordinates of a domain point in a chart."""
    if charts == 1:
        return p
    if charts == 6:
        x, y, z = (p, p[2:] + p[:2], p[1:] + p[:1])[chart // 2]
        return (chart % 2 + math.atan2(y, x) / math.pi) % 2, (math.asin(z) + 3 * math.pi / 8) * 4 / (3 * math.pi)
    return tuple(1.5 * ((p[k] - (chart % 3, chart // 3)[k] / 3) % 1) for k in range(2))


class Page:
    PATIENCE = 20

    def __init__(self, browser, path, name):
        self.browser, self.path, self.name = browser, path, name
        browser.open(path)

    def check(self, holds, what):
        check(holds, f"{self.name}: {what}")

    def picture(self):
        """The views as they stay: on a busy machine the browser may show what was asked for some frames later."""
        last = None
        for _ in range(self.PATIENCE):
            self.browser.settle()
            picture = self.browser.screenshot("#panels", 0.25)
            if picture == last:
                break
            last = picture
        return picture

    def check_picture(self, holds, what):
        """The views come to show a picture for which holds(picture), within some frames."""
        self.check(any(holds(self.picture()) for _ in range(self.PATIENCE)), what)

    def box(self, panel):
        return self.browser.run("""const r = document.querySelectorAll('.panel')[arguments[0]].getBoundingClientRect();
                                   return [r.left, r.top, r.width, r.height];""", panel)

    def middle(self, panel):
        x, y, width, height = self.box(panel)
        return x + width / 2, y + height / 2

    def tip(self):
        """What the box with the values at a point says: {name: value}; empty when it is not there."""
        return dict(self.browser.run("""const tip = document.getElementById('tip'), b = [...tip.querySelectorAll('b')];
            return tip.hidden ? [] : b.map(e => [e.textContent, e.nextSibling.textContent]);"""))

    def check_panels(self, count):
        panels = self.browser.run("return document.querySelectorAll('.panel').length")
        self.check(panels == count, f"{panels} views instead of {count}")
        rows = pixels(self.picture())
        scale = len(rows[0]) / self.browser.run("return document.getElementById('panels').clientWidth")
        left = self.browser.run("return document.getElementById('panels').getBoundingClientRect().left")
        for k in range(panels):
            x, _, width, _ = self.box(k)
            columns = slice(round((x - left) * scale), round((x - left + width) * scale))
            colours = {c for row in rows for c in row[columns]}
            self.check(len(colours) > 10, f"view {k} has {len(colours)} colours")

    def check_switches(self, names):
        found = self.browser.run("return [...document.querySelectorAll('input[name=field]')].map(e => e.value)")
        self.check(found == names, f"switches {found}")
        pictures, legends = {}, {}
        for name in reversed(found): # the first is shown already
            self.browser.run("document.querySelector(`input[value=${arguments[0]}]`).click()", name)
            pictures[name] = self.picture()
            legends[name] = self.browser.run("return document.getElementById('legend').textContent")
        for a, b in itertools.combinations(found, 2):
            self.check(pictures[a] != pictures[b], f"{a} looks like {b}")
            self.check(legends[a] != legends[b], f"{a} has the legend of {b}")
        before = self.picture()
        for toggle in self.browser.run("return [...document.querySelectorAll('#toggles input')].map(e => e.id)"):
            self.browser.run("document.getElementById(arguments[0]).click()", toggle)
            self.check_picture(lambda picture: picture != before, f"{toggle} changes nothing")
            self.browser.run("document.getElementById(arguments[0]).click()", toggle)
            self.check_picture(lambda picture: picture == before, f"{toggle} cannot be switched off")

    def check_pointer_and_keys(self):
        browser, first = self.browser, self.picture()
        browser.drag(*self.middle(0), 60, 25)
        browser.move_to(1, 1)
        self.check_picture(lambda picture: picture != first, "dragging changes nothing")
        browser.run("document.getElementById('reset').click()")
        self.check_picture(lambda picture: picture == first, "the view cannot be reset")
        browser.run("document.querySelectorAll('.panel')[1].focus()")
        browser.press(browser.ESCAPE)
        first = self.picture() # with the ring that shows the focus to those who use keys
        browser.press(browser.RIGHT)
        turned = self.picture()
        self.check(turned != first, "the arrow key changes nothing")
        browser.press("+")
        self.check_picture(lambda picture: picture != turned, "the key + changes nothing")
        browser.press("0")
        self.check_picture(lambda picture: picture == first, "the key 0 does not reset the view")
        browser.press("3")
        self.check(browser.run("return document.querySelector('input[name=field]:checked').value") == "angle",
                   "the key 3 does not choose the third colouring")
        browser.press("1")
        browser.press(browser.ENTER)
        self.check("face" in self.tip(), "Enter shows no values")
        browser.press(browser.ESCAPE)
        self.check(self.tip() == {}, "Escape leaves the values")

    def check_values(self, folder):
        """What hovering says of a point, against the map that the program wrote."""
        names, vertices, faces = read_map(folder / "map.ply")
        diagonal = sum((max(c) - min(c)) ** 2 for c in list(zip(*vertices))[:3]) ** 0.5
        info = json.loads(self.browser.run("return document.getElementById('info').textContent"))
        charts, shape = len(info["atlas"]["charts"]), info["atlas"]["shapes"][0]["title"]
        for panel in range(self.browser.run("return document.querySelectorAll('.panel').length")):
            self.browser.move_to(*self.middle(panel))
            tip = self.tip()
            if not tip and panel != 1: # the middle of a torus may be empty, that of a sphere or square is not
                x, y = self.middle(panel)
                for shift in range(0, 90, 6):
                    self.browser.move_to(x + shift, y + shift / 2)
                    tip = self.tip()
                    if tip: # and stay there
                        break
            self.check("face" in tip, f"hovering over view {panel} shows nothing")
            if "face" not in tip:
                continue
            face = faces[int(numbers(tip["face"])[0])]
            a, b, c = (vertices[v][:3] for v in face[:3])
            off, inside, size = distance_from_triangle_plane_and_outside(numbers(tip["in space"]), a, b, c)
            self.check(off < 4e-3 * diagonal and inside > -4e-3 * diagonal / size,
                       f"view {panel}: the point is not in the face: {tip}")
            p = numbers(tip[f"on the {shape}"])
            chart, u, v = numbers(tip["chart"])
            expected = chart_point(charts, int(chart), p)
            self.check(chart == tile(charts, p) and max(abs(u - expected[0]), abs(v - expected[1])) < 4e-3,
                       f"view {panel}: wrong chart point: {tip}, {expected}")
            self.check(numbers(tip["angle"])[0] >= 1, f"view {panel}: {tip}")
            dots = self.browser.run("return [...document.querySelectorAll('.dot')].map(e => !e.hidden)")
            self.check(dots[panel], f"view {panel} does not mark the point")
        self.browser.move_to(1, 1)
        self.check(self.tip() == {}, "the values stay when the pointer leaves")

    def check_times(self, folder):
        """The page has the times of metrics.json, which are those of the console."""
        seconds = json.loads((folder / "metrics.json").read_text())["seconds"]
        said = self.browser.run("""return [...document.querySelectorAll('#highlights div')]
                                     .find(e => e.textContent.includes('to map and fit')).textContent""")
        expected = seconds["map"] + seconds["fit"]
        self.check(abs(numbers(said)[0] - expected) <= 0.006 * expected, f"{said} instead of {expected} s")

    def check_parts(self, shapes):
        """Parts are switched off and on; canonical surface and plots are those of one, `shapes` the titles of each."""
        titles = lambda: self.browser.run(
            "return [...document.querySelectorAll('.panel h3')].map(e => e.firstChild.textContent)")
        found = self.browser.run("return [...document.querySelectorAll('input[name=part]')].map(e => e.value)")
        self.check(found == list(shapes), f"parts {found}")
        first = self.picture()
        for name, own in shapes.items():
            switch = f"document.querySelector('input[value={name}]').click()"
            self.browser.run(switch)
            self.check_picture(lambda picture: picture != first, f"{name} cannot be switched off")
            self.browser.run(switch)
            self.browser.run("""const select = document.getElementById('part');
                select.value = [...select.options].find(e => e.textContent === arguments[0]).value;
                select.dispatchEvent(new Event('change'));""", name)
            self.check(titles() == ["Mesh", *own, "Surface", "CAD faces"], f"{name} has the views {titles()}")
            figures = self.browser.run("return document.getElementById('figures').textContent")
            self.check(name in figures, f"the figures are not those of {name}")
        self.browser.run("document.querySelector('input[name=field][value=gauss]').click()")
        self.browser.run("[...document.querySelectorAll('#parts_bar button')].at(-1).click()")
        on = self.browser.run("return document.querySelectorAll('input[name=part]:checked').length")
        kept = self.browser.run("return document.querySelector('input[name=field]:checked').value")
        self.check(on == 1 and kept == "gauss", f"{on} parts are left on, coloured by {kept}")
        self.browser.run("document.querySelector('input[name=part]:checked').click()")
        on = self.browser.run("return document.querySelectorAll('input[name=part]:checked').length")
        self.check(on == 1, "the last part can be switched off")

    def check_places(self):
        """Where the error is largest, and where the surface turns over, is marked in the views and can be looked at."""
        buttons = lambda: self.browser.run("return document.querySelectorAll('#places button').length")
        self.check(buttons() == 1, f"{buttons()} places without folds")
        is_on = lambda: self.browser.run("return document.getElementById('places_switch').checked")
        self.check(not is_on(), "places are marked without folds")
        text = self.path.read_text()
        chart, uv = json.loads(re.search(r'"kind":"worst","chart":(\d+)', text)[1]), "[0.4,0.55]"
        fold = f'{{"kind":"fold","chart":{chart},"uv":{uv}}}'
        changed = re.sub(r'"folds":0,"places":\[', f'"folds":20,"places":[{fold},{fold},', text)
        path = self.path.with_name("folds.html")
        path.write_text(changed)
        self.browser.open(path)
        said = self.browser.run("return document.getElementById('places').textContent")
        self.check(buttons() == 3 and "turns over at 20 faces" in said and said.endswith("…"), f"places: {said}")
        self.check(is_on(), "folds are not marked")
        self.browser.run("document.querySelectorAll('#places button')[1].click()")
        self.browser.settle()
        rows = pixels(self.browser.screenshot("#panels", 1))
        scale = len(rows[0]) / self.browser.run("return document.getElementById('panels').clientWidth")
        for panel in 0, self.browser.run("return document.querySelectorAll('.panel').length") - 1:
            left, top = self.browser.run("""const a = document.getElementById('panels').getBoundingClientRect(),
                b = document.querySelectorAll('.panel')[arguments[0]].getBoundingClientRect();
                return [b.left + b.width / 2 - a.left, b.top + b.height / 2 - a.top];""", panel)
            square = [row[round((left - 15) * scale):round((left + 15) * scale)]
                      for row in rows[round((top - 15) * scale):round((top + 15) * scale)]]
            red = sum(r > 200 and g < 70 and b < 120 for row in square for r, g, b in row)
            self.check(red > 20, f"view {panel} has {red} red pixels in the middle")

    def check_cad(self, faces):
        """The faces for CAD are in the last view, each in a colour of its own, with dark borders between them."""
        panel = self.browser.run("return document.querySelectorAll('.panel').length") - 1
        title = self.browser.run("return document.querySelectorAll('.panel h3')[arguments[0]].textContent", panel)
        self.check(title.startswith(f"CAD faces{faces} faces"), f"the view of CAD faces is called {title}")
        rows = pixels(self.browser.screenshot("#panels", 1))
        scale = len(rows[0]) / self.browser.run("return document.getElementById('panels').clientWidth")
        left = self.browser.run("return document.getElementById('panels').getBoundingClientRect().left")
        x, _, width, _ = self.box(panel)
        seen = [c for row in rows for c in row[round((x - left) * scale):round((x - left + width) * scale)]]
        hues = {round(6 * colorsys.rgb_to_hsv(*c)[0]) for c in seen if max(c) - min(c) > 40}
        dark = sum(max(c) < 70 for c in seen)
        self.check(len(hues) >= 3 and dark > 30, f"the view of CAD faces has {len(hues)} hues, {dark} dark pixels")

    def check_quiet(self):
        for line in self.browser.log():
            self.check(line["level"] not in ("SEVERE", "ERROR"), f"console: {line['message']}")
        loaded = self.browser.run("return performance.getEntriesByType('resource').map(e => e.name)")
        self.check(loaded == [], f"loads {loaded}")


def main():
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    if Browser.missing():
        print(f"skipped: no {Browser.missing()} is installed (scripts/setup test)")
        sys.exit(77)
    fit_mesh, map_mesh, meshes, work = sys.argv[1:]
    work = pathlib.Path(work).resolve()
    work.mkdir(parents=True, exist_ok=True)
    of_map = ["charts", "checker", "angle", "area"]
    of_surface = of_map + ["error", "mean", "gauss", "shape"]
    with Browser(800, 560) as browser:
        for name, views in ("hand", 4), ("knot1", 4), ("three_peaks", 3):
            cad = ["--cad", work / f"{name}.step"] if name == "hand" else []
            subprocess.run([fit_mesh, f"{meshes}/{name}.off", "-o", work / name, "--quiet", *cad], check=True)
            page = Page(browser, work / name / "report.html", name)
            page.check_panels(views)
            if cad:
                page.check_cad(len(re.findall("ADVANCED_FACE", cad[1].read_text())))
            page.check_switches(of_surface)
            page.check_pointer_and_keys()
            page.check_values(work / name)
            page.check_quiet()
            cells = browser.run("return [...document.querySelectorAll('#figures td')].map(e => e.textContent)")
            plots = browser.run("return document.querySelectorAll('#plots svg').length")
            page.check(len(cells) > 40 and plots >= 3, f"{len(cells)} figures and {plots} plots")
            page.check(sum(cell.endswith("% of the diagonal") for cell in cells) >= 8, f"no units: {cells}")
            page.check_times(work / name)
            page.check_places()

        light = browser.run("return getComputedStyle(document.body).backgroundColor")
        browser.set_dark(True)
        check(browser.run("return getComputedStyle(document.body).backgroundColor") != light, "dark looks like light")
        browser.resize(390, 844, 1, True)
        browser.settle()
        width = browser.run("return document.documentElement.scrollWidth")
        check(width <= 390, f"the page is {width} wide on a phone of 390")
        # No number is broken: what stands in one word is in one line.
        broken = browser.run("""const range = document.createRange();
            return [...document.querySelectorAll('#figures td:not(.path), #highlights dd, .ticks span')].flatMap(e =>
              [...e.textContent.matchAll(/\\d[^ ]*/g)].filter(({0: word, index}) => {
                range.setStart(e.firstChild, index);
                range.setEnd(e.firstChild, index + word.length);
                return new Set([...range.getClientRects()].map(r => Math.round(r.top))).size > 1;
              }).map(([word]) => word));""")
        check(broken == [], f"broken numbers: {broken}")
        browser.resize(800, 560)

        bodies = work / "bodies.off"
        join(bodies, [pathlib.Path(meshes) / f"{name}.off" for name in ("torus_quad", "sphere")])
        subprocess.run([fit_mesh, bodies, "-o", work / "bodies", "--quiet", "--cad", work / "bodies.step"], check=True)
        page = Page(browser, work / "bodies" / "report.html", "bodies")
        page.check_panels(4)
        page.check_cad(15)
        page.check_parts({"part-1": ["Unit sphere"], "part-2": ["Flat torus", "Ring torus"]})
        page.check_quiet()

        report = work / "map.html"
        subprocess.run([map_mesh, f"{meshes}/hand.off", "-o", work / "map.ply", "--report", report, "--quiet"],
                       check=True)
        page = Page(browser, report, "map_mesh")
        page.check_panels(2)
        page.check_switches(of_map + ["shape"])
        page.check_quiet()
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
