// Attempts that were refused: their root paths, with a cross where they failed.

import { Group, Mesh } from 'three';
import { Flat } from './flat.js';

const kArm = 0.05, kBar = 0.009;  // half the length and breadth of a cross's bar [m]

export class Attempts {
  /** @param material  (color, opacity) => a flat one */
  constructor(page, material) {
    this.group = new Group();
    const played = new Flat(), others = new Flat(), crosses = new Flat();
    this.edges = page.walk.attempts.map((json) => {
      const line = page.array(json.line);
      (json.take === null ? others : played).addRibbon(line, 0.014, 0.009);
      addCross(crosses, json.at[0], json.at[1], line[line.length - 1] + 0.012);
      return { take: json.take, line };
    });
    this.add(others, material(0xd92d20, 0.28));
    this.add(played, material(0xd92d20, 0.8));
    this.add(crosses, material(0xd92d20, 0.8));
  }

  add(flat, material) {
    if (flat.isEmpty) return;
    const mesh = new Mesh(flat.geometry(), material);
    mesh.renderOrder = 4;
    this.group.add(mesh);
  }
}

function addCross(flat, x, y, z) {
  for (const side of [1, -1]) {
    const along = [kArm * Math.SQRT1_2, side * kArm * Math.SQRT1_2];
    const across = [-side * kBar * Math.SQRT1_2, kBar * Math.SQRT1_2];
    const corner = (a, b) => [x + a * along[0] + b * across[0], y + a * along[1] + b * across[1], z];
    flat.addQuad(corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1));
  }
}
