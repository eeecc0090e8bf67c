// The shapes and lines that are in the picture now, with their places.
"use strict";
import { across, groupsOf, isNode } from "./model.js";
import { arrange } from "./arrange.js";
import { shownVertices } from "./state.js";

const LINE = 16, PAD = 10, LETTER = 6.7, FRAME = 20, TITLE = 18;
const RANK = { error: 3, warning: 2, info: 1 };

/** @returns {{items: any[], lines: any[], frames: any[], byVertex: Map<number, any>, bounds: any}} */
export function makeScene(state) {
  const { system } = state;
  const groups = groupsOf(system, state.grouping);
  const shown = shownVertices(state);
  const byVertex = new Map(), byGroup = new Map(), allItems = [];
  for (const number of shown) {
    const title = groups[number];
    if (title && state.collapsed.has(title)) {
      if (!byGroup.has(title)) allItems.push(byGroup.set(title, groupItem(title)).get(title));
      const box = byGroup.get(title);
      box.vertices.push(number);
      byVertex.set(number, box);
    } else {
      const item = vertexItem(state, system.vertices[number], number, title);
      allItems.push(item);
      byVertex.set(number, item);
    }
  }
  for (const box of byGroup.values()) finishGroup(state, box);
  const direct = joinGroups(system, shown, byVertex);
  const items = allItems.filter((item) => item.isGroup || byVertex.has(item.number));
  const lines = makeLines(system, byVertex, direct);
  const drawn = system.drawing;
  const asDrawn = drawn && state.grouping === "drawn" && !byGroup.size && state.focus === null && !state.arranged;
  if (asDrawn) placeAsDrawn(drawn, items, lines);
  else arrange(items, lines);
  for (const line of lines) shapeLine(line);
  const frames = makeFrames(items, state);
  return { items, lines, frames, byVertex, bounds: boundsOf([...items, ...frames]), asDrawn };
}

function vertexItem(state, vertex, number, group) {
  const [w, h] = sizeOf(vertex.label, isNode(vertex));
  return {
    key: `v${number}`, vertex, number, group, w, h, kind: vertex.kind, look: vertex.look ?? vertex.kind,
    text: vertex.label, dashed: isNode(vertex) ? vertex.look === "aside" : !vertex.matched,
    hollow: !isNode(vertex) && !vertex.matched, badge: badgeOf(state, vertex.findings ?? []),
  };
}

function groupItem(title) {
  return { key: `g${title}`, isGroup: true, title, group: "", kind: "group", look: "group", vertices: [] };
}

function finishGroup(state, box) {
  const counts = { node: 0, topic: 0, service: 0, action: 0 };
  const found = new Set();
  for (const number of box.vertices) {
    const vertex = state.system.vertices[number];
    counts[vertex.kind]++;
    for (const finding of vertex.findings ?? []) found.add(finding);
  }
  const words = Object.entries(counts).filter(([, count]) => count).map(([kind, n]) => `${n} ${kind}${n > 1 ? "s" : ""}`);
  box.text = [box.title, words.join(", ")];
  box.badge = badgeOf(state, [...found]);
  [box.w, box.h] = sizeOf(box.text, true);
}

function sizeOf(text, large) {
  const [first, ...rest] = text;
  const widths = [first.length * LETTER * (large ? 13 / 12 : 11 / 12), ...rest.map((t) => t.length * LETTER * (10.5 / 12))];
  return [Math.max(...widths) + 2 * PAD, text.length * LINE + PAD];
}

function badgeOf(state, findings) {
  if (!findings.length) return null;
  const levels = findings.map((number) => state.model.findings[number].severity);
  return { count: findings.length, severity: levels.reduce((a, b) => (RANK[b] > RANK[a] ? b : a)) };
}

/**
 * What only closed groups talk over is not drawn: it becomes part of the lines from group to group.
 * @returns {{tail: any, head: any, edges: number[]}[]} what runs over it
 */
function joinGroups(system, shown, byVertex) {
  const direct = [];
  for (const number of shown) {
    if (isNode(system.vertices[number]) || byVertex.get(number).isGroup) continue;
    const edges = system.at[number].filter((edge) => byVertex.has(across(system.edges[edge], number)));
    const ends = edges.map((edge) => ({ edge, item: byVertex.get(across(system.edges[edge], number)) }));
    if (!ends.every(({ item }) => item.isGroup)) continue;
    byVertex.delete(number);
    for (const from of ends.filter(({ edge }) => system.edges[edge].head === number)) {
      for (const to of ends.filter(({ edge }) => system.edges[edge].tail === number)) {
        direct.push({ tail: from.item, head: to.item, edges: [from.edge, to.edge] });
      }
    }
  }
  return direct;
}

/** One line for all edges from one item to another. */
function makeLines(system, byVertex, direct) {
  const lines = new Map();
  const add = (tail, head, edges) => {
    if (!tail || !head || tail === head) return;
    const key = `${tail.key}>${head.key}`;
    if (!lines.has(key)) lines.set(key, { key, tail, head, edges: [] });
    lines.get(key).edges.push(...edges);
  };
  system.edges.forEach((edge, number) => add(byVertex.get(edge.tail), byVertex.get(edge.head), [number]));
  for (const { tail, head, edges } of direct) add(tail, head, edges);
  for (const line of lines.values()) {
    const edges = line.edges.map((number) => system.edges[number]);
    const ends = edges.flatMap((edge) => edge.ends);
    const interfaces = edges.map((e) => system.vertices[isNode(system.vertices[e.tail]) ? e.head : e.tail]);
    line.broken = edges.every((edge) => edge.broken) ? edges[0].broken : "";
    line.directed = ends.length > 0;
    line.dotted = ends.length > 0 && ends.every((end) => end.conditional);
    line.dashed = Boolean(line.broken) || !line.directed || interfaces.every((vertex) => !vertex.matched);
    const observed = ends.find((end) => end.observed)?.observed;
    line.look = line.broken ? "wrong" : observed ?? (line.directed ? interfaces[0].kind : "aside");
    line.cutOff = ends.some((end) => end.broken) && !line.broken;
  }
  return [...lines.values()];
}

function placeAsDrawn(drawing, items, lines) {
  for (const item of items) [item.x, item.y, item.w, item.h] = drawing.boxes[item.number];
  for (const line of lines) line.points = drawing.paths[line.edges[0]];
}

/** The path of a line, from `points` or from the boxes at its ends. */
function shapeLine(line) {
  line.points ??= between(line.tail, line.head);
  const points = line.points;
  const path = new Path2D();
  path.moveTo(points[0], points[1]);
  for (let index = 2; index < points.length; index += 6) path.bezierCurveTo(...points.slice(index, index + 6));
  line.path = path;
  const [x, y] = points.slice(-2);
  let [fromX, fromY] = points.slice(-4, -2);
  if (Math.hypot(x - fromX, y - fromY) < 1) [fromX, fromY] = points.slice(0, 2);
  line.tip = { x, y, angle: Math.atan2(y - fromY, x - fromX) };
  const half = 6 * Math.floor(((points.length - 2) / 6 - 1) / 2) + 2;
  line.middle = curveMiddle(points.slice(half - 2, half + 6));
}

function curveMiddle([x0, y0, x1, y1, x2, y2, x3, y3]) {
  return { x: (x0 + 3 * x1 + 3 * x2 + x3) / 8, y: (y0 + 3 * y1 + 3 * y2 + y3) / 8 };
}

function between(tail, head) {
  const y0 = tail.y + tail.h / 2, y1 = head.y + head.h / 2;
  const right = head.x - (tail.x + tail.w), left = tail.x - (head.x + head.w);
  if (right > 0 || left > 0) {
    const [x0, x1] = right > 0 ? [tail.x + tail.w, head.x] : [tail.x, head.x + head.w];
    const bend = (x1 - x0) / 2;
    return [x0, y0, x0 + bend, y0, x1 - bend, y1, x1, y1];
  }
  const down = head.y > tail.y;
  const x0 = tail.x + tail.w / 2, x1 = head.x + head.w / 2;
  const top = down ? tail.y + tail.h : tail.y, bottom = down ? head.y : head.y + head.h;
  const bend = (bottom - top) / 2;
  return [x0, top, x0, top + bend, x1, bottom - bend, x1, bottom];
}

function makeFrames(items, state) {
  const members = new Map();
  for (const item of items) {
    if (item.isGroup || !item.group) continue;
    if (!members.has(item.group)) members.set(item.group, []);
    members.get(item.group).push(item);
  }
  return [...members].map(([title, inside]) => {
    const { x, y, w, h } = boundsOf(inside);
    const count = inside.filter((item) => item.kind === "node").length;
    return {
      key: `f${title}`, title, count, x: x - FRAME, y: y - FRAME - TITLE / 2, w: w + 2 * FRAME, h: h + 2 * FRAME + TITLE / 2,
    };
  });
}

export function boundsOf(boxes) {
  if (!boxes.length) return { x: 0, y: 0, w: 1, h: 1 };
  const x = Math.min(...boxes.map((box) => box.x)), y = Math.min(...boxes.map((box) => box.y));
  const right = Math.max(...boxes.map((box) => box.x + box.w)), bottom = Math.max(...boxes.map((box) => box.y + box.h));
  return { x, y, w: right - x, h: bottom - y };
}
