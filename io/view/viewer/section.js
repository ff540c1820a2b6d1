  // A level section of body and garment, drawn to scale, with its girths.
  const sliceBox = document.getElementById('slice');

  function sectionAt(height) {
    const level = [0, height, 0], up = [0, 1, 0];
    return {
      body: data.settings.length ? cut(data.settings[0].points, data.settings[0].triangles, level, up) : [],
      cloth: cut(worn, triangles, level, up, nodeOf),
    };
  }

  function drawSection(section) {
    const drawing = document.getElementById('slice-drawing'), pen = drawing.getContext('2d');
    const all = [...section.body, ...section.cloth].flatMap(line => line.points);
    const scale = Math.min(window.devicePixelRatio || 1, 2), width = 230, height = 170;
    drawing.width = width * scale;
    drawing.height = height * scale;
    pen.setTransform(scale, 0, 0, scale, 0, 0);
    pen.clearRect(0, 0, width, height);
    if (!all.length) return;
    const box = boxOf(all.flat());
    const by = 0.92 * Math.min(width / Math.max(box.size[0], 0.05), (height - 18) / Math.max(box.size[2], 0.05));
    // Seen from above, the front at the bottom: the wearer's left is on the right.
    const at = p => [width / 2 + by * (p[0] - box.centre[0]), (height - 18) / 2 + by * (p[2] - box.centre[2])];
    const trace = line => {
      pen.beginPath();
      line.points.forEach((p, i) => (i ? pen.lineTo(...at(p)) : pen.moveTo(...at(p))));
      if (line.closed) pen.closePath();
    };
    pen.fillStyle = '#d8d3ce';
    for (const line of section.body) { trace(line); pen.fill(); }
    pen.strokeStyle = '#b03060';
    pen.lineWidth = 1.6;
    for (const line of section.cloth) { trace(line); pen.stroke(); }
    pen.strokeStyle = pen.fillStyle = '#26272b';
    pen.lineWidth = 1;
    const ruler = box.size[0] > 0.4 ? 0.1 : 0.05;
    pen.beginPath();
    pen.moveTo(8, height - 6);
    pen.lineTo(8 + by * ruler, height - 6);
    pen.stroke();
    pen.font = '11px sans-serif';
    pen.fillText(shown.unit === 'in' ? inches(100 * ruler) + ' in' : 100 * ruler + ' cm', 12 + by * ruler, height - 3);
  }

  // The closed lines of the section, the widest first: garment along the cloth, body as a tape reads.
  function girthsOf(section) {
    const centre = line => boxOf(line.points.flat()).centre;
    const bodies = section.body.map(line => ({ girth: hullGirth(line.points), centre: centre(line) }));
    return section.cloth.filter(line => line.points.length > 8).map(line => {
      const here = centre(line), box = boxOf(line.points.flat());
      const inside = bodies.filter(body => [0, 2].every(k => body.centre[k] > box.low[k] && body.centre[k] < box.high[k]));
      const within = inside.sort((a, b) => b.girth - a.girth)[0];
      return { closed: line.closed, cloth: lengthOf(line), body: within && line.closed ? within.girth : null, x: here[0] };
    }).sort((a, b) => b.cloth - a.cloth).slice(0, 5);
  }

  function lengthText(metres) { return shown.unit === 'in' ? inches(100 * metres) : (100 * metres).toFixed(1); }

  function tellSection(section) {
    const table = document.createElement('table');
    table.setAttribute('translate', 'no');
    const row = (cells, kind) => {
      const line = table.insertRow();
      for (const text of cells) {
        const place = document.createElement(kind);
        place.textContent = text;
        line.appendChild(place);
      }
    };
    row([words('girth') + ', ' + (shown.unit === 'in' ? 'inch' : 'cm'), words('garment'), words('body'), words('ease')], 'th');
    girthsOf(section).forEach((girth, i) => {
      const name = girth.closed ? String(i + 1) : words('open');
      row([name, localNumbers(lengthText(girth.cloth)), girth.body ? localNumbers(lengthText(girth.body)) : '',
        girth.body ? localNumbers(lengthText(girth.cloth - girth.body)) : ''], 'td');
    });
    const text = document.getElementById('slice-text');
    text.textContent = '';
    text.appendChild(table);
  }

  const pairs = line => line.points.slice(0, line.closed ? undefined : -1).flatMap((p, i) => [p, line.points[(i + 1) % line.points.length]]);
