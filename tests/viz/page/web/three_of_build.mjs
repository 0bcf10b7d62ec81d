// Lets the page's modules be imported as they stand in viz/page/web: what they ask npm for, three.js,
// is where the build has put it (AMBLE_WEB).
//   AMBLE_WEB=BUILD/web node --import ./three_of_build.mjs TEST.mjs

import { register } from 'node:module';

register('./three_hooks.mjs', import.meta.url);
