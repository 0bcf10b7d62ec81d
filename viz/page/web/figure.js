// The skin of a body, on its bones (viz/figure/figure.h).

import {
  BufferAttribute, BufferGeometry, Color, Matrix4, MeshLambertMaterial, Quaternion, Skeleton,
  SkinnedMesh, SRGBColorSpace, Vector3,
} from 'three';

const kOnes = new Vector3(1, 1, 1);

// Where each bone is in the pose that the vertices are in, and back.
function inversesOf(bind) {
  const inverses = [];
  for (let i = 0; i < bind.length; i += 7) {
    const p = new Vector3().fromArray(bind, i);
    const q = new Quaternion().fromArray(bind, i + 3);
    inverses.push(new Matrix4().compose(p, q, kOnes).invert());
  }
  return inverses;
}

function linearColors(bytes) {
  const colors = new Float32Array(bytes.length);
  const color = new Color();
  for (let i = 0; i < bytes.length; i += 3) {
    color.setRGB(bytes[i] / 255, bytes[i + 1] / 255, bytes[i + 2] / 255, SRGBColorSpace);
    color.toArray(colors, i);
  }
  return colors;
}

export function makeFigure(page, json, bones) {
  const geometry = new BufferGeometry();
  const add = (name, array, size) => geometry.setAttribute(name, new BufferAttribute(array, size));
  add('position', page.array(json.vertices), 3);
  add('normal', page.array(json.normals), 3);
  add('color', linearColors(page.array(json.colors)), 3);
  add('skinIndex', page.array(json.joints), 4);
  add('skinWeight', page.array(json.weights), 4);
  geometry.setIndex(new BufferAttribute(page.array(json.triangles), 1));
  const mesh = new SkinnedMesh(geometry, new MeshLambertMaterial({ vertexColors: true }));
  mesh.bind(new Skeleton(bones, inversesOf(page.array(json.bind))), new Matrix4());
  mesh.frustumCulled = false;
  mesh.castShadow = true;
  mesh.receiveShadow = true;
  return mesh;
}
