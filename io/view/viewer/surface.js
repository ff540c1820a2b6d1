  // The data of the page, decoded; and geometry that needs no picture.
  const data = JSON.parse(document.getElementById('data').textContent);

  function bytes(text) {
    const raw = atob(text), array = new Uint8Array(raw.length);
    for (let i = 0; i < raw.length; ++i) array[i] = raw.charCodeAt(i);
    return array.buffer;
  }
  const floats = text => new Float32Array(bytes(text));
  const indices = text => new Uint32Array(bytes(text));

  const nodes = floats(data.surface.nodes);
  const triangles = indices(data.surface.triangles);
  const nodeOf = data.surface.nodeOf ? indices(data.surface.nodeOf) : Uint32Array.from({ length: nodes.length / 3 }, (_, i) => i);
  const flat = data.surface.flat ? floats(data.surface.flat) : null;
  const pattern = data.surface.pattern ? floats(data.surface.pattern) : null;
  const count = nodeOf.length;
  data.maps.forEach(map => { map.values = floats(map.values); });
  data.settings.forEach(setting => { setting.points = floats(setting.points); setting.triangles = indices(setting.triangles); });
  data.lines.forEach(line => { line.ends = indices(line.ends); line.parts = floats(line.parts); });

  // Points of the surface, each of its piece: three coordinates as worn, three as they lie.
  const worn = new Float32Array(3 * count), lying = new Float32Array(3 * count);
  for (let i = 0; i < count; ++i) {
    for (let k = 0; k < 3; ++k) worn[3 * i + k] = nodes[3 * nodeOf[i] + k];
    if (flat) { lying[3 * i] = flat[2 * i]; lying[3 * i + 1] = flat[2 * i + 1]; }
  }

  // Normals that are smooth across seams.
  function smoothNormals() {
    const ofNodes = new Float32Array(nodes.length);
    for (let t = 0; t < triangles.length; t += 3) {
      const [a, b, c] = [0, 1, 2].map(k => 3 * nodeOf[triangles[t + k]]);
      const u = [0, 1, 2].map(k => nodes[b + k] - nodes[a + k]), v = [0, 1, 2].map(k => nodes[c + k] - nodes[a + k]);
      const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
      for (const corner of [a, b, c]) for (let k = 0; k < 3; ++k) ofNodes[corner + k] += n[k];
    }
    const normals = new Float32Array(3 * count);
    for (let i = 0; i < count; ++i) {
      const at = 3 * nodeOf[i], size = Math.hypot(ofNodes[at], ofNodes[at + 1], ofNodes[at + 2]) || 1;
      for (let k = 0; k < 3; ++k) normals[3 * i + k] = ofNodes[at + k] / size;
    }
    return normals;
  }

  function boxOf(points) {
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < points.length; ++i) {
      low[i % 3] = Math.min(low[i % 3], points[i]);
      high[i % 3] = Math.max(high[i % 3], points[i]);
    }
    return { low, high, size: high.map((h, k) => h - low[k]), centre: high.map((h, k) => (h + low[k]) / 2) };
  }

  // Where a line of the surface lies: pairs of points, as worn or as the pieces lie.
  function placesOf(line, points) {
    const places = [];
    for (let i = 0; i < line.parts.length; ++i) {
      const a = 3 * line.ends[2 * i], b = 3 * line.ends[2 * i + 1], part = line.parts[i];
      places.push([0, 1, 2].map(k => points[a + k] + part * (points[b + k] - points[a + k])));
    }
    return places;
  }

  // The lines in which a plane cuts a mesh: {points, closed} each. `joined` says which points are one.
  function cut(points, faces, origin, normal, joined) {
    const side = new Float64Array(points.length / 3);
    for (let i = 0; i < side.length; ++i) {
      side[i] = 0;
      for (let k = 0; k < 3; ++k) side[i] += (points[3 * i + k] - origin[k]) * normal[k];
      if (side[i] === 0) side[i] = 1e-12;
    }
    const one = i => joined ? joined[i] : i;
    const size = points.length / 3, place = new Map(), next = new Map();
    for (let t = 0; t < faces.length; t += 3) {
      const ends = [];
      for (let k = 0; k < 3; ++k) {
        const a = faces[t + k], b = faces[t + (k + 1) % 3];
        if ((side[a] > 0) === (side[b] > 0)) continue;
        const low = Math.min(one(a), one(b)), high = Math.max(one(a), one(b)), edge = low * size + high;
        if (!place.has(edge)) {
          const part = side[a] / (side[a] - side[b]);
          place.set(edge, [0, 1, 2].map(j => points[3 * a + j] + part * (points[3 * b + j] - points[3 * a + j])));
        }
        ends.push(edge);
      }
      if (ends.length !== 2) continue;
      for (const [from, to] of [ends, [ends[1], ends[0]]]) {
        if (!next.has(from)) next.set(from, []);
        next.get(from).push(to);
      }
    }
    const used = new Set(), lines = [];
    const starts = [...next.keys()].sort((a, b) => next.get(a).length - next.get(b).length);  // open ends first
    for (const start of starts) {
      if (used.has(start)) continue;
      const line = [start];
      used.add(start);
      for (let at = start; at !== undefined;) {
        at = next.get(at).find(edge => !used.has(edge));
        if (at !== undefined) { used.add(at); line.push(at); }
      }
      const closed = line.length > 2 && next.get(line[line.length - 1]).includes(start);
      lines.push({ points: line.map(edge => place.get(edge)), closed });
    }
    return lines;
  }

  function lengthOf(line) {
    let sum = 0;
    const all = line.closed ? [...line.points, line.points[0]] : line.points;
    for (let i = 0; i + 1 < all.length; ++i) sum += Math.hypot(...[0, 1, 2].map(k => all[i + 1][k] - all[i][k]));
    return sum;
  }

  // The girth that a tape reads around points of a level plane.
  function hullGirth(points) {
    const sorted = points.map(p => [p[0], p[2]]).sort((a, b) => a[0] - b[0] || a[1] - b[1]);
    const half = list => {
      const chain = [];
      for (const p of list) {
        while (chain.length > 1) {
          const [a, b] = [chain[chain.length - 2], chain[chain.length - 1]];
          if ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0) break;
          chain.pop();
        }
        chain.push(p);
      }
      return chain;
    };
    const lower = half(sorted), upper = half([...sorted].reverse());
    const hull = [...lower.slice(0, -1), ...upper.slice(0, -1)];
    let sum = 0;
    hull.forEach((p, i) => { const q = hull[(i + 1) % hull.length]; sum += Math.hypot(q[0] - p[0], q[1] - p[1]); });
    return sum;
  }
