// The clips: what analysis says of each, sorted and filtered; one is shown, another beside it.

import { make } from './dom.js';

const number = (value, digits, unit) => (typeof value === 'number' ? `${value.toFixed(digits)}\u00a0${unit}` : '–');
const kBeside = '<svg viewBox="0 0 16 16" aria-hidden="true"><rect x="2" y="2" width="8" height="8" rx="2" class="line"/><rect x="6" y="6" width="8" height="8" rx="2" class="line"/></svg>';

/** What a clip can be sorted by: key, label, its value, its text. */
export const kColumns = [
  ['name', 'Name', (clip) => (clip.join ? '\uffff' : '') + clip.name.toLowerCase(), (clip) => clip.name],  // transitions last
  ['type', 'Type', (clip) => clip.type, (clip) => clip.type || 'nobody'],
  ['duration', 'Duration', (clip) => clip.duration, (clip) => number(clip.duration, 1, 's')],
  ['speed', 'Speed', (clip) => clip.gait.speed, (clip) => number(clip.gait.speed, 2, 'm/s')],
  ['turn', 'Turn rate', (clip) => clip.gait.turn_rate, (clip) => number(clip.gait.turn_rate, 0, '°/s')],
  ['cadence', 'Cadence', (clip) => clip.gait.cadence, (clip) => number(clip.gait.cadence, 0, '/min')],
  ['step', 'Step length', (clip) => clip.gait.step_length, (clip) => number(clip.gait.step_length, 2, 'm')],
  ['lift', 'Lift', (clip) => clip.gait.lift, (clip) => number(scaled(clip.gait.lift, 100), 1, 'cm')],
  ['support', 'Double support', (clip) => clip.gait.double_support, (clip) => number(scaled(clip.gait.double_support, 100), 0, '%')],
  ['skate', 'Toe skate', (clip) => clip.analysis?.quality?.toe_skate, (clip) => number(scaled(clip.analysis?.quality?.toe_skate, 1000), 0, 'mm/s')],
];

function scaled(value, by) {
  return typeof value === 'number' ? value * by : value;
}

/** What is told in short of a motion that is played as it was captured; undefined of others. */
function asCaptured({ kind, transition, turn }) {
  if (turn) return `${number(turn.angle, 0, '°')} in ${turn.steps} steps`;
  return transition && `${kind === 'stop' ? 'last' : 'first'} step ${number(transition.first_speed, 2, 'm/s')}, ${number(transition.acceleration, 2, 'm/s²')}`;
}

export class BenchList {
  constructor(bench) {
    this.bench = bench;
    this.clips = bench.clips;
    this.column = kColumns[0];
    this.falling = false;
    this.build(bench.viewer.page);
    this.items = this.clips.map((clip) => this.itemOf(clip));
    this.arrange();
  }

  build(page) {
    this.filter = make('input', {
      type: 'search', id: 'bench-filter', placeholder: 'Filter by name or type', aria: { label: 'Filter' },
      on: { input: () => this.arrange() },
    });
    this.sort = make('select', { id: 'bench-sort', title: 'Sort by', aria: { label: 'Sort by' }, on: { change: () => this.sortBy(this.sort.value) } });
    for (const [key, label] of this.columns()) this.sort.add(new Option(label, key));
    this.way = make('button', {
      type: 'button', id: 'bench-way', className: 'icon', textContent: '↑', title: 'Rising or falling', aria: { label: 'Rising or falling' },
      on: { click: () => this.reverse() },
    });
    this.rows = make('ul', { id: 'bench-rows', role: 'list' });
    this.count = make('span', { id: 'bench-count' });
    const notes = make('div', { className: 'notes' }, ...page.notes.map((note) => make('p', { textContent: note })));
    this.element = make('aside', { id: 'bench-clips', className: 'panel', aria: { label: 'Clips' } },
      make('header', {}, make('h1', { textContent: page.title }), this.count),
      make('div', { className: 'bench-tools' }, this.filter, this.sort, this.way),
      this.rows, ...this.others(page.bench.library), notes);
  }

  // Motions of a library that cannot be played: how walks begin and end and who turns about, where the captures are not there.
  others(library) {
    return (library?.motions ?? []).slice(this.clips.length).map((motion) => make('p', {
      className: 'no-clip', title: `${motion.source.clip}, frames ${motion.source.frames.join(' to ')}. ${motion.source.credit}`,
    }, make('b', { textContent: motion.name }), ` ${asCaptured(motion)}`));
  }

  columns() {
    return kColumns.filter(([, , value]) => this.clips.some((clip) => value(clip) !== undefined));
  }

  itemOf(clip) {
    const show = make('button', {
      type: 'button', className: 'clip', on: { click: () => this.bench.show(clip.index) },
    }, make('b', { textContent: clip.name, title: clip.json.file }),
    make('small', {}, make('span', { className: `type ${clip.type}`, textContent: clip.type || 'nobody' }), this.summaryOf(clip)),
    make('small', { className: 'sorted' }));
    const beside = make('button', {
      type: 'button', className: 'icon beside', innerHTML: kBeside, title: 'Compare with the clip that is shown',
      aria: { label: `Compare with ${clip.name}`, pressed: 'false' },
      on: { click: () => this.bench.compare({ with: this.bench.companion.index === clip.index ? -1 : clip.index }) },
    });
    return { clip, beside, show, element: make('li', { className: clip.join ? 'join' : '' }, show, beside), sorted: show.lastElementChild };
  }

  summaryOf(clip) {
    if (clip.join) return `${number(1000 * clip.join.error, 0, 'mm')} · root ${clip.join.glide.toFixed(2)}`;
    const captured = clip.motion && asCaptured(clip.motion);
    const parts = clip.motion && !captured ? [] : [number(clip.duration, 1, 's')];
    if (typeof clip.gait.speed === 'number') parts.push(number(clip.gait.speed, 2, 'm/s'));
    if (clip.motion?.turning) parts.push(`${clip.gait.turn_rate.toFixed(0)}°/s`);
    if (typeof clip.gait.step_length === 'number') parts.push(`step\u00a0${number(clip.gait.step_length, 2, 'm')}`);
    if (captured) parts.push(captured);
    else if (clip.motion && !clip.cycle) parts.push(clip.motion.chains.join(', ').replaceAll('_', ' ') || 'the whole body');
    return parts.join(' · ');
  }

  sortBy(key) {
    this.column = kColumns.find(([one]) => one === key);
    this.sort.value = key;
    this.arrange();
  }

  reverse() {
    this.falling = !this.falling;
    this.way.textContent = this.falling ? '↓' : '↑';
    this.arrange();
  }

  /** The clips that match, in order: what a value is missing of comes last. */
  arrange() {
    const wanted = this.filter.value.trim().toLowerCase().split(/\s+/);
    const [key, , valueOf, textOf] = this.column;
    const shown = this.items.filter(({ clip }) =>
      wanted.every((word) => `${clip.name} ${clip.type}`.toLowerCase().includes(word)));
    const missing = (value) => value === undefined || value === null;
    shown.sort((a, b) => {
      const [x, y] = [valueOf(a.clip), valueOf(b.clip)];
      if (missing(x) || missing(y)) return missing(x) - missing(y) || a.clip.index - b.clip.index;
      const order = x < y ? -1 : x > y ? 1 : a.clip.index - b.clip.index;
      return this.falling ? -order : order;
    });
    for (const { clip, sorted } of shown) sorted.textContent = /name|type|duration|speed|^step/.test(key) ? '' : `${this.column[1]} ${textOf(clip)}`;
    this.order = shown.map(({ clip }) => clip.index);
    this.rows.replaceChildren(...shown.map(({ element }) => element));
    this.count.textContent = shown.length === this.clips.length ? '' : `${shown.length} of ${this.clips.length}`;
  }

  /** To the next clip of the list, or the one before. */
  step(by) {
    if (this.order.length === 0) return;
    const at = this.order.indexOf(this.bench.viewer.index);
    const next = this.order[(Math.max(0, at) + by + this.order.length) % this.order.length];
    this.bench.show(next);
    this.items[next].element.scrollIntoView({ block: 'nearest' });
  }

  mark(first, second) {
    for (const { clip, element, show, beside } of this.items) {
      element.classList.toggle('first', clip.index === first);
      element.classList.toggle('second', clip.index === second);
      show.setAttribute('aria-current', String(clip.index === first));
      beside.setAttribute('aria-pressed', String(clip.index === second));
      beside.disabled = clip.index === first;
    }
  }
}
