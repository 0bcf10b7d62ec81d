// The page: reads its data, puts the parts together, runs the clock.

import { readPage } from './data.js';
import { Viewer } from './viewer.js';
import { Controls } from './controls.js';
import { Bench } from './bench.js';

function start() {
  const canvas = document.getElementById('view');
  const context = canvas.getContext('webgl2', { antialias: true, powerPreference: 'high-performance' });
  if (!context) {
    document.getElementById('no-webgl').hidden = false;
    return;
  }
  const viewer = new Viewer(readPage(document), canvas, context);
  const controls = new Controls(viewer, document);
  controls.begin();
  if (viewer.page.bench) viewer.bench = new Bench(viewer);
  viewer.run();
  window.amble = viewer;  // for scripts and for the curious, as in tests/viz/page
}

start();
