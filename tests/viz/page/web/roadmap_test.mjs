import assert from 'node:assert/strict';
import test from 'node:test';
import { Box3, OrthographicCamera, Vector3 } from 'three';
import { edgeAt, Roadmap } from '../../../../viz/page/web/roadmap.js';
import { madePage } from './made_page.mjs';
import { near, numbersIn, seeded } from './seeded.mjs';

const kCanvas = { clientWidth: 800, clientHeight: 600 };

// From above: 100 pixels a metre, (0, 0) in the middle.
function fromAbove() {
  const camera = new OrthographicCamera(-4, 4, 3, -3, 0.1, 100);
  camera.position.set(0, 0, 50);
  camera.updateMatrixWorld();
  return camera;
}

const pixelOf = (x, y) => [400 + 100 * x, 300 - 100 * y];

function roadmapOf(edges, nodes = []) {
  return new Roadmap(madePage({ walk: { roadmap: { nodes, edges: edges.map((edge) => ({ take: 1, ...edge, line: Float32Array.from(edge.line) })) } } }));
}

test('an edge is found wherever it is drawn, also between points that are far apart', () => {
  const random = seeded(32);
  const camera = fromAbove();
  for (let round = 0; round < 50; ++round) {
    const ends = numbersIn(random, 4, -2.5, 2.5);
    const { edges } = roadmapOf([{ line: [ends[0], ends[1], 0, ends[2], ends[3], 0] }]);
    const { line } = edges[0], share = random();
    const [x, y] = pixelOf(line[0] + share * (line[3] - line[0]), line[1] + share * (line[4] - line[1]));
    assert.equal(edgeAt(edges, x, y, camera, kCanvas), 0);
  }
});

test('a press 16 pixels beside an edge is none of it, whichever way', () => {
  const { edges } = roadmapOf([{ line: [-2, 0, 0, 2, 0, 0] }]);
  const camera = fromAbove(), [x, y] = pixelOf(0, -0.035);
  for (const [dx, dy] of [[0, 17], [0, -17], [217, 0], [-217, 0]]) assert.equal(edgeAt(edges, x + dx, y + dy, camera, kCanvas), -1);
  for (const [dx, dy] of [[0, 15], [0, -15], [214, 0], [-214, 0]]) assert.equal(edgeAt(edges, x + dx, y + dy, camera, kCanvas), 0);
});

test('of several edges the nearest is meant, those that cannot be played are not', () => {
  const line = (y) => [-2, y, 0, 2, y, 0];
  const { edges } = roadmapOf([{ line: line(0) }, { line: line(0.1) }, { line: line(0.2), take: null }]);
  const camera = fromAbove();
  const at = (y) => edgeAt(edges, ...pixelOf(0.3, y - 0.035), camera, kCanvas);
  assert.deepEqual([0.01, 0.04, 0.06, 0.12, 0.19].map(at), [0, 0, 1, 1, 1]);
});

test('what lies behind the camera is not where it would be seen', () => {
  const { edges } = roadmapOf([{ line: [0, 0, 80, 1, 0, 80] }]);
  assert.equal(edgeAt(edges, 400, 300, fromAbove(), kCanvas), -1);
});

test('edges there and back lie beside one another, each on the right of its way', () => {
  const there = [0, 0, 0, 1, 0.5, 0, 2, 1, 0], back = [2, 1, 0, 1, 0.5, 0, 0, 0, 0];
  const { edges } = roadmapOf([{ line: there }, { line: back }]);
  const right = new Vector3(1, -2, 0).normalize();
  for (let i = 0; i < 3; ++i) {
    const off = [0, 1].map((edge) => new Vector3().fromArray(edges[edge].line, 3 * i).sub(new Vector3().fromArray(edge === 0 ? there : back, 3 * i)));
    near(off[0].dot(right), 0.035, 1e-6);
    near(off[1].dot(right), -0.035, 1e-6);
    near(off.map((one) => one.length()), [0.035, 0.035], 1e-6);
  }
});

test('an arrow points the way that its edge goes', () => {
  for (const angle of [0, 1, 2.2, -1.3]) {
    const line = Array.from({ length: 7 }, (_, i) => [i * Math.cos(angle), i * Math.sin(angle), 0]).flat();
    const { edges } = roadmapOf([{ line }]);
    near(edges[0].group.children[1].rotation.z, angle, 1e-6);
  }
});

test('a node stands at its place, guards as rings and connectors as squares', () => {
  const nodes = [{ at: [1, 2, 0.3], heading: 0.4, connector: false }, { at: [-1, 0, 0], heading: 0, connector: true }];
  const roadmap = roadmapOf([], nodes);
  assert.ok(!roadmap.isEmpty);
  const sizes = roadmap.group.children.map((mesh, i) => {
    near([mesh.position.x, mesh.position.y], nodes[i].at.slice(0, 2), 1e-9);
    mesh.geometry.computeBoundingBox();
    return mesh.geometry.boundingBox.getSize(new Vector3()).x;
  });
  near(sizes, [0.22, 0.18], 2e-3);
  const { array } = roadmap.group.children[0].geometry.attributes.position;
  for (let i = 0; i < array.length; i += 3) assert.ok(Math.hypot(array[i], array[i + 1]) > 0.079);  // a hole in its middle
});

test('one edge is chosen at a time, or none', () => {
  const roadmap = roadmapOf([{ line: [0, 0, 0, 1, 0, 0] }, { line: [0, 1, 0, 1, 1, 0] }]);
  const chosen = () => roadmap.edges.map(({ group }) => group.children.every((mesh) => mesh.material === roadmap.materials.chosen));
  roadmap.choose(1);
  assert.deepEqual(chosen(), [false, true]);
  roadmap.choose(0);
  assert.deepEqual(chosen(), [true, false]);
  roadmap.choose(-1);
  assert.deepEqual(chosen(), [false, false]);
});

test('a roadmap of one place has an edge of no length, drawn as numbers', () => {
  const { edges, group } = roadmapOf([{ line: [1, 1, 0] }]);
  assert.ok(edges[0].line.every(Number.isFinite));
  assert.ok(!new Box3().setFromObject(group).isEmpty());
});
