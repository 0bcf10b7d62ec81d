// Ground as strips: how far one gets, where a body can be.

import { Group, Mesh } from 'three';
import { Flat } from './flat.js';

const kLift = 0.006;  // over the ground [m]

// The strips of one kind as one mesh.
function meshOf(points, kinds, kind, breadth, material) {
  const flat = new Flat(), half = breadth / 2;
  for (let i = 0; i < kinds.length; ++i) {
    if (kinds[i] !== kind) continue;
    const [ax, ay, az, bx, by, bz] = points.subarray(6 * i, 6 * i + 6);
    flat.addQuad(
      [ax, ay - half, az + kLift], [bx, by - half, bz + kLift],
      [bx, by + half, bz + kLift], [ax, ay + half, az + kLift],
    );
  }
  const mesh = new Mesh(flat.geometry(), material);
  mesh.renderOrder = 1;
  return mesh;
}

/** @param materials  one a kind */
export function groundOf(page, json, materials) {
  const group = new Group();
  const points = page.array(json.strips), kinds = page.array(json.kind);
  materials.forEach((material, kind) => {
    if (kinds.includes(kind)) group.add(meshOf(points, kinds, kind, json.breadth, material));
  });
  return group;
}
