#!/usr/bin/env python3
"""areas: random SVGs, GeoJSONs and rings in texts, and what others say lies inside of them.

    areas.py PROGRAM [--cases N] [--seconds S] [--seed S] [--only svg|geojson]

Writes random drawings (groups, transforms in attributes, styles and rules, display, visibility,
classes, symbols, use, units, viewBoxes, clip paths, entities, namespaces, packed files) and random
maps (holes within polygons, across their outlines, across each other and twice; overlapping
polygons and rings, collections, sequences, lines, obstacles), and lets `lacuna sample` fill them.
librsvg paints the drawings, and shapely computes the maps: no point may lie outside of what they
say, and all that is deeper than the edge must be covered. Or the program refuses, with one line. Of
the maps, `lacuna verify` must prove each set.

Makes N cases (600), or as many as S seconds allow, and prints the seed, which is a new one each
time unless it is given. Ends with 1 at the first wrong case, whose file it prints. Without librsvg
or shapely it prints a line with SKIPPED; then it ends with 1 if LACUNA_REQUIRE has "areas".
"""
import argparse
import ctypes
import ctypes.util
import gzip
import json
import math
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import time

FOREIGN = "http://example.org/another"
RADIUS = 1.0
EDGE = RADIUS / 16
SCALE = 8  # pixels of the painted drawing to a unit of its page


def leave_out(why: str):
    is_required = "areas" in os.environ.get("LACUNA_REQUIRE", "")
    start = "LACUNA_REQUIRE has areas, but" if is_required else "SKIPPED"
    print(f"{start}: {why} (Debian: librsvg2-bin python3-shapely)")
    sys.exit(1 if is_required else 0)


try:
    import numpy as np
    import shapely
    from shapely import geometry, ops
except ImportError as error:
    leave_out(str(error))


class Painter:
    """librsvg and cairo: the pixels of a drawing that are painted."""

    def __init__(self):
        try:
            self.rsvg = ctypes.CDLL("librsvg-2.so.2")
            self.cairo = ctypes.CDLL("libcairo.so.2")
            self.object = ctypes.CDLL("libgobject-2.0.so.0")
        except OSError as error:
            leave_out(str(error))
        pointer = ctypes.c_void_p
        for library, name, result, arguments in (
            (self.rsvg, "rsvg_handle_new_from_data", pointer,
             [ctypes.c_char_p, ctypes.c_size_t, pointer]),
            (self.rsvg, "rsvg_handle_render_document", ctypes.c_int,
             [pointer, pointer, pointer, pointer]),
            (self.rsvg, "rsvg_handle_set_dpi", None, [pointer, ctypes.c_double]),
            (self.cairo, "cairo_image_surface_create", pointer, [ctypes.c_int] * 3),
            (self.cairo, "cairo_create", pointer, [pointer]),
            (self.cairo, "cairo_image_surface_get_data", pointer, [pointer]),
            (self.cairo, "cairo_image_surface_get_stride", ctypes.c_int, [pointer]),
            (self.cairo, "cairo_surface_flush", None, [pointer]),
            (self.cairo, "cairo_destroy", None, [pointer]),
            (self.cairo, "cairo_surface_destroy", None, [pointer]),
            (self.object, "g_object_unref", None, [pointer]),
        ):
            function = getattr(library, name)
            function.restype, function.argtypes = result, arguments

    def paint(self, text: str, width: float, height: float):
        """The opacity of each pixel, 0 to 255; row 0 is the top. None if librsvg cannot read it."""
        columns, rows = round(width * SCALE), round(height * SCALE)
        data = text.encode()
        handle = self.rsvg.rsvg_handle_new_from_data(data, len(data), None)
        if not handle:
            return None
        self.rsvg.rsvg_handle_set_dpi(handle, 96)  # its own default is 90
        surface = self.cairo.cairo_image_surface_create(0, columns, rows)
        context = self.cairo.cairo_create(surface)
        viewport = (ctypes.c_double * 4)(0, 0, columns, rows)
        painted = self.rsvg.rsvg_handle_render_document(handle, context, viewport, None)
        self.cairo.cairo_surface_flush(surface)
        stride = self.cairo.cairo_image_surface_get_stride(surface)
        address = self.cairo.cairo_image_surface_get_data(surface)
        raw = np.ctypeslib.as_array((ctypes.c_uint8 * (stride * rows)).from_address(address))
        alpha = raw.reshape(rows, stride)[:, 3 : 4 * columns : 4].copy()
        self.cairo.cairo_destroy(context)
        self.cairo.cairo_surface_destroy(surface)
        self.object.g_object_unref(handle)
        return alpha if painted else None


class Drawing:
    """A random SVG. Shapes are filled and have no stroke, unless they are open lines."""

    def __init__(self, random_: random.Random):
        self.random = random_
        self.defined: list[str] = []
        self.rules: list[str] = []
        self.names = 0
        self.entities: list[str] | None = [] if random_.random() < 0.3 else None
        self.rare = random_.random() < 0.25  # has what may be refused
        self.width, self.height = random_.randint(20, 60), random_.randint(20, 60)
        self.left, self.top = random_.choice([(0, 0), (-7, 13), (100, -40.5)])
        body = "".join(self.element(0) for _ in range(random_.randint(2, 6)))
        style = f"<style>{self.rules_text()}</style>" if self.rules else ""
        size = random_.choice(["", f' width="{self.width * 3}" height="{self.height * 3}"',
                               ' width="100mm" height="3in" preserveAspectRatio="none"'])
        root = random_.choice(["", "", ' fill-rule="evenodd"', ' style="fill-rule:evenodd"'])
        prefix = random_.choice(["", "", "", "s:"])
        space = self.entity("http://www.w3.org/2000/svg")
        drawing = (f'<svg xmlns{prefix and ":s"}="{space}" xmlns:f="{FOREIGN}" '
                   f'xmlns:xlink="http://www.w3.org/1999/xlink"{size}{root} '
                   f'viewBox="{self.left} {self.top} {self.width} {self.height}">'
                   f'{style}<defs>{"".join(self.defined)}</defs>{body}</svg>')
        drawing = re.sub(r"<(/?)(?=[a-zA-Z])(?!f:|/f:)", rf"<\1{prefix}", drawing)
        dtd = "".join(f"<!ENTITY {name} {value}>\n" for name, value in
                      ([(f"e{i}", value) for i, value in enumerate(self.entities or [])]))
        self.text = (f"<!DOCTYPE svg [<!-- &none; -->\n{dtd}]>\n" if dtd else "") + drawing

    def entity(self, text):
        """A text, which may be written as an entity or as two of them, one within the other."""
        if self.entities is None or self.random.random() < 0.5:
            return text
        half = self.random.randint(0, len(text))
        begin = text[:half]
        if self.random.random() < 0.3:
            self.entities.append(f"'{begin}'")
            begin = f"&e{len(self.entities) - 1};"
        self.entities.append(f'"{begin}{text[half:]}"')
        return f"&e{len(self.entities) - 1};"

    def rules_text(self):
        text = "\n".join(self.rules)
        return self.random.choice([text, f"<![CDATA[{text}]]>", f"/* {{ */ {text}"])

    def name(self):
        self.names += 1
        return f"n{self.names}"

    def number(self, low, high):
        return round(self.random.uniform(low, high), self.random.choice([0, 1, 3]))

    def place(self):
        return (self.number(self.left, self.left + self.width),
                self.number(self.top, self.top + self.height))

    def length(self, value):
        unit, factor = self.random.choice(
            [("", 1), ("", 1), ("", 1), ("px", 1), ("mm", 96 / 25.4), ("in", 96), ("pt", 4 / 3)])
        return f"{value / factor:.6g}{unit}"

    def transform(self):
        number, choose = self.number, self.random.choice
        steps = []
        for _ in range(choose([1, 1, 2])):
            x, y, s, angle = number(-9, 9), number(-9, 9), choose([0.5, 1.5, -1, 2]), number(-90, 90)
            steps.append(choose([
                ("translate", f"{x} {y}", f"{x}px, {y}px"), ("scale", f"{s}", f"{s}"),
                ("rotate", f"{angle}", f"{angle}deg"), ("skewX", f"{angle / 3}", f"{angle / 3}deg"),
                ("matrix", f"1 .3 {-s} 1 {x} {y}", f"1,.3,{-s},1,{x},{y}")]))
        return (" ".join(f"{name}({attribute})" for name, attribute, _ in steps),
                " ".join(f"{name}({css})" for name, _, css in steps))

    def properties(self, can_be_shown: bool):
        """Attributes of a random element: how it is hidden, moved and filled."""
        choose, chance = self.random.choice, self.random.random
        wanted: list[tuple[str, str, str]] = []  # property, value as attribute, value as CSS
        if chance() < 0.3:
            attribute, css = self.transform()
            wanted.append(("transform", attribute, css))
        if chance() < 0.15:
            value = choose(["none", "inline", "block"])
            wanted.append(("display", value, value))
        if chance() < 0.2:
            value = choose(["hidden", "visible", "collapse", "visible"])
            wanted.append(("visibility", value, value))
        if chance() < 0.1:
            value = choose(["0", "1", "0.9"])
            wanted.append(("opacity", value, value))
        if chance() < 0.2:
            value = choose(["evenodd", "nonzero", "inherit"])
            wanted.append(("fill-rule", value, value))
        if self.rare and chance() < 0.1:
            defined = self.name()
            x, y = self.place()
            self.defined.append(f'<clipPath id="{defined}"><circle cx="{x}" cy="{y}" r="9"/>'
                                f'</clipPath>')
            wanted.append(("clip-path", f"url(#{defined})", f"url(#{defined})"))
        attributes, style = [], []
        identity = None
        for property_, attribute, css in wanted:
            # librsvg 2.54 ignores transforms that are important.
            important = choose(["", "", "", " !important"]) if property_ != "transform" else ""
            where = choose(["attribute", "style", "class", "id", "both"])
            if where in ("attribute", "both"):
                attributes.append(f'{property_}="{self.entity(attribute)}"')
            if where in ("style", "both"):
                style.append(f"{property_}: {css}{important}")
            if where == "class":
                name = self.name()
                self.rules.append(f".{name}{choose(['', ', .other', ', #none.x'])}"
                                  f" {{{property_}:{css}{important};stroke-width:3}}")
                attributes.append(("class", name))
            if where == "id":
                identity = identity or self.name()
                self.rules.append(f"#{identity}{{{property_}:{css}{important}}}")
        classes = [a[1] for a in attributes if isinstance(a, tuple)]
        attributes = [a for a in attributes if isinstance(a, str)]
        if classes:
            attributes.append(f'class="{" ".join(classes)} more"')
        if identity:
            attributes.append(f'id="{identity}"')
        if style:
            attributes.append(f'style="{self.entity(choose([";", "; "]).join(style))}"')
        self.random.shuffle(attributes)
        return "".join(" " + a for a in attributes)

    def element(self, depth: int):
        choose, chance = self.random.choice, self.random.random
        kind = choose(["shape"] * 5 + (["g", "g", "use", "use"] if depth < 3 else []) +
                      (["symbol", "svg", "switch", "text"] if self.rare and depth < 3 else []))
        properties = self.properties(True)
        if chance() < 0.08:  # what is of another namespace is not drawn, nor is what is in it
            inner = self.shape(properties) if chance() < 0.5 else self.element(3)
            return choose([f"<f:g>{inner}</f:g>", f'<f:rect width="90" height="90"{properties}/>',
                           f'<f:g xmlns="{FOREIGN}">{inner}</f:g>',
                           f'<f:path d="{self.path()}"/>'])
        if kind == "shape":
            return self.shape(properties)
        if kind == "g":
            inner = "".join(self.element(depth + 1) for _ in range(self.random.randint(1, 3)))
            return f"<{choose(['g', 'a'])}{properties}>{inner}".replace("<a", "<g") + "</g>"
        if kind == "use":
            name = self.name()
            inner = self.element(depth + 1)
            if chance() < 0.5:
                self.defined.append(f'<g id="{name}">{inner}</g>')
                inner = ""
            else:
                inner = f'<g id="{name}">{inner}</g>'
            x, y = self.number(-15, 15), self.number(-15, 15)
            link = choose(["href", "xlink:href"])
            return f'{inner}<use {link}="#{name}" x="{x}" y="{self.length(y)}"{properties}/>'
        if kind == "symbol":
            name = self.name()
            self.defined.append(f'<symbol id="{name}" viewBox="0 0 10 10">'
                                f'{self.element(depth + 1)}</symbol>')
            return f'<use href="#{name}" width="12" height="9"{properties}/>'
        if kind == "svg":
            return f'<svg x="3" width="20" height="15">{self.element(depth + 1)}</svg>'
        if kind == "switch":
            return f"<switch{properties}>{self.element(3)}{self.element(3)}</switch>"
        return f'<text x="3" y="9" visibility="hidden"{""}>not read</text>'

    def shape(self, properties: str):
        choose, number = self.random.choice, self.number
        x, y = self.place()
        kind = choose(["rect", "circle", "ellipse", "polygon", "polyline", "path", "path", "path"])
        if self.rare and self.random.random() < 0.05:
            return f'<path fill="none" stroke="red" d="M{x} {y}h9v5"{properties}/>'
        if kind == "rect":
            corner = choose(["", "", f' rx="{number(0, 4)}"', f' rx="{number(1, 3)}" ry="2"'])
            return (f'<rect x="{self.length(x)}" y="{y}" width="{self.length(number(2, 25))}" '
                    f'height="{number(2, 25)}"{corner}{properties}/>')
        if kind == "circle":
            return f'<circle cx="{x}" cy="{self.length(y)}" r="{number(1, 12)}"{properties}/>'
        if kind == "ellipse":
            return f'<ellipse cx="{x}" cy="{y}" rx="{number(1, 12)}" ry="{number(1, 12)}"{properties}/>'
        if kind.startswith("poly"):
            points = " ".join("{},{}".format(*self.place())
                              for _ in range(self.random.randint(3, 6)))
            return f'<{kind} points="{points}"{properties}/>'
        return f'<path d="{self.path()}"{properties}/>'

    def path(self):
        pieces = []
        for _ in range(self.random.randint(1, 3)):
            pieces.append("M{} {}".format(*self.place()))
            for _ in range(self.random.randint(2, 5)):
                x, y = self.place()
                a, b = self.number(-12, 12), self.number(-12, 12)
                c, d = self.number(-12, 12), self.number(-12, 12)
                flags = f"{self.random.randint(0, 1)} {self.random.randint(0, 1)}"
                pieces.append(self.random.choice([
                    f"L{x} {y}", f"l{a} {b}", f"H{x}", f"v{b}", f"h{a}V{y}",
                    f"C{x} {y} {x + a} {y + b} {x + c} {y + d}", f"q{a} {b} {c} {d}",
                    f"s{a} {b} {c},{d}", f"t{a} {b}", f"a{abs(a)} {abs(b)} {c} {flags} {c} {d}",
                    f"A{abs(b) + 1} {abs(a) + 1} 0 {flags} {x} {y}"]))
            pieces.append(self.random.choice(["z", "Z", ""]))
        return "".join(pieces)


def spread(pixels, steps: int):
    """The pixels within `steps` of those that are set, along both axes."""
    for _ in range(steps):
        wider = pixels.copy()
        wider[1:] |= pixels[:-1]
        wider[:-1] |= pixels[1:]
        wide = wider.copy()
        wide[:, 1:] |= wider[:, :-1]
        wide[:, :-1] |= wider[:, 1:]
        pixels = wide
    return pixels


def covered(points, columns: int, rows: int):
    """The pixels whose middles are within the radius of a point. Row 0 is the top."""
    pixels = np.zeros((rows, columns), bool)
    for x, y in points:
        column, row, reach = x * SCALE, rows - y * SCALE, (RADIUS + 1e-6) * SCALE
        left, right = max(0, int(column - reach) - 1), min(columns, int(column + reach) + 2)
        top, bottom = max(0, int(row - reach) - 1), min(rows, int(row + reach) + 2)
        dx = np.arange(left, right) + 0.5 - column
        dy = np.arange(top, bottom) + 0.5 - row
        pixels[top:bottom, left:right] |= dy[:, None] ** 2 + dx[None, :] ** 2 <= reach * reach
    return pixels


class Program:
    def __init__(self, program: str, folder: pathlib.Path):
        self.program, self.folder = program, folder

    def run(self, *arguments: str):
        return subprocess.run([self.program, *arguments], cwd=self.folder, capture_output=True,
                              text=True, check=False)

    def points(self, *arguments: str):
        """The points, or the line with which the request was refused."""
        run = self.run("sample", *arguments, "--radius", str(RADIUS), "--quiet", "-o", "a.csv")
        if run.returncode == 0:
            lines = (self.folder / "a.csv").read_text().splitlines()
            rows = [line.split(",") for line in lines if line and not line.startswith(("#", "x"))]
            return [(float(row[0]), float(row[1])) for row in rows], ""
        if run.returncode not in (2, 3) or run.stderr.count("\n") != 1:
            raise SystemExit(f"exit code {run.returncode}: {run.stderr}")
        return None, run.stderr.strip()


def judge_drawing(random_: random.Random, program: Program, painter: Painter):
    """What is wrong with a drawing, or nothing; and whether it was refused."""
    drawing = Drawing(random_)
    packed = random_.random() < 0.1
    data = gzip.compress(drawing.text.encode()) if packed else drawing.text.encode()
    (program.folder / "a.svg").write_bytes(data)
    painted = painter.paint(drawing.text, drawing.width, drawing.height)
    if painted is None:
        return "", True
    points, refusal = program.points("--inside", "a.svg")
    deep = ~spread(~np.pad(painted > 250, 4), 4)[4:-4, 4:-4]
    if points is None:
        if "no polygon" in refusal and spread(deep, 0).any():
            return f"{refusal}, but something is painted\n{drawing.text}", True
        return "", True
    rows, columns = painted.shape
    near = spread(painted > 0, 1)  # also where something narrower than a pixel is
    for x, y in points:
        pixel = min(int(x * SCALE), columns - 1), min(int(y * SCALE), rows - 1)
        if not near[rows - 1 - pixel[1], pixel[0]]:
            return f"a point at {x}, {y}, where nothing is painted\n{drawing.text}", False
    bare = deep & ~covered(points, columns, rows)
    if bare.any():
        row, column = np.argwhere(bare)[0]
        return (f"no point near {column / SCALE}, {(rows - row) / SCALE}, which is painted\n"
                f"{drawing.text}"), False
    return "", False


class Map:
    """A random GeoJSON, and its area by shapely."""

    extension = "geojson"

    def __init__(self, random_: random.Random, side: float):
        self.random, self.side = random_, side
        self.has_lines = False
        polygons: list[geometry.Polygon] = []
        features = [self.feature(polygons, 0) for _ in range(random_.randint(1, 4))]
        if len(features) == 1 and random_.random() < 0.5:
            self.value = features[0]
        else:
            self.value = {"type": "FeatureCollection", "features": features}
        self.area = ops.unary_union(polygons)

    def ring(self, middle, size):
        corners = self.random.randint(3, 9)
        angles = sorted(self.random.uniform(0, 2 * math.pi) for _ in range(corners))
        points = []
        for angle in angles:
            far = size * self.random.uniform(0.4, 1)
            points.append([middle[0] + far * math.cos(angle), middle[1] + far * math.sin(angle)])
        return points + points[:1]

    def polygon(self, polygons):
        middle = [self.random.uniform(-0.1, 1.1) * self.side for _ in range(2)]
        size = self.random.uniform(2, 15)
        rings = [self.valid_ring(middle, size)]
        for _ in range(self.random.choice([0, 0, 1, 1, 2, 3])):
            far = self.random.choice([0, 0, 0.3, 1, 2])  # within, or across the shell, or apart
            at = [x + far * size * self.random.uniform(-1, 1) for x in middle]
            rings.append(self.valid_ring(at, size * self.random.choice([0.2, 0.3, 0.6])))
        if len(rings) > 1 and self.random.random() < 0.2:
            rings.append(self.random.choice(rings[1:]))
        holes = ops.unary_union([geometry.Polygon(ring) for ring in rings[1:]])
        polygons.append(geometry.Polygon(rings[0]).difference(holes))
        return [[list(map(float, p)) for p in ring] for ring in rings]

    def valid_ring(self, middle, size):
        while True:
            ring = self.ring(middle, size)
            polygon = geometry.Polygon(ring)
            if polygon.is_valid and polygon.area > 0.01:
                return ring

    def geometry(self, polygons, depth):
        kind = self.random.choice(["Polygon"] * 4 + ["MultiPolygon"] * 2 + ["Point"] +
                                  (["GeometryCollection"] if depth < 2 else []) +
                                  (["LineString"] if self.random.random() < 0.1 else []))
        if kind == "Polygon":
            return {"type": kind, "coordinates": self.polygon(polygons)}
        if kind == "MultiPolygon":
            count = self.random.randint(1, 3)
            return {"type": kind, "coordinates": [self.polygon(polygons) for _ in range(count)]}
        if kind == "GeometryCollection":
            return {"type": kind, "geometries": [self.geometry(polygons, depth + 1)
                                                 for _ in range(self.random.randint(1, 2))]}
        if kind == "Point":
            return {"type": kind, "coordinates": [1.5, 2.5]}
        self.has_lines = True
        return {"type": kind, "coordinates": [[0, 0], [self.side, self.side]]}

    def text(self):
        """The file: one text or, of a collection, a sequence of them."""
        if "features" not in self.value or self.random.random() < 0.6:
            return json.dumps(self.value)
        mark = self.random.choice(["", "\x1e"])
        return "".join(f"{mark}{json.dumps(one)}\n" for one in self.value["features"])

    def feature(self, polygons, depth):
        if self.random.random() < 0.15:
            return {"type": "Feature", "properties": {}, "geometry": None}
        return {"type": "Feature", "properties": None, "geometry": self.geometry(polygons, depth)}


class Rings(Map):
    """Rings in a text. A ring in another is a hole; rings that overlap in part are joined."""

    extension = "txt"

    def __init__(self, random_: random.Random, side: float):
        self.random, self.side, self.has_lines = random_, side, False
        rings = []
        for _ in range(random_.randint(1, 6)):
            middle = [random_.uniform(-0.1, 1.1) * side for _ in range(2)]
            if rings and random_.random() < 0.5:
                middle = random_.choice(rings)[0]
            rings.append((middle, self.valid_ring(middle, random_.uniform(1, 15))))
        if random_.random() < 0.2:
            rings.append(random_.choice(rings))
        self.rings = [ring for _, ring in rings]
        shapes = [geometry.Polygon(ring) for ring in self.rings]
        group = list(range(len(shapes)))
        for i, a in enumerate(shapes):
            for j, b in enumerate(shapes[:i]):
                is_nested = a.contains(b) != b.contains(a)
                if a.intersection(b).area > 0 and not is_nested:
                    group = [group[i] if one == group[j] else one for one in group]
        self.area = geometry.Polygon()
        for one in set(group):
            united = ops.unary_union([s for s, own in zip(shapes, group) if own == one])
            self.area = self.area.symmetric_difference(united)

    def text(self):
        return "\n".join("".join(f"{x!r} {y!r}\n" for x, y in ring) for ring in self.rings)


def judge_map(random_: random.Random, program: Program):
    side = random_.randint(15, 40)
    arguments = ["--domain", f"{side}x{side}"]
    inside, outside, avoid = [], [], []
    has_lines = False
    for name, areas, most in ("inside", inside, 2), ("outside", outside, 1):
        for i in range(random_.randint(0 if name == "outside" else 1, most)):
            found = random_.choice([Map, Map, Rings])(random_, side)
            path = f"{name}{i}.{found.extension}"
            (program.folder / path).write_text(found.text())
            arguments += [f"--{name}", path]
            areas.append(found.area)
            has_lines = has_lines or found.has_lines
    for i in range(random_.randint(0, 2)):
        points = [(random_.uniform(0, side), random_.uniform(0, side)) for _ in range(3)]
        width = round(random_.uniform(0.1, 3), 2)
        kind = random_.choice(["LineString", "Polygon", "Point"])
        line = {"LineString": geometry.LineString, "Point": lambda p: geometry.Point(p[0]),
                "Polygon": lambda p: geometry.LinearRing(p)}[kind](points)
        coordinates = {"LineString": points, "Point": points[0],
                       "Polygon": [points + points[:1]]}[kind]
        (program.folder / f"avoid{i}.geojson").write_text(
            json.dumps({"type": kind, "coordinates": coordinates}))
        arguments += ["--avoid", f"avoid{i}.geojson:{width}"]
        avoid.append((line, width))
    border = random_.choice([0, 0, 0, 0.5])
    if border:
        arguments += ["--border", str(border)]

    def depth(point):
        """How far inside of what is allowed a point lies."""
        deep = max((-1 if not area.contains(point) else 1) * area.boundary.distance(point)
                   if not area.is_empty else -math.inf for area in inside)
        deep -= border
        for area in outside:
            if not area.is_empty:
                far = area.boundary.distance(point)
                deep = min(deep, (-far if area.contains(point) else far) - border)
        for line, width in avoid:
            deep = min(deep, line.distance(point) - width)
        if border:
            deep = min(deep, point.x - border, point.y - border, side - border - point.x,
                       side - border - point.y)
        return deep

    points, refusal = program.points(*arguments)
    text = " ".join(arguments) + "".join(
        f"\n{path.name}: {path.read_text()}" for path in sorted(program.folder.glob("*.*"))
        if path.name in " ".join(arguments))
    spots = [geometry.Point(random_.uniform(0, side), random_.uniform(0, side))
             for _ in range(300)]
    if points is None:
        if not has_lines and "no polygon" not in refusal:
            return f"{refusal}\n{text}", True
        return "", True
    if has_lines:
        return f"a line was taken for an area\n{text}", False
    for x, y in points:
        if depth(geometry.Point(x, y)) < -1e-9:
            return f"a point outside, at {x}, {y}\n{text}", False
    all_points = np.array(points).reshape(-1, 2)
    for spot in spots:
        if depth(spot) <= EDGE + 1e-6:
            continue
        if not (np.hypot(all_points[:, 0] - spot.x, all_points[:, 1] - spot.y)
                <= RADIUS + 1e-6).any():
            return f"no point near {spot.x}, {spot.y}\n{text}", False
    proof = program.run("verify", "a.csv", "--radius", str(RADIUS), *arguments)
    if proof.returncode != 0:
        return f"{proof.stdout}{proof.stderr}\n{text}", False
    return "", False


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--cases", type=int, default=600)
    parser.add_argument("--seconds", type=float)
    parser.add_argument("--seed", type=int, default=random.SystemRandom().randrange(10**9))
    parser.add_argument("--only", choices=["svg", "geojson"])
    options = parser.parse_args()
    painter = Painter()
    print(f"seed {options.seed}", flush=True)
    begin = time.monotonic()
    counts = {kind: [0, 0] for kind in ("svg", "geojson")}
    number = 0
    with tempfile.TemporaryDirectory() as folder:
        program = Program(os.path.abspath(options.program), pathlib.Path(folder))
        while (time.monotonic() - begin < options.seconds if options.seconds
               else number < options.cases):
            kind = options.only or ("svg" if number % 2 == 0 else "geojson")
            random_ = random.Random(f"{options.seed} {number}")
            wrong, is_refused = (judge_drawing(random_, program, painter) if kind == "svg"
                                 else judge_map(random_, program))
            if wrong:
                print(f"case {number} of seed {options.seed}: {wrong}")
                return 1
            counts[kind][0] += 1
            counts[kind][1] += is_refused
            number += 1
    for kind, (count, refused) in counts.items():
        if count:
            print(f"{kind}: {count} cases, of which {refused} were refused")
        # A program that refuses most would be no test of areas.
        if count >= 40 and refused > count * 0.6:
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
