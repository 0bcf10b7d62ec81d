import assert from 'node:assert/strict';
import test from 'node:test';
import { MeshBasicMaterial } from 'three';
import { Attempts } from '../../../../viz/page/web/attempts.js';
import { fan, Flat, ribbon } from '../../../../viz/page/web/flat.js';
import { groundOf } from '../../../../viz/page/web/grounds.js';
import { madePage } from './made_page.mjs';
import { near, seeded } from './seeded.mjs';

// Corners of every triangle: [[x, y, z] x 3] each.
function trianglesOf(geometry) {
  const { array } = geometry.attributes.position;
  const corners = Array.from(geometry.index.array, (i) => [...array.subarray(3 * i, 3 * i + 3)]);
  return Array.from({ length: corners.length / 3 }, (_, t) => corners.slice(3 * t, 3 * t + 3));
}

// Seen from above; positive against the clock [m^2].
const signedArea = ([a, b, c]) => ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
const areaOf = (geometry) => trianglesOf(geometry).reduce((sum, one) => sum + signedArea(one), 0);
const shoelace = (outline) => outline.reduce((sum, [x, y], i) => {
  const [u, v] = outline[(i + 1) % outline.length];
  return sum + (x * v - u * y) / 2;
}, 0);

// A convex outline, against the clock.
function convexOf(random, count) {
  const angles = Array.from({ length: count }, () => 2 * Math.PI * random()).sort((a, b) => a - b);
  return angles.map((angle) => [2 + 0.7 * Math.cos(angle), -1 + 0.4 * Math.sin(angle)]);
}

const kMaterial = () => new MeshBasicMaterial();

test('a fan fills its outline once, with no triangle turned over', () => {
  const random = seeded(10);
  for (let round = 0; round < 30; ++round) {
    const outline = convexOf(random, 3 + round);
    const geometry = fan(outline);
    near(areaOf(geometry), shoelace(outline), 1e-5);
    for (const triangle of trianglesOf(geometry)) assert.ok(signedArea(triangle) >= -1e-7);
  }
});

test('a ribbon along a line is its length times its breadth, as high over it as was asked', () => {
  for (const angle of [0, 0.7, 2, -2.5]) {
    const points = Array.from({ length: 9 }, (_, i) => [0.3 * i * Math.cos(angle), 0.3 * i * Math.sin(angle), 0.5]).flat();
    const geometry = ribbon(points, 0.04, 0.01);
    near(Math.abs(areaOf(geometry)), 2.4 * 0.04, 1e-6);
    for (const corner of trianglesOf(geometry).flat()) near(corner[2], 0.51, 1e-6);
  }
});

test('the edges of a ribbon are half its breadth from its line, in bends as well', () => {
  const arc = Array.from({ length: 60 }, (_, i) => [Math.cos(i / 30), Math.sin(i / 30), 0]).flat();
  const { array } = ribbon(arc, 0.1, 0).attributes.position;
  for (let i = 3; i < array.length - 6; i += 3) near(Math.abs(Math.hypot(array[i], array[i + 1]) - 1), 0.05, 1e-3);
});

test('a ribbon of one point, or of points in one place, holds no number that is none', () => {
  for (const points of [[1, 2, 3], [1, 2, 3, 1, 2, 3, 1, 2, 3]])
    for (const value of ribbon(points, 0.1, 0).attributes.position.array) assert.ok(Number.isFinite(value));
});

test('many things in one geometry are each as they are alone', () => {
  const random = seeded(11);
  const flat = new Flat();
  assert.ok(flat.isEmpty);
  let sum = 0;
  for (let i = 0; i < 5; ++i) {
    const outline = convexOf(random, 5);
    flat.addFan(outline);
    flat.addQuad([0, 0, i], [2, 0, i], [2, 1, i], [0, 1, i]);
    sum += shoelace(outline) + 2;
  }
  near(areaOf(flat.geometry()), sum, 1e-5);
});

test('strips cover the ground that they say, each kind in its own material', () => {
  const strips = [[0, 0, 0.1, 3, 0, 0.1, 0], [1, 1, 0, 2, 1, 0, 2], [5, 2, 0, 9, 2, 0, 2]];
  const json = {
    breadth: 0.05, kind: Uint8Array.from(strips, (one) => one[6]),
    strips: Float32Array.from(strips.flatMap((one) => one.slice(0, 6))),
  };
  const materials = [kMaterial(), kMaterial(), kMaterial()];
  const group = groundOf(madePage(), json, materials);
  assert.deepEqual(group.children.map((mesh) => mesh.material), [materials[0], materials[2]]);
  near(group.children.map((mesh) => areaOf(mesh.geometry)), [3 * 0.05, 5 * 0.05], 1e-6);
  const [low] = group.children;
  for (const [x, y] of trianglesOf(low.geometry).flat()) assert.ok(x >= 0 && x <= 3 && Math.abs(y) <= 0.0251);
});

test('a cross lies where an attempt failed, and as large as any other', () => {
  const line = Float32Array.of(0, 0, 0.2, 1, 0, 0.2);
  const attempts = [[0.5, 0.25], [-3, 7]].map(([x, y], i) => ({ line, at: [x, y, 0.9], what: '', take: i === 0 ? 2 : null }));
  const { edges, group } = new Attempts(madePage({ walk: { attempts } }), kMaterial);
  assert.deepEqual(edges.map((edge) => edge.take), [2, null]);
  const crosses = group.children.at(-1).geometry;
  const all = trianglesOf(crosses);
  for (const [i, { at }] of attempts.entries()) {
    const own = all.slice(4 * i, 4 * i + 4).flat();
    for (const axis of [0, 1]) {
      near(own.reduce((sum, corner) => sum + corner[axis], 0) / own.length, at[axis], 1e-5);
      near(Math.max(...own.map((corner) => corner[axis])) - at[axis], 0.05 * Math.SQRT1_2 + 0.009 * Math.SQRT1_2, 1e-5);
    }
  }
  assert.equal(group.children.length, 3);  // what can be played, what cannot, and crosses
});
