"""Girths of a drape by a geometry of its own: slices of the written OBJ, hulls, and the rule of
as cut, to compare with what ease-map writes. Metres, standard library alone."""

import math

FOLD_SHARE = 1.3
LINE_DIFFERS = 0.01
ROUNDING = 1e-9


def read_drape(path):
    """Points, flat points, and triangles as (nodes, flat points, panel)."""
    points, flat, triangles, panel = [], [], [], None
    with open(path, encoding="utf-8") as file:
        for line in file:
            words = line.split()
            if not words:
                continue
            if words[0] == "v":
                points.append(tuple(map(float, words[1:4])))
            elif words[0] == "vt":
                flat.append(tuple(map(float, words[1:3])))
            elif words[0] in ("o", "g"):
                panel = line.split(maxsplit=1)[1].strip()
            elif words[0] == "f":
                corners = [corner.split("/") for corner in words[1:4]]
                triangles.append((tuple(int(c[0]) - 1 for c in corners),
                                  tuple(int(c[1]) - 1 for c in corners), panel))
    return points, flat, triangles


def level_pieces(drape, height):
    """Per triangle that the level cuts: its two worn ends, as edges with a place, and flat ends."""
    points, flat, triangles = drape
    pieces = []
    for nodes, corners, panel in triangles:
        above = [points[n][1] >= height for n in nodes]
        if all(above) or not any(above):
            continue
        ends = []
        for i in range(3):
            j = (i + 1) % 3
            if above[i] == above[j]:
                continue
            a, b = points[nodes[i]], points[nodes[j]]
            share = (height - a[1]) / (b[1] - a[1])
            worn = tuple(a[k] + share * (b[k] - a[k]) for k in (0, 2))
            p, q = flat[corners[i]], flat[corners[j]]
            ends.append((tuple(sorted((nodes[i], nodes[j]))), worn,
                         tuple(p[k] + share * (q[k] - p[k]) for k in (0, 1))))
        pieces.append((ends, panel))
    return pieces


def loops(pieces):
    """Closed loops of pieces, joined at the mesh edges that they share."""
    at = {}
    for i, (ends, _) in enumerate(pieces):
        for end in ends:
            at.setdefault(end[0], []).append(i)
    used, found = set(), []
    for start in range(len(pieces)):
        if start in used:
            continue
        loop, here, edge = [], start, pieces[start][0][0][0]
        closed = False
        while here not in used:
            used.add(here)
            loop.append(here)
            ends = pieces[here][0]
            edge = ends[1][0] if ends[0][0] == edge else ends[0][0]
            ahead = [i for i in at[edge] if i not in used]
            if not ahead:
                closed = start in at[edge] and len(loop) > 2
                break
            here = ahead[0]
        if closed:
            found.append(loop)
    return found


def polygon(pieces, loop):
    """The loop's worn points in order."""
    points, edge = [], None
    for k, i in enumerate(loop):
        ends = pieces[i][0]
        if edge is None:
            after = {e[0] for e in pieces[loop[1]][0]}
            first = ends[0] if ends[1][0] in after else ends[1]
            edge = first[0]
        here, there = (ends[0], ends[1]) if ends[0][0] == edge else (ends[1], ends[0])
        points.append(here[1])
        edge = there[0]
    return points


def area(points):
    return 0.5 * sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(points, points[1:] + points[:1]))


def contains(points, place):
    inside = False
    for p, q in zip(points, points[1:] + points[:1]):
        if (p[1] > place[1]) != (q[1] > place[1]):
            if place[0] < p[0] + (place[1] - p[1]) / (q[1] - p[1]) * (q[0] - p[0]):
                inside = not inside
    return inside


def perimeter(points):
    return sum(math.dist(p, q) for p, q in zip(points, points[1:] + points[:1]))


def hull(points):
    ordered = sorted(set(points))

    def half(path):
        chain = []
        for p in path:
            while len(chain) > 1 and ((chain[-1][0] - chain[-2][0]) * (p[1] - chain[-2][1]) -
                                      (chain[-1][1] - chain[-2][1]) * (p[0] - chain[-2][0])) <= 0:
                chain.pop()
            chain.append(p)
        return chain[:-1]

    return half(ordered) + half(ordered[::-1])


def joined(intervals):
    """Disjoint intervals that cover the same."""
    result = []
    for low, high in sorted(intervals):
        if result and low <= result[-1][1] + ROUNDING:
            result[-1][1] = max(result[-1][1], high)
        else:
            result.append([low, high])
    return result


def as_cut(drape, pieces, loop, grains):
    """Metres: as cut and on the line, by the rule of docs/report.md."""
    _, flat, triangles = drape
    lines = {}
    for i in loop:
        ends, panel = pieces[i]
        lines.setdefault(panel, []).append((ends[0][2], ends[1][2]))
    total, on_the_line = 0, 0
    for panel, parts in lines.items():
        grain = grains.get(panel, 0)
        warp = (-math.sin(grain), math.cos(grain))
        ups = [warp, (math.cos(grain), math.sin(grain)), (0, 1), (1, 0)]
        runs = [ups[1], ups[0], (1, 0), (0, 1)]

        def across(up):
            return sum(abs(up[0] * (q[0] - p[0]) + up[1] * (q[1] - p[1])) for p, q in parts)

        least = min(range(4), key=lambda k: across(ups[k]))
        up, run = ups[least], runs[least]

        def height(p):
            return up[0] * p[0] + up[1] * p[1]

        def along(p):
            return run[0] * p[0] + run[1] * p[1]

        length = sum(math.dist(p, q) for p, q in parts)
        level = sum(math.dist(p, q) * (height(p) + height(q)) / 2 for p, q in parts) / length
        covered = joined([sorted((along(p), along(q))) for p, q in parts])
        cloth = []
        for _, corners, of in triangles:
            if of != panel:
                continue
            crossed = []
            for i in range(3):
                p, q = flat[corners[i]], flat[corners[(i + 1) % 3]]
                if (height(p) >= level) != (height(q) >= level):
                    share = (level - height(p)) / (height(q) - height(p))
                    crossed.append(along(p) + share * (along(q) - along(p)))
            if len(crossed) == 2:
                cloth.append(sorted(crossed))
        width = 0
        for low, high in joined(cloth):
            parts = [(max(low, first), min(high, last)) for first, last in covered
                     if last > low and first < high]
            width += sum(last - first for first, last in parts)
            if parts:
                # At a slanting side the line ends a little before or beyond the straight one.
                width += sum(end for end in (parts[0][0] - low, high - parts[-1][1])
                             if end < LINE_DIFFERS)
        if sum(high - low for low, high in covered) - width > LINE_DIFFERS:
            width = length
        total += width
        on_the_line += length
    return (on_the_line if total - on_the_line > LINE_DIFFERS else total), on_the_line


def girth_at(drape, height, inside, grains):
    """The loop around `inside` (x, z) with the largest area: a dict, or None."""
    pieces = level_pieces(drape, height)
    best = None
    for loop in loops(pieces):
        points = polygon(pieces, loop)
        if contains(points, inside) and (best is None or abs(area(points)) > best[0]):
            best = (abs(area(points)), loop, points)
    if best is None:
        return None
    _, loop, points = best
    cut, line = as_cut(drape, pieces, loop, grains)
    return {"garment": perimeter(points), "over_hull": perimeter(points) / perimeter(hull(points)),
            "as_cut": cut, "on_the_line": line}
