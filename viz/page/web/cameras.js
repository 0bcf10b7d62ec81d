// Where one looks from: round about, along with the walker, from above, through the walker's eyes.

import { MOUSE, OrthographicCamera, PerspectiveCamera, TOUCH, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

export const kModes = ['orbit', 'follow', 'top', 'first'];

const kFollowTime = 0.25;  // in which a camera comes after the walker [s]
const kLost = 1.5;         // farther away the camera jumps after him [m]
const kEyesAhead = 0.11;   // of the middle of the head [m]
const kLooksDown = 0.18;   // of a walker's gaze [1]

export class Cameras {
  constructor(element, bounds, aim) {
    this.bounds = bounds;
    this.aim = aim.clone();
    this.perspective = new PerspectiveCamera(42, 1, 0.05, 2000);
    this.perspective.up.set(0, 0, 1);
    this.eyes = new PerspectiveCamera(75, 1, 0.05, 500);
    this.eyes.up.set(0, 0, 1);
    this.top = new OrthographicCamera(-1, 1, 1, -1, 0.1, 1000);
    this.top.up.set(0, 1, 0);
    this.orbit = new OrbitControls(this.perspective, element);
    this.orbit.maxPolarAngle = Math.PI * 0.495;
    this.orbit.minDistance = 0.4;
    this.orbit.enableDamping = true;
    this.orbit.dampingFactor = 0.15;
    this.orbit.zoomToCursor = true;
    this.plan = new OrbitControls(this.top, element);
    this.plan.enableRotate = false;
    this.plan.screenSpacePanning = true;
    this.plan.mouseButtons = { LEFT: MOUSE.PAN, MIDDLE: MOUSE.DOLLY, RIGHT: MOUSE.PAN };
    this.plan.touches = { ONE: TOUCH.PAN, TWO: TOUCH.DOLLY_PAN };
    this.turned = { yaw: 0, pitch: 0 };
    this.listenForLooks(element);
    this.changed = () => {};
    this.orbit.addEventListener('change', () => this.changed());
    this.plan.addEventListener('change', () => this.changed());
    this.free = 1;
    this.frameAll();
    this.setMode('orbit');
    for (const controls of [this.orbit, this.plan]) {
      controls.addEventListener('start', () => (this.moved = true));
    }
  }

  // In first person, dragging turns the head.
  listenForLooks(element) {
    let from = null;
    element.addEventListener('pointerdown', (event) => (from = [event.clientX, event.clientY]));
    element.addEventListener('pointerup', () => (from = null));
    element.addEventListener('pointercancel', () => (from = null));
    element.addEventListener('pointermove', (event) => {
      if (!from || this.mode !== 'first') return;
      this.turned.yaw += (event.clientX - from[0]) * 0.004;
      this.turned.pitch += (event.clientY - from[1]) * 0.004;
      this.turned.yaw = Math.max(-1.6, Math.min(1.6, this.turned.yaw));
      this.turned.pitch = Math.max(-1.1, Math.min(0.9, this.turned.pitch));
      from = [event.clientX, event.clientY];
      this.changed();
    });
  }

  get current() {
    return this.mode === 'top' ? this.top : this.mode === 'first' ? this.eyes : this.perspective;
  }

  // Everything in sight, from a raised corner and from above.
  frameAll(free = this.free) {
    this.free = free;
    const { min, max } = this.bounds;
    const middle = new Vector3().addVectors(min, max).multiplyScalar(0.5);
    middle.z = Math.min(middle.z, min.z + 0.8);
    const size = Math.max(2.2, Math.hypot(max.x - min.x, max.y - min.y));
    const wide = Math.min(1, this.perspective.aspect);
    const away = (0.5 * size) / Math.tan((this.perspective.fov * Math.PI) / 360) / Math.max(0.36, wide) / Math.min(1, free * 1.3);
    this.orbit.target.copy(middle);
    this.perspective.position.set(middle.x - 0.42 * away, middle.y - 0.7 * away, middle.z + 0.58 * away);
    this.orbit.maxDistance = 6 * size + 20;
    this.orbit.update();
    this.plan.target.set(middle.x, middle.y, min.z);
    this.top.position.set(middle.x, middle.y, max.z + 100);
    this.top.zoom = 1;
    this.plan.update();
  }

  setMode(mode) {
    this.mode = mode;
    this.orbit.enabled = mode === 'orbit' || mode === 'follow';
    this.plan.enabled = mode === 'top';
    this.turned.yaw = this.turned.pitch = 0;
    if (mode === 'follow') this.comeNear();
    this.changed();
  }

  comeNear() {
    kShift.subVectors(this.perspective.position, this.orbit.target).setLength(5);
    this.orbit.target.copy(this.aim);
    this.perspective.position.copy(this.aim).add(kShift);
    this.orbit.update();
  }

  resize(width, height, covered) {
    const aspect = width / height;
    const first = !this.sized;
    this.sized = true;
    for (const camera of [this.perspective, this.eyes]) {
      camera.aspect = aspect;
      camera.setViewOffset(width, height, 0, camera === this.eyes ? 0 : covered / 2, width, height);
      camera.updateProjectionMatrix();
    }
    const { min, max } = this.bounds;
    const free = Math.max(0.3, 1 - covered / height - 0.1);
    const half = 0.53 * Math.max((max.y - min.y) / free, (max.x - min.x) / aspect, 2);
    this.top.top = half;
    this.top.bottom = -half;
    this.top.right = half * aspect;
    this.top.left = -half * aspect;
    this.top.setViewOffset(width, height, 0, covered / 2, width, height);
    this.top.updateProjectionMatrix();
    // A window that is made narrower is to hold all as well, unless somebody looks elsewhere.
    if (first || Math.abs(covered - this.covered) > 1 || Math.abs(aspect - this.aspect) > 0.01) {
      this.covered = covered;
      this.aspect = aspect;
      if (!this.moved && (first || this.mode !== 'follow')) this.frameAll(free);
    }
  }

  /** @param aim  middle of the walker's body  @param head  of it  @param heading  [rad] */
  update(aim, head, heading, elapsed) {
    if (this.mode === 'follow') this.follow(aim, elapsed);
    this.aim.copy(aim);
    if (this.mode === 'orbit' || this.mode === 'follow') this.orbit.update();
    if (this.mode === 'top') this.plan.update();
    if (this.mode === 'first') this.lookOut(head, heading);
  }

  follow(aim, elapsed) {
    kShift.subVectors(aim, this.orbit.target);
    if (kShift.length() < kLost) kShift.multiplyScalar(1 - Math.exp(-elapsed / kFollowTime));
    this.orbit.target.add(kShift);
    this.perspective.position.add(kShift);
  }

  lookOut(head, heading) {
    const yaw = heading + this.turned.yaw;
    const c = Math.cos(heading), s = Math.sin(heading);
    this.eyes.position.set(head.x + kEyesAhead * c, head.y + kEyesAhead * s, head.z + 0.03);
    kShift.set(Math.cos(yaw), Math.sin(yaw), Math.tan(this.turned.pitch) - kLooksDown);
    this.eyes.lookAt(kShift.add(this.eyes.position));
  }
}

const kShift = new Vector3();
