// Buttons, keys and the address: what people do, told to the viewer.

import { kModes } from './cameras.js';
import { kSourceColors } from './colors.js';
import { kSpeeds } from './player.js';
import { edgeAt } from './roadmap.js';
import { Timeline } from './timeline.js';

const kMoved = 5;  // a pointer that has moved so far did not click [CSS pixels]

export class Controls {
  constructor(viewer, document) {
    this.viewer = viewer;
    this.player = viewer.player;
    this.byId = (id) => document.getElementById(id);
    this.timeline = new Timeline(this.byId('timeline'), this.player);
  }

  begin() {
    this.fillCard();
    this.addLayers();
    this.addCameras();
    this.addTransport();
    this.addKeys();
    this.addClicks();
    this.addTheme();
    this.player.changed = () => this.refresh();
    this.viewer.drawn = () => this.showTime();
    this.viewer.listeners.push(() => this.showTake());
    const resized = new ResizeObserver(() => this.resize());
    resized.observe(this.viewer.canvas);
    resized.observe(this.byId('transport'));
    window.addEventListener('hashchange', () => this.goToHash());
    const moving = this.viewer.takes.some((take) => take.duration > 0);
    this.byId('transport').hidden = !moving;
    if (!moving) return;
    this.showTake();
    if (this.viewer.take.stop) {
      this.player.seek(this.player.duration);  // where it fails
    } else if (!this.goToHash() && !matchMedia('(prefers-reduced-motion: reduce)').matches) {
      this.player.play();
    }
  }

  fillCard() {
    const { page } = this.viewer;
    this.byId('title').textContent = page.title;
    for (const [label, value] of page.facts) {
      const dt = document.createElement('dt'), dd = document.createElement('dd');
      dt.textContent = label;
      dd.textContent = value;
      this.byId('facts').append(dt, dd);
    }
    const why = this.byId('why');
    why.textContent = page.why;
    why.hidden = !page.why;
    for (const note of [...notesOfRoom(page.room), ...page.notes]) {
      const p = document.createElement('p');
      p.textContent = note;
      this.byId('notes').append(p);
    }
  }

  addLayers() {
    const list = this.byId('layer-list');
    for (const layer of this.viewer.layers.list) {
      const label = document.createElement('label');
      const box = document.createElement('input');
      box.type = 'checkbox';
      box.checked = layer.on;
      box.id = `layer-${layer.key}`;
      box.addEventListener('change', () => this.viewer.layers.set(layer.key, box.checked));
      label.append(box, document.createTextNode(layer.label));
      list.append(label);
    }
    const toggle = this.byId('layers-toggle');
    const panel = this.byId('layers');
    const open = (on) => {
      panel.classList.toggle('open', on);
      toggle.setAttribute('aria-expanded', String(on));
    };
    toggle.addEventListener('click', () => open(!panel.classList.contains('open')));
    // Open where there is room for it beside the picture: a phone that is turned has another.
    const wide = matchMedia(`(min-width: ${this.viewer.page.bench ? 1100 : 800}px) and (min-height: 480px)`);
    wide.addEventListener('change', () => open(wide.matches));
    open(wide.matches);
  }

  addCameras() {
    for (const mode of kModes) {
      const button = this.byId(`camera-${mode}`);
      button.addEventListener('click', () => this.look(mode));
      if (this.viewer.takes.length === 0 && (mode === 'follow' || mode === 'first')) button.hidden = true;
    }
  }

  look(mode) {
    const { cameras } = this.viewer;
    if (this.byId(`camera-${mode}`).hidden) return;
    if (mode === 'orbit' && cameras.mode === 'orbit') cameras.frameAll();
    cameras.setMode(mode);
    for (const other of kModes) {
      this.byId(`camera-${other}`).setAttribute('aria-pressed', String(other === mode));
    }
  }

  addTransport() {
    const on = (id, act) => this.byId(id).addEventListener('click', act);
    on('play', () => this.player.play(!this.player.playing));
    on('frame-back', () => this.player.stepFrames(-1));
    on('frame-on', () => this.player.stepFrames(1));
    on('step-back', () => this.player.stepSteps(-1));
    on('step-on', () => this.player.stepSteps(1));
    on('back', () => this.viewer.show(0));
    if (this.viewer.page.why) this.byId('back').textContent = 'Back';
    on('help', () => this.byId('keys').showModal());
    on('keys-close', () => this.byId('keys').close());
    const speed = this.byId('speed');
    for (const one of kSpeeds) speed.add(new Option(`${one}×`, one, one === 1, one === 1));
    speed.addEventListener('change', () => (this.player.speed = Number(speed.value)));
  }

  changeSpeed(by) {
    const at = kSpeeds.indexOf(this.player.speed) + by;
    if (at < 0 || at >= kSpeeds.length) return;
    this.player.speed = kSpeeds[at];
    this.byId('speed').value = String(kSpeeds[at]);
  }

  addKeys() {
    const keys = {
      ' ': () => this.player.play(!this.player.playing),
      k: () => this.player.play(!this.player.playing),
      ArrowLeft: (event) => (event.shiftKey ? this.player.stepSteps(-1) : this.player.stepFrames(-1)),
      ArrowRight: (event) => (event.shiftKey ? this.player.stepSteps(1) : this.player.stepFrames(1)),
      ',': () => this.player.stepFrames(-1),
      '.': () => this.player.stepFrames(1),
      '[': () => this.player.stepSteps(-1),
      ']': () => this.player.stepSteps(1),
      Home: () => this.player.seek(0),
      End: () => this.player.seek(this.player.duration),
      '-': () => this.changeSpeed(-1),
      '+': () => this.changeSpeed(1),
      1: () => this.look('orbit'),
      2: () => this.look('follow'),
      3: () => this.look('top'),
      4: () => this.look('first'),
      l: () => this.byId('layers-toggle').click(),
      Escape: () => this.viewer.index > 0 && this.viewer.show(0),
      '?': () => this.byId('keys').showModal(),
    };
    document.addEventListener('keydown', (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey || this.byId('keys').open) return;
      const at = event.target.tagName;
      if (event.key === ' ' && /^(SELECT|INPUT|BUTTON)$/.test(at)) return;
      if (event.key.startsWith('Arrow') && at === 'SELECT') return;
      const act = keys[keyOf(event)];
      if (!act || this.viewer.takes.length === 0) return;
      event.preventDefault();
      act(event);
    });
  }

  // A click on an edge of the roadmap plays it.
  addClicks() {
    const { canvas, layers, cameras } = this.viewer;
    let from = null;
    canvas.addEventListener('pointerdown', (event) => (from = [event.clientX, event.clientY]));
    canvas.addEventListener('pointerup', (event) => {
      if (!from || !layers.roadmap) return;
      if (Math.hypot(event.clientX - from[0], event.clientY - from[1]) > kMoved) return;
      const box = canvas.getBoundingClientRect();
      for (const name of ['roadmap', 'attempts']) {
        if (!layers.groups[name].visible) continue;
        const edge = edgeAt(layers[name].edges, event.clientX - box.left, event.clientY - box.top, cameras.current, canvas);
        if (edge < 0) continue;
        this.playEdge(name, edge);
        return;
      }
    });
  }

  playEdge(name, index) {
    const { layers } = this.viewer;
    this.viewer.show(layers[name].edges[index].take);
    layers.roadmap.choose(name === 'roadmap' ? index : -1);
    this.player.play();
  }

  addTheme() {
    const system = matchMedia('(prefers-color-scheme: dark)');
    const apply = () => {
      const theme = this.theme ?? (system.matches ? 'dark' : 'light');
      document.documentElement.dataset.theme = theme;
      this.viewer.stage.setTheme(theme);
      this.viewer.dirty = true;
      if (this.viewer.take) this.timeline.draw();
    };
    system.addEventListener('change', apply);
    this.byId('theme').addEventListener('click', () => {
      this.theme = document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark';
      apply();
    });
    apply();
  }

  // What the time line covers is no place to look at: the picture's middle lies above it.
  resize() {
    const transport = this.byId('transport');
    document.documentElement.style.setProperty('--transport', `${transport.offsetHeight}px`);
    const below = this.viewer.canvas.getBoundingClientRect().bottom - transport.getBoundingClientRect().top;
    this.viewer.resize(Math.max(0, Math.min(transport.offsetHeight, below)));
    if (this.viewer.take) this.timeline.draw();
  }

  showTake() {
    const { viewer } = this;
    this.byId('back').hidden = viewer.index === 0;
    const named = viewer.index > 0 || viewer.take.stop || viewer.actors.length > 1;
    this.byId('take-name').textContent = named ? viewer.take.name : '';
    if (viewer.index === 0) viewer.layers.roadmap?.choose(-1);
    this.timeline.draw();
    this.refresh();
  }

  refresh() {
    const { playing } = this.player;
    this.viewer.dirty = true;
    const play = this.byId('play');
    play.classList.toggle('playing', playing);
    play.setAttribute('aria-label', playing ? 'Pause' : 'Play');
    if (!playing && this.viewer.index === 0 && this.begun) this.keepHash();
    this.begun = true;
  }

  // Text changes ten times a second: more is not read.
  showTime() {
    const { time, duration, take, playing } = this.player;
    if (!take) return;
    this.timeline.update();
    const now = playing ? `${Math.floor(time * 10)} tenths` : time;
    if (now === this.said) return;
    this.said = now;
    const frame = take.frameAt(time);
    this.byId('time').textContent = `${time.toFixed(2)} / ${duration.toFixed(2)} s`;
    this.byId('frame').textContent = `frame ${frame * take.every}`;
    this.showSources(frame);
    const slider = this.byId('timeline');
    slider.setAttribute('aria-valuenow', time.toFixed(2));
    slider.setAttribute('aria-valuemax', duration.toFixed(2));
    slider.setAttribute('aria-valuetext', `${time.toFixed(2)} seconds, frame ${frame * take.every}`);
  }

  showSources(frame) {
    const chips = this.viewer.take.sourcesAt(frame).map(({ name, index, share }) => {
      const chip = document.createElement('span');
      chip.style.setProperty('--chip', kSourceColors[index % kSourceColors.length]);
      chip.textContent = `${name} ${Math.round(100 * share)} %`;
      return chip;
    });
    this.byId('sources').replaceChildren(...chips);
  }

  // #t=3.2 [s]
  goToHash() {
    const found = /^#t=([0-9]*\.?[0-9]+)$/.exec(location.hash);
    if (!found || this.viewer.takes.length === 0) return false;
    this.player.playing = false;
    this.player.seek(Number(found[1]));
    return true;
  }

  keepHash() {
    clearTimeout(this.keeping);
    this.keeping = setTimeout(() => {
      history.replaceState(null, '', `#t=${+this.player.time.toFixed(3)}`);
    }, 300);
  }
}

/** The key of an event, a letter as a small one: capitals are locked, or the page's list of keys is followed. */
export function keyOf({ key }) {
  return /^[A-Z]$/.test(key) ? key.toLowerCase() : key;
}

// A room of very many triangles is shown with fewer.
function notesOfRoom(room) {
  if (!room?.thinned) return [];
  const [all, shown] = [room.triangles, room.shown].map((n) => n.toLocaleString('en'));
  const lost = room.thinned < 1 ? `${(100 * room.thinned).toPrecision(2)} cm` : `${room.thinned.toFixed(1)} m`;
  return [`The room has ${all} triangles. ${shown} are shown: details of up to ${lost} are left out here, nowhere else.`];
}
