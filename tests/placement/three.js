// three.js' BVHLoader places every joint where Amble does, to 0.1 mm.
//
//   node three.js FOLDER          of three.js, with build/three.js and examples/js/loaders/BVHLoader.js
//                WALK.bvh JOINTS  as place_joints writes them
'use strict';
const fs = require('fs');
const path = require('path');

const [folder, walk, joints] = process.argv.slice(2);
global.THREE = require(path.join(folder, 'build', 'three.js'));
require('vm').runInThisContext(fs.readFileSync(path.join(folder, 'examples/js/loaders/BVHLoader.js'), 'utf8'));

const loaded = new THREE.BVHLoader().parse(fs.readFileSync(walk, 'utf8'));
const root = loaded.skeleton.bones[0];
const bones = new Map(loaded.skeleton.bones.map((bone) => [bone.name, bone]));

function showFrame(frame) {
  for (const track of loaded.clip.tracks) {
    const [, name, quantity] = track.name.match(/^\.bones\[(.*)\]\.(\w+)$/);
    const size = quantity === 'position' ? 3 : 4;
    bones.get(name)[quantity].fromArray(track.values, frame * size);
  }
  root.updateMatrixWorld(true);
}

let shown = -1;
let compared = 0;
let worst = 0;
for (const line of fs.readFileSync(joints, 'utf8').trim().split('\n')) {
  const [frame, name, x, y, z] = line.split(' ');
  if (Number(frame) !== shown) showFrame((shown = Number(frame)));
  const there = new THREE.Vector3().setFromMatrixPosition(bones.get(name).matrixWorld);
  const here = new THREE.Vector3(Number(x), Number(z), -Number(y));  // World to y up
  worst = Math.max(worst, there.distanceTo(here));
  ++compared;
}
console.log(`three.js r${THREE.REVISION}: ${compared} joints, farthest apart ${(1000 * worst).toFixed(4)} mm`);
process.exit(compared > 0 && worst <= 1e-4 ? 0 : 1);
