// GLB files against Khronos' validator, and, of a walk, three.js' reading of them against its reading of the BVH.
//
//   node glb.mjs MODULES FILE.glb...    MODULES: a folder in which npm has put three and gltf-validator
//
// Beside X.glb may lie X.bvh, the same motion: every joint must be in the same place, to 0.1 mm, at every frame.
import fs from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

const [modules, ...files] = process.argv.slice(2);
const packages = path.join(path.resolve(modules), 'node_modules');
const load = (file) => import(pathToFileURL(path.join(packages, file)));
globalThis.self = globalThis; // which GLTFLoader expects of a browser
const THREE = await load('three/build/three.module.js');
const { GLTFLoader } = await load('three/examples/jsm/loaders/GLTFLoader.js');
const { BVHLoader } = await load('three/examples/jsm/loaders/BVHLoader.js');
const validator = createRequire(import.meta.url)(path.join(packages, 'gltf-validator'));

const LARGEST = 1e-4; // [m]
let failed = files.length === 0;

async function validate(file, bytes) {
  const { issues } = await validator.validateBytes(bytes, { maxIssues: 20 });
  if (issues.numErrors + issues.numWarnings === 0) return;
  failed = true;
  for (const issue of issues.messages) console.log(`${file}: ${issue.code} ${issue.message} ${issue.pointer}`);
}

const read = (bytes) =>
  new Promise((resolve, reject) =>
    new GLTFLoader().parse(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength), '', resolve, reject));

// Of joints by the names that three gives both; each file is asked at its own times.
async function compare(file, bytes, walk) {
  const glb = await read(bytes);
  const bvh = new BVHLoader().parse(fs.readFileSync(walk, 'utf8'));
  let skin;
  glb.scene.traverse((node) => (skin ??= node.isSkinnedMesh ? node : undefined));
  const root = bvh.skeleton.bones[0];
  const players = [
    [glb.scene, glb.animations[0]],
    [root, bvh.clip],
  ].map(([scene, clip]) => {
    const mixer = new THREE.AnimationMixer(scene);
    const action = mixer.clipAction(clip).setLoop(THREE.LoopOnce);
    action.clampWhenFinished = true;
    action.play();
    return (frame) => mixer.setTime(clip.tracks[0].times[frame]);
  });
  const named = new Map(bvh.skeleton.bones.map((bone) => [bone.name, bone]));
  const frames = bvh.clip.tracks[0].times.length;
  const [here, there] = [new THREE.Vector3(), new THREE.Vector3()];
  let [worst, compared] = [0, 0];
  for (let frame = 0; frame < frames; ++frame) {
    for (const show of players) show(frame);
    glb.scene.updateMatrixWorld(true);
    root.updateMatrixWorld(true);
    for (const bone of skin.skeleton.bones) {
      here.setFromMatrixPosition(bone.matrixWorld);
      there.setFromMatrixPosition(named.get(bone.name).matrixWorld);
      worst = Math.max(worst, here.distanceTo(there));
      ++compared;
    }
  }
  console.log(`${file}: ${compared} joints, farthest apart ${(1000 * worst).toFixed(4)} mm`);
  if (compared === 0 || !(worst <= LARGEST)) failed = true;
}

for (const file of files) {
  const bytes = new Uint8Array(fs.readFileSync(file));
  await validate(file, bytes);
  const walk = file.replace(/\.glb$/, '.bvh');
  if (fs.existsSync(walk)) await compare(file, bytes, walk);
}
console.log(`${files.length} files, three.js r${THREE.REVISION}, validator ${validator.version()}: ${failed ? 'failed' : 'good'}`);
process.exit(failed ? 1 : 0);
