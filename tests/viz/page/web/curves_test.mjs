import assert from 'node:assert/strict';
import test from 'node:test';
import { element } from './fake_dom.mjs';
import { near, numbersIn, seeded } from './seeded.mjs';

const { Curves, tickOf, valueAt } = await import('../../../../viz/page/web/curves.js');

const kLabels = 74, kEnd = 12;  // margins of the drawing [CSS pixels]

function curvesOf(panels = [], seek = () => {}) {
  const canvas = element('canvas');
  const curves = new Curves(canvas, { seek });
  curves.panels = panels;
  return { canvas, curves, pen: canvas.getContext() };
}

const panelOf = (curves, more = {}) => ({ label: 'angle', unit: '°', curves, ...more });
const lineOf = (values, more = {}) => ({ values, from: 0, step: 0.1, color: '--axis-x', label: 'X', ...more });

// Points of the curve that is drawn in this colour; its line in the legend is thicker.
function pointsOf(pen, color) {
  return pen.calls.filter(({ name, strokeStyle, lineWidth }) => name === 'lineTo' && strokeStyle === color && lineWidth === 1.6).map(({ values }) => values);
}

test('a tick is 1, 2 or 5 times a power of ten, the smallest that is not too small', () => {
  const random = seeded(13);
  for (const exponent of numbersIn(random, 500, -6, 6)) {
    const least = 10 ** exponent, tick = tickOf(least);
    const [digit] = tick.toExponential(6).split('e').map(Number);
    assert.ok([1, 2, 5].some((n) => Math.abs(digit - n) < 1e-5), `${tick}`);
    assert.ok(tick >= least * (1 - 1e-9) && tick < 2.5 * least * (1 + 1e-9), `${tick} of ${least}`);
  }
  for (const exact of [0.001, 0.2, 1, 50, 1e5]) near(tickOf(exact), exact, 1e-9 * exact);
});

test('of a curve between samples the value is on the line between them, beyond its ends it has none', () => {
  const random = seeded(14);
  for (let round = 0; round < 200; ++round) {
    const values = numbersIn(random, 2 + Math.floor(9 * random()), -5, 5), from = random(), step = 0.01 + random();
    const at = random() * (values.length - 1), low = Math.floor(at);
    near(valueAt({ values, from, step }, from + at * step), values[low] + (at - low) * (values[Math.min(low + 1, values.length - 1)] - values[low]), 1e-9);
    assert.equal(valueAt({ values, from, step }, from - 0.51 * step), undefined);
    assert.equal(valueAt({ values, from, step }, from + (values.length - 0.49) * step), undefined);
  }
  assert.equal(valueAt({ values: [], from: 0, step: 1 }, 0), undefined);
  assert.equal(valueAt({ values: [1], from: 0, step: 1 }, NaN), undefined);
});

test('places on the canvas and on the axis are each other\'s inverse', () => {
  const { curves } = curvesOf();
  const random = seeded(15);
  for (let round = 0; round < 50; ++round) {
    curves.fit(-random(), 5 * random());
    curves.zoom(random(), 0.3);
    const x = kLabels + random() * curves.span;
    near(curves.xOf(curves.axisAt(x)), x, 1e-9);
  }
});

test('what is zoomed about stays where it is, unless an end of the whole comes in sight', () => {
  const { curves } = curvesOf();
  const random = seeded(16);
  for (let round = 0; round < 100; ++round) {
    curves.fit(0, 20);
    curves.zoom(0.3, 10);
    const about = curves.range[0] + random() * curves.length, x = curves.xOf(about);
    curves.zoom(0.2 + 0.8 * random(), about);
    near(curves.xOf(about), x, 1e-6);
    const length = curves.length;
    curves.zoom(1.1, about);
    near(curves.length, 1.1 * length, 1e-9);
  }
});

test('whatever is zoomed, moved and sought, what is shown lies within the whole and is not empty', () => {
  let sought = [];
  const { curves, canvas } = curvesOf([], (at) => sought.push(at));
  const random = seeded(17);
  curves.fit(0, 12);
  const acts = [
    () => canvas.send('wheel', { deltaX: 0, deltaY: 800 * random() - 400, offsetX: 600 * random() }),
    () => canvas.send('wheel', { deltaX: 0, deltaY: 800 * random() - 400, offsetX: 600 * random(), shiftKey: true }),
    () => canvas.send('wheel', { deltaX: 900 * random() - 450, deltaY: 1, offsetX: 600 * random() }),
    () => canvas.send('pointerdown', { pointerId: 1, offsetX: 900 * random() - 150, button: 0 }),
    () => canvas.send('pointermove', { pointerId: 1, offsetX: 900 * random() - 150 }),
    () => canvas.send('pointerup', { pointerId: 1 }),
    () => canvas.send('pointerdown', { pointerId: 2, offsetX: 600 * random(), button: 2 }),
    () => canvas.send('pointermove', { pointerId: 2, offsetX: 600 * random() }),
    () => canvas.send('pointercancel', { pointerId: 2 }),
    () => curves.setTime(12 * random()),
  ];
  for (let i = 0; i < 3000; ++i) {
    const act = acts[Math.floor(random() * acts.length)];
    act();
    assert.ok(curves.range[0] >= -1e-9 && curves.range[1] <= 12 + 1e-9 && curves.length >= 0.05 - 1e-9, `${act}: ${curves.range}`);
  }
  assert.ok(sought.length > 100);
  for (const at of sought) assert.ok(at >= 0 && at <= 12);
  canvas.send('dblclick');
  assert.deepEqual(curves.range, [0, 12]);
});

test('two fingers that part by half as far again show as much less', () => {
  const { curves, canvas } = curvesOf();
  curves.fit(0, 10);
  canvas.send('pointerdown', { pointerId: 1, offsetX: 200, button: 0 });
  canvas.send('pointerdown', { pointerId: 2, offsetX: 300, button: 0 });
  canvas.send('pointermove', { pointerId: 2, offsetX: 350 });
  near(curves.length, 10 / 1.5, 1e-9);
});

test('the cursor that leaves what is shown takes it along', () => {
  const { curves } = curvesOf();
  curves.fit(0, 10);
  curves.zoom(0.1, 2);
  for (const at of [7, 0.1, 9.99, 3]) {
    curves.setTime(at);
    assert.ok(curves.range[0] <= at && at <= curves.range[1]);
    near(curves.length, 1, 1e-9);
  }
});

test('a curve is drawn within its panel from low to high, however many samples it has', () => {
  const random = seeded(18);
  for (const count of [2, 40, 5000]) {
    const values = numbersIn(random, count, -30, 50);
    const { curves, pen } = curvesOf([panelOf([lineOf(values, { step: 10 / (count - 1) })])]);
    curves.fit(0, 10);
    const points = pointsOf(pen, '--axis-x');
    assert.ok(points.length >= Math.min(count, 500) && points.length <= 601, `${points.length}`);
    for (const [x, y] of points) assert.ok(x >= kLabels - 1 && x <= 600 - kEnd + 1 && y >= 0 && y <= 300, [x, y]);
    points.reduce((before, [x]) => {
      assert.ok(x >= before);
      return x;
    }, 0);
  }
});

test('higher values are drawn higher, in proportion', () => {
  const { curves, pen } = curvesOf([panelOf([lineOf([0, 10, 5, 2.5], { step: 1 })])]);
  curves.fit(0, 3);
  const at = (value) => pointsOf(pen, '--axis-x').find(([x]) => Math.abs(x - curves.xOf(value)) < 0.51)[1];
  const [y0, y1, y2, y3] = [0, 1, 2, 3].map(at);
  assert.ok(y1 < y2 && y2 < y3 && y3 < y0);
  near((y0 - y2) / (y0 - y1), 0.5, 0.01);
  near((y0 - y3) / (y0 - y1), 0.25, 0.01);
});

test('numbers on the axes are round, none of them is what rounding has left of zero', () => {
  const random = seeded(19);
  for (let round = 0; round < 200; ++round) {
    const size = 10 ** (6 * random() - 3);
    const { curves, pen } = curvesOf([panelOf([lineOf([-size * random(), size * random()], { label: '' })])]);
    curves.fit(0, 0.1);
    for (const text of pen.texts.filter((one) => !/angle|s$/.test(one))) {
      assert.ok(!/e-1[0-9]/.test(text), text);
      assert.ok(Number(text) === 0 || Math.abs(Number(text)) >= 1e-3 * size * 0.05, `${text} of ${size}`);
    }
  }
});

test('the axis\' numbers are all different, as fine as one may look', () => {
  const { curves, pen } = curvesOf();
  for (const length of [1e-3, 0.05, 0.4, 7, 300, 4000]) {
    curves.fit(0, length);
    const texts = pen.texts;
    assert.equal(new Set(texts).size, texts.length, texts.join());
    assert.ok(texts.length >= 2, `${length}`);
  }
});

test('a curve in another\'s time is looked up where that says', () => {
  const values = Array.from({ length: 101 }, (_, i) => i / 10);
  const { curves, pen } = curvesOf([panelOf([
    lineOf(values), lineOf(values, { color: '--second', map: (time) => time / 2, label: '' }),
  ])]);
  curves.fit(0, 10);
  const slopeOf = ([[x0, y0], ...more]) => (more.at(-1)[1] - y0) / (more.at(-1)[0] - x0);
  const [own, second] = ['--axis-x', '--second'].map((color) => slopeOf(pointsOf(pen, color)));
  assert.ok(own < 0);
  near(second / own, 0.5, 1e-3);
});

test('values at the cursor are said, with the digits of the panel; beyond its ends a curve has but its name', () => {
  const { curves, pen } = curvesOf([panelOf([lineOf([1, 2, 3]), lineOf([9], { from: 5, label: 'late' })], { digits: 2 })]);
  curves.fit(0, 10);
  curves.setTime(0.05);
  assert.ok(pen.texts.includes('X 1.50'));
  assert.ok(pen.texts.includes('late'));
});

test('where nothing can be drawn nothing fails: no samples, no panels, a canvas that is not shown', () => {
  for (const panels of [[], [panelOf([])], [panelOf([lineOf([])])], [panelOf([lineOf([NaN, NaN])], { limits: [{ value: NaN, color: '--left' }] })]]) {
    const { curves, canvas } = curvesOf(panels);
    curves.fit(0, 0);
    canvas.clientWidth = 0;
    curves.draw();
  }
});

test('bars are drawn where they are, and those that are too short are still seen', () => {
  const { curves, pen } = curvesOf([{ row: true, label: 'Left foot', color: '--left', bars: [[1, 3], [5, 5.0001]] }]);
  curves.fit(0, 10);
  const bars = pen.calls.filter(({ name, fillStyle }) => name === 'roundRect' && fillStyle === '--left').map(({ values }) => values);
  near(bars.map(([x]) => x), [curves.xOf(1), curves.xOf(5)], 1e-9);
  near(bars.map(([, , wide]) => wide), [curves.xOf(3) - curves.xOf(1), 2], 1e-9);
});
