// Where everything is drawn: the renderer, light and ground.

import {
  Color, DirectionalLight, GridHelper, Group, HemisphereLight, PCFShadowMap, Scene,
  WebGLRenderer,
} from 'three';
import { kBackground } from './colors.js';

const kSlow = 1 / 40;  // frames that take longer on the average are made of fewer pixels [s]
const kShadowed = 24;  // rooms larger than this are shadowed around the walker only [m]

export class Stage {
  constructor(canvas, context) {
    this.renderer = new WebGLRenderer({ canvas, context });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.renderer.shadowMap.autoUpdate = false;  // but when something moves
    this.renderer.shadowMap.needsUpdate = true;
    this.scene = new Scene();
    this.ratio = Math.min(devicePixelRatio, 2);
    this.average = 1 / 60;
    this.overlays = new Group();
    this.scene.add(this.overlays);
    this.addLight();
  }

  addLight() {
    this.sky = new HemisphereLight(0xffffff, 0xcfc8bd, 2.0);
    this.sky.position.set(0, 0, 1);
    this.sun = new DirectionalLight(0xfff6e8, 1.9);
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(2048, 2048);
    this.sun.shadow.bias = -0.0006;
    this.sun.shadow.normalBias = 0.012;
    this.sun.shadow.radius = 3;
    this.scene.add(this.sky, this.sun, this.sun.target);
  }

  /** Light for what lies within these bounds. */
  setBounds(bounds) {
    this.bounds = bounds;
    const size = Math.min(kShadowed, Math.hypot(bounds.max.x - bounds.min.x, bounds.max.y - bounds.min.y) + 2);
    const camera = this.sun.shadow.camera;
    camera.left = camera.bottom = -size / 2;
    camera.right = camera.top = size / 2;
    camera.near = 0.5;
    camera.far = 80;
    camera.updateProjectionMatrix();
    this.follows = size >= kShadowed;
    this.lightUp((bounds.min.x + bounds.max.x) / 2, (bounds.min.y + bounds.max.y) / 2, bounds.min.z);
  }

  lightUp(x, y, z) {
    this.sun.target.position.set(x, y, z);
    this.sun.position.set(x - 12, y - 9, z + 32);
  }

  /** The walker is here: what surrounds him gets shadows. */
  watch(x, y, z) {
    if (!this.follows) return;
    const step = 4;  // so that shadows do not swim [m]
    this.lightUp(Math.round(x / step) * step, Math.round(y / step) * step, Math.round(z / step) * step - 1);
  }

  addGrid(size, z) {
    this.grid = new GridHelper(size, size, 0x8a94a6, 0x8a94a6);
    this.grid.rotation.x = Math.PI / 2;
    this.grid.position.z = z - 0.004;
    this.grid.material.transparent = true;
    this.grid.material.opacity = 0.25;
    this.scene.add(this.grid);
  }

  setTheme(theme) {
    this.scene.background = new Color(kBackground[theme]);
    this.sky.intensity = theme === 'dark' ? 1.25 : 2.0;
    this.sun.intensity = theme === 'dark' ? 1.5 : 1.9;
  }

  resize(width, height) {
    this.renderer.setPixelRatio(this.ratio);
    this.renderer.setSize(width, height, false);
  }

  /** Fewer pixels where frames come too slowly. @returns whether the size changed */
  adapt(elapsed) {
    if (elapsed > 0.5) return false;
    this.average += 0.05 * (elapsed - this.average);
    if (this.average < kSlow || this.ratio <= 0.75) return false;
    this.ratio = Math.max(0.75, this.ratio * 0.75);
    this.average = 1 / 60;
    return true;
  }

  render(camera) {
    this.renderer.render(this.scene, camera);
  }
}
