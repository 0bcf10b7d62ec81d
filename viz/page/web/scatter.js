// Points and lines over two measures: the law of steps, speeds and turn rates.

import { ticksIn } from './curves.js';
import { penOf } from './dom.js';

const kLeft = 58, kBottom = 36, kTop = 12, kRight = 16;  // margins [CSS pixels]

/** Charts beside one another: { x: [label, unit], y: [label, unit], points: [{ x, y, name, chosen }],
 * line: { x: [...], y: [...] } } */
export function drawCharts(canvas, charts) {
  const pen = penOf(canvas);
  if (!pen) return;
  const { c, width, height } = pen;
  const style = getComputedStyle(canvas);
  const each = width / charts.length;
  charts.forEach((chart, i) => new Chart(c, style, chart, i * each, each, height).draw());
}

class Chart {
  constructor(c, style, chart, left, width, height) {
    Object.assign(this, { c, chart });
    this.color = (name) => style.getPropertyValue(name).trim();
    this.box = [left + kLeft, kTop, width - kLeft - kRight, height - kTop - kBottom];
    this.rangeX = extentOf([...chart.points.map((p) => p.x), ...(chart.line?.x ?? [])]);
    this.rangeY = extentOf([...chart.points.map((p) => p.y), ...(chart.line?.y ?? [])]);
  }

  x(value) {
    return this.box[0] + ((value - this.rangeX[0]) / (this.rangeX[1] - this.rangeX[0])) * this.box[2];
  }

  y(value) {
    return this.box[1] + this.box[3] * (1 - (value - this.rangeY[0]) / (this.rangeY[1] - this.rangeY[0]));
  }

  draw() {
    this.drawAxes();
    const { c, chart } = this;
    if (chart.line) {
      c.strokeStyle = this.color('--accent');
      c.lineWidth = 2;
      c.beginPath();
      for (let i = 0; i < chart.line.x.length; ++i) c.lineTo(this.x(chart.line.x[i]), this.y(chart.line.y[i]));
      c.stroke();
      c.lineWidth = 1;
    }
    const written = [];
    const inOrder = [...chart.points].sort((a, b) => Boolean(a.chosen) - Boolean(b.chosen));
    for (const point of inOrder) this.drawPoint(point, written);
  }

  drawAxes() {
    const { c, chart, box } = this;
    c.strokeStyle = this.color('--edge');
    c.fillStyle = this.color('--muted');
    c.textAlign = 'center';
    for (const [v, text] of ticks(this.rangeX, box[2] / 60)) {
      line(c, this.x(v), box[1], this.x(v), box[1] + box[3]);
      c.fillText(text, this.x(v), box[1] + box[3] + 10);
    }
    c.fillText(`${chart.x[0]} [${chart.x[1]}]`, box[0] + box[2] / 2, box[1] + box[3] + 26);
    c.textAlign = 'right';
    for (const [v, text] of ticks(this.rangeY, box[3] / 26)) {
      line(c, box[0], this.y(v), box[0] + box[2], this.y(v));
      c.fillText(text, box[0] - 6, this.y(v));
    }
    c.save();
    c.translate(box[0] - 46, box[1] + box[3] / 2);
    c.rotate(-Math.PI / 2);
    c.textAlign = 'center';
    c.fillText(`${chart.y[0]} [${chart.y[1]}]`, 0, 0, box[3]);
    c.restore();
    c.textAlign = 'left';
  }

  // Its name is written where no other is.
  drawPoint({ x, y, name, chosen }, written) {
    const { c, box } = this;
    const [px, py] = [this.x(x), this.y(y)];
    c.fillStyle = this.color(chosen ? '--right' : '--second');
    c.beginPath();
    c.arc(px, py, chosen ? 6 : 4.5, 0, 2 * Math.PI);
    c.fill();
    const wide = c.measureText(name).width;
    const left = px + 9 + wide > box[0] + box[2] ? px - 9 - wide : px + 9;
    const free = written.every(([wx, wy, ww]) => Math.abs(wy - py) > 11 || wx > left + wide || wx + ww < left);
    if (!free && !chosen) return;
    written.push([left, py, wide]);
    c.fillStyle = this.color(chosen ? '--text' : '--muted');
    c.fillText(name, left, py);
  }
}

function line(c, x1, y1, x2, y2) {
  c.beginPath();
  c.moveTo(x1, y1);
  c.lineTo(x2, y2);
  c.stroke();
}

function extentOf(values) {
  const low = Math.min(...values), high = Math.max(...values);
  const margin = 0.08 * (high - low || 1);
  return [low - margin, high + margin];
}

function ticks([low, high], count) {
  return ticksIn(low, high, (high - low) / Math.max(1, count));
}
