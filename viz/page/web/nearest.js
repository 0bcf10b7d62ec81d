// What is nearest to the body: a line with its length.

import { BufferAttribute, BufferGeometry, Line, LineBasicMaterial, Vector3 } from 'three';

export class Nearest {
  constructor(group, label) {
    this.group = group;
    this.label = label;
    this.on = true;
    this.at = new Vector3();
    this.text = '';
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(6), 3));
    this.line = new Line(geometry, new LineBasicMaterial({ color: 0xd92d20, depthTest: false }));
    this.line.frustumCulled = false;
    this.line.renderOrder = 11;
    group.add(this.line);
  }

  setTake(take) {
    this.clearance = take.clearance;
    this.hide();
  }

  show(on) {
    this.on = on;
    if (!on) this.hide();
  }

  hide() {
    this.line.visible = false;
    this.label.hidden = true;
  }

  update(frame, camera, canvas) {
    if (!this.on || !this.clearance) return;
    const distance = this.clearance.distance[frame];
    if (distance < 0) {
      this.hide();
      return;
    }
    const p = this.clearance.points;
    const o = 6 * frame;
    const ends = this.line.geometry.attributes.position;
    for (let i = 0; i < 6; ++i) ends.array[i] = p[o + i];
    ends.needsUpdate = true;
    this.line.visible = true;
    this.at.set(p[o] + p[o + 3], p[o + 1] + p[o + 4], p[o + 2] + p[o + 5]).multiplyScalar(0.5);
    this.at.project(camera);
    this.label.hidden = Math.abs(this.at.x) > 1 || Math.abs(this.at.y) > 1 || this.at.z > 1;
    const x = ((this.at.x + 1) / 2) * canvas.clientWidth;
    const y = ((1 - this.at.y) / 2) * canvas.clientHeight;
    this.label.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
    const text = distance < 1 ? `${(100 * distance).toFixed(1)} cm` : `${distance.toFixed(2)} m`;
    if (text !== this.text) this.label.firstElementChild.textContent = this.text = text;
  }
}
