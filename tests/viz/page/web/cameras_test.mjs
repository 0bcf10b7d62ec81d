import assert from 'node:assert/strict';
import test from 'node:test';
import { Box3, Vector3 } from 'three';
import { element } from './fake_dom.mjs';
import { near, numbersIn, seeded } from './seeded.mjs';

const { Cameras, kModes } = await import('../../../../viz/page/web/cameras.js');

const kRoom = new Box3(new Vector3(-1, 2, 0), new Vector3(7, 8, 2.6));

function camerasOf(bounds = kRoom, [width, height] = [900, 600], covered = 0) {
  const canvas = element('canvas');
  [canvas.clientWidth, canvas.clientHeight] = [width, height];
  const cameras = new Cameras(canvas, bounds, new Vector3(1, 3, 0.9));
  cameras.resize(width, height, covered);
  return { cameras, canvas };
}

const walked = (cameras, x, y, elapsed = 1 / 60, heading = 0) =>
  cameras.update(new Vector3(x, y, 0.9), new Vector3(x, y, 1.7), heading, elapsed);

// Where points are seen, as shares of the canvas from its upper left corner.
function seenAt(camera, points) {
  camera.updateMatrixWorld();
  return points.map((point) => {
    const p = point.clone().project(camera);
    return [(p.x + 1) / 2, (1 - p.y) / 2, p.z];
  });
}

const cornersOf = ({ min, max }, z = [min.z]) => z.flatMap((height) => [[min.x, min.y], [min.x, max.y], [max.x, min.y], [max.x, max.y]]
  .map(([x, y]) => new Vector3(x, y, height)));

test('from above all of the room is in sight, over what covers the lower edge, on every screen', () => {
  for (const size of [[900, 600], [360, 740], [740, 360], [1920, 1080], [390, 844]]) {
    for (const covered of [0, 0.2, 0.35]) {
      const { cameras } = camerasOf(kRoom, size, covered * size[1]);
      cameras.setMode('top');
      walked(cameras, 1, 3);
      for (const [x, y] of seenAt(cameras.top, cornersOf(kRoom)))
        assert.ok(x > 0 && x < 1 && y > 0 && y < 1 - covered, `${size} ${covered}: ${x}, ${y}`);
    }
  }
});

test('from above north is up and east is right', () => {
  const { cameras } = camerasOf();
  cameras.setMode('top');
  walked(cameras, 1, 3);
  const [[x0, y0], [x1, y1], [x2, y2]] = seenAt(cameras.top, [new Vector3(1, 3, 0), new Vector3(2, 3, 0), new Vector3(1, 4, 0)]);
  assert.ok(x1 > x0 && Math.abs(y1 - y0) < 1e-9 && y2 < y0 && Math.abs(x2 - x0) < 1e-9);
});

test('round about, all of the floor is in sight at first, on every screen and in rooms of all sizes', () => {
  for (const size of [[900, 600], [1920, 1080], [360, 740], [740, 360]]) {
    for (const scale of [0.5, 1, 10, 60]) {
      const bounds = new Box3(kRoom.min.clone(), new Vector3(-1 + 8 * scale, 2 + 6 * scale, 2.6));
      const { cameras } = camerasOf(bounds, size, 0.2 * size[1]);
      for (const [x, y, z] of seenAt(cameras.perspective, cornersOf(bounds)))
        assert.ok(x > -0.02 && x < 1.02 && y > -0.02 && y < 1.02 && z < 1, `${size} x ${scale}: ${x}, ${y}`);
    }
  }
});

test('the picture\'s middle is in the middle of what is not covered', () => {
  const { cameras } = camerasOf(kRoom, [900, 600], 150);
  const [[x, y]] = seenAt(cameras.perspective, [cameras.orbit.target]);
  near([x, y], [0.5, 225 / 600], 1e-6);
});

test('a camera that follows comes as near as the walker stands, by whatever frames', () => {
  for (const rate of [20, 60, 144]) {
    const { cameras } = camerasOf();
    cameras.setMode('follow');
    for (let i = 0; i < 2 * rate; ++i) walked(cameras, 2, 3, 1 / rate);
    near(cameras.orbit.target.toArray(), [2, 3, 0.9], 2e-3);
  }
});

test('how far it has come after a time does not depend on how many frames that took', () => {
  const left = [30, 60, 120].map((rate) => {
    const { cameras } = camerasOf();
    cameras.setMode('follow');
    for (let i = 0; i < 0.3 * rate; ++i) walked(cameras, 2, 3, 1 / rate);
    return cameras.orbit.target.x;
  });
  near(left, left.map(() => left[0]), 1e-6);
  assert.ok(left[0] > 1.5 && left[0] < 2);
});

test('it keeps its way and its distance to the walker, and jumps where he does', () => {
  const { cameras } = camerasOf();
  cameras.setMode('follow');
  const away = () => cameras.perspective.position.clone().sub(cameras.orbit.target);
  const before = away();
  near(before.length(), 5, 1e-6);
  walked(cameras, 1.4, 3.2);
  near(away().toArray(), before.toArray(), 1e-6);
  walked(cameras, 30, -20);  // another take
  near(cameras.orbit.target.toArray(), [30, -20, 0.9], 1e-9);
  near(away().toArray(), before.toArray(), 1e-6);
});

test('through a walker\'s eyes one looks where he faces, a little down, from before his head', () => {
  const random = seeded(33);
  const { cameras } = camerasOf();
  cameras.setMode('first');
  for (const heading of numbersIn(random, 20, -3.1, 3.1)) {
    walked(cameras, 2, 5, 1 / 60, heading);
    const way = cameras.eyes.getWorldDirection(new Vector3());
    near(Math.atan2(way.y, way.x), heading, 1e-6);
    assert.ok(way.z < 0 && way.z > -0.3);
    const off = cameras.eyes.position.clone().sub(new Vector3(2, 5, 1.7));
    near([off.x, off.y], [0.11 * Math.cos(heading), 0.11 * Math.sin(heading)], 1e-9);
  }
});

test('dragging turns the walker\'s head, to his shoulders and no further, and only in his eyes', () => {
  const { cameras, canvas } = camerasOf();
  const drag = (dx, dy) => {
    canvas.send('pointerdown', { clientX: 100, clientY: 100, pointerId: 1, pointerType: 'mouse', button: 0 });
    canvas.send('pointermove', { clientX: 100 + dx, clientY: 100 + dy, pointerId: 1, pointerType: 'mouse' });
    canvas.send('pointerup', { pointerId: 1, pointerType: 'mouse', button: 0 });
  };
  cameras.setMode('first');
  drag(100, -50);
  near([cameras.turned.yaw, cameras.turned.pitch], [0.4, -0.2], 1e-9);
  drag(-5000, 5000);
  near([cameras.turned.yaw, cameras.turned.pitch], [-1.6, 0.9], 1e-9);
  cameras.setMode('first');
  assert.deepEqual(cameras.turned, { yaw: 0, pitch: 0 });
});

test('each mode has its camera, and no other is moved by hand', () => {
  const { cameras } = camerasOf();
  const seen = kModes.map((mode) => {
    cameras.setMode(mode);
    return [cameras.current, cameras.orbit.enabled, cameras.plan.enabled];
  });
  assert.deepEqual(seen.map(([camera]) => camera), [cameras.perspective, cameras.perspective, cameras.top, cameras.eyes]);
  assert.deepEqual(seen.map(([, orbit, plan]) => [orbit, plan]), [[true, false], [true, false], [false, true], [false, false]]);
});

test('a window made narrower holds all as well, unless somebody has looked elsewhere', () => {
  const { cameras } = camerasOf();
  const distance = () => cameras.perspective.position.distanceTo(cameras.orbit.target);
  const wide = distance();
  cameras.resize(400, 600, 0);
  assert.ok(distance() > 1.2 * wide);
  cameras.resize(900, 600, 0);
  near(distance(), wide, 1e-6);
  cameras.orbit.dispatchEvent({ type: 'start' });
  cameras.perspective.position.z += 1;
  const moved = cameras.perspective.position.clone();
  cameras.resize(400, 600, 0);
  near(cameras.perspective.position.toArray(), moved.toArray(), 1e-9);
});
