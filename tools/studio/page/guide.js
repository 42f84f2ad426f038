// What helps a newcomer: examples to click, words of the instruction that may be in no formula, what lines mean.

const $ = (id) => document.getElementById(id);

// Instructions about things of the map. take(text): one was clicked
export function show_examples(map, take) {
  const things = [...new Set(map.nodes.map((node) => node.object).filter(Boolean))].sort();
  const [a, b, c] = things;
  const texts = things.length < 3 ? [] :
    [`go to the ${a}, then to the ${b}`, `go to the ${b} without passing the ${c}`, `visit the ${a} and the ${c} forever`];
  const buttons = texts.map((text) => {
    const made = document.createElement('button');
    made.type = 'button';
    made.textContent = text;
    made.addEventListener('click', () => take(text));
    return made;
  });
  $('examples').replaceChildren(...buttons);
}

export function show_welcome(shown) {
  $('welcome').hidden = !shown;
  $('results').hidden = shown;
}

// Words that seldom mean anything by themselves in an instruction.
const small = new Set(('a about after all an and any are as at be been before but by can could do does down else ever for from ' +
  'come continue corridor cross follow forward get go going hall hallway have head i in into is it its just keep let move moving must never no not now of off on once one onto or ' +
  'other out over pass past place please reach robot should so some step take that the them then there this through till to toward ' +
  'towards until up visit walk walking was way we when where while will with without would you your').split(' '));

// found: the answer of /api/words, null for nothing. A word counts as read when it names something, or when a symbol of
// the formula attended to it.
export function mark_unread(found) {
  const attended = new Set();
  let first = 0;
  for (const sentence of found?.explain ?? []) {
    for (const { attention } of sentence.symbols)
      attention.forEach((weight, i) => { if (weight >= .1) attended.add(first + i); });
    first += sentence.words.length;
  }
  if (!attended.size) return;  // a reader that attends to nothing tells nothing
  [...$('words').children].forEach((word, i) => {
    const bare = word.textContent.toLowerCase().replace(/[^a-z0-9']/g, '');
    if (!bare || small.has(bare) || attended.has(i) || word.classList.contains('named')) return;
    word.classList.add('unread');
    word.title = 'No part of the formula may come from this word.';
  });
}

// Which lines and marks the drawing has now.
export function show_legend(kinds) {
  for (const entry of $('legend').children) entry.hidden = !kinds.has(entry.dataset.kind);
  $('legend').hidden = kinds.size === 0;
}

// What a proposition of a letter says of a pose, where its name does not.
export function meaning_of(name, floors) {
  const [, side, floor] = /^(?:(ahead|behind|left|right)_)?(.+)$/.exec(name);
  if (!floors.includes(floor)) return name.replaceAll('_', ' ');
  return side ? `a ${floor} hallway leads ${side === 'ahead' || side === 'behind' ? side : `to the ${side}`}`
    : `a ${floor} hallway meets this place`;
}
