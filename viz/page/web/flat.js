// Flat things that lie on the ground.

import { BufferAttribute, BufferGeometry } from 'three';

/** Triangles of many of them as one geometry. */
export class Flat {
  constructor() {
    this.positions = [];
    this.triangles = [];
  }

  get isEmpty() {
    return this.triangles.length === 0;
  }

  addQuad(a, b, c, d) {
    const k = this.positions.length / 3;
    this.positions.push(...a, ...b, ...c, ...d);
    this.triangles.push(k, k + 1, k + 2, k, k + 2, k + 3);
  }

  /** A convex outline, or one that its middle sees all of: [[x, y], ...]. */
  addFan(outline) {
    const first = this.positions.length / 3, count = outline.length;
    let x = 0, y = 0;
    for (const p of outline) {
      x += p[0] / count;
      y += p[1] / count;
    }
    this.positions.push(x, y, 0);
    for (const p of outline) this.positions.push(p[0], p[1], 0);
    for (let i = 0; i < count; ++i) {
      this.triangles.push(first, first + 1 + i, first + 1 + ((i + 1) % count));
    }
  }

  /** A band along points x, y, z one after another, `lift` over them. */
  addRibbon(points, width, lift) {
    const count = points.length / 3, first = this.positions.length / 3;
    for (let i = 0; i < count; ++i) {
      const a = 3 * Math.max(0, i - 1), b = 3 * Math.min(count - 1, i + 1);
      const x = points[b] - points[a], y = points[b + 1] - points[a + 1];
      const half = width / 2 / (Math.hypot(x, y) || 1);
      for (const side of [half, -half]) {
        this.positions.push(points[3 * i] - side * y, points[3 * i + 1] + side * x, points[3 * i + 2] + lift);
      }
      if (i === 0) continue;
      const k = first + 2 * i;
      this.triangles.push(k - 2, k - 1, k, k, k - 1, k + 1);
    }
  }

  geometry() {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(this.positions), 3));
    geometry.setIndex(this.triangles);
    return geometry;
  }
}

export function fan(outline) {
  const flat = new Flat();
  flat.addFan(outline);
  return flat.geometry();
}

export function ribbon(points, width, lift) {
  const flat = new Flat();
  flat.addRibbon(points, width, lift);
  return flat.geometry();
}
