// Elements, made in one call.

/** @param props  properties; `on` has listeners, `data` attributes data-..., `aria` aria-... */
export function make(tag, props = {}, ...children) {
  const element = document.createElement(tag);
  const { on = {}, data = {}, aria = {}, ...rest } = props;
  Object.assign(element, rest);
  Object.assign(element.dataset, data);
  for (const [name, value] of Object.entries(aria)) element.setAttribute(`aria-${name}`, value);
  for (const [name, act] of Object.entries(on)) element.addEventListener(name, act);
  element.append(...children);
  return element;
}

/** Buttons of which one is pressed. @param options  [[key, label, title], ...] */
export function choice(label, options, chosen, act) {
  const buttons = options.map(([key, text, title = '']) => make('button', {
    type: 'button', textContent: text, title, data: { key }, aria: { pressed: String(key === chosen) },
    on: { click: () => group.choose(key) },
  }));
  const group = make('div', { className: 'choice', role: 'group', aria: { label } }, ...buttons);
  group.choose = (key) => {
    for (const button of buttons) button.setAttribute('aria-pressed', String(button.dataset.key === key));
    act(key);
  };
  return group;
}

/** A canvas as large as it is shown, cleared, in CSS pixels, for small text: { c, width, height }; null where it is not shown. */
export function penOf(canvas) {
  const width = canvas.clientWidth, height = canvas.clientHeight;
  if (width === 0 || height === 0) return null;
  const ratio = Math.min(devicePixelRatio, 2);
  if (canvas.width !== Math.round(width * ratio)) canvas.width = Math.round(width * ratio);
  if (canvas.height !== Math.round(height * ratio)) canvas.height = Math.round(height * ratio);
  const c = canvas.getContext('2d');
  c.setTransform(ratio, 0, 0, ratio, 0, 0);
  c.clearRect(0, 0, width, height);
  c.font = '11px system-ui, sans-serif';
  c.textBaseline = 'middle';
  return { c, width, height };
}
