// What the reader has chosen, and which vertices that leaves to be shown.
"use strict";
import { across, groupsOf, isNode, neighbourhood } from "./model.js";

/** Beyond so many shapes a system opens with its groups collapsed, where no places were worked out for it. */
const OPEN_AT_MOST = 400;

export function newState(model) {
  return { model, query: "", selected: null, path: null, ...stateOfSystem(model, 0) };
}

/** What starts anew with another system. */
export function stateOfSystem(model, number) {
  const system = model.systems[number];
  const state = {
    number, system, grouping: model.group ?? "drawn", collapsed: new Set(system.collapsed), hidden: new Set(), focus: null,
    onlyFound: false, onlyConnected: false, arranged: false, selected: null, path: null,
  };
  if (!system.drawing && system.vertices.length > OPEN_AT_MOST) {
    state.collapsed = new Set(groupsOf(system, "drawn").filter(Boolean));
  }
  return state;
}

/** What a filter hides is in `hidden` as "facet:value". */
export const FACETS = {
  kind: { title: "Kinds", of: (vertex) => (isNode(vertex) ? null : vertex.kind) },
  package: { title: "Packages", of: (vertex) => (isNode(vertex) ? vertex.package ?? "(no package)" : null) },
  namespace: { title: "Namespaces", of: (vertex) => (isNode(vertex) ? vertex.namespace : null) },
  launched_by: { title: "Launch files", of: (vertex) => (isNode(vertex) ? vertex.launched_by ?? "(none)" : null) },
};

function passes(state, vertex) {
  return Object.entries(FACETS).every(([facet, { of }]) => !state.hidden.has(`${facet}:${of(vertex)}`));
}

/** The numbers of the vertices that pass all filters; an interface needs a node that does. */
export function shownVertices(state) {
  const { system } = state;
  const near = state.focus === null ? null : neighbourhood(system, state.focus);
  const found = state.onlyFound ? withFindings(system) : null;
  const wanted = (number) => (!near || near.has(number)) && (!found || found.has(number));
  const shown = new Set();
  system.vertices.forEach((vertex, number) => {
    if (isNode(vertex) && passes(state, vertex) && wanted(number)) shown.add(number);
  });
  system.vertices.forEach((vertex, number) => {
    if (isNode(vertex) || !passes(state, vertex) || !wanted(number)) return;
    if (state.onlyConnected && !vertex.matched) return;
    if (system.at[number].some((edge) => shown.has(across(system.edges[edge], number)))) shown.add(number);
  });
  return shown;
}

/** What has findings, and what that is connected to at once. */
function withFindings(system) {
  const found = new Set();
  system.vertices.forEach((vertex, number) => {
    if (!vertex.findings?.length) return;
    found.add(number);
    for (const edge of system.at[number]) found.add(across(system.edges[edge], number));
  });
  return found;
}

export function isFiltered(state) {
  return state.hidden.size > 0 || state.onlyFound || state.onlyConnected || state.focus !== null;
}
