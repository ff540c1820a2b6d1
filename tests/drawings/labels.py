"""Labels of drawings: what a tailor would sew, by points on the outlines of imported pieces."""
import hashlib
import json
import math
import os
import pathlib
import subprocess
import tempfile

import outlines

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
DATA = pathlib.Path(os.environ.get("TOILE_DATA", ROOT.parent / "shared/data")) / "patterns"
BUILD = pathlib.Path(os.environ.get("TOILE_BUILD", ROOT / "build/release"))
SOURCES = ("freesewing", "industrial-dxf", "valentina")
NEAR = 0.5  # cm by which two places on an outline may differ and be one
SHARE = 0.03  # of an arc's length, the same
BOX = 0.2  # cm by which a piece's box may differ from its label's


def tolerance(length):
    return max(NEAR, SHARE * length)


def program(name, *arguments):
    command = [str(BUILD / "tools" / name), *map(str, arguments), "--threads", "1", "-q"]
    return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)


def drawings(source):
    return sorted(file for file in (DATA / source).iterdir()
                  if file.suffix.lower() in (".svg", ".dxf"))


def name_of(source, file):
    """The name of a drawing's label. A drawing that is not public is named by its content alone."""
    if source == "industrial-dxf":
        return hashlib.sha256(file.read_bytes()).hexdigest()[:12]
    return source + "_" + file.stem


def files_of(source, part=None):
    """Drawings by the names of their labels: all, or those that are kept aside, or the others."""
    files = sorted(drawings(source), key=lambda f: hashlib.sha256(f.name.encode()).hexdigest())
    border = len(files) - round(len(files) / 3)
    files = {None: files, "fit": files[:border], "aside": files[border:]}[part]
    return {name_of(source, file): file for file in files}


def turns_to(outline, box):
    """All degrees by which an outline may be turned to have this box."""
    def off():
        return max(abs(a - b) for a, b in zip(outline.box, box))

    def best(angles):
        rated = []
        for degrees in angles:
            outline.turn(degrees)
            rated.append((off(), degrees))
            outline.turn(-degrees)
        return sorted(rated)

    rough = best(range(0, 360, 2))
    fine = []
    for _, degrees in rough[:8]:
        far, exact = best(degrees + k / 10 for k in range(-20, 21))[0]
        if far <= BOX:
            fine.append(exact)
    return fine


class Piece:
    """A piece of an imported drawing: its panels by copy, `""` where there is one."""

    def __init__(self):
        self.panels = {}


def import_drawing(file, options=()):
    """The pattern file that import-pattern makes of a drawing."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "pattern.json"
        done = program("import-pattern", file, "-o", out, *options)
        if not out.exists():
            raise ValueError("not read: " + done.stderr.strip().splitlines()[-1])
        return json.loads(out.read_text())


class Imported:
    """An imported drawing. Pieces that are left out keep their number."""

    def __init__(self, file, without=()):
        self.file = file
        self.unit = 100 / self.file["properties"]["units_in_meter"]
        self.panels = self.file["pattern"]["panels"]
        self.outlines = {name: outlines.Outline(panel, self.unit)
                         for name, panel in self.panels.items()}
        self.pieces = []
        self.place = {}  # of a panel: (piece, copy)

        def new_piece():
            number = len(self.pieces)
            self.pieces.append(Piece())
            leave_out()
            return number

        def leave_out():
            while len(self.pieces) in without:
                self.pieces.append(Piece())

        leave_out()
        for name in self.panels:
            side, _, stem = name.partition("_")
            other = {"left": "right_", "right": "left_"}.get(side, "") + stem
            if side in ("left", "right") and other in self.panels:
                if other in self.place:
                    piece, copy = self.place[other][0], side
                else:
                    piece, copy = new_piece(), side
            else:
                piece, copy = new_piece(), ""
            self.pieces[piece].panels[copy] = name
            self.place[name] = (piece, copy)

    def stem(self, piece):
        panels = self.pieces[piece].panels
        return panels[""] if "" in panels else panels["left"].partition("_")[2]

    def is_as_labelled(self, number, fact):
        """Whether a piece has the label's size and is cut as often. It may lie turned."""
        if number >= len(self.pieces):
            return False
        panels = self.pieces[number].panels
        outline = self.outlines[next(iter(panels.values()))]
        alike = all(abs(a - b) <= BOX for a, b in zip(outline.box, fact["box"]))
        return ((len(panels) == 2) == (fact.get("copies", 1) == 2) and
                (alike or bool(turns_to(outline, fact["box"]))))

    def turn_as(self, label):
        """Turns outlines until the label's points lie on them: an import may turn pieces."""
        points = {}
        for seam in label.seams:
            for side in (seam["a"], seam["b"]):
                panels = self.pieces[side["piece"]].panels
                points.setdefault(panels.get(side.get("copy", "")), []).extend(
                    (side["piece"], side[key]) for key in ("from", "to"))
        for name, sides in points.items():
            if name is None:
                raise ValueError(f"piece {sides[0][0]} is not cut as often as labelled")
            outline = self.outlines[name]

            def off(degrees):
                outline.turn(degrees)
                far = max(outline.place(point)[1] for _, point in sides)
                outline.turn(-degrees)
                return far

            if off(0) <= NEAR:
                continue
            turns = turns_to(outline, label.pieces[sides[0][0]]["box"])
            if turns:
                outline.turn(min(turns, key=off))


class Label:
    def __init__(self, text):
        self.data = json.loads(text)
        self.options = self.data.get("options", [])
        self.pieces = self.data["pieces"]
        self.seams = self.data["seams"]

    @property
    def spare(self):
        return {i: piece["spare"] for i, piece in enumerate(self.pieces) if "spare" in piece}

    @property
    def without(self):
        return [i for i, piece in enumerate(self.pieces) if "without" in piece]

    def told(self, plain):
        """The options that say what the label knows and the plain import does not."""
        told = list(self.options)
        for i, piece in enumerate(self.pieces):
            name = plain.stem(i)
            if i in self.without:
                told += ["--without", name]
                continue
            copies = len(plain.pieces[i].panels)
            if "fold" in piece:
                outline = plain.outlines[next(iter(plain.pieces[i].panels.values()))]
                if not plain.is_as_labelled(i, piece):
                    edge = fold_edge(outline, piece["fold"])
                    told += ["--unfold", f"{name}:{edge}"]
            if piece.get("copies", 1) == 2 and copies == 1:
                told += ["--pair", name]
            if piece.get("copies", 1) == 1 and copies == 2:
                told += ["--single", name]
        return told

    def imported(self, file):
        """As a newcomer imports the drawing, and with what the label knows of its pieces."""
        plain = Imported(import_drawing(file, self.options))
        return plain, self.read_as_told(file, plain)

    def read_as_told(self, file, plain):
        whole = Imported(import_drawing(file, self.told(plain)), self.without)
        whole.turn_as(self)
        return whole


def fold_edge(outline, ends):
    """The edge of an outline that runs between these points, or is as long where it is turned."""
    places = [outline.place(point)[0] for point in ends]
    length = math.dist(*ends)
    return min(outline.edges, key=lambda n: (
        abs(outline.end[n] - outline.begin[n] - length) > NEAR,
        min(outline.apart(outline.begin[n], a) + outline.apart(outline.end[n], b)
            for a, b in (places, places[::-1]))))


def has(name):
    return (HERE / "labels" / (name + ".json")).exists()


def load(name):
    return Label((HERE / "labels" / (name + ".json")).read_text())


class Arc:
    """A part of a panel's outline, from one length to another, counter-clockwise."""

    def __init__(self, panel, outline, start, end):
        self.panel, self.outline = panel, outline
        self.start = start % outline.length
        self.length = outline.span(start, end)

    def at(self, fraction):
        return (self.start + self.length * fraction) % self.outline.length

    def fraction(self, at, slack):
        """Where on the arc a place lies, 0 to 1, or None if it is further off than the slack."""
        ahead = (at - self.start) % self.outline.length
        if ahead <= self.length:
            return ahead / self.length if self.length > 0 else 0.0
        if ahead - self.length <= slack:
            return 1.0
        return 0.0 if self.outline.length - ahead <= slack else None


def arc_of(side, imported):
    """The arc of a label's seam side on the imported panel."""
    panels = imported.pieces[side["piece"]].panels
    name = panels[side.get("copy", "")]
    outline = imported.outlines[name]
    ends = []
    for key in ("from", "to"):
        place, far = outline.place(side[key])
        if far > NEAR:
            raise ValueError(f"piece {side['piece']} is not as labelled, by {far:.1f} cm")
        corner = min(outline.corners, key=lambda c: outline.apart(c, place))
        ends.append(corner if outline.apart(corner, place) < outlines.SHORT else place)
    return Arc(name, outline, *ends)


class Seam:
    def __init__(self, entry, imported):
        self.a, self.b = arc_of(entry["a"], imported), arc_of(entry["b"], imported)
        self.reversed = entry.get("reversed", True)
        self.ask = entry.get("ask")
        self.around = entry.get("around")
        self.what = entry.get("what", "")
        self.sewn = entry.get("sewn", True)


def seams_of(label, imported):
    return [Seam(entry, imported) for entry in label.seams]


def inner(arc):
    """The corners of an outline within an arc, as lengths from its start."""
    ahead = sorted((c - arc.start) % arc.outline.length for c in arc.outline.corners)
    return [x for x in ahead if 1e-3 < x < arc.length - 1e-3]


def steps(seam):
    """Lengths at which both sides of a seam are cut, from their starts. Both as side a runs."""
    a, b = seam.a, seam.b
    mine = inner(a)
    theirs = [b.length - x for x in reversed(inner(b))] if seam.reversed else inner(b)
    near = tolerance(max(a.length, b.length))
    pairs = []
    for x in mine:
        y = min(theirs, key=lambda t: abs(t / b.length - x / a.length), default=None)
        if y is not None and abs(y / b.length * a.length - x) <= near:
            if not pairs or (pairs[-1][1] < y - 1e-6):
                pairs.append((x, y))
    anchors = [(0.0, 0.0)] + pairs + [(a.length, b.length)]

    def other(value, this, that):
        for low, high in zip(anchors, anchors[1:]):
            if low[this] <= value <= high[this]:
                t = (value - low[this]) / (high[this] - low[this])
                return low[that] + (high[that] - low[that]) * t
        return None

    taken_a, taken_b = {x for x, _ in pairs}, {y for _, y in pairs}
    pairs += [(x, other(x, 0, 1)) for x in mine if x not in taken_a]
    pairs += [(other(y, 1, 0), y) for y in theirs if y not in taken_b]
    return sorted(pairs)


def labelled_pattern(label, imported):
    """The imported pattern, its edges cut where the label's seams end, and these as stitches."""
    file = json.loads(json.dumps(imported.file))
    panels = file["pattern"]["panels"]
    seams = [seam for seam in seams_of(label, imported) if seam.sewn]
    cuts = {name: [] for name in panels}
    rows = []
    for seam in seams:
        row = []
        at = [(0.0, 0.0)] + steps(seam) + [(seam.a.length, seam.b.length)]
        for (a0, b0), (a1, b1) in zip(at, at[1:]):
            if seam.reversed:
                b0, b1 = seam.b.length - b1, seam.b.length - b0
            row.append((seam.a.start + a0, seam.a.start + a1, seam.b.start + b0, seam.b.start + b1))
        for a0, a1, b0, b1 in row:
            cuts[seam.a.panel] += [a0, a1]
            cuts[seam.b.panel] += [b0, b1]
        rows.append((seam, row))
    for name, panel in panels.items():
        panels[name] = outlines.cut(panel, cuts[name], imported.unit)
        piece = imported.place[name][0]
        if piece in label.spare:
            panels[name]["left_out"] = label.spare[piece]
    walks = {name: outlines.Outline(panel, imported.unit) for name, panel in panels.items()}
    # A cut outline starts where the imported one's walk does.
    stitches = []
    for seam, row in rows:
        for a0, a1, b0, b1 in row:
            ends = []
            for arc, start, end in ((seam.a, a0, a1), (seam.b, b0, b1)):
                edge = walks[arc.panel].edge_at(start, end)
                if edge is None:
                    raise ValueError(f"no edge of {arc.panel} from {start:.2f} to {end:.2f} cm, "
                                     f"{seam.what}: seams overlap, or end beside a corner")
                ends.append({"panel": arc.panel, "edge": edge})
            stitches.append(ends if seam.reversed else ends + [{"reversed": False}])
    file["pattern"]["stitches"] = stitches
    return file
