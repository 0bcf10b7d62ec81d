// The curves under the picture: of a joint, of the root, of the feet with what plants are told by.

import { Curves } from './curves.js';
import { choice, make } from './dom.js';

const kAxes = { X: '--axis-x', Y: '--axis-y', Z: '--axis-z' };
const kSides = [['Left', '--left'], ['Right', '--right']];
const kDashed = [6, 4];

export class BenchCurves {
  constructor(bench) {
    this.bench = bench;
    this.tab = 'joint';
    this.title = make('span', { className: 'title' });
    this.canvas = make('canvas', { id: 'bench-canvas', role: 'img', tabIndex: 0 });
    this.tabs = choice('Curves', [['joint', 'Joint'], ['feet', 'Feet'], ['root', 'Root']], 'joint', (key) => this.choose(key));
    const whole = make('button', {
      type: 'button', textContent: 'Whole', title: 'All of its time (double click)', on: { click: () => this.fit() },
    });
    this.element = make('section', { id: 'bench-curves', className: 'panel', aria: { label: 'Curves' } },
      make('header', {}, this.tabs, this.title, whole), this.canvas);
    const { player } = bench.viewer;
    this.curves = new Curves(this.canvas, {
      seek: (time) => {
        player.playing = false;
        player.seek(time);
      },
    });
  }

  choose(key) {
    this.tab = key;
    this.draw();
  }

  fit() {
    this.curves.fit(0, this.bench.viewer.take.duration);
  }

  update() {
    this.curves.setTime(this.bench.viewer.player.time);
  }

  // Another clip's curve over this one's time.
  second(curve, color) {
    const { companion } = this.bench;
    return { ...curve, label: '', color, dash: kDashed, alpha: 0.85, map: (time) => companion.timeOf(time) };
  }

  draw() {
    const { clip, companion } = this.bench;
    this.curves.panels = { joint: () => this.ofJoint(), feet: () => this.ofFeet(), root: () => this.ofRoot() }[this.tab]();
    const pair = companion.index >= 0 && this.tab !== 'feet' ? ` · dashed: ${companion.clip.name}` : '';
    const of = this.tab === 'joint' ? `${this.bench.jointName}, rotation in its parent` : this.tab === 'feet' ? 'Ankle and toe; below the dotted lines a foot may be planted; marks: lift, lift-off, strike, landing' : 'Pelvis over the floor';
    this.title.textContent = `${of}${pair}`;
    this.canvas.setAttribute('aria-label', `Curves of ${clip.name}: ${of}`);
    this.curves.draw();
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
    const { clip } = this.bench;
    if (!clip.json.feet) return [];
    const panel = (key, unit, digits, marks) => {
      const curves = [], limits = [];
      kSides.forEach(([side, color], i) => {
        for (const [point, dash, width] of [['ankle', null, 1.7], ['toe', [3, 2], 1.3]]) {
          const curve = clip.footCurve(i, point, key);
          curves.push({ ...curve, label: `${side} ${point}`, color, dash, width });
          if (typeof curve.limit === 'number') limits.push({ value: curve.limit, color });
        }
      });
      return { label: key, unit, digits, least: 0.02, curves, limits, marks, zero: key === 'speed' };
    };
    const marks = kSides.flatMap(([, color], i) => clip.events(i).map((event) => ({ ...event, color })));
    return [panel('height', 'm', 3, marks), panel('speed', 'm/s', 2, []), ...this.plantRows(clip)];
  }
}
