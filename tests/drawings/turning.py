"""Drawings turned and mirrored as a whole: DXF coordinate by coordinate, SVG by an outer group."""
import math
import re

PAIRS = {10: 20, 11: 21, 12: 22, 13: 23}


class Motion:
    """A turn by degrees, counter-clockwise, after a mirror image that exchanges left and right."""

    def __init__(self, degrees, mirrored=False):
        self.degrees, self.mirrored = degrees, mirrored
        # Quarter turns are exact.
        self.cos = round(math.cos(math.radians(degrees)), 15)
        self.sin = round(math.sin(math.radians(degrees)), 15)

    def __str__(self):
        return "mirrored" if self.mirrored else f"{self.degrees} degrees"

    def point(self, x, y):
        if self.mirrored:
            x = -x
        return x * self.cos - y * self.sin, x * self.sin + y * self.cos

    def angle(self, degrees):
        return self.degrees + (180 - degrees if self.mirrored else degrees)


def turned(content, suffix, motion):
    """The drawing's bytes, moved."""
    if suffix.lower() == ".svg":
        return turned_svg(content, motion)
    return turned_dxf(content, motion)


def turned_svg(content, motion):
    """All that is drawn, in one group more: as an editor writes what was turned in it."""
    a, b = motion.point(1, 0)
    c, d = motion.point(0, 1)
    # y is down in SVG.
    matrix = "matrix(%.15g %.15g %.15g %.15g 0 0)" % (a, -b, -c, d)
    head = re.search(rb"<svg\b[^>]*>", content).end()
    tail = content.rindex(b"</svg>")
    return (content[:head] + b'<g transform="' + matrix.encode() + b'">' + content[head:tail] +
            b"</g>" + content[tail:])


def turned_dxf(content, motion):
    lines = content.split(b"\n")
    if lines and not lines[-1].strip():
        lines.pop()
    groups = [[int(lines[i]), lines[i + 1].strip(b"\r")] for i in range(0, len(lines) - 1, 2)]
    starts = [i for i, (code, _) in enumerate(groups) if code == 0] + [len(groups)]
    section = b""
    for start, end in zip(starts, starts[1:]):
        kind = groups[start][1].strip()
        if kind == b"SECTION":
            section = groups[start + 1][1].strip()
        elif section in (b"BLOCKS", b"ENTITIES"):
            _turn(kind, groups, start + 1, end, motion)
    return b"\n".join(b"%3d\n%s" % (code, value) for code, value in groups) + b"\n"


def _turn(kind, groups, start, end, motion):
    """Moves one entity in place."""
    x_of, values = {}, {}
    for i in range(start, end):
        code = groups[i][0]
        if code in PAIRS:
            x_of[PAIRS[code]] = i
        elif code in x_of:
            k = x_of.pop(code)
            x, y = motion.point(float(groups[k][1]), float(groups[i][1]))
            groups[k][1], groups[i][1] = b"%.12g" % x, b"%.12g" % y
        elif code in (41, 42, 50, 51, 230):
            values.setdefault(code, i)
            if code == 42 and kind in (b"VERTEX", b"LWPOLYLINE") and motion.mirrored:
                groups[i][1] = b"%.12g" % -float(groups[i][1])  # a bulge

    def value(code, default=0.0):
        return float(groups[values[code]][1]) if code in values else default

    def put(code, number):
        groups[values[code]][1] = b"%.12g" % number

    if value(230, 1.0) < 0:
        raise ValueError(f"{kind.decode()} is seen from behind")
    if kind in (b"TEXT", b"ATTRIB", b"ATTDEF", b"POINT") and 50 in values:
        put(50, motion.angle(value(50)))
    elif kind == b"ARC":
        first, last = value(50), value(51)
        if motion.mirrored:
            first, last = last, first
        put(50, motion.angle(first)), put(51, motion.angle(last))
    elif kind == b"ELLIPSE" and motion.mirrored:
        first, last = value(41), value(42)
        put(41, -last), put(42, -first)
    elif kind == b"INSERT":
        flipped = value(41, 1.0) * value(42, 1.0) < 0
        turn = -value(50) if motion.mirrored else value(50)
        turn += 2 * motion.degrees if flipped else 0
        if 50 in values:
            put(50, turn)
        elif turn:
            raise ValueError("an INSERT that is mirrored has no group 50")
