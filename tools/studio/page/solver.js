// The solvers beyond the exact search: the value of every pose where moves may slip, and learning curves.

import { ask } from './api.js';
import { element } from './map.js';

export const is_learner = (solver) => !['exact', 'pmax', 'mincost'].includes(solver);
const runs = 5;

export const percent = (p) => `${(100 * p).toFixed(p > 0.995 && p < 1 ? 2 : 1).replace(/\.0+$/, '')} %`;

export function in_words(solved) {
  const within = `${solved.sweeps} sweeps over ${solved.product.states} states`;
  if (solved.query === 'pmax')
    return `Value iteration: from the start the task succeeds with probability ${percent(solved.value)} (${within}).`;
  if (solved.value === 'inf') return 'Value iteration: no strategy reaches the goal almost surely.';
  return `Value iteration: from the start the task costs ${solved.value.toFixed(2)} actions in the mean (${within}).`;
}

// The poses of one state of the automaton, with values as shares of 1: 1 is best.
export function poses_of(solved, state) {
  const poses = solved.states.find((one) => one.state === state)?.poses ?? [];
  if (solved.query === 'pmax') return poses.map((pose) => ({ ...pose, share: pose.value, text: percent(pose.value) }));
  const most = Math.max(1, ...poses.map((pose) => pose.value ?? 0));
  return poses.map((pose) => ({
    ...pose, share: pose.value === null ? 0 : 1 - pose.value / most,
    text: pose.value === null ? 'never surely' : `${pose.value.toFixed(2)} actions` }));
}

const left = 46, right = 12, top = 14, bottom = 34, width = 560, height = 210;

// Curves of runs by steps, their mean, and the optimum above.
function draw_curves(box, answers) {
  const svg = element('svg', { viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': 'Learning curve' });
  const steps = answers[0].curve.at(-1).steps;
  const x = (step) => left + (width - left - right) * step / steps;
  const y = (score) => top + (height - top - bottom) * (1 - score);
  const text = (at, words, anchor = 'middle') => {
    element('text', { x: at[0], y: at[1], 'text-anchor': anchor }, svg).textContent = words;
  };
  for (const share of [0, 0.5, 1]) {
    element('path', { class: share === 1 ? 'best' : 'grid', d: `M${left} ${y(share)}H${width - right}` }, svg);
    text([left - 6, y(share) + 4], share === 1 ? 'best' : String(share), 'end');
  }
  for (const share of [0, 0.5, 1])
    text([x(steps * share), height - 14], String(Math.round(steps * share)), share === 1 ? 'end' : 'middle');
  text([(left + width) / 2 + 90, height - 2], 'steps taken in the map', 'middle');
  const line = (points, kind) =>
    element('path', { class: kind, d: `M${points.map((p) => `${x(p.steps)} ${y(p.score)}`).join('L')}` }, svg);
  for (const answer of answers) line(answer.curve, 'run');
  line(answers[0].curve.map((point, i) => ({
    steps: point.steps,
    score: answers.reduce((sum, answer) => sum + answer.curve[i].score, 0) / answers.length })), 'mean');
  box.replaceChildren(svg);
  box.hidden = false;
}

// One run after the other: the curve grows while they come in. say(text) is told how far it is.
export async function learn(request, box, current, say) {
  const answers = [];
  for (let seed = 1; seed <= runs; ++seed) {
    const steps = request.method.startsWith('dqn') ? 10_000 : 20_000;
    const answer = await ask('learn', { ...request, seed, steps });
    if (!current()) return;
    if (answer.curve.length === 0) return say('There is nothing to learn: no strategy succeeds, or the start does.');
    answers.push(answer);
    draw_curves(box, answers);
    const last = answers.reduce((sum, one) => sum + one.curve.at(-1).score, 0) / answers.length;
    say(`${request.method}: run ${seed} of ${runs}; in the end the policy comes to ${percent(last)} of the optimum` +
        ` (thin: each run, thick: their mean; the optimum succeeds with ${percent(answer.optimum.probability)}).`);
  }
}
