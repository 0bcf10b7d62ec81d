#include "viz/pictures/report_page_style.h"

namespace amble {

const char* const kReportPageStyle = R"css(
:root { color-scheme: light dark; --page: #f5f5f2; --card: #fff; --ink: #1d2126; --quiet: #5d6670;
  --line: #d9dad5; --good: #21713a; --bad: #a3122b; --track: #e9e9e4; --bar: #4478b8;
  --p0: #8a94a0; --p1: #2f8f8a; --p2: #4478b8; --p3: #9a5fb4; }
@media (prefers-color-scheme: dark) { :root { --page: #14171a; --card: #1e2226; --ink: #e8e9e6;
  --quiet: #a2abb3; --line: #363c42; --good: #6fce8b; --bad: #ff8a99; --track: #2c3237;
  --bar: #6d9fdd; --p0: #76808b; --p1: #3fb0aa; --p2: #6d9fdd; --p3: #b98ad0; } }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 68rem; padding: 0 1.25rem 2rem; background: var(--page);
  color: var(--ink); font: 15px/1.45 system-ui, -apple-system, Roboto, sans-serif; }
h1 { margin: 1.5rem 0 .25rem; font-size: 1.6rem; overflow-wrap: anywhere; }
h2 { margin: 0 0 .6rem; font-size: 1.05rem; }
.status { font-weight: 600; color: var(--bad); }
.status.solved { color: var(--good); }
.lead { margin: .25rem 0 1rem; overflow-wrap: anywhere; }
section, figure { background: var(--card); border: 1px solid var(--line); border-radius: .6rem;
  padding: 1rem 1.1rem; margin: 1rem 0; overflow-x: auto; break-inside: avoid; }
figure { padding: .4rem; }
figure img { display: block; width: 100%; height: auto; border-radius: .35rem; background: #fff; }
figcaption { color: var(--quiet); padding: .4rem .5rem .1rem; font-size: .87rem; }
.facts { display: grid; grid-template-columns: repeat(auto-fill, minmax(10.5rem, 1fr));
  gap: .8rem 1.4rem; margin: 0; }
.facts div { min-width: 0; }
dt { color: var(--quiet); font-size: .85rem; }
dd { margin: 0; font-size: 1.1rem; font-variant-numeric: tabular-nums; overflow-wrap: anywhere; }
dd small { display: block; color: var(--quiet); font-size: .8rem; }
.facts + table { margin-top: .9rem; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th, td { padding: .28rem .6rem; text-align: right; border-bottom: 1px solid var(--line);
  unicode-bidi: isolate; }
th { font-weight: 600; color: var(--quiet); font-size: .85rem; }
th:first-child, td:first-child { text-align: left; padding-left: 0; }
tr:last-child td { border-bottom: 0; }
td.gauge { width: 34%; min-width: 7rem; padding-right: 0; }
.track { position: relative; display: block; height: .65rem; border-radius: .33rem;
  background: var(--track); overflow: hidden; }
.track span { display: block; height: 100%; background: var(--bar); }
.holds { color: var(--good); }
.fails { color: var(--bad); font-weight: 600; }
.phases { display: flex; height: 1.4rem; border-radius: .35rem; overflow: hidden;
  background: var(--track); margin-bottom: .8rem; }
.key { display: inline-block; width: .75rem; height: .75rem; border-radius: .2rem;
  margin-right: .45rem; }
.load { background: var(--p0); }
.roadmap { background: var(--p1); }
.search { background: var(--p2); }
.refine { background: var(--p3); }
.quiet { color: var(--quiet); margin: .6rem 0 0; font-size: .9rem; }
code { font: .87rem/1.5 ui-monospace, Menlo, Consolas, monospace; overflow-wrap: anywhere;
  unicode-bidi: isolate; white-space: pre-wrap; }
td.hash { text-align: left; }
@media screen and (max-width: 44rem) {
  body { padding: 0 .6rem 1.5rem; }
  .plan img { width: 44rem; max-width: none; }
  .steps td { white-space: nowrap; }
  td.hash { min-width: 17rem; }
  .plan figcaption { position: sticky; left: 0; width: fit-content; } }
@media print { :root { color-scheme: light; --page: #fff; --card: #fff; --ink: #000;
  --quiet: #444; --line: #bbb; --good: #1b5e30; --bad: #8c0f25; --track: #e6e6e6; --bar: #4478b8;
  --p0: #8a94a0; --p1: #2f8f8a; --p2: #4478b8; --p3: #9a5fb4; }
  body { max-width: none; padding: 0; font-size: 10pt; }
  section, figure { border-radius: 0; overflow: visible; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  figure img { max-height: 15cm; object-fit: contain; }
  table.steps { break-inside: auto; } }
)css";

}  // namespace amble
