// Curves over time on a canvas: panels one below another, to be zoomed and scrubbed.
//
// A panel: { label, unit, curves: [{ values, from, step, color, dash, width, map }], limits:
// [{ value, color }], zero, marks: [{ at, color, kind }], height } or a row of bars { label, bars:
// [[from, to]], color, row: true }. `map` tells where of its own a curve is at a value of the axis.

import { penOf } from './dom.js';
const kLabels = 74, kEnd = 12, kAxis = 20, kRow = 11, kGap = 8, kLegend = 18;  // [CSS pixels]
const kLeast = 0.05;  // shortest part of the axis that is shown [s]

export class Curves {
  constructor(canvas, { seek, unit = 's' }) {
    this.canvas = canvas;
    this.seek = seek;
    this.unit = unit;
    this.panels = [];
    this.whole = [0, 1];
    this.range = [0, 1];
    this.at = 0;
    this.pointers = new Map();
    this.instead = null;  // draws something else on the canvas: { draw(canvas), onDown, onMove, onWheel }
    this.listen();
  }

  listen() {
    const { canvas } = this;
    canvas.addEventListener('wheel', (event) => this.onWheel(event), { passive: false });
    canvas.addEventListener('pointerdown', (event) => this.onDown(event));
    canvas.addEventListener('pointermove', (event) => this.onMove(event));
    for (const end of ['pointerup', 'pointercancel'])
      canvas.addEventListener(end, (event) => this.pointers.delete(event.pointerId));
    canvas.addEventListener('dblclick', () => this.fit(...this.whole));
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    new ResizeObserver(() => this.draw()).observe(canvas);
  }

  onWheel(event) {
    event.preventDefault();
    if (this.instead) return void this.instead.onWheel?.(event);
    if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
      this.pan(((event.deltaX || event.deltaY) * this.length) / 1000);
    } else {
      this.zoom(Math.exp(event.deltaY * 0.0015), this.axisAt(event.offsetX));
    }
  }

  onDown(event) {
    if (this.instead) return void this.instead.onDown?.(event);
    this.canvas.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, event.offsetX);
    this.panning = event.button === 2 || event.button === 1;
    if (this.pointers.size === 1 && !this.panning) this.seek(this.inside(this.axisAt(event.offsetX)));
  }

  onMove(event) {
    if (this.instead) return void this.instead.onMove?.(event);
    if (!this.pointers.has(event.pointerId)) return;
    const before = this.pointers.get(event.pointerId);
    const all = [...this.pointers.values()];
    if (this.pointers.size === 2) {
      const other = [...this.pointers].find(([id]) => id !== event.pointerId)[1];
      const [was, is] = [Math.abs(before - other), Math.abs(event.offsetX - other)];
      if (was > 8 && is > 8) this.zoom(was / is, this.axisAt(other));
    } else if (all.length === 1 && this.panning) {
      this.pan(((before - event.offsetX) * this.length) / this.span);
    } else if (all.length === 1) {
      this.seek(this.inside(this.axisAt(event.offsetX)));
    }
    this.pointers.set(event.pointerId, event.offsetX);
  }

  get span() {
    return Math.max(10, this.canvas.clientWidth - kLabels - kEnd);
  }

  get length() {
    return this.range[1] - this.range[0];
  }

  axisAt(x) {
    return this.range[0] + ((x - kLabels) / this.span) * this.length;
  }

  xOf(value) {
    return kLabels + ((value - this.range[0]) / this.length) * this.span;
  }

  inside(value) {
    return Math.max(this.whole[0], Math.min(this.whole[1], value));
  }

  fit(from, to) {
    this.whole = [from, Math.max(to, from + 1e-3)];
    this.range = [...this.whole];
    this.draw();
  }

  zoom(by, about) {
    const whole = this.whole[1] - this.whole[0];
    const length = Math.min(whole, Math.max(Math.min(kLeast, whole), this.length * by));
    const share = (about - this.range[0]) / this.length;
    this.setRange(about - share * length, length);
  }

  pan(by) {
    this.setRange(this.range[0] + by, this.length);
  }

  setRange(from, length) {
    const low = Math.max(this.whole[0], Math.min(this.whole[1] - length, from));
    this.range = [low, low + length];
    this.draw();
  }

  /** Moves the cursor; where it leaves what is shown, that follows. */
  setTime(at) {
    if (at === this.at && this.drawnAt === at) return;
    this.at = at;
    if (at < this.range[0] || at > this.range[1]) this.setRange(at - 0.1 * this.length, this.length);
    else this.draw();
  }

  draw() {
    if (this.instead) {
      this.instead.draw(this.canvas);
      this.drawnAt = this.at;
      return;
    }
    const { canvas } = this;
    const pen = penOf(canvas);
    if (!pen) return;
    const { c, width, height } = pen;
    this.style = getComputedStyle(canvas);
    const rows = this.panels.filter((panel) => panel.row).length;
    const plots = this.panels.length - rows;
    const free = height - kAxis - rows * (kRow + 4) - plots * (kGap + kLegend);
    let y = 2;
    this.drawAxis(c, height);
    for (const panel of this.panels) {
      const tall = panel.row ? kRow : Math.max(24, free / Math.max(1, plots));
      if (panel.row) this.drawBars(c, panel, y);
      else this.drawPanel(c, panel, y + kLegend, tall);
      y += tall + (panel.row ? 4 : kGap + kLegend);
    }
    this.drawCursor(c, height);
    this.drawnAt = this.at;
  }

  color(name) {
    return name.startsWith('--') ? this.style.getPropertyValue(name).trim() : name;
  }

  drawAxis(c, height) {
    c.textAlign = 'center';
    for (const [t, text] of ticksIn(...this.range, (this.length * 70) / this.span)) {
      const x = Math.round(this.xOf(t)) + 0.5;
      c.strokeStyle = this.color('--track');
      c.beginPath();
      c.moveTo(x, 0);
      c.lineTo(x, height - kAxis);
      c.stroke();
      c.fillStyle = this.color('--muted');
      c.fillText(`${text} ${this.unit}`.trim(), x, height - 9);
    }
    c.textAlign = 'left';
  }

  drawBars(c, panel, y) {
    c.fillStyle = this.color('--muted');
    c.fillText(panel.label, 0, y + kRow / 2, kLabels - 8);
    c.fillStyle = this.color('--track');
    c.fillRect(kLabels, y, this.span, kRow);
    c.save();
    clip(c, kLabels, y - 2, this.span, kRow + 4);
    c.fillStyle = this.color(panel.color);
    for (const [from, to] of panel.bars) {
      c.beginPath();
      c.roundRect(this.xOf(from), y, Math.max(2, this.xOf(to) - this.xOf(from)), kRow, 3);
      c.fill();
    }
    c.restore();
  }

  // Smallest and largest of what is shown.
  extentOf(panel) {
    let low = Infinity, high = -Infinity;
    for (const curve of panel.curves) {
      this.eachPoint(curve, (x, value) => {
        low = Math.min(low, value);
        high = Math.max(high, value);
      });
    }
    for (const { value } of panel.limits ?? []) {
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
    if (panel.zero) low = 0;
    if (!(high >= low)) return [0, 1];
    const least = panel.least ?? 1e-3;
    if (high - low < least) [low, high] = [(low + high - least) / 2, (low + high + least) / 2];
    const margin = 0.06 * (high - low);
    return [panel.zero ? low : low - margin, high + margin];
  }

  // A point a pixel or a sample, whichever are fewer.
  eachPoint(curve, act) {
    const { values, from, step, map } = curve;
    if (!map && step > this.length / this.span) {
      const first = Math.max(0, Math.floor((this.range[0] - from) / step));
      const last = Math.min(values.length - 1, Math.ceil((this.range[1] - from) / step));
      for (let i = first; i <= last; ++i) act(this.xOf(from + i * step), values[i]);
      return;
    }
    for (let x = 0; x <= this.span; ++x) {
      const axis = this.axisAt(kLabels + x);
      const value = valueAt(curve, map ? map(axis) : axis);
      if (value !== undefined) act(kLabels + x, value);
    }
  }

  drawPanel(c, panel, y, tall) {
    const [low, high] = this.extentOf(panel);
    const yOf = (value) => y + tall - ((value - low) / (high - low)) * tall;
    c.fillStyle = this.color('--track');
    c.globalAlpha = 0.5;
    c.fillRect(kLabels, y, this.span, tall);
    c.globalAlpha = 1;
    this.drawScale(c, panel, low, high, yOf, y, tall);
    c.save();
    clip(c, kLabels, y, this.span, tall);
    for (const mark of panel.marks ?? []) this.drawMark(c, mark, y, tall);
    for (const limit of panel.limits ?? []) this.drawLimit(c, limit, yOf);
    for (const curve of panel.curves) this.drawCurve(c, curve, yOf);
    c.restore();
    this.drawLegend(c, panel, y - kLegend);
  }

  drawScale(c, panel, low, high, yOf, y, tall) {
    c.textAlign = 'right';
    for (const [v, text] of ticksIn(low, high, ((high - low) * 17) / tall)) {
      const at = Math.round(yOf(v)) + 0.5;
      c.strokeStyle = this.color('--edge');
      c.beginPath();
      c.moveTo(kLabels, at);
      c.lineTo(kLabels + this.span, at);
      c.stroke();
      c.fillStyle = this.color('--muted');
      c.fillText(text, kLabels - 6, Math.max(y + 5, Math.min(y + tall - 5, at)));
    }
    c.textAlign = 'left';
    c.fillStyle = this.color('--text');
    c.save();
    c.translate(8, y + tall / 2);
    c.rotate(-Math.PI / 2);
    c.textAlign = 'center';
    c.fillText(panel.unit ? `${panel.label} [${panel.unit}]` : panel.label, 0, 0, Math.max(30, tall + 8));
    c.restore();
  }

  drawCurve(c, curve, yOf) {
    c.strokeStyle = this.color(curve.color);
    c.lineWidth = curve.width ?? 1.6;
    c.globalAlpha = curve.alpha ?? 1;
    c.setLineDash(curve.dash ?? []);
    c.lineJoin = 'round';
    c.beginPath();
    this.eachPoint(curve, (x, value) => c.lineTo(x, yOf(value)));
    c.stroke();
    c.setLineDash([]);
    c.lineWidth = 1;
    c.globalAlpha = 1;
  }

  drawLimit(c, { value, color }, yOf) {
    if (!Number.isFinite(value)) return;
    c.strokeStyle = this.color(color);
    c.setLineDash([2, 3]);
    c.beginPath();
    c.moveTo(kLabels, yOf(value));
    c.lineTo(kLabels + this.span, yOf(value));
    c.stroke();
    c.setLineDash([]);
  }

  drawMark(c, { time, color, kind }, y, tall) {
    const x = this.xOf(time), up = kind.startsWith('lift'), filled = kind === 'lift_off' || kind === 'strike';
    const top = y + (filled ? 3 : 14), size = 4;
    c.strokeStyle = c.fillStyle = this.color(color);
    c.globalAlpha = 0.5;
    c.beginPath();
    c.moveTo(x, top + 2 * size);
    c.lineTo(x, y + tall);
    c.stroke();
    c.globalAlpha = 1;
    c.beginPath();
    c.moveTo(x, up ? top : top + 2 * size);
    c.lineTo(x - size, up ? top + 2 * size : top);
    c.lineTo(x + size, up ? top + 2 * size : top);
    c.closePath();
    if (filled) c.fill();
    else c.stroke();
  }

  // Names of the curves, with their values at the cursor.
  drawLegend(c, panel, y) {
    let x = kLabels;
    for (const curve of panel.curves) {
      if (!curve.label) continue;
      const value = valueAt(curve, curve.map ? curve.map(this.at) : this.at);
      const text = value === undefined ? curve.label : `${curve.label} ${value.toFixed(panel.digits ?? 1)}`.trim();
      const wide = c.measureText(text).width;
      c.strokeStyle = this.color(curve.color);
      c.lineWidth = 2;
      c.setLineDash(curve.dash ? [3, 2] : []);
      c.beginPath();
      c.moveTo(x, y + 10);
      c.lineTo(x + 14, y + 10);
      c.stroke();
      c.setLineDash([]);
      c.lineWidth = 1;
      c.fillStyle = this.color('--text');
      c.fillText(text, x + 18, y + 11);
      x += Math.ceil(wide / 12) * 12 + 34;
    }
  }

  drawCursor(c, height) {
    const x = this.xOf(this.at);
    if (x < kLabels - 1 || x > kLabels + this.span + 1) return;
    c.fillStyle = this.color('--text');
    c.fillRect(x - 0.75, 0, 1.5, height - kAxis);
    c.beginPath();
    c.arc(x, 3, 4, 0, 2 * Math.PI);
    c.fill();
  }
}

/** Of a curve between its samples; undefined where it has none. */
export function valueAt({ values, from, step }, at) {
  const i = (at - from) / step;
  if (!(i > -0.5 && i < values.length - 0.5)) return undefined;
  const low = Math.max(0, Math.min(values.length - 1, Math.floor(i)));
  const high = Math.min(values.length - 1, low + 1);
  const share = Math.max(0, Math.min(1, i - low));
  return values[low] + share * (values[high] - values[low]);
}

// 1, 2 or 5 times a power of ten, not below `least`.
export function tickOf(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return power * [1, 2, 5, 10].find((n) => n * power >= least * (1 - 1e-9));
}

/** Multiples of a tick that is not below `least`: [value, text], with the digits that tell them apart. */
export function* ticksIn(low, high, least) {
  const every = tickOf(least), digits = Math.min(100, Math.max(0, -Math.floor(Math.log10(every) + 1e-9)));
  for (let i = Math.ceil(low / every - 1e-9); i * every <= high + 1e-9 * every; ++i) yield [i * every, `${+(i * every).toFixed(digits)}`];
}

function clip(c, x, y, width, height) {
  c.beginPath();
  c.rect(x, y, width, height);
  c.clip();
}
