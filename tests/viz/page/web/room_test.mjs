import assert from 'node:assert/strict';
import test from 'node:test';
import { Box3, Matrix4, Vector3 } from 'three';
import { Room } from '../../../../viz/page/web/room.js';
import { madePage } from './made_page.mjs';
import { near, numbersIn, seeded } from './seeded.mjs';

const kGrid = 65535;
// A cube on the grid of its own box.
const kCorners = Uint16Array.from([0, 1, 2, 3, 4, 5, 6, 7].flatMap((i) => [i & 1, (i >> 1) & 1, i >> 2].map((bit) => bit * kGrid)));
const kTriangles = Uint16Array.of(0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5);

// Boxes as surfaces: [kind, low, high, color].
function roomOf(boxes) {
  const placings = boxes.flatMap(([, low, high]) => {
    const size = high.map((value, i) => value - low[i]);
    return [size[0], 0, 0, 0, size[1], 0, 0, 0, size[2], ...low];
  });
  return {
    objects: boxes.map((_, i) => `object-${i}`), triangles: 0, shown: 0, thinned: 0, floor: 0,
    meshes: [{
      placings: Float32Array.from(placings), colors: Uint8Array.from(boxes.flatMap((box) => box[3] ?? [200, 100, 50])),
      objects: Uint32Array.from(boxes.keys()), kinds: boxes.map(([kind]) => kind), corners: kCorners, triangles: kTriangles,
    }],
  };
}

const roomWith = (boxes) => new Room(madePage({ room: roomOf(boxes) }));
const kFloor = ['floor', [0, 0, -0.1], [6, 4, 0]];
const kWalls = [
  ['wall', [-0.1, 0, 0], [0, 4, 2.5]], ['wall', [6, 0, 0], [6.1, 4, 2.5]],
  ['wall', [0, -0.1, 0], [6, 0, 2.5]], ['wall', [0, 4, 0], [6, 4.1, 2.5]],
];

// As a camera of the page, at a place.
const cameraAt = (x, y, z, mode = 'orbit') => ({ mode, current: { position: new Vector3(x, y, z) } });
const kAim = new Vector3(3, 2, 0.9);

test('surfaces stand where their boxes are, turned and sized as these are', () => {
  const random = seeded(34);
  for (let round = 0; round < 20; ++round) {
    const axes = [0, 1, 2].map(() => numbersIn(random, 3, -2, 2)), at = numbersIn(random, 3, -5, 5);
    const json = roomOf([['thing', [0, 0, 0], [1, 1, 1]]]);
    json.meshes[0].placings = Float32Array.from([...axes.flat(), ...at]);
    const { group } = new Room(madePage({ room: json }));
    const matrix = new Matrix4().set(axes[0][0], axes[1][0], axes[2][0], at[0], axes[0][1], axes[1][1], axes[2][1], at[1],
      axes[0][2], axes[1][2], axes[2][2], at[2], 0, 0, 0, 1);
    const expected = Array.from(kTriangles, (i) => new Vector3(i & 1, (i >> 1) & 1, i >> 2).applyMatrix4(matrix).toArray()).flat();
    near(group.children[0].geometry.attributes.position.array, expected, 1e-4);
  }
});

test('many equal things are drawn as instances in the places in which few of them are drawn one by one', () => {
  const random = seeded(35);
  const boxes = Array.from({ length: 30 }, () => {
    const low = numbersIn(random, 3, 0, 5);
    return ['thing', low, low.map((value) => value + 0.1 + random())];
  });
  const many = roomWith(boxes).group.children;
  assert.ok(many.length === 1 && many[0].isInstancedMesh);
  const matrix = new Matrix4(), box = new Box3();
  many[0].geometry.computeBoundingBox();
  boxes.forEach(([, low, high], i) => {
    many[0].getMatrixAt(i, matrix);
    box.copy(many[0].geometry.boundingBox).applyMatrix4(matrix);
    near([...box.min.toArray(), ...box.max.toArray()], [...low, ...high], 1e-5);
  });
  const few = new Box3().setFromObject(roomWith(boxes.slice(0, 5)).group);
  const union = new Box3();
  for (const [, low, high] of boxes.slice(0, 5)) union.union(new Box3(new Vector3(...low), new Vector3(...high)));
  near([...few.min.toArray(), ...few.max.toArray()], [...union.min.toArray(), ...union.max.toArray()], 1e-5);
});

test('of an instance the normals are those of its sides, whatever its proportions', () => {
  const boxes = Array.from({ length: 12 }, (_, i) => ['thing', [i, 0, 0], [i + 0.5, 0.02, 3]]);
  const [mesh] = roomWith(boxes).group.children;
  const matrix = new Matrix4();
  mesh.getMatrixAt(0, matrix);
  const { position, normal } = mesh.geometry.attributes;
  const p = new Vector3(), n = new Vector3();
  for (let i = 0; i < position.count; ++i) {
    // As the drawing does: a normal goes by the inverse of the sizes, here through its own scaling.
    n.fromBufferAttribute(normal, i).divide(new Vector3().setFromMatrixScale(matrix)).normalize();
    p.fromBufferAttribute(position, i).addScalar(-0.5);
    near(n.toArray().map(Math.abs).sort(), [0, 0, 1], 1e-5);
    assert.ok(p.dot(n) > 0);
  }
});

test('colours are those of the file, as light', () => {
  const { array } = roomWith([['thing', [0, 0, 0], [1, 1, 1], [255, 0, 128]]]).group.children[0].geometry.attributes.color;
  near(array.slice(0, 3), [1, 0, 0.21586], 1e-4);  // IEC 61966-2-1 of 128/255
});

test('a wall between the eye and the walker gives way, those behind him stay', () => {
  const room = roomWith([kFloor, ...kWalls]);
  const gone = () => room.walls.map(({ mesh }) => mesh.material.transparent);
  room.giveWay(cameraAt(-5, 2, 3), kAim);
  assert.deepEqual(gone(), [true, false, false, false]);
  room.giveWay(cameraAt(3, 9, 3), kAim);
  assert.deepEqual(gone(), [false, false, false, true]);
  room.giveWay(cameraAt(11, -5, 6), kAim);
  assert.deepEqual(gone(), [false, true, true, false]);
  room.giveWay(cameraAt(2, 1.5, 1.6), kAim);  // in the room
  assert.deepEqual(gone(), [false, false, false, false]);
});

test('no wall gives way from above, in the walker\'s eyes, or where that is switched off', () => {
  const room = roomWith([kFloor, ...kWalls]);
  const any = () => room.walls.some(({ mesh }) => mesh.material.transparent);
  for (const mode of ['top', 'first']) {
    room.giveWay(cameraAt(-5, 2, 3, mode), kAim);
    assert.ok(!any(), mode);
  }
  room.gives = false;
  room.giveWay(cameraAt(-5, 2, 3), kAim);
  assert.ok(!any());
});

test('an inner wall gives way where the walker would be behind it, and stays where he is not', () => {
  const inner = ['wall', [2, 1, 0], [2.1, 3, 2.5]];
  const room = roomWith([kFloor, ...kWalls, inner]);
  const wall = room.walls.at(-1);
  assert.deepEqual(wall.outside, { axis: 'x', sides: [false, false] });
  room.giveWay(cameraAt(0.5, 2, 1.6), kAim);
  assert.ok(wall.mesh.material.transparent);
  room.giveWay(cameraAt(0.5, 2, 1.6), new Vector3(1.2, 2, 0.9));  // on this side of it
  assert.ok(!wall.mesh.material.transparent);
  room.giveWay(cameraAt(5.5, 3.9, 1.6), kAim);
  assert.ok(!wall.mesh.material.transparent);
});

test('which side of a wall is outside is told by the floors beside it', () => {
  const room = roomWith([kFloor, ...kWalls]);
  assert.deepEqual(room.walls.map(({ outside }) => [outside.axis, ...outside.sides]),
    [['x', true, false], ['x', false, true], ['y', true, false], ['y', false, true]]);
});

test('a ceiling over the walker is taken off, and put back where one looks from below it', () => {
  const room = roomWith([kFloor, ...kWalls, ['ceiling', [0, 0, 2.5], [6, 4, 2.6]]]);
  const [{ mesh }] = room.ceilings;
  for (const [camera, visible] of [[cameraAt(3, -6, 7), false], [cameraAt(3, 1, 1.5), true], [cameraAt(3, 2, 9, 'first'), true]]) {
    room.giveWay(camera, kAim);
    assert.equal(mesh.visible, visible);
  }
  room.gives = false;
  room.giveWay(cameraAt(3, -6, 7), kAim);
  assert.ok(mesh.visible);
});

test('a thing lights up as it stands, one at a time, and goes out again', () => {
  const room = roomWith([kFloor, ['thing', [1, 1, 0], [2, 1.5, 0.7]], ['thing', [4, 3, 0], [5, 3.5, 1.7]]]);
  const count = room.group.children.length;
  for (const [object, low, high] of [[1, [1, 1, 0], [2, 1.5, 0.7]], [2, [4, 3, 0], [5, 3.5, 1.7]]]) {
    room.light(object);
    const box = new Box3().setFromObject(room.lit);
    near([...box.min.toArray(), ...box.max.toArray()], [...low, ...high], 1e-5);
    assert.equal(room.group.children.length, count + 1);
  }
  room.light(-1);
  assert.equal(room.lit, null);
  assert.equal(room.group.children.length, count);
  room.light(77);  // none of the room's
  assert.ok(!room.lit);
});

test('without a room there is nothing to be seen, and nothing fails', () => {
  const room = new Room(madePage());
  room.light(3);
  room.giveWay(cameraAt(0, 0, 3), kAim);
  assert.equal(room.group.children.length, 0);
});

test('beyond four hundred, walls are things like others', () => {
  const boxes = Array.from({ length: 500 }, (_, i) => ['wall', [i, 0, 0], [i + 0.1, 4, 2.5]]);
  const room = roomWith(boxes);
  assert.equal(room.walls.length, 400);
  assert.equal(room.group.children.filter((mesh) => mesh.isInstancedMesh).reduce((sum, mesh) => sum + mesh.count, 0), 100);
});
