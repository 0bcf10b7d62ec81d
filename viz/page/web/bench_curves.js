// The curves under the picture: of a joint, of the root, of the feet with what plants are told by.

import { BenchGraph } from './bench_graph.js';
import { Curves } from './curves.js';
import { choice, make } from './dom.js';
import { drawCharts } from './scatter.js';

const kAxes = { X: '--axis-x', Y: '--axis-y', Z: '--axis-z' };
const kSides = [['Left', '--left'], ['Right', '--right']];
const kDashed = [6, 4];

export class BenchCurves {
  constructor(bench) {
    this.bench = bench;
    this.title = make('span', { className: 'title' });
    this.canvas = make('canvas', { id: 'bench-canvas', role: 'img', tabIndex: 0 });
    this.library = bench.viewer.page.bench.library ?? null;
    const { graph } = bench.viewer.page.bench;
    this.graph = graph ? new BenchGraph(bench, graph) : null;
    this.tab = graph ? 'graph' : 'joint';
    const tabs = [['joint', 'Joint'], this.library ? ['cycle', 'Cycle'] : ['feet', 'Feet'], ['root', 'Root']];
    if (this.library) tabs.push(['law', 'Speeds']);
    if (graph) tabs.unshift(['graph', 'Graph']);
    this.tabs = choice('Curves', tabs, this.tab, (key) => this.choose(key));
    const whole = make('button', {
      type: 'button', textContent: 'Whole', title: 'All of its time (double click)', on: { click: () => this.fit() },
    });
    this.element = make('section', { id: 'bench-curves', className: 'panel', aria: { label: 'Curves' } },
      make('header', {}, this.tabs, this.title, whole), this.canvas);
    const { player } = bench.viewer;
    this.curves = new Curves(this.canvas, {
      seek: (at) => {
        player.playing = false;
        player.seek(this.overPhase ? this.cycleStart + at * this.bench.clip.period : at);
      },
    });
  }

  /** The axis is the phase of the cycle; else time. */
  get overPhase() {
    return this.tab === 'cycle' && this.bench.clip.cycle !== null;
  }

  // Of the cycle that is played [s].
  get cycleStart() {
    const { time } = this.bench.viewer.player;
    const { period } = this.bench.clip;
    return Math.min(Math.floor(time / period + 1e-9), 1) * period;
  }

  choose(key) {
    this.tab = key;
    this.draw();
    this.fit();
  }

  fit() {
    this.curves.unit = this.overPhase ? '' : 's';
    this.curves.fit(0, this.overPhase ? 1 : this.bench.viewer.take.duration);
  }

  update() {
    const { time } = this.bench.viewer.player;
    this.curves.setTime(this.overPhase ? (time - this.cycleStart) / this.bench.clip.period : time);
  }

  // Another clip's curve over this one's time.
  second(curve, color) {
    const { companion } = this.bench;
    return { ...curve, label: '', color, dash: kDashed, alpha: 0.85, map: (time) => companion.timeOf(time) };
  }

  draw() {
    this.canvas.style.cursor = '';
    this.curves.instead = this.drawingOf(this.tab);
    if (!this.curves.instead) {
      this.curves.panels = {
        joint: () => this.ofJoint(), feet: () => this.ofFeet(), root: () => this.ofRoot(), cycle: () => this.ofCycle(),
      }[this.tab]();
    }
    const title = this.titleOf();
    this.title.textContent = this.title.title = title;
    this.canvas.setAttribute('aria-label', `Curves of ${this.bench.clip.name}: ${title}`);
    this.curves.draw();
  }

  // What is drawn in place of curves, if anything is.
  drawingOf(tab) {
    if (tab === 'law') return { draw: () => drawCharts(this.canvas, this.charts()) };
    return tab === 'graph' ? this.graph : null;
  }

  titleOf() {
    const { clip, companion, jointName } = this.bench;
    const pair = companion.index >= 0 && (this.tab === 'joint' || this.tab === 'root' || this.tab === 'feet') ? ` · dashed: ${companion.clip.name}` : '';
    switch (this.tab) {
      case 'joint': return `${jointName}, rotation in its parent${pair}`;
      case 'root': return `Pelvis over the floor${pair}`;
      case 'feet': return 'Ankle and toe; below the dotted lines a foot may be planted; marks: lift, lift-off, strike, landing' + pair;
      case 'graph': return this.graph.title;
      case 'law': return 'The law of steps through the captured walks; how fast they turn';
      default: return this.titleOfCycle(clip, jointName);
    }
  }

  titleOfCycle({ cycle, motion }, jointName) {
    if (!cycle) return `${motion.name} is no cycle`;
    const drawn = motion.lacking ?? (motion.measures.cycles === 1 ? 'thin: the captured cycle' : `thin: the ${motion.measures.cycles} captured cycles`);
    return `${jointName} over the phase, against the stance; thick: ${motion.measures.harmonics} harmonics; ${drawn}`;
  }

  plantRows(clip) {
    return kSides.map(([side, color], i) => ({ row: true, label: `${side} foot`, bars: clip.plants(i), color }));
  }

  rows() {
    const { clip } = this.bench;
    return clip.analysis ? this.plantRows(clip) : [];
  }

  ofJoint() {
    const { clip, companion, joint, jointName } = this.bench;
    const curves = clip.channels(joint).map((curve) => ({ ...curve, color: kAxes[curve.label] }));
    if (companion.index >= 0) {
      const same = companion.clip.joints.findIndex(({ name }) => name === jointName);
      if (same >= 0)
        for (const curve of companion.clip.channels(same)) curves.push(this.second(curve, kAxes[curve.label]));
    }
    return [{ label: 'angle', unit: '°', curves, least: 2, digits: 1 }, ...this.rows()];
  }

  ofCycle() {
    const { clip, joint } = this.bench;
    if (!clip.cycle) return [];
    const panel = (label, unit, channels, digits) => {
      const curves = [];
      for (const [i, [name, channel]] of Object.entries(channels).entries()) {
        const color = Object.values(kAxes)[i];
        for (const ref of channel.captured) curves.push({ ...clip.cycleCurve(ref), color, width: 0.9, alpha: 0.5 });
        curves.push({ ...clip.cycleCurve(channel.fourier), label: name, color, width: 2.2 });
      }
      return { label, unit, digits, curves, least: unit === 'm' ? 0.01 : 2 };
    };
    const panels = [panel('angle', '°', clip.cycle.joints[joint], 1)];
    if (joint === 0) {
      const { height, ...flat } = clip.cycle.root;
      panels.unshift(panel('off its line', 'm', flat, 3), panel('height', 'm', { height }, 3));
    }
    return [...panels, ...this.plantRows(clip).map((row) => ({ ...row, bars: row.bars.map((bar) => bar.map((time) => time / clip.period)) }))];
  }

  // Of the library's walks.
  charts() {
    const { step_law: law, motions } = this.library;
    const { name } = this.bench.clip;
    const charts = [];
    const numbers = (ref) => this.bench.viewer.page.numbers(ref);
    if (law) {
      charts.push({
        x: ['speed', 'm/s'], y: ['step length', 'm'], line: { x: numbers(law.speeds), y: numbers(law.steps) },
        points: law.points.map((point) => ({ x: point.speed, y: point.step, name: point.name, chosen: point.name === name })),
      });
    }
    const walks = motions.filter((motion) => motion.kind === 'walk');
    if (walks.length > 0) {
      charts.push({
        x: ['turn rate', '°/s'], y: ['speed', 'm/s'],
        points: walks.map((walk) => ({ x: walk.measures.turn_rate, y: walk.measures.speed, name: walk.name, chosen: walk.name === name })),
      });
    }
    return charts;
  }

  ofRoot() {
    const { clip, companion } = this.bench;
    const panel = (label, unit, key, digits, least) => {
      const curves = [];
      const own = clip.rootCurve(key);
      if (own) curves.push({ ...own, label: ' ', color: '--accent' });
      const other = companion.index >= 0 ? companion.clip.rootCurve(key) : null;
      if (other) curves.push(this.second(other, '--second'));
      return { label, unit, curves, digits, least };
    };
    return [
      { ...panel('speed', 'm/s', 'speed', 2, 0.2), zero: true }, panel('turn', '°/s', 'turn_rate', 0, 10),
      panel('height', 'm', 'height', 3, 0.05), ...this.rows(),
    ].filter((one) => one.row || one.curves.length > 0);
  }

  ofFeet() {
    const { clip, companion } = this.bench;
    if (!clip.json.feet) return [];
    const other = companion.index >= 0 && companion.clip.json.feet ? companion.clip : null;
    const panel = (key, unit, digits, marks) => {
      const curves = [], limits = [];
      kSides.forEach(([side, color], i) => {
        for (const [point, dash, width] of [['ankle', null, 1.7], ['toe', [3, 2], 1.3]]) {
          const curve = clip.footCurve(i, point, key);
          curves.push({ ...curve, label: `${side} ${point}`, color, dash, width });
          if (typeof curve.limit === 'number') limits.push({ value: curve.limit, color });
          if (other) curves.push({ ...this.second(other.footCurve(i, point, key), color), width: 1, alpha: 0.6 });
        }
      });
      return { label: key, unit, digits, least: 0.02, curves, limits, marks, zero: key === 'speed' };
    };
    const marks = kSides.flatMap(([, color], i) => clip.events(i).map((event) => ({ ...event, color })));
    const second = other ? this.plantRows(other).map((row) => ({ ...row, label: `${row.label} 2`, bars: companion.spansOver(row.bars) })) : [];
    return [panel('height', 'm', 3, marks), panel('speed', 'm/s', 2, []), ...this.plantRows(clip), ...second];
  }
}
