// The page: reads its data, puts the parts together, runs the clock.

import { readPage } from './data.js';
import { Viewer } from './viewer.js';
import { Controls } from './controls.js';
import { Bench } from './bench.js';

function webglIsThere() {
  try {
    return Boolean(document.createElement('canvas').getContext('webgl2'));
  } catch {
    return false;
  }
}

function start() {
  if (!webglIsThere()) {
    document.getElementById('no-webgl').hidden = false;
    return;
  }
  const viewer = new Viewer(readPage(document), document.getElementById('view'));
  const controls = new Controls(viewer, document);
  controls.begin();
  if (viewer.page.bench) viewer.bench = new Bench(viewer);
  viewer.run();
  window.amble = viewer;  // for scripts and for the curious, as in tests/viz/page
}

start();
