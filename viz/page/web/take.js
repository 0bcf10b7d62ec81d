// A motion: the pose at any time, as a player shows it. Between two frames the root moves linearly
// and each joint turns by slerp, as the walk was checked.

import { Quaternion } from 'three';

const kCoarse = 1 / 32767;  // unit of rotations in 16 bits
const kWhole = 1e-6;        // nearer to a frame than this is the frame [frames]

function rotationsOf(page, ref) {
  const stored = page.array(ref);
  if (stored instanceof Float32Array) return stored;
  const rotations = new Float32Array(stored.length);
  for (let i = 0; i < stored.length; ++i) rotations[i] = stored[i] * kCoarse;
  return rotations;
}

export class Take {
  constructor(page, json) {
    this.name = json.name;
    this.actor = json.actor;
    this.frames = json.frames;
    this.frameTime = json.frame_time;
    this.every = json.every;  // of the file's frames
    this.root = page.array(json.root);
    this.rotations = rotationsOf(page, json.rotations);
    this.positions = json.positions ? page.array(json.positions) : null;
    this.headings = json.headings ? page.array(json.headings) : null;
    this.way = json.way ? page.array(json.way) : this.shadowOfRoot(page.floor);
    this.planted = json.planted;
    this.events = json.events;
    this.prints = json.prints;
    this.sources = json.sources.map((s) => ({ name: s.name, share: page.array(s.share) }));
    this.clearance = json.clearance && {
      distance: page.array(json.clearance.distance),
      points: page.array(json.clearance.points),
      part: json.clearance.part,
      object: json.clearance.object,
    };
    this.stop = json.stop ?? null;
    this.joints = this.rotations.length / 4 / this.frames;
    this.steps = this.findSteps();
  }

  // The root's way, on the floor.
  shadowOfRoot(floor) {
    return this.root.map((value, i) => (i % 3 === 2 ? floor : value));
  }

  /** Up to where it ends, or fails [s]. */
  get duration() {
    return (this.stop ? this.stop.frame : this.frames - 1) * this.frameTime;
  }

  /** Frames in which a foot comes down, in order. */
  findSteps() {
    const starts = new Set([0, this.frames - 1]);
    for (const side of this.planted) for (const [first] of side) starts.add(first);
    return [...starts].sort((a, b) => a - b);
  }

  /** Captured motions that a frame is made of, the largest share first: [{name, index, share}]. */
  sourcesAt(frame) {
    return this.sources
      .map((source, index) => ({ name: source.name, index, share: source.share[frame] }))
      .filter((source) => source.share >= 0.005)
      .sort((a, b) => b.share - a.share);
  }

  frameAt(time) {
    return Math.max(0, Math.min(this.frames - 1, Math.round(time / this.frameTime)));
  }

  /** Poses bones at a time [s]. */
  pose(bones, time) {
    const at = Math.max(0, Math.min(this.frames - 1, time / this.frameTime));
    let frame = Math.min(Math.floor(at + kWhole), this.frames - 1);
    let share = at - frame;
    if (share < kWhole) share = 0;
    const next = Math.min(frame + 1, this.frames - 1);
    const q = this.rotations;
    for (let joint = 0; joint < this.joints; ++joint) {
      const bone = bones[joint];
      const a = (frame * this.joints + joint) * 4;
      if (share === 0) {
        bone.quaternion.set(q[a], q[a + 1], q[a + 2], q[a + 3]);
      } else {
        Quaternion.slerpFlat(kTurned, 0, q, a, q, (next * this.joints + joint) * 4, share);
        bone.quaternion.set(kTurned[0], kTurned[1], kTurned[2], kTurned[3]);
      }
      if (this.positions) place(bone, this.positions, frame, next, joint, this.joints, share);
    }
    place(bones[0], this.root, frame, next, 0, 1, share);
  }

  /** The way that the walker faces at a time [rad]; without it, the way that the root moves. */
  heading(time) {
    const frame = this.frameAt(time);
    if (this.headings) {
      const at = Math.max(0, Math.min(this.frames - 1, time / this.frameTime));
      const low = Math.min(Math.floor(at), this.frames - 2 < 0 ? 0 : this.frames - 2);
      const high = Math.min(low + 1, this.frames - 1);
      const turn = this.headings[high] - this.headings[low];
      return this.headings[low] + Math.atan2(Math.sin(turn), Math.cos(turn)) * (at - low);
    }
    const reach = Math.round(0.3 / this.frameTime);
    const a = Math.max(0, frame - reach) * 3;
    const b = Math.min(this.frames - 1, frame + reach) * 3;
    return Math.atan2(this.root[b + 1] - this.root[a + 1], this.root[b] - this.root[a]);
  }
}

const kTurned = new Float32Array(4);

function place(bone, positions, frame, next, joint, joints, share) {
  const a = (frame * joints + joint) * 3;
  const b = (next * joints + joint) * 3;
  bone.position.set(
    positions[a] + share * (positions[b] - positions[a]),
    positions[a + 1] + share * (positions[b + 1] - positions[a + 1]),
    positions[a + 2] + share * (positions[b + 2] - positions[a + 2]),
  );
}
