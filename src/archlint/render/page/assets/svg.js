// The picture as SVG, for paper: everything that is shown, sharp at any size, in the colours of the light page.
"use strict";
import { outline, textRows } from "./paint.js";

const SPACE = 20;

/** A pen that writes down what a Path2D would be told. */
class PathWriter {
  constructor() { this.words = []; }
  moveTo(x, y) { this.words.push(`M${round(x)},${round(y)}`); }
  lineTo(x, y) { this.words.push(`L${round(x)},${round(y)}`); }
  closePath() { this.words.push("Z"); }
  roundRect(x, y, w, h, r) {
    const c = Math.min(r, h / 2);
    this.words.push(
      `M${round(x + c)},${round(y)}h${round(w - 2 * c)}q${c},0 ${c},${c}v${round(h - 2 * c)}q0,${c} ${-c},${c}`,
      `h${round(2 * c - w)}q${-c},0 ${-c},${-c}v${round(2 * c - h)}q0,${-c} ${c},${-c}Z`,
    );
  }
}

function round(number) {
  return Math.round(number * 10) / 10;
}

/** @returns {SVGSVGElement} */
export function svgOf(scene, colours) {
  const { x, y, w, h } = scene.bounds;
  const svg = shape(null, "svg", { viewBox: [x - SPACE, y - SPACE, w + 2 * SPACE, h + 2 * SPACE].map(round).join(" ") });
  for (const frame of scene.frames) {
    const at = { x: round(frame.x), y: round(frame.y), width: round(frame.w), height: round(frame.h), rx: 8 };
    shape(svg, "rect", { ...at, fill: colours.frame, stroke: colours["frame-line"] });
    write(svg, { text: frame.title, x: frame.x + 8, y: frame.y + 12, size: 12, bold: true }, colours.quiet, "start");
  }
  for (const line of scene.lines) drawLine(svg, line, colours);
  for (const item of scene.items) drawItem(svg, item, colours);
  return svg;
}

function drawLine(svg, line, colours) {
  const [x, y, ...rest] = line.points.map(round);
  const colour = colours[line.look].line;
  const dashes = line.dotted ? "1.5 3" : line.dashed ? "6 4" : "none";
  shape(svg, "path", {
    d: `M${x},${y}C${rest.join(" ")}`, fill: "none", stroke: colour, "stroke-width": 1.2, "stroke-dasharray": dashes,
  });
  const { x: a, y: b } = line.middle;
  if (line.broken || line.cutOff) {
    const cross = `M${round(a - 5)},${round(b - 5)}l10,10m0,-10l-10,10`;
    shape(svg, "path", { d: cross, stroke: colours.wrong.line, "stroke-width": 2 });
  }
  if (line.broken || !line.directed) return;
  const turn = `translate(${round(line.tip.x)},${round(line.tip.y)}) rotate(${round((line.tip.angle * 180) / Math.PI)})`;
  shape(svg, "path", { d: "M0,0L-8,-4L-8,4Z", transform: turn, fill: colour });
}

function drawItem(svg, item, colours) {
  const look = colours[item.look];
  const pen = new PathWriter();
  outline(pen, item);
  const fill = item.hollow && item.look === item.kind ? colours.page : look.fill;
  const dashes = item.dashed ? "6 4" : "none";
  shape(svg, "path", { d: pen.words.join(""), fill, stroke: look.line, "stroke-dasharray": dashes });
  for (const row of textRows(item)) write(svg, row, look.text, "middle");
  if (item.badge) {
    const x = item.x + item.w;
    shape(svg, "circle", { cx: round(x), cy: round(item.y), r: 8, fill: colours[item.badge.severity] });
    write(svg, { text: String(item.badge.count), x, y: item.y + 0.5, size: 10, bold: true }, colours.page, "middle");
  }
}

function write(svg, row, colour, anchor) {
  const at = { x: round(row.x), y: round(row.y), "text-anchor": anchor, "dominant-baseline": "central" };
  const font = { "font-family": "Helvetica, Arial, sans-serif", "font-size": row.size, "font-weight": row.bold ? 600 : 400 };
  shape(svg, "text", { ...at, ...font, fill: colour }).textContent = row.text;
}

function shape(parent, tag, attributes) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value));
  parent?.append(made);
  return made;
}
