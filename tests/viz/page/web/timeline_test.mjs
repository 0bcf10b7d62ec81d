import assert from 'node:assert/strict';
import test from 'node:test';
import { element } from './fake_dom.mjs';
import { madePage, madeTake } from './made_page.mjs';
import { near, seeded } from './seeded.mjs';

const { Player } = await import('../../../../viz/page/web/player.js');
const { Take } = await import('../../../../viz/page/web/take.js');
const { Timeline } = await import('../../../../viz/page/web/timeline.js');

const kLabels = 74, kEnd = 8;  // margins of the drawing [CSS pixels]

function timelineOf(more, width = 600) {
  const line = element('div'), canvas = element('canvas'), head = element('div');
  head.className = 'playhead';
  line.append(canvas, head);
  line.clientWidth = width;
  const player = new Player();
  player.setTake(new Take(madePage(), madeTake(more)));
  const timeline = new Timeline(line, player);
  timeline.draw();
  return { line, head, player, timeline, pen: canvas.getContext(), span: width - kLabels - kEnd };
}

const filled = (pen, color) => pen.calls.filter(({ name, fillStyle }) => name === 'roundRect' && fillStyle === color).map(({ values }) => values);
const placeOf = (head) => Number(/translateX\((.+)px\)/.exec(head.style.transform)[1]);

test('a press anywhere is the time of that place, and what is beside the line its ends', () => {
  const { line, player, span } = timelineOf({ frames: 101 });
  const random = seeded(20);
  for (let i = 0; i < 100; ++i) {
    player.play();
    const clientX = 900 * random() - 150;
    line.send('pointerdown', { clientX });
    near(player.time, 10 * Math.max(0, Math.min(1, (clientX - kLabels) / span)), 1e-9);
    assert.ok(!player.playing);
    line.send('pointerup');
  }
});

test('dragging goes on until the pointer is let go', () => {
  const { line, player, span } = timelineOf({ frames: 101 });
  line.send('pointermove', { clientX: kLabels + span / 2 });
  assert.equal(player.time, 0);
  line.send('pointerdown', { clientX: kLabels });
  line.send('pointermove', { clientX: kLabels + span / 4 });
  near(player.time, 2.5, 1e-9);
  line.send('pointercancel');
  line.send('pointermove', { clientX: kLabels + span });
  near(player.time, 2.5, 1e-9);
});

test('the play head stands where a press would give its time', () => {
  const { head, timeline, player, line } = timelineOf({ frames: 101 });
  for (const time of [0, 1.7, 10]) {
    player.seek(time);
    timeline.update();
    const place = placeOf(head);
    player.seek(5);
    line.send('pointerdown', { clientX: place });
    near(player.time, time, 1e-9);
  }
});

test('bars lie over the frames in which a foot stands, ticks at its events', () => {
  const planted = [[[0, 20], [50, 70]], [[15, 55]]];
  const events = [{ name: 'left strike', side: 0, frame: 50.5 }, { name: 'right lift', side: 1, frame: 15 }];
  const { pen, span } = timelineOf({ frames: 101, planted, events });
  const x = (frame) => kLabels + (span * frame) / 100;
  for (const [side, color] of [[0, '--left'], [1, '--right']]) {
    const bars = filled(pen, color);
    near(bars.flatMap(([left, , wide]) => [left, left + wide]), planted[side].flat().map(x), 1e-9);
  }
  const ticks = pen.calls.filter(({ name, fillStyle }) => name === 'fillRect' && fillStyle === '--text');
  near(ticks.map(({ values }) => values[0] + 0.5), [x(50.5), x(15)], 1e-9);
});

test('of an attempt that fails the line ends where it fails', () => {
  const stop = { frame: 40, part: 0, object: 0, at: [0, 0, 0] };
  const { pen, span, head, player, timeline } = timelineOf({ frames: 101, planted: [[[10, 90]], [[60, 80]]], stop });
  for (const [left, , wide] of [...filled(pen, '--left'), ...filled(pen, '--right')]) assert.ok(left + wide <= kLabels + span + 1e-9);
  assert.equal(filled(pen, '--right').length, 0);  // it would stand afterwards
  player.seek(99);
  timeline.update();
  near(placeOf(head), kLabels + span, 1e-9);
});

test('a row is there for what is known, and for nothing else', () => {
  const share = new Float32Array(11).fill(1);
  const clearance = { distance: new Float32Array(11).fill(0.2), points: new Float32Array(66), part: [], object: [] };
  const labels = ({ pen }) => pen.texts.filter((text) => !text.endsWith(' s'));
  assert.deepEqual(labels(timelineOf({})), []);
  assert.deepEqual(labels(timelineOf({ planted: [[[0, 3]], []] })), ['Left foot']);
  assert.deepEqual(labels(timelineOf({ planted: [[[0, 3]], [[4, 5]]], clearance, sources: [{ name: 'a', share }] })),
    ['Left foot', 'Right foot', 'Clearance', 'Motions']);
});

test('a row of captured motions is filled from below to above where their shares are one', () => {
  const shares = [0.25, 0.5, 0.25].map((value) => new Float32Array(11).fill(value));
  const { pen } = timelineOf({ sources: shares.map((share, i) => ({ name: `${i}`, share })) });
  const heights = pen.calls.filter(({ name }) => name === 'lineTo').map(({ values }) => values[1]);
  near([Math.max(...heights) - Math.min(...heights)], [13], 1e-6);
  assert.equal(new Set(heights.map((y) => y.toFixed(3))).size, 4);  // of three layers
});

test('what is far is high on the row of the nearest thing, and so is what nothing is near', () => {
  const distance = Float32Array.of(0, 0.25, 0.5, 3, -1);
  const { pen } = timelineOf({ frames: 5, clearance: { distance, points: new Float32Array(30), part: [], object: [] } });
  const heights = pen.calls.filter(({ name, fillStyle }) => name === 'lineTo' && fillStyle === '--accent').map(({ values }) => values[1]);
  near(heights.slice(0, 5), [13, 6.5, 0, 0, 0], 1e-5);
});

test('seconds are written from the beginning on, evenly, none over the next', () => {
  for (const [frames, frameTime, width] of [[11, 0.1, 600], [2000, 1 / 30, 280], [40, 1 / 120, 300], [90000, 0.1, 900], [2, 0.02, 400]]) {
    const { pen } = timelineOf({ frames, frameTime }, width);
    const seconds = pen.calls.filter(({ name, values }) => name === 'fillText' && String(values[0]).endsWith(' s'));
    const texts = seconds.map(({ values }) => values[0]), places = seconds.map(({ values }) => values[1]);
    assert.equal(texts[0], '0 s');
    assert.equal(new Set(texts).size, texts.length, texts.join());
    for (let i = 1; i < places.length; ++i) {
      assert.ok(places[i] - places[i - 1] >= 40, `${frames} frames: ${places}`);
      near(places[i] - places[i - 1], places[1] - places[0], 1e-6);
    }
  }
});
