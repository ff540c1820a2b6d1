"""A page of measured figures beside what is aimed at."""
import subprocess
import sys


class Page:
    def __init__(self):
        self.rows = []
        self.left_out = []

    def add(self, what, body, aim, value, is_kept, note=""):
        verdict = "" if is_kept is None else "kept" if is_kept else "**missed**"
        self.rows.append((what, body, aim, value, verdict, note))

    def at_most(self, what, body, bound, value, unit, note="", digits=1):
        self.add(what, body, f"≤ {bound:g} {unit}", f"{value:.{digits}f} {unit}", value <= bound, note)

    def at_least(self, what, body, bound, value, unit, note=""):
        self.add(what, body, f"≥ {bound:g} {unit}", f"{value:.1f} {unit}", value >= bound, note)

    def take(self, folder, name, command, parse):
        """Parses what the command prints, or what it printed into the folder before."""
        kept = folder / (name + ".txt")
        if not kept.exists():
            print(f"{name} ...", file=sys.stderr, flush=True)
            done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)
            kept.write_text(done.stdout)
        parse(self, kept.read_text())

    def print(self, head, of):
        """`head` is the page's title and what is said above; `of` heads the second column."""
        missed = sum(row[4] == "**missed**" for row in self.rows)
        asked = sum(row[4] != "" for row in self.rows)
        print(head)
        print(f"{missed} of {asked} figures miss their aim.\n")
        if self.left_out:
            print(f"Not taken this time: {', '.join(self.left_out)}.\n")
        print(f"| figure | {of} | aim | measured | verdict | note |")
        print("|---|---|---|---|---|---|")
        for row in self.rows:
            print("| " + " | ".join(row) + " |")


def cells(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]
