// A cluster graph as a drawing: clips as rows of sequences, in the colours of the feet that stand;
// clusters where their frames lie among all poses; what is alike of both, and transitions.

import { penOf } from './dom.js';

const kNames = 0.3;      // of the rows' width, at most
const kTop = 4, kRow = 20, kBar = 13, kGap = 16;  // [CSS pixels]
const kNear = 6;         // of a click to a line [CSS pixels]
const kPieces = 24;      // of a transition's curve
const kAlpha = { L: 1, R: 1, LB: 0.62, RB: 0.62, LN: 0.3, RN: 0.3, N: 1 };

const colorOf = (state) => (state[0] === 'L' ? '--left' : state[0] === 'R' ? '--right' : '--muted');

export class BenchGraph {
  constructor(bench, graph) {
    this.bench = bench;
    this.graph = graph;
    this.cluster = -1;
    this.over = null;  // what the pointer is over
    this.scrolled = 0;
    const numbers = (ref) => bench.viewer.page.numbers(ref);
    this.places = graph.places.map(numbers);
    this.firsts = [];
    let first = 0;
    for (const clip of graph.clips) {
      this.firsts.push(first);
      first += clip.frames;
    }
    this.longest = Math.max(...graph.clips.map((clip) => clip.frames));
    this.extent = this.places.map((values) => extentOf(values));
  }

  /** The transition of a take; undefined of a clip. */
  joinOf(index) {
    return this.graph.joins.find((join) => join.take === index);
  }

  /** Where the body is: [{ clip, frame }, ...], two while both clips are mixed. */
  get now() {
    const { viewer } = this.bench;
    const at = viewer.player.time / this.graph.frame_time;
    const join = this.joinOf(viewer.index);
    if (!join) return [{ clip: viewer.index, frame: Math.min(at, this.graph.clips[viewer.index].frames - 1) }];
    const [first, last] = join.blend, places = [];
    if (at <= last) places.push({ clip: join.leave.clip, frame: Math.min(join.leave.frame + at - join.meeting, this.graph.clips[join.leave.clip].frames - 1) });
    if (at >= first) places.push({ clip: join.enter.clip, frame: Math.max(0, join.enter.frame + at - join.meeting) });
    return places;
  }

  get title() {
    const { graph } = this;
    const place = this.cluster;
    if (place < 0) return `${graph.clusters.length} clusters at error ${graph.error} m; blue: on the left foot, orange: on the right, pale: both or none`;
    const { state, frames, sequences, spread, next } = graph.clusters[place];
    return `Cluster ${place}, ${state}: ${frames} frame${frames === 1 ? '' : 's'} in ${sequences.length} sequence${sequences.length === 1 ? '' : 's'}, ${(1000 * spread).toFixed(0)} mm about their mean; clips go on to ${next.join(', ') || 'none'}`;
  }

  draw(canvas) {
    const pen = penOf(canvas);
    if (!pen) return;
    const { c, width, height } = pen;
    const style = getComputedStyle(canvas);
    this.c = c;
    this.color = (name) => style.getPropertyValue(name).trim();
    this.lines = [];
    const side = Math.min(height, Math.round(0.42 * width));
    this.drawRows(0, width - side - kGap, height);
    this.drawClusters(width - side, side, height);
  }

  // Rows.

  xOf(frame) {
    return this.labels + (frame / this.longest) * (this.wide - this.labels);
  }

  yOf(clip) {
    return kTop + clip * kRow - this.scrolled;
  }

  drawRows(left, wide, height) {
    const { c, graph } = this;
    this.wide = wide;
    const names = graph.clips.map(({ name }) => c.measureText(name).width);
    this.labels = Math.min(Math.max(...names) + 12, kNames * wide);
    this.scrolled = Math.max(0, Math.min(this.scrolled, graph.clips.length * kRow + 2 * kTop - height));
    c.save();
    c.beginPath();
    c.rect(left, 0, wide, height);
    c.clip();
    graph.clips.forEach((clip, i) => this.drawLabel(clip, i));
    graph.sequences.forEach((sequence) => this.drawSequence(sequence));
    graph.joins.forEach((join, i) => this.drawJoin(join, i));
    for (const { clip, frame } of this.now) {
      c.fillStyle = this.color('--text');
      c.fillRect(this.xOf(frame + 0.5) - 0.75, this.yOf(clip) - 2, 1.5, kBar + 4);
    }
    c.restore();
  }

  drawLabel(clip, i) {
    const { c } = this;
    c.fillStyle = this.color(i === this.bench.viewer.index ? '--text' : '--muted');
    let text = clip.name;
    while (text.length > 3 && c.measureText(`${text}…`).width > this.labels - 10) text = text.slice(0, -1);
    c.fillText(text === clip.name ? text : `${text}…`, 0, this.yOf(i) + kBar / 2);
  }

  drawSequence({ clip, cluster, first, last, alignment }) {
    const { c, graph } = this;
    const y = this.yOf(clip);
    if (y < -kRow || y > this.c.canvas.clientHeight) return;
    const x = this.xOf(first), wide = this.xOf(last + 1) - x, { state, sequences } = graph.clusters[cluster];
    const chosen = cluster === this.cluster;
    c.globalAlpha = kAlpha[state] * (this.cluster < 0 || chosen ? 1 : 0.35);
    c.fillStyle = this.color(colorOf(state));
    c.fillRect(x + 0.5, y, Math.max(1, wide - 1), kBar);
    c.globalAlpha = 1;
    if (sequences.length > 1) {  // a place to leave
      c.fillStyle = this.color('--panel');
      c.fillRect(this.xOf(alignment + 0.5) - 1, y + kBar - 4, 2, 4);
    }
    if (!chosen) return;
    c.strokeStyle = this.color('--text');
    c.lineWidth = 1.5;
    c.strokeRect(x, y - 1.5, Math.max(2, wide), kBar + 3);
    c.lineWidth = 1;
  }

  // From where one clip is left to where the other is entered.
  drawJoin(join, i) {
    const { c } = this;
    const shown = this.bench.viewer.index === join.take, over = this.over === i;
    if (this.cluster >= 0 && join.cluster !== this.cluster && !shown && !over) return;
    const from = [this.xOf(join.leave.frame + 0.5), this.yOf(join.leave.clip) + kBar / 2];
    const to = [this.xOf(join.enter.frame + 0.5), this.yOf(join.enter.clip) + kBar / 2];
    const bow = join.leave.clip === join.enter.clip ? [(from[0] + to[0]) / 2, from[1] + kRow] : [(from[0] + to[0]) / 2 + 18, (from[1] + to[1]) / 2];
    const points = curveOf(from, bow, to);
    this.lines.push({ points, join: i });
    c.strokeStyle = c.fillStyle = this.color(shown ? '--accent' : '--second');
    c.globalAlpha = shown || over ? 1 : this.cluster < 0 ? 0.35 : 0.85;
    c.lineWidth = shown || over ? 2.5 : 1.2;
    this.drawLine(points);
    c.globalAlpha = 1;
    c.lineWidth = 1;
  }

  drawLine(points) {
    const { c } = this;
    c.beginPath();
    for (const [x, y] of points) c.lineTo(x, y);
    c.stroke();
    const [x, y] = points.at(-1), [bx, by] = points.at(-3);
    this.drawHead(x, y, Math.atan2(y - by, x - bx), 5);
  }

  drawHead(x, y, way, size) {
    const { c } = this;
    c.beginPath();
    c.moveTo(x, y);
    c.lineTo(x - size * Math.cos(way - 0.5), y - size * Math.sin(way - 0.5));
    c.lineTo(x - size * Math.cos(way + 0.5), y - size * Math.sin(way + 0.5));
    c.closePath();
    c.fill();
  }

  // Clusters.

  placeOf(x, y) {
    const { left, top, across } = this.box;
    const [[lowX, highX], [lowY, highY]] = this.extent;
    const size = Math.max(highX - lowX, highY - lowY) || 1;
    return [left + across * (0.5 + (x - (lowX + highX) / 2) / size), top + across * (0.5 - (y - (lowY + highY) / 2) / size)];
  }

  placeOfFrame({ clip, frame }) {
    const at = this.firsts[clip] + Math.round(frame);
    return this.placeOf(this.places[0][at], this.places[1][at]);
  }

  drawClusters(left, side, height) {
    const { c, graph } = this;
    const margin = 16, across = side - 2 * margin;
    this.box = { left: left + margin, top: (height - side) / 2 + margin, across };
    c.fillStyle = this.color('--track');
    c.globalAlpha = 0.5;
    c.fillRect(left, 0, side, height);
    c.globalAlpha = 1;
    this.nodes = graph.clusters.map((cluster) => ({ at: this.placeOf(...cluster.at), size: Math.min(13, 2.2 + Math.sqrt(cluster.frames)) }));
    graph.clusters.forEach((cluster, i) => cluster.next.forEach((next) => this.drawEdge(i, next)));
    graph.clusters.forEach((cluster, i) => this.drawCluster(cluster, i));
    for (const place of this.now) {
      const [x, y] = this.placeOfFrame(place);
      c.fillStyle = this.color('--text');
      c.beginPath();
      c.arc(x, y, 4, 0, 2 * Math.PI);
      c.fill();
    }
  }

  // A clip goes on from the one to the other.
  drawEdge(from, to) {
    const { c } = this;
    const chosen = from === this.cluster || to === this.cluster;
    const [a, b] = [this.nodes[from], this.nodes[to]];
    const way = Math.atan2(b.at[1] - a.at[1], b.at[0] - a.at[0]);
    const end = [b.at[0] - b.size * Math.cos(way), b.at[1] - b.size * Math.sin(way)];
    c.strokeStyle = c.fillStyle = this.color(chosen ? '--text' : '--muted');
    c.globalAlpha = chosen ? 0.9 : this.cluster < 0 ? 0.35 : 0.14;
    c.beginPath();
    c.moveTo(...a.at);
    c.lineTo(...end);
    c.stroke();
    if (Math.hypot(end[0] - a.at[0], end[1] - a.at[1]) > 6) this.drawHead(...end, way, 4);
    c.globalAlpha = 1;
  }

  drawCluster({ state }, i) {
    const { c } = this;
    const { at, size } = this.nodes[i];
    c.beginPath();
    c.arc(...at, size, 0, 2 * Math.PI);
    c.fillStyle = this.color('--panel');
    c.fill();
    c.fillStyle = this.color(colorOf(state));
    c.globalAlpha = kAlpha[state] * (this.cluster < 0 || i === this.cluster ? 0.9 : 0.4);
    c.fill();
    c.globalAlpha = 1;
    if (i !== this.cluster) return;
    c.strokeStyle = this.color('--text');
    c.lineWidth = 2;
    c.stroke();
    c.lineWidth = 1;
  }

  // What is at a point of the drawing.

  find(x, y) {
    const node = this.nodes.findLastIndex(({ at, size }) => Math.hypot(at[0] - x, at[1] - y) <= Math.max(size, kNear));
    if (node >= 0) return { cluster: node };
    if (x > this.wide) return {};
    const clip = Math.floor((y + this.scrolled - kTop) / kRow);
    const frame = Math.floor(((x - this.labels) / (this.wide - this.labels)) * this.longest);
    const onBar = y - this.yOf(clip) <= kBar;
    const sequence = this.graph.sequences.find((one) => one.clip === clip && one.first <= frame && frame <= one.last);
    const line = this.lines.findLast(({ points }) => points.some(([px, py], i) => i > 1 && i < kPieces - 1 && Math.hypot(px - x, py - y) <= kNear));
    if (line && (!onBar || !sequence || this.cluster === this.graph.joins[line.join].cluster)) return { join: line.join };
    return onBar && sequence ? { cluster: sequence.cluster, clip, frame } : {};
  }

  onDown(event) {
    const found = this.find(event.offsetX, event.offsetY);
    if (found.join !== undefined) {
      this.play(found.join);
      return;
    }
    this.cluster = found.cluster ?? -1;
    const { viewer } = this.bench;
    if (found.clip !== undefined) {
      viewer.player.playing = false;
      if (viewer.index !== found.clip) this.bench.show(found.clip);
      viewer.player.seek(found.frame * this.graph.frame_time);
    }
    this.bench.curves.draw();
  }

  onMove(event) {
    const { join, cluster } = this.find(event.offsetX, event.offsetY);
    event.target.style.cursor = join !== undefined || cluster !== undefined ? 'pointer' : 'default';
    if (join === (this.over ?? undefined)) return;
    this.over = join ?? null;
    this.bench.curves.draw();
  }

  onWheel(event) {
    this.scrolled += event.deltaY;
    this.bench.curves.draw();
  }

  play(index) {
    const join = this.graph.joins[index];
    this.cluster = join.cluster;
    this.bench.show(join.take);
    this.bench.viewer.player.seek(0);
    this.bench.viewer.player.play();
  }
}

/** What a transition is: label and value. */
export function factsOfJoin(join, { clips, clusters }) {
  const named = ({ clip, frame }) => `${clips[clip].name}, frame ${Math.round(clips[clip].first_frame + frame * clips[clip].step)}`;
  const kCases = { before: 'as before', after: 'as after', within: 'as the nearer clip', slips: 'slips' };
  return [
    ['leaves', named(join.leave)], ['enters', named(join.enter)],
    ['cluster', `${join.cluster}, ${clusters[join.cluster].state}`],
    ['error', `${(1000 * join.error).toFixed(0)} mm`],
    ['root', `at most ${join.glide.toFixed(2)} of its sources' speed`],
    ...join.feet.map(({ foot, case: which, slip }) => [`${foot} foot`, `${kCases[which]}, ${(1000 * slip).toFixed(0)} mm`]),
    ['to be written', `amble graph play GRAPH '${join.play}' -o FILE.bvh`],
  ];
}

function extentOf(values) {
  let low = Infinity, high = -Infinity;
  for (const value of values) {
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  return [low, high];
}

function curveOf(from, bow, to) {
  return Array.from({ length: kPieces + 1 }, (_, i) => {
    const t = i / kPieces, s = 1 - t;
    return [0, 1].map((axis) => s * s * from[axis] + 2 * s * t * bow[axis] + t * t * to[axis]);
  });
}
