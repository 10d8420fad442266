"""How the web page looks: light and dark, on a phone, at a desk, on paper."""

from __future__ import annotations

CSS = """
:root { color-scheme: light dark; --ink: #1c1b1a; --paper: #fffefb; --quiet: #6b6862; --line: #d9d5cb;
  --accent: #7a2e1d; --good: #2c6e3f; --bad: #b3261e; --box: #f7f3e8; }
@media (prefers-color-scheme: dark) { :root { --ink: #e8e4da; --paper: #1a1917; --quiet: #a19c91; --line: #45423c;
  --accent: #e0a48f; --good: #86c79a; --bad: #f2a59d; --box: #24221e; } }
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; }
body { margin: 0; background: var(--paper); color: var(--ink); line-height: 1.55;
  font: 1.0625rem/1.55 "Palatino Linotype", Palatino, "Book Antiqua", "TeX Gyre Pagella", Georgia, serif; }
main { max-width: 46rem; margin: 0 auto; padding: 2rem 1.25rem 4rem; }
article + article { margin-top: 4rem; border-top: 1px solid var(--line); padding-top: 2rem; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: 0; font-weight: 600; }
h2 { font-size: 1.12rem; margin: 2.2rem 0 .6rem; font-weight: 600; border-top: 1px solid var(--line);
  padding-top: .8rem; break-after: avoid; }
h2 .count { color: var(--accent); display: inline-block; min-width: 1.9rem; }
p { margin: .6rem 0; overflow-wrap: break-word; }
.source { color: var(--quiet); font-style: italic; margin: .25rem 0 0; }
nav ol { padding-left: 1.5rem; }
a { color: var(--accent); text-decoration: none; }
a:hover, a:focus-visible { text-decoration: underline; }
math { font-family: "STIX Two Math", "Latin Modern Math", "Cambria Math", "TeX Gyre Pagella Math", math;
  font-size: 1.1em; }
mover > mo { font-size: 1.15em; }
.v { font-weight: bold; font-style: normal; }
.together, p math, li math, td math, th math { white-space: nowrap; }
.display { margin: .7rem 0; display: grid; grid-template-columns: 1fr auto; column-gap: 1rem; row-gap: .35rem;
  align-items: baseline; break-inside: avoid; }
.display.long { break-inside: auto; }
.display.aligned { grid-template-columns: auto 1fr auto; }
.display > .equation { padding-left: 3.2rem; text-indent: -1.6rem; min-width: 0; overflow-x: auto;
  overflow-y: hidden; padding-block: .12rem; }
.display.aligned > .left { padding-left: 1.6rem; text-align: right; }
.display.aligned > .equation { padding-left: 1.6rem; }
.display math { text-indent: 0; }
.term { display: inline-block; max-width: 100%; text-indent: -1em; padding-left: 1em;
  baseline-source: first; }
.condition { text-indent: 0; padding-left: 1em; display: inline-block; }
.number { color: var(--quiet); font-variant-numeric: tabular-nums; }
.result { border: 1px solid var(--accent); border-radius: 4px; background: var(--box); padding: .6rem .8rem .6rem 0; }
.scroll { margin: .8rem 0; overflow-x: auto; overflow-y: hidden; }
table { border-collapse: collapse; margin-left: 1.6rem; font-size: .98em; }
th, td { text-align: left; padding: .25rem .9rem .25rem 0; vertical-align: baseline; font-weight: normal; }
thead th { border-bottom: 1px solid var(--ink); color: var(--quiet); }
td .label, .phone { display: none; }
ul.checks { list-style: none; padding: 0; margin: .6rem 0; }
ul.checks li { padding-left: 1.6rem; text-indent: -1.6rem; margin: .2rem 0; }
.mark { display: inline-block; width: 1.6rem; text-indent: 0; font-weight: bold; }
.held { color: var(--good); } .failed { color: var(--bad); } .open { color: var(--quiet); }
.how { color: var(--quiet); }
figure { margin: 1.2rem 0; text-align: center; break-inside: avoid; }
figure svg { max-width: 100%; height: auto; }
figcaption { color: var(--quiet); font-size: .95em; margin-top: .3rem; }
.picture path { fill: none; stroke: currentColor; stroke-width: 1.3; stroke-linejoin: round; stroke-linecap: round; }
.picture .rod { stroke-width: 2.2; }
.picture .guide { stroke: var(--quiet); stroke-width: .9; stroke-dasharray: 4 4; }
.picture .axis, .picture .curve { stroke: var(--quiet); }
.picture .ground, .picture .angle { stroke-width: 1; }
.picture .force { stroke-width: 2; }
.picture .reaction { stroke: var(--accent); stroke-width: 2; }
.picture path.tip { fill: currentColor; stroke: none; }
.picture path.axis.tip { fill: var(--quiet); }
.picture path.reaction.tip { fill: var(--accent); }
.picture circle { fill: currentColor; }
.picture .hinge { fill: var(--paper); stroke: currentColor; stroke-width: 1.3; }
.picture text { font: 15px "STIX Two Text", "Latin Modern Roman", "TeX Gyre Pagella", Georgia, serif;
  fill: currentColor; text-anchor: middle; }
.picture .i { font-style: italic; }
.picture .b { font-weight: bold; }
.unseen { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
@media (max-width: 40rem) {
  body { font-size: 1rem; }
  main { padding: 1.25rem 1rem 3rem; }
  .phone { display: inline; }
  .desk { display: none; }
  .display { column-gap: .5rem; }
  .display math { font-size: .93em; }
  .display > .equation { padding-left: 2rem; text-indent: -1.2rem; }
  .display.aligned > .left { padding-left: .6rem; }
  .display.aligned > .equation { padding-left: 1.2rem; }
  table { margin-left: 0; }
  table.wide, table.wide tbody, table.wide tr, table.wide th, table.wide td { display: block; }
  table.wide thead { display: none; }
  table.wide tr { margin-bottom: .6rem; }
  table.wide th[scope=row] { font-style: italic; }
  table.wide td { padding-left: 1.2rem; padding-block: .1rem; }
  table.wide td .label { display: inline; color: var(--quiet); }
}
@media print {
  :root { --ink: #000; --paper: #fff; --quiet: #444; --line: #bbb; --accent: #000; --good: #000; --bad: #000;
    --box: #fff; }
  main { max-width: none; padding: 0; }
  article + article { break-before: page; border: 0; }
}
""".strip()
