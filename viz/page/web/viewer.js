// What is shown and when: room, actors, layers and cameras, by one clock.

import { Box3, Vector3 } from 'three';
import { Actor } from './actor.js';
import { Cameras } from './cameras.js';
import { Layers } from './layers.js';
import { Player } from './player.js';
import { Room } from './room.js';
import { Stage } from './stage.js';
import { Take } from './take.js';

export class Viewer {
  constructor(page, canvas, context) {
    this.page = page;
    this.canvas = canvas;
    this.stage = new Stage(canvas, context);
    this.player = new Player();
    this.room = new Room(page);
    this.takes = page.takes.map((json) => new Take(page, json));
    this.actors = page.actors.map((json) => new Actor(page, json));
    this.stage.scene.add(this.room.group, ...this.actors.map((actor) => actor.group));
    this.aim = new Vector3();
    this.head = new Vector3();
    this.bounds = this.findBounds();
    this.stage.setBounds(this.bounds);
    if (!page.room) {
      const size = Math.ceil(Math.max(6, this.bounds.getSize(this.aim).length() + 2));
      this.stage.addGrid(size, page.floor);
    }
    this.layers = new Layers(page, this);
    this.cameras = new Cameras(canvas, this.bounds, this.aim);
    this.cameras.changed = () => (this.dirty = true);
    this.listeners = [];
    this.followers = [];  // told the time when the body has been posed
    this.dirty = true;
    for (const actor of this.actors) actor.group.visible = false;
    if (this.takes.length > 0) this.show(0);
    this.resize();
  }

  findBounds() {
    const bounds = new Box3();
    bounds.setFromObject(this.room.group);
    for (const take of this.takes) {
      for (let i = 0; i < take.root.length; i += 3) {
        bounds.expandByPoint(this.aim.fromArray(take.root, i));
      }
    }
    if (bounds.isEmpty()) bounds.set(new Vector3(-2, -2, 0), new Vector3(2, 2, 2));
    if (!this.page.room) bounds.min.z = this.page.floor;
    if (this.page.room) bounds.min.z = Math.max(bounds.min.z, this.page.floor - 0.2);
    return bounds;
  }

  /** From now on the take of that index is played. */
  show(index, time = 0) {
    this.index = index;
    this.take = this.takes[index];
    this.actor = this.actors[this.take.actor];
    for (const actor of this.actors) actor.group.visible = actor === this.actor;
    this.player.setTake(this.take, time);
    this.layers.showTake(this.take);
    this.stop = null;
    this.pose();
    this.reshade();
    for (const listener of this.listeners ?? []) listener();
  }

  /** Something else is to be seen, that may throw a shadow. */
  reshade() {
    this.stage.renderer.shadowMap.needsUpdate = true;
    this.dirty = true;
  }

  pose() {
    if (!this.actor) return;
    this.actor.pose(this.take, this.player.time);
    for (const follow of this.followers ?? []) follow(this.player.time);
    this.aim.setFromMatrixPosition(this.actor.root.matrixWorld);
    this.head.setFromMatrixPosition(this.actor.eye.matrixWorld);
  }

  // An attempt that has come to where it failed: part and thing light up.
  lightUp() {
    if (!this.take) return;
    const stop = this.player.time >= this.player.duration - 1e-6 ? this.take.stop : null;
    if (stop === this.stop) return;
    this.stop = stop;
    this.actor.light(stop ? stop.part : -1);
    this.room.light(stop ? stop.object : -1);
    this.layers.mark(stop ? stop.at : this.page.walk?.obstruction);
    this.reshade();
  }

  /** @param covered  pixels at the lower edge that something else lies over */
  resize(covered = this.covered ?? 0) {
    this.covered = covered;
    const { clientWidth: width, clientHeight: height } = this.canvas;
    this.stage.resize(width, height);
    this.cameras.resize(width, height, covered);
    this.dirty = true;
  }

  run() {
    let before = performance.now();
    const loop = (now) => {
      requestAnimationFrame(loop);
      const elapsed = Math.max(0, Math.min(0.1, (now - before) / 1000));  // the first frame may be dated before
      before = now;
      this.frame(elapsed);
    };
    requestAnimationFrame(loop);
  }

  frame(elapsed) {
    const moved = this.player.tick(elapsed);
    if (moved || this.player.time !== this.posed) {
      this.posed = this.player.time;
      this.pose();
      this.reshade();
    }
    const heading = this.take ? this.take.heading(this.player.time) : 0;
    this.cameras.update(this.aim, this.head, heading, elapsed);
    if (!this.dirty) return;
    if (moved && this.stage.adapt(elapsed)) this.resize();
    this.dirty = false;
    this.cameras.current.updateMatrixWorld();
    this.room.giveWay(this.cameras, this.aim);
    this.layers.update(this.player.time);
    this.lightUp();
    this.stage.watch(this.aim.x, this.aim.y, this.aim.z);
    this.stage.render(this.cameras.current);
    this.drawn?.();
  }
}
