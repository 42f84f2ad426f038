// The map on the page: the server's drawing, and above it poses to click, routes and the agent.

const svg_ns = 'http://www.w3.org/2000/svg';

export function element(name, attributes = {}, parent = null) {
  const made = document.createElementNS(svg_ns, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (parent) parent.append(made);
  return made;
}

// Drawings of the server are parsed as XML: nothing in them runs.
export function drawing(text) {
  return document.importNode(new DOMParser().parseFromString(text, 'image/svg+xml').documentElement, true);
}

const directions = { 0: [0, -1], 90: [1, 0], 180: [0, 1], 270: [-1, 0] };
export const same = (a, b) => a[0] === b[0] && a[1] === b[1] && a[2] === b[2];

export class MapView {
  // take(node): a place was clicked
  constructor(paper, take) {
    this.paper = paper;
    this.take = take;
  }

  show(map) {
    this.map = map;
    this.nodes = new Map(map.nodes.map((node) => [`${node.x},${node.y}`, node]));
    const sheet = document.createElement('div');
    sheet.className = 'sheet';
    this.over = element('svg', { viewBox: `0 0 ${map.width} ${map.height}` });
    for (const node of map.nodes) {
      const place = element('circle', { class: 'node', cx: node.at[0], cy: node.at[1], r: 34 }, this.over);
      place.dataset.at = `${node.x},${node.y}`;
      place.addEventListener('click', () => this.take(node));
    }
    this.values = element('g', { id: 'values' }, this.over);
    this.routes = element('g', { class: 'above' }, this.over);
    this.marks = element('g', { class: 'above' }, this.over);
    this.agent = element('g', { class: 'above agent', id: 'agent' }, this.over);
    element('path', { d: 'M0 -17 L12 12 L0 6 L-12 12 Z' }, this.agent);
    sheet.append(drawing(map.svg), this.over);
    this.paper.replaceChildren(sheet);
    this.zoom(1);
  }

  node(x, y) { return this.nodes.get(`${x},${y}`); }

  // The pose after an action, null at a wall.
  after([x, y, heading], action) {
    if (action === 'LEFT') return [x, y, (heading + 270) % 360];
    if (action === 'RIGHT') return [x, y, (heading + 90) % 360];
    if (!this.node(x, y).ways.includes(heading)) return null;
    const [dx, dy] = directions[heading];
    return [x + dx, y + dy, heading];
  }

  // The poses of a shortest way to a place, without the first.
  way(from, node) {
    const before = new Map([[from.join(), null]]);
    const queue = [from];
    for (const pose of queue) {
      if (pose[0] === node.x && pose[1] === node.y) {
        const poses = [];
        for (let at = pose; at; at = before.get(at.join())) poses.unshift(at);
        return poses.slice(1);
      }
      for (const action of ['FORWARD', 'LEFT', 'RIGHT']) {
        const to = this.after(pose, action);
        if (!to || before.has(to.join())) continue;
        before.set(to.join(), pose);
        queue.push(to);
      }
    }
    return [];
  }

  // To the right of the hallway's middle: there and back can be told apart.
  point([x, y, heading], aside = 10) {
    const [cx, cy] = this.node(x, y).at;
    const [dx, dy] = directions[heading];
    return [cx - dy * aside, cy + dx * aside];
  }

  line(poses, kind, aside = 10) {
    if (poses.length < 2) return;
    const d = `M${poses.map((pose) => this.point(pose, aside).join(' ')).join(' L')}`;
    if (!kind.includes('done')) element('path', { class: 'casing', d }, this.routes);  // seen on any floor
    element('path', { class: `route ${kind}`, d }, this.routes);
  }

  // Returns the kinds of lines and marks that are drawn.
  // walk: {poses, cycle: actions that are repeated, other: poses of another reading, lost: index or null}
  draw(walk, step) {
    this.routes.replaceChildren();
    this.marks.replaceChildren();
    const { poses, cycle = 0, other = null, lost = null } = walk;
    const loop = poses.length - 1 - cycle;
    this.line(poses.slice(0, loop + 1), '');
    if (cycle) this.line(poses.slice(loop), 'cycle');
    const done = poses.slice(0, step + 1);
    this.line(done.slice(0, loop + 1), 'done');
    if (cycle && step > loop) this.line(done.slice(loop), 'done cycle');
    if (other) this.line(other, 'other', 19);
    this.mark(poses[0], 'first', 8);
    if (cycle) this.mark(poses[loop], 'turning', 8);
    if (lost !== null) this.mark(poses[lost], 'lost', 22);
    this.place(poses[step]);
    const kinds = { ahead: step < poses.length - 1, done: step > 0, cycle: cycle > 0, other, lost: lost !== null };
    return new Set(['first', ...Object.keys(kinds).filter((kind) => kinds[kind])].filter(() => poses.length > 1));
  }

  // Larger than the page, the map is scrolled.
  zoom(factor) {
    const sheet = this.paper.firstElementChild;
    this.scale = Math.max(1, Math.min(4, (this.scale ?? 1) * factor));
    if (!sheet) return;
    sheet.style.width = `${100 * this.scale}%`;
    sheet.classList.toggle('large', this.scale > 1);
  }

  mark(pose, kind, r) {
    const [cx, cy] = this.point(pose);
    element('circle', { class: kind, cx, cy, r }, this.marks);
  }

  // Behind the middle of the place, so that what stands there is seen.
  place(pose) {
    const [dx, dy] = directions[pose[2]];
    const [x, y] = this.point(pose, 15).map((at, i) => at - 24 * [dx, dy][i]);
    this.agent.style.transform = `translate(${x}px, ${y}px)`;
    const arrow = this.agent.firstChild;  // turns the short way round
    const turned = Number(arrow.dataset.turned ?? pose[2]);
    const turn = ((pose[2] - turned) % 360 + 540) % 360 - 180;
    arrow.dataset.turned = turned + turn;
    arrow.style.transform = `rotate(${turned + turn}deg)`;
    this.agent.dataset.pose = pose.join();
  }

  // What a strategy does in every pose, and how good that is: {pose, action, share of the best, text}.
  show_values(poses) {
    const glyphs = { FORWARD: '↑', LEFT: '↰', RIGHT: '↱' };
    this.values.replaceChildren();
    for (const { pose, action, share, text } of poses) {
      const node = this.node(pose[0], pose[1]);
      const [dx, dy] = directions[pose[2]];
      const group = element('g', { class: 'value', transform: `translate(${node.at[0] + dx * 25} ${node.at[1] + dy * 25})` },
                            this.values);
      element('circle', { r: 13, fill: shade(share) }, group);
      element('text', { transform: `rotate(${pose[2]})`, 'text-anchor': 'middle', 'dominant-baseline': 'central',
                        fill: share > 0.6 ? '#000' : '#fff' }, group).textContent = glyphs[action] ?? (share === 1 ? '★' : '·');
      element('title', {}, group).textContent = `(${pose.join(', ')}): ${text}${action ? `, ${action}` : ''}`;
      group.addEventListener('click', () => this.take(node));
    }
  }
}

// From dark blue over green to yellow, as light as it is good.
function shade(share) {
  const stops = [[68, 1, 84], [33, 145, 140], [253, 231, 37]];
  const at = Math.max(0, Math.min(1, share)) * 2, i = Math.min(1, Math.floor(at));
  return `rgb(${stops[i].map((from, k) => Math.round(from + (stops[i + 1][k] - from) * (at - i))).join()})`;
}
