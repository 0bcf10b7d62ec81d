#include "viz/regression/check_page_text.h"

namespace amble {

const char* const kCheckPageStyle = R"css(
:root { color-scheme: light dark; --page: #f5f5f2; --card: #fff; --ink: #1d2126; --quiet: #5d6670;
  --line: #d9dad5; --ok: #21713a; --differs: #a33b00; --error: #a3122b; --skipped: #5d6670;
  --changed: #7a4b00; --mark: #fdf1d6; --accent: #1f5fa8; }
@media (prefers-color-scheme: dark) { :root { --page: #14171a; --card: #1e2226; --ink: #e8e9e6;
  --quiet: #a2abb3; --line: #363c42; --ok: #6fce8b; --differs: #ff9f6b; --error: #ff8a99;
  --skipped: #a2abb3; --changed: #f0c070; --mark: #3a3120; --accent: #8ab8f0; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--page); color: var(--ink);
  font: 15px/1.45 system-ui, -apple-system, "Segoe UI", Roboto, sans-serif; }
body > header, main { max-width: 100rem; margin: 0 auto; padding: 0 1.25rem; }
h1 { margin: 1.25rem 0 .25rem; font-size: 1.5rem; }
header p { margin: .15rem 0; color: var(--quiet); }
#tools { position: sticky; top: 0; z-index: 1; background: var(--page);
  border-bottom: 1px solid var(--line); }
#tools form { max-width: 100rem; margin: 0 auto; padding: .6rem 1.25rem; display: flex;
  flex-wrap: wrap; gap: .5rem 1rem; align-items: center; }
#tools input[type=search], #tools select { font: inherit; color: inherit; background: var(--card);
  border: 1px solid var(--line); border-radius: .4rem; padding: .35rem .55rem; min-width: 0; }
#tools fieldset { border: 0; margin: 0; padding: 0; display: flex; flex-wrap: wrap; gap: .35rem; }
#tools fieldset label { border: 1px solid var(--line); border-radius: 1rem; padding: .25rem .7rem;
  background: var(--card); cursor: pointer; }
#tools fieldset input { position: absolute; opacity: 0; }
#tools fieldset label:has(:checked) { border-color: var(--accent); color: var(--accent);
  box-shadow: inset 0 0 0 1px var(--accent); }
:focus-visible, #tools label:has(:focus-visible) { outline: 2px solid var(--accent);
  outline-offset: 2px; }
#shown { margin-left: auto; color: var(--quiet); }
main { display: grid; gap: 1rem; padding-top: 1rem; padding-bottom: 2rem;
  grid-template-columns: repeat(auto-fill, minmax(min(100%, 19rem), 1fr)); grid-auto-flow: dense; }
article { background: var(--card); border: 1px solid var(--line); border-radius: .6rem;
  overflow: hidden; min-width: 0; display: flex; flex-direction: column; }
@media (min-width: 45rem) { article.changed { grid-column: span 2; } }
article[hidden] { display: none; }
article h2 { font-size: 1rem; margin: 0; overflow-wrap: anywhere; }
article > header { display: flex; gap: .6rem; align-items: baseline; padding: .6rem .8rem; }
.verdict { font-weight: 600; }
.ok .verdict { color: var(--ok); } .differs .verdict { color: var(--differs); }
.error .verdict { color: var(--error); } .skipped .verdict, .stopped .verdict {
  color: var(--skipped); }
.status { margin-left: auto; color: var(--quiet); white-space: nowrap; }
.pictures { display: grid; grid-auto-columns: 1fr; grid-auto-flow: column; gap: 1px;
  background: var(--line); }
figure { margin: 0; background: var(--card); min-width: 0; }
figure button { display: block; width: 100%; padding: 0; border: 0; background: none;
  cursor: zoom-in; }
img { display: block; width: 100%; height: auto; }
figcaption { padding: .15rem .8rem; color: var(--quiet); font-size: .85rem; }
.none { display: grid; place-items: center; aspect-ratio: 16 / 10; color: var(--quiet);
  padding: 1rem; text-align: center; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th, td { padding: .15rem .8rem; text-align: right; white-space: nowrap; }
th:first-child { text-align: left; font-weight: 400; color: var(--quiet); }
thead th { font-weight: 400; color: var(--quiet); font-size: .85rem; }
tr.changed td { background: var(--mark); } tr.changed td:last-child { color: var(--changed);
  font-weight: 600; }
.figures { padding: .4rem 0 .6rem; overflow-x: auto; }
.notes { margin: 0; padding: .5rem .8rem .7rem 1.8rem; border-top: 1px solid var(--line);
  overflow-wrap: anywhere; }
.why { margin: 0; padding: .4rem .8rem; overflow-wrap: anywhere; }
dialog { border: 0; border-radius: .6rem; padding: 0; width: min(96vw, 80rem); max-width: none;
  background: var(--card); color: var(--ink); }
dialog::backdrop { background: rgb(0 0 0 / .65); }
dialog p { margin: 0; padding: .5rem .8rem; display: flex; gap: 1rem; align-items: center; }
dialog button { font: inherit; color: inherit; background: none; border: 1px solid var(--line);
  border-radius: .4rem; padding: .25rem .8rem; cursor: pointer; }
dialog p button:first-of-type { margin-left: auto; }
dialog img { max-height: 82vh; object-fit: contain; }
@media (max-width: 30rem) { body > header, main { padding-left: .75rem; padding-right: .75rem; }
  #tools { position: static; } #tools form { padding: .6rem .75rem; }
  #tools input[type=search] { flex: 1 1 100%; } th, td { padding: .15rem .5rem; } }
@media print { #tools { display: none; } article { break-inside: avoid; } }
)css";

const char* const kCheckPageScript = R"js(
"use strict";
{
  const main = document.querySelector("main");
  const cards = [...main.children];
  const form = document.querySelector("#tools form");
  const number = (card, key) => Number(card.dataset[key] ?? -Infinity);
  const orders = {
    worst: (a, b) => number(b, "worst") - number(a, "worst"),
    files: () => 0,
    name: (a, b) => a.dataset.name.localeCompare(b.dataset.name),
    length: (a, b) => number(b, "length") - number(a, "length"),
    clearance: (a, b) =>
      Number(a.dataset.clearance ?? Infinity) - Number(b.dataset.clearance ?? Infinity),
    skate: (a, b) => number(b, "skate") - number(a, "skate"),
    planning: (a, b) => number(b, "planning") - number(a, "planning"),
  };
  const show = () => {
    const typed = form.elements.search.value.trim().toLowerCase();
    const kind = form.elements.kind.value;
    const wanted = (card) => card.dataset.name.toLowerCase().includes(typed) &&
      (kind === "all" || card.classList.contains(kind));
    for (const card of cards) card.hidden = !wanted(card);
    const sorted = cards.map((card, i) => [card, i]);
    sorted.sort(([a, i], [b, k]) => orders[form.elements.order.value](a, b) || i - k);
    main.replaceChildren(...sorted.map(([card]) => card));
    const shown = cards.filter((card) => !card.hidden).length;
    document.querySelector("#shown").textContent = `${shown} of ${cards.length}`;
  };
  form.addEventListener("input", show);
  form.addEventListener("submit", (event) => event.preventDefault());
  document.querySelector("#tools").hidden = false;
  show();

  const dialog = document.querySelector("dialog");
  const large = dialog.querySelector("img");
  const title = dialog.querySelector("span");
  const other = dialog.querySelector("#other");
  let pictures = [], at = 0;
  const enlarge = () => {
    large.src = pictures[at].src;
    large.alt = title.textContent = pictures[at].alt;
    other.hidden = pictures.length < 2;
  };
  const swap = () => { at = (at + 1) % pictures.length; enlarge(); };
  main.addEventListener("click", (event) => {
    const button = event.target.closest("figure button");
    if (!button) return;
    pictures = [...button.closest(".pictures").querySelectorAll("img")];
    at = pictures.indexOf(button.querySelector("img"));
    enlarge();
    dialog.showModal();
  });
  other.addEventListener("click", swap);
  large.addEventListener("click", swap);
  dialog.querySelector("#close").addEventListener("click", () => dialog.close());
  dialog.addEventListener("click", (event) => { if (event.target === dialog) dialog.close(); });
}
)js";

}  // namespace amble
