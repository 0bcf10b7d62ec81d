import assert from 'node:assert/strict';
import test from 'node:test';
import { Bone, BoxGeometry, Group, Mesh, MeshBasicMaterial, Vector3 } from 'three';
import { Companion, interpolated } from '../../../../viz/page/web/companion.js';
import { Take } from '../../../../viz/page/web/take.js';
import { madePage, madeTake, rootOf } from './made_page.mjs';
import { near, numbersIn, seeded } from './seeded.mjs';

// Somebody of one bone.
function actorOf() {
  const group = new Group(), root = new Bone(), skin = new Mesh(new BoxGeometry(), new MeshBasicMaterial({ color: 0x336699 }));
  group.add(root, skin);
  return {
    group, root, skin,
    pose(take, time) {
      take.pose([root], time);
      root.updateMatrixWorld(true);
    },
    redraw() {},
  };
}

// Somebody who sets out in a direction, at a place.
function takeOf(actor, { frames = 61, from = [0, 0], heading = 0, speed = 1.2 }) {
  const root = rootOf(frames, (i) => [
    from[0] + (speed * i * Math.cos(heading)) / 30, from[1] + (speed * i * Math.sin(heading)) / 30, 0.9 + 0.02 * Math.sin(i / 5),
  ]);
  return new Take(madePage(), madeTake({ frames, joints: 1, frameTime: 1 / 30, actor, root }));
}

// Phases of the gait: whole where the left foot is in front, cycles of different lengths.
function phaseOf(random, count, begin, first) {
  const pairs = [[begin, first]];
  for (let i = 1; i < count; ++i) pairs.push([pairs.at(-1)[0] + 0.35 + 0.4 * random(), first + i / 2]);
  return pairs;
}

function companionOf({ takes = [{}, { from: [3, -1], heading: 2 }], phases = [[], []], floors = [0, 0] } = {}) {
  const actors = takes.map(actorOf);
  const viewer = { index: 0, actors, takes: takes.map((take, i) => takeOf(i, take)) };
  Object.defineProperties(viewer, { take: { get: () => viewer.takes[viewer.index] }, actor: { get: () => actors[viewer.index] } });
  const companion = new Companion(viewer, phases.map((phase, i) => ({ phase, floor: floors[i] })));
  companion.align();
  return { companion, viewer };
}

function placeAt(companion, viewer, time) {
  viewer.actor.pose(viewer.take, time);
  companion.follow(time);
  for (const { group } of viewer.actors) group.updateMatrixWorld(true);
  return viewer.actors.map(({ root }) => new Vector3().setFromMatrixPosition(root.matrixWorld));
}

test('what is interpolated there comes back from where it went, beyond the ends as well', () => {
  const random = seeded(24);
  for (let round = 0; round < 100; ++round) {
    const pairs = phaseOf(random, 2 + Math.floor(6 * random()), random(), 0.5);
    const time = pairs[0][0] + (pairs.at(-1)[0] - pairs[0][0]) * (1.6 * random() - 0.3);
    near(interpolated(pairs, interpolated(pairs, time, 0, 1), 1, 0), time, 1e-9);
    for (const [at, phase] of pairs) near(interpolated(pairs, at, 0, 1), phase, 1e-12);
  }
});

test('by time both clips are at one time, the shorter waits at its end', () => {
  const { companion } = companionOf({ takes: [{ frames: 91 }, { frames: 31 }] });
  companion.set({ with: 1 });
  for (const [time, expected] of [[0, 0], [0.7, 0.7], [1, 1], [2.5, 1]]) near(companion.timeOf(time), expected, 1e-12);
});

test('by phase both are at the same moment of a cycle, at every time', () => {
  const random = seeded(25);
  for (let round = 0; round < 40; ++round) {
    const phases = [phaseOf(random, 9, random(), Math.floor(3 * random()) / 2), phaseOf(random, 7, random(), Math.floor(5 * random()) / 2)];
    const { companion } = companionOf({ takes: [{ frames: 300 }, { frames: 300 }], phases });
    companion.set({ with: 1, sync: 'phase' });
    for (const time of numbersIn(random, 50, phases[0][0][0], phases[0].at(-1)[0])) {
      const [own, other] = [interpolated(phases[0], time, 0, 1), interpolated(phases[1], companion.timeOf(time), 0, 1)];
      near((own - other) - Math.round(own - other), 0, 1e-9);
      const late = companion.timeOf(time);
      assert.ok(late >= phases[1][0][0] - 1e-9 && late <= phases[1].at(-1)[0] + 1e-9, `${late}`);
    }
  }
});

test('spans of the second clip lie over the first\'s times that show them', () => {
  const random = seeded(26);
  for (let round = 0; round < 30; ++round) {
    const phases = [phaseOf(random, 11, random(), 0.5), phaseOf(random, 7, random(), 2)];
    const { companion } = companionOf({ takes: [{ frames: 400 }, { frames: 400 }], phases });
    companion.set({ with: 1, sync: 'phase' });
    const [low, high] = [phases[1][0][0], phases[1].at(-1)[0]];
    const from = low + 0.6 * (high - low) * random(), spans = [[from, from + 0.2]];
    const over = companion.spansOver(spans);
    for (const time of numbersIn(random, 200, phases[0][0][0], phases[0].at(-1)[0])) {
      const late = companion.timeOf(time), slack = 1e-6;
      const isIn = (all, at, by) => all.some(([a, b]) => at > a - by && at < b + by);
      if (isIn(spans, late, -slack)) assert.ok(isIn(over, time, slack), `${time}: ${late} of ${spans} but ${over}`);
    }
  }
});

test('by time spans lie where they are', () => {
  const { companion } = companionOf();
  companion.set({ with: 1 });
  assert.deepEqual(companion.spansOver([[1, 2]]), [[1, 2]]);
});

test('clips without a gait have no phase to be compared by', () => {
  const { companion } = companionOf({ phases: [[[0, 0], [1, 1]], [[0.2, 0.5]]] });
  companion.set({ with: 1, sync: 'phase' });
  assert.ok(!companion.hasPhase);
  near(companion.timeOf(0.4), 0.4, 1e-12);
});

test('wherever two clips were captured, overlaid they set out from one place in one direction', () => {
  const random = seeded(27);
  for (let round = 0; round < 20; ++round) {
    const takes = [0, 1].map(() => ({ from: numbersIn(random, 2, -9, 9), heading: 6 * random() - 3, speed: 1 + random() }));
    const { companion, viewer } = companionOf({ takes });
    companion.set({ with: 1 });
    const begin = placeAt(companion, viewer, 0), later = placeAt(companion, viewer, 1.5);
    near(begin[0].distanceTo(begin[1]), 0, 1e-5);
    const ways = later.map((place, i) => place.clone().sub(begin[i]).setZ(0).normalize());
    near(ways[0].dot(ways[1]), 1, 1e-6);
  }
});

test('side by side the second goes 1.1 m to the right of the first, whichever way that goes', () => {
  for (const heading of [0, 1, 2.5, -1.2]) {
    const { companion, viewer } = companionOf({ takes: [{ heading, speed: 1.2 }, { heading: 3, speed: 1.2 }] });
    companion.set({ with: 1, place: 'beside' });
    for (const time of [0, 0.8, 2]) {
      const [first, second] = placeAt(companion, viewer, time);
      const aside = second.sub(first);
      near([aside.x, aside.y], [1.1 * Math.sin(heading), -1.1 * Math.cos(heading)], 1e-5);
    }
  }
});

test('on the spot both stay over the origin, as high as they walk', () => {
  const { companion, viewer } = companionOf({ floors: [0.1, -0.2] });
  companion.set({ with: 1 });
  companion.inPlace = true;
  companion.align();
  for (const time of [0, 0.5, 1.9]) {
    placeAt(companion, viewer, time).forEach((place, i) => {
      near([place.x, place.y], [0, 0], 1e-6);
      near(place.z, viewer.takes[i].root[3 * Math.round(30 * time) + 2] - [0.1, -0.2][i], 0.01);
    });
  }
});

test('both stand on the floor of the page, whatever floor they were captured on', () => {
  const { companion, viewer } = companionOf({ floors: [1, 0.3] });
  companion.set({ with: 1 });
  const places = placeAt(companion, viewer, 0);
  near(places.map(({ z }) => z), [viewer.takes[0].root[2] - 1, viewer.takes[1].root[2] - 0.3], 1e-6);
});

test('the second wears a colour of his own, and his first one again when he leaves', () => {
  const { companion, viewer } = companionOf();
  const color = () => viewer.actors[1].skin.material.color.getHex();
  const before = color();
  companion.set({ with: 1 });
  assert.notEqual(color(), before);
  assert.ok(viewer.actors[1].group.visible);
  companion.set({ with: -1 });
  assert.equal(color(), before);
  assert.ok(!viewer.actors[1].group.visible);
  companion.set({ with: 0 });  // nobody beside himself
  assert.equal(companion.index, -1);
});

test('all of both ways is within what is to be in sight', () => {
  const { companion, viewer } = companionOf({ takes: [{ heading: 0.4 }, { heading: -2, frames: 150 }] });
  companion.set({ with: 1, place: 'beside' });
  const bounds = companion.bounds();
  for (let time = 0; time < 5; time += 0.2)
    for (const place of placeAt(companion, viewer, time)) assert.ok(bounds.containsPoint(place), place.toArray().join());
});
