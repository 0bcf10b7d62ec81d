// As much of a browser's document as the page's modules ask for, so that they run without one: elements
// that hold what is put into them, and canvases that write down what is drawn on them.

class Style {
  setProperty(name, value) {
    this[name] = String(value);
  }
  getPropertyValue(name) {
    return this[name] ?? '';
  }
}

// Of each call of a canvas' pen its name, its numbers, and how the pen was set.
class Pen {
  constructor(canvas) {
    this.canvas = canvas;
    this.calls = [];
    this.kept = [];
    for (const name of ['beginPath', 'closePath', 'moveTo', 'lineTo', 'arc', 'rect', 'roundRect', 'fill', 'stroke', 'clip',
      'fillRect', 'strokeRect', 'fillText', 'setLineDash', 'setTransform', 'scale', 'translate', 'rotate'])
      this[name] = (...values) => this.note(name, values);
  }
  note(name, values) {
    const { fillStyle, strokeStyle, textAlign, lineWidth, globalAlpha } = this;
    this.calls.push({ name, values, fillStyle, strokeStyle, textAlign, lineWidth, globalAlpha });
  }
  clearRect() {
    this.calls = [];
  }
  save() {
    this.kept.push({ ...this });
  }
  restore() {
    const { calls, kept } = this;
    Object.assign(this, this.kept.pop(), { calls, kept });
  }
  measureText(text) {
    return { width: 6 * text.length };
  }
  /** Texts as they are written, in order. */
  get texts() {
    return this.calls.filter(({ name }) => name === 'fillText').map(({ values }) => String(values[0]));
  }
}

class Element extends EventTarget {
  constructor(tag) {
    super();
    this.tagName = tag.toUpperCase();
    this.children = [];
    this.parent = null;
    this.dataset = {};
    this.style = new Style();
    this.attributes = new Map();
    this.className = '';
    this.value = '';
    [this.clientWidth, this.clientHeight, this.scrollTop, this.offsetTop] = [600, 300, 0, 0];
    this.classList = {
      has: (name) => this.classes.includes(name), contains: (name) => this.classes.includes(name),
      toggle: (name, on = !this.classes.includes(name)) => {
        this.className = [...this.classes.filter((one) => one !== name), ...(on ? [name] : [])].join(' ');
      },
      add: (name) => this.classList.toggle(name, true),
    };
  }
  get classes() {
    return this.className.split(' ').filter(Boolean);
  }
  append(...children) {
    for (const child of children) {
      if (child instanceof Element) child.parent = this;
      this.children.push(child);
    }
  }
  add(option) {
    if (this.children.length === 0 || option.selected) this.value = String(option.value);
    this.append(option);
  }
  replaceChildren(...children) {
    this.children = [];
    this.append(...children);
  }
  get lastElementChild() {
    return this.children.findLast((child) => child instanceof Element);
  }
  get firstElementChild() {
    return this.children.find((child) => child instanceof Element);
  }
  get textContent() {
    return this.children.map((child) => (child instanceof Element ? child.textContent : child)).join('');
  }
  set textContent(text) {
    this.children = [String(text)];
  }
  setAttribute(name, value) {
    this.attributes.set(name, value);
  }
  getAttribute(name) {
    return this.attributes.get(name) ?? null;
  }
  /** Every element below it, itself first. */
  get all() {
    return [this, ...this.children.filter((child) => child instanceof Element).flatMap((child) => child.all)];
  }
  querySelector(selector) {
    const key = /^\[data-key=(.+)\]$/.exec(selector)?.[1];
    return this.all.find((one) => (key ? one.dataset.key === key : one.classes.includes(selector.slice(1)) || one.tagName === selector.toUpperCase())) ?? null;
  }
  getContext() {
    return (this.pen ??= new Pen(this));
  }
  getBoundingClientRect() {
    return { left: 0, top: 0, width: this.clientWidth, height: this.clientHeight, right: this.clientWidth, bottom: this.clientHeight };
  }
  getRootNode() {
    return document;
  }
  get ownerDocument() {
    return document;
  }
  setPointerCapture() {}
  releasePointerCapture() {}
  scrollIntoView() {}
  /** An event of that kind with these properties is sent. */
  send(kind, properties = {}) {
    const event = new Event(kind, { cancelable: true });
    Object.assign(event, properties);
    this.dispatchEvent(event);
    return event;
  }
  click() {
    this.send('click');
  }
}

/** An element that stands in no document. */
export const element = (tag) => new Element(tag);

const byId = new Map();
/** Forgets all elements of the document that have an id, and who listens to them. */
export const forgetElements = () => byId.clear();
globalThis.document = Object.assign(new Element('html'), {
  createElement: element,
  createTextNode: (text) => text,
  body: element('body'),
  documentElement: element('html'),
  // Made when it is asked for.
  getElementById: (id) => byId.get(id) ?? byId.set(id, Object.assign(element('div'), { id })).get(id),
});
globalThis.devicePixelRatio = 1;
globalThis.Option = class extends Element {
  constructor(text, value, byDefault, selected = false) {
    super('option');
    Object.assign(this, { textContent: text, value: String(value), selected });
  }
};
// A colour is its name.
globalThis.getComputedStyle = () => ({ getPropertyValue: (name) => name });
globalThis.ResizeObserver = class {
  observe() {}
};
