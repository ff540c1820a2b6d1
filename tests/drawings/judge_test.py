#!/usr/bin/env python3
"""The judge on a made skirt of two panels and a band, and labels on real drawings. By ctest."""
import importlib.machinery
import importlib.util
import json
import math
import pathlib
import tempfile
import unittest

import comparison
import labels
import outlines


def panel(*vertices):
    count = len(vertices)
    return {"vertices": [list(v) for v in vertices],
            "edges": [{"endpoints": [i, (i + 1) % count]} for i in range(count)]}


# The back's right side is longer than its left one, so that its sides cannot change places.
FRONT = panel((0, 0), (40, 0), (35, 60), (5, 60))
BACK = panel((0, 0), (44, 4), (38, 64), (6, 60))
BAND = panel((0, 0), (62, 0), (62, 8), (0, 8))
FRONT_SIDE = outlines.Outline(FRONT).end[1] - outlines.Outline(FRONT).begin[1]
BACK_LENGTH = outlines.Outline(BACK).length
PATTERN = {
    "pattern": {"panels": {"front": FRONT, "back": BACK, "band": BAND}, "stitches": []},
    "properties": {"units_in_meter": 100, "curvature_coords": "relative",
                   "normalized_edge_loops": True},
}


def side(piece, start, end):
    return {"piece": piece, "from": list(start), "to": list(end)}


LABEL = {
    "pieces": [{"box": [40, 60]}, {"box": [44, 64]}, {"box": [62, 8]}],
    "seams": [
        {"what": "side", "a": side(0, (40, 0), (35, 60)), "b": side(1, (6, 60), (0, 0))},
        {"what": "side", "a": side(0, (5, 60), (0, 0)), "b": side(1, (44, 4), (38, 64))},
        {"what": "waist", "a": side(2, (0, 0), (30, 0)), "b": side(0, (35, 60), (5, 60)),
         "around": "waist"},
        {"what": "waist", "a": side(2, (30, 0), (62, 0)), "b": side(1, (38, 64), (6, 60)),
         "around": "waist"},
        {"what": "band", "a": side(2, (62, 0), (62, 8)), "b": side(2, (0, 8), (0, 0))},
    ],
}


class JudgeTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        file = pathlib.Path(folder.name) / "skirt.json"
        file.write_text(json.dumps(PATTERN))
        self.file = file
        self.label = labels.Label(json.dumps(LABEL))
        self.imported = self.label.imported(file)[1]

    def judged(self, *stitches, cuts=None, confidence=1.0):
        panels = {name: outlines.cut(panel, (cuts or {}).get(name, []))
                  for name, panel in self.imported.panels.items()}
        walks = {name: outlines.Outline(panel) for name, panel in panels.items()}
        found = []
        for stitch in stitches:
            (a, b), backward = stitch[:2], stitch[2:] != ("along",)
            entry = {"a": dict(zip(("panel", "edge"), a)), "b": dict(zip(("panel", "edge"), b)),
                     "reversed": backward, "confidence": confidence}
            found.append(comparison.Found(entry, walks, self.imported, {n: n for n in panels}))
        row = comparison.Judge(self.label, self.imported).judge(found, 0.85)
        return tuple(row[key] for key in ("right", "wrong", "missing", "undecided"))

    LEFT = (("front", 1), ("back", 3))
    RIGHT = (("front", 3), ("back", 1))

    def test_the_labelled_pattern_is_all_right(self):
        pattern = labels.labelled_pattern(self.label, self.imported)["pattern"]
        self.assertEqual(len(pattern["stitches"]), 5)
        stitches = [tuple((end["panel"], end["edge"]) for end in stitch)
                    for stitch in pattern["stitches"]]
        self.assertEqual(self.judged(*stitches, cuts={"band": [30]}), (5, 0, 0, 0))

    def test_a_label_holds_where_pieces_lie_turned(self):
        turned = json.loads(json.dumps(PATTERN))
        for panel, degrees in (("front", 180), ("back", 33)):
            vertices = turned["pattern"]["panels"][panel]["vertices"]
            c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
            vertices[:] = [[x * c - y * s, x * s + y * c] for x, y in vertices]
        self.file.write_text(json.dumps(turned))
        self.imported = self.label.imported(self.file)[1]
        self.assertEqual(self.judged(self.LEFT, self.RIGHT), (2, 0, 3, 0))

    def test_a_seam_that_runs_the_other_way_is_wrong(self):
        self.assertEqual(self.judged(self.LEFT, (*self.RIGHT, "along")), (1, 1, 4, 0))

    def test_a_seam_to_another_edge_is_wrong(self):
        self.assertEqual(self.judged(self.LEFT, (("front", 3), ("back", 2))), (1, 1, 4, 0))

    def test_an_unsure_seam_is_undecided(self):
        self.assertEqual(self.judged(self.LEFT, self.RIGHT, confidence=0.5), (0, 0, 3, 2))

    def test_a_part_of_a_seam_is_right_and_does_not_cover_it(self):
        half = {"front": [40 + FRONT_SIDE / 2], "back": [BACK_LENGTH - 30]}
        upper, lower = (("front", 2), ("back", 3)), (("front", 1), ("back", 4))
        self.assertEqual(self.judged(upper, lower, cuts=half), (1, 0, 4, 0))
        self.assertEqual(self.judged(upper, cuts=half), (0, 0, 5, 0))

    def test_a_band_may_be_turned_around_the_body(self):
        turned = {"band": [32]}
        self.assertEqual(self.judged(self.LEFT, self.RIGHT, (("band", 0), ("back", 2)),
                                     (("band", 1), ("front", 2)), cuts=turned), (4, 0, 1, 0))

    def test_a_band_may_change_its_edges(self):
        self.assertEqual(self.judged((("band", 2), ("back", 2)), (("band", 3), ("front", 2)),
                                     (("band", 1), ("band", 4)), cuts={"band": [102]}),
                         (3, 0, 2, 0))


def program(name):
    """A program of this folder, as a module."""
    loader = importlib.machinery.SourceFileLoader(name, str(labels.HERE / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(module)
    return module


class FiguresTest(unittest.TestCase):
    def test_words_hold_for_the_same_seams_and_verdict_alone(self):
        figures = program("drawing-figures")

        def seam(a, b):
            return {"a": {"panel": "front", "edge": a}, "b": {"panel": "back", "edge": b}}

        seams = {"seams": [seam(1, 3), seam(3, 1)], "undecided": [seam(0, 0)]}
        mark = figures.mark(seams, "sewn")
        turned = {"seams": [{"a": s["b"], "b": s["a"]} for s in reversed(seams["seams"])]}
        self.assertEqual(figures.mark(turned, "sewn"), mark)
        self.assertNotEqual(figures.mark(seams, "too_tight"), mark)
        self.assertNotEqual(figures.mark({"seams": seams["seams"][:1]}, "sewn"), mark)

    def test_each_line_of_looked_has_a_drawing_a_mark_and_words(self):
        for (name, mark), words in program("drawing-figures").looked_at().items():
            self.assertTrue(labels.has(name.removesuffix(".told")), name)
            self.assertRegex(mark, "^[0-9a-f]{8}$")
            self.assertTrue(words)


class LabelsTest(unittest.TestCase):
    @unittest.skipUnless(labels.DATA.is_dir(), "no real drawings here")
    def test_labels_fit_what_is_imported(self):
        for source in labels.SOURCES:
            for name, file in labels.files_of(source).items():
                with self.subTest(name):
                    label = labels.load(name)
                    labels.labelled_pattern(label, label.imported(file)[1])


if __name__ == "__main__":
    unittest.main()
