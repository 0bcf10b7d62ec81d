// Ground as strips: how far one gets, where a body can be.

import { BufferAttribute, BufferGeometry, Group, Mesh } from 'three';

const kLift = 0.006;  // over the ground [m]

// The strips of one kind as one mesh.
function meshOf(points, kinds, kind, breadth, material) {
  const positions = [];
  const triangles = [];
  for (let i = 0; i < kinds.length; ++i) {
    if (kinds[i] !== kind) continue;
    const [ax, ay, az, bx, by, bz] = points.subarray(6 * i, 6 * i + 6);
    const k = positions.length / 3, half = breadth / 2;
    positions.push(ax, ay - half, az + kLift, bx, by - half, bz + kLift, bx, by + half, bz + kLift, ax, ay + half, az + kLift);
    triangles.push(k, k + 1, k + 2, k, k + 2, k + 3);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3));
  geometry.setIndex(triangles);
  const mesh = new Mesh(geometry, material);
  mesh.renderOrder = 1;
  return mesh;
}

/** @param materials  one a kind */
export function groundOf(page, json, materials) {
  const group = new Group();
  const points = page.array(json.strips), kinds = page.array(json.kind);
  materials.forEach((material, kind) => group.add(meshOf(points, kinds, kind, json.breadth, material)));
  return group;
}
