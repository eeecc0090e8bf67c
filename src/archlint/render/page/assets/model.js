// The data of the page, with what follows from them: who is connected to whom, and in which group a shape is.
"use strict";

/**
 * @typedef {{kind: string, name?: string, label: string[], group: string, types?: string[], package?: string,
 *   namespace?: string, launched_by?: string, findings?: number[], look?: string, matched?: boolean}} Vertex
 * @typedef {{tail: number, head: number, ends: any[], findings: number[], broken: string}} Edge
 * @typedef {{vertices: Vertex[], edges: Edge[], at: number[][], title: string, name: string | null, drawing: any,
 *   caption: string, findings: number[], unresolved: any[], launch_arguments: any[]}} System
 */

/** What a group may be made of, and what to call it. */
export const GROUPINGS = { drawn: "", namespace: "namespace", package: "package", folder: "folder", launched_by: "launch file", process: "process", none: "" };

/** @returns {{systems: System[], findings: any[], interfaces: any}} */
export function readModel(text) {
  const data = JSON.parse(text);
  for (const system of data.systems) {
    system.at = system.vertices.map(() => []);
    system.edges.forEach((edge, number) => {
      system.at[edge.tail].push(number);
      system.at[edge.head].push(number);
      edge.findings = [...new Set(edge.ends.flatMap((end) => end.findings ?? []))];
      edge.broken = edge.ends.length && edge.ends.every((end) => end.broken) ? edge.ends[0].broken : "";
    });
    system.vertices.forEach((vertex, number) => { vertex.number = number; });
  }
  return data;
}

export function isNode(vertex) {
  return vertex.kind === "node";
}

/** The other end of an edge. */
export function across(edge, number) {
  return edge.tail === number ? edge.head : edge.tail;
}

export function nameOf(vertex) {
  return vertex.name ?? vertex.label[0];
}

/** The group of each vertex: an interface is in the group that all its nodes are in. */
export function groupsOf(system, by) {
  if (by === "drawn") return system.vertices.map((vertex) => vertex.group);
  if (by === "none") return system.vertices.map(() => "");
  const groups = system.vertices.map((vertex) => (isNode(vertex) ? vertex[by] ?? "" : ""));
  system.vertices.forEach((vertex, number) => {
    if (isNode(vertex)) return;
    const around = new Set(system.at[number].map((edge) => groups[across(system.edges[edge], number)]));
    if (around.size === 1) groups[number] = [...around][0];
  });
  return groups;
}

/** All that is near a vertex: what it talks over, and, for a node, who else does. */
export function neighbourhood(system, number) {
  const near = new Set([number]);
  const step = (from) => { for (const edge of system.at[from]) near.add(across(system.edges[edge], from)); };
  step(number);
  if (isNode(system.vertices[number])) for (const other of [...near]) if (other !== number) step(other);
  return near;
}

/** The text in which the search looks. */
export function searchText(vertex) {
  vertex.text ??= [
    nameOf(vertex), vertex.kind, vertex.class, vertex.package, vertex.executable, vertex.file, vertex.launched_by,
    ...(vertex.types ?? []), ...(vertex.parameters ?? []).map((parameter) => parameter.name),
  ].filter(Boolean).join(" ").toLowerCase();
  return vertex.text;
}

/** The vertices that have all words; null where nothing is searched for. */
export function matching(system, query) {
  const words = query.toLowerCase().split(/\s+/).filter(Boolean);
  if (!words.length) return null;
  const found = new Set();
  system.vertices.forEach((vertex, number) => {
    const text = searchText(vertex);
    if (words.every((word) => text.includes(word))) found.add(number);
  });
  return found;
}

/**
 * The shortest way of what one vertex sends to another, along the arrows; null where there is none.  Nothing gets through a
 * broken connection.
 */
export function shortestPath(system, from, to) {
  const cameBy = new Map([[from, -1]]);
  for (const here of cameBy.keys()) {
    if (here === to) break;
    for (const number of system.at[here]) {
      const edge = system.edges[number];
      if (edge.tail === here && !edge.broken && edge.ends.length && !cameBy.has(edge.head)) cameBy.set(edge.head, number);
    }
  }
  if (!cameBy.has(to)) return null;
  const edges = [];
  for (let here = to; here !== from; here = system.edges[edges[0]].tail) edges.unshift(cameBy.get(here));
  return edges;
}
