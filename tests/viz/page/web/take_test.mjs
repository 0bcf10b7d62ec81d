import assert from 'node:assert/strict';
import test from 'node:test';
import { Bone, Quaternion, Vector3 } from 'three';
import { Take } from '../../../../viz/page/web/take.js';
import { madePage, madeTake, rootOf, turnAbout } from './made_page.mjs';
import { near, numbersIn, seeded } from './seeded.mjs';

const takeOf = (more, page) => new Take(madePage(page), madeTake(more));
const bonesOf = (count) => Array.from({ length: count }, () => new Bone());

function posed(take, time) {
  const bones = bonesOf(take.joints);
  take.pose(bones, time);
  return bones;
}

// Unit quaternions of many frames, one after another.
function someTurns(random, count) {
  const turns = [];
  for (let i = 0; i < count; ++i) {
    const axis = new Vector3(...numbersIn(random, 3, -1, 1)).normalize();
    turns.push(...turnAbout(axis.toArray(), 2 * random()));
  }
  return Float32Array.from(turns);
}

test('at a frame the pose is that frame, to the last bit', () => {
  const random = seeded(5);
  const rotations = someTurns(random, 3 * 12), root = Float32Array.from(numbersIn(random, 36, -3, 3));
  const take = takeOf({ frames: 12, joints: 3, frameTime: 1 / 30, rotations, root });
  for (let frame = 0; frame < 12; ++frame) {
    const bones = posed(take, frame * take.frameTime);
    assert.deepEqual(bones[0].position.toArray(), [...root.subarray(3 * frame, 3 * frame + 3)]);
    bones.forEach((bone, joint) => {
      const at = 4 * (3 * frame + joint);
      assert.deepEqual(bone.quaternion.toArray(), [...rotations.subarray(at, at + 4)]);
    });
  }
});

test('between two frames a joint turns evenly about one axis, and the root goes straight', () => {
  const random = seeded(6);
  for (let round = 0; round < 50; ++round) {
    const axis = new Vector3(...numbersIn(random, 3, -1, 1)).normalize().toArray();
    const [from, by] = [random(), 2.5 * random()], share = random();
    const ends = numbersIn(random, 6, -3, 3);
    const rotations = Float32Array.from([...turnAbout(axis, from), ...turnAbout(axis, from + by)]);
    const [bone] = posed(takeOf({ frames: 2, joints: 1, frameTime: 1, rotations, root: Float32Array.from(ends) }), share);
    const turned = new Quaternion(...turnAbout(axis, from + share * by));
    near(bone.quaternion.angleTo(turned), 0, 2e-3);
    near(bone.position.toArray(), [0, 1, 2].map((i) => ends[i] + share * (ends[i + 3] - ends[i])), 1e-6);
  }
});

test('a quaternion and its negative are one pose: the shorter way is taken', () => {
  const a = turnAbout([0, 0, 1], 0.2), b = turnAbout([0, 0, 1], 0.6);
  const plain = takeOf({ frames: 2, joints: 1, frameTime: 1, rotations: Float32Array.from([...a, ...b]) });
  const other = takeOf({ frames: 2, joints: 1, frameTime: 1, rotations: Float32Array.from([...a, ...b.map((x) => -x)]) });
  for (const time of [0.25, 0.5, 0.75])
    near(posed(plain, time)[0].quaternion.angleTo(posed(other, time)[0].quaternion), 0, 1e-6);
});

test('before its beginning a take is its first frame, behind its end its last', () => {
  const take = takeOf({ frames: 5, root: rootOf(5, (i) => [i, 0, 1]) });
  assert.equal(posed(take, -1)[0].position.x, 0);
  assert.equal(posed(take, 99)[0].position.x, 4);
});

test('rotations in 16 bits are as those in 32, to what 16 bits can tell', () => {
  const random = seeded(7);
  const exact = someTurns(random, 24);
  const coarse = Int16Array.from(exact, (value) => Math.round(value * 32767));
  const [a, b] = [exact, coarse].map((rotations) => takeOf({ frames: 8, joints: 3, rotations }));
  for (let time = 0; time <= 0.7; time += 0.035) {
    const other = posed(b, time);
    posed(a, time).forEach((bone, joint) => near(bone.quaternion.toArray(), other[joint].quaternion.toArray(), 6e-5));
  }
});

test('joints with places of their own are put there, but the root is where the root is', () => {
  const random = seeded(8);
  const positions = Float32Array.from(numbersIn(random, 18, -1, 1)), root = rootOf(3, (i) => [10 * i, 0, 1]);
  const take = takeOf({ frames: 3, joints: 2, frameTime: 1, positions, root });
  const [first, second] = posed(take, 1.5);
  near(first.position.toArray(), [15, 0, 1], 1e-6);
  near(second.position.toArray(), [0, 1, 2].map((i) => (positions[9 + i] + positions[15 + i]) / 2), 1e-6);
});

test('headings turn the short way over the seam at half a turn', () => {
  const headings = Float32Array.from([3.0, -3.0, -2.6]);
  const take = takeOf({ frames: 3, frameTime: 1, headings });
  const short = 2 * Math.PI - 6;
  for (const share of [0, 0.25, 0.5, 0.75]) {
    const off = take.heading(share) - (3.0 + share * short);
    near(Math.atan2(Math.sin(off), Math.cos(off)), 0, 1e-6);
  }
  near(take.heading(2), -2.6, 1e-6);
  near(take.heading(9), -2.6, 1e-6);
  near(takeOf({ frames: 1, headings: Float32Array.of(1.5) }).heading(0.3), 1.5, 1e-6);
});

test('without headings a walker faces the way that he goes, turned as the walk is turned', () => {
  const way = (angle) => rootOf(61, (i) => {
    const [x, y] = [0.03 * i, 0.01 * Math.sin(i / 9)];
    return [x * Math.cos(angle) - y * Math.sin(angle), x * Math.sin(angle) + y * Math.cos(angle), 0.9];
  });
  const plain = takeOf({ frames: 61, frameTime: 1 / 30, root: way(0) });
  for (const angle of [0.4, 1.9, -2.8, Math.PI]) {
    const turned = takeOf({ frames: 61, frameTime: 1 / 30, root: way(angle) });
    for (let time = 0; time <= 2; time += 0.11) {
      const off = turned.heading(time) - plain.heading(time) - angle;
      near(Math.atan2(Math.sin(off), Math.cos(off)), 0, 1e-4);
    }
  }
});

test('the frame of a time is the nearest that there is', () => {
  const take = takeOf({ frames: 24, frameTime: 1 / 24 });
  const random = seeded(9);
  for (const time of numbersIn(random, 200, -0.5, 1.5)) {
    const away = (frame) => Math.abs(frame / 24 - time);
    const found = take.frameAt(time);
    for (let frame = 0; frame < 24; ++frame) assert.ok(away(found) <= away(frame) + 1e-9);
  }
});

test('sources of a frame fall from the largest, those of nothing are left out, names keep their colour', () => {
  const share = [[0.7, 0, 0.2], [0.1, 1, 0.5], [0.2, 0.004, 0.3]].map((values) => Float32Array.from(values));
  const take = takeOf({ frames: 3, sources: share.map((values, i) => ({ name: `motion ${i}`, share: values })) });
  assert.deepEqual(take.sourcesAt(0).map(({ index }) => index), [0, 2, 1]);
  assert.deepEqual(take.sourcesAt(1).map(({ name }) => name), ['motion 1']);
  for (const frame of [0, 1, 2])
    near(take.sourcesAt(frame).reduce((sum, one) => sum + one.share, 0), 1, 0.005);
});

test('the way of a root that none was drawn for lies under it on the floor', () => {
  const root = rootOf(4, (i) => [i, -i, 0.9 + 0.1 * i]);
  const { way } = takeOf({ frames: 4, root }, { floor: 0.25 });
  for (let i = 0; i < 4; ++i) assert.deepEqual([...way.subarray(3 * i, 3 * i + 3)], [i, -i, 0.25]);
});

test('a take lasts from its first frame to its last, or to where it fails', () => {
  near(takeOf({ frames: 31, frameTime: 1 / 30 }).duration, 1, 1e-12);
  near(takeOf({ frames: 31, frameTime: 1 / 30, stop: { frame: 7.5 } }).duration, 0.25, 1e-12);
  assert.equal(takeOf({ frames: 1 }).duration, 0);
});
