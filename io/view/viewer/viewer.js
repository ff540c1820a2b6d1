  // The page: what is chosen, and what follows from it.
  const byId = id => document.getElementById(id);
  const checked = id => byId(id).checked;
  const colours = { cloth: 0x111111, body: 0x2b62b5, section: 0xb03060 };
  const state = { map: data.maps.findIndex(map => map.tab), region: -1, line: -1, sections: [] };
  let hoveredRegion = -1, hoveredLine = -1;
  let space = null, pieces = null;

  try {
    space = new SpaceView(byId('space'));
    if (flat) pieces = new FlatView(byId('flat'));
  } catch (failed) {
    byId('plain').style.display = 'block';
    document.querySelectorAll('.view, #stage .no-print').forEach(element => { element.style.display = 'none'; });
    document.documentElement.dataset.state = 'no-webgl';
  }
  if (!flat) byId('flat').classList.add('none');
  const views = [space, pieces].filter(Boolean);

  // The maps: a tab for each group, and what is in the group.
  const tabs = [...new Set(data.maps.map(map => map.tab).filter(Boolean))];
  const mapsOf = tab => data.maps.map((map, i) => i).filter(i => data.maps[i].tab === tab);

  function button(text, role, holder, chosen, act) {
    const made = document.createElement('button');
    made.setAttribute('role', role);
    say(made, text);
    made.setAttribute(role === 'tab' ? 'aria-selected' : 'aria-checked', String(chosen));
    made.tabIndex = chosen ? 0 : -1;
    made.addEventListener('click', act);
    holder.appendChild(made);
    return made;
  }

  // Arrow keys within a row of buttons.
  for (const holder of [byId('tabs'), byId('group')]) {
    holder.addEventListener('keydown', event => {
      const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      if (!step) return;
      const all = [...holder.children], at = all.indexOf(document.activeElement);
      all[(at + step + all.length) % all.length].click();
      holder.querySelector('[tabindex="0"]').focus();
      event.preventDefault();
    });
  }

  const hex = colour => 'rgb(' + colour.join(',') + ')';

  function showBar(map) {
    const bar = byId('bar');
    bar.textContent = '';
    const part = (holder, kind, className) => {
      const made = document.createElement(kind);
      if (className) made.className = className;
      holder.appendChild(made);
      return made;
    };
    say(part(bar, 'div', 'name'), map.title);
    const row = part(bar, 'div', 'row');
    const end = which => {
      if (!which.text) return;
      const box = part(row, 'div', 'beyond');
      part(box, 'i').style.background = hex(which.colour);
      say(part(box, 'span'), which.text);
    };
    end(map.below);
    const scale = part(row, 'div', 'scale');
    part(scale, 'div', 'colours').style.background = 'linear-gradient(to right, ' + map.steps.map(hex).join(', ') + ')';
    const ticks = part(scale, 'div', 'ticks');
    for (const [value, text] of map.marks) {
      const tick = part(ticks, 'span');
      tick.style.left = 100 * (value - map.low) / (map.high - map.low) + '%';
      say(tick, text);
    }
    end(map.above);
    say(byId('meaning'), map.meaning);
  }

  function showMap(number) {
    state.map = number;
    const map = data.maps[number];
    byId('tabs').textContent = byId('group').textContent = '';
    if (tabs.length > 1) {
      for (const tab of tabs) button(tab, 'tab', byId('tabs'), tab === map.tab, () => showMap(mapsOf(tab)[0]));
    }
    const group = mapsOf(map.tab);
    if (group.length > 1) {
      for (const i of group) button(data.maps[i].name, 'radio', byId('group'), i === number, () => showMap(i));
    }
    showBar(map);
    if (views.length) colourBy(map);
    show();
  }

  function show() {
    const only = hoveredRegion >= 0 ? hoveredRegion : state.region;
    const opacity = byId('opacity').value / 100;
    for (const view of views) {
      view.regions.forEach((mesh, i) => {
        const quiet = only >= 0 && i !== only;
        const seen = quiet ? 0.12 : view === space ? opacity : 1;
        mesh.material.transparent = seen < 1;
        mesh.material.opacity = seen;
        mesh.material.depthWrite = seen === 1;
        view.borders[i].visible = checked('show-borders') && (!quiet || view === pieces);
        view.wires[i].visible = checked('show-mesh') && !quiet;
        if (view.sunken[i]) view.sunken[i].visible = !quiet && data.maps[state.map].tab === tabs[0];
      });
      view.draw();
    }
    if (space) space.settings.forEach((mesh, i) => { mesh.visible = checked('show-setting-' + i); });
    light();
    remember();
  }

  // The line of a row, and the section.
  function light() {
    const of = { space: [], flat: [] };
    const number = hoveredLine >= 0 ? hoveredLine : state.line;
    if (number >= 0) {
      const line = data.lines[number], ends = placesOf(line, worn);
      of.space.push({ ends, colour: colours.cloth, radius: 0.0025 });
      if (pieces) of.flat.push({ ends: placesOf(line, lying), colour: colours.cloth, radius: pieces.box.size[1] / 250, onTop: true });
      if (line.normal && data.settings.length) {
        const here = boxOf(ends.flat());
        const near = cut(data.settings[0].points, data.settings[0].triangles, line.origin, line.normal)
          .map(loop => ({ loop, box: boxOf(loop.points.flat()) }))
          .filter(({ box }) => box.centre.every((c, k) => c > here.low[k] - 0.03 && c < here.high[k] + 0.03));
        for (const { loop } of near) of.space.push({ ends: pairs(loop), colour: colours.body, radius: 0.002, onTop: true });
      }
    }
    if (checked('show-slice')) {
      const section = sectionAt(sliceHeight());
      for (const line of section.cloth) of.space.push({ ends: pairs(line), colour: colours.section, radius: 0.002 });
      drawSection(section);
      tellSection(section);
    }
    if (space) space.light(of.space);
    if (pieces) pieces.light(of.flat);
  }

  function sliceHeight() {
    const low = space ? space.box.low[1] : 0, high = space ? space.box.high[1] : 1;
    return low + (high - low) * (0.002 + 0.996 * byId('slice-height').value / 1000);
  }

  function showSlice() {
    const on = checked('show-slice');
    sliceBox.hidden = !on;
    byId('slice-at').textContent = on ? localNumbers(lengthText(sliceHeight())) + (shown.unit === 'in' ? ' in' : ' cm') : '';
    if (space) { space.plane.visible = on; space.plane.position.set(space.box.centre[0], sliceHeight(), space.box.centre[2]); }
    light();
    remember();
  }

  // Choices.
  data.settings.forEach((setting, i) => {
    const label = document.createElement('label'), box = document.createElement('input'), name = document.createElement('span');
    Object.assign(box, { type: 'checkbox', id: 'show-setting-' + i, checked: true });
    box.addEventListener('change', show);
    say(name, setting.name);
    label.append(box, ' ', name);
    byId('settings').appendChild(label);
  });
  for (const id of ['show-borders', 'show-mesh']) byId(id).addEventListener('change', show);
  byId('opacity').addEventListener('input', show);
  byId('show-slice').addEventListener('change', showSlice);
  byId('slice-height').addEventListener('input', () => { byId('show-slice').checked = true; showSlice(); });
  document.querySelectorAll('[data-view]').forEach(made => made.addEventListener('click', () => { space.look(made.dataset.view); remember(); }));
  byId('language').addEventListener('change', () => { shown.language = byId('language').value; speakAll(); });
  byId('unit').addEventListener('change', () => { shown.unit = byId('unit').value; speakAll(); });
  function speakAll() {
    speak();
    showSlice();
  }

  // Rows of tables.
  const number = (row, key) => row.dataset[key] === undefined ? -1 : Number(row.dataset[key]);
  const rows = [...document.querySelectorAll('tr[tabindex], li[tabindex]')];
  function choose(row) {
    const chosen = Boolean(row) && !row.classList.contains('chosen');
    rows.forEach(r => r.classList.toggle('chosen', r === row && chosen));
    state.region = chosen ? number(row, 'region') : -1;
    state.line = chosen ? number(row, 'line') : -1;
    show();
  }
  function hover(row) {
    hoveredRegion = row ? number(row, 'region') : -1;
    hoveredLine = row ? number(row, 'line') : -1;
    show();
  }
  for (const row of rows) {
    row.addEventListener('mouseenter', () => hover(row));
    row.addEventListener('mouseleave', () => hover(null));
    row.addEventListener('focus', () => hover(row));
    row.addEventListener('blur', () => hover(null));
    row.addEventListener('click', () => choose(row));
    row.addEventListener('keydown', event => { if (event.key === 'Enter' || event.key === ' ') { choose(row); event.preventDefault(); } });
  }

  // Values at the pointer.
  const tip = byId('tip');
  const at = (values, hit) => hit.face.reduce((sum, i, k) => sum + hit.weights[k] * values[i], 0);
  function tell(hit, event) {
    tip.style.display = hit ? 'block' : 'none';
    if (!hit) return;
    tip.textContent = '';
    const name = document.createElement('b');
    name.textContent = hit.setting ? words(hit.setting) : data.regions[hit.region].name;
    tip.appendChild(name);
    if (hit.face) {
      const table = document.createElement('table');
      const row = (what, value) => {
        const line = table.insertRow();
        line.insertCell().textContent = what;
        line.insertCell().textContent = value;
      };
      for (const map of data.maps) {
        if (map.reading) row(words(map.reading), localNumbers(at(map.values, hit).toFixed(map.decimals)) + (map.unit ? ' ' + map.unit : ''));
      }
      if (pattern) {
        const flatPlace = [0, 1].map(k => hit.face.reduce((sum, i, j) => sum + hit.weights[j] * pattern[2 * i + k], 0));
        row(words('on the panel'), flatPlace.map(x => localNumbers(lengthText(x))).join(' | ') + (shown.unit === 'in' ? ' in' : ' cm'));
      }
      row(words('height'), localNumbers(lengthText(hit.face.reduce((sum, i, k) => sum + hit.weights[k] * worn[3 * i + 1], 0))) + (shown.unit === 'in' ? ' in' : ' cm'));
      tip.appendChild(table);
    }
    const frame = byId('views').getBoundingClientRect();
    const x = event.clientX - frame.left, y = event.clientY - frame.top;
    tip.style.left = Math.max(0, Math.min(x + 14, frame.width - tip.offsetWidth - 4)) + 'px';
    tip.style.top = Math.max(0, Math.min(y + 14, frame.height - tip.offsetHeight - 4)) + 'px';
  }
  for (const view of views) {
    let asked = null;
    const probe = () => {
      const event = asked;
      asked = null;
      if (!event) return;
      const only = hoveredRegion >= 0 ? hoveredRegion : state.region;
      const hit = view.hit(event.clientX, event.clientY, only, view === space ? space.settings.filter(mesh => mesh.visible) : []);
      tell(hit, event);
      for (const other of views) if (other !== view) other.mark(hit);
    };
    view.holder.addEventListener('mousemove', event => {
      if (event.buttons) { tip.style.display = 'none'; return; }
      if (!asked) requestAnimationFrame(probe);
      asked = event;
    });
    view.holder.addEventListener('mouseleave', () => { asked = null; tip.style.display = 'none'; views.forEach(other => other.mark(null)); });
  }

  // Keys.
  document.addEventListener('keydown', event => {
    if (event.ctrlKey || event.metaKey || event.altKey || /^(INPUT|SELECT)$/.test(event.target.tagName)) return;
    const look = { 1: 'front', 2: 'back', 3: 'left', 4: 'right', 5: 'top' }[event.key];
    if (look && space) { space.look(look); remember(); }
    if (event.key === 'm') showMap(mapsOf(tabs[(tabs.indexOf(data.maps[state.map].tab) + 1) % tabs.length])[0]);
    if (event.key === 's') { byId('show-slice').checked = !checked('show-slice'); showSlice(); }
    if (event.key === 'b' && data.settings.length) { byId('show-setting-0').checked = !checked('show-setting-0'); show(); }
    if (event.key === 'Escape') choose(null);
  });
  byId('space').addEventListener('keydown', event => {
    const step = { ArrowLeft: [-0.15, 0], ArrowRight: [0.15, 0], ArrowUp: [0, -0.15], ArrowDown: [0, 0.15] }[event.key];
    if (!step || !space) return;
    space.turn(...step);
    event.preventDefault();
  });

  // A link that opens the same view again.
  let isReady = false;
  function remember() {
    if (!isReady) return;
    const round = array => array.map(x => Number(x.toFixed(4))).join(',');
    const words = new URLSearchParams();
    words.set('map', state.map);
    if (state.region >= 0) words.set('panel', state.region);
    if (state.line >= 0) words.set('line', state.line);
    if (checked('show-slice')) words.set('section', byId('slice-height').value);
    if (byId('opacity').value !== '100') words.set('opacity', byId('opacity').value);
    if (shown.language !== 'en') words.set('language', shown.language);
    if (shown.unit !== 'cm') words.set('unit', shown.unit);
    if (space) words.set('camera', round([...space.camera.position.toArray(), ...space.controls.target.toArray()]));
    history.replaceState(null, '', '#' + words);
  }
  function recall() {
    const words = new URLSearchParams(location.hash.slice(1));
    const whole = (key, size) => { const n = Number(words.get(key)); return words.has(key) && Number.isInteger(n) && n >= 0 && n < size ? n : -1; };
    const own = navigator.language ? navigator.language.slice(0, 2) : 'en';
    const language = words.get('language') || (words.has('map') ? 'en' : own);
    shown.language = languages[language] ? language : 'en';
    shown.unit = words.get('unit') === 'in' ? 'in' : 'cm';
    byId('language').value = shown.language;
    byId('unit').value = shown.unit;
    const map = whole('map', data.maps.length);
    if (map >= 0 && data.maps[map].tab) state.map = map;
    state.region = whole('panel', data.regions.length);
    state.line = whole('line', data.lines.length);
    rows.forEach(row => row.classList.toggle('chosen', (state.region >= 0 || state.line >= 0) &&
      number(row, 'region') === state.region && number(row, 'line') === state.line));
    if (whole('section', 1001) >= 0) { byId('slice-height').value = words.get('section'); byId('show-slice').checked = true; }
    if (whole('opacity', 101) >= 0) byId('opacity').value = words.get('opacity');
    const camera = (words.get('camera') || '').split(',').map(Number);
    if (space && camera.length === 6 && camera.every(Number.isFinite)) {
      space.camera.position.set(...camera.slice(0, 3));
      space.controls.target.set(...camera.slice(3));
      space.controls.update();
    }
  }
  byId('link').addEventListener('click', () => {
    remember();
    const done = () => { say(byId('link'), 'Link copied'); setTimeout(() => say(byId('link'), 'Copy link to this view'), 1500); };
    if (navigator.clipboard) navigator.clipboard.writeText(location.href).then(done, () => {});
    byId('link').dataset.address = location.href;
  });

  // The print: two sheets, each as small as it must be to fit. First what hurts, front and back and
  // the main tables; then lengths and the panels as they lie. Pictures are of the map that is shown.
  function preparePrint() {
    const paper = byId('paper');
    paper.textContent = '';
    const sheet = parts => {
      const page = document.createElement('section'), content = document.createElement('div');
      page.className = 'sheet';
      parts.filter(Boolean).forEach(part => content.appendChild(part));
      page.appendChild(content);
      paper.appendChild(page);
      const room = page.clientHeight / Math.max(content.scrollHeight, 1);
      if (room < 1) content.style.zoom = Math.floor(100 * room) / 100;
    };
    const copy = query => {
      const holder = document.createElement('div');
      document.querySelectorAll(query).forEach(element => holder.appendChild(element.cloneNode(true)));
      holder.querySelectorAll('[id]').forEach(element => { element.dataset.part = element.id; element.removeAttribute('id'); });
      holder.querySelectorAll('details').forEach(element => { element.open = true; });
      return holder;
    };
    const pictures = (className, sources) => {
      const holder = document.createElement('div');
      holder.className = className;
      for (const source of sources) {
        const image = document.createElement('img');
        image.alt = '';
        image.src = source;
        holder.appendChild(image);
      }
      return holder;
    };
    let sides = byId('still') ? [byId('still').src] : [], lies = [];
    if (space) {
      const kept = [space.camera.position.clone(), space.controls.target.clone()];
      space.plane.visible = false;
      sides = ['front', 'back'].map(side => {
        space.camera.aspect = 0.8;
        space.look(side);
        return space.picture(800, 1000);
      });
      space.camera.position.copy(kept[0]);
      space.controls.target.copy(kept[1]);
      space.plane.visible = checked('show-slice');
      space.controls.update();
      space.resize();
    }
    if (pieces) {
      lies = [pieces.picture(1400, Math.round(Math.min(1000, Math.max(500, 1400 * pieces.box.size[1] / pieces.box.size[0]))))];
      pieces.resize();
    }
    sheet([copy('header > div:first-child'), copy('.verdict, .reasons, .warnings'), pictures('sides', sides), copy('#bar'),
      copy('section.table[data-sheet="1"]')]);
    sheet([copy('section.table[data-sheet="2"]'), lies.length ? pictures('lies', lies) : null, lies.length ? copy('#bar') : null]);
  }
  window.addEventListener('beforeprint', preparePrint);
  byId('print').addEventListener('click', () => window.print());

  // Begin.
  if (space) {
    space.showSunken(data.maps[state.map]);
    views.forEach(view => view.resize());
    space.look('front');
    space.controls.addEventListener('end', remember);
    // What is written below the pictures changes their height, too.
    const watch = new ResizeObserver(() => views.forEach(view => view.resize()));
    views.forEach(view => watch.observe(view.holder));
  }
  recall();
  // The worst first: its line is lit.
  if (!location.hash.includes('map=')) choose(document.querySelector('.reasons li[tabindex]'));
  showMap(state.map);
  speakAll();
  isReady = true;
  document.documentElement.dataset.ready = 'yes';
