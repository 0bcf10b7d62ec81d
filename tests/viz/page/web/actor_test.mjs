import assert from 'node:assert/strict';
import test from 'node:test';
import { Quaternion, Vector3 } from 'three';
import { Actor } from '../../../../viz/page/web/actor.js';
import { Ghosts } from '../../../../viz/page/web/ghosts.js';
import { Take } from '../../../../viz/page/web/take.js';
import { madePage, madeTake, turnAbout } from './made_page.mjs';
import { near, numbersIn, seeded } from './seeded.mjs';

const kJoints = [
  { name: 'hips', parent: -1, offset: [0, 0, 0.9], tips: [] },
  { name: 'spine', parent: 0, offset: [0, 0, 0.3], tips: [] },
  { name: 'head', parent: 1, offset: [0.02, 0, 0.35], tips: [[0, 0, 0.2], [0.1, 0, 0.1]] },
  { name: 'leg', parent: 0, offset: [0, 0.1, -0.05], tips: [[0, 0, -0.8]] },
];
const kParts = [
  { name: 'trunk', joint: 0, from: [0, 0, 0.1], to: [0, 0.05, 0.5], radius: 0.15, side: -1 },
  { name: 'skull', joint: 2, from: [0, 0, 0.1], to: [0, 0, 0.1], radius: 0.1, side: -1 },
  { name: 'left sole', joint: 3, from: [-0.05, 0, -0.8], to: [0.13, 0, -0.8], radius: 0.04, side: 0 },
];

// A skin of four corners, each on one or two bones; the pose that it is in has bones of places and turns.
function figureOf(random) {
  const bind = kJoints.flatMap(() => [...numbersIn(random, 3, -1, 1), ...new Quaternion(...numbersIn(random, 4, -1, 1)).normalize().toArray()]);
  return {
    vertices: Float32Array.from(numbersIn(random, 12, -1, 1)), normals: Float32Array.of(0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1),
    colors: Uint8Array.of(255, 255, 255, 0, 0, 0, 128, 0, 0, 0, 188, 0), triangles: Uint32Array.of(0, 1, 2, 0, 2, 3),
    joints: Uint16Array.of(0, 0, 0, 0, 1, 2, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0),
    weights: Float32Array.of(1, 0, 0, 0, 0.25, 0.75, 0, 0, 1, 0, 0, 0, 0.5, 0.5, 0, 0), bind: Float32Array.from(bind),
  };
}

function actorOf(more = {}) {
  const actor = new Actor(madePage(), { name: 'walker', body: { joints: kJoints, parts: kParts, head: 1, ...more.body }, figure: more.figure ?? null });
  actor.show({ body: true, capsules: true, bones: true });
  return actor;
}

function someTake(random, frames = 20) {
  const rotations = Array.from({ length: frames * kJoints.length }, () =>
    turnAbout(new Vector3(...numbersIn(random, 3, -1, 1)).normalize().toArray(), random()));
  return new Take(madePage(), madeTake({ frames, joints: kJoints.length, rotations: Float32Array.from(rotations.flat()), root: Float32Array.from(numbersIn(random, 3 * frames, -2, 2)) }));
}

// Forward kinematics, joint by joint, from the take's numbers.
function placesAt(take, frame) {
  const places = [], turns = [];
  kJoints.forEach(({ parent, offset }, joint) => {
    const own = new Quaternion().fromArray(take.rotations, 4 * (frame * kJoints.length + joint));
    const at = parent < 0 ? new Vector3().fromArray(take.root, 3 * frame) : new Vector3(...offset).applyQuaternion(turns[parent]).add(places[parent]);
    places.push(at);
    turns.push(parent < 0 ? own : turns[parent].clone().multiply(own));
  });
  return { places, turns };
}

test('joints are where forward kinematics puts them, joint by joint', () => {
  const random = seeded(36), actor = actorOf(), take = someTake(random);
  for (let frame = 0; frame < take.frames; ++frame) {
    actor.pose(take, frame * take.frameTime);
    const { places } = placesAt(take, frame);
    actor.bones.forEach((bone, i) => near(new Vector3().setFromMatrixPosition(bone.matrixWorld).toArray(), places[i].toArray(), 1e-5));
  }
});

test('every point of a capsule is its radius from its axis, which goes from end to end', () => {
  const actor = actorOf();
  actor.parts.forEach((mesh, i) => {
    mesh.updateMatrix();
    const [from, to] = [kParts[i].from, kParts[i].to].map((p) => new Vector3(...p));
    const axis = to.clone().sub(from), { position } = mesh.geometry.attributes;
    let least = Infinity, most = -Infinity;
    for (let k = 0; k < position.count; ++k) {
      const p = new Vector3().fromBufferAttribute(position, k).applyMatrix4(mesh.matrix);
      const share = axis.lengthSq() > 0 ? p.clone().sub(from).dot(axis) / axis.lengthSq() : 0;
      near(p.distanceTo(from.clone().addScaledVector(axis, Math.max(0, Math.min(1, share)))), kParts[i].radius, 1e-5);
      [least, most] = [Math.min(least, share), Math.max(most, share)];
    }
    if (axis.length() > 0) near([least, most], [-kParts[i].radius / axis.length(), 1 + kParts[i].radius / axis.length()], 1e-5);
  });
});

test('lines of bones go from joint to joint and to their tips, wherever the group is put', () => {
  const random = seeded(37), actor = actorOf(), take = someTake(random);
  for (const shift of [[0, 0, 0], [3, -2, 0.4]]) {
    actor.group.position.set(...shift);
    actor.group.rotation.z = shift[0];
    actor.group.updateMatrixWorld(true);
    actor.pose(take, 0.5);
    actor.redraw();
    const { places, turns } = placesAt(take, 5);
    const expected = [];
    kJoints.forEach(({ parent, tips }, i) => {
      if (parent >= 0) expected.push(places[parent], places[i]);
      for (const tip of tips) expected.push(places[i], new Vector3(...tip).applyQuaternion(turns[i]).add(places[i]));
    });
    near(actor.lines.geometry.attributes.position.array, expected.flatMap((p) => p.toArray()), 1e-5);
    const ends = actor.ends.flatMap((end) => actor.endsOf(end)).map((p) => p.applyMatrix4(actor.group.matrixWorld.clone().invert()));
    near(ends.flatMap((p) => p.toArray()), expected.flatMap((p) => p.toArray()), 1e-5);
  }
});

test('a skin in the pose that it was made in is as it was made', () => {
  const random = seeded(38), figure = figureOf(random), actor = actorOf({ figure });
  kJoints.forEach((_, i) => {
    const bone = actor.bones[i];
    bone.matrixWorld.compose(new Vector3().fromArray(figure.bind, 7 * i), new Quaternion().fromArray(figure.bind, 7 * i + 3), new Vector3(1, 1, 1));
  });
  const p = new Vector3();
  for (let i = 0; i < 4; ++i) near(actor.figure.applyBoneTransform(i, p.fromArray(figure.vertices, 3 * i)).toArray(), figure.vertices.slice(3 * i, 3 * i + 3), 1e-5);
});

test('a corner of a skin lies between where its bones would have it, by their shares', () => {
  const random = seeded(39), figure = figureOf(random), actor = actorOf({ figure }), take = someTake(random);
  actor.pose(take, 0.7);
  const { places, turns } = placesAt(take, 7);
  for (let i = 0; i < 4; ++i) {
    const vertex = new Vector3().fromArray(figure.vertices, 3 * i), expected = new Vector3();
    for (let k = 0; k < 4; ++k) {
      const joint = figure.joints[4 * i + k];
      const own = vertex.clone().sub(new Vector3().fromArray(figure.bind, 7 * joint))
        .applyQuaternion(new Quaternion().fromArray(figure.bind, 7 * joint + 3).invert());
      expected.addScaledVector(own.applyQuaternion(turns[joint]).add(places[joint]), figure.weights[4 * i + k]);
    }
    near(actor.figure.applyBoneTransform(i, vertex).toArray(), expected.toArray(), 1e-4);
  }
});

test('what is switched on is seen; where there is no body its bones always are', () => {
  const actor = actorOf({ figure: figureOf(seeded(40)) });
  for (const body of [true, false]) {
    for (const capsules of [true, false]) {
      for (const bones of [true, false]) {
        actor.show({ body, capsules, bones });
        assert.deepEqual([actor.figure.visible, actor.parts.every(({ visible }) => visible === capsules), actor.lines.visible], [body, true, bones]);
      }
    }
  }
  const bare = actorOf({ body: { joints: kJoints, parts: [], head: -1 } });
  bare.show({ body: true, capsules: false, bones: false });
  assert.ok(bare.lines.visible);
  assert.equal(bare.eye, bare.bones[0]);
});

test('a part that touched something lights up and is seen, the others stay as they are', () => {
  const actor = actorOf();
  actor.show({ body: true, capsules: false, bones: false });
  const before = actor.parts.map(({ material }) => material);
  actor.light(2);
  assert.deepEqual(actor.parts.map(({ visible }) => visible), [false, false, true]);
  assert.deepEqual(actor.parts.map(({ material }, i) => material === before[i]), [true, true, false]);
  actor.light(-1);
  assert.deepEqual(actor.parts.map(({ material, visible }, i) => material === before[i] && !visible), [true, true, true]);
});

// A viewer with nothing but what a trace asks for.
function tracing(actor, take) {
  const groups = Object.fromEntries(['path', 'prints'].map((name) => [name, { children: [], add(...all) { this.children.push(...all); } }]));
  const viewer = { stage: { overlays: { add() {} } }, layers: { groups }, posed: 0 };
  const ghosts = new Ghosts(viewer);
  return { ghosts, viewer, one: { take, actor, clip: { floor: 0.1 } } };
}

test('a trace has a stick from end to end of each bone in every so-manieth frame', () => {
  const random = seeded(41), actor = actorOf(), take = someTake(random, 31);
  const { ghosts, one } = tracing(actor, take);
  ghosts.draw(10, [one], false);
  const mesh = ghosts.group.children[0];
  assert.equal(ghosts.drawn, 4);  // frames 0, 10, 20, 30
  assert.equal(mesh.count, 4 * actor.ends.length);
  const matrix = mesh.matrixWorld.clone(), up = new Vector3();
  [0, 10, 20, 30].forEach((frame, i) => {
    actor.pose(take, frame * take.frameTime);
    actor.ends.forEach((end, k) => {
      mesh.getMatrixAt(i * actor.ends.length + k, matrix);
      const [from, to] = actor.endsOf(end);
      near(up.set(0, -0.5, 0).applyMatrix4(matrix).toArray(), from.toArray(), 1e-4);
      near(up.set(0, 0.5, 0).applyMatrix4(matrix).toArray(), to.toArray(), 1e-4);
    });
  });
});

test('the trace of a thinned clip is of the file\'s frames, that of a very long one is thinned', () => {
  const random = seeded(42), actor = actorOf(), take = someTake(random, 40);
  const { ghosts, one } = tracing(actor, take);
  take.every = 5;
  ghosts.draw(10, [one], false);
  assert.equal(ghosts.drawn, 20);
  const long = { ...take, frames: 40000, pose: take.pose.bind(take), frameTime: 0, root: take.root };
  ghosts.draw(1, [{ ...one, take: long }], false);
  assert.ok(ghosts.drawn * actor.ends.length <= 24000, ghosts.drawn);
});

test('on the spot, or where none is asked for, there is no trace', () => {
  const actor = actorOf(), take = someTake(seeded(43));
  const { ghosts, one } = tracing(actor, take);
  ghosts.draw(5, [one], true);
  assert.deepEqual([ghosts.drawn, ghosts.group.children.length], [0, 0]);
  ghosts.draw(0, [one], false);
  assert.deepEqual([ghosts.drawn, ghosts.group.children.length], [0, 0]);
});
