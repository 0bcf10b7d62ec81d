// What can be shown beside the body, each to be switched: path, prints, roadmap, nearest thing.

import {
  DoubleSide, Group, Mesh, MeshBasicMaterial, MeshLambertMaterial, SphereGeometry,
} from 'three';
import { Attempts } from './attempts.js';
import { kGoalColor, kLeftColor, kPathColor, kRightColor, kStartColor } from './colors.js';
import { fan, ribbon } from './flat.js';
import { groundOf } from './grounds.js';
import { Nearest } from './nearest.js';
import { Roadmap } from './roadmap.js';

export function flatMaterial(color, opacity = 1) {
  return new MeshBasicMaterial({
    color, opacity, transparent: opacity < 1, side: DoubleSide, depthWrite: false,
    polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -4,
  });
}

export class Layers {
  constructor(page, viewer) {
    this.page = page;
    this.viewer = viewer;
    this.groups = {};
    this.prints = [];
    const walk = page.walk;
    this.faint = [kLeftColor, kRightColor].map((color) => flatMaterial(color, 0.4));
    this.strong = [kLeftColor, kRightColor].map((color) => flatMaterial(color, 0.95));
    this.add('path').renderOrder = 2;
    this.add('prints');
    if (walk) {
      this.roadmap = new Roadmap(page);
      this.add('roadmap').add(this.roadmap.group);
      this.attempts = new Attempts(page, flatMaterial);
      this.add('attempts').add(this.attempts.group);
      this.addGrounds(walk);
      this.add('places');
      this.addPlaces(walk);
    }
    this.nearest = new Nearest(this.add('nearest'), document.getElementById('nearest-label'));
    this.mark(walk?.obstruction);
    this.list = this.whatThereIs();
    for (const layer of this.list) layer.apply(layer.on);
  }

  add(name) {
    const group = new Group();
    this.groups[name] = group;
    this.viewer.stage.overlays.add(group);
    return group;
  }

  // A layer is offered where there is something to see.
  whatThereIs() {
    const { page, viewer, groups } = this;
    const visible = (name) => (on) => (groups[name].visible = on);
    const parts = { body: true, capsules: false, bones: false };
    const showParts = () => {
      for (const actor of viewer.actors) actor.show(parts);
      viewer.pose();
    };
    const has = {
      body: page.actors.some((actor) => actor.body.parts.length > 0),
      prints: page.takes.some((take) => take.prints.length > 0),
      nearest: page.takes.some((take) => take.clearance),
      capsules: page.actors.some((actor) => actor.body.parts.length > 0),
      attempts: Boolean(this.attempts) && this.attempts.edges.length > 0,
      reached: Boolean(page.walk?.reached),
      room: Boolean(page.walk?.room_to_walk),
      roadmap: Boolean(this.roadmap) && !this.roadmap.isEmpty,
      walls: viewer.room.walls.length > 0,
    };
    return [
      ['body', 'Body', true, (on) => { parts.body = on; showParts(); }],
      ['capsules', 'Capsules', false, (on) => { parts.capsules = on; showParts(); }],
      ['bones', 'Bones', false, (on) => { parts.bones = on; showParts(); }],
      ['path', 'Root path', true, visible('path')],
      ['prints', 'Footprints', true, visible('prints')],
      ['roadmap', 'Roadmap', !page.takes.some((take) => !take.stop), visible('roadmap')],
      ['attempts', 'Refused attempts', this.isRefused, visible('attempts')],
      ['reached', 'Reached from the start', true, visible('reached')],
      ['room', 'Room to walk', false, visible('room')],
      ['nearest', 'Nearest thing', true, (on) => this.nearest.show(on)],
      ['walls', 'Walls give way', true, (on) => { viewer.room.gives = on; }],
    ].filter(([key]) => has[key] ?? page.takes.length > 0)
      .map(([key, label, on, apply]) => ({ key, label, on, apply }));
  }

  set(key, on) {
    const layer = this.list.find((one) => one.key === key);
    layer.on = on;
    layer.apply(on);
    this.viewer.reshade();
  }

  // Where no walk was found.
  get isRefused() {
    return Boolean(this.page.why);
  }

  addGrounds(walk) {
    if (walk.reached) this.add('reached').add(groundOf(this.page, walk.reached, [flatMaterial(0x12b76a, 0.3)]));
    if (!walk.room_to_walk) return;
    const colors = [0xf79009, 0xfac515, 0x2e90fa];
    this.add('room').add(groundOf(this.page, walk.room_to_walk, colors.map((color) => flatMaterial(color, 0.32))));
  }

  /** Something is at this place; null: nothing is. */
  mark(at) {
    if (!this.pin) {
      const material = new MeshLambertMaterial({
        color: 0xf04438, emissive: 0xd92d20, depthTest: false, transparent: true, opacity: 0.85,
      });
      this.pin = new Mesh(new SphereGeometry(0.045, 24, 16), material);
      this.pin.renderOrder = 12;
      this.viewer.stage.overlays.add(this.pin);
    }
    this.pin.visible = Boolean(at);
    if (at) this.pin.position.fromArray(at);
  }

  addPlaces(walk) {
    const group = this.groups.places;
    const put = (place, color) => {
      if (!place) return;
      const disc = new Mesh(fan(circle(0.17)), flatMaterial(color, 0.9));
      disc.position.fromArray(place.at);
      group.add(disc);
      if (place.heading === null) return;
      const arrow = new Mesh(fan([[0.22, -0.1], [0.42, 0], [0.22, 0.1]]), flatMaterial(color, 0.9));
      arrow.position.fromArray(place.at);
      arrow.rotation.z = place.heading;
      group.add(arrow);
    };
    put(walk.start, kStartColor);
    put(walk.goal, kGoalColor);
    for (const via of walk.via) put(via, 0x6b7280);
  }

  /** Path and prints of the take that is shown. */
  showTake(take) {
    const { path, prints } = this.groups;
    for (const group of [path, prints]) {
      for (const mesh of group.children) mesh.geometry.dispose();
      group.clear();
    }
    if (take.way) path.add(new Mesh(ribbon(take.way, 0.03, 0.008), flatMaterial(kPathColor, 0.85)));
    this.prints = take.prints.map((print) => {
      const mesh = new Mesh(fan(print.outline), this.faint[print.side]);
      mesh.position.set(0, 0, print.at[2] + 0.004);
      mesh.renderOrder = 3;
      prints.add(mesh);
      return mesh;
    });
    this.take = take;
    this.nearest.setTake(take);
  }

  update(time) {
    if (!this.take) return;
    const frame = this.take.frameAt(time);
    for (let i = 0; i < this.prints.length; ++i) {
      const print = this.take.prints[i];
      const stands = frame >= print.first && frame <= print.last;
      this.prints[i].material = (stands ? this.strong : this.faint)[print.side];
    }
    this.nearest.update(frame, this.viewer.cameras.current, this.viewer.canvas);
  }
}

function circle(radius) {
  return Array.from({ length: 40 }, (_, i) => [
    radius * Math.cos((i * Math.PI) / 20), radius * Math.sin((i * Math.PI) / 20),
  ]);
}
