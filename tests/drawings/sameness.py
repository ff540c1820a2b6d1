"""What the programs make of a drawing, and whether that of two drawings is the same."""
import json
import math
import pathlib
import tempfile

import labels
import outlines
import turning

SAME = 0.01  # cm by which edges may differ
SEAM = 0.2  # cm by which the ends of sewn edges may differ: a part of an edge is cut by its length


class Pattern:
    """What the programs make of a drawing: panels as edges' ends and lengths, seams as edges."""

    def __init__(self, file, options, seams):
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "pattern.json"
            done = labels.program("import-pattern", file, "-o", out, *options)
            if not out.exists():
                raise ValueError("not read: " + done.stderr.strip().splitlines()[-1])
            read = json.loads(out.read_text())
            sewn = pathlib.Path(folder) / "sewn.json"
            if seams and read["pattern"]["stitches"]:
                sewn = out  # the drawing states them
            elif seams:
                done = labels.program("find-seams", out, "-o", sewn)
                if not sewn.exists():
                    raise ValueError("find-seams: " + done.stderr.strip().splitlines()[-1])
            found = json.loads(sewn.read_text()) if seams else read
        panels = read["pattern"]["panels"]
        unit = 100 / read["properties"]["units_in_meter"]
        self.up_unknown = read["properties"].get("up") == "unknown"
        walks = {name: outlines.Outline(panel, unit)
                 for name, panel in panels.items()}
        self.middle = {name: ((walk.low[0] + walk.high[0]) / 2, (walk.low[1] + walk.high[1]) / 2)
                       for name, walk in walks.items()}
        self.panels = {name: [self.edge(name, walk, n) for n in walk.edges]
                       for name, walk in walks.items()}
        self.notches = {name: [notch["vertex"] for notch in panel.get("notches", [])]
                        for name, panel in panels.items()}
        self.quantities = {name: panel.get("quantity", 1) for name, panel in panels.items()}
        cut = {name: outlines.Outline(panel, unit)
               for name, panel in found["pattern"]["panels"].items()}
        self.seams = [tuple((side["panel"], self.edge(side["panel"], cut[side["panel"]],
                                                      side["edge"])) for side in stitch[:2])
                      for stitch in found["pattern"].get("stitches", [])] if seams else []

    def edge(self, name, walk, number):
        """Start, middle, end from the middle of the panel's box, cm."""
        mx, my = self.middle[name]
        points = []
        for at in (walk.begin[number], (walk.begin[number] + walk.end[number]) / 2,
                   walk.end[number]):
            x, y = walk.point(at)
            points.append((x + walk.low[0] - mx, y + walk.low[1] - my))
        return points

    def moved(self, motion):
        """The same pattern, mirrored or on its head. Names stay, as texts do."""
        other = Pattern.__new__(Pattern)

        def edge(points):
            points = [motion.point(*p) for p in points]
            return points[::-1] if motion.mirrored else points

        other.panels = {name: [edge(e) for e in edges]
                        for name, edges in self.panels.items()}
        other.seams = [tuple((name, edge(e)) for name, e in seam) for seam in self.seams]
        return other


def is_same(a, b, near):
    return all(math.dist(p, q) <= near for p, q in zip(a, b))


def panels_that_differ(pattern, other):
    differ = sorted(set(pattern.panels) ^ set(other.panels))
    for name in set(pattern.panels) & set(other.panels):
        mine, theirs = pattern.panels[name], other.panels[name]
        if len(mine) != len(theirs) or not all(any(is_same(e, f, SAME) for f in theirs)
                                               for e in mine):
            differ.append(f"{name} ({len(mine)} edges, {len(theirs)})")
    return sorted(differ)


def seams_that_differ(pattern, other):
    """Seams of each that the other has not."""
    def same(a, b):
        return any(all(s[0] == t[0] and is_same(s[1], t[1], SEAM) for s, t in zip(a, way))
                   for way in (b, b[::-1]))

    return ([s for s in pattern.seams if not any(same(s, t) for t in other.seams)],
            [s for s in other.seams if not any(same(s, t) for t in pattern.seams)])


OWN_IMAGES = [turning.Motion(180), turning.Motion(0, True), turning.Motion(180, True)]


def as_own_images(pattern, other):
    """Differing seams where a panel may change places with its own image, if that makes them less.

    A band has a left end by its place in the drawing only.
    """
    best = seams_that_differ(pattern, other)
    for name, edges in pattern.panels.items():
        for motion in OWN_IMAGES:
            if not best[0] and not best[1]:
                return best

            def image(edge):
                edge = [motion.point(*p) for p in edge]
                return edge[::-1] if motion.mirrored else edge

            if not all(any(is_same(image(e), f, SAME) for f in edges) for e in edges):
                continue
            trial = Pattern.__new__(Pattern)
            trial.seams = [tuple((panel, image(edge) if panel == name else edge)
                                 for panel, edge in seam) for seam in pattern.seams]
            now = seams_that_differ(trial, other)
            if len(now[0]) < len(best[0]):
                pattern, best = trial, now
    return best
