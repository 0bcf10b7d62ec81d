// See three_of_build.mjs.

import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const web = pathToFileURL(join(process.env.AMBLE_WEB, 'package.json')).href;

export function resolve(specifier, context, next) {
  return next(specifier, /^three($|\/)/.test(specifier) ? { ...context, parentURL: web } : context);
}
