  // What is shown, in the reader's words. English is the text itself. A language is a table from
  // English to it; {0} stands for any text, which is looked up in turn.
  const languages = JSON.parse(document.getElementById('languages').textContent);
  const shown = { language: 'en', unit: 'cm' };
  const originals = new WeakMap();  // text node -> its English
  let templates = [];

  function templatesOf(table) {
    return Object.keys(table).filter(key => key.includes('{0}')).map(key => {
      const order = [];
      const escaped = key.replace(/[.*+?^$()|[\]\\]/g, '\\$&');
      const source = escaped.replace(/\{(\d)\}/g, (_, digit) => { order.push(Number(digit)); return '(.+?)'; });
      return { pattern: new RegExp('^' + source + '$'), order, to: table[key], length: key.length };
    }).sort((a, b) => b.length - a.length);  // what says more comes first
  }

  // "Mittel 3.5" and the like: numbers keep their digits, and get the language's comma.
  const localNumbers = text => shown.language === 'en' ? text : text.replace(/(\d)\.(\d)/g, '$1,$2');

  function translated(text, depth = 0) {
    const table = languages[shown.language];
    if (!table || depth > 4) return text;
    if (Object.prototype.hasOwnProperty.call(table, text)) return table[text];
    for (const template of templates) {
      const match = template.pattern.exec(text);
      if (!match) continue;
      const parts = [];
      template.order.forEach((digit, i) => { parts[digit] = translated(match[i + 1], depth + 1); });
      return template.to.replace(/\{(\d)\}/g, (_, digit) => parts[digit]);
    }
    // A sentence is the capital or the full stop that a phrase lacks.
    const bare = text.replace(/\.$/, '');
    if (bare !== text) {
      const found = translated(bare, depth + 1);
      if (found !== bare) return found + '.';
    }
    const low = text.charAt(0).toLowerCase() + text.slice(1);
    if (low !== text) {
      const found = translated(low, depth + 1);
      if (found !== low) return found.charAt(0).toUpperCase() + found.slice(1);
    }
    return text;
  }

  const inches = centimetres => (centimetres / 2.54).toFixed(1);

  // Lengths in sentences: "3.0 ± 0.4 cm".
  function inUnit(text) {
    if (shown.unit === 'cm') return text;
    return text.replace(/(-?\d+(?:\.\d+)?)( (?:[±|–]|to|bis|à) )?(-?\d+(?:\.\d+)?)? cm(?![²\w])/g, (whole, a, sign, b) =>
      sign && b ? inches(a) + sign + inches(b) + ' in' : b ? whole : inches(a) + ' in');
  }

  const words = text => localNumbers(inUnit(translated(text)));

  function cell(text, isLength) {
    if (!isLength) return words(text);
    const told = translated(text);
    return localNumbers(shown.unit === 'in' ? told.replace(/-?\d+(?:\.\d+)?/g, inches) : told);
  }

  // Captions and titles end with ", cm".
  const caption = text => shown.unit === 'in' ? text.replace(/, cm$/, ', inch') : text;

  function speak() {
    document.documentElement.lang = shown.language;
    templates = templatesOf(languages[shown.language] || {});
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
      const holder = node.parentElement;
      if (!node.nodeValue.trim() || holder.closest('script, style, noscript, [translate=no]')) continue;
      if (!originals.has(node)) originals.set(node, node.nodeValue);
      const text = originals.get(node).trim();
      node.nodeValue = holder.tagName === 'CAPTION' ? words(caption(text)) : cell(text, holder.dataset.cm !== undefined);
    }
  }

  // Text of an element that the page itself makes; English in, shown as chosen.
  function say(element, text) {
    element.textContent = '';
    const node = document.createTextNode(text);
    originals.set(node, text);
    element.appendChild(node);
    node.nodeValue = words(text);
  }
