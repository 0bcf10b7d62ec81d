// Flat things that lie on the ground.

import { BufferAttribute, BufferGeometry } from 'three';

function geometryOf(positions, triangles) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3));
  geometry.setIndex(triangles);
  return geometry;
}

/** A convex outline, or one that its middle sees all of: [[x, y], ...]. */
export function fan(outline) {
  const positions = [0, 0, 0];
  const triangles = [];
  for (const [x, y] of outline) {
    positions[0] += x / outline.length;
    positions[1] += y / outline.length;
    positions.push(x, y, 0);
  }
  for (let i = 0; i < outline.length; ++i) {
    triangles.push(0, 1 + i, 1 + ((i + 1) % outline.length));
  }
  return geometryOf(positions, triangles);
}

/** A band along points x, y, z one after another, `lift` over them. */
export function ribbon(points, width, lift) {
  const count = points.length / 3;
  const positions = [];
  const triangles = [];
  for (let i = 0; i < count; ++i) {
    const a = 3 * Math.max(0, i - 1), b = 3 * Math.min(count - 1, i + 1);
    const x = points[b] - points[a], y = points[b + 1] - points[a + 1];
    const half = width / 2 / (Math.hypot(x, y) || 1);
    for (const side of [half, -half]) {
      positions.push(points[3 * i] - side * y, points[3 * i + 1] + side * x, points[3 * i + 2] + lift);
    }
    if (i > 0) {
      const k = 2 * i;
      triangles.push(k - 2, k - 1, k, k, k - 1, k + 1);
    }
  }
  return geometryOf(positions, triangles);
}
