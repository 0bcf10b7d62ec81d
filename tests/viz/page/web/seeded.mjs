// Numbers that look random and are the same in every run.

/** @returns () => a number in [0, 1): mulberry32, of Tommy Ettinger */
export function seeded(seed) {
  return () => {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/** `count` numbers in [low, high). */
export function numbersIn(random, count, low, high) {
  return Array.from({ length: count }, () => low + (high - low) * random());
}

/** Fails where two lists of numbers are not of one length, or differ by more. */
export function near(found, expected, within, what = '') {
  const [a, b] = [found, expected].map((one) => (typeof one === 'number' ? [one] : [...one]));
  if (a.length !== b.length) throw new Error(`${what}: ${a.length} numbers in place of ${b.length}`);
  a.forEach((value, i) => {
    if (!(Math.abs(value - b[i]) <= within)) throw new Error(`${what} [${i}]: ${value} is not ${b[i]} within ${within}`);
  });
}
