import assert from 'node:assert/strict';
import test from 'node:test';
import { kSpeeds, Player } from '../../../../viz/page/web/player.js';
import { Take } from '../../../../viz/page/web/take.js';
import { madePage, madeTake } from './made_page.mjs';
import { near, seeded } from './seeded.mjs';

const takeOf = (more) => new Take(madePage(), madeTake(more));

function playerOf(more) {
  const player = new Player();
  player.setTake(takeOf(more));
  return player;
}

const kPlanted = [[[0, 9], [20, 31]], [[8, 21], [30, 40]]];

test('whatever is done, and in whatever order, the time is one of the take', () => {
  const random = seeded(3);
  const takes = [
    takeOf({ frames: 41, planted: kPlanted }), takeOf({ frames: 1 }), takeOf({ frames: 2 }),
    takeOf({ frames: 30, stop: { frame: 12.5, part: 0, object: 0, at: [0, 0, 0] } }),
  ];
  const player = new Player();
  const acts = [
    () => player.setTake(takes[Math.floor(random() * takes.length)], 8 * random() - 2),
    () => player.play(random() < 0.7),
    () => player.seek(10 * random() - 3),
    () => player.stepFrames(Math.floor(9 * random()) - 4),
    () => player.stepSteps(random() < 0.5 ? 1 : -1),
    () => player.tick(0.4 * random()),
    () => { player.speed = kSpeeds[Math.floor(random() * kSpeeds.length)]; },
  ];
  acts[0]();
  for (let i = 0; i < 5000; ++i) {
    const act = acts[Math.floor(random() * acts.length)];
    act();
    assert.ok(player.time >= 0 && player.time <= player.duration, `${act}: ${player.time} of ${player.duration}`);
  }
});

test('frames on and as many back are where one was', () => {
  const player = playerOf({ frames: 41 });
  for (const at of [7, 20, 33]) {
    for (const count of [1, 3, 7]) {
      player.seek(at * 0.1);
      player.stepFrames(count);
      assert.equal(player.take.frameAt(player.time), at + count);
      player.stepFrames(-count);
      near(player.time, at * 0.1, 1e-12);
    }
  }
});

test('step by step one comes by every moment at which a foot comes down, there and back', () => {
  const player = playerOf({ frames: 41, planted: kPlanted });
  const strikes = [...new Set([0, 40, ...kPlanted.flat().map(([first]) => first)])].sort((a, b) => a - b);
  const there = [0], back = [40];
  while (there.at(-1) < 40 && there.length < 99) {
    player.stepSteps(1);
    there.push(player.take.frameAt(player.time));
  }
  while (back.at(-1) > 0 && back.length < 99) {
    player.stepSteps(-1);
    back.push(player.take.frameAt(player.time));
  }
  assert.deepEqual(there, strikes);
  assert.deepEqual(back, strikes.toReversed());
});

test('time goes on as the clock does, times the speed, and begins anew behind the end', () => {
  const random = seeded(4);
  for (const speed of kSpeeds) {
    const player = playerOf({ frames: 21 });
    player.speed = speed;
    player.play();
    let sum = 0;
    for (let i = 0; i < 200; ++i) {
      const elapsed = 0.1 * random();
      assert.ok(player.tick(elapsed));
      sum += elapsed * speed;
    }
    const off = (sum - player.time) / player.duration;
    near(off, Math.round(off), 1e-9, `${speed}`);
  }
});

test('an attempt is played up to where it fails, and halts there', () => {
  const player = playerOf({ frames: 30, stop: { frame: 12.5, part: 0, object: 0, at: [0, 0, 0] } });
  let told = 0;
  player.changed = () => ++told;
  player.play();
  for (let i = 0; i < 100 && player.playing; ++i) player.tick(0.1);
  near(player.time, 1.25, 1e-12);
  assert.ok(!player.playing);
  assert.equal(told, 2);
  assert.ok(!player.tick(1));
  player.play();  // once more, from the beginning
  assert.equal(player.time, 0);
  assert.ok(player.playing);
});

test('what does not move cannot be played', () => {
  const player = playerOf({ frames: 1 });
  player.play();
  assert.ok(!player.playing);
  player.setTake(takeOf({ frames: 9 }));
  player.play();
  player.setTake(takeOf({ frames: 1 }));
  assert.ok(!player.tick(0.3) && !player.playing);
});

test('without a take there is no time, and nothing is played', () => {
  const player = new Player();
  player.play();
  player.seek(3);
  assert.deepEqual([player.duration, player.time, player.playing], [0, 0, false]);
});
