import assert from 'node:assert/strict';
import test from 'node:test';
import { element } from './fake_dom.mjs';
import { near, numbersIn, seeded } from './seeded.mjs';

const { BenchGraph, factsOfJoin } = await import('../../../../viz/page/web/bench_graph.js');

const kStates = ['L', 'LB', 'R', 'RB', 'N'];

// Clips of some frames, cut into sequences of ten, each of the cluster of its place in turn.
function graphOf(random, counts = [60, 40, 80]) {
  const clips = counts.map((frames, i) => ({ name: `clip-${i}`, frames, first_frame: 5, step: 2 }));
  const sequences = clips.flatMap(({ frames }, clip) => Array.from({ length: frames / 10 }, (_, i) => ({
    clip, cluster: i % kStates.length, first: 10 * i, last: 10 * i + 9, alignment: 10 * i + 4,
  })));
  const all = counts.reduce((sum, one) => sum + one);
  const clusters = kStates.map((state, i) => ({
    state, frames: 40, spread: 0.05, at: [Math.cos(i), 2 + Math.sin(i)], next: [(i + 1) % kStates.length],
    sequences: sequences.flatMap((one, k) => (one.cluster === i ? [k] : [])),
  }));
  const joins = [{
    take: 3, cluster: 1, leave: { clip: 0, frame: 14 }, enter: { clip: 2, frame: 64 }, meeting: 14, blend: [10, 19], error: 0.0321, glide: 0.5,
    play: '0 0-14 2 64-79', feet: [{ foot: 'left', case: 'before', slip: 0.002 }, { foot: 'right', case: 'within', slip: 0.011 }],
  }];
  return { clips, sequences, clusters, joins, frame_time: 1 / 30, error: 0.2, places: [0, 1].map(() => numbersIn(random, all, -2, 5)) };
}

function shown(graph = graphOf(seeded(29)), size = [900, 300]) {
  const said = [];
  const player = { time: 0, playing: false, seek(time) { this.time = time; said.push(['seek', time]); }, play() { this.playing = true; } };
  const viewer = { index: 0, player, page: { numbers: (ref) => ref } };
  const bench = { viewer, curves: { draw: () => drawing.draw(canvas) }, show: (index) => { viewer.index = index; said.push(['show', index]); } };
  const canvas = element('canvas');
  [canvas.clientWidth, canvas.clientHeight] = size;
  const drawing = new BenchGraph(bench, graph);
  drawing.draw(canvas);
  return { drawing, canvas, viewer, said, pen: canvas.getContext(), press: (x, y) => drawing.onDown({ offsetX: x, offsetY: y }) };
}

test('every frame of every clip is found where it is drawn, with the cluster that it is in', () => {
  const { drawing } = shown();
  for (const { clip, cluster, first, last } of drawing.graph.sequences) {
    for (let frame = first; frame <= last; ++frame) {
      const found = drawing.find(drawing.xOf(frame + 0.5), drawing.yOf(clip) + 2);
      if (found.join === undefined) assert.deepEqual(found, { cluster, clip, frame });
    }
  }
});

test('every cluster is found where it is drawn, and drawn within its square', () => {
  const { drawing, canvas } = shown();
  drawing.nodes.forEach(({ at, size }, i) => {
    assert.deepEqual(drawing.find(...at), { cluster: i });
    assert.ok(at[0] - size > drawing.wide && at[0] + size <= canvas.clientWidth && at[1] - size >= 0 && at[1] + size <= canvas.clientHeight);
  });
});

test('places keep their proportions: one scale along both axes, what is up is up', () => {
  const { drawing } = shown();
  const [x0, y0] = drawing.placeOf(0, 0), [x1, y1] = drawing.placeOf(1, 1);
  near(x1 - x0, y0 - y1, 1e-9);
  assert.ok(x1 > x0);
});

test('a transition is found along its line, which goes from where one clip is left to where the other is entered', () => {
  const { drawing } = shown();
  const [{ points, join }] = drawing.lines, { leave, enter } = drawing.graph.joins[join];
  near(points[0], [drawing.xOf(leave.frame + 0.5), drawing.yOf(leave.clip) + 6.5], 1e-9);
  near(points.at(-1), [drawing.xOf(enter.frame + 0.5), drawing.yOf(enter.clip) + 6.5], 1e-9);
  drawing.cluster = drawing.graph.joins[join].cluster;
  for (const [x, y] of points.slice(3, -3)) assert.deepEqual(drawing.find(x, y), { join });
});

test('during a transition one is in the one clip, then in both, then in the other', () => {
  const { drawing, viewer } = shown();
  viewer.index = 3;
  const { leave, enter, meeting, blend } = drawing.graph.joins[0];
  for (let frame = 0; frame <= 29; ++frame) {
    viewer.player.time = (frame + 1e-9) / 30;
    const places = drawing.now;
    const expected = [...(frame < blend[1] ? [leave] : []), ...(frame >= blend[0] ? [enter] : [])];
    if (frame !== blend[1]) assert.deepEqual(places.map(({ clip }) => clip), expected.map(({ clip }) => clip), `${frame}`);
    for (const place of places) {
      const from = place.clip === leave.clip ? leave : enter;
      near(place.frame, Math.max(0, from.frame + frame - meeting), 1e-6);
    }
  }
});

test('of a clip one is at its frame, never behind its last', () => {
  const { drawing, viewer } = shown();
  viewer.index = 1;
  for (const [time, frame] of [[0, 0], [1, 30], [9, 39]]) {
    viewer.player.time = time;
    assert.equal(drawing.now.length, 1);
    near(drawing.now[0].frame, frame, 1e-9);
  }
});

test('a press on a frame shows it, a press on nothing chooses nothing', () => {
  const { drawing, viewer, said, press } = shown();
  viewer.player.playing = true;
  press(drawing.xOf(35.5), drawing.yOf(1) + 3);
  assert.deepEqual(said, [['show', 1], ['seek', 35 / 30]]);
  assert.ok(!viewer.player.playing);
  assert.equal(drawing.cluster, 3);
  press(drawing.wide + 5, 1);
  assert.equal(drawing.cluster, -1);
  assert.match(drawing.title, /^5 clusters/);
});

test('a transition is played from its beginning', () => {
  const { drawing, viewer, said } = shown();
  drawing.play(0);
  assert.deepEqual(said, [['show', 3], ['seek', 0]]);
  assert.ok(viewer.player.playing);
  assert.equal(drawing.cluster, 1);
});

test('more clips than there is room for are scrolled, from the first to the last and no further', () => {
  const { drawing } = shown(graphOf(seeded(30), new Array(40).fill(20)), [900, 200]);
  drawing.onWheel({ deltaY: 1e6 });
  near(drawing.yOf(39) + 20 + 4, 200, 1e-9);
  assert.equal(drawing.find(drawing.xOf(5.5), drawing.yOf(39) + 2).clip, 39);
  drawing.onWheel({ deltaY: -1e6 });
  assert.equal(drawing.yOf(0), 4);
});

test('long names are shortened, so that rows have room for clips', () => {
  const graph = graphOf(seeded(31));
  graph.clips[1].name = 'a'.repeat(300);
  const { drawing, pen } = shown(graph);
  assert.ok(drawing.labels <= 0.3 * drawing.wide + 1e-9);
  for (const text of pen.texts) assert.ok(6 * text.length <= drawing.labels, text);
  assert.ok(pen.texts.some((text) => /^a+…$/.test(text)));
});

test('what is said of a transition names frames of the files, in units that are read', () => {
  const { drawing } = shown();
  const facts = new Map(factsOfJoin(drawing.graph.joins[0], drawing.graph));
  assert.equal(facts.get('leaves'), 'clip-0, frame 33');
  assert.equal(facts.get('enters'), 'clip-2, frame 133');
  assert.equal(facts.get('error'), '32 mm');
  assert.equal(facts.get('left foot'), 'as before, 2 mm');
  assert.match(facts.get('to be written'), /^amble graph play GRAPH '0 0-14 2 64-79' -o FILE\.bvh$/);
});
