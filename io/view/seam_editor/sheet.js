'use strict';
// The panels drawn flat, to scale, side by side. It draws what it is given and says what is clicked.
const Sheet = (function () {
  const space = 6;  // centimetres between panels
  const svgNamespace = 'http://www.w3.org/2000/svg';

  function element(name, attributes, parent, text) {
    const made = document.createElementNS(svgNamespace, name);
    for (const key of Object.keys(attributes)) made.setAttribute(key, attributes[key]);
    if (text !== undefined) made.textContent = text;
    if (parent) parent.appendChild(made);
    return made;
  }
  function pathOf(line) {
    return line.map((p, i) => (i > 0 ? 'L' : 'M') + p[0].toFixed(3) + ' ' + (-p[1]).toFixed(3)).join('');
  }

  class Sheet {
    // `onEdge(ref, share)`, `onHover(ref or null)`, `onPanel(name)`, `onNothing()` are called on clicks and moves.
    constructor(svg, callbacks) {
      this.svg = svg;
      this.callbacks = callbacks;
      this.offsets = {};
      this.view = [0, 0, 100, 100];
      this.listen();
    }

    // Places of the panels in rows, about as wide as the window.
    layOut(model) {
      const boxes = {};
      let area = 0, widest = 0;
      for (const name of model.names) {
        const box = [Infinity, Infinity, -Infinity, -Infinity];
        model.panels[name].edges.forEach((_, edge) => {
          for (const [x, y] of model.polyline({ panel: name, edge })) {
            box[0] = Math.min(box[0], x); box[1] = Math.min(box[1], y);
            box[2] = Math.max(box[2], x); box[3] = Math.max(box[3], y);
          }
        });
        boxes[name] = box;
        area += (box[2] - box[0] + space) * (box[3] - box[1] + space);
        widest = Math.max(widest, box[2] - box[0]);
      }
      const shape = this.svg.clientHeight > 0 ? this.svg.clientWidth / this.svg.clientHeight : 1.5;
      const wide = Math.max(widest, 1.1 * Math.sqrt(area * shape));
      let x = 0, top = 0, deepest = 0, right = 0;
      for (const name of model.names) {
        const box = boxes[name], width = box[2] - box[0];
        if (x > 0 && x + width > wide) { x = 0; top -= deepest + space; deepest = 0; }
        this.offsets[name] = [x - box[0], top - box[3]];
        x += width + space;
        right = Math.max(right, x - space);
        deepest = Math.max(deepest, box[3] - box[1]);
      }
      this.whole = [-space, -space, right + 2 * space, deepest - top + 2 * space];
      this.view = [...this.whole];
    }

    // `marks`: `chosen` edges (some may be null), `panel`, `parts` by panel, and `colours`: by edge
    // "panel:number", the {colour, text, bad, proposed, runs} of its seam. `runs`: with the edge 1,
    // against it -1, and 0 where that is not known.
    draw(model, marks) {
      this.svg.replaceChildren();
      this.svg.setAttribute('viewBox', this.view.join(' '));
      const unit = this.view[3] / Math.max(this.svg.clientHeight, 1);  // centimetres a pixel
      this.pixel = unit;
      for (const name of model.names) this.drawPanel(model, name, marks, unit);
    }

    drawPanel(model, name, marks, unit) {
      const [dx, dy] = this.offsets[name];
      const group = element('g', { transform: `translate(${dx} ${-dy})`, 'data-panel': name }, this.svg);
      const loop = model.outline(name).flatMap(({ edge, forward }) => {
        const line = model.polyline({ panel: name, edge });
        return forward ? line : line.reverse();
      });
      const face = element('path', { d: pathOf(loop) + 'Z', class: 'panel' + (model.leftOut(name) ? ' out' : '') + (marks.panel === name ? ' chosen' : '') }, group);
      face.addEventListener('click', event => { event.stopPropagation(); this.callbacks.onPanel(name); });
      const middle = this.middleOf(loop);
      element('text', { x: middle[0], y: -middle[1], class: 'name', 'font-size': 13 * unit }, group, name);
      const below = model.leftOut(name) ? 'left out: ' + model.leftOut(name) : marks.parts[name];
      if (below) {
        element('text', { x: middle[0], y: -middle[1] + 16 * unit, class: 'part', 'font-size': 11 * unit }, group, below);
      }
      this.drawGrain(model, name, middle, group, unit);
      for (const lines of [model.panels[name].internal_lines || [], model.panels[name].cut_outs || []]) {
        for (const line of lines) {
          element('path', { d: pathOf(line.map(p => p.map(x => x * model.scale))), class: 'internal', 'stroke-width': unit }, group);
        }
      }
      model.panels[name].edges.forEach((_, edge) => this.drawEdge(model, { panel: name, edge }, marks, group, unit));
      for (const v of model.notches(name)) {
        const [x, y] = model.vertex(name, v);
        element('circle', { cx: x, cy: -y, r: 3.5 * unit, class: 'notch', 'stroke-width': 1.2 * unit }, group);
      }
    }

    middleOf(loop) {
      let x = 0, y = 0, area = 0;
      loop.forEach((p, i) => {
        const q = loop[(i + 1) % loop.length], cross = p[0] * q[1] - q[0] * p[1];
        x += (p[0] + q[0]) * cross; y += (p[1] + q[1]) * cross; area += 3 * cross;
      });
      return area === 0 ? loop[0] : [x / area, y / area];
    }

    drawGrain(model, name, middle, group, unit) {
      const angle = (90 + (model.panels[name].grain || 0)) * Math.PI / 180, half = 26 * unit;
      const way = [Math.cos(angle), Math.sin(angle)], side = [-way[1], way[0]];
      const at = (along, across) => [middle[0] - 20 * unit + along * way[0] + across * side[0],
                                     middle[1] - 34 * unit + along * way[1] + across * side[1]];
      const head = 5 * unit;
      const line = [at(-half, 0), at(half, 0), at(half - head, head / 2), at(half, 0), at(half - head, -head / 2)];
      element('path', { d: pathOf(line), class: 'grain', 'stroke-width': unit }, group);
    }

    drawEdge(model, ref, marks, group, unit) {
      const mark = marks.colours.get(ref.panel + ':' + ref.edge);
      const chosen = marks.chosen.some(e => e && e.panel === ref.panel && e.edge === ref.edge);
      const d = pathOf(model.polyline(ref));
      const drawn = element('path', { d, class: 'edge' + (chosen ? ' chosen' : '') + (mark && mark.proposed ? ' proposed' : ''),
        stroke: mark ? mark.colour : '#8a8c93', 'stroke-width': (chosen ? 5 : mark ? 3 : 1.5) * unit }, group);
      if (mark && mark.proposed) drawn.setAttribute('stroke-dasharray', `${6 * unit} ${4 * unit}`);
      const hit = element('path', { d, class: 'hit', 'stroke-width': 14 * unit, 'data-edge': ref.panel + ':' + ref.edge }, group);
      hit.addEventListener('click', event => {
        event.stopPropagation();
        this.callbacks.onEdge(ref, model.shareNear(ref, this.pointOf(event, ref.panel)));
      });
      hit.addEventListener('pointerenter', () => this.callbacks.onHover(ref));
      hit.addEventListener('pointerleave', () => this.callbacks.onHover(null));
      if (mark) this.drawSeamMark(model, ref, mark, group, unit);
    }

    // The seam's number, an arrow the way that its two sides run together, and the lengths.
    drawSeamMark(model, ref, mark, group, unit) {
      const { point, along } = model.at(ref, 0.5);
      const inwards = model.isCounterClockwise(ref) ? 1 : -1;
      const off = [-inwards * along[1], inwards * along[0]];
      const at = (a, b) => [point[0] + a * unit * along[0] + b * unit * off[0], point[1] + a * unit * along[1] + b * unit * off[1]];
      const way = mark.runs;
      if (way !== 0) {
        element('path', { d: pathOf([at(-9 * way, 5), at(9 * way, 5), at(4 * way, 9)]), class: 'arrow', stroke: mark.colour, 'stroke-width': 1.6 * unit,
          'data-arrow': ref.panel + ':' + ref.edge, 'data-runs': way > 0 ? 'with' : 'against' }, group);
      }
      const label = at(0, 18);
      element('text', { x: label[0], y: -label[1] + 4 * unit, class: mark.bad ? 'seam bad' : 'seam', 'font-size': 11 * unit,
        fill: mark.colour }, group, mark.text);
    }

    // A point of the window in centimetres of the panel's drawing.
    pointOf(event, panel) {
      const box = this.svg.getBoundingClientRect(), [x, y, width, height] = this.view;
      const scale = Math.max(width / box.width, height / box.height);
      const left = x + (width - scale * box.width) / 2, top = y + (height - scale * box.height) / 2;
      const [dx, dy] = panel ? this.offsets[panel] : [0, 0];
      return [left + scale * (event.clientX - box.left) - dx, -(top + scale * (event.clientY - box.top)) - dy];
    }

    zoom(factor, about) {
      const [x, y, width, height] = this.view;
      const cx = about ? about[0] : x + width / 2, cy = about ? -about[1] : y + height / 2;
      this.view = [cx + (x - cx) * factor, cy + (y - cy) * factor, width * factor, height * factor];
      this.callbacks.onView();
    }
    pan(dx, dy) {
      this.view[0] += dx; this.view[1] += dy;
      this.callbacks.onView();
    }
    showAll() {
      this.view = [...this.whole];
      this.callbacks.onView();
    }

    listen() {
      this.svg.addEventListener('wheel', event => {
        event.preventDefault();
        this.zoom(event.deltaY > 0 ? 1.15 : 1 / 1.15, this.pointOf(event, null));
      }, { passive: false });
      let held = null, moved = false;
      this.svg.addEventListener('pointerdown', event => { held = [event.clientX, event.clientY]; moved = false; });
      // The end of a move is a click for the browser, but not for the user.
      this.svg.addEventListener('click', event => { if (moved) event.stopPropagation(); }, true);
      this.svg.addEventListener('click', () => { if (!moved) this.callbacks.onNothing(); });
      window.addEventListener('pointerup', () => { held = null; });
      this.svg.addEventListener('pointermove', event => {
        if (!held || event.buttons === 0) return;
        const dx = event.clientX - held[0], dy = event.clientY - held[1];
        if (Math.hypot(dx, dy) < 3) return;
        held = [event.clientX, event.clientY];
        moved = true;
        this.pan(-dx * this.pixel, -dy * this.pixel);
      });
    }
  }
  return Sheet;
})();
