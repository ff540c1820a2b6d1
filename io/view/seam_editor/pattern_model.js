'use strict';
// The pattern as its JSON has it, and what the page does to it. No drawing here.
//
// Lengths are centimetres. An edge is named {panel, edge}: the panel's name and the edge's number
// from 0. A place along an edge is its share of the length, 0 at the first of its endpoints.
const PatternModel = (function () {
  const chords = 48;  // of a curve: lengths are right to some hundredths of a percent

  function minus(a, b) { return [a[0] - b[0], a[1] - b[1]]; }
  function between(a, b, share) { return [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])]; }
  function distance(a, b) { return Math.hypot(a[0] - b[0], a[1] - b[1]); }

  // A control point in the drawing, and back in the frame of the edge.
  function fromFrame(point, start, end) {
    const run = minus(end, start);
    return [start[0] + point[0] * run[0] - point[1] * run[1], start[1] + point[0] * run[1] + point[1] * run[0]];
  }
  function toFrame(point, start, end) {
    const run = minus(end, start), to = minus(point, start), squared = run[0] * run[0] + run[1] * run[1];
    return [(to[0] * run[0] + to[1] * run[1]) / squared, (to[1] * run[0] - to[0] * run[1]) / squared];
  }

  // Bezier curves by de Casteljau.
  function split(points, t) {
    const first = [points[0]], second = [points[points.length - 1]];
    for (let row = points; row.length > 1;) {
      const next = row.slice(1).map((p, i) => between(row[i], p, t));
      first.push(next[0]);
      second.unshift(next[next.length - 1]);
      row = next;
    }
    return [first, second];
  }
  function bezier(points, t) { return split(points, t)[0][points.length - 1]; }

  // The middle, first angle and sweep of an arc, as SVG defines it with y up.
  function arcOf(start, end, radius, large, right) {
    const chord = distance(start, end), r = Math.max(radius, chord / 2);
    const middle = between(start, end, 0.5), run = minus(end, start);
    // An arc that bulges to the right runs counter-clockwise.
    const off = Math.sqrt(Math.max(r * r - chord * chord / 4, 0)) / chord * (large === right ? -1 : 1);
    const centre = [middle[0] - off * run[1], middle[1] + off * run[0]];
    const from = Math.atan2(start[1] - centre[1], start[0] - centre[0]);
    let sweep = Math.atan2(end[1] - centre[1], end[0] - centre[0]) - from;
    if (right && sweep < 0) sweep += 2 * Math.PI;
    if (!right && sweep > 0) sweep -= 2 * Math.PI;
    return { centre, radius: r, from, sweep };
  }

  class PatternModel {
    constructor(json) {
      this.json = json;
      this.past = [];
      this.future = [];
      this.found = new Map();  // by seam, the directions that nobody has stated
      this.saved = JSON.stringify(json);
    }

    get panels() { return this.json.pattern.panels; }
    get names() { return this.json.pattern.panel_order || Object.keys(this.panels); }
    get stitches() { return this.json.pattern.stitches || (this.json.pattern.stitches = []); }
    get scale() { return 100 / ((this.json.properties || {}).units_in_meter || 100); }
    get relative() { return (this.json.properties || {}).curvature_coords !== 'absolute'; }
    get changed() { return JSON.stringify(this.json) !== this.saved; }

    // Undo: every change is made within `act`.
    act(change) {
      const before = JSON.stringify(this.json);
      change();
      if (JSON.stringify(this.json) === before) return;
      this.past.push(before);
      this.future = [];
    }
    undo() { return this.step(this.past, this.future); }
    redo() { return this.step(this.future, this.past); }
    step(from, to) {
      if (from.length === 0) return false;
      to.push(JSON.stringify(this.json));
      this.json = JSON.parse(from.pop());
      return true;
    }

    vertex(panel, index) { return this.panels[panel].vertices[index].map(x => x * this.scale); }
    ends(ref) { return this.panels[ref.panel].edges[ref.edge].endpoints.map(v => this.vertex(ref.panel, v)); }

    // The curve as parts that follow each other: Bezier control points, or an arc.
    parts(ref) {
      const [start, end] = this.ends(ref);
      const curvature = this.panels[ref.panel].edges[ref.edge].curvature;
      if (!curvature) return [{ points: [start, end] }];
      const control = p => this.relative ? fromFrame(p, start, end) : p.map(x => x * this.scale);
      if (Array.isArray(curvature)) return [{ points: [start, control(curvature), end] }];
      if (curvature.type === 'circle') {
        const [radius, large, right] = curvature.params;
        return [{ arc: arcOf(start, end, radius * this.scale, !!large, !!right), large: !!large, right: !!right }];
      }
      const points = [start, ...curvature.params.map(control), end];
      if (curvature.type !== 'cubics') return [{ points }];
      const parts = [];
      for (let i = 0; i + 3 < points.length; i += 3) parts.push({ points: points.slice(i, i + 4) });
      return parts;
    }

    // Points along the edge.
    polyline(ref) {
      const line = [];
      this.parts(ref).forEach((part, number) => {
        const count = part.arc || part.points.length > 2 ? chords : 1;
        for (let i = number > 0 ? 1 : 0; i <= count; ++i) line.push(this.onPart(part, i / count));
      });
      return line;
    }
    onPart(part, t) {
      if (!part.arc) return bezier(part.points, t);
      const { centre, radius, from, sweep } = part.arc;
      return [centre[0] + radius * Math.cos(from + t * sweep), centre[1] + radius * Math.sin(from + t * sweep)];
    }
    length(ref) {
      const line = this.polyline(ref);
      let sum = 0;
      for (let i = 1; i < line.length; ++i) sum += distance(line[i - 1], line[i]);
      return sum;
    }
    // The point at a share of the length, and the direction there.
    at(ref, share) {
      const line = this.polyline(ref);
      let left = share * this.length(ref);
      for (let i = 1; i < line.length; ++i) {
        const step = distance(line[i - 1], line[i]);
        if (left <= step || i === line.length - 1) {
          const run = minus(line[i], line[i - 1]);
          return { point: between(line[i - 1], line[i], step > 0 ? Math.min(left / step, 1) : 0),
                   along: [run[0] / (step || 1), run[1] / (step || 1)] };
        }
        left -= step;
      }
      return { point: line[0], along: [1, 0] };
    }
    // The share of the length at the point of the edge that is nearest to `point`.
    shareNear(ref, point) {
      const line = this.polyline(ref), whole = this.length(ref);
      let best = Infinity, share = 0, walked = 0;
      for (let i = 1; i < line.length; ++i) {
        const a = line[i - 1], run = minus(line[i], a), squared = run[0] * run[0] + run[1] * run[1];
        const to = minus(point, a);
        const t = squared > 0 ? Math.max(0, Math.min(1, (to[0] * run[0] + to[1] * run[1]) / squared)) : 0;
        const off = distance(between(a, line[i], t), point);
        if (off < best) { best = off; share = (walked + t * Math.sqrt(squared)) / whole; }
        walked += Math.sqrt(squared);
      }
      return share;
    }

    // The outline as edges in turn, each with whether it runs with the outline.
    outline(panel) {
      const edges = this.panels[panel].edges, left = new Set(edges.keys()), loop = [];
      let vertex = edges[0].endpoints[0];
      while (left.size > 0) {
        const next = [...left].find(e => edges[e].endpoints.includes(vertex));
        if (next === undefined) break;
        const forward = edges[next].endpoints[0] === vertex;
        loop.push({ edge: next, forward });
        vertex = edges[next].endpoints[forward ? 1 : 0];
        left.delete(next);
      }
      return loop;
    }
    // Whether the edge runs counter-clockwise around its panel.
    isCounterClockwise(ref) {
      let area = 0;
      const loop = this.outline(ref.panel);
      for (const { edge, forward } of loop) {
        const line = this.polyline({ panel: ref.panel, edge });
        if (!forward) line.reverse();
        for (let i = 1; i < line.length; ++i) area += line[i - 1][0] * line[i][1] - line[i][0] * line[i - 1][1];
      }
      const step = loop.find(s => s.edge === ref.edge);
      return (area > 0) === (step ? step.forward : true);
    }

    edges() {
      const all = [];
      for (const panel of this.names) {
        this.panels[panel].edges.forEach((_, edge) => all.push({ panel, edge }));
      }
      return all;
    }
    // Vertices that are notches.
    notches(panel) {
      return (this.panels[panel].notches || []).map(n => n.vertex)
        .filter(v => Number.isInteger(v) && v >= 0 && v < this.panels[panel].vertices.length);
    }

    static keyOf(stitch) { return stitch.slice(0, 2).map(side => side.panel + ':' + side.edge).join(' '); }
    static same(a, b) { return a.panel === b.panel && a.edge === b.edge; }
    seamsOf(ref) { return this.stitches.filter(s => PatternModel.same(s[0], ref) || PatternModel.same(s[1], ref)); }

    // Whether GarmentCode's convention holds: seams run from end to start.
    get conventional() { return !!(this.json.properties || {}).normalized_edge_loops; }
    // Whether the start of one side meets the end of the other; null: that is not known here.
    isReversed(stitch) {
      const how = stitch[2];
      if (how === 'right_wrong') return false;
      if (how && typeof how.reversed === 'boolean') return how.reversed;
      const isFound = how && how.reversed === 'found';
      if (!isFound && how && how.layer) return false;
      if (!isFound && this.conventional) return true;
      const found = this.found.get(PatternModel.keyOf(stitch));
      return found === undefined ? null : found;
    }
    // Takes over the directions that the server has found for the stitches, in turn.
    setFound(directions) {
      this.found = new Map(this.stitches.map((stitch, i) => [PatternModel.keyOf(stitch), directions[i]]));
    }
    isGathered(stitch) { return !!(stitch[2] && stitch[2].gather); }
    detail(stitch) {
      if (!stitch[2] || typeof stitch[2] !== 'object') stitch[2] = stitch[2] === 'right_wrong' ? { reversed: false } : {};
      return stitch[2];
    }
    // Why the garment is sewn without the panel; an empty reason takes it in.
    leftOut(panel) { return this.panels[panel].left_out || ''; }
    leaveOut(panel, reason) {
      if (reason) this.panels[panel].left_out = reason;
      else delete this.panels[panel].left_out;
    }
    isSewn(panel) { return this.stitches.some(s => s[0].panel === panel || s[1].panel === panel); }

    // Joins two edges, and takes their panels in. `how` may state the direction. Else the reader of the
    // file finds it, once the convention does not say it.
    sew(a, b, how) {
      this.stitches.push([{ ...a }, { ...b }, { ...(this.conventional ? { reversed: 'found' } : {}), ...how }]);
      for (const { panel } of [a, b]) this.leaveOut(panel, '');
      return this.stitches[this.stitches.length - 1];
    }
    unsew(stitch) {
      const at = this.stitches.indexOf(stitch);
      if (at >= 0) this.stitches.splice(at, 1);
    }
    flip(stitch) {
      const runs = this.isReversed(stitch);
      this.detail(stitch).reversed = runs === false;
    }
    gather(stitch) {
      const detail = this.detail(stitch);
      if (detail.gather) delete detail.gather; else detail.gather = true;
    }
    // How much longer the longer side is, as a share of the shorter.
    difference(stitch) {
      const a = this.length(stitch[0]), b = this.length(stitch[1]);
      return Math.max(a, b) / Math.min(a, b) - 1;
    }

    // Splits an edge at a share of its length. It keeps its number as far as there, the rest becomes
    // the panel's last edge. Its seams are taken out. Returns the number of the rest, or -1.
    splitEdge(ref, share) {
      const rest = this.cutEdge(ref, share);
      if (rest >= 0) this.json.pattern.stitches = this.stitches.filter(s => !PatternModel.same(s[0], ref) && !PatternModel.same(s[1], ref));
      return rest;
    }
    // The seams that the split of an edge has to cut, too; null: it is not known where.
    seamsToSplit(ref) {
      const met = this.stitches.filter(s => this.cutsWith(ref, 0.5).some(cut => PatternModel.same(s[0], cut.ref)));
      return met.some(stitch => this.isReversed(stitch) === null) ? null : met;
    }
    // As splitEdge(), but its seams stay, on both parts: what is sewn to it is split in the same place.
    // Needs seamsToSplit(). Returns the edges that were split, as {ref, share, rest}; none: it can't be split there.
    splitSewn(ref, share) {
      if (!(share > 0.001 && share < 0.999)) return [];
      const cuts = this.cutsWith(ref, share);
      const met = this.seamsToSplit(ref);
      const ways = met.map(stitch => this.isReversed(stitch));
      for (const cut of cuts) cut.rest = this.cutEdge(cut.ref, cut.share);
      const restOf = side => ({ ...side, edge: cuts.find(cut => PatternModel.same(cut.ref, side)).rest });
      met.forEach((stitch, i) => {
        const [a, b] = stitch, name = stitch[2] && stitch[2].name;
        // Which parts meet was chosen by the direction, so that both have to stay.
        const how = { ...(typeof stitch[2] === 'object' ? stitch[2] : {}), reversed: ways[i] };
        const more = name ? { name: this.freeName(name) } : {};
        // Where they run against each other, the first part of one meets the rest of the other.
        const pairs = ways[i] ? [[{ ...a }, restOf(b)], [restOf(a), { ...b }]] : [[{ ...a }, { ...b }], [restOf(a), restOf(b)]];
        this.stitches.splice(this.stitches.indexOf(stitch), 1, [...pairs[0], how], [...pairs[1], { ...how, ...more }]);
      });
      return cuts;
    }
    // The edge, those that are sewn to it, and so on, each with its share.
    cutsWith(ref, share) {
      const cuts = [{ ref: { ...ref }, share }];
      for (let i = 0; i < cuts.length; ++i) {
        for (const stitch of this.seamsOf(cuts[i].ref)) {
          const other = PatternModel.same(stitch[0], cuts[i].ref) ? stitch[1] : stitch[0];
          if (cuts.some(cut => PatternModel.same(cut.ref, other))) continue;
          cuts.push({ ref: { ...other }, share: this.isReversed(stitch) ? 1 - cuts[i].share : cuts[i].share });
        }
      }
      return cuts;
    }
    freeName(name) {
      for (let number = 2;; ++number) {
        const free = `${name} ${number}`;
        if (!this.stitches.some(s => s[2] && s[2].name === free)) return free;
      }
    }
    // Cuts the edge in two. Its seams stay as they are. Returns the number of the rest, or -1.
    cutEdge(ref, share) {
      if (!(share > 0.001 && share < 0.999)) return -1;
      const panel = this.panels[ref.panel], edge = panel.edges[ref.edge];
      const parts = this.parts(ref);
      const lengths = parts.map(part => this.partLength(part));
      let left = share * lengths.reduce((sum, x) => sum + x, 0), number = 0;
      while (number + 1 < parts.length && left > lengths[number]) left -= lengths[number++];
      const t = this.partParameter(parts[number], left);
      const middle = this.onPart(parts[number], t);
      const vertex = panel.vertices.length;
      panel.vertices.push(middle.map(x => x / this.scale));
      const rest = { ...edge, endpoints: [vertex, edge.endpoints[1]] };
      edge.endpoints = [edge.endpoints[0], vertex];
      const [first, second] = this.cut(parts, number, t);
      this.setParts(edge, first);
      this.setParts(rest, second);
      panel.edges.push(rest);
      return panel.edges.length - 1;
    }
    partLength(part) {
      let sum = 0, last = this.onPart(part, 0);
      for (let i = 1; i <= chords; ++i) {
        const next = this.onPart(part, i / chords);
        sum += distance(last, next);
        last = next;
      }
      return sum;
    }
    partParameter(part, length) {
      let left = length, last = this.onPart(part, 0);
      for (let i = 1; i <= chords; ++i) {
        const next = this.onPart(part, i / chords), step = distance(last, next);
        if (left <= step) return (i - 1 + (step > 0 ? left / step : 0)) / chords;
        left -= step;
        last = next;
      }
      return 1;
    }
    cut(parts, number, t) {
      const part = parts[number];
      if (part.arc) {
        const halves = [[0, t], [t, 1]].map(([from, to]) => {
          const sweep = part.arc.sweep * (to - from);
          const arc = { ...part.arc, from: part.arc.from + from * part.arc.sweep, sweep };
          return [{ arc, large: Math.abs(sweep) > Math.PI, right: part.right }];
        });
        return halves;
      }
      const [first, second] = split(part.points, t);
      return [[...parts.slice(0, number), { points: first }], [{ points: second }, ...parts.slice(number + 1)]];
    }
    setParts(edge, parts) {
      const first = parts[0], last = parts[parts.length - 1];
      delete edge.curvature;
      if (first.arc) {
        edge.curvature = { type: 'circle', params: [first.arc.radius / this.scale, +first.large, +first.right] };
        return;
      }
      const start = first.points[0], end = last.points[last.points.length - 1];
      const inner = parts.flatMap(part => part.points.slice(1)).slice(0, -1);
      if (inner.length === 0) return;
      const type = inner.length === 1 ? 'quadratic' : inner.length === 2 ? 'cubic' : 'cubics';
      const params = inner.map(p => this.relative ? toFrame(p, start, end) : p.map(x => x / this.scale));
      edge.curvature = { type, params };
    }

    // Where the panel is worn: {part, side, around}; an empty part takes the placement out.
    place(panel, placement) {
      if (placement.part) this.panels[panel].placement = placement;
      else delete this.panels[panel].placement;
    }
  }
  return PatternModel;
})();
if (typeof module !== 'undefined') module.exports = PatternModel;
