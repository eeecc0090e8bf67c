// The panel with search, filters and the list: the same things as in the picture, for keyboards and screen readers.
"use strict";
import { groupsOf, isNode, nameOf } from "./model.js";
import { FACETS, shownVertices } from "./state.js";
import { byId, element, plural } from "./elements.js";

/** Fills in the filters that the system has anything for. */
export function showFilters(page) {
  const { state } = page;
  const parts = Object.entries(FACETS).map(([facet, { title, of }]) => {
    const counts = new Map();
    for (const vertex of state.system.vertices) {
      const value = of(vertex);
      if (value !== null && value !== undefined) counts.set(value, (counts.get(value) ?? 0) + 1);
    }
    return counts.size > 1 ? facetFilter(page, facet, title, [...counts].sort(([a], [b]) => (a < b ? -1 : 1))) : null;
  });
  byId("filters").replaceChildren(
    ...parts.filter(Boolean), check(page, "onlyFound", "Only what has findings"),
    check(page, "onlyConnected", "Only what has both ends"),
  );
}

function facetFilter(page, facet, title, counts) {
  const boxes = counts.map(([value, count]) => {
    const key = `${facet}:${value}`;
    const box = element("input", { type: "checkbox", checked: !page.state.hidden.has(key), onchange: () => page.act("filter", key) });
    return element("label", {}, box, ` ${value} `, element("span", { class: "quiet" }, String(count)));
  });
  const open = page.state.openFacets?.has(facet) ?? facet === "kind";
  const all = counts.map(([value]) => `${facet}:${value}`);
  const toggle = element("button", { onclick: () => page.act("filterAll", all) }, "all or none");
  return element("details", { open, ontoggle: (event) => page.act("facet", [facet, event.target.open]) },
    element("summary", {}, title), counts.length > 3 && toggle, ...boxes);
}

function check(page, name, words) {
  const box = element("input", { type: "checkbox", checked: page.state[name], onchange: () => page.act("toggle", name) });
  return element("label", { class: "plain" }, box, ` ${words}`);
}

/** What is shown, by groups; with a search only what it finds. */
export function showList(page, matches) {
  const { state } = page;
  const shown = [...shownVertices(state)].filter((number) => !matches || matches.has(number));
  const groups = groupsOf(state.system, state.grouping);
  const members = new Map();
  for (const number of shown) {
    const title = groups[number] ?? "";
    if (!members.has(title)) members.set(title, []);
    members.get(title).push(number);
  }
  const sections = [...members].sort(([a], [b]) => (a === "" ? 1 : b === "" ? -1 : a < b ? -1 : 1));
  byId("list").replaceChildren(...sections.flatMap(([title, numbers]) => section(page, title, numbers, matches !== null)));
}

function section(page, title, numbers, searched) {
  const { state } = page;
  const collapsed = state.collapsed.has(title) && !searched;
  const order = (a, b) => Number(isNode(state.system.vertices[b])) - Number(isNode(state.system.vertices[a])) || a - b;
  const rows = collapsed ? [] : numbers.sort(order).map((number) => element("li", {}, entry(page, number)));
  const list = element("ul", { "aria-label": title || "in no group" }, ...rows);
  if (!title) return [list];
  const words = plural(numbers.filter((number) => isNode(state.system.vertices[number])).length, "node");
  const toggle = element("button", {
    "aria-expanded": String(!collapsed), "aria-label": `${collapsed ? "expand" : "collapse"} ${title}`,
    onclick: () => page.act(state.collapsed.has(title) ? "expand" : "collapse", title),
  }, collapsed ? "▸" : "▾");
  return [element("div", { class: "group" }, toggle, element("span", {}, title), element("span", { class: "quiet" }, words)), list];
}

function entry(page, number) {
  const vertex = page.state.system.vertices[number];
  const count = vertex.findings?.length ?? 0;
  return element(
    "button", { class: "entry", "data-key": `v${number}`, onclick: () => page.select(`v${number}`, true) },
    element("span", { class: `kind ${vertex.kind}`, "aria-hidden": "true" }), nameOf(vertex),
    element("span", { class: "quiet" }, isNode(vertex) ? "" : ` ${vertex.kind}`),
    count > 0 && element("span", { class: "error" }, ` ${plural(count, "finding")}`),
  );
}

/** Marks the entry of what is selected. */
export function markEntry(key) {
  for (const button of byId("list").querySelectorAll('[aria-current="true"]')) button.removeAttribute("aria-current");
  const button = byId("list").querySelector(`[data-key="${key}"]`);
  button?.setAttribute("aria-current", "true");
  button?.scrollIntoView({ block: "nearest" });
}

/** Up and down go from entry to entry. */
export function walkList(event) {
  const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
  if (!step) return;
  const entries = [...byId("list").querySelectorAll(".entry")];
  const here = entries.indexOf(document.activeElement);
  const next = entries[here + step];
  if (next) {
    event.preventDefault();
    next.focus();
  }
}

/** The two fields of a path, with the names of nodes and interfaces to choose from. */
export function showPathForm(page) {
  const names = page.state.system.vertices.map(nameOf);
  byId("names").replaceChildren(...names.map((name) => element("option", { value: name })));
}
