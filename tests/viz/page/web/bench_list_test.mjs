import assert from 'node:assert/strict';
import test from 'node:test';
import './fake_dom.mjs';
import { seeded } from './seeded.mjs';

const { BenchList, kColumns } = await import('../../../../viz/page/web/bench_list.js');
const { BenchTree } = await import('../../../../viz/page/web/bench_tree.js');

function clipOf(index, { name = `clip-${index}.bvh`, type = 'walk', gait = {}, analysis = { class: { type }, gait }, ...more } = {}) {
  return {
    index, name, type, duration: 3, gait, analysis, join: null, motion: null, cycle: null,
    joints: [{ name: 'Hips', parent: -1 }, { name: 'LeftUpLeg', parent: 0 }, { name: 'LeftLeg', parent: 1 }, { name: 'RightUpLeg', parent: 0 }],
    json: { file: name, facts: [['joints', '4']], warnings: [] }, ...more,
  };
}

function benchOf(clips, bench = {}) {
  const shown = [];
  return {
    clips, joint: 0, shown, viewer: { index: 0, page: { title: 'clips', notes: ['a note'], bench } },
    companion: { index: -1 }, show: (index) => shown.push(index), compare() {}, chooseJoint(index) { this.joint = index; },
  };
}

const speeds = (values, more = {}) => values.map((speed, i) => clipOf(i, { gait: { speed }, ...more }));
const namesOf = (list) => list.rows.children.map((row) => row.querySelector('B').textContent);

test('sorted by any column, values rise or fall, and clips without one come last either way', () => {
  const random = seeded(28);
  const clips = Array.from({ length: 40 }, (_, i) => {
    const value = () => [undefined, null, random(), Math.floor(3 * random())][Math.floor(4 * random())];
    return clipOf(i, {
      type: ['walk', 'run', 'jump'][i % 3], duration: 1 + Math.floor(5 * random()),
      gait: { speed: value(), turn_rate: value(), cadence: value(), step_length: value(), lift: value(), double_support: value() },
    });
  });
  const list = new BenchList(benchOf(clips));
  for (const [key, , valueOf] of kColumns) {
    for (const falling of [false, true]) {
      list.sortBy(key);
      if (list.falling !== falling) list.reverse();
      const values = list.order.map((index) => valueOf(clips[index]) ?? null);
      const present = values.filter((value) => value !== null);
      assert.deepEqual(values.slice(0, present.length), present, `${key}: what has none is last`);
      for (let i = 1; i < present.length; ++i)
        assert.ok(falling ? present[i - 1] >= present[i] : present[i - 1] <= present[i], `${key} ${falling}`);
      assert.deepEqual([...list.order].sort((a, b) => a - b), clips.map(({ index }) => index));
    }
    list.reverse();
  }
});

test('a filter leaves the clips that hold each of its words, in name or type, in any case', () => {
  const clips = ['Walk_Slow.bvh', 'walk_fast.bvh', 'Run_slow.bvh'].map((name, i) => clipOf(i, { name, type: i < 2 ? 'walk' : 'run' }));
  const list = new BenchList(benchOf(clips));
  const left = (text) => {
    list.filter.value = text;
    list.filter.send('input');
    return [...list.order].sort((a, b) => a - b);
  };
  assert.deepEqual(left('slow'), [0, 2]);
  assert.deepEqual(left('WALK  slow'), [0]);
  assert.deepEqual(left(' run'), [2]);
  assert.deepEqual(left('swim'), []);
  assert.equal(list.count.textContent, '0 of 3');
  assert.deepEqual(left('.*'), []);  // no pattern: as it is written
  assert.deepEqual(left('  '), [0, 1, 2]);
  assert.equal(list.count.textContent, '');
});

test('only columns that some clip has a value for can be sorted by', () => {
  const list = new BenchList(benchOf(speeds([1, 2])));
  const keys = list.columns().map(([key]) => key);
  assert.ok(keys.includes('speed') && keys.includes('name'));
  for (const key of ['turn', 'lift', 'skate']) assert.ok(!keys.includes(key), key);
});

test('the next clip is the next of the list as it is sorted, round and round', () => {
  const bench = benchOf(speeds([3, 1, 2]));
  const list = new BenchList(bench);
  list.sortBy('speed');
  for (const by of [1, -1]) {
    bench.shown.length = 0;
    for (let i = 0; i < 6; ++i) {
      list.step(by);
      bench.viewer.index = bench.shown.at(-1);
    }
    assert.deepEqual(bench.shown, by > 0 ? [1, 2, 0, 1, 2, 0] : [2, 1, 0, 2, 1, 0]);
  }
  list.filter.value = 'none';
  list.arrange();
  list.step(1);  // nowhere to go
  assert.equal(bench.shown.length, 6);
});

test('names stand in the list as they are, whatever is in them', () => {
  const name = '<img src=x onerror=alert(1)> "&\u2028.bvh';
  const list = new BenchList(benchOf([clipOf(0, { name })]));
  assert.deepEqual(namesOf(list), [name]);
});

test('values that are not there are a dash, no word of the program', () => {
  const clip = clipOf(0, { type: '', gait: { speed: null }, analysis: null });
  const list = new BenchList(benchOf([clip, clipOf(1, { gait: { speed: 1.234 } })]));
  for (const [, , , text] of kColumns) assert.ok(!/null|undefined|NaN/.test(text(clip)), text(clip));
  assert.ok(!/null|undefined|NaN/.test(list.rows.textContent), list.rows.textContent);
  const [, , , speed] = kColumns.find(([key]) => key === 'speed');
  assert.deepEqual([clip, { gait: { speed: 1.234 } }].map(speed), ['–', '1.23\u00a0m/s']);
});

test('units are those that are read: centimetres of lift, per cent of support, millimetres of skate', () => {
  const clip = clipOf(0, { gait: { lift: 0.123, double_support: 0.25 }, analysis: { quality: { toe_skate: 0.0321 } } });
  const said = (key) => kColumns.find(([one]) => one === key)[3](clip);
  assert.deepEqual(['lift', 'support', 'skate'].map(said), ['12.3\u00a0cm', '25\u00a0%', '32\u00a0mm/s']);
});

test('one clip is marked as shown and one as beside it, which cannot be itself', () => {
  const list = new BenchList(benchOf(speeds([1, 2, 3])));
  list.mark(1, 2);
  assert.deepEqual(list.items.map(({ show }) => show.getAttribute('aria-current')), ['false', 'true', 'false']);
  assert.deepEqual(list.items.map(({ beside }) => beside.getAttribute('aria-pressed')), ['false', 'false', 'true']);
  assert.deepEqual(list.items.map(({ beside }) => beside.disabled), [false, true, false]);
});

test('transitions of a graph come behind its clips by name', () => {
  const clips = [clipOf(0, { name: 'b' }), clipOf(1, { name: 'a to b', join: { error: 0.1, glide: 0.02 } }), clipOf(2, { name: 'c' })];
  assert.deepEqual(namesOf(new BenchList(benchOf(clips))), ['b', 'c', 'a to b']);
});

test('a joint stands one deeper in the tree than the one that it hangs on, and by its side\'s colour', () => {
  const clip = clipOf(0);
  const tree = new BenchTree(benchOf([clip]));
  tree.fill(clip);
  assert.deepEqual(tree.items.map((item) => Number(item.getAttribute('aria-level'))), [1, 2, 3, 2]);
  assert.deepEqual(tree.items.map(({ className }) => className), ['', 'left', 'left', 'right']);
});

test('sides are told by names of rigs, and by no word that only begins so', () => {
  const sides = {
    left: ['LeftHand', 'l_hip', 'lThigh', 'hip.L', 'hip_l', 'mixamorig:LeftFoot', 'Bip01 L Thigh', 'L_Knee'],
    right: ['RightHand', 'r_hip', 'rShin', 'hip.R', 'hand-r', 'Bip01 R Foot', 'R_Knee', 'rtibia', 'rfemur'],
    '': ['Hips', 'LowerBack', 'Root', 'Spine1', 'lower_back', 'root', 'head', 'Collar'],
  };
  sides.left.push('ltibia', 'lfemur');
  for (const [side, names] of Object.entries(sides)) {
    const clip = clipOf(0, { joints: names.map((name) => ({ name, parent: -1 })) });
    const tree = new BenchTree(benchOf([clip]));
    tree.fill(clip);
    tree.items.forEach((item, i) => assert.equal(item.className, side, names[i]));
  }
});

test('arrows go through the joints, round and round, and keep the page from scrolling', () => {
  const bench = benchOf([clipOf(0)]);
  const tree = new BenchTree(bench);
  tree.fill(bench.clips[0]);
  const seen = [];
  for (const key of ['ArrowDown', 'ArrowDown', 'ArrowUp', 'ArrowUp', 'ArrowUp', 'ArrowDown']) {
    assert.ok(tree.rows.send('keydown', { key }).defaultPrevented);
    seen.push(bench.joint);
  }
  assert.deepEqual(seen, [1, 2, 1, 0, 3, 0]);
  assert.ok(!tree.rows.send('keydown', { key: 'x' }).defaultPrevented);
});

test('what is said of two clips stands in one row a measure', () => {
  const clips = speeds([1, 2]);
  const tree = new BenchTree(benchOf(clips));
  tree.fill(clips[0], clips[1]);
  const rows = tree.facts.all.filter(({ tagName }) => tagName === 'TR');
  assert.ok(rows.length >= 3);
  for (const row of rows) assert.equal(row.children.length, 3);
  const speed = rows.find(({ dataset }) => dataset.key === 'speed');
  assert.deepEqual(speed.children.map((cell) => cell.textContent), ['Speed', '1.00\u00a0m/s', '2.00\u00a0m/s']);
});
