"""Ways to spoil a pattern. Each takes the JSON and returns False where it does not apply."""
import math


def panels_of(pattern):
    return pattern["pattern"]["panels"]


def stitches_of(pattern):
    return pattern["pattern"]["stitches"]


def sides(stitch):
    return [(side["panel"], side["edge"]) for side in stitch[:2]]


def is_sleeve(name):
    return "sleeve" in name.lower() or "cuff" in name.lower()


def joins(stitch):
    return {panel for panel, _ in sides(stitch)}


def label(stitch):
    return stitch[2].get("name", "") if len(stitch) > 2 and isinstance(stitch[2], dict) else ""


def height(pattern, panel, edge):
    drawn = panels_of(pattern)[panel]
    ends = drawn["edges"][edge]["endpoints"]
    return sum(drawn["vertices"][end][1] for end in ends) / 2


def length(pattern, panel, edge):
    drawn = panels_of(pattern)[panel]
    return math.dist(*(drawn["vertices"][end] for end in drawn["edges"][edge]["endpoints"]))


def trunk(pattern):
    return [name for name in panels_of(pattern) if not is_sleeve(name)]


def open_top(pattern, panel):
    """The highest edge of a panel that no seam takes; None: there is none."""
    sewn = {side for stitch in stitches_of(pattern) for side in sides(stitch)}
    edges = [i for i in range(len(panels_of(pattern)[panel]["edges"])) if (panel, i) not in sewn]
    return max(edges, key=lambda i: height(pattern, panel, i), default=None)


def turn(stitch):
    how = stitch[2] if len(stitch) > 2 and isinstance(stitch[2], dict) else {}
    stitch[2:] = [{**how, "reversed": not how.get("reversed", True)}]


def side_seam(pattern):
    """A seam down a side, or under an arm or between the legs: by its name, else the longest."""
    two = [s for s in stitches_of(pattern) if len(joins(s)) == 2]
    named = [s for s in two if any(w in label(s) for w in ("side", "underarm", "inseam"))]
    long = [s for s in two if not any(map(is_sleeve, joins(s)))]
    return max(named or long, key=lambda s: length(pattern, *sides(s)[0]), default=None)


def armhole(pattern):
    """The seams of one sleeve with the trunk."""
    seams = [s for s in stitches_of(pattern) if sum(map(is_sleeve, joins(s))) == 1]
    of_sleeve = [next(p for p in joins(s) if is_sleeve(p)) for s in seams]
    left = [s for s, p in zip(seams, of_sleeve) if "left" in p]
    return left


def seam_turned(pattern):
    seam = side_seam(pattern)
    return seam is not None and (turn(seam) or True)


def two_seams_turned(pattern):
    seams = armhole(pattern)
    if len(seams) < 2:
        by_panels = {}
        for stitch in stitches_of(pattern):
            if len(joins(stitch)) == 2:
                by_panels.setdefault(frozenset(joins(stitch)), []).append(stitch)
        seams = max(by_panels.values(), key=len, default=[])
    if len(seams) < 2:
        return False
    for seam in seams[:2]:
        turn(seam)
    return True


def sleeves_exchanged(pattern):
    def other(name):
        return name.replace("left", "\0").replace("right", "left").replace("\0", "right")
    seams = {}  # by the panels that they join, the sleeve's first: the side of the sleeve
    for stitch in stitches_of(pattern):
        if sum(map(is_sleeve, joins(stitch))) == 1:
            sleeve, body = sorted(stitch[:2], key=lambda side: not is_sleeve(side["panel"]))
            seams[sleeve["panel"], body["panel"]] = sleeve
    pairs = [(side, seams.get((other(sleeve), other(body))))
             for (sleeve, body), side in seams.items() if "left" in sleeve]
    if not pairs or any(mirrored is None for _, mirrored in pairs):
        return False
    for side, mirrored in pairs:
        for key in ("panel", "edge"):
            side[key], mirrored[key] = mirrored[key], side[key]
    for panel in panels_of(pattern).values():
        for key in ("translation", "rotation", "placement"):
            panel.pop(key, None)
    return True


def sleeve_at_neckline(pattern):
    moved = False
    for stitch in armhole(pattern):
        for side in stitch[:2]:
            edge = None if is_sleeve(side["panel"]) else open_top(pattern, side["panel"])
            if edge is not None:
                side["edge"] = edge
                moved = True
    return moved


def turned_about(pattern, turned):
    """Turns the first panel of the trunk that stands by a translation about its middle."""
    for name in trunk(pattern):
        panel = panels_of(pattern)[name]
        if "translation" not in panel:
            continue
        turned(panel)
        return True
    return False


def mirrored(panel, flips):
    """A drawing that is turned by 180 degrees about its middle, of points relative to it."""
    points = panel["vertices"]
    middle = [(min(p[k] for p in points) + max(p[k] for p in points)) / 2 for k in (0, 1)]
    angles = [math.radians(a) for a in panel.get("rotation", [0, 0, 0])]

    def placed(p):
        x, y, z = p[0], p[1], 0
        y, z = y * math.cos(angles[0]) - z * math.sin(angles[0]), \
            y * math.sin(angles[0]) + z * math.cos(angles[0])
        x, z = x * math.cos(angles[1]) + z * math.sin(angles[1]), \
            z * math.cos(angles[1]) - x * math.sin(angles[1])
        return [x * math.cos(angles[2]) - y * math.sin(angles[2]),
                x * math.sin(angles[2]) + y * math.cos(angles[2]), z]
    before = placed(middle)
    panel["rotation"] = [a + f for a, f in zip(panel.get("rotation", [0, 0, 0]), flips)]
    angles[:] = [math.radians(a) for a in panel["rotation"]]
    after = placed(middle)
    panel["translation"] = [t + b - a for t, b, a in zip(panel["translation"], before, after)]


def upside_down(pattern):
    return turned_about(pattern, lambda panel: mirrored(panel, (0, 0, 180)))


def inside_out(pattern):
    return turned_about(pattern, lambda panel: mirrored(panel, (0, 180, 0)))


def panel_missing(pattern):
    names = trunk(pattern)
    if len(names) < 3:
        return False
    gone = names[0]
    del panels_of(pattern)[gone]
    stitches_of(pattern)[:] = [s for s in stitches_of(pattern) if gone not in joins(s)]
    order = pattern["pattern"].get("panel_order")
    if order:
        order.remove(gone)
    return True


def part_misstated(pattern):
    for name in trunk(pattern):
        panel = panels_of(pattern)[name]
        old = panel.get("placement", {}).get("part", panel.get("label", "torso"))
        part = "left_arm" if "leg" in old else "left_leg"
        panel["placement"] = {"part": part}
    return True


def side_open(pattern):
    seam = side_seam(pattern)
    if seam is None:
        return False
    stitches_of(pattern).remove(seam)
    return True


def opening_shut(pattern):
    tops = [(n, open_top(pattern, n)) for n in trunk(pattern)]
    tops = [(n, e) for n, e in tops if e is not None]
    if len(tops) < 2:
        return False
    first = max(tops, key=lambda t: height(pattern, *t))
    # Its partner is joined to it by a seam.
    beside = [t for t in tops if t[0] != first[0] and
              any(joins(s) == {t[0], first[0]} for s in stitches_of(pattern))]
    if not beside:
        return False
    second = max(beside, key=lambda t: height(pattern, *t))
    stitches_of(pattern).append([{"panel": p, "edge": e} for p, e in (first, second)])
    return True


def scaled(factor):
    def scale(pattern):
        for panel in panels_of(pattern).values():
            points = panel["vertices"]
            middle = [(min(p[k] for p in points) + max(p[k] for p in points)) / 2 for k in (0, 1)]
            panel["vertices"] = [[m + factor * (x - m) for x, m in zip(p, middle)] for p in points]
            for edge in panel["edges"]:
                curve = edge.get("curvature")
                if isinstance(curve, dict) and curve.get("type") == "circle":
                    curve["params"][0] *= factor
        return True
    return scale


WAYS = {"seam turned": seam_turned, "two seams turned": two_seams_turned,
        "sleeves exchanged": sleeves_exchanged, "sleeve at the neckline": sleeve_at_neckline,
        "panel upside down": upside_down, "panel inside out": inside_out,
        "panel missing": panel_missing, "part misstated": part_misstated,
        "side open": side_open, "opening shut": opening_shut,
        "cut at 0.7": scaled(0.7), "cut at 1.4": scaled(1.4)}
