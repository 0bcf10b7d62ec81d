// What `amble plan` and `amble view` write, in headless Chromium.
//   node pages.mjs AMBLE CHROMIUM WEB SOURCE WORK
// Ends with status 1 where a claim does not hold, after all of them have been tried.

import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync, statSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { tryBench } from './bench.mjs';
import { tryReport, tryTurned } from './phone.mjs';

const [, , amble, chromium, web, source, work] = process.argv;
const require = createRequire(join(web, 'package.json'));
const { chromium: browsers } = require('playwright-core');

let failed = 0;
function claim(what, holds, found = '') {
  if (!holds) ++failed;
  console.log(`${holds ? 'holds ' : 'FAILS '} ${what}${holds || found === '' ? '' : `: ${found}`}`);
}

function plan(scenario) {
  const folder = join(work, scenario);
  const file = join(source, 'scenarios', `${scenario}.yaml`);
  try {
    execFileSync(amble, ['plan', file, '-o', folder, '--formats', 'bvh,json,html,png,svg,report'], { stdio: 'pipe' });
  } catch (error) {
    if (error.status !== 1) throw error;  // 1: there is no walk
  }
  return folder;
}

// Joints of every frame in World, by three.js' own loader [m].
async function jointsOfBvh(file) {
  const three = pathToFileURL(join(web, 'node_modules/three/'));
  const THREE = await import(new URL('build/three.module.js', three));
  const { BVHLoader } = await import(new URL('examples/jsm/loaders/BVHLoader.js', three));
  const { skeleton, clip } = new BVHLoader().parse(readFileSync(file, 'utf8'));
  const tracks = new Map(clip.tracks.map((track) => [track.name, track]));
  const frames = clip.tracks[0].times.length;
  const p = new THREE.Vector3();
  return Array.from({ length: frames }, (_, frame) => {
    for (const bone of skeleton.bones) {
      const position = tracks.get(`${bone.name}.position`);
      const rotation = tracks.get(`${bone.name}.quaternion`);
      if (position) bone.position.fromArray(position.values, 3 * frame);
      if (rotation) bone.quaternion.fromArray(rotation.values, 4 * frame);
    }
    skeleton.bones[0].updateMatrixWorld(true);
    return skeleton.bones
      .filter((bone) => bone.name !== 'ENDSITE')
      .map((bone) => [bone.name, p.setFromMatrixPosition(bone.matrixWorld).x, -p.z, p.y]);
  });
}

// The same as the page poses them.
const jointsOfPage = () =>
  Array.from({ length: window.amble.take.frames }, (_, frame) => {
    const { actor, take } = window.amble;
    actor.pose(take, frame * take.frameTime);
    return actor.bones.map((bone) => [bone.name, ...bone.matrixWorld.elements.slice(12, 15)]);
  });

function farthest(a, b) {
  let most = a.length === b.length ? 0 : Infinity;
  for (let frame = 0; frame < Math.min(a.length, b.length); ++frame) {
    if (a[frame].length !== b[frame].length) return Infinity;
    a[frame].forEach(([name, ...p], joint) => {
      const [other, ...q] = b[frame][joint];
      most = Math.max(most, name === other ? Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) : Infinity);
    });
  }
  return most;
}

const said = [];
async function open(context, file, hash = '') {
  const page = await context.newPage();
  page.setDefaultTimeout(120_000);  // of a machine that does other things beside
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) said.push(`${file}: ${message.text()}`);
  });
  page.on('pageerror', (error) => said.push(`${file}: ${error.message}`));
  page.on('request', (request) => {
    if (!/^(file|data):/.test(request.url())) said.push(`${file} asks for ${request.url()}`);
  });
  await page.goto(pathToFileURL(file).href + hash);
  await page.waitForFunction(() => window.amble);
  return page;
}

// Pixels of the picture, few of them, and the label in it: what is told apart when something is switched.
const picture = () => {
  const { stage, cameras } = window.amble;
  window.amble.frame(0);
  stage.render(cameras.current);
  const small = document.createElement('canvas');
  [small.width, small.height] = [160, 100];
  const c = small.getContext('2d', { willReadFrequently: true });
  c.drawImage(stage.renderer.domElement, 0, 0, 160, 100);
  let sum = document.getElementById('nearest-label').hidden ? 1 : 2;
  const { data } = c.getImageData(0, 0, 160, 100);
  for (let i = 0; i < data.length; ++i) sum = (sum * 31 + data[i]) % 4294967291;
  return sum;
};

async function tryWalk(context, folder) {
  const file = join(folder, 'walk.html');
  claim('the living room has 3 MB or less', statSync(file).size <= 3e6, statSync(file).size);
  const page = await open(context, file, '#t=3.2');
  const time = await page.evaluate(() => [window.amble.player.time, window.amble.player.playing]);
  claim('#t=3.2 shows that moment, and stands', time[0] === 3.2 && !time[1], time);
  const away = farthest(await page.evaluate(jointsOfPage), await jointsOfBvh(join(folder, 'walk.bvh')));
  claim('page and BVH agree on every joint to 0.1 mm at every frame', away <= 1e-4, away);
  await tryPlaying(page);
  await tryLayers(page);
  await tryCameras(page);
  await tryEdges(page);
  await page.close();
}

async function tryPlaying(page) {
  const at = () => page.evaluate(() => window.amble.actor.root.matrixWorld.elements.slice(12, 15));
  await page.keyboard.press('Home');
  const begin = await at();
  await page.click('#play');
  await page.waitForFunction(() => window.amble.player.time > 1);
  const later = await at();
  claim('play moves the body', Math.hypot(later[0] - begin[0], later[1] - begin[1]) > 0.1, later);
  await page.keyboard.press(' ');
  claim('the space bar halts it', await page.evaluate(() => !window.amble.player.playing));
  await page.keyboard.press('Home');
  await page.keyboard.press('ArrowRight');
  const frame = () => page.evaluate(() => window.amble.take.frameAt(window.amble.player.time));
  claim('an arrow is a frame', (await frame()) === 1, await frame());
  await page.keyboard.press('Shift+ArrowRight');
  const step = await page.evaluate(() => window.amble.take.steps[1]);
  claim('with shift it is a step', (await frame()) === step, await frame());
  await page.waitForFunction(() => /^#t=/.test(location.hash));
}

async function tryLayers(page) {
  await page.evaluate(() => window.amble.player.seek(3.85));
  const layers = await page.$$eval('#layer-list input', (boxes) => boxes.map((box) => box.id));
  claim('there are layers', layers.length >= 7, layers);
  for (const id of layers) {
    const before = await page.evaluate(picture);
    await page.click(`#${id}`);
    const switched = await page.evaluate(picture);
    await page.click(`#${id}`);
    const back = await page.evaluate(picture);
    claim(`${id} switches, and back`, before !== switched && before === back);
  }
}

async function tryCameras(page) {
  const seen = new Set();
  for (const mode of ['orbit', 'follow', 'top', 'first']) {
    await page.click(`#camera-${mode}`);
    seen.add(await page.evaluate(picture));
  }
  claim('four cameras see four pictures', seen.size === 4, seen.size);
  await page.click('#camera-orbit');
}

async function tryEdges(page) {
  await page.click('#camera-top');
  await page.check('#layer-roadmap');
  const at = await page.evaluate(() => {
    const { layers, cameras, canvas } = window.amble;
    window.amble.frame(0);
    const edge = layers.roadmap.edges.findIndex((one) => one.take !== null);
    if (edge < 0) return null;
    const { line } = layers.roadmap.edges[edge];
    const p = window.amble.aim.clone().fromArray(line, 3 * Math.floor(line.length / 6)).project(cameras.current);
    return [((p.x + 1) / 2) * canvas.clientWidth, ((1 - p.y) / 2) * canvas.clientHeight];
  });
  claim('edges can be played', at !== null);
  if (!at) return;
  await page.mouse.click(...at);
  const shown = await page.evaluate(() => [window.amble.index, window.amble.player.playing]);
  claim('a click on an edge plays it', shown[0] > 0 && shown[1], shown);
  await page.keyboard.press('Escape');
  claim('Esc is back at the walk', (await page.evaluate(() => window.amble.index)) === 0);
}

async function tryPhone(browser, folder) {
  const context = await browser.newContext({
    viewport: { width: 360, height: 740 }, isMobile: true, hasTouch: true, colorScheme: 'dark',
  });
  const page = await open(context, join(folder, 'walk.html'), '#t=1');
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  claim('a phone shows all of its breadth', wide <= 360, wide);
  const outside = await page.$$eval('button, #timeline, #card', (all) =>
    all.filter((one) => one.offsetParent !== null)
      .filter((one) => {
        const box = one.getBoundingClientRect();
        return box.left < 0 || box.right > innerWidth || box.top < 0 || box.bottom > innerHeight;
      })
      .map((one) => one.id));
  claim('nothing is beside the phone', outside.length === 0, outside);
  claim('dark is dark', await page.evaluate(() => document.documentElement.dataset.theme === 'dark'));
  await page.tap('#play');
  claim('a tap plays', await page.evaluate(() => window.amble.player.playing));
  await context.close();
}

async function tryNone(context, folder) {
  const page = await open(context, join(folder, 'walk.html'));
  const why = await page.textContent('#why');
  claim('without a walk the page says why', why.length > 20, why);
  const lit = await page.evaluate(() => {
    window.amble.frame(0);
    const { take, player, room, pin = window.amble.layers.pin } = window.amble;
    return Boolean(take.stop) && player.time === player.duration && Boolean(room.lit) && pin.visible;
  });
  claim('and shows an attempt where it failed, with what it touched lit up', lit);
  claim('and how far one gets', (await page.$('#layer-reached')) !== null);
  await page.close();
}

async function tryView(context, folder) {
  const file = join(work, 'viewed.html');
  execFileSync(amble, ['view', folder, '-o', file], { stdio: 'pipe', cwd: source });
  const page = await open(context, file, '#t=0.5');
  const away = farthest(await page.evaluate(jointsOfPage), await jointsOfBvh(join(folder, 'walk.bvh')));
  claim('what amble view shows of a folder is its walk', away <= 1e-4, away);
  claim('in its room', (await page.evaluate(() => window.amble.page.room.objects.length)) > 50);
  const distance = () => page.evaluate(() => {
    const { perspective, orbit } = window.amble.cameras;
    return perspective.position.distanceTo(orbit.target);
  });
  const wide = await distance();
  await page.setViewportSize({ width: 390, height: 600 });
  await page.waitForFunction(() => Math.abs(window.amble.cameras.perspective.aspect - 390 / 600) < 0.05);
  const narrow = await distance();
  claim('a window that is made narrower holds the room as well', narrow > 1.3 * wide, [wide, narrow]);
  await page.close();
}

rmSync(work + '/living-room', { recursive: true, force: true });
mkdirSync(work, { recursive: true });
const walk = plan('living-room');
const none = plan('narrow-gap-040');
const browser = await browsers.launch({
  timeout: 120_000,
  executablePath: chromium,
  args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
});
const context = await browser.newContext({ viewport: { width: 900, height: 600 }, colorScheme: 'light' });
await tryWalk(context, walk);
await tryView(context, walk);
await tryNone(context, none);
await tryPhone(browser, walk);
await tryTurned(browser, open, claim, walk);
await tryReport(browser, claim, walk);
await tryBench({ browser, context, open, claim, amble, work, source, walk });
await browser.close();
claim('nothing was said on the console, and nothing asked for', said.length === 0, said.join('\n'));
process.exit(failed > 0 ? 1 : 0);
