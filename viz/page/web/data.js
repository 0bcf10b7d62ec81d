// The page's data as viz/page/page.h writes it: JSON, and arrays that look into one run of bytes.

const kTypes = {
  f32: Float32Array,
  i16: Int16Array,
  u8: Uint8Array,
  u16: Uint16Array,
  u32: Uint32Array,
};

function bytesOf(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes.buffer;
}

// Numbers that were written in 16 bits.
function scaled(values, scale) {
  return scale === undefined ? values : Float32Array.from(values, (value) => value * scale);
}

/** @returns {{array: (ref: object) => ArrayBufferView}} with the JSON's fields */
export function readPage(document) {
  const page = JSON.parse(document.getElementById('amble-data').textContent);
  const bytes = bytesOf(document.getElementById('amble-bytes').textContent);
  page.numbers = (ref) => scaled(page.array(ref), ref.scale);
  page.array = (ref) => new kTypes[ref.t](bytes, ref.o, ref.n);
  return page;
}
