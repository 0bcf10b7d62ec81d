import assert from 'node:assert/strict';
import test from 'node:test';
import { clipsOf } from '../../../../viz/page/web/bench_data.js';
import { madePage } from './made_page.mjs';
import { near } from './seeded.mjs';

const kFoot = { ankle: { height: [1, 2], speed: [3, 4], height_limit: 0.1, speed_limit: 0.4 } };

function clipOf(json = {}, page = {}) {
  const one = {
    file: 'a.bvh', frame_time: 0.01, every: 1, first_frame: 0, floor: 0, phase: [], root: {}, feet: [kFoot, kFoot], facts: [], warnings: [],
    joints: [{ name: 'hips', parent: -1, channels: { X: [0, 1], Z: [2, 3] } }], analysis: null, ...json,
  };
  return clipsOf(madePage({ takes: [{ name: 'a', frames: 51 }], bench: { clips: [one] }, ...page }))[0];
}

test('a thinned clip lasts as long as its file, and its curves with it', () => {
  for (const every of [1, 2, 5]) {
    const frames = 1 + 50 / every;
    const clip = clipOf({ every }, { takes: [{ name: 'a', frames }] });
    near(clip.duration, 0.5, 1e-12);
    near((frames - 1) * clip.channels(0)[0].step, 0.5, 1e-12);
  }
});

test('curves of the feet begin where the analysis does', () => {
  const clip = clipOf({ first_frame: 30, every: 3 });
  const curve = clip.footCurve(1, 'ankle', 'speed');
  near([curve.from, curve.step, curve.limit], [0.3, 0.01, 0.4], 1e-12);
  assert.deepEqual(curve.values, [3, 4]);
});

test('channels keep the names and the order of the file', () => {
  assert.deepEqual(clipOf().channels(0).map(({ label, values }) => [label, values]), [['X', [0, 1]], ['Z', [2, 3]]]);
});

test('plants and events are those of the foot that is asked for; events that nobody saw are left out', () => {
  const analysis = {
    class: { type: 'walk' }, gait: {},
    plants: [{ foot: 'left', strike: 1, lift_off: 2 }, { foot: 'right', strike: 1.5, lift_off: 2.5 }, { foot: 'left', strike: 3, lift_off: 4 }],
    events: [{ foot: 'right', lift: 0.5, lift_off: 0.6, strike: null, landing: 1.6 }],
  };
  const clip = clipOf({ analysis });
  assert.deepEqual(clip.plants(0), [[1, 2], [3, 4]]);
  assert.deepEqual(clip.plants(1), [[1.5, 2.5]]);
  assert.deepEqual(clip.events(0), []);
  assert.deepEqual(clip.events(1).map(({ kind, time }) => [kind, time]), [['lift', 0.5], ['lift_off', 0.6], ['landing', 1.6]]);
});

test('phases are told by times, not by frames', () => {
  assert.deepEqual(clipOf({ phase: [[10, 0], [30, 0.5]] }).phase.map(([time, phase]) => [+time.toFixed(9), phase]), [[0.1, 0], [0.3, 0.5]]);
});

test('of a clip in which nobody is found nothing is said, and nothing fails', () => {
  const clip = clipOf({ feet: null });
  assert.deepEqual([clip.type, clip.gait, clip.plants(0), clip.events(1), clip.rootCurve('speed'), clip.cycle], ['', {}, [], [], null, null]);
});

test('an array is looked up once', () => {
  let looked = 0;
  const page = madePage({ takes: [{ name: 'a', frames: 2 }], bench: { clips: [{ frame_time: 1, every: 1, first_frame: 0, phase: [], joints: [{ channels: { X: { o: 1 } } }] }] } });
  page.numbers = () => [++looked];
  const [clip] = clipsOf(page);
  assert.equal(clip.channels(0)[0].values, clip.channels(0)[0].values);
  assert.equal(looked, 1);
});

test('a cycle is drawn over its phase from 0 to 1', () => {
  const motion = { cycle: { points: 65 }, measures: { period: 1.1 } };
  const clip = clipOf({}, { bench: { clips: [{ frame_time: 0.01, every: 1, first_frame: 0, phase: [], joints: [] }], library: { motions: [motion] } } });
  const { from, step, values } = clip.cycleCurve(new Array(65).fill(0));
  near([from, from + (values.length - 1) * step], [0, 1], 1e-12);
  assert.equal(clip.period, 1.1);
});

test('a transition is one by the take that plays it', () => {
  const join = { take: 0, cluster: 3 };
  const clip = clipOf({}, { bench: { clips: [{ frame_time: 0.01, every: 1, first_frame: 0, phase: [], joints: [], analysis: null }], graph: { joins: [{ take: 5 }, join] } } });
  assert.equal(clip.join, join);
  assert.equal(clip.type, 'transition');
});
