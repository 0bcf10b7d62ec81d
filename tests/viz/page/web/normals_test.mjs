import assert from 'node:assert/strict';
import test from 'node:test';
import { BoxGeometry, IcosahedronGeometry, Matrix4, Quaternion, Vector3 } from 'three';
import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';
import { creasedNormals } from '../../../../viz/page/web/normals.js';
import { near, numbersIn, seeded } from './seeded.mjs';

// Corners that faces share, and triangles.
function meshOf(geometry) {
  for (const name of ['normal', 'uv']) geometry.deleteAttribute(name);
  const merged = mergeVertices(geometry);
  return { points: merged.attributes.position.array, triangles: merged.index.array };
}

const sphere = () => meshOf(new IcosahedronGeometry(1.3, 6));
const box = () => meshOf(new BoxGeometry(2, 1, 0.5));
const at = (array, i) => [...array.subarray(3 * i, 3 * i + 3)];

test('corners come three a triangle, where the triangle has them', () => {
  const { points, triangles } = sphere();
  const { positions } = creasedNormals(points, triangles);
  triangles.forEach((vertex, i) => assert.deepEqual(at(positions, i), at(points, vertex)));
});

test('a sphere is smooth: normals point away from its middle', () => {
  const { points, triangles } = sphere();
  const { positions, normals } = creasedNormals(points, triangles);
  for (let i = 0; i < triangles.length; ++i) near(at(normals, i), at(positions, i).map((x) => x / 1.3), 0.02);
});

test('a box is sharp: normals are those of its sides', () => {
  const { points, triangles } = box();
  const { positions, normals } = creasedNormals(points, triangles);
  for (let i = 0; i < triangles.length; ++i) {
    const normal = at(normals, i), p = at(positions, i);
    near(normal.map(Math.abs).sort(), [0, 0, 1], 1e-6);
    const axis = normal.findIndex((value) => Math.abs(value) > 0.5);
    assert.ok(normal[axis] * p[axis] > 0);  // outwards
  }
});

test('two faces are smooth below 35 degrees between them and sharp above', () => {
  for (const degrees of [5, 30, 34, 36, 50, 90]) {
    const bend = (degrees * Math.PI) / 180;
    const points = Float32Array.of(0, 0, 0, 0, 1, 0, -1, 0, 0, Math.cos(bend), 0, Math.sin(bend));
    const { normals } = creasedNormals(points, Uint16Array.of(0, 1, 2, 0, 3, 1));
    const apart = new Vector3(...at(normals, 0)).angleTo(new Vector3(...at(normals, 3)));
    near(apart, degrees < 35 ? 0 : bend, 1e-3, `${degrees}`);
  }
});

test('normals turn with the mesh, and neither its size nor the order of its triangles matters', () => {
  const random = seeded(12);
  const { points, triangles } = sphere();
  const bumpy = points.map((x) => x * (1 + 0.05 * random()));
  const plain = creasedNormals(bumpy, triangles).normals;
  const turn = new Quaternion(...numbersIn(random, 4, -1, 1)).normalize();
  const matrix = new Matrix4().makeRotationFromQuaternion(turn).scale(new Vector3(3, 3, 3));
  const moved = new Float32Array(bumpy.length), p = new Vector3();
  for (let i = 0; i < moved.length; i += 3) p.fromArray(bumpy, i).applyMatrix4(matrix).toArray(moved, i);
  const turned = creasedNormals(moved, triangles).normals;
  for (let i = 0; i < triangles.length; ++i) near(at(turned, i), p.fromArray(plain, 3 * i).applyQuaternion(turn).toArray(), 1e-4);
  const last = triangles.length / 3 - 1;
  const backwards = Uint16Array.from(triangles, (_, i) => triangles[3 * (last - Math.floor(i / 3)) + (i % 3)]);
  const reordered = creasedNormals(bumpy, backwards).normals;
  for (let t = 0; t <= last; ++t) near(at(reordered, 3 * t), at(plain, 3 * (last - t)), 1e-5);
});

test('a triangle of no area has no normal, and none that is not a number', () => {
  const { normals } = creasedNormals(Float32Array.of(1, 1, 1, 1, 1, 1, 2, 2, 2), Uint16Array.of(0, 1, 2));
  for (const value of normals) assert.equal(value, 0);
});
