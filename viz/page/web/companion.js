// A second clip beside the first, or over it, at the same time or at the same moment of the gait;
// and both on the spot.

import { Box3, Color, Vector3 } from 'three';

const kBeside = 1.1;    // between two walkers [m]
const kAround = 0.7;    // a walker's root, of what is to be in sight [m]
const kUnderWay = 0.5;  // after so much of its way a clip shows where it goes [m]
const kSecond = new Color(0x7a5af8);

export class Companion {
  constructor(viewer, clips) {
    this.viewer = viewer;
    this.clips = clips;
    this.index = -1;
    this.place = 'over';
    this.sync = 'time';
    this.inPlace = false;
    this.colors = new Map();
  }

  get clip() {
    return this.clips[this.index];
  }

  get take() {
    return this.viewer.takes[this.index];
  }

  get actor() {
    return this.viewer.actors[this.take.actor];
  }

  get asShown() {
    return { take: this.take, actor: this.actor, clip: this.clip, second: true };
  }

  get hasPhase() {
    return this.clips[this.viewer.index].phase.length > 1 && this.clip.phase.length > 1;
  }

  set(change) {
    if ('with' in change) {
      if (this.index >= 0) this.dye(this.actor, null);
      this.index = change.with === this.viewer.index ? -1 : change.with;
      if (this.index >= 0) this.dye(this.actor, kSecond);
    }
    if (change.place) this.place = change.place;
    if (change.sync) this.sync = change.sync;
    this.align();
  }

  // The second walker in a colour of his own.
  dye(actor, color) {
    actor.group.traverse((mesh) => {
      for (const material of [mesh.material].flat().filter(Boolean)) {
        if (!this.colors.has(material)) this.colors.set(material, material.color?.clone());
        const own = this.colors.get(material);
        if (own) material.color.copy(color ? own.clone().lerp(color, 0.85) : own);
      }
    });
  }

  /** Where the bodies stand: the first as captured, on the floor; the second from where that begins. */
  align() {
    const { viewer } = this;
    for (const actor of viewer.actors) actor.group.visible = actor === viewer.actor;
    this.turn(viewer.actor, viewer.take, this.clips[viewer.index], null);
    if (this.index < 0) return;
    this.actor.group.visible = true;
    this.turn(this.actor, this.take, this.clip, viewer.take);
  }

  turn(actor, take, clip, like) {
    const { group } = actor;
    group.rotation.z = like ? wayOf(like) - wayOf(take) : 0;
    group.position.set(0, 0, -clip.floor);
    if (like) {
      const at = new Vector3().fromArray(take.root).applyEuler(group.rotation);
      group.position.x = like.root[0] - at.x;
      group.position.y = like.root[1] - at.y;
      if (this.place === 'beside') this.shift(group.position, wayOf(like));
    }
    group.updateMatrixWorld(true);
  }

  // To the right of the first.
  shift(position, heading) {
    position.x += kBeside * Math.sin(heading);
    position.y -= kBeside * Math.cos(heading);
  }

  /** The second clip's time at a time of the first [s]. */
  timeOf(time) {
    if (this.sync === 'time' || !this.hasPhase) return Math.min(time, this.take.duration);
    const phase = interpolated(this.clips[this.viewer.index].phase, time, 0, 1);
    const own = this.clip.phase;
    const first = own[0][1], cycles = Math.max(1, Math.floor(own.at(-1)[1] - first));
    // As many whole cycles on or back as bring it among the second's own.
    const late = (((phase - first) % cycles) + cycles) % cycles;
    return Math.min(this.take.duration, Math.max(0, interpolated(own, first + late, 1, 0)));
  }

  /** Spans of the second clip's time as they lie over the first's, as often as they come [[from, to], ...] [s]. */
  spansOver(spans) {
    if (this.sync === 'time' || !this.hasPhase) return spans;
    const first = this.clips[this.viewer.index].phase, own = this.clip.phase;
    const cycles = Math.max(1, Math.floor(own.at(-1)[1] - own[0][1]));
    const over = [];
    for (const span of spans) {
      const [from, to] = span.map((time) => interpolated(own, time, 0, 1));
      if (from >= own[0][1] + cycles) continue;  // the second begins anew before
      for (let k = Math.ceil((first[0][1] - to) / cycles); from + k * cycles <= first.at(-1)[1]; ++k)
        over.push([from, to].map((phase) => interpolated(first, phase + k * cycles, 1, 0)));
    }
    return over;
  }

  /** After the first has been posed. */
  follow(time) {
    const { viewer } = this;
    if (this.inPlace) this.hold(viewer.actor, viewer.take, 0);
    if (this.index < 0) return;
    this.actor.pose(this.take, this.timeOf(time));
    if (this.inPlace) this.hold(this.actor, this.take, this.place === 'beside' ? 1 : 0);
  }

  // On the spot: the root stays over the origin.
  hold(actor, take, aside) {
    const { group } = actor;
    const root = actor.root.position.clone().applyEuler(group.rotation);
    group.position.x = -root.x;
    group.position.y = -root.y;
    if (aside) this.shift(group.position, wayOf(this.viewer.take));
    group.updateMatrixWorld(true);
    actor.redraw();
  }

  /** What is to be in sight. */
  bounds() {
    const bounds = new Box3();
    if (this.inPlace) {
      bounds.set(new Vector3(-1.2, -1.2, 0), new Vector3(1.2, 1.2, 1.8));
      return bounds;
    }
    const all = [[this.viewer.take, this.viewer.actor]];
    if (this.index >= 0) all.push([this.take, this.actor]);
    const point = new Vector3();
    for (const [take, actor] of all) {
      for (let i = 0; i < take.root.length; i += 3) {
        point.fromArray(take.root, i).applyMatrix4(actor.group.matrixWorld);
        bounds.expandByPoint(point);
      }
    }
    bounds.expandByScalar(kAround);
    bounds.min.z = 0;
    return bounds;
  }
}

// The direction in which the take sets out [rad].
function wayOf(take) {
  const { root } = take;
  for (let i = 3; i < root.length; i += 3) {
    const x = root[i] - root[0], y = root[i + 1] - root[1];
    if (Math.hypot(x, y) > kUnderWay) return Math.atan2(y, x);
  }
  return 0;
}

// Piecewise linear through pairs, and on at both ends as the nearest piece goes.
export function interpolated(pairs, value, from, to) {
  let i = 0;
  while (i < pairs.length - 2 && pairs[i + 1][from] < value) ++i;
  const a = pairs[i], b = pairs[i + 1];
  return a[to] + ((value - a[from]) / (b[from] - a[from])) * (b[to] - a[to]);
}
