// The time line: bars where a foot stands, ticks at gait events, what is nearest, captured motions.

import { kSourceColors } from './colors.js';

const kRow = 13, kGap = 4, kLabels = 74;  // [CSS pixels]
const kSecond = 46;  // what a time written below it takes [CSS pixels]

function styleOf(element, name) {
  return getComputedStyle(element).getPropertyValue(name).trim();
}

export class Timeline {
  constructor(element, player) {
    this.element = element;
    this.player = player;
    this.canvas = element.querySelector('canvas');
    this.head = element.querySelector('.playhead');
    this.shown = -1;
    element.addEventListener('pointerdown', (event) => {
      element.setPointerCapture(event.pointerId);
      this.held = true;
      this.seekTo(event);
    });
    element.addEventListener('pointermove', (event) => this.held && this.seekTo(event));
    for (const end of ['pointerup', 'pointercancel']) {
      element.addEventListener(end, () => (this.held = false));
    }
  }

  seekTo(event) {
    const box = this.element.getBoundingClientRect();
    const share = (event.clientX - box.left - kLabels) / (box.width - kLabels - 8);
    this.player.playing = false;
    this.player.seek(Math.max(0, Math.min(1, share)) * this.player.duration);
  }

  rows() {
    const take = this.player.take;
    const rows = [];
    const sides = [['Left foot', '--left'], ['Right foot', '--right']];
    sides.forEach(([label, color], side) => {
      if (take.planted[side].length === 0) return;
      const events = take.events.filter((event) => event.side === side);
      rows.push({ label, draw: (c, x, y) => this.drawSpans(c, x, y, take.planted[side], events, color) });
    });
    if (take.clearance) {
      rows.push({ label: 'Clearance', draw: (c, x, y) => this.drawClearance(c, x, y, take) });
    }
    if (take.sources.length > 0) {
      rows.push({ label: 'Motions', draw: (c, x, y) => this.drawSources(c, x, y, take) });
    }
    return rows;
  }

  /** Draws all but the play head. */
  draw() {
    const rows = this.rows();
    const height = rows.length * (kRow + kGap) + 18;
    const width = this.element.clientWidth;
    const ratio = Math.min(devicePixelRatio, 2);
    this.element.style.height = `${height}px`;
    this.canvas.width = width * ratio;
    this.canvas.height = height * ratio;
    const c = this.canvas.getContext('2d');
    c.scale(ratio, ratio);
    c.font = '11px system-ui, sans-serif';
    c.textBaseline = 'middle';
    const span = width - kLabels - 8;
    const last = this.player.duration / this.player.take.frameTime;  // shorter than the take where it fails
    const x = (frame) => kLabels + (span * Math.min(frame, last)) / Math.max(1e-6, last);
    rows.forEach((row, i) => {
      const y = i * (kRow + kGap);
      c.fillStyle = styleOf(this.element, '--muted');
      c.fillText(shortened(c, row.label, kLabels - 10), 0, y + kRow / 2);
      c.fillStyle = styleOf(this.element, '--track');
      c.beginPath();
      c.roundRect(kLabels, y, span, kRow, 3);
      c.fill();
      row.draw(c, x, y);
    });
    this.drawSeconds(c, x, height - 9);
    this.shown = -1;
    this.update();
  }

  drawSpans(c, x, y, spans, events, color) {
    c.fillStyle = styleOf(this.element, color);
    for (const [first, last] of spans) {
      if (x(last) <= x(first) && first > 0) continue;
      c.beginPath();
      c.roundRect(x(first), y, Math.max(2, x(last) - x(first)), kRow, 3);
      c.fill();
    }
    c.fillStyle = styleOf(this.element, '--text');
    for (const event of events) c.fillRect(x(event.frame) - 0.5, y - 1, 1, kRow + 2);
  }

  drawClearance(c, x, y, take) {
    const most = 0.5;  // [m]
    c.fillStyle = styleOf(this.element, '--accent');
    c.beginPath();
    c.moveTo(x(0), y + kRow);
    take.clearance.distance.forEach((d, i) => {
      const share = d < 0 ? 1 : Math.min(1, d / most);
      c.lineTo(x(i), y + kRow * (1 - share));
    });
    c.lineTo(x(take.frames - 1), y + kRow);
    c.fill();
  }

  // Captured motions over one another, as high as they have a share in the frame.
  drawSources(c, x, y, take) {
    const below = new Float32Array(take.frames);
    c.save();
    c.beginPath();
    c.roundRect(x(0), y, x(take.frames - 1) - x(0), kRow, 3);
    c.clip();
    take.sources.forEach((source, index) => {
      c.fillStyle = kSourceColors[index % kSourceColors.length];
      c.beginPath();
      for (let i = 0; i < take.frames; ++i) c.lineTo(x(i), y + kRow * (1 - below[i]));
      for (let i = take.frames - 1; i >= 0; --i) {
        below[i] += source.share[i];
        c.lineTo(x(i), y + kRow * (1 - below[i]));
      }
      c.fill();
    });
    c.restore();
  }

  drawSeconds(c, x, y) {
    const duration = this.player.duration;
    const most = (x(this.player.take.frames - 1) - x(0)) / kSecond;
    const every = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 60, 120, 300].find((s) => duration / s < most) ?? 600;
    c.fillStyle = styleOf(this.element, '--muted');
    c.textAlign = 'center';
    for (let i = 0; i * every <= duration + 1e-9; ++i) {
      c.fillText(`${+(i * every).toFixed(1)} s`, x((i * every) / this.player.take.frameTime), y);
    }
    c.textAlign = 'left';
  }

  /** Moves the play head. */
  update() {
    const { time, duration } = this.player;
    if (time === this.shown) return;
    this.shown = time;
    const span = this.element.clientWidth - kLabels - 8;
    const share = duration > 0 ? time / duration : 0;
    this.head.style.transform = `translateX(${kLabels + share * span}px)`;
  }
}

function shortened(c, text, width) {
  if (c.measureText(text).width <= width) return text;
  let end = text.length;
  while (end > 1 && c.measureText(`${text.slice(0, end)}…`).width > width) --end;
  return `${text.slice(0, end)}…`;
}
