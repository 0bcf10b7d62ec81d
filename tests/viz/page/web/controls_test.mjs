import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { element, forgetElements } from './fake_dom.mjs';
import { madePage, madeTake } from './made_page.mjs';
import { near } from './seeded.mjs';

// Questions to the browser about its window; `ask` answers them anew.
const queries = new Map();
globalThis.matchMedia = (query) => {
  if (!queries.has(query)) queries.set(query, Object.assign(new EventTarget(), { matches: false }));
  return queries.get(query);
};
function ask(part, matches) {
  const [, query] = [...queries].find(([text]) => text.includes(part));
  query.matches = matches;
  query.dispatchEvent(new Event('change'));
}
globalThis.window = new EventTarget();
globalThis.location = { hash: '' };
globalThis.history = { replaceState: (state, title, hash) => (location.hash = hash) };

const { Controls } = await import('../../../../viz/page/web/controls.js');
const { kSpeeds, Player } = await import('../../../../viz/page/web/player.js');
const { Take } = await import('../../../../viz/page/web/take.js');

// A viewer without anything to be seen: what is done to it is written down.
function viewerOf(page, takes) {
  const done = [];
  const viewer = {
    page, done, takes, actors: [], index: 0, listeners: [], player: new Player(), canvas: element('canvas'), stage: { setTheme: (theme) => done.push(theme) },
    layers: { list: [{ key: 'body', label: 'Body', on: true }], set: (key, on) => done.push(`${key} ${on}`) },
    cameras: { mode: 'orbit', frameAll: () => done.push('frame'), setMode: (mode) => (viewer.cameras.mode = mode) },
    resize() {},
    show(index) {
      viewer.index = index;
      viewer.take = takes[index];
      viewer.player.setTake(viewer.take);
      for (const listener of viewer.listeners) listener();
    },
  };
  if (takes.length > 0) viewer.show(0);
  return viewer;
}

const byId = (id) => document.getElementById(id);
const kPlanted = [[[0, 9], [20, 31]], [[8, 21], [30, 40]]];
let controls;

// A page anew; those before hear no more keys.
function begin({ page = {}, takes = [{ frames: 41, planted: kPlanted }, { frames: 21, name: 'Edge 1 → 2' }], hash = '' } = {}) {
  forgetElements();
  queries.clear();
  const head = element('div');
  head.className = 'playhead';
  byId('timeline').append(element('canvas'), head);
  const made = madePage(page);
  const viewer = viewerOf(made, takes.map((take) => new Take(made, madeTake(take))));
  location.hash = hash;
  const listening = document.addEventListener;
  document.addEventListener = (kind, act) => listening.call(document, kind, (event) => controls.viewer === viewer && act(event));
  controls = new Controls(viewer, document);
  controls.begin();
  document.addEventListener = listening;
  return viewer;
}

// @param at  the element in which it is pressed
function press(key, more = {}, at = 'BODY') {
  const event = Object.assign(new Event('keydown', { cancelable: true }), { key, ...more });
  Object.defineProperty(event, 'target', { value: { tagName: at } });
  document.dispatchEvent(event);
  return event;
}

test('every key of the page\'s own list does something, as a capital as well', () => {
  const html = readFileSync(new URL('../../../../viz/page/web/page.html', import.meta.url), 'utf8');
  const said = [...html.matchAll(/<kbd>(.+?)<\/kbd>/g)].map(([, key]) => key).filter((key) => key !== 'Shift');
  assert.ok(said.length >= 12);
  const names = { Space: ' ', '←': 'ArrowLeft', '→': 'ArrowRight', Esc: 'Escape' };
  begin();
  for (const key of said) assert.ok(press(names[key] ?? key).defaultPrevented, key);
});

test('keys are the browser\'s own with Ctrl, Alt or the command key, and those that mean nothing always', () => {
  const viewer = begin({ hash: '#t=1' });
  for (const more of [{ ctrlKey: true }, { altKey: true }, { metaKey: true }]) assert.ok(!press('l', more).defaultPrevented);
  for (const key of ['q', 'F5', 'Tab', 'Enter']) assert.ok(!press(key).defaultPrevented, key);
  byId('keys').open = true;
  assert.ok(!press(' ').defaultPrevented);
  byId('keys').open = false;
  assert.ok(!viewer.player.playing);
});

test('a space on a button presses that button, an arrow in a list of speeds chooses there', () => {
  const viewer = begin({ hash: '#t=1' });
  for (const at of ['BUTTON', 'INPUT', 'SELECT']) assert.ok(!press(' ', {}, at).defaultPrevented, at);
  assert.ok(!press('ArrowRight', {}, 'SELECT').defaultPrevented);
  near(viewer.player.time, 1, 1e-12);
  assert.ok(press('ArrowRight', {}, 'BUTTON').defaultPrevented);
  near(viewer.player.time, 1.1, 1e-12);
});

test('arrows are frames, with shift steps; home and end are the ends', () => {
  const viewer = begin({ hash: '#t=1' });
  const at = (key, more) => {
    press(key, more);
    return viewer.take.frameAt(viewer.player.time);
  };
  assert.deepEqual([at('ArrowRight'), at('.'), at('ArrowLeft'), at(',')], [11, 12, 11, 10]);
  assert.deepEqual([at('ArrowRight', { shiftKey: true }), at(']'), at('ArrowLeft', { shiftKey: true }), at('[')], [20, 30, 20, 8]);
  assert.deepEqual([at('End'), at('ArrowRight'), at('Home'), at('ArrowLeft')], [40, 40, 0, 0]);
});

test('speeds go one up or down, to the fastest and the slowest, and the list shows which', () => {
  const viewer = begin({ hash: '#t=0' });
  const speeds = [];
  for (const key of ['+', '+', '+', '-', '-', '-', '-', '-', '-', '-']) {
    press(key);
    speeds.push(viewer.player.speed);
    assert.equal(Number(byId('speed').value), viewer.player.speed);
  }
  assert.equal(Math.max(...speeds), kSpeeds.at(-1));
  assert.equal(speeds.at(-1), kSpeeds[0]);
  byId('speed').value = '0.5';
  byId('speed').send('change');
  assert.equal(viewer.player.speed, 0.5);
});

test('a time in the address is shown, and stands; what is no time is not', () => {
  for (const [hash, time] of [['#t=3.2', 3.2], ['#t=.5', 0.5], ['#t=0', 0], ['#t=99', 4]]) {
    const viewer = begin({ hash });
    near(viewer.player.time, time, 1e-12, hash);
    assert.ok(!viewer.player.playing, hash);
  }
  for (const hash of ['', '#t=', '#t=-1', '#t=1e9', '#t=x', '#t=1.2.3', '#other']) assert.ok(begin({ hash }).player.playing, hash);
  const viewer = begin({ hash: '#t=1' });
  location.hash = '#t=2.5';
  window.dispatchEvent(new Event('hashchange'));
  near(viewer.player.time, 2.5, 1e-12);
});

test('where one halts is kept in the address, which shows that moment again', async () => {
  const viewer = begin({ hash: '#t=0' });
  for (const time of [1.23456, 3.9999, 0.001]) {
    viewer.player.seek(time);
    await new Promise((resolve) => setTimeout(resolve, 350));
    near(begin({ hash: location.hash }).player.time, time, 5.1e-4, location.hash);
    controls.viewer = viewer;
    viewer.player.changed = () => controls.refresh();
    controls.player = viewer.player;
  }
});

test('the panel of layers is open where there is room beside the picture, and goes with a phone that is turned', () => {
  begin();
  const open = () => [byId('layers').classList.has('open'), byId('layers-toggle').getAttribute('aria-expanded')];
  for (const wide of [true, false, true, false]) {
    ask('min-width', wide);
    assert.deepEqual(open(), [wide, String(wide)]);
  }
  press('l');
  assert.deepEqual(open(), [true, 'true']);
  ask('min-width', true);
  ask('min-width', false);
  assert.deepEqual(open(), [false, 'false']);
});

test('a box in the panel of layers switches its layer', () => {
  const viewer = begin();
  const box = byId('layer-list').all.find(({ id }) => id === 'layer-body');
  assert.ok(box.checked);
  box.checked = false;
  box.send('change');
  assert.ok(viewer.done.includes('body false'));
});

test('a camera is pressed that looks, by its button or its number; orbit once more shows all', () => {
  const viewer = begin();
  ['orbit', 'follow', 'top', 'first'].forEach((mode, i, all) => {
    press(String(i + 1));
    assert.equal(viewer.cameras.mode, mode);
    assert.deepEqual(all.map((one) => byId(`camera-${one}`).getAttribute('aria-pressed')), all.map((one) => String(one === mode)));
  });
  viewer.done.length = 0;
  byId('camera-orbit').click();
  assert.deepEqual(viewer.done, []);
  byId('camera-orbit').click();
  assert.deepEqual(viewer.done, ['frame']);
});

test('the theme is the system\'s until somebody chooses one', () => {
  const viewer = begin();
  const theme = () => [document.documentElement.dataset.theme, viewer.done.at(-1)];
  ask('dark', true);
  assert.deepEqual(theme(), ['dark', 'dark']);
  ask('dark', false);
  assert.deepEqual(theme(), ['light', 'light']);
  byId('theme').click();
  assert.deepEqual(theme(), ['dark', 'dark']);
  ask('dark', false);
  assert.deepEqual(theme(), ['dark', 'dark']);
});

test('an edge that is played is named, and one gets back to the walk', () => {
  const viewer = begin();
  assert.deepEqual([byId('take-name').textContent, byId('back').hidden], ['', true]);
  viewer.show(1);
  assert.deepEqual([byId('take-name').textContent, byId('back').hidden], ['Edge 1 → 2', false]);
  press('Escape');
  assert.deepEqual([viewer.index, byId('back').hidden], [0, true]);
});

test('an attempt that fails is shown where it fails, whatever the address says', () => {
  const viewer = begin({ takes: [{ frames: 30, stop: { frame: 12, part: 0, object: 0, at: [0, 0, 0] } }], hash: '#t=0.3', page: { why: 'the gap is too narrow' } });
  near(viewer.player.time, 1.2, 1e-12);
  assert.deepEqual([byId('why').textContent, byId('why').hidden, byId('back').textContent], ['the gap is too narrow', false, 'Back']);
});

test('without a motion there is nothing to be played, and keys do nothing', () => {
  begin({ takes: [] });
  assert.ok(byId('transport').hidden);
  assert.ok(byId('camera-follow').hidden && byId('camera-first').hidden);
  for (const key of [' ', 'ArrowRight', 'Home', '2']) assert.ok(!press(key).defaultPrevented);
});

test('times are said by what is read: seconds to a hundredth, frames of the file', () => {
  const viewer = begin({ takes: [{ frames: 41, every: 3 }], hash: '#t=1.26' });
  controls.showTime();
  assert.equal(byId('time').textContent, '1.26 / 4.00 s');
  assert.equal(byId('frame').textContent, 'frame 39');
  assert.equal(byId('timeline').getAttribute('aria-valuenow'), '1.26');
  assert.equal(byId('timeline').getAttribute('aria-valuetext'), '1.26 seconds, frame 39');
  assert.equal(viewer.player.time, 1.26);
});

test('a room that is shown with fewer triangles says so, in a length that reads', () => {
  const noteOf = (room) => {
    begin({ page: { room, notes: ['another'] } });
    return byId('notes').children.map((note) => note.textContent);
  };
  assert.deepEqual(noteOf({ thinned: 0, triangles: 10, shown: 10 }), ['another']);
  for (const [thinned, text] of [[0.0123, '1.2 cm'], [0.3, '30 cm'], [1.5, '1.5 m'], [40, '40.0 m']]) {
    const [note] = noteOf({ thinned, triangles: 1234567, shown: 150000 });
    assert.ok(note.includes(`of up to ${text} are`) && note.includes('1,234,567'), note);
  }
});

test('what is said beside the picture is written as it is, never as a page\'s own words', () => {
  const nasty = '<b>"&\u2028';
  begin({ page: { title: nasty, facts: [[nasty, nasty]], notes: [nasty] } });
  assert.equal(byId('title').textContent, nasty);
  assert.deepEqual(byId('facts').children.map((one) => one.textContent), [nasty, nasty]);
});
