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
