import assert from 'node:assert/strict';
import test from 'node:test';
import { Group, PerspectiveCamera, Vector3 } from 'three';
import { element } from './fake_dom.mjs';
import { madePage, madeTake } from './made_page.mjs';
import { near, numbersIn, seeded } from './seeded.mjs';

const { Layers } = await import('../../../../viz/page/web/layers.js');
const { Nearest } = await import('../../../../viz/page/web/nearest.js');
const { Take } = await import('../../../../viz/page/web/take.js');

const label = document.getElementById('nearest-label');
label.append(element('span'));
const kCanvas = { clientWidth: 800, clientHeight: 600 };

// From (0, -10, 1) along y.
function camera() {
  const one = new PerspectiveCamera(40, 800 / 600, 0.1, 100);
  one.up.set(0, 0, 1);
  one.position.set(0, -10, 1);
  one.lookAt(0, 0, 1);
  one.updateMatrixWorld();
  return one;
}

const kWalk = {
  start: { at: [1, 1, 0], heading: 0.5 }, goal: { at: [3, 1, 0.2], heading: null }, via: [{ at: [2, 2, 0], heading: null }],
  roadmap: { nodes: [], edges: [] }, attempts: [], reached: null, room_to_walk: null, obstruction: null,
};
const kPrints = [0, 1, 2].map((i) => ({
  outline: [[i, 0], [i + 0.2, 0], [i + 0.2, 0.1], [i, 0.1]], side: i % 2, at: [i + 0.1, 0.05, 0.25 * i], heading: 0, first: 10 * i, last: 10 * i + 14,
}));
const kSomeBody = { body: { parts: [{}], joints: [] } };

function layersOf(page = {}, takes = [{ frames: 41, prints: kPrints }]) {
  const shown = [];
  const made = madePage({ actors: [kSomeBody], takes: takes.map(madeTake), ...page });
  const viewer = {
    stage: { overlays: new Group() }, actors: [{ show: (parts) => shown.push({ ...parts }) }], room: { walls: page.walls ?? [], gives: true },
    pose() {}, reshade() {}, cameras: { current: camera() }, canvas: kCanvas,
  };
  const layers = new Layers(made, viewer);
  if (takes.length > 0) layers.showTake(new Take(made, made.takes[0]));
  return { layers, viewer, shown, keys: layers.list.map(({ key }) => key) };
}

test('a layer is offered where there is something to be seen, and only there', () => {
  const ground = { breadth: 0.1, strips: Float32Array.of(0, 0, 0, 1, 0, 0), kind: Uint8Array.of(0) };
  const line = Float32Array.of(0, 0, 0, 1, 0, 0);
  assert.deepEqual(layersOf({ actors: [] }, []).keys, []);
  assert.deepEqual(layersOf().keys, ['body', 'capsules', 'bones', 'path', 'prints']);
  assert.deepEqual(layersOf({ actors: [{ body: { parts: [] } }] }, [{}]).keys, ['bones', 'path']);
  assert.ok(layersOf({ walk: { ...kWalk, roadmap: { nodes: [{ at: [0, 0, 0], heading: 0, connector: true }], edges: [] } } }).keys.includes('roadmap'));
  assert.ok(layersOf({ walk: { ...kWalk, attempts: [{ line, at: [1, 0, 0], what: '', take: null }] } }).keys.includes('attempts'));
  const both = layersOf({ walk: { ...kWalk, reached: ground, room_to_walk: ground }, walls: [{}] }).keys;
  for (const key of ['reached', 'room', 'walls']) assert.ok(both.includes(key), key);
  const clearance = { distance: new Float32Array(11), points: new Float32Array(66), part: [], object: [] };
  assert.ok(layersOf({}, [{ clearance }]).keys.includes('nearest'));
});

test('a layer that is switched is seen or not, the others stay as they are', () => {
  const { layers, keys } = layersOf();
  const seen = () => ['path', 'prints'].map((name) => layers.groups[name].visible);
  assert.deepEqual(seen(), [true, true]);
  layers.set('path', false);
  assert.deepEqual(seen(), [false, true]);
  layers.set('prints', false);
  layers.set('path', true);
  assert.deepEqual(seen(), [true, false]);
  assert.deepEqual(layers.list.filter(({ on }) => !on).map(({ key }) => key), keys.filter((key) => ['capsules', 'bones', 'prints'].includes(key)));
});

test('body, capsules and bones are told to everybody that there is', () => {
  const { layers, shown } = layersOf();
  layers.set('capsules', true);
  layers.set('body', false);
  assert.deepEqual(shown.at(-1), { body: false, capsules: true, bones: false });
});

test('where no walk was found the roadmap and what was refused are seen from the first', () => {
  const walk = { ...kWalk, roadmap: { nodes: [{ at: [0, 0, 0], heading: 0, connector: false }], edges: [] } };
  const attempts = [{ line: Float32Array.of(0, 0, 0, 1, 0, 0), at: [1, 0, 0], what: '', take: null }];
  const on = (page, takes) => new Map(layersOf(page, takes).layers.list.map(({ key, on: is }) => [key, is]));
  const found = on({ walk: { ...walk, attempts } }), none = on({ walk: { ...walk, attempts }, why: 'no' }, []);
  assert.deepEqual([found.get('roadmap'), found.get('attempts')], [false, false]);
  assert.deepEqual([none.get('roadmap'), none.get('attempts')], [true, true]);
});

test('a print is strong while its foot stands, and lies where the shoe came down', () => {
  const { layers } = layersOf();
  for (let frame = 0; frame <= 40; ++frame) {
    layers.update(frame * 0.1);
    layers.prints.forEach((mesh, i) => {
      const stands = frame >= kPrints[i].first && frame <= kPrints[i].last;
      assert.equal(mesh.material, (stands ? layers.strong : layers.faint)[kPrints[i].side], `${frame} ${i}`);
    });
  }
  layers.prints.forEach((mesh, i) => near(mesh.position.z, kPrints[i].at[2] + 0.004, 1e-9));
});

test('another take has its own path and prints, those before are gone', () => {
  const { layers } = layersOf();
  layers.showTake(new Take(madePage(), madeTake({ prints: kPrints.slice(0, 1) })));
  assert.equal(layers.groups.prints.children.length, 1);
  assert.equal(layers.groups.path.children.length, 1);
});

test('start, goal and places between are marked where they are, with an arrow where a heading is asked for', () => {
  const { layers } = layersOf({ walk: kWalk });
  const marks = layers.groups.places.children;
  near(marks.map(({ position }) => position.toArray()).flat(), [kWalk.start.at, kWalk.start.at, kWalk.goal.at, kWalk.via[0].at].flat(), 1e-9);
  near(marks[1].rotation.z, 0.5, 1e-9);
});

test('a pin stands where something was touched, and nowhere else', () => {
  const { layers } = layersOf({ walk: kWalk });
  assert.ok(!layers.pin.visible);
  layers.mark([1, 2, 0.7]);
  assert.ok(layers.pin.visible);
  near(layers.pin.position.toArray(), [1, 2, 0.7], 1e-9);
  layers.mark(null);
  assert.ok(!layers.pin.visible);
});

function nearestOf(distance, points) {
  const nearest = new Nearest(new Group(), label);
  nearest.setTake({ clearance: { distance: Float32Array.from(distance), points: Float32Array.from(points) } });
  return nearest;
}

test('the nearest thing is shown by a line from point to point, its label in the middle of it', () => {
  const random = seeded(44);
  const points = numbersIn(random, 60, -2, 2), one = camera();
  const nearest = nearestOf(new Array(10).fill(0.3), points);
  for (let frame = 0; frame < 10; ++frame) {
    nearest.update(frame, one, kCanvas);
    near(nearest.line.geometry.attributes.position.array, points.slice(6 * frame, 6 * frame + 6), 1e-6);
    const middle = new Vector3(0, 1, 2).set(...[0, 1, 2].map((i) => (points[6 * frame + i] + points[6 * frame + 3 + i]) / 2)).project(one);
    const [x, y] = label.style.transform.match(/-?[0-9.]+/g).map(Number);
    near([x, y], [400 * (middle.x + 1), 300 * (1 - middle.y)], 0.06);
    assert.ok(!label.hidden && nearest.line.visible);
  }
});

test('its length is said in centimetres below a metre, in metres above', () => {
  for (const [distance, text] of [[0, '0.0 cm'], [0.0123, '1.2 cm'], [0.5, '50.0 cm'], [1, '1.00 m'], [2.345, '2.35 m']]) {
    nearestOf([distance], [0, 0, 1, 0.1, 0, 1]).update(0, camera(), kCanvas);
    assert.ok(Math.abs(parseFloat(label.firstElementChild.textContent) - parseFloat(text)) < 0.011, label.firstElementChild.textContent);
    assert.equal(label.firstElementChild.textContent.split(' ')[1], text.split(' ')[1]);
  }
});

test('where nothing is near, behind the camera, or switched off, there is no label', () => {
  const nearest = nearestOf([-1, 0.3, 0.3], [0, 0, 1, 0, 0, 1, 0, -20, 1, 0, -20, 1, 0, 0, 1, 0, 0, 1]);
  const hidden = (frame) => {
    nearest.update(frame, camera(), kCanvas);
    return label.hidden;
  };
  assert.deepEqual([hidden(0), hidden(1), hidden(2)], [true, true, false]);
  nearest.show(false);
  assert.ok(label.hidden && !nearest.line.visible);
  assert.ok(hidden(2));
});
