// The picture on the canvas: only what can be seen at this scale, and only in the part that is in view.
"use strict";

const LOOKS = ["node", "topic", "service", "action", "group", "wrong", "aside", "missing", "unexpected", "different"];
/** Scales below which there is no text, and only names. */
const NO_TEXT = 0.34, NAMES_ONLY = 0.6;
const FADED = 0.13;
/** Lines from which they are pale where no text can be read: groups shall be seen through them. */
const MANY_LINES = 800;
const PALE = 0.3;

/** The colours of the style sheet, which are other ones in the dark. */
export function readColours() {
  const style = getComputedStyle(document.documentElement);
  const value = (name) => style.getPropertyValue(`--${name}`).trim();
  const colours = Object.fromEntries(
    ["page", "text", "quiet", "frame", "frame-line", "lit", "error", "warning", "info"].map((name) => [name, value(name)]),
  );
  for (const look of LOOKS) {
    colours[look] = { fill: value(`${look}-fill`), line: value(`${look}-line`), text: value(`${look}-text`) };
  }
  return colours;
}

/**
 * @param {HTMLCanvasElement} canvas
 * @param {any} scene
 * @param {{x: number, y: number, k: number}} view
 * @param {{lit: Set<string> | null, marked: Set<string>}} marks what is not faded, by keys, and what is outlined
 */
export function paint(canvas, scene, view, marks, colours) {
  const context = canvas.getContext("2d", { alpha: false });
  const ratio = devicePixelRatio || 1;
  const width = Math.round(canvas.clientWidth * ratio), height = Math.round(canvas.clientHeight * ratio);
  if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.fillStyle = colours.page;
  context.fillRect(0, 0, width, height);
  context.setTransform(view.k * ratio, 0, 0, view.k * ratio, view.x * ratio, view.y * ratio);
  const inView = visibleArea(canvas, view);
  const pen = { context, colours, scale: view.k, inView, marks };
  for (const frame of scene.frames) if (overlaps(frame, inView)) paintFrame(pen, frame);
  paintLines(pen, scene);
  for (const item of scene.items) if (overlaps(item, inView)) paintItem(pen, item);
  for (const frame of scene.frames) if (overlaps(frame, inView)) paintTitle(pen, frame);
}

function visibleArea(canvas, view) {
  return { x: -view.x / view.k, y: -view.y / view.k, w: canvas.clientWidth / view.k, h: canvas.clientHeight / view.k };
}

function overlaps(box, area) {
  return box.x < area.x + area.w && box.x + box.w > area.x && box.y < area.y + area.h && box.y + box.h > area.y;
}

function paintFrame({ context, colours, scale }, frame) {
  context.globalAlpha = 1;
  context.fillStyle = colours.frame;
  context.strokeStyle = colours["frame-line"];
  context.lineWidth = Math.max(1, 1 / scale);
  context.setLineDash([]);
  context.beginPath();
  context.roundRect(frame.x, frame.y, frame.w, frame.h, 8);
  context.fill();
  context.stroke();
}

/** The title of a group is as large on the screen at any scale, as long as the frame has room for it. */
function paintTitle({ context, colours, scale }, frame) {
  const wanted = Math.max(12, 12 / scale);
  const size = Math.min(wanted, (frame.w - 16) / (frame.title.length * 0.6), frame.h / 2);
  context.globalAlpha = 1;
  context.font = `600 ${size}px Helvetica, Arial, sans-serif`;
  context.textAlign = "left";
  context.textBaseline = "top";
  if (scale < NO_TEXT) {
    context.fillStyle = colours.page;
    context.globalAlpha = 0.75;
    context.fillRect(frame.x + 4, frame.y + 2, context.measureText(frame.title).width + 8, size * 1.3);
    context.globalAlpha = 1;
  }
  context.fillStyle = colours.quiet;
  context.fillText(frame.title, frame.x + 8, frame.y + 5);
}

const DASHES = { solid: [], dashed: [6, 4], dotted: [1.5, 3] };

function strokeOf(line) {
  return line.dotted ? "dotted" : line.dashed ? "dashed" : "solid";
}

/** Lines that look the same are stroked at once; the paths are put together once for a scene. */
function paintLines(pen, scene) {
  const { context, colours, scale, marks, inView } = pen;
  const lit = marks.lit ? scene.lines.filter((line) => marks.lit.has(line.key)) : null;
  const pale = scale < NO_TEXT && scene.lines.length > MANY_LINES;
  scene.batches ??= batchesOf(scene.lines);
  const batches = lit ? [...scene.batches.map((batch) => ({ ...batch, faded: true })), ...batchesOf(lit)] : scene.batches;
  for (const { path, look, stroke, wide, faded } of batches) {
    context.globalAlpha = faded ? FADED : pale && !lit ? PALE : 1;
    context.strokeStyle = colours[look].line;
    context.lineWidth = Math.max(wide ? 1.8 : 1.2, 0.55 / scale);
    context.setLineDash(DASHES[stroke]);
    context.stroke(path);
  }
  context.setLineDash([]);
  context.globalAlpha = 1;
  for (const line of scene.lines) if (marks.marked.has(line.key)) paintMarkedLine(pen, line);
  if (scale < NO_TEXT) return;
  for (const line of scene.lines) {
    if (!line.directed || !near(line.tip, inView)) continue;
    context.globalAlpha = lit && !marks.lit.has(line.key) ? FADED : 1;
    if (line.broken || line.cutOff) paintCross(pen, line);
    if (!line.broken) paintArrow(pen, line);
  }
  context.globalAlpha = 1;
}

function batchesOf(lines) {
  const batches = new Map();
  for (const line of lines) {
    const key = `${line.look} ${strokeOf(line)} ${Boolean(line.broken)}`;
    if (!batches.has(key)) {
      batches.set(key, { look: line.look, stroke: strokeOf(line), wide: Boolean(line.broken), path: new Path2D() });
    }
    batches.get(key).path.addPath(line.path);
  }
  return [...batches.values()];
}

function paintMarkedLine({ context, colours, scale }, line) {
  context.strokeStyle = colours.lit;
  context.lineWidth = Math.max(2.6, 2 / scale);
  context.setLineDash(DASHES[strokeOf(line)]);
  context.stroke(line.path);
  context.setLineDash([]);
}

function near({ x, y }, area) {
  return x > area.x - 20 && x < area.x + area.w + 20 && y > area.y - 20 && y < area.y + area.h + 20;
}

function paintArrow({ context, colours, marks }, line) {
  const { x, y, angle } = line.tip;
  const cos = Math.cos(angle), sin = Math.sin(angle);
  context.fillStyle = marks.marked.has(line.key) ? colours.lit : colours[line.look].line;
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(x - 8 * cos + 4 * sin, y - 8 * sin - 4 * cos);
  context.lineTo(x - 8 * cos - 4 * sin, y - 8 * sin + 4 * cos);
  context.fill();
}

/** A cross where nothing gets through. */
function paintCross({ context, colours }, line) {
  const { x, y } = line.middle;
  context.strokeStyle = colours.wrong.line;
  context.lineWidth = 2;
  context.beginPath();
  context.moveTo(x - 5, y - 5);
  context.lineTo(x + 5, y + 5);
  context.moveTo(x - 5, y + 5);
  context.lineTo(x + 5, y - 5);
  context.stroke();
}

/** @param {CanvasRenderingContext2D | Path2D} path */
export function outline(path, item) {
  const { x, y, w, h, kind } = item;
  if (kind === "service" || kind === "action") {
    const cut = Math.min(6, h / 2), low = kind === "service" ? h / 2 : cut;
    const corners = [
      [x + cut, y], [x + w - cut, y], [x + w, y + low], [x + w, y + h - low], [x + w - cut, y + h], [x + cut, y + h],
      [x, y + h - low], [x, y + low],
    ];
    corners.forEach(([a, b], index) => (index ? path.lineTo(a, b) : path.moveTo(a, b)));
    path.closePath();
  } else {
    path.roundRect(x, y, w, h, kind === "topic" ? 0 : 7);
  }
}

function paintItem(pen, item) {
  const { context, colours, scale, marks } = pen;
  const look = colours[item.look];
  const marked = marks.marked.has(item.key);
  context.globalAlpha = marks.lit && !marks.lit.has(item.key) ? FADED : 1;
  context.fillStyle = item.hollow && item.look === item.kind ? colours.page : look.fill;
  context.strokeStyle = marked ? colours.lit : look.line;
  context.lineWidth = Math.max(marked ? 3 : item.kind === "node" ? 1.5 : 1.1, (marked ? 2.5 : 0.6) / scale);
  context.setLineDash(item.dashed ? DASHES.dashed : []);
  if (scale < NO_TEXT) {
    context.fillRect(item.x, item.y, item.w, item.h);
    context.strokeRect(item.x, item.y, item.w, item.h);
  } else {
    context.beginPath();
    outline(context, item);
    context.fill();
    context.stroke();
    paintText(pen, item, look.text);
  }
  context.setLineDash([]);
  if (item.badge) paintBadge(pen, item);
  context.globalAlpha = 1;
}

function paintText({ context, scale }, item, colour) {
  context.fillStyle = colour;
  context.textAlign = "center";
  context.textBaseline = "middle";
  const rows = textRows(item);
  for (const row of scale < NAMES_ONLY ? rows.slice(0, 1) : rows) {
    context.font = `${row.bold ? "600 " : ""}${row.size}px Helvetica, Arial, sans-serif`;
    context.fillText(row.text, row.x, row.y, item.w - 8);
  }
}

/** The lines of text of an item, each with the middle of where it stands. */
export function textRows(item) {
  const top = item.y + (item.h - item.text.length * 16) / 2 + 8.5;
  const large = item.kind === "node" || item.kind === "group";
  return item.text.map((text, index) => ({
    text, x: item.x + item.w / 2, y: top + index * 16, size: index ? 10.5 : large ? 13 : 11, bold: !index && large,
  }));
}

function paintBadge({ context, colours, scale }, item) {
  const size = Math.max(8, Math.min(3 / scale, 14));
  const x = item.x + item.w, y = item.y;
  context.fillStyle = colours[item.badge.severity];
  context.beginPath();
  context.arc(x, y, size, 0, 2 * Math.PI);
  context.fill();
  if (scale < NO_TEXT) return;
  context.fillStyle = colours.page;
  context.font = "600 10px Helvetica, Arial, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillText(String(item.badge.count), x, y + 0.5);
}

/** What is at a point of the picture: an item, the title of a frame, or a line. */
export function thingAt(canvas, scene, point, scale) {
  const inside = (box) => point.x >= box.x && point.x <= box.x + box.w && point.y >= box.y && point.y <= box.y + box.h;
  const item = scene.items.findLast(inside);
  if (item) return { item };
  const reach = Math.max(12, 12 / scale) * 1.4;
  const frame = scene.frames.find((f) => inside({ ...f, h: Math.min(reach, f.h) }));
  const line = lineAt(canvas.getContext("2d"), scene.lines, point, scale);
  return line ? { line } : frame ? { frame } : {};
}

/** The line that is nearest to a point, if one is near. */
function lineAt(context, lines, { x, y }, scale) {
  context.save();
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.setLineDash([]);
  let found;
  for (const reach of [12, 6, 2]) {
    context.lineWidth = reach / scale;
    const near = (found ? [...found] : lines).filter((line) => context.isPointInStroke(line.path, x, y));
    if (!near.length) break;
    found = near;
  }
  context.restore();
  return found?.[0];
}
