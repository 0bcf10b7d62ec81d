// The skeleton as a tree, of which a joint is chosen; and what analysis says in words.

import { factsOfJoin } from './bench_graph.js';
import { kColumns } from './bench_list.js';
import { choice, make } from './dom.js';

export class BenchTree {
  constructor(bench) {
    this.bench = bench;
    this.rows = make('ul', { id: 'bench-joints', role: 'tree', tabIndex: 0, aria: { label: 'Skeleton' }, on: { keydown: (event) => this.onKey(event) } });
    this.facts = make('div', { id: 'bench-facts', hidden: true });
    this.tabs = choice('What is said', [['tree', 'Skeleton'], ['facts', 'Facts']], 'tree', (key) => this.open(key));
    this.element = make('aside', { id: 'bench-tree', className: 'panel', aria: { label: 'Skeleton and facts' } },
      this.tabs, this.rows, this.facts);
  }

  open(key) {
    this.rows.hidden = key !== 'tree';
    this.facts.hidden = key !== 'facts';
    for (const button of this.tabs.children)
      button.setAttribute('aria-pressed', String(button.dataset.key === key));
  }

  fill(clip, second) {
    const depths = [];
    this.items = clip.joints.map((joint, index) => {
      depths.push(joint.parent < 0 ? 0 : depths[joint.parent] + 1);
      const item = make('li', {
        role: 'treeitem', textContent: joint.name, id: `bench-joint-${index}`, className: sideOf(joint.name),
        aria: { level: String(depths[index] + 1), selected: 'false' },
        on: { click: () => this.bench.chooseJoint(index) },
      });
      item.style.setProperty('--depth', depths[index]);
      return item;
    });
    this.rows.replaceChildren(...this.items);
    this.fillFacts(clip, second);
  }

  /** @param second  the clip beside it, if there is one */
  fillFacts(clip, second) {
    const list = make('dl');
    for (const [label, value] of factsOf(clip)) {
      list.append(make('dt', { textContent: label }), make('dd', { textContent: value }));
    }
    const warnings = clip.json.warnings.map((text) => make('p', { className: 'warning', textContent: text }));
    this.facts.replaceChildren(this.tableOf([clip, second].filter(Boolean)), ...warnings, list);
  }

  tableOf(clips) {
    const rows = kColumns.filter(([key, , value]) => key !== 'name' && clips.some((clip) => value(clip) !== undefined && value(clip) !== ''))
      .map(([key, label, , text]) => make('tr', { data: { key } },
        make('th', { scope: 'row', textContent: label }),
        ...clips.map((clip) => make('td', { textContent: text(clip) }))));
    const names = clips.map((clip) => make('p', { className: 'name', textContent: clip.name, title: clip.name }));
    return make('div', {}, ...names, make('table', {}, ...rows));
  }

  mark(index) {
    this.items.forEach((item, i) => item.setAttribute('aria-selected', String(i === index)));
    this.rows.setAttribute('aria-activedescendant', `bench-joint-${index}`);
    const { rows } = this, item = this.items[index];
    if (item.offsetTop < rows.scrollTop || item.offsetTop > rows.scrollTop + rows.clientHeight - 24)
      rows.scrollTop = item.offsetTop - rows.clientHeight / 2;
  }

  onKey(event) {
    const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (!by) return;
    event.preventDefault();
    event.stopPropagation();
    this.bench.chooseJoint((this.bench.joint + by + this.items.length) % this.items.length);
  }
}

// Label and value: of a capture what `amble analyse` says, of a library's motion what it holds.
function factsOf({ json, motion, join, page }) {
  if (join) return factsOfJoin(join, page.bench.graph);
  if (!motion) return [['file', json.file], ...json.facts];
  const { source, measures: m } = motion;
  const facts = [
    ['kind', motion.turning ? `${motion.kind}, turning` : motion.kind],
    ['moves', motion.chains.join(', ').replaceAll('_', ' ') || 'all joints'],
    ['valid', motion.valid],
  ];
  if (m) {
    facts.push(
      ['period', `${m.period.toFixed(3)} s, mean of ${m.cycles} captured cycle${m.cycles === 1 ? '' : 's'}`],
      ['step', `${m.step_length.toFixed(3)} m long, ${m.step_width.toFixed(3)} m wide`],
      ['feet turned', `left ${m.toe_out[0].toFixed(1)}°, right ${m.toe_out[1].toFixed(1)}° to the left`],
      ['series', `${m.harmonics} harmonics, which leave out ${m.residual.toFixed(2)}°`],
      ['closure', `${(1000 * m.closure).toFixed(1)} mm; feet slide ${(1000 * m.slide).toFixed(1)} mm, as they land ${m.slip.map((way) => (1000 * way).toFixed(0)).join(' and ')} mm`],
    );
  }
  if (motion.transition) facts.push(['played', 'as it was captured'], [motion.kind === 'stop' ? 'last step' : 'first step', `${motion.transition.first_speed.toFixed(2)} m/s, ${motion.transition.acceleration.toFixed(2)} m/s²`]);
  if (motion.turn) {
    const { angle, duration, steps, first, twist } = motion.turn;
    facts.push(['played', 'as it was captured'], ['turn', `${angle.toFixed(0)}° in ${duration.toFixed(2)} s and ${steps} steps, ${first} foot first`],
      ['feet', `turned by up to ${twist.toFixed(0)}° against the pelvis; made walks step more often`]);
  }
  if (motion.kind === 'movement') facts.push(['played', 'over the walk of the nearest speed']);
  const part = source.speed === undefined ? `frames ${source.frames.join(' to ')}` : `a speed engine, at ${source.speed} m/s`;
  facts.push(['captured', `${source.clip}, ${part}${source.mirrored ? ', mirrored' : ''}`]);
  if (motion.lacking) facts.push(['not shown', motion.lacking]);
  facts.push(['licence', source.licence], ['credit', source.credit]);
  return facts;
}

// As names of rigs tell: LeftHand, lThigh, hip.L, Bip01 L Foot; and of Acclaim's bones, which are written in one.
const kBones = '(clavicle|humerus|radius|wrist|hand|fingers|thumb|hipjoint|femur|tibia|foot|toes)$';

function sideOf(name) {
  for (const side of ['left', 'right']) {
    const [l, L] = [side[0], side[0].toUpperCase()];
    const letter = `^${l}[A-Z]|(^|[:._ -])[${l}${L}]([._ -]|$)|^${l}${kBones}`;
    if (new RegExp(side, 'i').test(name) || new RegExp(letter).test(name)) return side;
  }
  return '';
}
