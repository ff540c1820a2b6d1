#!/usr/bin/env python3
"""The workflow on three garments, with Snakemake: workflow_test.py TOOLS. It is skipped where that is missing."""
import csv
import hashlib
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[2]
TOOLS = pathlib.Path(sys.argv.pop(1)).resolve()
HEADER = "body,pattern,fabric,edge_length,options,season,size"
ROWS = ["body.ply,band.json,,40mm,--quality draft,summer,",
        "body.ply,band.json,denim,40mm,--quality draft,winter,",
        "body.ply,band.json,broken.json,40mm,--quality draft,never,"]


SIZE = "  0\nTEXT\n  8\n1\n 10\n0\n 20\n0\n 40\n5\n  1\nSize: {}\n  0\nENDBLK"


def program(name, *words):
    subprocess.run([TOOLS / name, *words, "-q"], check=True, stdout=subprocess.DEVNULL)


def draw_graded(folder, pattern, sizes):
    """graded.dxf of a pattern whose panels are `sizes[size]` times as wide in each size."""
    blocks = ""
    for size, width in sizes.items():
        graded = json.loads(pattern.read_text())
        for panel in graded["pattern"]["panels"].values():
            panel["vertices"] = [[width * x, y] for x, y in panel["vertices"]]
        (folder / "one.json").write_text(json.dumps(graded))
        program("export-pattern", folder / "one.json", "-o", folder / "one.dxf")
        drawn = (folder / "one.dxf").read_text()
        start = drawn.index("BLOCKS\n") + len("BLOCKS\n")
        end = drawn.index("  0\nENDSEC", start)
        named = re.sub(r"(BLOCK\n  8\n.*\n  2\n)(.*)", rf"\g<1>\g<2>_{size}", drawn[start:end])
        blocks += named.replace("  0\nENDBLK", SIZE.format(size))
    without_inserts = re.sub(r"  0\nINSERT\n(?:(?!  0\n).*\n)*", "", drawn[end:])
    (folder / "graded.dxf").write_text(drawn[:start] + blocks + without_inserts)


class WorkflowTest(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        shutil.copy(SOURCE / "samples/band.json", self.folder)
        (self.folder / "broken.json").write_text("{")
        program("make-mannequin", "--edge-length", "15mm", "-o", self.folder / "body.ply")

    def run_workflow(self, rows, *words):
        (self.folder / "samples.csv").write_text("\n".join([HEADER, *rows]) + "\n")
        return subprocess.run(
            ["snakemake", "-s", SOURCE / "workflow/Snakefile", "--profile", SOURCE / "workflow/profiles/local",
             "--cores", "2", "--config", f"tools={TOOLS}", *words],
            cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def table(self):
        with open(self.folder / "population/table.csv", newline="") as opened:
            return {row["name"]: row for row in csv.DictReader(opened)}

    def drape(self, name):
        (file,) = self.folder.glob(f"population/shards/*/*/batch/{name}/dressed.obj")
        return file

    def dressed_by_hand(self, *words):
        """The checksum of the same garment, program by program."""
        at = self.folder / "by_hand"
        at.mkdir(exist_ok=True)
        program("clean-body", self.folder / "body.ply", "-o", at / "body.ply")
        program("mesh-pattern", self.folder / "band.json", "--edge-length", "40mm", "-o", at / "garment.obj")
        program("dress", "--body", at / "body.ply", at / "garment.obj", "-o", at / "dressed.obj", "--quality", "draft", *words)
        return hashlib.sha256((at / "dressed.obj").read_bytes()).hexdigest()

    def test_wrong_table(self):
        """It is told whole before anything runs."""
        ended = self.run_workflow([ROWS[0], ROWS[0], "body.ply,gone.json,,40mm,,,", "body.ply,band.json,velvet,40 miles,,,", "body.ply"])
        self.assertEqual(ended.returncode, 1)
        for told in ("samples.csv:3: 'body_band' is the name of line 2, too",
                     "samples.csv:4: pattern 'gone.json' is not there",
                     "samples.csv:5: edge length '40 miles' is no length",
                     "samples.csv:5: fabric 'velvet' is unknown",
                     "samples.csv:6: has more or fewer fields"):
            self.assertIn(told, ended.stdout)
        self.assertNotIn("Traceback", ended.stdout)
        self.assertFalse((self.folder / "population").exists())

    def test_pattern_that_does_not_mesh(self):
        """It is told before anything is dressed."""
        pattern = json.loads((self.folder / "band.json").read_text())
        corners = pattern["pattern"]["panels"]["front"]["vertices"]
        corners[0], corners[1] = corners[1], corners[0]
        (self.folder / "crossed.json").write_text(json.dumps(pattern))
        rows = [ROWS[0], "body.ply,crossed.json,,40mm,,,"]
        ended = self.run_workflow(rows)
        self.assertEqual(ended.returncode, 1)
        self.assertIn("samples.csv, line 3: can't be meshed: crossed.json", ended.stdout)
        self.assertFalse((self.folder / "population/shards").exists())
        ended = self.run_workflow(rows, "check=table")  # asked for, it is a row
        self.assertEqual(ended.returncode, 0, ended.stdout)
        self.assertEqual({name: row["verdict"] for name, row in self.table().items()},
                         {"body_band": "sewn", "body_crossed": "error"})

    def test_graded_drawing(self):
        """Sizes come from it."""
        draw_graded(self.folder, self.folder / "band.json", {"36": 1.0, "38": 1.04})
        rows = [f"body.ply,graded.dxf,,40mm,--quality draft,,{size}" for size in ("36", "38", "40")]
        ended = self.run_workflow(rows)
        self.assertEqual(ended.returncode, 1)
        self.assertRegex(ended.stdout, r"samples.csv, line 4: can't be meshed: .*/40.json")
        ended = self.run_workflow(rows[:2])
        self.assertEqual(ended.returncode, 0, ended.stdout)
        self.assertEqual([(row["size"], row["verdict"], row["half top edge cm"]) for row in self.table().values()],
                         [("36", "sewn", "36.33"), ("38", "sewn", "37.78")])

    def test_shard_that_fails(self):
        """It is told in the table and tried again."""
        planned = self.run_workflow(ROWS[:1], "--dry-run").stdout
        in_the_way = self.folder / re.search(r"output: (population/shards/.*)\.jsonl", planned)[1]
        in_the_way.parent.mkdir(parents=True)
        in_the_way.write_text("where the shard's folder should be")
        ended = self.run_workflow(ROWS[:1])
        self.assertEqual(ended.returncode, 1)
        self.assertEqual(self.table()["body_band"]["cause"], "shard: did not end")
        in_the_way.unlink()
        self.assertIn("pictures=perhaps: is neither true nor false", self.run_workflow(ROWS[:1], "pictures=perhaps").stdout)
        ended = self.run_workflow(ROWS[:1], "pictures=false")
        self.assertEqual(ended.returncode, 0, ended.stdout)
        row = self.table()["body_band"]
        self.assertEqual((row["verdict"], row["page"]), ("sewn", ""))
        self.assertTrue((self.folder / "population" / row["ease"]).is_file())
        self.assertFalse(list(self.folder.glob("population/shards/*/*/batch/*/*.png")))

    def test_what_changed(self):
        """Every row is in the table, and only what changed is done again."""
        planned = self.run_workflow(ROWS, "--dry-run")
        self.assertEqual(planned.returncode, 0, planned.stdout)
        self.assertRegex(planned.stdout, r"\nshard +1 ")
        self.assertFalse((self.folder / "population").exists())

        ended = self.run_workflow(ROWS)
        self.assertEqual(ended.returncode, 0, ended.stdout)
        rows = self.table()
        self.assertEqual([row["verdict"] for row in rows.values()], ["sewn", "sewn", "error"])
        self.assertEqual([row["season"] for row in rows.values()], ["summer", "winter", "never"])
        self.assertIn("broken.json", rows["body_band_broken.json"]["detail"])
        self.assertEqual(rows["body_band"]["dressed_sha256"], self.dressed_by_hand())
        self.assertEqual(rows["body_band_denim"]["dressed_sha256"], self.dressed_by_hand("--fabric", "denim"))
        self.assertEqual(rows["body_band"]["half top edge cm"], "36.33")
        self.assertAlmostEqual(float(rows["body_band"]["body_bust_cm"]), 93.6, delta=0.2)
        pattern = hashlib.sha256((self.folder / "band.json").read_bytes()).hexdigest()
        self.assertEqual({row["pattern_sha256"] for row in rows.values()}, {pattern})
        self.assertTrue((self.folder / "population" / rows["body_band"]["page"]).is_file())
        self.assertIn("2 sewn, 1 error; 3 garments", (self.folder / "population/index.html").read_text())

        self.assertIn("Nothing to be done", self.run_workflow(ROWS).stdout)
        plain, denim = (self.drape(name).stat().st_mtime_ns for name in ("body_band", "body_band_denim"))
        # A row that changed, one that is new, and one whose fabric is mended.
        shutil.copy(SOURCE / "cloth/scene/fabrics/jersey.json", self.folder / "broken.json")
        changed = [ROWS[0], ROWS[1].replace("40mm", "35mm"), ROWS[2], "body.ply,band.json,jersey,40mm,--quality draft,,"]
        ended = self.run_workflow(changed)
        self.assertEqual(ended.returncode, 0, ended.stdout)
        self.assertEqual([row["verdict"] for row in self.table().values()], ["sewn"] * 4,
                         [row["detail"] for row in self.table().values()])
        self.assertEqual(self.drape("body_band").stat().st_mtime_ns, plain)
        self.assertNotEqual(self.drape("body_band_denim").stat().st_mtime_ns, denim)
        self.assertEqual(self.table()["body_band_broken.json"]["dressed_sha256"], self.table()["body_band_jersey"]["dressed_sha256"])

        # What was lost is done again, in the same bits.
        before = self.table()
        shutil.rmtree(self.drape("body_band_denim").parent)
        next(self.folder.glob("population/shards/*/*.jsonl")).unlink()
        self.run_workflow(changed)
        self.assertEqual(self.table()["body_band_denim"]["dressed_sha256"], before["body_band_denim"]["dressed_sha256"])
        self.assertEqual(self.drape("body_band").stat().st_mtime_ns, plain)
        # Rows that are gone leave nothing.
        self.run_workflow(changed[:3])
        self.assertEqual(list(self.table()), list(before)[:3])
        self.assertFalse(list(self.folder.glob("population/shards/*/*/batch/body_band_jersey")))


if __name__ == "__main__":
    if shutil.which("snakemake") is None:
        print("snakemake is not installed")
        sys.exit(77)
    unittest.main()
