// The clock: what time it is in the take, and whether it runs.

export const kSpeeds = [0.1, 0.25, 0.5, 1, 2];

export class Player {
  constructor() {
    this.time = 0;
    this.speed = 1;
    this.playing = false;
    this.looping = true;
    this.take = null;
    this.changed = () => {};
  }

  setTake(take, time = 0) {
    this.take = take;
    this.playing &&= this.duration > 0;  // what does not move has no time that could go on
    this.seek(time);
  }

  get duration() {
    return this.take ? this.take.duration : 0;
  }

  play(on = true) {
    this.playing = on && this.duration > 0;
    if (this.playing && this.time >= this.duration - 1e-6) this.time = 0;
    this.changed();
  }

  seek(time) {
    this.time = Math.max(0, Math.min(this.duration, time));
    this.changed();
  }

  stepFrames(count) {
    this.playing = false;
    this.seek((this.take.frameAt(this.time) + count) * this.take.frameTime);
  }

  /** To the next moment, or the one before, at which a foot comes down. */
  stepSteps(count) {
    this.playing = false;
    const frame = this.take.frameAt(this.time);
    const steps = this.take.steps;
    const later = steps.find((step) => step > frame) ?? this.take.frames - 1;
    const before = steps.findLast((step) => step < frame) ?? 0;
    this.seek((count > 0 ? later : before) * this.take.frameTime);
  }

  /** @returns whether time went on */
  tick(elapsed) {
    if (!this.playing) return false;
    this.time += elapsed * this.speed;
    if (this.time > this.duration) {
      if (this.looping && !this.take.stop) {
        this.time %= this.duration;
      } else {
        this.time = this.duration;
        this.playing = false;
        this.changed();
      }
    }
    return true;
  }
}
