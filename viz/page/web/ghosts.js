// The trace of a motion: its skeleton in every n-th frame, and the way of its root (the thesis'
// trace view).

import {
  BufferAttribute, BufferGeometry, Color, CylinderGeometry, Group, InstancedMesh, Line,
  LineBasicMaterial, Matrix4, MeshStandardMaterial, Quaternion, Vector3,
} from 'three';
import { kPathColor } from './colors.js';

const kMost = 24000;     // bones of a trace: beyond, it is thinned
const kThick = 0.011;    // of a bone [m]
const kUp = new Vector3(0, 1, 0);
const kFrom = new Color(0x0e9384), kTo = new Color(0x2e90fa), kSecondFrom = new Color(0x7a5af8), kSecondTo = new Color(0xdd2590);

export class Ghosts {
  constructor(viewer) {
    this.viewer = viewer;
    this.group = new Group();
    viewer.stage.overlays.add(this.group);
    this.stick = new CylinderGeometry(1, 1, 1, 6, 1, true);
  }

  clear() {
    for (const mesh of this.group.children) {
      mesh.material.dispose();
      mesh.dispose?.();
    }
    this.group.clear();
    for (const line of this.lines ?? []) {
      line.removeFromParent();
      line.geometry.dispose();
      line.material.dispose();
    }
    this.lines = [];
    this.drawn = 0;
  }

  /** @param every  frames of the file; 0: no trace @param shown  [{ take, actor, clip, second }]
   * @param inPlace  on the spot there is neither way nor trace */
  draw(every, shown, inPlace) {
    this.clear();
    this.placeGround(shown[0], inPlace);
    if (inPlace) return;
    for (const one of shown) {
      if (one.second || !one.take.way) this.lines.push(this.rootLine(one));
      if (every > 0) this.group.add(this.trace(every, one));
    }
    if (this.lines.length > 0) this.viewer.layers.groups.path.add(...this.lines);
  }

  // What lies on the floor lies on it where the first clip stands; on the spot there is none.
  placeGround({ clip }, inPlace) {
    for (const name of ['path', 'prints']) {
      for (const mesh of this.viewer.layers.groups[name].children) {
        mesh.visible = !inPlace;
        mesh.userData.height ??= mesh.position.z;
        mesh.position.z = mesh.userData.height - clip.floor;
      }
    }
  }

  rootLine({ take, actor, clip, second }) {
    const points = new Float32Array(take.root.length);
    const p = new Vector3();
    for (let i = 0; i < points.length; i += 3) {
      p.fromArray(take.root, i);
      p.z = clip.floor + 0.006;
      p.applyMatrix4(actor.group.matrixWorld).toArray(points, i);
    }
    const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(points, 3));
    return new Line(geometry, new LineBasicMaterial({ color: second ? kSecondFrom : kPathColor }));
  }

  trace(every, { take, actor, second }) {
    const bones = actor.ends;
    const step = Math.max(1, Math.round(every / take.every));
    const thinned = Math.max(step, Math.ceil((take.frames * bones.length) / kMost));
    const frames = [];
    for (let frame = 0; frame < take.frames; frame += thinned) frames.push(frame);
    const mesh = new InstancedMesh(this.stick, new MeshStandardMaterial({ roughness: 0.8 }), frames.length * bones.length);
    const matrix = new Matrix4(), turn = new Quaternion(), size = new Vector3(), color = new Color();
    let at = 0;
    frames.forEach((frame) => {
      actor.pose(take, frame * take.frameTime);
      const share = frame / Math.max(1, take.frames - 1);
      color.lerpColors(second ? kSecondFrom : kFrom, second ? kSecondTo : kTo, share);
      for (const end of bones) {
        const [from, to] = actor.endsOf(end);
        const length = from.distanceTo(to);
        size.set(kThick, Math.max(length, 1e-4), kThick);
        if (length > 1e-4) turn.setFromUnitVectors(kUp, to.clone().sub(from).divideScalar(length));
        matrix.compose(from.add(to).multiplyScalar(0.5), turn, size);
        mesh.setMatrixAt(at, matrix);
        mesh.setColorAt(at, color);
        ++at;
      }
    });
    this.drawn += frames.length;
    this.viewer.posed = -1;
    mesh.frustumCulled = false;
    return mesh;
  }
}
