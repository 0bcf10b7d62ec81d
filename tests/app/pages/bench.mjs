// The workbench: what `amble view` writes of captures and of a library, in the browser that the
// other pages are tried in.

import { execFileSync } from 'node:child_process';
import { join } from 'node:path';

const kStarts = ['Home', 'End'];

// The canvas of the curves as a number that tells drawings apart.
const drawing = () => {
  window.amble.frame(0);
  window.amble.bench.curves.curves.draw();
  const canvas = document.getElementById('bench-canvas');
  const copy = Object.assign(document.createElement('canvas'), { width: canvas.width, height: canvas.height });
  const c = copy.getContext('2d', { willReadFrequently: true });
  c.drawImage(canvas, 0, 0);
  const { data } = c.getImageData(0, 0, copy.width, copy.height);
  let sum = 0;
  for (let i = 0; i < data.length; i += 4) sum = (sum * 31 + data[i] + 7 * data[i + 3]) % 4294967291;
  return sum;
};

export async function tryBench({ browser, context, open, claim, amble, work, source, walk }) {
  const run = (args) => execFileSync(amble, args, { cwd: source, maxBuffer: 1 << 28, stdio: ['ignore', 'pipe', 'pipe'] });
  const fast = join(work, 'fast "walk" <b>.bvh');
  run(['animate', '--speed', '1.6', '--duration', '5', '-o', fast]);
  const clips = [join(walk, 'walk.bvh'), fast];
  const file = join(work, 'bench.html');
  run(['view', ...clips, '-o', file]);
  const said = JSON.parse(run(['view', '--json', ...clips]));
  const page = await open(context, file, '#t=1');
  await tryList(page, claim, said);
  await tryCurves(page, claim, said);
  await tryPair(page, claim);
  await tryTrace(page, claim);
  await page.close();
  await tryPhone(browser, open, claim, file);
  const library = join(work, 'library.html');
  run(['view', 'animation/motions/default.yaml', '--captures', join(source, 'nowhere'), '-o', library]);
  await tryLibrary(context, open, claim, library);
  const graph = join(work, 'walks.graph');
  run(['graph', 'build', ...clips, '-o', graph]);
  run(['view', graph, '-o', join(work, 'graph.html')]);
  await tryGraph(context, open, claim, join(work, 'graph.html'));
}

async function tryList(page, claim, said) {
  claim('#t=1 holds on the workbench', (await page.evaluate(() => window.amble.player.time)) === 1);
  const rows = () => page.$$eval('#bench-rows b', (all) => all.map((one) => one.textContent));
  claim('every clip is listed by its name, whatever is in it', (await rows()).includes('fast "walk" <b>.bvh'), await rows());
  await page.fill('#bench-filter', 'fast');
  claim('a filter leaves those that match', (await rows()).length === 1);
  await page.fill('#bench-filter', '');
  await page.selectOption('#bench-sort', 'speed');
  const bySpeed = said.toSorted((a, b) => a.analysis.gait.speed - b.analysis.gait.speed).map((clip) => clip.file);
  const sorted = () => page.$$eval('#bench-rows b', (all) => all.map((one) => one.title));
  claim('sorted by speed the slowest is first', (await sorted()).join() === bySpeed.join());
  await page.click('#bench-way');
  claim('or last', (await sorted()).join() === bySpeed.toReversed().join());
  await page.click(`#bench-rows li:has-text("fast") .clip`);
  claim('a click shows a clip', (await page.evaluate(() => window.amble.take.name)).startsWith('fast'));
}

async function tryCurves(page, claim, said) {
  const away = await page.evaluate((clips) => {
    let most = 0;
    clips.forEach((clip, i) => clip.joints.forEach((joint, j) => {
      for (const { label, values } of window.amble.bench.clips[i].channels(j))
        joint.channels[label].forEach((value, k) => { most = Math.max(most, Math.abs(value - values[k])); });
    }));
    return most;
  }, said);
  claim('curves on the page are those of --json to a hundredth of a degree', away <= 0.0101, away);
  const seen = new Set([await page.evaluate(drawing)]);
  await page.click('#bench-joint-2');
  seen.add(await page.evaluate(drawing));
  for (const tab of ['feet', 'root', 'joint']) {
    await page.click(`#bench-curves [data-key=${tab}]`);
    seen.add(await page.evaluate(drawing));
  }
  claim('joints, feet and root have curves of their own', seen.size === 4, seen.size);
  const box = await page.locator('#bench-canvas').boundingBox();
  await page.mouse.click(box.x + 74 + (box.width - 86) / 2, box.y + 40);
  const [time, duration] = await page.evaluate(() => [window.amble.player.time, window.amble.player.duration]);
  claim('a click on a curve is that time', Math.abs(time - duration / 2) < 0.02 * duration, time);
  for (const key of kStarts) {
    await page.keyboard.press(key);
    const [at, now] = await page.evaluate(() => {
      window.amble.frame(0);
      return [window.amble.bench.curves.curves.at, window.amble.player.time];
    });
    claim(`the cursor goes with the player to its ${key}`, at === now, at);
  }
  await page.mouse.move(box.x + box.width / 2, box.y + 40);
  await page.mouse.wheel(0, -400);
  await page.waitForFunction(() => {
    const { curves } = window.amble.bench.curves;
    return curves.length < 0.8 * (curves.whole[1] - curves.whole[0]);
  });
  await page.click('#bench-curves button:has-text("Whole")');
  claim('curves are zoomed, and back', await page.evaluate(() => {
    const { curves } = window.amble.bench.curves;
    return curves.length === curves.whole[1] - curves.whole[0];
  }));
}

async function tryPair(page, claim) {
  await page.locator('#bench-rows li:not(.first) .beside').first().click();
  const two = () => page.evaluate(() => window.amble.actors.filter((actor) => actor.group.visible).length);
  claim('two clips are shown together', (await two()) === 2, await two());
  await page.click('#bench-pair [data-key=beside]');
  await page.evaluate(() => { window.amble.player.seek(0); window.amble.posed = -1; window.amble.frame(0); });
  const apart = await page.evaluate(() => {
    const { actor, bench } = window.amble;
    const [a, b] = [actor, bench.companion.actor].map((one) => one.root.matrixWorld.elements);
    return Math.hypot(a[12] - b[12], a[13] - b[13]);
  });
  claim('side by side they are a metre and a bit apart', apart > 1 && apart < 1.2, apart);
  await page.click('#bench-pair [data-key=phase]');
  const off = await page.evaluate(() => {
    const { companion, clip } = window.amble.bench;
    const other = companion.clip.phase;
    const moments = clip.phase.filter(([, phase]) => phase % 1 === 0).map(([time]) => companion.timeOf(time));
    const whole = other.filter(([, phase]) => phase % 1 === 0).map(([time]) => time);
    return Math.max(...moments.map((time) => Math.min(...whole.map((one) => Math.abs(one - time)))));
  });
  claim('by phase both have the left foot in front at one time', off < 1e-6, off);
  await page.click('#bench-curves [data-key=feet]');
  const feet = await page.evaluate(() => {
    const { panels } = window.amble.bench.curves.curves;
    return [panels[0].curves.length, panels.filter((panel) => panel.row && panel.bars.length > 0).length];
  });
  claim('feet of both are drawn, and who of them stands when', feet.join() === '8,4', feet);
  await page.click('#bench-curves [data-key=joint]');
  await page.keyboard.press('Escape');
  claim('Esc leaves one of them', (await two()) === 1);
}

async function tryTrace(page, claim) {
  await page.selectOption('#bench-trace', '15');
  const [ghosts, frames] = await page.evaluate(() => [window.amble.bench.ghosts.drawn, window.amble.take.frames]);
  claim('the trace has every fifteenth frame', ghosts === Math.ceil(frames / 15), ghosts);
  await page.selectOption('#bench-trace', '0');
  await page.click('#bench-still');
  const root = await page.evaluate(() => {
    window.amble.player.seek(2);
    window.amble.frame(0);
    return window.amble.actor.root.matrixWorld.elements.slice(12, 14);
  });
  claim('on the spot the root stays', Math.hypot(...root) < 1e-6, root);
}

async function tryPhone(browser, open, claim, file) {
  const context = await browser.newContext({
    viewport: { width: 360, height: 740 }, isMobile: true, hasTouch: true, colorScheme: 'dark',
  });
  const page = await open(context, file, '#t=1');
  for (const key of ['clips', 'tree', 'facts', 'curves']) {
    await page.tap(`#bench-nav [data-key=${key}]`);
    const outside = await page.$$eval('button, select, .panel', (all) =>
      all.filter((one) => one.checkVisibility() && !one.closest('#bench-rows'))
        .filter((one) => {
          const box = one.getBoundingClientRect();
          return box.left < 0 || box.right > innerWidth || box.top < 0 || box.bottom > innerHeight;
        })
        .map((one) => one.id || one.textContent));
    const shown = await page.$$eval('.panel', (all) => all.filter((one) => one.checkVisibility()).length);
    claim(`on a phone ${key} are one panel, and nothing is beside it`, shown === 1 && outside.length === 0, [shown, outside]);
  }
  await context.close();
}

async function tryLibrary(context, open, claim, file) {
  const page = await open(context, file);
  const motions = await page.evaluate(() => window.amble.page.bench.library.motions.length);
  const listed = await page.$$eval('#bench-rows li, .no-clip', (all) => all.length);
  claim('every motion of a library is listed', listed === motions, listed);
  await page.click('#bench-rows li:has-text("walk-slow") .clip');
  await page.click('#bench-curves [data-key=cycle]');
  const cycle = await page.evaluate(drawing);
  claim('a capture that is not there is said', /is not there/.test(await page.textContent('#bench-curves .title')));
  await page.click('#bench-curves [data-key=law]');
  claim('cycles and the law of steps are drawn', (await page.evaluate(drawing)) !== cycle);
  await page.click('#bench-tree [data-key=facts]');
  claim('with their credits', /Open Motion Project/.test(await page.textContent('#bench-facts')));
  await page.close();
}

// A point of the drawing, or what a function of the graph's drawing gives.
async function clickAt(page, point) {
  const [x, y] = typeof point === 'function' ? await page.evaluate(point) : point;
  const box = await page.locator('#bench-canvas').boundingBox();
  await page.mouse.click(box.x + x, box.y + y);
}

async function tryGraph(context, open, claim, file) {
  const page = await open(context, file, '#t=0');
  const before = await page.evaluate(drawing);
  await clickAt(page, () => window.amble.bench.curves.graph.nodes.at(-1).at);
  const chosen = await page.evaluate(() => [window.amble.bench.curves.graph.cluster, window.amble.page.bench.graph.clusters.length]);
  claim('a click chooses a cluster', chosen[0] === chosen[1] - 1, chosen);
  claim('which is seen in the drawing', (await page.evaluate(drawing)) !== before);
  claim('and told', /^Cluster [0-9]+, [LRN][BN]?: [0-9]+ frame/.test(await page.textContent('#bench-curves .title')));
  await clickAt(page, () => [window.amble.bench.curves.graph.xOf(20.5), window.amble.bench.curves.graph.yOf(1) + 3]);
  const shown = await page.evaluate(() => [window.amble.index, window.amble.player.time / window.amble.page.bench.graph.frame_time]);
  claim('a click on a clip is that frame of it', shown[0] === 1 && Math.abs(shown[1] - 20) < 1e-6, shown);
  // A transition whose line lies over no other's where it is clicked.
  const [join, point] = await page.evaluate(() => {
    const { graph } = window.amble.bench.curves;
    for (const [i, { cluster }] of graph.graph.joins.entries()) {
      graph.cluster = cluster;
      graph.bench.curves.draw();
      const { points } = graph.lines.find((line) => line.join === i) ?? { points: [] };
      const seen = points.find(([x, y]) => graph.find(x, y).join === i);
      if (seen) return [i, seen];
    }
    return [0, [0, 0]];
  });
  await clickAt(page, point);
  const played = await page.evaluate((i) => [window.amble.index, window.amble.page.bench.graph.joins[i].take, window.amble.player.playing], join);
  claim('a click on a transition plays it', played[0] === played[1] && played[2], played);
  const [from, both, to, left, entered] = await page.evaluate((i) => {
    const { graph } = window.amble.bench.curves, { meeting, leave, enter } = graph.graph.joins[i];
    window.amble.player.playing = false;
    return [...[0, meeting, window.amble.take.frames - 1].map((frame) => {
      window.amble.player.seek(frame * graph.graph.frame_time);
      return graph.now.map(({ clip }) => clip);
    }), leave.clip, enter.clip];
  }, join);
  claim('it comes from one clip, is both, and ends in the other', from[0] === left && both.length === 2 && to.at(-1) === entered, [from, both, to]);
  await page.click('#bench-tree [data-key=facts]');
  claim('the command that writes it is told', /amble graph play GRAPH '.+' -o FILE.bvh/.test(await page.textContent('#bench-facts')));
  await page.close();
}
