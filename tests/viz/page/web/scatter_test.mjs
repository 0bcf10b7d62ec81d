import assert from 'node:assert/strict';
import test from 'node:test';
import { element } from './fake_dom.mjs';
import { near, numbersIn, seeded } from './seeded.mjs';

const { drawCharts } = await import('../../../../viz/page/web/scatter.js');

function drawn(charts) {
  const canvas = element('canvas');
  drawCharts(canvas, charts);
  return canvas.getContext();
}

const chartOf = (points, more = {}) => ({ x: ['speed', 'm/s'], y: ['step', 'm'], points, ...more });
const somePoints = (random, count) => numbersIn(random, count, 0.2, 2).map((x, i) => ({ x, y: 0.4 + 0.3 * x + 0.1 * random(), name: `walk-${i}` }));
const dots = (pen) => pen.calls.filter(({ name, values }) => name === 'arc' && values[2] < 10).map(({ values }) => values);

test('points keep their order and their proportions, along both axes', () => {
  const random = seeded(21), points = somePoints(random, 9);
  const found = dots(drawn([chartOf(points)]));
  const scale = (axis, key) => (found[1][axis] - found[0][axis]) / (points[1][key] - points[0][key]);
  assert.ok(scale(0, 'x') > 0 && scale(1, 'y') < 0);
  found.forEach((dot, i) => {
    near(dot[0] - found[0][0], (points[i].x - points[0].x) * scale(0, 'x'), 1e-6);
    near(dot[1] - found[0][1], (points[i].y - points[0].y) * scale(1, 'y'), 1e-6);
  });
});

test('a line through the points goes through them on the canvas as well', () => {
  const points = [0.5, 1, 1.5].map((x) => ({ x, y: 0.3 + 0.4 * x, name: `${x}` }));
  const line = { x: [0.25, 0.5, 1, 1.5, 2], y: [0.25, 0.5, 1, 1.5, 2].map((x) => 0.3 + 0.4 * x) };
  const pen = drawn([chartOf(points, { line })]);
  const places = pen.calls.filter(({ name, strokeStyle }) => name === 'lineTo' && strokeStyle === '--accent').map(({ values }) => values);
  assert.equal(places.length, 5);
  dots(pen).forEach(([x, y], i) => near([x, y], places[i + 1], 1e-6));
});

test('no name is written over another, and that of the chosen one always', () => {
  const random = seeded(22);
  const points = somePoints(random, 60);
  points[41].chosen = true;
  const pen = drawn([chartOf(points)]);
  const names = pen.calls.filter(({ name, values }) => name === 'fillText' && /^walk-/.test(values[0]))
    .map(({ values: [text, x, y], fillStyle }) => ({ text, x, y, fillStyle }));
  assert.ok(names.length > 5 && names.length < 60);
  const chosen = names.filter(({ fillStyle }) => fillStyle === '--text');
  assert.deepEqual(chosen.map(({ text }) => text), ['walk-41']);
  const others = names.filter((one) => one !== chosen[0]);
  for (const [i, a] of others.entries())
    for (const b of others.slice(i + 1))
      assert.ok(Math.abs(a.y - b.y) > 11 || a.x > b.x + 6 * b.text.length || b.x > a.x + 6 * a.text.length, `${a.text} ${b.text}`);
});

test('charts share the canvas: each keeps to its part', () => {
  const random = seeded(23);
  const pen = drawn([chartOf(somePoints(random, 5)), chartOf(somePoints(random, 5)), chartOf(somePoints(random, 5))]);
  dots(pen).forEach(([x], i) => assert.equal(Math.floor(x / 200), Math.floor(i / 5)));
});

test('one point, or points of one speed, are drawn in the middle', () => {
  for (const points of [[{ x: 1, y: 2, name: 'a' }], [{ x: 1, y: 2, name: 'a' }, { x: 1, y: 2, name: 'b' }]])
    for (const [x, y] of dots(drawn([chartOf(points)]))) near([x, y], [58 + (600 - 74) / 2, 12 + (300 - 48) / 2], 1e-6);
});

test('numbers along the axes are round and none of them is left of zero by rounding', () => {
  const points = [{ x: -0.3, y: -30, name: 'a' }, { x: 0.35, y: 31, name: 'b' }];
  const numbers = drawn([chartOf(points)]).texts.filter((text) => /^-?[0-9]/.test(text));
  assert.ok(numbers.includes('0') && numbers.includes('-0.2'), numbers.join());
  for (const text of numbers) assert.ok(text.length <= 5, text);
});
