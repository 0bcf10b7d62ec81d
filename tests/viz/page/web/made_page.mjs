// A page's data as its program has it, made by hand: arrays are kept as they are given.

/** The JSON names arrays by themselves; `numbers` of a reference { scale, values } are scaled. */
export function madePage(json = {}) {
  const array = (ref) => ref;
  return {
    title: '', why: '', floor: 0, facts: [], notes: [], actors: [], takes: [], room: null, walk: null, bench: null, ...json,
    array, numbers: array,
  };
}

/** A take of `frames` frames in which nobody moves. @param more  what is otherwise */
export function madeTake({ frames = 11, joints = 2, frameTime = 0.1, ...more } = {}) {
  return {
    name: 'take', actor: 0, frames, frame_time: frameTime, every: 1,
    root: new Float32Array(3 * frames),
    rotations: Float32Array.from({ length: 4 * joints * frames }, (_, i) => (i % 4 === 3 ? 1 : 0)),
    planted: [[], []], events: [], prints: [], sources: [], clearance: null, ...more,
  };
}

/** The root's places, from x, y, z of each frame. */
export function rootOf(frames, place) {
  return Float32Array.from(Array.from({ length: frames }, (_, i) => place(i)).flat());
}

/** A quaternion about an axis of length 1 [rad]: x, y, z, w. */
export function turnAbout(axis, angle) {
  const s = Math.sin(angle / 2);
  return [s * axis[0], s * axis[1], s * axis[2], Math.cos(angle / 2)];
}
