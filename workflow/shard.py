"""Dresses the rows of a shard by `toile batch`, and writes their reports, a line each. Snakemake runs it."""
import csv
import fcntl
import json
import os
import pathlib
import shutil
import subprocess
import sys

# Of errors that are not the garment's: the row is tried again.
FULL = ("is the disk full?", "No space left")
KILLED = ("ended by signal 9",)


def write_manifest(rows, file):
    """A manifest of `toile batch`. Its paths count from its folder."""
    def seen(path):
        return os.path.relpath(path, file.parent)

    with open(file, "w", newline="") as opened:
        table = csv.writer(opened, lineterminator="\n")
        table.writerow(["name", "pattern", "body", "edge_length", "fabric", "options", "size"])
        for row in rows:
            fabrics = [panels + (seen(fabric) if is_file else fabric) for panels, fabric, is_file in row["fabrics"]]
            table.writerow([row["name"], seen(row["pattern_file"]), seen(row["body_file"]), row["edge_length"],
                            ";".join(fabrics), row["options"], row["size"]])


def forget(batch, rows, messages):
    """Removes the reports of rows that ended with such a message, so that they are dressed again. Gives how many."""
    count = 0
    for report in (batch / row["name"] / "report.json" for row in rows):
        if report.exists() and any(message in json.loads(report.read_text())["detail"] for message in messages):
            report.unlink()
            count += 1
    return count


def compared(batch, tools, target):
    """What `toile compare` says of each row, by name."""
    table = batch.parent / "compare.csv"
    words = ["--target", target] if target else []
    subprocess.run([f"{tools}/toile", "compare", batch, "-o", table, "-q", *words], stdout=subprocess.DEVNULL)
    with open(table, newline="") as opened:
        return {pathlib.Path(row.pop("report")).name: row for row in csv.DictReader(opened)}


def dress(rows, output, tools, threads, timeout, memory, target, pictures, is_archived, attempt):
    folder = output.with_suffix("")
    batch, archive = folder / "batch", folder.with_name(folder.name + ".tar.gz")
    folder.parent.mkdir(parents=True, exist_ok=True)
    # A batch whose workflow was killed may still run here: its work is waited for, and kept.
    lock = open(folder.with_name(folder.name + ".lock"), "w")
    fcntl.flock(lock, fcntl.LOCK_EX)
    if archive.exists() and not batch.exists():
        shutil.unpack_archive(archive, folder)
    for left in batch.iterdir() if batch.exists() else []:  # of rows that the table has no more
        if left.is_dir() and left.name not in {"bodies", *(row["name"] for row in rows)}:
            shutil.rmtree(left)
    folder.mkdir(parents=True, exist_ok=True)
    write_manifest(rows, folder / "manifest.csv")
    (batch / "summary.md").unlink(missing_ok=True)
    forget(batch, rows, FULL + KILLED)
    subprocess.run([f"{tools}/toile", "batch", folder / "manifest.csv", "-o", batch, "--resume", "-j", str(threads),
                    "--threads", "1", "--timeout", f"{timeout}s", "--memory", f"{memory}MB", *([] if pictures else ["--no-pictures"])],
                   stdout=subprocess.DEVNULL, pass_fds=[lock.fileno()])
    if not (batch / "summary.md").exists():  # it is written last
        sys.exit("toile batch did not end its work")
    if forget(batch, rows, FULL):
        sys.exit("the disk is full; what is done is kept")
    if attempt < 3 and forget(batch, rows, KILLED):
        sys.exit("a program was killed from outside; what is done is kept")
    reports = {row["name"]: json.loads((batch / row["name"] / "report.json").read_text()) for row in rows}
    runs = compared(batch, tools, target)
    for cache in (batch / "bodies").glob("*.distances"):
        cache.unlink()
    if is_archived:
        os.replace(shutil.make_archive(f"{folder}.part", "gztar", folder), archive)
        shutil.rmtree(folder)
    part = output.with_suffix(".part")
    part.write_text("".join(json.dumps({**report, "compared": runs[name]}) + "\n" for name, report in reports.items()))
    part.replace(output)


with open(snakemake.log[0], "a") as log:
    os.dup2(log.fileno(), sys.stderr.fileno())
    dress(snakemake.params.rows, pathlib.Path(snakemake.output[0]), os.path.dirname(snakemake.input.programs),
          snakemake.threads, snakemake.params.timeout, snakemake.params.memory, snakemake.params.target,
          snakemake.params.pictures, snakemake.params.archive, snakemake.resources.attempt)
