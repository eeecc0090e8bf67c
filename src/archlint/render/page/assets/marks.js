// What stands out in the picture: a path, what is selected, or what the search finds.
"use strict";
import { across, groupsOf, matching, neighbourhood } from "./model.js";
import { shownVertices } from "./state.js";
import { plural } from "./elements.js";

/** So many finds of a search are outlined; more of them only keep their colours. */
const OUTLINED = 50;

/** The number of a vertex by its key, or null for the key of something else. */
export function vertexOf(key) {
  return key?.startsWith("v") && !key.includes(">") ? Number(key.slice(1)) : null;
}

export function lineOf(scene, key) {
  return key?.includes(">") ? scene.lines.find((line) => line.key === key) : null;
}

/** What is shown of a group. */
export function membersOf(state, title) {
  const groups = groupsOf(state.system, state.grouping);
  return [...shownVertices(state)].filter((number) => groups[number] === title);
}

/** @returns {{lit: Set<string> | null, marked: Set<string>}} keys of items and lines */
export function marksOf(state, scene) {
  const edges = state.path?.edges;
  const matches = matching(state.system, state.query);
  const chosen = edges ? verticesOf(state.system, edges) : selectedVertices(state, scene) ?? matches;
  if (!chosen) return { lit: null, marked: new Set() };
  const lit = new Set([...chosen].map((number) => scene.byVertex.get(number)?.key).filter(Boolean));
  const path = new Set(edges ?? []);
  const onPath = (line) => line.edges.some((edge) => path.has(edge));
  const lines = scene.lines.filter((line) => (edges ? onPath(line) : lit.has(line.tail.key) && lit.has(line.head.key)));
  for (const line of lines) lit.add(line.key);
  return { lit, marked: new Set(edges ? lines.map((line) => line.key) : outlined(state, scene, matches)) };
}

function verticesOf(system, edges) {
  return new Set(edges.flatMap((number) => [system.edges[number].tail, system.edges[number].head]));
}

function outlined(state, scene, matches) {
  const { selected } = state;
  if (lineOf(scene, selected)) return [selected];
  if (selected) return [scene.byVertex.get(vertexOf(selected))?.key ?? selected];
  return matches.size > OUTLINED ? [] : [...matches].map((number) => scene.byVertex.get(number)?.key);
}

function selectedVertices(state, scene) {
  const { system, selected } = state;
  if (!selected) return null;
  const line = lineOf(scene, selected);
  if (line) return endsOfLine(system, line);
  const number = vertexOf(selected);
  if (number !== null) return neighbourhood(system, number);
  const members = membersOf(state, selected.slice(1));
  return new Set(members.flatMap((here) => [here, ...system.at[here].map((edge) => across(system.edges[edge], here))]));
}

/** Both ends of a line; where it is one connection, everybody who is at the other end of it. */
function endsOfLine(system, line) {
  const ends = verticesOf(system, line.edges);
  if (line.edges.length > 1) return ends;
  const edge = system.edges[line.edges[0]];
  const middle = system.vertices[edge.tail].kind === "node" ? edge.head : edge.tail;
  for (const number of system.at[middle]) {
    const other = system.edges[number];
    if ((other.head === middle) !== (edge.head === middle)) ends.add(across(other, middle));
  }
  return ends;
}

/** One sentence on what is shown, which screen readers say, too. */
export function statusWords(state) {
  const { system, query } = state;
  if (state.path) return state.path.edges ? "The path is marked." : "There is no path.";
  const matches = matching(system, query);
  if (matches && !state.selected) return `${matches.size} ${matches.size === 1 ? "match" : "matches"} for “${query}”`;
  const hidden = system.vertices.length - shownVertices(state).size;
  return hidden ? `${system.caption}  ·  ${plural(hidden, "thing")} hidden by filters` : system.caption;
}
