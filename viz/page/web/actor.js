// A body that moves: its bones, and what hangs on them.

import {
  Bone, BufferAttribute, BufferGeometry, CapsuleGeometry, Group, LineBasicMaterial, LineSegments,
  Matrix4, Mesh, MeshLambertMaterial, Quaternion, Vector3,
} from 'three';
import { kLeftColor, kRightColor } from './colors.js';
import { makeFigure } from './figure.js';

const kUp = new Vector3(0, 1, 0);
const kLit = new MeshLambertMaterial({ color: 0xf04438, emissive: 0xb42318 });

function bonesOf(joints) {
  const bones = joints.map((joint) => {
    const bone = new Bone();
    bone.name = joint.name;
    bone.position.fromArray(joint.offset);
    return bone;
  });
  joints.forEach((joint, i) => {
    if (joint.parent >= 0) bones[joint.parent].add(bones[i]);
  });
  return bones;
}

function capsuleOf(part, material) {
  const from = new Vector3().fromArray(part.from);
  const along = new Vector3().fromArray(part.to).sub(from);
  const mesh = new Mesh(new CapsuleGeometry(part.radius, along.length(), 8, 20), material);
  mesh.position.copy(from).addScaledVector(along, 0.5);
  if (along.length() > 0) {
    mesh.quaternion.copy(new Quaternion().setFromUnitVectors(kUp, along.normalize()));
  }
  mesh.castShadow = true;
  mesh.name = part.name;
  return mesh;
}

export class Actor {
  constructor(page, json) {
    this.name = json.name;
    this.json = json.body;
    this.bones = bonesOf(json.body.joints);
    this.root = this.bones[0];
    this.group = new Group();
    this.group.add(this.root);
    this.parts = this.addCapsules();
    this.lines = this.addBones();
    this.figure = json.figure ? makeFigure(page, json.figure, this.bones) : null;
    if (this.figure) this.group.add(this.figure);
    this.eye = json.body.head >= 0 ? this.parts[json.body.head] : this.bones[0];
  }

  addCapsules() {
    const skin = new MeshLambertMaterial({ color: 0xb9c2cf });
    const soles = [kLeftColor, kRightColor].map(
      (color) => new MeshLambertMaterial({ color }),
    );
    this.skins = this.json.parts.map((part) => (part.side >= 0 ? soles[part.side] : skin));
    return this.json.parts.map((part, i) => {
      const mesh = capsuleOf(part, this.skins[i]);
      this.bones[part.joint].add(mesh);
      return mesh;
    });
  }

  // Lines from joint to joint, drawn over all else; their ends are moved every frame.
  addBones() {
    this.ends = [];
    this.json.joints.forEach((joint, i) => {
      if (joint.parent >= 0) this.ends.push([this.bones[joint.parent], this.bones[i], null]);
      for (const tip of joint.tips) this.ends.push([this.bones[i], null, new Vector3().fromArray(tip)]);
    });
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(this.ends.length * 6), 3));
    const lines = new LineSegments(
      geometry,
      new LineBasicMaterial({ color: 0x7c3aed, depthTest: false, transparent: true }),
    );
    lines.frustumCulled = false;
    lines.renderOrder = 10;
    this.group.add(lines);
    return lines;
  }

  show({ body, capsules, bones }) {
    if (this.figure) this.figure.visible = body;
    for (const part of this.parts) part.visible = capsules;
    this.lines.visible = bones || this.parts.length === 0;
    this.shown = { body, capsules, bones };
  }

  /** A part of the body, or -1 for none, lights up. */
  light(part) {
    this.parts.forEach((mesh, i) => {
      mesh.material = i === part ? kLit : this.skins[i];
      mesh.visible = this.shown.capsules || i === part;
      mesh.scale.setScalar(i === part ? 1.06 : 1);
    });
  }

  /** Poses the body as the take has it at a time [s]. */
  pose(take, time) {
    take.pose(this.bones, time);
    this.root.updateMatrixWorld(true);
    if (this.lines.visible) this.drawBones();
  }

  /** After its group has been moved. */
  redraw() {
    if (this.lines.visible) this.drawBones();
  }

  // Both ends of a bone, in World.
  endsOf([from, to, tip]) {
    const start = new Vector3().setFromMatrixPosition(from.matrixWorld);
    if (to) return [start, new Vector3().setFromMatrixPosition(to.matrixWorld)];
    return [start, tip.clone().applyMatrix4(from.matrixWorld)];
  }

  // Its lines are in its group, which may have been moved.
  drawBones() {
    const at = this.lines.geometry.attributes.position;
    const home = kHome.copy(this.group.matrixWorld).invert();
    for (let i = 0; i < this.ends.length; ++i) {
      const [from, to, tip] = this.ends[i];
      kPoint.setFromMatrixPosition(from.matrixWorld).applyMatrix4(home);
      at.setXYZ(2 * i, kPoint.x, kPoint.y, kPoint.z);
      if (to) kPoint.setFromMatrixPosition(to.matrixWorld);
      else kPoint.copy(tip).applyMatrix4(from.matrixWorld);
      kPoint.applyMatrix4(home);
      at.setXYZ(2 * i + 1, kPoint.x, kPoint.y, kPoint.z);
    }
    at.needsUpdate = true;
  }
}

const kHome = new Matrix4();
const kPoint = new Vector3();
