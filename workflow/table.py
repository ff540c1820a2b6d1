"""The table and the page of a population, from the reports of its shards."""
import collections
import csv
import functools
import html
import json
import os
import pathlib

from population import OWN, RESULTS

BODY = ("height", "bust", "waist", "hip")
PAGE = """<!doctype html><html lang="en"><meta charset="utf-8"><title>{title}</title>
<style>body{{font:14px/1.5 sans-serif;margin:2em;max-width:70em}} table{{border-collapse:collapse;margin:1em 0}}
td,th{{padding:.2em .7em;border-bottom:1px solid #ccc;text-align:left}}</style>
<h1>{title}</h1>{body}</html>
"""


@functools.lru_cache(maxsize=None)
def read_table(file):
    if not file.exists():
        return []
    with open(file, newline="") as opened:
        return list(csv.DictReader(opened))


def read_reports(population):
    """The report of each row by name; of a shard that did not end, an error."""
    reports = {}
    for shard, rows in population.shards.items():
        file = population.out / "shards" / f"{shard}.jsonl"
        if file.exists():
            reports |= {report["name"]: {**report, "shard": shard} for report in map(json.loads, open(file))}
        for row in rows:
            reports.setdefault(row["name"], {
                "name": row["name"], "shard": shard, "verdict": "error", "cause": "shard: did not end",
                "detail": f"see {file.with_suffix('.log')}; run the workflow again"})
    return reports


def table_row(population, row, report):
    out, inputs, figures = population.out, report.get("inputs", {}), report.get("figures", {})
    checksum = lambda files: " ".join(file["sha256"] or "" for file in files)
    folder = out / "shards" / report["shard"] / "batch" / row["name"]
    line = {column: row[column] for column in OWN} | row["others"]
    told = (report, figures, report.get("compared", {}))
    line |= {column: next((each[column] for each in told if column in each), "") for column in RESULTS}
    line |= {"pattern_sha256": checksum([inputs["pattern"]]) if inputs else "",
             "body_sha256": checksum([inputs["body"]]) if inputs else "",
             "fabric_sha256": checksum(inputs.get("fabrics", [])),
             "dressed_sha256": report.get("outputs", {}).get("dressed.obj", ""),
             "page": os.path.relpath(folder / "ease.html", out) if (folder / "ease.html").exists() else "",
             "ease": os.path.relpath(folder / "ease.json", out) if (folder / "ease.json").exists() else ""}
    measures = {each["name"]: each["value"] for each in read_table(out / "bodies" / f"{row['body_key']}.csv")}
    line |= {f"body_{name}_cm": measures.get(name, "") for name in BODY}
    points = read_table(out / "patterns" / f"{row['pattern_key']}.csv")
    return line | {f"{each['name']} cm": each["actual_cm"] for each in points}


def html_table(header, rows):
    def cell(value):
        text, page = value if isinstance(value, tuple) else (value, "")
        text = html.escape(str(text))
        return f"<td><a href='{html.escape(page)}'>{text}</a></td>" if page else f"<td>{text}</td>"

    return ("<table><tr>" + "".join(f"<th>{html.escape(name)}</th>" for name in header) + "</tr>" +
            "".join("<tr>" + "".join(map(cell, row)) + "</tr>\n" for row in rows) + "</table>")


def summary(table):
    count = collections.Counter(row["verdict"] for row in table)
    body = "<p>" + ", ".join(f"{number} {verdict}" for verdict, number in count.most_common()) + \
        f"; {len(table)} garments. Every row is in <a href='table.csv'>table.csv</a>.</p>"
    causes = collections.Counter((row["verdict"], row["cause"]) for row in table if row["verdict"] != "sewn")
    if causes:
        body += "<h2>Not sewn</h2>" + html_table(
            ["verdict", "cause", "garments"], [[*cause, number] for cause, number in causes.most_common(30)])
        body += html_table(["garment", "verdict", "what"], [
            [(row["name"], row["page"]), row["verdict"], row["detail"]] for row in table if row["verdict"] != "sewn"][:300])
    sizes = collections.defaultdict(collections.Counter)
    for row in table:
        sizes[row["pattern"], row["fabric"]][row["size"], row["best"] == "yes"] += 1
    body += "<h2>Best sizes</h2><p>Bodies whose best size this is, by the rule of <code>toile compare</code>.</p>"
    body += html_table(["pattern", "size", "fabric", "best of", "garments"], [
        [pattern, size, fabric, counts[size, True], counts[size, True] + counts[size, False]]
        for (pattern, fabric), counts in sizes.items() for size in sorted({size for size, _ in counts})])
    return body


def write(file, text):
    part = file.with_suffix(".part")
    part.write_text(text)
    part.replace(file)


def write_table(population):
    reports = read_reports(population)
    table = [table_row(population, row, reports[row["name"]]) for row in population.rows]
    columns = list(dict.fromkeys(column for line in table for column in line))
    with open(population.out / "table.part", "w", newline="") as opened:
        writer = csv.DictWriter(opened, columns, restval="", lineterminator="\n")
        writer.writeheader()
        writer.writerows(table)
    (population.out / "table.part").replace(population.out / "table.csv")
    write(population.out / "reports.jsonl",
          "".join(json.dumps(reports[row["name"]]) + "\n" for row in population.rows))
    write(population.out / "index.html", PAGE.format(title=html.escape(str(population.table)), body=summary(table)))
