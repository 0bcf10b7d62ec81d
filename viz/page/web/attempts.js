// Attempts that were refused: their root paths, with a cross where they failed.

import { Group, Mesh } from 'three';
import { fan, ribbon } from './flat.js';

export class Attempts {
  /** @param material  (color, opacity) => a flat one */
  constructor(page, material) {
    this.group = new Group();
    const red = material(0xd92d20, 0.8), faint = material(0xd92d20, 0.28);
    this.edges = page.walk.attempts.map((json) => {
      const line = page.array(json.line);
      const band = new Mesh(ribbon(line, 0.014, 0.009), json.take === null ? faint : red);
      band.renderOrder = 4;
      this.group.add(band);
      for (const turn of [0.25, -0.25]) {
        const bar = new Mesh(fan([[-0.05, -0.008], [0.05, -0.008], [0.05, 0.008], [-0.05, 0.008]]), red);
        bar.position.fromArray(line, line.length - 3);
        bar.position.z += 0.012;
        bar.rotation.z = turn * Math.PI;
        bar.renderOrder = 5;
        this.group.add(bar);
      }
      return { take: json.take, line };
    });
  }
}
