"""Style and script of the HTML page."""

from __future__ import annotations

STYLE = """
:root { font-family: Helvetica, Arial, sans-serif; color: #1e293b; background: #ffffff; }
body { margin: 0; height: 100vh; display: flex; flex-direction: column; }
header { display: flex; align-items: baseline; flex-wrap: wrap; gap: 0.5rem 1.25rem; padding: 0.75rem 1.25rem;
  border-bottom: 1px solid #cbd5e1; }
h1 { font-size: 1.05rem; margin: 0; }
#search { font: inherit; padding: 0.3rem 0.6rem; min-width: 16rem; border: 1px solid #94a3b8;
  border-radius: 0.4rem; }
#counts { margin: 0; color: #64748b; font-size: 0.85rem; }
main { flex: 1; display: flex; min-height: 0; }
#drawing { flex: 1; overflow: auto; padding: 1rem; }
#drawing svg { display: block; margin: auto; }
#details { width: 22rem; overflow: auto; padding: 1rem 1.25rem; border-left: 1px solid #cbd5e1;
  background: #f8fafc; font-size: 0.85rem; overflow-wrap: anywhere; }
#details h2 { font-size: 1rem; margin: 0 0 0.25rem; }
#details h3 { font-size: 0.85rem; margin: 1rem 0 0.25rem; }
#details p { margin: 0.15rem 0; color: #475569; }
.node { cursor: pointer; }
.fade { opacity: 0.12; }
"""

SCRIPT = """
"use strict";
const { vertices, lines } = JSON.parse(document.getElementById("data").textContent);
const panel = document.getElementById("details");
const search = document.getElementById("search");
const shapes = new Map();
const edges = [];
let kept = null;

for (const group of document.querySelectorAll("#drawing g.node, #drawing g.edge")) {
  const title = group.querySelector("title");
  const name = title.textContent;
  title.remove();
  if (group.classList.contains("edge")) {
    const [tail, head] = name.split("->");
    edges.push({ group, tail, head });
  } else {
    shapes.set(name, group);
    group.addEventListener("mouseenter", () => { if (!kept) show(name); });
    group.addEventListener("mouseleave", () => { if (!kept) show(null); });
    group.addEventListener("click", (event) => { event.stopPropagation(); kept = name; show(name); });
  }
}

document.getElementById("drawing").addEventListener("click", () => { kept = null; show(null); });
search.addEventListener("input", () => { kept = null; show(null); });

function element(tag, text) {
  const made = document.createElement(tag);
  made.textContent = text;
  return made;
}

function around(name) {
  const found = new Set([name]);
  for (const line of lines) {
    if (line.tail === name) found.add(line.head);
    if (line.head === name) found.add(line.tail);
  }
  if (vertices[name].kind !== "node") return found;
  for (const near of [...found]) {
    for (const line of lines) {
      if (near !== name && line.tail === near) found.add(line.head);
      if (near !== name && line.head === near) found.add(line.tail);
    }
  }
  return found;
}

function matching(words) {
  const found = new Set();
  for (const [name, vertex] of Object.entries(vertices)) {
    const text = [vertex.name, vertex.kind, ...vertex.details].join(" ").toLowerCase();
    if (words.every((word) => text.includes(word))) found.add(name);
  }
  return found;
}

function show(name) {
  const words = search.value.toLowerCase().split(/\\s+/).filter(Boolean);
  const lit = name ? around(name) : words.length ? matching(words) : null;
  for (const [other, group] of shapes) group.classList.toggle("fade", lit !== null && !lit.has(other));
  for (const { group, tail, head } of edges) {
    const on = name ? lit.has(tail) && lit.has(head) : lit === null || lit.has(tail) || lit.has(head);
    group.classList.toggle("fade", !on);
  }
  if (name) describe(name);
}

function describe(name) {
  const vertex = vertices[name];
  panel.replaceChildren(element("h2", vertex.name), ...vertex.details.map((text) => element("p", text)));
  for (const line of lines) {
    if (line.tail !== name && line.head !== name) continue;
    const other = vertices[line.tail === name ? line.head : line.tail];
    panel.append(element("h3", (line.tail === name ? "\\u2192 " : "\\u2190 ") + other.name));
    panel.append(element("p", line.details));
  }
}
"""
