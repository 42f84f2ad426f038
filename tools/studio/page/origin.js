// Where a reading comes from: words that name things of the map, and the words that each symbol attended to.

const $ = (id) => document.getElementById(id);

function span(text, kind, parent) {
  const made = document.createElement('span');
  made.textContent = text;
  made.className = kind;
  parent.append(made, ' ');
  return made;
}

// found: the answer of /api/words, null for nothing
export function show_origin(found) {
  $('origin').hidden = !found;
  $('words').replaceChildren();
  $('symbols').replaceChildren();
  if (!found) return;
  const words = found.words.map((word, i) => {
    const name = found.mentions.find(({ begin, end }) => begin <= i && i < end)?.name;
    const made = span(word, name ? 'word named' : 'word', $('words'));
    if (name) made.title = name;
    return made;
  });
  let first = 0;  // the words of the sentences stand one after the other
  for (const sentence of found.explain) {
    const own = words.slice(first, first + sentence.words.length);
    first += sentence.words.length;
    for (const { symbol, probability, attention } of sentence.symbols) {
      if (!attention.length) continue;
      const made = span(symbol, 'symbol', $('symbols'));
      made.tabIndex = 0;
      made.title = `probability ${probability.toFixed(2)}`;
      const shade = (on) => own.forEach((word, i) => word.style.setProperty('--weight', on ? attention[i] : 0));
      for (const event of ['pointerenter', 'focus']) made.addEventListener(event, () => shade(true));
      for (const event of ['pointerleave', 'blur']) made.addEventListener(event, () => shade(false));
    }
  }
}
