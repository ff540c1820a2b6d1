'use strict';
// What the page does: choices, seams, proposals, places on the body, saving and dressing.
(function () {
  const data = JSON.parse(document.getElementById('data').textContent);
  const model = new PatternModel(data.pattern);
  const find = id => document.getElementById(id);
  const keyOf = ref => ref.panel + ':' + ref.edge;
  const maxDifference = 0.02;  // of the lengths of a seam, without a word about a gather
  const parts = ['head', 'torso', 'left_arm', 'right_arm', 'left_leg', 'right_leg'];
  const sides = ['front', 'back', 'left', 'right'];

  let version = data.version;  // of the file on disk that this page knows
  let edge = null, taken = null, place = null;  // the chosen edge, the one to sew it to, the clicked share
  let panel = null, lit = null;  // the chosen panel, the seam under the cursor in the drape
  let proposals = [], proposal = -1;
  let warnings = [], dressWarnings = [];  // of the pattern, and of the last drape
  let checked = null, checking = Promise.resolve();  // the text that was sent to be checked; resolves when that is done
  const drape = new DrapeView(find('drape'), name => { lit = name; drawSheet(); });
  const sheet = new Sheet(find('sheet'), {
    onEdge: (ref, share) => { place = share; choose(ref); take(); },
    onHover: ref => drape.light(ref && model.seamsOf(ref).length > 0 ? seamName(model.seamsOf(ref)[0]) : null),
    onPanel: name => { letGo(); panel = name; show(); },
    onNothing: () => { letGo(); panel = null; show(); },
    onView: () => drawSheet(),
  });

  function colourOf(number) { return `hsl(${(number * 137.5 + 205) % 360} 62% 42%)`; }
  function centimetres(value) { return value.toFixed(1) + ' cm'; }
  function nameOf(ref) { return ref.panel + ' ' + ref.edge; }

  // Seams.

  function isBad(stitch) { return !model.isGathered(stitch) && model.difference(stitch) > maxDifference; }
  function lengthsOf(stitch) {
    const a = model.length(stitch[0]), b = model.length(stitch[1]);
    const text = centimetres(a);
    return Math.abs(a - b) < 0.05 ? text : `${text}, ${b > a ? '+' : '−'}${centimetres(Math.abs(b - a))}`;
  }
  function warningsOf(stitch) { return warnings.filter(w => w.keys.includes(PatternModel.keyOf(stitch))); }
  function markSide(colours, ref, stitch, number, second, proposed) {
    const a = model.length(stitch[0]), b = model.length(stitch[1]);
    const own = second ? b : a, other = second ? a : b;
    const more = own - other;
    const warned = !proposed && warningsOf(stitch).length > 0;
    const text = `${number + 1}` + (Math.abs(more) < 0.05 ? '' : `: ${more > 0 ? '+' : '−'}${centimetres(Math.abs(more))}`) + (warned ? ' !' : '');
    const reversed = model.isReversed(stitch);
    colours.set(keyOf(ref), { colour: colourOf(number), text, bad: warned || isBad(stitch), proposed,
                              runs: reversed === null ? 0 : second && reversed ? -1 : 1 });
  }
  function marks() {
    const colours = new Map();
    proposals.forEach((p, i) => {
      if (p.state !== 'open') return;
      const stitch = [p.a, p.b, { reversed: p.reversed !== false }];
      markSide(colours, p.a, stitch, model.stitches.length + i, false, true);
      markSide(colours, p.b, stitch, model.stitches.length + i, true, true);
    });
    model.stitches.forEach((stitch, i) => {
      markSide(colours, stitch[0], stitch, i, false, false);
      markSide(colours, stitch[1], stitch, i, true, false);
    });
    const placed = {};
    for (const name of model.names) {
      const at = model.panels[name].placement;
      if (at && at.part) placed[name] = placementText(at);
    }
    const seam = edge && model.seamsOf(edge)[0];
    const under = model.stitches.find(stitch => seamName(stitch) === lit);
    const partner = taken || (seam && (PatternModel.same(seam[0], edge) ? seam[1] : seam[0]));
    return { colours, chosen: [edge, partner, ...(under || []).slice(0, 2)], panel, parts: placed };
  }
  function placementText(at) {
    return at.part.replace('_', ' ') + (at.side ? ', ' + at.side : '') + (at.around ? ', around' : '');
  }
  // As mesh-pattern names it.
  function seamName(stitch) {
    const [a, b, how] = stitch;
    return how && how.name ? how.name : `${a.panel}.${a.edge}-${b.panel}.${b.edge}`;
  }

  // Choices.

  function letGo() { edge = null; taken = null; place = null; }
  function choose(ref) { edge = ref; panel = ref ? ref.panel : panel; }
  // The edge is taken; the second one that is taken is sewn to the first.
  function take() {
    if (!edge) return;
    if (taken && !PatternModel.same(taken, edge)) {
      const first = taken, second = edge;
      const sewn = [...model.seamsOf(first), ...model.seamsOf(second)];
      model.act(() => {
        sewn.forEach(s => model.unsew(s));
        model.sew(first, second);
      });
      say(sewn.length > 0 ? `Sewn; ${sewn.length === 1 ? 'the seam' : 'seams'} that ${sewn.length === 1 ? 'was' : 'were'} there ${sewn.length === 1 ? 'is' : 'are'} taken out.` : 'Sewn.');
      taken = null;
    } else {
      taken = model.seamsOf(edge).length > 0 || (taken && PatternModel.same(taken, edge)) ? null : edge;
    }
    show();
  }
  function step(list, current, by) { return list.length === 0 ? -1 : (current + by + list.length) % list.length; }
  function nextEdge(by) {
    const all = model.edges();
    const at = edge ? all.findIndex(e => PatternModel.same(e, edge)) : (by > 0 ? -1 : 0);
    place = null;
    choose(all[step(all, at, by)]);
    show();
  }
  function onSeam(change) {
    const seam = edge && model.seamsOf(edge)[0];
    if (!seam) { say('The chosen edge has no seam.'); return; }
    model.act(() => change(seam));
    show();
  }
  async function split() {
    if (!edge) return;
    const chosen = edge, share = splitShare();
    await checking;  // a seam that was just drawn has no direction before
    const isKnown = model.seamsToSplit(chosen) !== null;
    if (!isKnown && !window.confirm('Which way its seam runs is not known here. Split the edge, and take the seam out?')) return;
    let cuts = [];
    model.act(() => {
      if (isKnown) cuts = model.splitSewn(chosen, share);
      else cuts = [{ rest: model.splitEdge(chosen, share) }].filter(cut => cut.rest >= 0);
    });
    taken = null;
    place = null;
    const [own, ...others] = cuts;
    say(!own ? 'It cannot be split at its end.'
      : `Split: the rest is edge ${own.rest}.` + (others.length === 0 ? ''
        : ` ${others.map(cut => nameOf(cut.ref)).join(', ')} ${others.length === 1 ? 'is' : 'are'} split, too, and both parts are sewn.`));
    show();
  }
  // Where the edge was clicked; the middle without a click.
  function splitShare() { return place === null ? 0.5 : place; }

  // Proposals.

  function takeProposals(report) {
    const open = decided => seam => ({ ...seam, decided, state: 'open' });
    proposals = [...(report.seams || []).map(open(true)), ...(report.undecided || []).map(open(false))]
      .filter(p => p.a && p.b && !model.seamsOf(p.a).some(s => PatternModel.same(s[0], p.b) || PatternModel.same(s[1], p.b)));
    proposals.sort((a, b) => a.confidence - b.confidence);
    proposal = proposals.length > 0 ? 0 : -1;
    show();
  }
  // Sews what is proposed instead of what was there.
  function sewProposal(p) {
    [...model.seamsOf(p.a), ...model.seamsOf(p.b)].forEach(s => model.unsew(s));
    model.sew(p.a, p.b, p.reversed === undefined ? {} : { reversed: p.reversed });
    p.state = 'accepted';
  }
  function decide(state) {
    const p = proposals[proposal];
    if (!p || p.state !== 'open') return;
    if (state === 'accepted') model.act(() => sewProposal(p));
    p.state = state;
    nextProposal(1);
  }
  function acceptAll() {
    model.act(() => {
      for (const p of proposals) {
        if (p.state === 'open' && p.decided) sewProposal(p);
      }
    });
    nextProposal(1);
  }
  function swap() {
    const p = proposals[proposal];
    if (!p || !p.alternative) return;
    const { a, b, reversed } = p;
    Object.assign(p, { a: p.alternative.a, b: p.alternative.b, reversed: p.alternative.reversed });
    p.alternative = { a, b, reversed };
    show();
  }
  function nextProposal(by) {
    const open = proposals.map((p, i) => i).filter(i => proposals[i].state === 'open');
    if (open.length === 0) { proposal = -1; show(); return; }
    const at = open.findIndex(i => by > 0 ? i > proposal : i >= proposal);
    proposal = by > 0 ? open[at < 0 ? 0 : at] : open[step(open, at < 0 ? 0 : at, -1)];
    choose(proposals[proposal].a);
    show();
  }

  // The place on the body.

  function setPlacement(change) {
    if (!panel) return;
    model.act(() => {
      const now = { ...(model.panels[panel].placement || {}) };
      change(now);
      model.place(panel, now);
    });
    show();
  }
  function setPart(part) {
    setPlacement(now => {
      now.part = part;
      if (part === '') { delete now.part; return; }
      if (part === 'torso' && !now.side && !now.around) now.side = 'front';
      if (part.endsWith('_arm') && !now.side && !now.around) now.around = true;
    });
  }
  function setSide(side) { setPlacement(now => { if (now.side === side) delete now.side; else now.side = side; }); }
  function setAround() { setPlacement(now => { if (now.around) delete now.around; else now.around = true; }); }

  // Panels that the garment is sewn without, such as pockets. Their seams are taken out.
  function leaveOut() {
    if (!panel) return;
    const out = model.leftOut(panel) !== '';
    model.act(() => {
      model.leaveOut(panel, out ? '' : 'asked for');
      if (!out) model.stitches.filter(s => s[0].panel === panel || s[1].panel === panel).forEach(s => model.unsew(s));
    });
    show();
  }

  // Drawing.

  function say(text) { find('progress').textContent = text; }
  function drawSheet() { sheet.draw(model, marks()); }
  function row(parent, colour, text, figure, bad, chosen, onClick) {
    const made = document.createElement('div');
    made.className = 'row' + (chosen ? ' chosen' : '');
    const swatch = document.createElement('i'), label = document.createElement('span'), value = document.createElement('b');
    swatch.style.background = colour;
    label.textContent = text;
    value.textContent = figure;
    if (bad) value.className = 'bad';
    made.append(swatch, label, value);
    made.addEventListener('click', onClick);
    parent.appendChild(made);
    return made;
  }
  function showProposals() {
    const box = find('proposals');
    box.replaceChildren();
    const open = proposals.filter(p => p.state === 'open');
    if (open.length === 0) return;
    const title = document.createElement('h2');
    title.textContent = `Proposed seams (${open.length}), the least certain first`;
    const tools = document.createElement('div');
    tools.className = 'tools';
    for (const [text, key, act] of [['Accept', 'A', () => decide('accepted')], ['Reject', 'R', () => decide('rejected')],
                                    ['Swap', 'W', swap], ['Accept all that are certain', '', acceptAll]]) {
      const button = document.createElement('button');
      button.textContent = text;
      button.title = key;
      button.dataset.proposal = text.split(' ').slice(0, 2).join('-').toLowerCase();
      button.addEventListener('click', act);
      if (text === 'Swap') button.disabled = !(proposals[proposal] && proposals[proposal].alternative);
      tools.appendChild(button);
    }
    box.append(title, tools);
    proposals.forEach((p, i) => {
      if (p.state !== 'open') return;
      row(box, colourOf(model.stitches.length + i), `${nameOf(p.a)} – ${nameOf(p.b)}`, (100 * p.confidence).toFixed(0) + ' %',
          !p.decided, i === proposal, () => { proposal = i; choose(p.a); show(); });
    });
  }
  function show() {
    drawSheet();
    const seam = edge && model.seamsOf(edge)[0];
    find('edge').textContent = !edge ? 'Click an edge, then the edge that it is sewn to.'
      : `${nameOf(edge)}: ${centimetres(model.length(edge))}` +
        (seam ? `, sewn to ${nameOf(PatternModel.same(seam[0], edge) ? seam[1] : seam[0])}` : taken ? '. Now click the edge that it is sewn to.' : '') +
        (seam && model.isReversed(seam) === null && !data.served ? '. Which way it runs is found when it is meshed.' : '');
    for (const id of ['flip', 'gather', 'unsew']) find(id).disabled = !seam;
    find('gather').className = seam && model.isGathered(seam) ? 'on' : '';
    find('split').disabled = !edge;
    const list = find('seams');
    list.replaceChildren();
    find('seams-title').textContent = `Seams (${model.stitches.length})`;
    model.stitches.forEach((stitch, i) => {
      const chosen = edge && (PatternModel.same(stitch[0], edge) || PatternModel.same(stitch[1], edge));
      row(list, colourOf(i), `${i + 1}  ${nameOf(stitch[0])} – ${nameOf(stitch[1])}`, lengthsOf(stitch) + (model.isGathered(stitch) ? ' gathered' : ''),
          isBad(stitch), chosen, () => { choose({ ...stitch[0] }); taken = null; show(); });
      for (const warning of warningsOf(stitch)) showWarning(list, warning.text).dataset.seam = seamName(stitch);
    });
    const at = panel && model.panels[panel].placement;
    find('panel').textContent = !panel ? 'Click a panel to say where it is worn.'
      : panel + ': ' + (model.leftOut(panel) ? 'left out, ' + model.leftOut(panel) : at && at.part ? placementText(at) : 'found by itself');
    find('leave-out').className = panel && model.leftOut(panel) ? 'on' : '';
    find('figure').toggleAttribute('hidden', !panel);
    find('sides').hidden = !panel;
    for (const shape of find('figure').querySelectorAll('[data-part]')) {
      shape.setAttribute('class', at && at.part === shape.dataset.part ? 'chosen' : '');
    }
    for (const button of find('sides').querySelectorAll('[data-side]')) button.className = at && at.side === button.dataset.side ? 'on' : '';
    find('sides').querySelector('[data-around]').className = at && at.around ? 'on' : '';
    find('undo').disabled = model.past.length === 0;
    find('redo').disabled = model.future.length === 0;
    showProposals();
    showWarnings();
    check();
    document.documentElement.dataset.seams = model.stitches.length;
  }
  function showWarning(box, text) {
    const line = document.createElement('p');
    line.className = 'warning';
    line.textContent = text;
    const named = model.names.find(name => text.includes(`'${name}'`)) || model.names.find(name => text.includes(name));
    if (named) { line.style.cursor = 'pointer'; line.addEventListener('click', () => { panel = named; show(); }); }
    box.appendChild(line);
    return line;
  }
  // Those of the pattern that name no seam, and those of the last drape. The others stand at their seams.
  function showWarnings() {
    const box = find('warnings');
    box.replaceChildren();
    const texts = [...warnings.filter(w => w.keys.length === 0).map(w => w.text), ...dressWarnings];
    if (texts.length === 0) return;
    const title = document.createElement('h2');
    title.textContent = 'Warnings';
    box.appendChild(title);
    for (const line of new Set(texts)) showWarning(box, line);
  }
  // Asks what mesh-pattern would warn of, and which way seams run, as soon as the pattern is another one.
  function check() {
    const now = data.served ? text() : checked;
    if (now === checked) return;
    checked = now;
    checking = checkText(now);
  }
  async function checkText(now) {
    try {
      const said = JSON.parse(await ask('POST', 'check', now));
      if (now !== checked) return;  // there is a newer one
      model.setFound(said.reversed);
      warnings = said.warnings.map(w => ({ ...w, keys: w.seams.map(i => PatternModel.keyOf(model.stitches[i])) }));
    } catch (failed) {
      if (failed.status !== 422 || now !== checked) return;
      warnings = [{ text: failed.message, keys: [] }];
    }
    document.documentElement.dataset.warnings = warnings.length;
    show();
  }
  function undo() { model.undo(); clean(); }
  function redo() { model.redo(); clean(); }
  // After undo the chosen edge may be gone.
  function clean() {
    const all = model.edges();
    if (edge && !all.some(e => PatternModel.same(e, edge))) edge = null;
    taken = null;
    if (panel && !model.panels[panel]) panel = null;
    show();
  }

  // Files and the chain.

  function text() { return JSON.stringify(model.json, null, 2) + '\n'; }
  function ask(method, where, body) {
    return fetch(where, { method, body }).then(async answer => {
      const said = await answer.text();
      if (!answer.ok) throw Object.assign(new Error(said || answer.statusText), { status: answer.status });
      return said;
    });
  }
  // `where` says what may be replaced. Another file there is somebody's work: the user is asked.
  async function saveOver(where) {
    const saved = JSON.stringify(model.json);
    try {
      const said = JSON.parse(await ask('PUT', where, text()));
      version = said.version;
      model.saved = saved;
      say(said.text);
    } catch (failed) {
      if (failed.status !== 409) { say('Not saved: ' + failed.message); return; }
      if (window.confirm(failed.message + ' Replace it?')) await saveOver('pattern'); else say('Not saved.');
    }
  }
  function save() {
    if (data.served) return saveOver('pattern/over/' + version);
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([text()], { type: 'application/json' }));
    link.download = data.name;
    link.click();
    URL.revokeObjectURL(link.href);
    model.saved = JSON.stringify(model.json);
    say('Saved as ' + data.name + ' where the browser puts downloads.');
    return Promise.resolve();
  }
  // Starts work on the server, and says how far it is. Resolves to whether it was done.
  async function work(what) {
    await ask('POST', what, text());
    for (;;) {
      const now = JSON.parse(await ask('GET', what + '/progress'));
      if (now.text) say(now.text);
      if (now.state === 'done' || now.state === 'failed') return now.state === 'done';
      await new Promise(done => setTimeout(done, 50));
    }
  }
  async function propose() {
    find('propose').disabled = true;
    const asked = JSON.stringify(model.panels);
    try {
      if (await work('propose')) showProposed(asked, JSON.parse(await ask('GET', 'proposals')));
    } catch (failed) { say(failed.message); }
    find('propose').disabled = false;
  }
  // `asked`: the panels that the seams were looked for in.
  function showProposed(asked, report) {
    if (JSON.stringify(model.panels) !== asked) {
      say('The panels were changed meanwhile. Find the seams again.');
      return;
    }
    // Its seams name the edges of the pattern that it has cut.
    model.act(() => {
      (report.splits || []).forEach(cut => model.splitEdge(cut, cut.share));
      (report.left_out || []).filter(out => !model.isSewn(out.panel)).forEach(out => model.leaveOut(out.panel, out.kind));
    });
    takeProposals(report);
    say(`${proposals.length} seams proposed.`);
  }
  async function dress() {
    find('dress').disabled = true;
    try {
      if (await work('dress')) showDrape(JSON.parse(await ask('GET', 'drape')));
    } catch (failed) { say(failed.message); }
    find('dress').disabled = false;
  }
  function showDrape(result) {
    find('middle').classList.add('dressed');
    drape.show(result);
    const verdict = find('verdict');
    verdict.textContent = result.verdict.replace('_', ' ') + (result.reason ? ': ' + result.reason : '');
    document.documentElement.dataset.verdict = result.verdict;
    dressWarnings = result.warnings.filter(text => !result.reason.includes(text));
    showWarnings();
    drawSheet();
  }

  const keys = {
    n: () => nextEdge(1), N: () => nextEdge(-1), Enter: take, Escape: () => { letGo(); show(); },
    f: () => onSeam(s => model.flip(s)), g: () => onSeam(s => model.gather(s)), x: () => onSeam(s => model.unsew(s)),
    s: split, j: () => nextProposal(1), k: () => nextProposal(-1), a: () => decide('accepted'), r: () => decide('rejected'), w: swap,
    t: () => { panel = model.names[step(model.names, panel ? model.names.indexOf(panel) : -1, 1)]; show(); },
    b: () => { const at = panel && model.panels[panel].placement; if (at && at.part) setSide(sides[step(sides, sides.indexOf(at.side), 1)]); },
    o: setAround, l: leaveOut, '+': () => sheet.zoom(1 / 1.25), '-': () => sheet.zoom(1.25), 0: () => sheet.showAll(),
    ArrowLeft: () => sheet.pan(-40 * sheet.pixel, 0), ArrowRight: () => sheet.pan(40 * sheet.pixel, 0),
    ArrowUp: () => sheet.pan(0, -40 * sheet.pixel), ArrowDown: () => sheet.pan(0, 40 * sheet.pixel),
    p: () => { if (data.served && !find('propose').disabled) propose(); }, d: () => { if (data.served && data.body && !find('dress').disabled) dress(); },
  };
  parts.forEach((part, i) => { keys[i + 1] = () => setPart(part); });
  window.addEventListener('keydown', event => {
    if (event.ctrlKey || event.metaKey) {
      const held = { z: undo, y: redo, s: save }[event.key.toLowerCase()];
      if (held) { event.preventDefault(); (event.shiftKey && held === undo ? redo : held)(); }
      return;
    }
    // Enter and space on a button are the button's.
    if (event.target instanceof HTMLButtonElement && (event.key === 'Enter' || event.key === ' ')) return;
    if (keys[event.key]) { event.preventDefault(); keys[event.key](); }
  });
  window.addEventListener('beforeunload', event => { if (model.changed) event.preventDefault(); });
  window.addEventListener('resize', show);

  find('undo').addEventListener('click', undo);
  find('redo').addEventListener('click', redo);
  find('fit').addEventListener('click', () => sheet.showAll());
  find('flip').addEventListener('click', keys.f);
  find('gather').addEventListener('click', keys.g);
  find('unsew').addEventListener('click', keys.x);
  find('split').addEventListener('click', split);
  find('save').addEventListener('click', save);
  find('propose').addEventListener('click', propose);
  find('dress').addEventListener('click', dress);
  find('propose').hidden = !data.served;
  find('dress').hidden = !(data.served && data.body);
  for (const shape of find('figure').querySelectorAll('[data-part]')) shape.addEventListener('click', () => setPart(shape.dataset.part));
  for (const button of find('sides').querySelectorAll('[data-side]')) button.addEventListener('click', () => setSide(button.dataset.side));
  find('sides').querySelector('[data-around]').addEventListener('click', setAround);
  find('sides').querySelector('[data-part]').addEventListener('click', () => setPart(''));

  find('leave-out').addEventListener('click', leaveOut);

  sheet.layOut(model);
  if (data.proposals) takeProposals(data.proposals);
  show();
  document.documentElement.dataset.state = 'ready';
})();
