#!/usr/bin/env python3
"""Dresses seven bodies, bust 84 to 102 cm, with one T-shirt, and plots its ease against their size:

    ease_by_size.py PATTERN.json PICTURE.png

It prints a line for each body. The page docs/python.md shows the picture.
"""
import sys
from concurrent.futures import ThreadPoolExecutor

import matplotlib
import toile

matplotlib.use("Agg")
from matplotlib import pyplot

LEVELS = ["bust", "waist"]
BUSTS = range(84, 103, 3)
garment = toile.mesh(toile.read_pattern(sys.argv[1]), edge_length=0.025)


def ease_on(bust):
    """The verdict on a body of this bust, and the ease and its error at each level, centimetres."""
    body = toile.mannequin({"height": 170, "bust": bust, "waist": bust - 23, "hip": bust + 4})
    drape = toile.dress(garment, body, quality="draft")
    girths = {row.get("level"): row for row in toile.ease(drape, body)["girths"]}
    return drape.report["verdict"], [
        (girths[level]["as_cut_ease_cm"], girths[level]["plus_minus_as_cut_cm"]) for level in LEVELS]


with ThreadPoolExecutor(4) as threads:  # no call disturbs another
    found = list(threads.map(ease_on, BUSTS))
for bust, (verdict, eases) in zip(BUSTS, found):
    print(f"bust {bust} cm: {verdict};", ", ".join(
        f"{level} {ease:.1f} cm" for level, (ease, _) in zip(LEVELS, eases)))

figure, axes = pyplot.subplots(figsize=(6, 3.5), layout="constrained")
for i, level in enumerate(LEVELS):
    axes.errorbar(BUSTS, [eases[i][0] for _, eases in found], [eases[i][1] for _, eases in found],
                  marker="o", capsize=3, label=level)
axes.axhline(0, color="grey", linewidth=0.8)
axes.set(xlabel="bust of the body, cm", ylabel="ease as cut, cm", title="One T-shirt on seven bodies")
axes.legend()
figure.savefig(sys.argv[2], dpi=100)
