#!/usr/bin/env python3
"""The module toile against the programs: library_test.py TOOLS SAMPLES, with PYTHONPATH set."""
import ast
import inspect
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import toile

TOOLS, SAMPLES = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
# What names a file, or says how long something took.
APART = {"inputs", "pattern", "drawing", "garment_file", "body_file", "file"}


def run(program, *words):
    """What the program says on stderr. It ends well, or with a verdict."""
    done = subprocess.run([TOOLS / program, *map(str, words)], stderr=subprocess.PIPE, text=True)
    assert done.returncode in (0, 1, 3), done.stderr
    return done.stderr


def plain(value, apart=APART):
    """A report without files' names and times."""
    if isinstance(value, list):
        return [plain(item, apart) for item in value]
    if not isinstance(value, dict):
        return value
    return {key: plain(item, apart) for key, item in value.items()
            if key not in apart and "seconds" not in key}


class AsThePrograms(unittest.TestCase):
    """The sample T-shirt on the sample mannequin, at 25 mm: by the programs, and by the library."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        at = cls.at = pathlib.Path(cls.folder.name)
        run("make-mannequin", "-o", at / "body.ply", "--report", at / "body.json", "-q")
        run("mesh-pattern", SAMPLES / "tshirt.json", "-o", at / "garment.obj", "--edge-length", "25mm",
            "--report", at / "mesh.json", "-q")
        run("dress", "--body", at / "body.ply", at / "garment.obj", "-o", at / "dressed.obj",
            "--report", at / "dressed.json", "-q")
        run("ease-map", "--body", at / "body.ply", at / "dressed.obj", "-o", at / "ease.html",
            "--report", at / "ease.json", "-q")
        cls.body = toile.mannequin()
        cls.garment = toile.mesh(toile.read_pattern(SAMPLES / "tshirt.json"), edge_length=0.025)
        cls.drape = toile.dress(cls.garment, cls.body)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def report(self, name):
        return json.loads((self.at / name).read_text())

    def assert_same(self, ours, theirs, apart=APART):
        ours, theirs = plain(ours, apart), plain(theirs, apart)
        self.assertEqual({key for key in {**ours, **theirs} if ours.get(key) != theirs.get(key)}, set())

    def test_body(self):
        read = toile.read_body(self.at / "body.ply")
        np.testing.assert_array_equal(read.points, self.body.points)
        np.testing.assert_array_equal(read.triangles, self.body.triangles)
        self.assertEqual(read.joints, self.body.joints)
        self.assert_same(self.body.report, self.report("body.json"))

    def test_garment(self):
        read = toile.read_garment(self.at / "garment.obj")
        for name in ("flat", "placed", "triangles"):
            np.testing.assert_array_equal(getattr(read, name), getattr(self.garment, name))
        self.assertEqual(read.json, self.garment.json)
        self.assert_same(self.garment.report, self.report("mesh.json"))

    def test_drape(self):
        read = toile.read_drape(self.at / "dressed.obj", self.garment)
        np.testing.assert_array_equal(read.points, self.drape.points)
        np.testing.assert_array_equal(read.triangles, self.drape.triangles)
        report = self.drape.report
        self.assertEqual(report["verdict"], "sewn")
        self.assertEqual(report["dressed_sha256"], self.report("dressed.json")["dressed_sha256"])
        self.assert_same(report, self.report("dressed.json"))
        self.assert_same(read.report, self.report("dressed.json"), set())

    def test_judge(self):
        judged = toile.judge(self.drape, self.body)
        self.assertIn("verdict", judged)
        self.assertEqual(judged, {key: self.drape.report[key] for key in judged})
        # A control: pushed into the body it is another verdict.
        pushed = toile.Drape(self.drape.points + [0.01, 0, 0], self.drape.triangles, self.garment)
        self.assertEqual(toile.judge(pushed, self.body)["verdict"], "intersecting")

    def test_ease(self):
        ease = toile.ease(self.drape, self.body)
        self.assert_same(ease, self.report("ease.json"))
        gaps = toile.gaps(self.drape, self.body)
        self.assertEqual(gaps.shape, self.drape.points.shape[:1])
        self.assertLess(0.001, gaps.min())
        self.assertLess(gaps.max(), 0.2)

    def test_measure(self):
        run("measure-body", self.at / "body.ply", "-o", self.at / "measures.json", "-q")
        theirs = self.report("measures.json")
        self.assertGreater(len(theirs["measures"]), 30)
        self.assert_same(toile.measure(self.body), theirs, {"body"})

    def test_clean(self):
        run("make-mannequin", "-o", self.at / "raw.obj", "--edge-length", "15mm", "-q")
        (self.at / "raw.body.json").unlink()
        run("clean-body", self.at / "raw.obj", "-o", self.at / "clean.ply", "--report",
            self.at / "clean.json", "-q")
        theirs = toile.read_body(self.at / "clean.ply")
        for given in (toile.read_mesh(self.at / "raw.obj"), [self.at / "raw.obj"]):
            ours = toile.clean(given)
            np.testing.assert_array_equal(ours.points, theirs.points)
            self.assertEqual(ours.joints, theirs.joints)
            self.assert_same(ours.report, self.report("clean.json"))

    def test_pattern(self):
        run("export-pattern", SAMPLES / "tshirt.json", "-o", self.at / "tshirt.dxf", "-q")
        run("import-pattern", self.at / "tshirt.dxf", "-o", self.at / "drawn.json", "--report",
            self.at / "import.json", "-q")
        drawn = toile.import_pattern(self.at / "tshirt.dxf")
        self.assertEqual(drawn.json, self.report("drawn.json"))
        self.assert_same(drawn.report, self.report("import.json"))
        run("find-seams", self.at / "drawn.json", "-o", self.at / "sewn.json", "--report",
            self.at / "seams.json", "-q")
        sewn = toile.find_seams(toile.read_pattern(self.at / "drawn.json"))
        self.assertEqual(sewn.json, self.report("sewn.json"))
        self.assertGreater(len(sewn.report["seams"]), 8)
        self.assert_same(sewn.report, self.report("seams.json"))

    def test_files(self):
        other = self.at / "written"
        other.mkdir()
        toile.write(self.body, other / "body.ply")
        toile.write(self.garment, other / "garment.obj")
        toile.write(self.drape, other / "dressed.obj")
        for name in ("body.ply", "body.body.json", "garment.obj", "garment.garment.json",
                     "dressed.obj"):
            self.assertEqual((other / name).read_bytes(), (self.at / name).read_bytes(), name)

    def test_threads(self):
        """Four at once give the same bits as one after the other."""
        band = toile.mesh(toile.read_pattern(SAMPLES / "band.json"), edge_length=0.025)
        wide = toile.mannequin({"height": 168, "bust": 96, "waist": 78, "hip": 104})
        works = [(self.garment, self.body), (band, self.body), (self.garment, wide), (band, wide)]
        alone = [toile.dress(*work, quality="draft") for work in works]
        with ThreadPoolExecutor(4) as four:
            at_once = list(four.map(lambda work: toile.dress(*work, quality="draft"), works))
            eases = list(four.map(lambda at: toile.ease(at[0], at[1][1]), zip(at_once, works)))
        for one, other in zip(alone, at_once):
            np.testing.assert_array_equal(one.points, other.points)
            self.assert_same(one.report, other.report)
        self.assert_same(eases[0], toile.ease(alone[0], self.body))
        self.assertFalse(np.array_equal(alone[0].points, alone[2].points))

    def test_lock(self):
        """Python goes on while a garment is dressed."""
        thread = threading.Thread(target=toile.dress, args=(self.garment, self.body))
        begin = last = time.monotonic()
        longest = 0
        thread.start()
        while thread.is_alive():
            time.sleep(0.001)
            longest, last = max(longest, time.monotonic() - last), time.monotonic()
        self.assertLess(longest, (last - begin) / 3)

    def test_silence(self):
        """Warnings stand in the report, and are not printed."""
        script = ("import sys, toile; drape = toile.dress(toile.mesh(toile.read_pattern(sys.argv[1]), "
                  "edge_length=0.025), toile.mannequin(), quality='draft'); "
                  "assert drape.report['warnings']; toile.ease(drape, toile.mannequin())")
        done = subprocess.run([sys.executable, "-c", script, SAMPLES / "band_small.json"],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assertEqual((done.returncode, done.stdout), (0, ""))


class Errors(unittest.TestCase):
    def said(self, work):
        with self.assertRaises(toile.Error) as caught:
            work()
        return str(caught.exception)

    def test_words_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            at = pathlib.Path(folder)
            (at / "bad.json").write_text('{"pattern": {"panels": {"front": {"vertices": [[0, 0')
            said = self.said(lambda: toile.read_pattern(at / "bad.json"))
            self.assertIn("bad.json", said)
            self.assertEqual(run("mesh-pattern", at / "bad.json", "-o", at / "bad.obj", "-q"),
                             f"mesh-pattern: error: {said}\n")
            self.assertIn("missing.ply", self.said(lambda: toile.read_body(at / "missing.ply")))
            open_body = toile.mannequin()
            open_body.triangles = open_body.triangles[1:]
            toile.write(open_body, at / "open.ply")
            said = self.said(lambda: toile.measure(open_body))
            self.assertEqual(run("measure-body", at / "open.ply", "-o", at / "measures.json", "-q"),
                             f"measure-body: error: {said.replace('body:', str(at / 'open.ply') + ':', 1)}\n")

    def test_values(self):
        body, pattern = toile.mannequin(), toile.read_pattern(SAMPLES / "band.json")
        garment = toile.mesh(pattern, edge_length=0.025)
        wrong = toile.Garment(garment.flat, garment.placed, garment.triangles + 10000, garment.json)
        other = toile.Body(body.points, body.triangles,
                           {**body.joints, "joints": {**body.joints["joints"], "waist": [5, 1, 0]}})
        for word, work in [
                ("edge_length", lambda: toile.mesh(pattern, edge_length=-1)),
                ("subdivisions", lambda: toile.mesh(pattern, subdivisions=9)),
                ("quality", lambda: toile.dress(garment, body, quality="best")),
                ("chiffon-of-lead", lambda: toile.dress(garment, body, fabric="chiffon-of-lead")),
                ("triangle 0", lambda: toile.dress(wrong, body)),
                ("waist", lambda: toile.dress(garment, other)),
                ("3 columns", lambda: toile.Mesh([[0, 1]])),
                ("indices", lambda: toile.Mesh([[0, 1, 2]], [[0.5, 1, 2]])),
                ("finite", lambda: toile.clean(toile.Mesh([[0, 1, np.nan]]))),
                ("bust", lambda: toile.mannequin({"bust": -3}))]:
            self.assertIn(word, self.said(work))


class Stubs(unittest.TestCase):
    def test_signatures(self):
        """The stubs have the names and arguments of the module."""
        stubs = pathlib.Path(toile.__file__).with_suffix(".pyi").read_text()
        typed = {}
        for node in ast.parse(stubs).body:
            if isinstance(node, ast.ClassDef):
                typed[node.name] = {item.target.id for item in node.body
                                    if isinstance(item, ast.AnnAssign)}
            elif isinstance(node, ast.FunctionDef):
                words = node.args.args + node.args.kwonlyargs
                typed.setdefault(node.name, []).append([word.arg for word in words])
        self.assertEqual(set(typed), set(toile.__all__))
        for name, words in typed.items():
            value = getattr(toile, name)
            if isinstance(words, set):
                members = {key for key, item in vars(value).items() if isinstance(item, property)}
                self.assertEqual(members, words, name)
                continue
            lines = [line for line in inspect.getdoc(value).splitlines()
                     if re.match(rf"(\d+\. )?{name}\(", line) and "*args" not in line]
            self.assertEqual(len(lines), max(len(words), 4 if name == "write" else 0), name)
            for line in lines:
                given = [a or b for a, b in re.findall(r", (\w+):|\((\w+):", line)]
                self.assertIn(given, words, name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
