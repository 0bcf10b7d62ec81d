import assert from 'node:assert/strict';
import test from 'node:test';
import { readPage } from '../../../../viz/page/web/data.js';
import { near, seeded } from './seeded.mjs';

// The two elements that hold a page's data, as viz/page/page.h writes them.
function documentOf(json, bytes) {
  const texts = { 'amble-data': JSON.stringify(json), 'amble-bytes': Buffer.from(bytes).toString('base64') };
  return { getElementById: (id) => ({ textContent: texts[id] }) };
}

// Arrays one after another, each at a multiple of four bytes, and what names them.
function packed(arrays) {
  const refs = [], parts = [];
  let at = 0;
  for (const [t, values] of arrays) {
    refs.push({ t, o: at, n: values.length });
    const size = 4 * Math.ceil(values.byteLength / 4);
    parts.push(Buffer.concat([Buffer.from(values.buffer), Buffer.alloc(size - values.byteLength)]));
    at += size;
  }
  return { refs, bytes: Buffer.concat(parts) };
}

const kKinds = { f32: Float32Array, i16: Int16Array, u8: Uint8Array, u16: Uint16Array, u32: Uint32Array };

test('arrays of every type come back bit for bit, however long the one before is', () => {
  const random = seeded(1);
  const arrays = [];
  for (let round = 0; round < 8; ++round) {
    for (const [t, Kind] of Object.entries(kKinds)) {
      const bytes = Uint8Array.from({ length: Kind.BYTES_PER_ELEMENT * Math.floor(7 * random()) }, () => Math.floor(256 * random()));
      arrays.push([t, new Kind(bytes.buffer)]);
    }
  }
  const { refs, bytes } = packed(arrays);
  const page = readPage(documentOf({}, bytes));
  refs.forEach((ref, i) => {
    const read = page.array(ref);
    assert.equal(read.constructor, kKinds[ref.t]);
    assert.deepEqual(Buffer.from(read.buffer, read.byteOffset, read.byteLength), Buffer.from(arrays[i][1].buffer));
  });
});

test('an array is looked at in place: what is written into it is seen by the next reader', () => {
  const { refs, bytes } = packed([['u8', Uint8Array.of(1, 2, 3)], ['f32', Float32Array.of(4)]]);
  const page = readPage(documentOf({}, bytes));
  page.array(refs[1])[0] = 7;
  assert.equal(page.array(refs[1])[0], 7);
  assert.deepEqual([...page.array(refs[0])], [1, 2, 3]);
});

test('numbers with a scale are so many units of it, those without are themselves', () => {
  const random = seeded(2);
  const units = Int16Array.from({ length: 100 }, () => Math.floor(65536 * random()) - 32768);
  const plain = Float32Array.from({ length: 5 }, random);
  const { refs, bytes } = packed([['i16', units], ['f32', plain]]);
  const page = readPage(documentOf({}, bytes));
  near(page.numbers({ ...refs[0], scale: 0.01 }), Array.from(units, (unit) => unit * 0.01), 1e-4);
  assert.deepEqual(page.numbers(refs[1]), plain);
});

test('what else is in the JSON stays as it is', () => {
  const json = { title: '</script> "x" \u2028 漢', takes: [{ frames: 3 }], walk: null };
  const page = readPage(documentOf(json, []));
  for (const [key, value] of Object.entries(json)) assert.deepEqual(page[key], value);
});

test('an array beyond the bytes is refused, not cut', () => {
  const page = readPage(documentOf({}, Buffer.alloc(8)));
  assert.throws(() => page.array({ t: 'f32', o: 4, n: 2 }), RangeError);
  assert.throws(() => page.array({ t: 'f32', o: 2, n: 1 }), RangeError);
});
