// The studio: what is asked, what is answered, and the step at which the answer is looked at.

import { ask, ApiError } from './api.js';
import { MapView, drawing, same } from './map.js';
import { mark_unread, meaning_of, show_examples, show_legend, show_welcome } from './guide.js';
import { show_origin } from './origin.js';
import { in_words as solved_in_words, is_learner, learn, percent, poses_of } from './solver.js';

const $ = (id) => document.getElementById(id);
const state = {
  map: null, start: null, instruction: '', formula: '', semantics: 'auto', infinite: false,
  answer: null, readings: [], other: null,
  walk: null, steps: [], step: 0, automaton: null, hand: false, drawn: false, timer: null, turn: 0, solver: 'exact', slip: 0, solved: null,
};

// hand: places that are clicked go on the trajectory. drawn: the walk is such a trajectory, finished or not.
const view = new MapView($('paper'), take_node);
const start_text = () => state.start.join();
const semantics = () => (state.infinite ? 'infinite' : 'finite');
const task = () => ({ map: state.map.map, start: start_text(), formula: state.formula, semantics: semantics() });

// What is said below the instruction.
function say(text, bad = false, button = null) {
  $('message').textContent = text;
  $('message').classList.toggle('bad', bad);
  if (!button) return;
  const made = document.createElement('button');
  made.type = 'button';
  made.textContent = button.text;
  made.addEventListener('click', button.press);
  $('message').append(made);
}

// Runs what asks the server; of two at a time only the later one is shown.
async function latest(work) {
  const turn = ++state.turn;
  document.body.dataset.busy = turn;
  const current = () => turn === state.turn;
  try {
    await work(current);
  } catch (error) {
    if (!(error instanceof ApiError)) throw error;
    if (current()) say(error.message, true);
  } finally {
    if (current()) delete document.body.dataset.busy;
  }
}

// ── maps ────────────────────────────────────────────────────────────────────────────────────────────────────────

function show_map(map, start = null) {
  state.map = map;
  state.start = start && view_has(map, start) ? start : map.start;
  view.show(map);
  show_examples(map, (text) => { $('instruction').value = text; run(); });
  if (![...$('map').options].some((option) => option.value === map.map))
    $('map').append(new Option(map.name || 'your map', map.map));
  $('map').value = map.map;
  reset_walk();
}

const view_has = (map, [x, y]) => map.nodes.some((node) => node.x === x && node.y === y);

async function choose_map(name, start = null) {
  show_map(await ask('map', { map: name }), start);
}

async function open_file(file) {
  if (!file) return;
  await latest(async (current) => {
    const map = await ask('maps', await file.text());
    if (!current()) return;
    show_map(map);
    forget_answer();
    say(`The map ${map.name || file.name} has ${map.nodes.length} places.`);
    remember();
  });
}

// ── what is asked ───────────────────────────────────────────────────────────────────────────────────────────────

// Nothing is asked, or what was asked has no answer: no older one stays. The texts that were typed do.
function clear_answer() {
  Object.assign(state, { formula: '', instruction: '', readings: [], other: null, answer: null, automaton: null, solved: null });
  show_formula(null);
  show_origin(null);
  show_readings();
  show_question(null);
  show_automaton(null);
  if (state.drawn) Object.assign(state, { steps: [], check: null });
  state.drawn ? draw() : reset_walk();
  $('curve').hidden = true;
  for (const id of ['understood', 'answer', 'notation', 'solved']) $(id).textContent = '';
}

function forget_answer() {
  $('instruction').value = $('formula').value = '';
  clear_answer();
  show_welcome(true);
}

async function run(force = false) {
  const text = $('instruction').value.trim();
  if (!text) {
    forget_answer();
    say('');
    return remember();
  }
  set_hand(false);
  show_question(null);
  state.instruction = text;
  state.drawn = false;
  await latest(async (current) => {
    say('…');
    const answer = await ask('run', {
      map: state.map.map, start: start_text(), instruction: text, semantics: state.semantics, force });
    if (!current()) return;
    if (answer.status === 'not understood') return not_understood(answer, text);
    show_welcome(false);
    state.readings = answer.shown;
    state.infinite = answer.semantics === 'infinite';
    take_formula(answer.formula);
    $('understood').textContent = answer.understood;
    show_readings();
    await show_answer(answer, current);
    show_question(answer.alternatives?.[0] ?? null);
    say('');
    const words = await ask('words', {
      map: state.map.map, start: start_text(), instruction: text, attention: answer.shown[0].reader === 'routes' });
    if (!current()) return;
    show_origin(words);
    mark_unread(words);
  });
  remember();
}

function not_understood(answer, text) {
  const quoted = (words) => words.map((word) => `“${word}”`).join(', ');
  let why = '';
  if (answer.missing) {
    why = `Nothing here is called ${quoted([answer.missing.words])}.`;
    if (answer.missing.nearest.length) why += ` Nearest: ${quoted(answer.missing.nearest)}.`;
  } else if (answer.words.length) {
    why = `No command says ${quoted(answer.words)}.`;
  }
  $('formula').value = '';
  clear_answer();
  show_welcome(true);
  state.instruction = text;
  say(`I did not understand this. ${why}`, true, { text: 'Answer all the same', press: () => run(true) });
}

function take_formula(formula) {
  state.formula = formula;
  $('formula').value = formula;
  fit();
}

// The field is as high as its text.
function fit() {
  $('formula').style.height = 'auto';
  $('formula').style.height = `${$('formula').scrollHeight + 2}px`;
}

// Plans the formula in the field, and shows its route.
async function plan() {
  if (!state.formula) return;
  await latest(async (current) => {
    const written = await ask('formula', { map: state.map.map, formula: state.formula });
    if (!current()) return;
    show_formula(written);
    show_welcome(false);
    if (state.drawn) return show_automaton_and_walk(current);
    await show_answer(await ask('plan', task()), current);
    say('');
  });
  remember();
}

async function show_answer(answer, current) {
  if (!current()) return;
  state.answer = answer;
  state.walk = answer.route ? { poses: answer.route, cycle: answer.cycle ? answer.cycle.length - 1 : 0 } : null;
  state.step = 0;
  $('answer').textContent = in_words(answer);
  if (!state.walk) reset_walk();
  await show_automaton_and_walk(current);
  if (!current()) return;
  if (state.walk) draw();
  await solve(current);
}

function in_words(answer) {
  const product = `Product with the map: ${answer.product.states} states met, ${answer.product.edges} edges.`;
  if (answer.status !== 'solved') return `No route: ${answer.reason}. ${product}`;
  const count = (n) => `${n} action${n === 1 ? '' : 's'}`;
  const route = answer.cycle
    ? `${count(answer.prefix.length - 1)}, then ${count(answer.cycle.length - 1)} for ever`
    : `${count(answer.route.length - 1)}`;
  return `Route: ${route}, certified by the ${answer.certified_by}. ${product}`;
}

async function show_automaton_and_walk(current) {
  const [written, automaton, check] = await Promise.all([
    ask('formula', { map: state.map.map, formula: state.formula }),
    ask('automaton', { map: state.map.map, formula: state.formula, semantics: semantics() }),
    state.walk ? ask('check', check_request()) : null]);
  if (!current()) return;
  show_formula(written);
  show_automaton(automaton);
  show_check(check);
}

const check_request = () =>
  ({ ...task(), trajectory: state.walk.poses, cycle: state.walk.cycle ?? 0 });

// ── formula, readings, question ─────────────────────────────────────────────────────────────────────────────────

function show_formula(written, error = null) {
  $('fault').hidden = !error;
  $('formula').setAttribute('aria-invalid', error ? 'true' : 'false');
  if (error) {
    $('fault').textContent = error.begin === undefined ? error.message : pointing_at(error);
    return;
  }
  state.written = written;
  $('notation').textContent = written ? written.unicode : '';
  if (written) $('understood').textContent = written.english[semantics()];
}

// The part of the formula where it is wrong, with carets below.
function pointing_at({ begin, end, message }) {
  const text = [...$('formula').value.replaceAll('\n', ' ')];
  const from = Math.max(0, begin - 30);
  const part = text.slice(from, from + 60).join('');
  const carets = '^'.repeat(Math.max(1, Math.min(end, from + 60) - begin));
  return `${from > 0 ? '…' : ' '}${part}\n ${' '.repeat(begin - from)}${carets}\n${message}`;
}

let typing = null;
function formula_typed() {
  fit();
  clearTimeout(typing);
  typing = setTimeout(async () => {
    const text = $('formula').value.trim();
    if (!text) {
      ++state.turn;  // what is under way is about the formula that was there
      delete document.body.dataset.busy;
      clear_answer();
      show_welcome(!state.drawn);
      return remember();
    }
    try {
      const written = await ask('formula', { map: state.map.map, formula: $('formula').value });
      if ($('formula').value.trim() !== text) return;
      if (state.semantics !== 'auto') state.infinite = state.semantics === 'infinite';
      state.formula = text;
      show_formula(written);
      state.readings = [];
      show_origin(null);
      show_readings();
      show_question(null);
      await plan();
    } catch (error) {
      if (!(error instanceof ApiError)) throw error;
      if ($('formula').value.trim() === text) show_formula(null, error);
    }
  }, 180);
}

function show_readings() {
  const list = state.readings.map((reading, i) => {
    const label = document.createElement('label');
    label.className = 'reading';
    label.title = reading.unicode;
    const radio = document.createElement('input');
    Object.assign(radio, { type: 'radio', name: 'reading', checked: reading.formula === state.formula });
    radio.addEventListener('change', () => {
      take_formula(reading.formula);
      plan();
    });
    const probability = document.createElement('span');
    probability.textContent = `${(100 * reading.probability).toFixed(i > 0 && reading.probability < .1 ? 1 : 0)} %`;
    const english = document.createElement('span');
    english.textContent = reading.english;
    label.append(radio, probability, english);
    return label;
  });
  $('readings').replaceChildren($('readings').firstElementChild, ...list);
  $('readings').hidden = list.length < 2;
}

// Of two close readings: a route that only one of them lets pass, drawn beside the route of the first.
function show_question(other) {
  const route = other?.distinguishing.route ?? null;
  state.other = route;
  $('question').hidden = !other;
  if (!other) return;
  const text = document.createElement('p');
  const which = other.distinguishing.route_of === 'first' ? 'first' : 'other';
  text.textContent = `Did you mean: ${other.english}` + (route
    ? ` Only the ${which} reading lets the dotted blue route pass.` : '');
  const yes = document.createElement('button');
  yes.type = 'button';
  yes.textContent = 'Yes, this is what I mean';
  yes.addEventListener('click', () => {
    take_formula(other.formula);
    show_question(null);
    plan().then(show_readings);
  });
  $('question').replaceChildren(text, yes);
  if (state.walk) draw();
}

// ── automaton and steps ─────────────────────────────────────────────────────────────────────────────────────────

function show_automaton(automaton) {
  state.automaton = automaton;
  $('automaton').hidden = !automaton;
  if (!automaton) return;
  const count = (n, noun) => `${n} ${noun}${n === 1 ? '' : 's'}`;
  $('size').textContent = `${count(automaton.states, 'state')}, ${count(automaton.edges, 'edge')}, over ` +
    (state.infinite ? 'infinite words' : 'finite words');
  if (automaton.svg) $('graph').replaceChildren(drawing(automaton.svg));
  else $('graph').textContent = 'The automaton is not drawn: it is too large, or Graphviz is not installed.';
}

function show_check(check) {
  state.check = check;
  state.steps = check ? check.steps : [];
  if (check && state.walk) state.walk.lost = check.lost_at ? check.lost_at - 1 : null;  // letters are counted from 1
  if (check && state.drawn) {
    $('answer').textContent = state.infinite
      ? (check.decided ? verdict_of(check.satisfied) : 'The trajectory goes on: repeat its end for ever to decide.')
      : verdict_of(check.satisfied);
  }
  if (check && state.drawn && check.lost_at !== null && check.lost_at !== undefined)
    $('answer').textContent += ` All is lost with letter ${check.lost_at}.`;
  draw();
}

const verdict_of = (satisfied) => `The trajectory ${satisfied ? 'satisfies' : 'does not satisfy'} the formula.`;

function reset_walk() {
  stop();
  state.drawn = state.hand;
  state.walk = state.hand ? { poses: [state.start], cycle: 0 } : null;
  state.steps = [];
  state.step = 0;
  draw();
}

function draw() {
  const walk = state.walk ?? { poses: [state.start] };
  const last = walk.poses.length - 1;
  state.step = Math.min(state.step, last);
  show_legend(view.draw({ ...walk, other: state.drawn ? null : state.other }, state.step));
  $('start').textContent = `start ${start_text()}`;
  $('step').max = last;
  $('step').value = state.step;
  $('undo').disabled = !state.hand || last === 0;
  $('loop').disabled = !(state.hand && state.infinite && loop_length() > 0);
  const action = state.steps[state.step]?.action;
  $('count').textContent = state.step === 0 ? `start of ${last}` : `${state.step} of ${last}: ${action ?? ''}`;
  for (const id of ['first', 'back']) $(id).disabled = state.step === 0;
  for (const id of ['next', 'play']) $(id).disabled = last === 0;
  show_now();
}

function show_now() {
  const step = state.steps[state.step];
  $('now').hidden = !step;
  light(step);
  show_values();
  if (!step) return;
  const read = new Set((state.formula.match(/"[^"]*"|\w+/g) ?? []).map((name) => name.replaceAll('"', '')));
  const chips = step.letter.filter((name) => read.has(name)).map((name) => {
    const chip = document.createElement('span');
    chip.className = 'chip';
    chip.textContent = name;
    chip.title = meaning_of(name, state.map.floors);
    return chip;
  });
  const others = step.letter.filter((name) => !read.has(name));
  const more = document.createElement('details');
  more.open = $('letter').querySelector('details')?.open ?? false;
  const summary = document.createElement('summary');
  summary.textContent = `${chips.length ? 'and ' : ''}${others.length} that the formula does not name`;
  const floors = step.letter.filter((name) => state.map.floors.includes(name)).map((name) => meaning_of(name, state.map.floors));
  more.append(summary, others.join(', ') + (floors.length ? ` (${floors.join('; ')})` : ''));
  $('letter').replaceChildren(...chips, more);
  $('remains').textContent = step.unicode;
  const words = { satisfied: 'satisfied, if it ends here', lost: 'lost, whatever follows', open: 'open' };
  $('verdict').textContent = `— ${words[step.verdict]}`;
  $('verdict').className = { satisfied: 'satisfied', lost: 'lost-word', open: '' }[step.verdict];
}

// The states after the letter, and the edges that led there.
function light(step) {
  const graph = $('graph');
  for (const lit of graph.querySelectorAll('.lit')) lit.classList.remove('lit');
  if (!step || !state.automaton) return;
  const before = state.step === 0 ? [state.automaton.initial] : state.steps[state.step - 1].states;
  const edges = new Set(before.flatMap((from) => step.states.map((to) => `${from}->${to}`)));
  for (const title of graph.querySelectorAll('g > title')) {
    const group = title.parentElement;
    const is_node = group.classList.contains('node') && step.states.includes(Number(title.textContent));
    if (title.textContent !== '' && (is_node || edges.has(title.textContent))) group.classList.add('lit');
  }
}

function go_to(step) {
  const last = (state.walk ?? { poses: [0] }).poses.length - 1;
  const loop = last - (state.walk?.cycle ?? 0);
  state.step = step > last ? (state.walk?.cycle ? loop + 1 : last) : Math.max(0, step);
  draw();
}

function stop() {
  clearInterval(state.timer);
  state.timer = null;
  $('play').textContent = 'Play';
}

function play() {
  if (state.timer) return stop();
  const ends = () => state.step === state.walk.poses.length - 1 && !state.walk.cycle;
  if (ends()) go_to(0);
  $('play').textContent = 'Pause';
  state.timer = setInterval(() => {
    go_to(state.step + 1);
    if (ends()) stop();
  }, 600);
}

// ── poses and trajectories by hand ──────────────────────────────────────────────────────────────────────────────

function set_hand(on) {
  if (on === state.hand) return;
  state.hand = on;
  $('undo').disabled = true;  // until it is drawn again
  $('draw').setAttribute('aria-pressed', String(on));
  $('draw').textContent = on ? 'Drawing: click places' : 'Draw a trajectory';
}

// The trajectory that was drawn stays when drawing ends, and is gone on with when it begins again.
function toggle_hand() {
  set_hand(!state.hand);
  if (!state.hand && state.walk.poses.length > 1) {
    draw();
    return say('The trajectory stays.', false, { text: 'Show the route again', press: () => { reset_walk(); plan(); } });
  }
  if (state.hand && state.drawn) return check_hand();
  reset_walk();
  state.hand ? check_hand() : plan();
}

function take_node(node) {
  if (state.hand) return extend(view.way(state.walk.poses.at(-1), node));
  const [x, y, heading] = state.start;
  const turned = x === node.x && y === node.y ? (heading + 90) % 360 : heading;
  take_start([node.x, node.y, turned]);
}

function take_start(pose) {
  state.start = pose;
  reset_walk();
  plan();
}

async function extend(poses) {
  if (!poses.length) return;
  state.walk = { poses: [...state.walk.poses, ...poses], cycle: 0 };
  await check_hand();
}

async function check_hand() {
  state.step = state.walk.poses.length - 1;
  state.steps = [];
  draw();
  if (state.formula)
    await latest(async (current) => {
      const check = await ask('check', check_request());
      if (current()) show_check(check);
    });
  remember();
}

// Actions since the trajectory was last in the pose in which it ends.
function loop_length() {
  const poses = state.walk?.poses ?? [];
  for (let i = poses.length - 2; i >= 0; --i) if (same(poses[i], poses.at(-1))) return poses.length - 1 - i;
  return 0;
}

function map_key(event) {
  const action = { ArrowUp: 'FORWARD', ArrowLeft: 'LEFT', ArrowRight: 'RIGHT' }[event.key];
  if (event.key === 'Backspace' && state.hand) undo();
  else if (!action) return;
  event.preventDefault();
  if (!action) return;
  const from = state.hand ? state.walk.poses.at(-1) : state.start;
  const to = view.after(from, action);
  if (!to) return say('There is a wall.');
  state.hand ? extend([to]) : take_start(to);
}

function undo() {
  if (state.walk.poses.length < 2) return;
  state.walk = { poses: state.walk.poses.slice(0, -1), cycle: 0 };
  check_hand();
}

// ── other solvers ───────────────────────────────────────────────────────────────────────────────────────────────

// Asks the solver that is chosen about the formula; what it answered before is taken away.
async function solve(current) {
  state.solved = null;
  $('curve').hidden = true;
  $('solved').textContent = '';
  show_values();
  if (state.solver === 'exact' || !state.formula) return;
  if (state.infinite) {
    $('solved').textContent = 'This solver is for finite words here; choose them above.';
    return;
  }
  const request = { ...task(), slip: state.slip };
  if (is_learner(state.solver)) {
    const tell = (text) => { $('solved').textContent = text; };
    tell('…');
    return learn({ ...request, method: state.solver }, $('curve'), current, tell);
  }
  const solved = await ask('values', { ...request, query: state.solver });
  if (!current()) return;
  state.solved = solved;
  $('solved').textContent = solved_in_words(solved);
  show_values();
}

// Of the state of the automaton that the step has come to.
function show_values() {
  const now = state.steps[state.step]?.states[0] ?? state.automaton?.initial;
  view.show_values(state.solved ? poses_of(state.solved, now) : []);
}

function solver_changed() {
  state.solver = $('solver').value;
  state.slip = Number($('slip').value);
  $('chance').textContent = percent(state.slip);
  $('slip').disabled = state.solver === 'exact';
  latest(solve);
  remember();
}

// ── exports, and the link ───────────────────────────────────────────────────────────────────────────────────────

function save(name, text, type) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

async function export_as(kind) {
  if (!state.formula) return say('There is nothing to export yet.', true);
  await latest(async () => {
    if (kind === 'json') return save('waymark.json', `${JSON.stringify(state.answer, null, 2)}\n`, 'application/json');
    if (kind === 'latex') return save('formula.tex', `${state.written.latex}\n`, 'application/x-tex');
    if (kind === 'automaton-svg') return save('automaton.svg', state.automaton.svg, 'image/svg+xml');
    if (kind === 'svg') {
      const picture = await ask('picture', { ...task(), instruction: state.instruction });
      return save('waymark.svg', picture.svg, 'image/svg+xml');
    }
    if (kind === 'prism') {
      const product = await ask('prism', { ...task(), slip: state.slip });
      return save('product.nm', product.text, 'text/plain');
    }
    const request = { ...task(), format: kind };
    if (kind === 'never') Object.assign(request, { semantics: 'infinite', to: 'buchi' });
    const made = await ask('translate', request);
    save(`automaton.${kind}`, made.text, 'text/plain');
  });
}

// What the link says: enough to see the same again.
function remember() {
  const link = new URLSearchParams({ map: state.map.map, start: start_text() });
  if (state.instruction) link.set('say', state.instruction);
  if (state.formula) link.set('formula', state.formula);
  if (state.semantics !== 'auto' || state.infinite) link.set('words', semantics());
  if (state.drawn && state.walk) link.set('walk', state.walk.poses.map((pose) => pose.join('.')).join(' '));
  if (state.drawn && state.walk?.cycle) link.set('cycle', state.walk.cycle);
  if (state.step) link.set('step', state.step);
  if (state.solver !== 'exact') {
    link.set('solver', state.solver);
    link.set('slip', state.slip);
  }
  history.replaceState(null, '', `#${link}`);
}

async function recall(link) {
  const numbers = (text, separator) => text.split(separator).map(Number);
  await choose_map(link.get('map') ?? 'grid', link.has('start') ? numbers(link.get('start'), ',') : null);
  if (link.has('words')) {
    $('semantics').value = state.semantics = link.get('words');
    state.infinite = state.semantics === 'infinite';
  }
  const step = Number(link.get('step') ?? 0);
  if (link.has('solver')) {
    $('solver').value = link.get('solver');
    $('slip').value = link.get('slip') ?? 0;
  }
  solver_changed();
  $('instruction').value = link.get('say') ?? '';
  const formula = link.get('formula') ?? '';
  if (link.has('say')) await run();
  if (formula && formula !== state.formula) {
    take_formula(formula);
    await plan();
    show_readings();
  }
  if (link.has('walk')) {
    set_hand(true);
    state.drawn = true;
    state.walk = { poses: link.get('walk').split(' ').map((pose) => numbers(pose, '.')),
      cycle: Number(link.get('cycle') ?? 0) };
    await check_hand();
  }
  if (step) go_to(step);
}

// ── wiring ──────────────────────────────────────────────────────────────────────────────────────────────────────

function listen() {
  $('ask').addEventListener('submit', (event) => { event.preventDefault(); run(); });
  $('formula').addEventListener('input', formula_typed);
  $('formula').addEventListener('keydown', (event) => { if (event.key === 'Enter') event.preventDefault(); });
  $('map').addEventListener('change', () => latest(async () => {
    const text = $('instruction').value;
    await choose_map($('map').value);
    forget_answer();
    $('instruction').value = text;
    remember();
  }));
  $('semantics').addEventListener('change', () => {
    state.semantics = $('semantics').value;
    if (state.semantics !== 'auto') state.infinite = state.semantics === 'infinite';
    if (state.instruction && !state.hand && state.semantics === 'auto') run();
    else plan();
  });
  $('open').addEventListener('click', () => $('file').click());
  $('file').addEventListener('change', () => { open_file($('file').files[0]); $('file').value = ''; });
  $('first').addEventListener('click', () => { stop(); go_to(0); });
  $('back').addEventListener('click', () => { stop(); go_to(state.step - 1); });
  $('next').addEventListener('click', () => { stop(); go_to(state.step + 1); });
  $('play').addEventListener('click', play);
  $('step').addEventListener('input', () => { stop(); go_to(Number($('step').value)); });
  $('draw').addEventListener('click', toggle_hand);
  $('larger').addEventListener('click', () => view.zoom(1.4));
  $('smaller').addEventListener('click', () => view.zoom(1 / 1.4));
  $('undo').addEventListener('click', undo);
  $('loop').addEventListener('click', () => { state.walk.cycle = loop_length(); check_hand(); });
  $('paper').addEventListener('keydown', map_key);
  for (const id of ['solver', 'slip']) $(id).addEventListener('change', solver_changed);
  $('export').addEventListener('change', () => { const kind = $('export').value; $('export').value = ''; if (kind) export_as(kind); });
  $('share').addEventListener('click', async () => {
    remember();
    if (!navigator.clipboard) return say('The link is in the address bar.');  // there is none beyond this machine
    await navigator.clipboard.writeText(location.href);
    say('The link is copied.');
  });
  document.addEventListener('dragover', (event) => { event.preventDefault(); document.body.classList.add('dragging'); });
  document.addEventListener('dragleave', (event) => { if (!event.relatedTarget) document.body.classList.remove('dragging'); });
  document.addEventListener('drop', (event) => {
    event.preventDefault();
    document.body.classList.remove('dragging');
    open_file(event.dataTransfer.files[0]);
  });
}

// Throws ApiError where the server refuses this page.
async function begin() {
  if (matchMedia('(max-width: 800px)').matches) view.zoom(2);  // labels are legible, the map is scrolled
  const { maps } = await ask('maps');
  $('map').append(...maps.map((name) => new Option(name, name)));
  listen();
  try {
    await recall(new URLSearchParams(location.hash.slice(1)));
  } catch (error) {
    if (!(error instanceof ApiError)) throw error;
    await choose_map('grid');
    say(error.message, true);
  }
}

try {
  await begin();
} catch (error) {
  if (!(error instanceof ApiError)) throw error;
  say(error.message, true);
}
document.body.dataset.ready = 'yes';
