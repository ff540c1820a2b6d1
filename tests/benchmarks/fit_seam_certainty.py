"""Fits the confidence of find-seams to seams that are known to be right or wrong. By hand:

    build/release/tests/bench_seams_found --features features.txt FOLDER FILE...
    python3 tests/benchmarks/fit_seam_certainty.py features.txt [OTHER.txt]

Logistic regression by Newton's method. Prints the row of pattern/seams/seam_certainty.cpp, and for
several thresholds the share of right seams among those above, and the right ones above over all
right ones. Each garment is judged by a fit to the other four fifths of the garments. OTHER is judged
by the fit to all of them.
"""
import hashlib
import math
import sys

FOLDS = 5
# Of the squared weights. Half and double change the first weight by a quarter, most by a twentieth.
RIDGE = 1.0
THRESHOLDS = (0, 0.5, 0.7, 0.8, 0.85, 0.88, 0.9, 0.92, 0.94, 0.95, 0.96, 0.97, 0.98, 0.99)


def read(path):
    rows = []
    with open(path, encoding="utf-8") as file:
        for line in file:
            name, named, right, _, *features = line.split()
            rows.append((name, named == "1", int(right), [float(feature) for feature in features]))
    return rows


def certainty(weights, features):
    total = sum(weight * feature for weight, feature in zip(weights, features))
    return 1 / (1 + math.exp(-max(-30, min(30, total))))


def solve(matrix, right):
    size = len(right)
    rows = [list(row) + [value] for row, value in zip(matrix, right)]
    for i in range(size):
        pivot = max(range(i, size), key=lambda r: abs(rows[r][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for r in range(i + 1, size):
            factor = rows[r][i] / rows[i][i]
            for c in range(i, size + 1):
                rows[r][c] -= factor * rows[i][c]
    result = [0.0] * size
    for i in reversed(range(size)):
        rest = sum(rows[i][c] * result[c] for c in range(i + 1, size))
        result[i] = (rows[i][size] - rest) / rows[i][i]
    return result


def fit(rows):
    size = len(rows[0][3])
    weights = [0.0] * size
    for _ in range(12):
        slope = [-RIDGE * weight for weight in weights]
        bend = [[RIDGE if i == j else 0.0 for j in range(size)] for i in range(size)]
        for _, _, right, features in rows:
            chance = certainty(weights, features)
            part = chance * (1 - chance)
            for i, feature in enumerate(features):
                if feature == 0:
                    continue
                slope[i] += (right - chance) * feature
                for j, other in enumerate(features):
                    bend[i][j] += part * feature * other
        weights = [weight + step for weight, step in zip(weights, solve(bend, slope))]
    return weights


def table(title, judged):
    for named in (True, False):
        of_kind = [(chance, right) for is_named, right, chance in judged if is_named == named]
        all_right = sum(right for _, right in of_kind)
        print(f"{title}, names {'kept' if named else 'gone'}: {len(of_kind)} seams")
        for threshold in THRESHOLDS:
            above = [right for chance, right in of_kind if chance >= threshold]
            if above:
                print(f"  {threshold:.2f}: {sum(above) / len(above):.3f} right, "
                      f"{sum(above) / all_right:.3f} of the right ones, "
                      f"{len(above)} seams")


def main():
    rows = read(sys.argv[1])

    def fold(name):
        return hashlib.sha256(("fold " + name).encode()).digest()[0] % FOLDS

    judged = []
    for k in range(FOLDS):
        weights = fit([row for row in rows if fold(row[0]) != k])
        judged += [(named, right, certainty(weights, features))
                   for name, named, right, features in rows if fold(name) == k]
    table("others' fit", judged)
    weights = fit(rows)
    print("{" + ", ".join(f"{weight:.3f}" for weight in weights) + "}")
    for path in sys.argv[2:]:
        table(path, [(named, right, certainty(weights, features))
                     for _, named, right, features in read(path)])


if __name__ == "__main__":
    main()
