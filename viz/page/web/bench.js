// The workbench: clips to choose from, two of them together, the skeleton and its curves.

import { BenchCurves } from './bench_curves.js';
import { BenchList } from './bench_list.js';
import { BenchTree } from './bench_tree.js';
import { clipsOf } from './bench_data.js';
import { Companion } from './companion.js';
import { keyOf } from './controls.js';
import { choice, make } from './dom.js';
import { Ghosts } from './ghosts.js';

const kTraces = [0, 5, 10, 15, 30, 60];  // every so manieth frame; the thesis has 15

export class Bench {
  constructor(viewer) {
    this.viewer = viewer;
    this.clips = clipsOf(viewer.page);
    this.joint = 0;
    this.companion = new Companion(viewer, this.clips);
    this.ghosts = new Ghosts(viewer);
    document.body.classList.add('bench');
    this.build();
    this.listen();
    this.shown();
  }

  get clip() {
    return this.clips[this.viewer.index];
  }

  build() {
    this.list = new BenchList(this);
    this.tree = new BenchTree(this);
    this.curves = new BenchCurves(this);
    this.nav = choice('Panel', [['clips', 'Clips'], ['curves', 'Curves'], ['tree', 'Skeleton'], ['facts', 'Facts']],
      'curves', (key) => this.openPanel(key));
    this.nav.id = 'bench-nav';
    this.tools = make('div', { id: 'bench-tools' }, this.buildPair(), this.buildTrace());
    this.split = make('div', { id: 'bench-split', title: 'Drag: more or less of the curves', on: { pointerdown: (event) => this.onSplit(event) } });
    document.body.append(this.split, this.list.element, this.tree.element, this.curves.element, this.nav, this.tools);
    this.openPanel('curves');
    this.addKeys();
  }

  // To the page's own.
  addKeys() {
    const keys = [['N', 'P', 'the next clip, the one before'], ['F', 'filter clips'], ['I', 'walk on the spot'],
      ['T', 'trace: every n-th frame'], ['Esc', 'one clip only']];
    const list = document.querySelector('#keys dl');
    for (const row of keys) {
      const does = row.pop();
      list.append(make('dt', {}, ...row.map((key) => make('kbd', { textContent: key }))), make('dd', { textContent: does }));
    }
    list.append(make('dt', { textContent: 'Curves' }), make('dd', { textContent: 'drag: time; wheel or pinch: zoom; shift and wheel, or right button: move; double click: whole' }));
  }

  buildPair() {
    this.pairNames = make('div', { className: 'pair-names' });
    this.pair = make('div', { id: 'bench-pair', className: 'card', hidden: true },
      this.pairNames,
      choice('Where the second is', [['over', 'Overlaid'], ['beside', 'Side by side']], 'over',
        (key) => this.compare({ place: key })),
      choice('What is at one time', [['time', 'By time'], ['phase', 'By phase', 'The same moment of the gait']], 'time',
        (key) => this.compare({ sync: key })));
    this.pair.sync = this.pair.lastElementChild;
    return this.pair;
  }

  buildTrace() {
    this.still = make('button', {
      id: 'bench-still', type: 'button', textContent: 'In place', title: 'Walk on the spot (I)', aria: { pressed: 'false' },
      on: { click: () => this.walkOnTheSpot(this.still.getAttribute('aria-pressed') !== 'true') },
    });
    this.trace = make('select', { id: 'bench-trace', title: 'Show every n-th frame (T)', on: { change: () => this.drawTrace() } });
    for (const every of kTraces) this.trace.add(new Option(every ? `every ${ordinal(every)} frame` : 'no trace', every));
    const label = make('label', {}, make('span', { textContent: 'Trace' }), this.trace);
    return make('div', { className: 'card group', id: 'bench-trace-card' }, label, this.still);
  }

  listen() {
    const { viewer } = this;
    viewer.listeners.push(() => this.shown());
    const drawn = viewer.drawn;
    viewer.drawn = () => {
      drawn?.();
      this.curves.update();
    };
    viewer.followers.push((time) => this.companion.follow(time));
    new MutationObserver(() => this.curves.draw())
      .observe(document.documentElement, { attributeFilter: ['data-theme'] });
    document.addEventListener('keydown', (event) => this.onKey(event), true);
  }

  onKey(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || document.getElementById('keys').open) return;
    const typing = /^(INPUT|SELECT)$/.test(event.target.tagName) && event.target.type !== 'checkbox';
    const keys = {
      Escape: () => this.compare({ with: -1 }),
      n: () => this.list.step(1),
      p: () => this.list.step(-1),
      i: () => this.still.click(),
      t: () => { this.trace.selectedIndex = (this.trace.selectedIndex + 1) % kTraces.length; this.drawTrace(); },
      f: () => this.list.filter.focus(),
    };
    if (typing) {
      if (event.key === 'Escape') event.target.blur();
      event.stopPropagation();
      return;
    }
    const act = keys[keyOf(event)];
    if (!act) return;
    event.preventDefault();
    event.stopPropagation();
    act();
  }

  // Dragging the edge between picture and curves.
  onSplit(event) {
    const { split } = this;
    split.setPointerCapture(event.pointerId);
    split.onpointermove = (move) => {
      const share = 100 * (1 - move.clientY / innerHeight);
      document.documentElement.style.setProperty('--curves', `${Math.max(16, Math.min(75, share))}vh`);
    };
    split.onpointerup = split.onpointercancel = () => (split.onpointermove = null);
  }

  /** On a phone one panel is open at a time. */
  openPanel(key) {
    document.body.dataset.panel = key;
    if (key === 'tree' || key === 'facts') this.tree.open(key);
    this.curves?.draw();
  }

  show(index) {
    if (index === this.companion.index) this.compare({ with: -1 });
    const { playing } = this.viewer.player;
    this.viewer.show(index);
    if (playing) this.viewer.player.play();
  }

  // The viewer has turned to another clip.
  shown() {
    this.companion.align();
    this.list.mark(this.viewer.index, this.companion.index);
    this.tree.fill(this.clip, this.companion.clip);
    this.chooseJoint(this.sameJoint());
    this.curves.fit();
    this.drawTrace();
    this.showPair();
    this.frame();
  }

  // Of another skeleton the joint of the same name.
  sameJoint() {
    const { joints } = this.clip;
    const same = joints.findIndex((joint) => joint.name === this.jointName);
    if (same >= 0) return same;
    const leg = joints.findIndex((joint) => /left.*(leg|knee|shin|tibia|lowleg)/i.test(joint.name));
    return Math.max(0, leg);
  }

  chooseJoint(index) {
    this.joint = index;
    this.jointName = this.clip.joints[index].name;
    this.tree.mark(index);
    this.curves.draw();
  }

  /** @param change  { with: index or -1, place: 'over' | 'beside', sync: 'time' | 'phase' } */
  compare(change) {
    this.companion.set(change);
    this.list.mark(this.viewer.index, this.companion.index);
    this.showPair();
    this.tree.fillFacts(this.clip, this.companion.clip);
    this.curves.draw();
    this.drawTrace();
    this.viewer.posed = -1;
    if ('with' in change || 'place' in change) this.frame();
  }

  showPair() {
    const { companion } = this;
    this.pair.hidden = companion.index < 0;
    if (companion.index < 0) return;
    const phase = this.pair.sync.querySelector('[data-key=phase]');
    phase.disabled = !companion.hasPhase;
    if (!companion.hasPhase && companion.sync === 'phase') this.pair.sync.choose('time');
    this.pairNames.replaceChildren(
      make('span', { className: 'first', textContent: this.clip.name }),
      make('span', { className: 'second', textContent: companion.clip.name }),
      make('button', {
        type: 'button', className: 'icon', textContent: '×', title: 'One clip only (Esc)', aria: { label: 'One clip only' },
        on: { click: () => this.compare({ with: -1 }) },
      }));
  }

  walkOnTheSpot(on) {
    this.still.setAttribute('aria-pressed', String(on));
    this.companion.inPlace = on;
    this.companion.align();
    this.viewer.posed = -1;
    this.drawTrace();
    this.frame();
  }

  drawTrace() {
    const every = Number(this.trace.value);
    const shown = [{ take: this.viewer.take, actor: this.viewer.actor, clip: this.clip }];
    if (this.companion.index >= 0) shown.push(this.companion.asShown);
    this.ghosts.draw(every, shown, this.companion.inPlace);
    this.viewer.dirty = true;
  }

  frame() {
    const { cameras } = this.viewer;
    cameras.bounds.copy(this.companion.bounds());
    this.viewer.stage.setBounds(cameras.bounds);
    this.viewer.resize();
    cameras.frameAll();
    this.viewer.dirty = true;
  }
}

function ordinal(n) {
  return `${n}th`;
}
