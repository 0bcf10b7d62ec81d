// What the page knows of each clip (viz/page/bench.h), its arrays looked up when they are asked for.

export function clipsOf(page) {
  return page.bench.clips.map((json, index) => new BenchClip(page, json, index));
}

export class BenchClip {
  constructor(page, json, index) {
    this.page = page;
    this.json = json;
    this.index = index;
    this.name = page.takes[index].name;
    this.frameTime = json.frame_time;             // of the file
    this.shownTime = json.frame_time * json.every;  // of the page
    this.from = json.first_frame * json.frame_time;  // that the analysis begins at [s]
    this.joints = json.joints;
    this.motion = page.bench.library?.motions[index] ?? null;
    this.join = page.bench.graph?.joins.find(({ take }) => take === index) ?? null;
    this.floor = json.floor;
    this.analysis = json.analysis;
    this.phase = json.phase.map(([frame, phase]) => [frame * json.frame_time, phase]);
    this.cache = new Map();
  }

  /** An array of numbers. */
  numbers(ref) {
    if (!this.cache.has(ref)) this.cache.set(ref, this.page.numbers(ref));
    return this.cache.get(ref);
  }

  get duration() {
    return this.page.takes[this.index].frames * this.shownTime - this.shownTime;
  }

  /** Of a library's walk or movement, over its phase: { fourier, captured: [...] } a channel. */
  get cycle() {
    return this.motion?.cycle ?? null;
  }

  get period() {
    return this.motion.measures.period;
  }

  cycleCurve(ref) {
    return { from: 0, step: 1 / (this.cycle.points - 1), values: this.numbers(ref) };
  }

  get type() {
    return this.join ? 'transition' : this.analysis?.class.type ?? '';
  }

  get gait() {
    return this.analysis?.gait ?? {};
  }

  /** Curves of a joint: [{ label, from, step, values }], one a channel. */
  channels(joint) {
    return Object.entries(this.joints[joint].channels).map(([label, ref]) => ({
      label, from: 0, step: this.shownTime, values: this.numbers(ref),
    }));
  }

  rootCurve(key) {
    const ref = this.json.root[key];
    return ref ? { from: 0, step: this.shownTime, values: this.numbers(ref) } : null;
  }

  /** @param side  0 left, 1 right @param point  'ankle' | 'toe' @param key  'height' | 'speed' */
  footCurve(side, point, key) {
    const foot = this.json.feet[side][point];
    return { from: this.from, step: this.frameTime, values: this.numbers(foot[key]), limit: foot[`${key}_limit`] };
  }

  /** Times at which a foot stands [[from, to], ...] [s]. */
  plants(side) {
    const foot = side === 0 ? 'left' : 'right';
    return (this.analysis?.plants ?? []).filter((plant) => plant.foot === foot)
      .map((plant) => [plant.strike, plant.lift_off]);
  }

  /** [{ kind, time }] */
  events(side) {
    const foot = side === 0 ? 'left' : 'right';
    const events = [];
    for (const swing of this.analysis?.events ?? []) {
      if (swing.foot !== foot) continue;
      for (const kind of ['lift', 'lift_off', 'strike', 'landing'])
        if (typeof swing[kind] === 'number') events.push({ kind, time: swing[kind] });
    }
    return events;
  }
}
