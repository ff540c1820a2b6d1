"""Outlines of panels as curves by length: places on them, arcs, cuts, and what coincides.

Lengths are centimetres. Every outline is walked counter-clockwise, wherever it is drawn.
"""
import bisect
import math

STEPS = 24  # straight steps that a cubic is measured by
SHORT = 0.1  # cm: no edge is cut as short as that
SAMPLES = 96  # points by which two outlines are compared


def bezier(curve, t):
    if len(curve) == 2:
        (ax, ay), (bx, by) = curve
        return (ax + (bx - ax) * t, ay + (by - ay) * t)
    u = 1 - t
    w = (u * u * u, 3 * u * u * t, 3 * u * t * t, t * t * t)
    return (sum(f * p[0] for f, p in zip(w, curve)), sum(f * p[1] for f, p in zip(w, curve)))


def split(curve, t):
    """Both parts of a line or a cubic, by de Casteljau's rule."""
    rows = [list(curve)]
    while len(rows[-1]) > 1:
        row = rows[-1]
        rows.append([(a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t)
                     for a, b in zip(row, row[1:])])
    return [row[0] for row in rows], [row[-1] for row in reversed(rows)]


def curves_of(edge, vertices):
    """The lines and cubics of an edge, from its start to its end."""
    start, end = (tuple(vertices[v]) for v in edge["endpoints"])
    curvature = edge.get("curvature")
    if curvature is None:
        return [(start, end)]
    dx, dy = end[0] - start[0], end[1] - start[1]
    params = curvature["params"]
    if curvature["type"] == "quadratic":
        c = params[0] if isinstance(params[0], list) else params
        params = [[c[0] * 2 / 3, c[1] * 2 / 3], [1 / 3 + c[0] * 2 / 3, c[1] * 2 / 3]]
    elif curvature["type"] not in ("cubic", "cubics"):
        raise ValueError(f"curve of type {curvature['type']}")
    points = [start] + [(start[0] + x * dx - y * dy, start[1] + x * dy + y * dx)
                        for x, y in params] + [end]
    return [tuple(points[i:i + 4]) for i in range(0, len(points) - 1, 3)]


def edge_of(curves, start, end):
    """The edge's entry in a pattern file, between two numbered vertices."""
    edge = {"endpoints": [start, end]}
    if len(curves) == 1 and len(curves[0]) == 2:
        return edge
    (ax, ay), (bx, by) = curves[0][0], curves[-1][-1]
    dx, dy = bx - ax, by - ay
    scale = dx * dx + dy * dy
    points = []
    for curve in curves:
        if len(curve) == 2:
            curve = [curve[0], bezier(curve, 1 / 3), bezier(curve, 2 / 3), curve[1]]
        points += curve[1:]
    params = [[((x - ax) * dx + (y - ay) * dy) / scale, ((y - ay) * dx - (x - ax) * dy) / scale]
              for x, y in points[:-1]]
    edge["curvature"] = {"type": "cubic" if len(params) == 2 else "cubics", "params": params}
    return edge


class Outline:
    """A panel's outline. Places on it are lengths from the start of its first edge."""

    def __init__(self, panel, unit_cm=1.0):
        vertices = [(x * unit_cm, y * unit_cm) for x, y in panel["vertices"]]
        order, steps = [], {}
        for number, edge in enumerate(panel["edges"]):
            a, b = edge["endpoints"]
            steps.setdefault(a, []).append((number, False))
            steps.setdefault(b, []).append((number, True))
        number, turned = 0, False
        while len(order) < len(panel["edges"]):
            order.append((number, turned))
            end = panel["edges"][number]["endpoints"][0 if turned else 1]
            number, turned = next(s for s in steps[end] if s[0] != number)
        loop = []
        for number, turned in order:
            curves = curves_of(panel["edges"][number], vertices)
            if turned:
                curves = [tuple(reversed(c)) for c in reversed(curves)]
            loop.append((number, turned, curves))
        if self._area([c for _, _, curves in loop for c in curves]) < 0:
            loop = [(number, not turned, [tuple(reversed(c)) for c in reversed(curves)])
                    for number, turned, curves in reversed(loop)]
            loop = loop[-1:] + loop[:-1]
        self.turned, self.begin, self.end = {}, {}, {}
        self.edges = []  # numbers in the order of the walk
        self.points, self.at = [], []  # the outline in straight steps, and the length at each
        self.curves = []  # (length at its start, length at its end, curve, edge number)
        length = 0.0
        for number, turned, curves in loop:
            self.edges.append(number)
            self.turned[number] = turned
            self.begin[number] = length
            for curve in curves:
                first = length
                steps_of = 1 if len(curve) == 2 else STEPS
                last = curve[0]
                for i in range(1, steps_of + 1):
                    self.points.append(last)
                    self.at.append(length)
                    point = bezier(curve, i / steps_of)
                    length += math.dist(last, point)
                    last = point
                self.curves.append((first, length, curve, number))
            self.end[number] = length
        self.length = length
        self.corners = sorted(self.begin.values())
        self.angle = 0.0  # by which it was turned
        self._find_box()

    def _find_box(self):
        xs, ys = [p[0] for p in self.points], [p[1] for p in self.points]
        self.low, self.high = (min(xs), min(ys)), (max(xs), max(ys))
        self.box = (self.high[0] - self.low[0], self.high[1] - self.low[1])

    def turn(self, degrees):
        """Turns the outline counter-clockwise: its points and its box, its places stay."""
        if degrees == 0:
            return
        c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        self.points = [(x * c - y * s, x * s + y * c) for x, y in self.points]
        self.angle += degrees
        self._find_box()

    @staticmethod
    def _area(curves):
        points = [bezier(c, i / 8) for c in curves for i in range(8)]
        return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(points, points[1:] + points[:1])) / 2

    def point(self, at):
        """The point at a length, from the lower left corner of the panel's box."""
        at %= self.length
        i = bisect.bisect_right(self.at, at) - 1
        a = self.points[i]
        b = self.points[(i + 1) % len(self.points)]
        step = (self.at[i + 1] if i + 1 < len(self.at) else self.length) - self.at[i]
        t = (at - self.at[i]) / step if step > 0 else 0
        return (a[0] + (b[0] - a[0]) * t - self.low[0], a[1] + (b[1] - a[1]) * t - self.low[1])

    def place(self, point):
        """The length at which the outline is nearest to a point, and how near."""
        x, y = point[0] + self.low[0], point[1] + self.low[1]
        best = (math.inf, 0.0)
        for i, (ax, ay) in enumerate(self.points):
            bx, by = self.points[(i + 1) % len(self.points)]
            dx, dy = bx - ax, by - ay
            square = dx * dx + dy * dy
            t = max(0.0, min(1.0, ((x - ax) * dx + (y - ay) * dy) / square)) if square else 0.0
            far = math.hypot(ax + t * dx - x, ay + t * dy - y)
            if far < best[0]:
                best = (far, self.at[i] + t * math.sqrt(square))
        return best[1], best[0]

    def span(self, start, end):
        """The length of the arc from one place to another, walked counter-clockwise."""
        return (end - start) % self.length

    def edge_at(self, start, end):
        """The number of the edge that is this arc, or None."""
        for number in self.edges:
            if (self.apart(self.begin[number], start) < 1.5 * SHORT and
                    self.apart(self.end[number], end) < 1.5 * SHORT):
                return number
        return None

    def apart(self, a, b):
        away = (a - b) % self.length
        return min(away, self.length - away)


def cut(panel, cuts, unit_cm=1.0):
    """The panel with its outline in the order of the walk, cut at these places, too."""
    outline = Outline(panel, unit_cm)
    places = []
    for c in sorted(c % outline.length for c in cuts):
        if all(outline.apart(c, other) > SHORT for other in places + outline.corners):
            places.append(c)
    vertices = [tuple(v) for v in panel["vertices"]]
    edges = []
    for number in outline.edges:
        source = panel["edges"][number]
        first, last = source["endpoints"][::-1] if outline.turned[number] else source["endpoints"]
        rest = {k: v for k, v in source.items() if k not in ("endpoints", "curvature")}
        parts, current = [], []
        for begin, end, curve, of in outline.curves:
            if of != number:
                continue
            whole = curve = [(x / unit_cm, y / unit_cm) for x, y in curve]
            done = 0.0
            for c in [c for c in places if begin < c < end]:
                t = _parameter(whole, (c - begin) / (end - begin))
                front, curve = split(curve, (t - done) / (1 - done))
                done = t
                parts.append(current + [front])
                current = []
            current.append(curve)
        parts.append(current)
        start = first
        for i, part in enumerate(parts):
            stop = last
            if i + 1 < len(parts):
                vertices.append(part[-1][-1])
                stop = len(vertices) - 1
            edges.append({**edge_of(part, start, stop), **rest})
            start = stop
    return {**panel, "vertices": [list(v) for v in vertices], "edges": edges}


def _parameter(curve, fraction):
    """The parameter of a curve at a fraction of its length."""
    if len(curve) == 2:
        return fraction
    points = [bezier(curve, i / STEPS) for i in range(STEPS + 1)]
    lengths = [0.0]
    for a, b in zip(points, points[1:]):
        lengths.append(lengths[-1] + math.dist(a, b))
    want = fraction * lengths[-1]
    i = min(bisect.bisect_right(lengths, want) - 1, STEPS - 1)
    return (i + (want - lengths[i]) / (lengths[i + 1] - lengths[i])) / STEPS


class Fit:
    """A way to lay one outline upon another: where it starts, and whether it is turned over."""

    def __init__(self, source, target, mirrored, shift):
        self.outline, self.mirrored, self.shift = target, mirrored, shift
        self.scale = target.length / source.length

    def image(self, at):
        ahead = at * self.scale
        return (self.shift - ahead if self.mirrored else self.shift + ahead) % self.outline.length


def fits(a, b, tolerance=0.3):
    """The ways in which outline `a` lies on `b` within the tolerance, the closest first."""
    if abs(a.length - b.length) > 4 * tolerance:
        return []
    points = [a.point(a.length * i / SAMPLES) for i in range(SAMPLES)]
    scale = b.length / a.length
    near = max(1.0, 4 * tolerance)  # of two that differ by less, the closer one is meant
    candidates = []
    for mirrored in (False, True):
        shifts = {round((s + c * scale if mirrored else s - c * scale) % b.length, 1)
                  for s in b.corners for c in a.corners}
        for shift in shifts:
            images = [b.point(shift + (-1 if mirrored else 1) * b.length * i / SAMPLES)
                      for i in range(SAMPLES)]
            distance = _distance(points, images, mirrored)
            if distance < tolerance:
                candidates.append((distance, mirrored, shift))
    found = []
    for _, mirrored, shift in sorted(candidates):
        if all(f.mirrored != mirrored or b.apart(f.shift, shift) >= near for f in found):
            found.append(Fit(a, b, mirrored, shift))
    return found


def _distance(points, images, mirrored):
    """The largest distance of two rows of points after the best rigid motion."""
    n = len(points)
    cx, cy = sum(p[0] for p in points) / n, sum(p[1] for p in points) / n
    ix, iy = sum(p[0] for p in images) / n, sum(p[1] for p in images) / n
    sign = -1 if mirrored else 1
    source = [(sign * (x - cx), y - cy) for x, y in points]
    target = [(x - ix, y - iy) for x, y in images]
    cos = sum(a[0] * b[0] + a[1] * b[1] for a, b in zip(source, target))
    sin = sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(source, target))
    size = math.hypot(cos, sin) or 1.0
    cos, sin = cos / size, sin / size
    return max(math.hypot(x * cos - y * sin - u, x * sin + y * cos - v)
               for (x, y), (u, v) in zip(source, target))
