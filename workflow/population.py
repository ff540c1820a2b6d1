"""The table of a population: read, checked, and cut into shards."""
import csv
import hashlib
import os
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[1]
FABRICS = {"default"} | {file.stem for file in (ROOT / "cloth/scene/fabrics").glob("*.json")}
POSES = {"walking", "sitting", "reaching"}
OWN = ("name", "body", "pattern", "size", "fabric", "edge_length", "pose", "options")
# Columns that the table of results has besides.
RESULTS = ("verdict", "cause", "detail", "fit", "strain_p99", "bust_ease_cm", "waist_ease_cm", "hip_ease_cm", "attempts",
           "nodes", "worst_level", "worst_ease_cm", "plus_minus_ease_cm", "off_level", "off_cm", "best", "version",
           "executable_sha256", "pattern_sha256", "body_sha256", "fabric_sha256", "dressed_sha256", "seconds", "peak_MiB",
           "page", "ease", "shard", "body_height_cm", "body_bust_cm", "body_waist_cm", "body_hip_cm")
# Of a folder of `toile batch`, besides the garments' folders.
TAKEN = ("bodies", "results.csv", "index.html", "summary.md")
MAX_TOLD = 50


class TableError(Exception):
    """What is wrong with the table, a line each."""


def key(*parts):
    """A file name that tells its source, and is that of no other."""
    checksum = hashlib.sha256("\n".join(parts).encode()).hexdigest()[:8]
    return re.sub(r"[^\w.-]+", "-", "_".join(pathlib.Path(part).stem for part in parts if part)) + "-" + checksum


class Population:
    """`rows` of the table, each with the files that it needs; `shards` of rows by name.

    A shard is all rows of one body in one pose, or, with `shards` given, of the bodies that fall to it;
    more rows than `rows_per_shard` are several shards. A row that is added moves no row of another body.
    """

    def __init__(self, table, out, edge_length, rows_per_shard, shards):
        self.table, self.out = pathlib.Path(table), pathlib.Path(out)
        self.wrong, self._there, self._line_of_name = [], {}, {}
        self.rows, self.shards = [], {}
        self.bodies, self.poses, self.patterns, self.drawings = {}, {}, {}, {}
        try:
            with open(table, newline="", encoding="utf-8-sig") as file:
                reader = csv.DictReader(file, strict=True)
                self._check_columns(reader.fieldnames or [])
                for fields in reader:
                    self._add(reader.line_num, fields, edge_length)
        except (OSError, UnicodeDecodeError, csv.Error) as error:
            raise TableError(f"{table}: can't be read: {error}") from None
        if not self.rows and not self.wrong:
            self.wrong = [f"{table}: holds no garment; give a line for each below the names of the columns"]
        if self.wrong:
            more = len(self.wrong) - MAX_TOLD
            raise TableError("\n".join(self.wrong[:MAX_TOLD] + ([f"and {more} more"] if more > 0 else [])))
        for row in self.rows:
            bodies = key(row["body"], row["pose"])
            if shards:
                bodies = f"{int(hashlib.sha256(bodies.encode()).hexdigest(), 16) % shards:05}"
            self.shards.setdefault(bodies, []).append(row)
        self.shards = {f"{hashlib.sha256(bodies.encode()).hexdigest()[:2]}/{bodies}-{start // rows_per_shard}":
                       rows[start:start + rows_per_shard]
                       for bodies, rows in self.shards.items() for start in range(0, len(rows), rows_per_shard)}

    def _check_columns(self, columns):
        self.other_columns = [column for column in columns if column not in OWN]
        for column in ("body", "pattern"):
            if column not in columns:
                raise TableError(f"{self.table}:1: there is no column '{column}'; the first line names the columns: "
                                 f"body, pattern, and if wanted {', '.join(column for column in OWN if column not in ('body', 'pattern'))}")
        for column in columns:
            if columns.count(column) > 1 or column in RESULTS:
                raise TableError(f"{self.table}:1: column '{column}' is there twice, or is one of the results; rename it")

    def _file(self, line, what, name):
        """The path of a file that a row names; told where it is not there."""
        path = os.path.normpath(self.table.parent / name)
        if path not in self._there:
            self._there[path] = os.path.isfile(path)
        if not self._there[path]:
            self.wrong.append(f"{self.table}:{line}: {what} '{name}' is not there; paths count from the table's folder")
        return path

    def _add(self, line, fields, edge_length):
        tell = lambda problem: self.wrong.append(f"{self.table}:{line}: {problem}")
        if None in fields or None in fields.values():
            return tell("has more or fewer fields than the first line; a field with a comma needs quotes")
        for column in ("body", "pattern"):
            if not fields.get(column):
                return tell(f"names no {column}; fill column '{column}'")
        row = {column: fields.get(column) or "" for column in OWN}
        row["others"] = {column: fields[column] for column in self.other_columns}
        row["line"], row["files"] = line, []
        row["edge_length"] = row["edge_length"] or edge_length
        if not re.fullmatch(r"(\d+\.?\d*|\.\d+) *(mm|cm|m|in)", row["edge_length"]):
            tell(f"edge length '{row['edge_length']}' is no length with its unit; write 10mm, say")
        row["body_file"] = self._file(line, "body", row["body"])
        row["pattern_file"] = self._file(line, "pattern", row["pattern"])
        if row["pose"] == "standing":
            row["pose"] = ""
        pose = row["pose"]
        if pose and pose not in POSES:
            pose = self._file(line, "pose", pose)
        row["fabrics"] = []  # what stands before the name, the name or path, whether it is a path
        for part in filter(None, map(str.strip, row["fabric"].split(";"))):
            panels, equals, fabric = part.rpartition("=")
            is_file = fabric not in FABRICS
            if is_file and re.search(r"[./]", fabric):
                fabric = self._file(line, "fabric", fabric)
                row["files"].append(fabric)
            elif is_file:
                tell(f"fabric '{fabric}' is unknown; give a file, or one of {', '.join(sorted(FABRICS))}")
            row["fabrics"].append((panels + equals, fabric, is_file))
        if row["pattern"].lower().endswith((".dxf", ".svg")):
            if not row["size"]:
                tell(f"pattern '{row['pattern']}' is a drawing, and no size is named; fill column 'size'")
            drawing = key(row["pattern_file"])
            self.drawings[drawing] = row["pattern_file"]
            row["pattern_file"] = str(self.out / "sizes" / drawing / (row["size"].replace("/", "_") + ".json"))
        row["pattern_key"] = key(row["pattern_file"], row["edge_length"])
        self.patterns[row["pattern_key"]] = (row["pattern_file"], row["edge_length"])
        row["body_key"] = key(row["body_file"])
        self.bodies[row["body_key"]] = row["body_file"]
        if pose:
            posed = key(row["body_file"], pose)
            self.poses[posed] = (row["body_file"], pose)
            row["body_file"] = str(self.out / "posed" / f"{posed}.ply")
        row["files"] += [row["body_file"], row["pattern_file"]]
        if not row["name"]:
            stem = pathlib.Path(row["pattern"]).stem
            size = "" if re.search(rf"[_.\- ]{re.escape(row['size'])}$", stem) else row["size"]
            words = [pathlib.Path(row["body"]).stem, stem, size, row["fabric"], pathlib.Path(row["pose"]).stem]
            row["name"] = re.sub(r"[^\w.-]+", "-", "_".join(filter(None, words)))
        if not re.fullmatch(r"[^./\\][^/\\]{0,199}", row["name"]) or row["name"].lower() in TAKEN:
            tell(f"'{row['name']}' is no name for a garment; give one without slashes or a leading dot")
        other = self._line_of_name.setdefault(row["name"].lower(), line)
        if other != line:
            tell(f"'{row['name']}' is the name of line {other}, too; give each garment a name of its own in column 'name'")
        self.rows.append(row)
