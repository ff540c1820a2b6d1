#!/usr/bin/env python3
"""A pattern with seams is drawn as DXF, read and drawn again: edges and seams stay. By ctest."""
import json
import pathlib
import subprocess
import tempfile
import unittest

import labels
import outlines

SAMPLES = ("tshirt", "trousers", "jacket", "bodice_dress", "gathered_skirt")
DRAWN = ("freesewing/brian.svg", "freesewing/carlton.svg", "valentina/TShirt_test.dxf")
NEAR = 0.001  # cm
FIT = 0.02  # cm by which edges of a pattern that was never drawn may change


def program(name, *arguments):
    done = labels.program(name, *arguments)
    if done.returncode not in (0, 3):
        raise ValueError(f"{name}: {done.stderr}")


class Sewn:
    """Panels as walked outlines; seams by places: both sides from the end where they begin."""

    def __init__(self, file):
        read = json.loads(file.read_text())
        self.pattern = read["pattern"]
        unit = 100 / read["properties"]["units_in_meter"]
        self.walks = {name: outlines.Outline(panel, unit)
                      for name, panel in self.pattern["panels"].items()}

    def seams(self):
        for stitch in self.pattern["stitches"]:
            how = stitch[2] if len(stitch) > 2 and isinstance(stitch[2], dict) else {}
            sides = []
            for i, side in enumerate(stitch[:2]):
                walk, edge = self.walks[side["panel"]], side["edge"]
                ends = [walk.point(walk.begin[edge]), walk.point(walk.end[edge])]
                backward = walk.turned[edge]
                if i == 1 and how.get("reversed", True):
                    backward = not backward
                sides.append((side["panel"], ends[::-1] if backward else ends))
            yield sides


def far(a, b):
    return max(abs(p - q) for s, t in zip(a, b) for p, q in zip(s, t))


class RoundTripTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def there_and_back(self, file, name):
        drawing, back = self.folder / (name + ".dxf"), self.folder / (name + ".json")
        program("export-pattern", file, "-o", drawing)
        audit = subprocess.run([labels.ROOT / "tests/support/read_dxf", drawing],
                               stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        self.assertEqual(audit.returncode, 0, audit.stderr)
        program("import-pattern", drawing, "-o", back)
        return back

    def check(self, file):
        once = self.there_and_back(file, "once")
        twice = self.there_and_back(once, "twice")
        first, second, third = Sewn(file), Sewn(once), Sewn(twice)
        self.assertEqual(len(first.pattern["stitches"]), len(second.pattern["stitches"]))
        for mine, theirs in zip(first.seams(), second.seams()):
            # Both sides may be begun from the other end.
            turned = [(panel, ends[::-1]) for panel, ends in theirs]
            self.assertEqual([panel for panel, _ in mine], [panel for panel, _ in theirs])
            self.assertLess(min(max(far(a[1], b[1]) for a, b in zip(mine, way))
                                for way in (theirs, turned)), FIT)
        self.assertEqual(second.pattern["stitches"], third.pattern["stitches"])
        self.assertEqual(second.pattern["panel_order"], third.pattern["panel_order"])
        for name, panel in second.pattern["panels"].items():
            again = third.pattern["panels"][name]
            for key in ("side", "left_out", "grain", "quantity", "material"):
                self.assertEqual(panel.get(key), again.get(key), f"{name}: {key}")
            self.assertEqual([n["vertex"] for n in panel.get("notches", [])],
                             [n["vertex"] for n in again.get("notches", [])])
            walk, other = second.walks[name], third.walks[name]
            self.assertEqual(len(walk.edges), len(other.edges), name)
            for edge in walk.edges:
                self.assertLess(far([walk.point(walk.begin[edge])],
                                    [other.point(other.begin[edge])]), NEAR, f"{name}:{edge}")
                for k in range(11):
                    at = walk.begin[edge] + (walk.end[edge] - walk.begin[edge]) * k / 10
                    self.assertLess(other.place(walk.point(at))[1], NEAR, f"{name}:{edge}")

    def test_samples(self):
        for name in SAMPLES:
            with self.subTest(name):
                self.check(labels.ROOT / "samples" / (name + ".json"))

    @unittest.skipUnless(labels.DATA.is_dir(), "no real drawings here")
    def test_drawings_whose_seams_were_found(self):
        for name in DRAWN:
            with self.subTest(name):
                program("import-pattern", labels.DATA / name, "-o", self.folder / "drawn.json")
                program("find-seams", self.folder / "drawn.json", "-o", self.folder / "sewn.json")
                self.check(self.folder / "sewn.json")


if __name__ == "__main__":
    unittest.main()
