// Places for what is shown now, by dagre: each group by itself, then the groups among each other.
"use strict";

/** Shapes of one group beyond which they stand in columns: dagre would take seconds. */
const MOST_LAYERED = 350;
const ROOM = 26;
const BETWEEN = 40;
/** Square pixels from which groups that dagre puts into one long row or column stand in several instead. */
const LARGE = 4e6;
const WIDEST = 3.5;
const NARROWEST = 0.4;

/**
 * Sets `x` and `y` (left, top) of each item and `points` of the lines inside of groups.
 * @param {{w: number, h: number, group: string, x?: number, y?: number}[]} items
 * @param {{tail: any, head: any, points?: number[]}[]} lines
 */
export function arrange(items, lines) {
  const groups = new Map();
  for (const item of items) {
    const title = item.isGroup ? "" : item.group;
    if (!groups.has(title)) groups.set(title, []);
    groups.get(title).push(item);
  }
  const blocks = [];
  for (const [title, members] of groups) {
    if (!title) continue;
    const inside = new Set(members);
    const inner = lines.filter((line) => inside.has(line.tail) && inside.has(line.head));
    const size = layered(members, inner);
    blocks.push({ members, inner, w: size.w + 2 * ROOM, h: size.h + 2 * ROOM, inset: ROOM });
  }
  for (const item of groups.get("") ?? []) blocks.push({ members: [item], inner: [], w: item.w, h: item.h, inset: 0 });
  const home = new Map(blocks.flatMap((block) => block.members.map((item) => [item, block])));
  for (const item of groups.get("") ?? []) item.x = item.y = 0;
  const outer = [];
  for (const line of lines) {
    const tail = home.get(line.tail), head = home.get(line.head);
    if (tail !== head) outer.push({ tail, head, line });
  }
  const size = layered(blocks, outer);
  const ratio = size.w / Math.max(size.h, 1);
  const rows = blocks.length > MOST_LAYERED
    || (blocks.length > 6 && size.w * size.h > LARGE && (ratio > WIDEST || ratio < NARROWEST));
  if (rows) inRows(blocks);
  for (const block of blocks) move(block);
  for (const { tail, head, line, points } of outer) {
    line.points = tail.inset === 0 && head.inset === 0 && !rows ? points : null;
  }
}

function move(block) {
  const dx = block.x + block.inset, dy = block.y + block.inset;
  for (const item of block.members) {
    item.x += dx;
    item.y += dy;
  }
  for (const line of block.inner) line.points = line.points?.map((value, index) => value + (index % 2 ? dy : dx));
}

/** One layout from left to right; returns its size. */
function layered(boxes, lines) {
  if (boxes.length > MOST_LAYERED) return inRows(boxes);
  const graph = new dagre.graphlib.Graph({ multigraph: true });
  graph.setGraph({ rankdir: "LR", nodesep: 16, ranksep: 60, edgesep: 8 });
  const names = new Map(boxes.map((box, number) => [box, String(number)]));
  for (const [box, name] of names) graph.setNode(name, { width: box.w, height: box.h });
  lines.forEach((line, number) => {
    if (line.tail !== line.head) graph.setEdge(names.get(line.tail), names.get(line.head), {}, String(number));
  });
  dagre.layout(graph);
  for (const [box, name] of names) {
    const { x, y } = graph.node(name);
    box.x = x - box.w / 2;
    box.y = y - box.h / 2;
  }
  for (const edge of graph.edges()) {
    const { points } = graph.edge(edge);
    lines[Number(edge.name)].points = smooth(points);
  }
  const { width, height } = graph.graph();
  return { w: width, h: height };
}

/** In rows that together are about as wide as a screen. */
function inRows(boxes) {
  const area = boxes.reduce((sum, box) => sum + (box.w + BETWEEN) * (box.h + BETWEEN), 0);
  const limit = Math.max(Math.sqrt(area * 1.6), ...boxes.map((box) => box.w));
  let left = 0, top = 0, row = 0, width = 0;
  for (const box of boxes) {
    if (left && left + box.w > limit) {
      left = 0;
      top += row + BETWEEN;
      row = 0;
    }
    box.x = left;
    box.y = top;
    left += box.w + BETWEEN;
    row = Math.max(row, box.h);
    width = Math.max(width, left - BETWEEN);
  }
  return { w: width, h: top + row };
}

/** Bézier points through the corners of a line. */
function smooth(corners) {
  const points = [corners[0].x, corners[0].y];
  for (let index = 1; index < corners.length; index++) {
    const from = corners[index - 1], to = corners[index], middle = (from.x + to.x) / 2;
    points.push(middle, from.y, middle, to.y, to.x, to.y);
  }
  return points;
}
