"""Learns which pairs of edges are sewn, from patterns that have seams. By hand:

    cmake --build build/release --target bench_seam_pairs
    build/release/tests/bench_seam_pairs --varied 1 PAIRS FILE...
    python3 tests/benchmarks/fit_seam_trees.py --judge ASIDE pattern/seams/seam_trees.inc PAIRS...

PAIRS@3 counts the pairs of a file three times. ASIDE are pairs of other patterns, which are judged
and not learned from. Needs python3-sklearn, which nothing else does.

The trees in use learned from 2,212 random garments of garmentcode-train, without the last third by the
SHA-256 of their names: the first 1,120 in that order as they are, and those from 721 to 900 varied. Of
those from 71 to 400 others have fused panels (fuse_panels), as they are and miscut; they count 1.5 times.
Ten samples, five drafts, halves.dxf of tests/io/drawings and the 29 labelled drawings of the part `fit`
count three times: varied five times, and four times miscut.

Trees are gradient-boosted by their histograms (Friedman 2001; Ke et al. 2017). The first leaf is
the logarithm of the odds of all pairs.
"""
import argparse

import numpy as np
from sklearn.ensemble import HistGradientBoostingClassifier
from sklearn.metrics import average_precision_score, log_loss

HEAD = 4  # file, names, sewn, weight
NAMES = ("gone", "kept", "kept but for left and right")
# Chosen for the size of the table. More garments helped more: from 720 to 1,120 of them, the log loss of
# pairs aside, names gone, fell from 0.0230 to 0.0194. Half and double were not measured.
TREES = 260
LEAVES = 44
RATE = 0.12


def read(path):
    """Heads and features. The file's first number is that of the features."""
    path, _, times = path.partition("@")
    rows = np.fromfile(path, np.float32)
    rows = rows[1:].reshape(-1, HEAD + int(rows[0]))
    rows[:, 3] *= float(times or 1)
    return rows[:, :HEAD], rows[:, HEAD:]


def preorder(nodes, at=0):
    """The nodes of a tree as rows (feature, steps to the right one, value)."""
    node = nodes[at]
    if node["is_leaf"]:
        return [(-1, 0, node["value"])]
    left = preorder(nodes, node["left"])
    right = preorder(nodes, node["right"])
    return [(node["feature_idx"], len(left) + 1, node["num_threshold"])] + left + right


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--judge", action="append", default=[], metavar="ASIDE")
    parser.add_argument("out")
    parser.add_argument("pairs", nargs="+")
    options = parser.parse_args()
    parts = [read(path) for path in options.pairs]
    heads = np.concatenate([head for head, _ in parts])
    features = np.concatenate([rows for _, rows in parts])
    del parts
    trees = HistGradientBoostingClassifier(
        max_iter=TREES, max_leaf_nodes=LEAVES, learning_rate=RATE, min_samples_leaf=60,
        l2_regularization=5, early_stopping=False, max_bins=127, random_state=1)
    trees.fit(features, heads[:, 2], sample_weight=heads[:, 3])
    for path in options.judge:
        head, rows = read(path)
        chance = trees.predict_proba(rows)[:, 1]
        for kept in (1, 2, 0):
            own = head[:, 1] == kept
            loss = log_loss(head[own, 2], chance[own], sample_weight=head[own, 3])
            area = average_precision_score(head[own, 2], chance[own])
            print(f"{path}, names {NAMES[kept]}: log loss {loss:.5f}, precision {area:.4f}")
    rows = [(-1, 0, float(np.ravel(trees._baseline_prediction)[0]))]
    for (tree,) in trees._predictors:
        rows += preorder(tree.nodes)
    with open(options.out, "w", encoding="ascii") as file:
        file.write("// Written by tests/benchmarks/fit_seam_trees.py.\n")
        line = ""
        for feature, right, value in rows:
            number = f"{np.float32(value):.5g}"
            number += "" if "." in number or "e" in number else "."
            node = f"{{{feature},{right},{number}F}},"
            if len(line) + len(node) > 99:
                file.write(line + "\n")
                line = ""
            line += node
        file.write(line + "\n")


if __name__ == "__main__":
    main()
