"""Compares seams that were found with labelled ones, by places on outlines."""
import labels
import outlines

SURE = 0.9
TIGHT, LOOSE = 0.3, 3.0  # cm by which panels may differ that coincide, and that may be taken for it
PARTS = 8  # of a found seam, whose ends are compared


class Found:
    """A seam that find-seams proposes, on the outlines of the imported panels."""

    def __init__(self, entry, sewn, imported, names):
        self.confidence = entry["confidence"]
        self.evidence = entry.get("evidence", {})
        self.reversed = entry["reversed"]
        self.arcs = []
        for side in (entry["a"], entry["b"]):
            walk = sewn[side["panel"]]
            panel = names[side["panel"]]
            outline = imported.outlines[panel]
            walk.turn(outline.angle - walk.angle)
            number = side["edge"]
            ends = [outline.place(walk.point(at))[0]
                    for at in (walk.begin[number], walk.end[number])]
            self.arcs.append(labels.Arc(panel, outline, *ends))
            if walk.turned[number]:
                self.reversed = not self.reversed
        self.length = max(arc.length for arc in self.arcs)

    def places(self, laid):
        """Both sides' panels, and pairs of places along the seam, after panels changed places."""
        panels, rows, against = [], [], self.reversed
        for i, arc in enumerate(self.arcs):
            fit = laid.get(arc.panel)
            panels.append(fit.target if fit else arc.panel)
            fractions = [f / PARTS for f in range(PARTS + 1)]
            if i == 1 and self.reversed:
                fractions.reverse()
            row = [arc.at(f) for f in fractions]
            if fit:
                row = [fit.image(at) for at in row]
                against = against != fit.mirrored
            rows.append(row)
        return panels, list(zip(*rows)), against


class Judge:
    def __init__(self, label, imported):
        self.imported = imported
        self.seams = labels.seams_of(label, imported)
        self.spare = {name for name, (piece, _) in imported.place.items() if piece in label.spare}
        self.fits = []
        for a, outline in imported.outlines.items():
            for b, other in imported.outlines.items():
                piece = imported.place[a][0]
                asked = piece == imported.place[b][0] and "ask" in label.pieces[piece]
                for fit in outlines.fits(outline, other, LOOSE if asked else TIGHT):
                    fit.source, fit.target = a, b
                    if a != b or fit.mirrored or other.apart(fit.shift, 0) > 0.5:
                        self.fits.append(fit)
                    else:
                        self.fits.insert(0, fit)
        self.known = {}

    def label_at(self, panels, places, against, near):
        """The labelled seam that joins these two places, or None."""
        for seam in self.seams:
            if seam.reversed != against:
                continue
            for i, mine in enumerate((seam.a, seam.b)):
                if mine.panel != panels[0]:
                    continue
                at = mine.fraction(places[0], near)
                if at is None:
                    continue
                others = [(seam.a, seam.b)[1 - i]]
                if seam.around is not None:
                    others = [(s.a, s.b)[1 - i] for s in self.seams if s.around == seam.around]
                for other in others:
                    if other.panel != panels[1]:
                        continue
                    if seam.around is not None:
                        if other.fraction(places[1], near) is not None:
                            return seam
                    elif other.outline.apart(other.at(1 - at if seam.reversed else at),
                                             places[1]) <= near:
                        return seam
        return None

    def match(self, found, laid):
        """The labelled seams along a found one: none where it is wrong."""
        key = (found, laid.get(found.arcs[0].panel), laid.get(found.arcs[1].panel))
        if key not in self.known:
            near = labels.tolerance(found.length)
            panels, places, against = found.places(laid)
            hits = [self.label_at(panels, pair, against, near) for pair in places]
            self.known[key] = [] if None in hits else hits
        return self.known[key]

    def counts(self, found):
        """Whether it counts: not between spare pieces."""
        return not all(arc.panel in self.spare for arc in found.arcs)

    def is_asked(self, found, laid):
        """Whether both its sides lie where a tailor would have to ask."""
        panels, places, _ = found.places(laid)
        near = labels.tolerance(found.length)
        arcs = [arc for seam in self.seams if seam.ask for arc in (seam.a, seam.b)]
        return all(any(arc.panel == panel and arc.fraction(place, near) is not None
                       for arc in arcs)
                   for pair in places[1:-1] for panel, place in zip(panels, pair))

    def lay(self, found):
        """Lets coinciding panels change places, one after the other along the found seams."""
        laid, taken = {}, set()
        at_panel = {}
        for seam in found:
            for arc in seam.arcs:
                at_panel.setdefault(arc.panel, []).append(seam)

        def score(trial):
            return sum(all(arc.panel in trial for arc in seam.arcs) and
                       bool(self.match(seam, trial)) for seam in found)

        for seed in at_panel:
            if seed in laid:
                continue
            best, best_taken, best_score = laid, taken, -1
            for fit in self.fits:
                if fit.source != seed or fit.target in taken:
                    continue
                trial, used = {**laid, seed: fit}, taken | {fit.target}
                queue = [seed]
                for panel in queue:
                    for seam in at_panel[panel]:
                        a, b = (arc.panel for arc in seam.arcs)
                        other = b if a == panel else a
                        if other in trial:
                            continue
                        for following in self.fits:
                            if following.source != other or following.target in used:
                                continue
                            if self.match(seam, {**trial, other: following}):
                                trial[other] = following
                                used = used | {following.target}
                                queue.append(other)
                                break
                value = score(trial)
                if value > best_score:
                    best, best_taken, best_score = trial, used, value
            laid, taken = best, best_taken
        plain = {}
        if sum(bool(self.match(seam, plain)) for seam in found) >= score(laid):
            return plain
        return laid

    def covered(self, seam, right, laid):
        """Whether right seams cover a labelled one."""
        best = 0.0
        arc = seam.a
        steps = 40
        for arc, i in ((seam.a, 0), (seam.b, 1)):
            hit = [False] * steps
            for found in right:
                if not any(s is seam or (s.around and s.around == seam.around)
                           for s in self.match(found, laid)):
                    continue
                panels, places, _ = found.places(laid)
                for side in (0, 1):
                    if panels[side] != arc.panel:
                        continue
                    ends = places[0][side], places[-1][side]
                    if arc.outline.span(*ends) > arc.outline.span(*ends[::-1]):
                        ends = ends[::-1]
                    walked = labels.Arc(arc.panel, arc.outline, *ends)
                    for k in range(steps):
                        at = arc.at((k + 0.5) / steps)
                        hit[k] = hit[k] or walked.fraction(at, 0) is not None
            best = max(best, sum(hit) / steps)
        return (1 - best) * seam.a.length <= labels.tolerance(seam.a.length) + 1e-9

    def ruled(self, found):
        """All seams that count, whatever their confidence, and whether each is right."""
        laid = self.lay(found)
        return [(seam, bool(self.match(seam, laid))) for seam in found
                if self.counts(seam) and not self.is_asked(seam, laid)]

    def judge(self, found, min_confidence):
        decided = [seam for seam in found if seam.confidence >= min_confidence]
        laid = self.lay(decided)
        right = [seam for seam in decided if self.match(seam, laid)]
        wrong = [seam for seam in decided
                 if not self.match(seam, laid) and self.counts(seam)
                 and not self.is_asked(seam, laid)]
        counted = [seam for seam in self.seams if seam.ask is None]
        done = [seam for seam in counted if self.covered(seam, right, laid)]
        laid_all = self.lay(found)
        listed = [seam for seam in found if self.match(seam, laid_all)]
        rest = [seam for seam in counted if seam not in done]
        undecided = [seam for seam in rest if self.covered(seam, listed, laid_all)]
        missing = [seam for seam in rest if seam not in undecided]
        return {
            "seams": len(counted), "right": len(done), "wrong": len(wrong),
            "missing": len(missing), "undecided": len(undecided),
            "wrong at ≥ 0.9": sum(seam.confidence >= SURE for seam in wrong),
            "whole": int(len(done) == len(counted) and not wrong),
            "mistakes": ["wrong   %.2f %s%s" % (seam.confidence, self.line(seam.arcs),
                                               "" if seam.reversed else ", along")
                         for seam in wrong] +
                        ["missing %s %s" % (seam.what, self.line((seam.a, seam.b)))
                         for seam in missing] +
                        ["undecided %s %s" % (seam.what, self.line((seam.a, seam.b)))
                         for seam in undecided],
        }

    @staticmethod
    def line(arcs):
        return " = ".join("%s %s to %s, %.1f cm" % (
            arc.panel, *("(%.1f, %.1f)" % arc.outline.point(arc.at(f)) for f in (0, 1)),
            arc.length) for arc in arcs)


def walks_of(panels, imported):
    return {name: outlines.Outline(panel, imported.unit) for name, panel in panels.items()}


def reported(report, sewn, imported, names=None):
    """The seams of find-seams' report, on panels as it wrote them: those undecided, too."""
    walks = walks_of(sewn, imported)
    names = names or {name: name for name in walks}
    return [Found(entry, walks, imported, names)
            for entry in report["seams"] + report["undecided"]]


def moved(found, plain, told):
    """Seams of the pieces as drawn, on the pieces as labelled: a half lies on its whole piece."""
    found = [seam for seam in found
             if all(told.pieces[plain.place[arc.panel][0]].panels for arc in seam.arcs)]
    for seam in found:
        for i, arc in enumerate(seam.arcs):
            piece, copy = plain.place[arc.panel]
            panels = told.pieces[piece].panels
            name = panels.get(copy) or panels["left"]
            target = told.outlines[name]
            arc.outline.turn(target.angle - arc.outline.angle)
            moves = [(x, y) for x in (0, target.box[0] - arc.outline.box[0])
                     for y in (0, target.box[1] - arc.outline.box[1])]
            points = [arc.outline.point(c) for c in arc.outline.corners]
            x, y = min(moves, key=lambda m: sum(
                min(target.place((px + m[0], py + m[1]))[1], 1) for px, py in points))
            ends = [target.place((px + x, py + y))[0]
                    for px, py in (arc.outline.point(arc.at(f)) for f in (0, 1))]
            seam.arcs[i] = labels.Arc(name, target, *ends)
    return found
