// The room: its surfaces as few meshes; walls and ceilings that stand between the eye and the walker
// give way.

import {
  Box3, BufferAttribute, BufferGeometry, Color, DoubleSide, Group, InstancedMesh, Matrix4, Mesh,
  MeshLambertMaterial, Ray, SRGBColorSpace, Vector3,
} from 'three';
import { creasedNormals } from './normals.js';

const kMany = 12;      // equal things from which on they are instances of one mesh
const kGrid = 65535;   // steps along a side of a surface's box
const kMostWalls = 400;  // beyond, walls are things like others

const kBeyond = 0.35;    // how far beyond a wall its other side is looked for [m]
const kHip = 0.9;        // of a walker over his feet [m]
const kAround = 0.8;     // what is to be seen around the walker [m]

const kThing = new MeshLambertMaterial({ vertexColors: true, side: DoubleSide });
const kLit = new MeshLambertMaterial({
  color: 0xf04438, emissive: 0x7a1510, side: DoubleSide, transparent: true, opacity: 0.75,
  polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -1,
});
const kGhost = new MeshLambertMaterial({
  vertexColors: true, transparent: true, opacity: 0.1, depthWrite: false,
});

// A surface where it stands: matrix from its box, colour, object and kind.
function* instancesOf(page, json) {
  const placings = page.array(json.placings);
  const colors = page.array(json.colors);
  const objects = page.array(json.objects);
  for (let i = 0; i < objects.length; ++i) {
    const p = placings.subarray(12 * i, 12 * i + 12);
    const color = new Color().setRGB(
      colors[3 * i] / 255, colors[3 * i + 1] / 255, colors[3 * i + 2] / 255, SRGBColorSpace,
    );
    // Columns, of three numbers each.
    const matrix = new Matrix4().set(
      p[0], p[3], p[6], p[9], p[1], p[4], p[7], p[10], p[2], p[5], p[8], p[11], 0, 0, 0, 1,
    );
    yield { matrix, color, object: objects[i], kind: json.kinds[i] };
  }
}

// Corners of a surface, placed.
function placed(corners, matrix) {
  const points = new Float32Array(corners.length);
  const p = new Vector3();
  for (let i = 0; i < corners.length; i += 3) {
    p.set(corners[i] / kGrid, corners[i + 1] / kGrid, corners[i + 2] / kGrid).applyMatrix4(matrix);
    p.toArray(points, i);
  }
  return points;
}

// Triangles of many surfaces, each of one colour, as one geometry.
class Merge {
  constructor() {
    this.pieces = [];
    this.count = 0;
  }

  add(points, triangles, color) {
    const piece = creasedNormals(points, triangles);
    this.pieces.push({ ...piece, color });
    this.count += piece.positions.length;
  }

  geometry() {
    const positions = new Float32Array(this.count);
    const normals = new Float32Array(this.count);
    const colors = new Float32Array(this.count);
    let at = 0;
    for (const piece of this.pieces) {
      positions.set(piece.positions, at);
      normals.set(piece.normals, at);
      for (let i = 0; i < piece.positions.length; i += 3) piece.color.toArray(colors, at + i);
      at += piece.positions.length;
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setAttribute('normal', new BufferAttribute(normals, 3));
    geometry.setAttribute('color', new BufferAttribute(colors, 3));
    return geometry;
  }
}

// Equal things as instances. Normals belong to the proportions of the first of them.
function instanced(corners, triangles, instances) {
  const size = new Vector3().setFromMatrixScale(instances[0].matrix);
  const points = placed(corners, new Matrix4().makeScale(size.x, size.y, size.z));
  const { positions, normals } = creasedNormals(points, triangles);
  const scale = [size.x, size.y, size.z];
  for (let i = 0; i < positions.length; ++i) {
    positions[i] = scale[i % 3] > 0 ? positions[i] / scale[i % 3] : 0;
    normals[i] *= scale[i % 3];
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('normal', new BufferAttribute(normals, 3));
  const mesh = new InstancedMesh(
    geometry, new MeshLambertMaterial({ side: DoubleSide }), instances.length,
  );
  instances.forEach((instance, i) => {
    mesh.setMatrixAt(i, instance.matrix);
    mesh.setColorAt(i, instance.color);
  });
  mesh.castShadow = mesh.receiveShadow = true;
  return mesh;
}

export class Room {
  constructor(page) {
    this.page = page;
    this.group = new Group();
    this.walls = [];
    this.ceilings = [];
    this.floors = [];
    this.gives = true;
    if (page.room) this.build(page);
    for (const wall of this.walls) wall.outside = this.outsideOf(wall.box);
  }

  build(page) {
    const floor = new Merge(), thing = new Merge();
    for (const json of page.room.meshes) {
      const corners = page.array(json.corners);
      const triangles = page.array(json.triangles);
      const others = [];
      for (const instance of instancesOf(page, json)) {
        const points = () => placed(corners, instance.matrix);
        const alone = this.walls.length + this.ceilings.length < kMostWalls;
        if (instance.kind === 'floor') {
          floor.add(points(), triangles, instance.color);
          this.floors.push(boxAround(points()));
        } else if (instance.kind === 'wall' && alone) {
          this.walls.push(this.addAlone(points(), triangles, instance.color));
        } else if (instance.kind === 'ceiling' && alone) {
          this.ceilings.push(this.addAlone(points(), triangles, instance.color));
        } else {
          others.push(instance);
        }
      }
      if (others.length >= kMany) {
        this.group.add(instanced(corners, triangles, others));
      } else {
        for (const other of others) thing.add(placed(corners, other.matrix), triangles, other.color);
      }
    }
    this.addMerge(floor, false);
    this.addMerge(thing, true);
  }

  addMerge(merge, throwsShadow) {
    if (merge.count === 0) return;
    const mesh = new Mesh(merge.geometry(), kThing);
    mesh.castShadow = throwsShadow;
    mesh.receiveShadow = true;
    this.group.add(mesh);
  }

  // A surface that can give way.
  addAlone(points, triangles, color) {
    const merge = new Merge();
    merge.add(points, triangles, color);
    const mesh = new Mesh(merge.geometry(), kThing);
    mesh.receiveShadow = true;
    this.group.add(mesh);
    return { mesh, box: boxAround(points) };
  }

  // By side of a wall, the lower first: whether there is no floor beyond; and the axis across it.
  outsideOf(box) {
    const size = box.getSize(new Vector3());
    const axis = size.x < size.y ? 'x' : 'y';
    const sides = [box.min[axis] - kBeyond, box.max[axis] + kBeyond].map((value) => {
      const p = box.getCenter(new Vector3());
      p[axis] = value;
      return !this.floors.some((f) => p.x > f.min.x && p.x < f.max.x && p.y > f.min.y && p.y < f.max.y);
    });
    return { axis, sides };
  }

  /** A thing, by its index in the scene, or -1 for none, lights up. */
  light(object) {
    if (this.lit) {
      this.group.remove(this.lit);
      this.lit.geometry.dispose();
      this.lit = null;
    }
    if (object < 0 || !this.page.room) return;
    const merge = new Merge();
    for (const json of this.page.room.meshes) {
      for (const instance of instancesOf(this.page, json)) {
        if (instance.object !== object) continue;
        const corners = this.page.array(json.corners);
        merge.add(placed(corners, instance.matrix), this.page.array(json.triangles), instance.color);
      }
    }
    if (merge.count === 0) return;
    this.lit = new Mesh(merge.geometry(), kLit);
    this.group.add(this.lit);
  }

  /** Lets what stands between the eye and the walker give way. @param aim  the walker's hips */
  giveWay(cameras, aim) {
    const eye = cameras.current.position;
    const inside = cameras.mode === 'first';
    for (const { mesh, box } of this.ceilings) {
      const above = eye.z < box.min.z || aim.z - kHip > box.max.z - 0.3;
      mesh.visible = inside || !this.gives || above || !covers(box, eye, aim);
    }
    for (const wall of this.walls) {
      const gives = this.gives && !inside && cameras.mode !== 'top' && hides(wall, eye, aim);
      wall.mesh.material = gives ? kGhost : kThing;
    }
  }
}

/** Whether the walker is under it, or seen through it. */
function covers(box, eye, aim) {
  const under = aim.x > box.min.x && aim.x < box.max.x && aim.y > box.min.y && aim.y < box.max.y;
  return under || between(kWide.copy(box).expandByScalar(kAround), eye, aim);
}

function between(box, eye, aim) {
  kRay.origin.copy(eye);
  kRay.direction.subVectors(aim, eye);
  const away = kRay.direction.length();
  kRay.direction.divideScalar(away || 1);
  const hit = kRay.intersectBox(box, kHit);
  return hit !== null && hit.distanceTo(eye) < away - 0.2;
}

function hides({ box, outside }, eye, aim) {
  const { axis, sides } = outside;
  if (sides[0] && eye[axis] < box.min[axis]) return true;
  if (sides[1] && eye[axis] > box.max[axis]) return true;
  kWide.copy(box).expandByScalar(kAround);
  kWide.min[axis] += kAround;
  kWide.max[axis] -= kAround;
  return between(kWide, eye, aim);
}

const kWide = new Box3(), kRay = new Ray(), kHit = new Vector3();

function boxAround(points) {
  return new Box3().setFromArray(points);
}
