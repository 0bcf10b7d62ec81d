// What `amble plan` writes into a page, read by the page's own modules and held against what it writes
// beside it.
//   AMBLE=PROGRAM AMBLE_WEB=BUILD/web node --import three_of_build.mjs written_test.mjs WORK

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import { Box3, Vector3 } from 'three';
import { Actor } from '../../../viz/page/web/actor.js';
import { readPage } from '../../../viz/page/web/data.js';
import { Roadmap } from '../../../viz/page/web/roadmap.js';
import { Room } from '../../../viz/page/web/room.js';
import { Take } from '../../../viz/page/web/take.js';
import { near } from '../../viz/page/web/seeded.mjs';

const source = fileURLToPath(new URL('../../..', import.meta.url));
const work = join(process.argv[2], 'written');
mkdirSync(work, { recursive: true });

function pageOf(html) {
  const text = readFileSync(html, 'utf8');
  const textOf = (id) => new RegExp(`<script id="${id}"[^>]*>([^]*?)</script>`).exec(text)[1];
  return readPage({ getElementById: (id) => ({ textContent: textOf(id) }) });
}

function planned(scenario) {
  const folder = join(work, scenario);
  try {
    execFileSync(process.env.AMBLE, ['plan', join(source, 'scenarios', `${scenario}.yaml`), '-o', folder, '--formats', 'json,html'], { stdio: 'pipe' });
  } catch (error) {
    if (error.status !== 1) throw error;  // 1: there is no walk
  }
  const page = pageOf(join(folder, 'walk.html'));
  return {
    page, report: JSON.parse(readFileSync(join(folder, 'report.json'))),
    takes: page.takes.map((json) => new Take(page, json)), actor: new Actor(page, page.actors[0]), room: new Room(page),
  };
}

const walk = planned('living-room');
walk.actor.show({ body: true, capsules: true, bones: true });
const { report } = walk, [take] = walk.takes;

test('length, time and steps on the page are those of the report', () => {
  assert.equal(take.frames, report.frames);
  near(take.duration, report.duration, 1e-6);
  const facts = new Map(walk.page.facts);
  near(parseFloat(facts.get('Length')), report.length, 0.0051);
  near(parseFloat(facts.get('Time')), report.duration, 0.0051);
  assert.equal(Number(facts.get('Steps')), report.steps.length);
});

test('the root\'s way on the ground is as long as the report says the walk is', () => {
  let length = 0;
  for (let i = 3; i < take.way.length; i += 3) length += Math.hypot(take.way[i] - take.way[i - 3], take.way[i + 1] - take.way[i - 2]);
  near(length, report.length, 0.05);
});

test('a shoe is printed where each step of the report comes down, for as long as it stands', () => {
  for (const step of report.steps) {
    const side = step.foot === 'left' ? 0 : 1;
    const print = take.prints.find((one) => one.side === side && Math.hypot(one.at[0] - step.at[0], one.at[1] - step.at[1]) < 1e-3);
    assert.ok(print, JSON.stringify(step));
    const middle = ((step.start + step.end) / 2) / report.frame_time;
    assert.ok(print.first - 1 <= middle && middle <= print.last + 1, `${print.first} to ${print.last}: ${middle}`);
  }
});

test('while a shoe stands nothing of its sole leaves its print', () => {
  const soles = walk.actor.parts.filter((_, i) => walk.page.actors[0].body.parts[i].side >= 0);
  const p = new Vector3();
  for (const print of take.prints) {
    const own = soles.filter(({ material }) => material === walk.actor.skins[walk.page.actors[0].body.parts.findIndex((part) => part.side === print.side)]);
    const [middle, reach] = [print.at, Math.max(...print.outline.map(([x, y]) => Math.hypot(x - print.at[0], y - print.at[1])))];
    for (let frame = print.first; frame <= Math.min(print.last, take.frames - 1); frame += 5) {
      walk.actor.pose(take, frame * take.frameTime);
      for (const mesh of own) {
        p.setFromMatrixPosition(mesh.matrixWorld);
        assert.ok(Math.hypot(p.x - middle[0], p.y - middle[1]) < reach, `${frame}: ${p.toArray()}`);
      }
    }
  }
});

test('what is nearest is as near as the report says, at the moment that it says', () => {
  const { distance } = take.clearance;
  const present = Array.from(distance).filter((d) => d >= 0);
  assert.ok(Math.min(...present) >= report.clearance.min - 1e-5);  // between two frames it may be nearer
  const at = take.frameAt(report.clearance.time);
  near(distance[at], report.clearance.min, 2e-3);
  assert.equal(walk.page.room.objects[take.clearance.object[at]], report.clearance.object);
  assert.equal(walk.page.actors[0].body.parts[take.clearance.part[at]].name, report.clearance.part);
});

test('the two points of what is nearest are as far apart as it is near', () => {
  const { distance, points } = take.clearance;
  distance.forEach((d, i) => {
    if (d < 0) return;
    near(Math.hypot(...[0, 1, 2].map((k) => points[6 * i + k] - points[6 * i + 3 + k])), d, 6e-3);
  });
});

test('in every frame the motions that it is made of come to one', () => {
  for (let frame = 0; frame < take.frames; ++frame) {
    const sum = take.sources.reduce((all, source) => all + source.share[frame], 0);
    assert.ok(sum > 0.95 && sum < 1.0001, `${frame}: ${sum}`);
  }
});

test('a walker faces where he goes, but for where he turns on the spot', () => {
  const off = [];
  for (let frame = 30; frame < take.frames - 30; ++frame) {
    const [x, y] = [0, 1].map((axis) => take.root[3 * (frame + 10) + axis] - take.root[3 * (frame - 10) + axis]);
    if (Math.hypot(x, y) < 0.15) continue;
    const turn = Math.atan2(y, x) - take.heading(frame * take.frameTime);
    off.push(Math.abs(Math.atan2(Math.sin(turn), Math.cos(turn))));
  }
  assert.ok(off.length > 100);
  assert.ok(Math.max(...off) < 0.8, Math.max(...off));
});

test('shares of a skin\'s bones come to one, and its corners are of the bones that there are', () => {
  const { skinWeight, skinIndex, normal } = walk.actor.figure.geometry.attributes;
  for (let i = 0; i < skinWeight.count; ++i) {
    const own = [0, 1, 2, 3].map((k) => skinWeight.getComponent(i, k));
    near(own.reduce((sum, one) => sum + one), 1, 1e-5);
    assert.ok(own.every((one) => one >= 0));
    for (let k = 0; k < 4; ++k) assert.ok(skinIndex.getComponent(i, k) < walk.actor.bones.length);
    near(new Vector3().fromBufferAttribute(normal, i).length(), 1, 1e-4);
  }
});

test('in every pose of the walk the skin is as tall as a walker, and does not sink into the floor', () => {
  const { actor } = walk, p = new Vector3();
  const { position } = actor.figure.geometry.attributes;
  for (let frame = 0; frame < take.frames; frame += 23) {
    actor.pose(take, frame * take.frameTime);
    let low = Infinity, high = -Infinity;
    for (let i = 0; i < position.count; i += 3) {
      const { z } = actor.figure.applyBoneTransform(i, p.fromBufferAttribute(position, i));
      [low, high] = [Math.min(low, z), Math.max(high, z)];
    }
    assert.ok(low > walk.page.floor - 0.02 && low < walk.page.floor + 0.06, `${frame}: ${low}`);
    near(high - walk.page.floor, report.stature, 0.15);
  }
});

test('the walk is within the room, which has every thing of the scene', () => {
  const { room } = walk, bounds = new Box3().setFromObject(room.group);
  for (let i = 0; i < take.root.length; i += 3) assert.ok(bounds.containsPoint(new Vector3().fromArray(take.root, i)));
  const seen = new Set(walk.page.room.meshes.flatMap((mesh) => [...walk.page.array(mesh.objects)]));
  assert.deepEqual([...seen].sort((a, b) => a - b), walk.page.room.objects.map((_, i) => i));
  for (let object = 0; object < walk.page.room.objects.length; object += 9) {
    room.light(object);
    assert.ok(room.lit, walk.page.room.objects[object]);
  }
});

test('a room of few triangles is shown with all of them', () => {
  const { triangles, shown, thinned, meshes } = walk.page.room;
  assert.deepEqual([shown, thinned], [triangles, 0]);
  assert.equal(meshes.reduce((sum, mesh) => sum + (mesh.triangles.n / 3) * mesh.objects.n, 0), shown);
});

test('the roadmap is the report\'s, and an edge that is played goes from node to node', () => {
  const { nodes, edges } = walk.page.walk.roadmap;
  assert.equal(nodes.length, report.roadmap.guards + report.roadmap.connectors);
  assert.equal(edges.length, report.roadmap.edges);
  const roadmap = new Roadmap(walk.page);
  for (const edge of roadmap.edges.filter(({ take: index }) => index !== null)) {
    const played = walk.takes[edge.take], ends = [edge.from, edge.to].map((node) => nodes[node].at);
    const last = played.way.length - 3;
    near([played.way[0], played.way[1]], ends[0].slice(0, 2), 0.05);
    near([played.way[last], played.way[last + 1]], ends[1].slice(0, 2), 0.1);
  }
});

test('rotations of edges, in 16 bits, are turns still', () => {
  for (const edge of walk.takes.slice(1))
    for (let i = 0; i < edge.rotations.length; i += 4) near(Math.hypot(...edge.rotations.subarray(i, i + 4)), 1, 1e-4);
});

test('a walk begins and ends where it was asked to', () => {
  const { start, goal } = walk.page.walk;
  near([...take.way.subarray(0, 2)], start.at.slice(0, 2), 0.02);
  near([...take.way.subarray(-3, -1)], goal.at.slice(0, 2), 0.02 + Math.abs(report.goal_error.position ?? 0));
});

const none = planned('narrow-gap-040');

test('without a walk the page says what the report says', () => {
  assert.equal(none.report.status === 'solved', false);
  assert.equal(none.page.why, none.report.why);
});

test('attempts that can be played end where they failed, on a part and a thing that there are', () => {
  const played = none.page.walk.attempts.filter((attempt) => attempt.take !== null);
  assert.ok(played.length > 0);
  for (const { take: index, at } of played) {
    const { stop, frames } = none.takes[index];
    assert.ok(stop.frame >= 0 && stop.frame <= frames - 1, `${stop.frame} of ${frames}`);
    near(stop.at, at, 1e-9);
    assert.ok(stop.part < none.page.actors[0].body.parts.length && stop.object < none.page.room.objects.length);
  }
});

test('the part that touched is at the thing that it touched, in the frame in which it did', () => {
  none.actor.show({ body: true, capsules: true, bones: true });
  const { room } = none, p = new Vector3();
  for (const [index, one] of none.takes.entries()) {
    if (!one.stop || one.stop.part < 0 || one.stop.object < 0) continue;
    none.actor.pose(one, one.duration);
    room.light(one.stop.object);
    const box = new Box3().setFromObject(room.lit);
    const part = none.page.actors[0].body.parts[one.stop.part], { matrixWorld } = none.actor.bones[part.joint];
    const [from, to] = [part.from, part.to].map((end) => new Vector3(...end).applyMatrix4(matrixWorld));
    let least = Infinity;
    for (let share = 0; share <= 1; share += 0.02) least = Math.min(least, box.distanceToPoint(p.lerpVectors(from, to, share)));
    assert.ok(least <= part.radius + 0.03, `${index}: ${least} from ${part.name} of ${part.radius}`);
  }
});

test('ground that is reached, and ground with room to walk, lies in the room', () => {
  for (const { page, room } of [walk, none]) {
    const bounds = new Box3().setFromObject(room.group);
    for (const ground of [page.walk.reached, page.walk.room_to_walk].filter(Boolean)) {
      const strips = page.array(ground.strips);
      assert.equal(strips.length, 6 * page.array(ground.kind).length);
      for (let i = 0; i < strips.length; i += 6) {
        assert.ok(strips[i] < strips[i + 3] && strips[i + 1] === strips[i + 4]);
        assert.ok(strips[i] >= bounds.min.x - 0.06 && strips[i + 3] <= bounds.max.x + 0.06);
      }
    }
  }
  assert.ok(none.page.walk.reached && walk.page.walk.room_to_walk);
});

test('the page\'s numbers take no more bytes than they need', () => {
  // The arrays lie one after another: what is not named is padding only.
  const refs = [];
  JSON.stringify(walk.page, (key, value) => {
    if (value && typeof value === 'object' && 'o' in value && 'n' in value) refs.push(value);
    return value;
  });
  const size = { f32: 4, i16: 2, u8: 1, u16: 2, u32: 4 };
  const spans = refs.map(({ t, o, n }) => [o, o + n * size[t]]).sort(([a], [b]) => a - b);
  let end = 0;
  for (const [from, to] of spans) {
    assert.ok(from >= end && from - end < 4, `${from} after ${end}`);
    end = Math.max(end, to);
  }
});
