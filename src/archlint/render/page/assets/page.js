// The page: what happens when the reader does something.
"use strict";
import { byId, element } from "./elements.js";
import { GROUPINGS, groupsOf, matching, nameOf, readModel, shortestPath } from "./model.js";
import { isFiltered, newState, stateOfSystem } from "./state.js";
import { makeScene } from "./scene.js";
import { readColours, thingAt } from "./paint.js";
import { moved, paintAnew } from "./snapshot.js";
import { svgOf } from "./svg.js";
import { groupDetails, lineDetails, pathDetails, systemDetails, vertexDetails } from "./details.js";
import { lineOf, marksOf, membersOf, statusWords, vertexOf } from "./marks.js";
import { markEntry, showFilters, showList, showPathForm, walkList } from "./sidebar.js";

/** The scale from which all texts can be read. */
const READABLE = 0.6;

const model = readModel(byId("data").textContent);
const canvas = /** @type {HTMLCanvasElement} */ (byId("canvas"));
const page = { model, state: newState(model), select, act };
let scene, colours, view = { x: 0, y: 0, k: 1 }, marks = { lit: null, marked: new Set() }, waiting = false;

const zoom = d3.zoom().scaleExtent([0.02, 4]).on("zoom", ({ transform }) => {
  view = transform;
  if (!moved(canvas, scene, view, repaint)) repaint();
});
d3.select(canvas).call(zoom).on("dblclick.zoom", null);

function repaint() {
  if (waiting) return;
  waiting = true;
  requestAnimationFrame(() => {
    waiting = false;
    paintAnew(canvas, scene, view, marks, colours);
  });
}

/** Makes the picture anew; `fit` shows all of it. */
function rebuild(fit) {
  scene = makeScene(page.state);
  showList(page, matching(page.state.system, page.state.query));
  byId("reset").disabled = scene.asDrawn || !page.state.system.drawing;
  byId("all").disabled = !isFiltered(page.state);
  light();
  if (fit) fitAll();
}

function fitAll() {
  showBox(scene.bounds, 1.4);
}

/** Brings a box into view, at most `largest` times its size. */
function showBox(box, largest) {
  const { clientWidth: width, clientHeight: height } = canvas;
  const k = Math.min(largest, (width - 60) / box.w, (height - 70) / box.h);
  const to = d3.zoomIdentity.translate(width / 2 - k * (box.x + box.w / 2), height / 2 - k * (box.y + box.h / 2)).scale(k);
  zoom.transform(d3.select(canvas), to);
}

/** Says what stands out, and shows it. */
function light() {
  marks = marksOf(page.state, scene);
  say(statusWords(page.state));
  repaint();
}

function say(words) {
  byId("status").textContent = words;
}

/** Selects a thing by its key, or nothing; `bring` moves it into view. */
function select(key, bring = false) {
  const { state } = page;
  state.selected = key;
  state.path = null;
  const number = vertexOf(key), line = lineOf(scene, key);
  const item = number === null ? null : scene.byVertex.get(number);
  if (item && (bring || !inView(item))) bringIntoView(item);
  const content = number !== null ? vertexDetails(page, number)
    : line ? lineDetails(page, line)
    : key ? groupDetails(page, key.slice(1), membersOf(state, key.slice(1)), state.collapsed.has(key.slice(1)))
    : systemDetails(page);
  showDetails(content);
  markEntry(key ?? "");
  light();
  remember();
}

function showDetails(content) {
  const panel = byId("details");
  panel.replaceChildren(...content.filter(Boolean));
  panel.scrollTop = 0;
}

function inView(item) {
  const [x, y] = [view.x + view.k * (item.x + item.w / 2), view.y + view.k * (item.y + item.h / 2)];
  return x > 0 && y > 0 && x < canvas.clientWidth && y < canvas.clientHeight;
}

function bringIntoView(item) {
  const k = Math.max(view.k, READABLE);
  const x = canvas.clientWidth / 2 - k * (item.x + item.w / 2), y = canvas.clientHeight / 2 - k * (item.y + item.h / 2);
  zoom.transform(d3.select(canvas), d3.zoomIdentity.translate(x, y).scale(k));
}

/** Names in the address, so that it can be passed on: the system and what is selected. */
function remember() {
  const number = vertexOf(page.state.selected);
  const words = new URLSearchParams();
  if (page.state.number) words.set("system", page.state.system.title);
  if (number !== null) words.set("show", nameOf(page.state.system.vertices[number]));
  const wanted = words.size ? `#${words}` : location.pathname;
  try {
    history.replaceState(null, "", wanted);
  } catch { /* a page in a frame of another origin may not */ }
}

const ACTIONS = {
  filter: (key) => { flip(page.state.hidden, key); rebuild(false); },
  filterAll: (keys) => {
    const hide = keys.every((key) => !page.state.hidden.has(key));
    for (const key of keys) hide ? page.state.hidden.add(key) : page.state.hidden.delete(key);
    showFilters(page);
    rebuild(false);
  },
  facet: ([facet, open]) => { (page.state.openFacets ??= new Set(["kind"]))[open ? "add" : "delete"](facet); },
  toggle: (name) => { page.state[name] = !page.state[name]; rebuild(false); },
  collapse: (title) => { page.state.collapsed.add(title); again(title); },
  expand: (title) => { page.state.collapsed.delete(title); again(title); },
  focus: (number) => { page.state.focus = number; rebuild(true); select(`v${number}`); },
  unfocus: (number) => { page.state.focus = null; rebuild(true); select(`v${number}`); },
  pathFrom: (number) => { byId("from").value = nameOf(page.state.system.vertices[number]); openPathForm("to"); },
  pathTo: (number) => { byId("to").value = nameOf(page.state.system.vertices[number]); openPathForm("from"); },
};

function act(name, value) {
  ACTIONS[name](value);
}

function again(title) {
  rebuild(true);
  select(`${page.state.collapsed.has(title) ? "g" : "f"}${title}`);
}

function flip(set, value) {
  if (!set.delete(value)) set.add(value);
}

function openPathForm(next) {
  byId("trace").open = true;
  if (byId(next).value) tracePath();
  else byId(next).focus();
}

function tracePath() {
  const { system } = page.state;
  const [from, to] = ["from", "to"].map((id) => system.vertices.findIndex((vertex) => nameOf(vertex) === byId(id).value.trim()));
  if (from < 0 || to < 0) return say(`no node, topic, service or action is called “${byId(from < 0 ? "from" : "to").value}”`);
  page.state.selected = null;
  page.state.path = { from, to, edges: shortestPath(system, from, to) };
  showDetails(pathDetails(page, page.state.path));
  light();
}

function showSystem(number) {
  Object.assign(page.state, stateOfSystem(model, number));
  byId("system").value = String(number);
  byId("group").value = page.state.grouping;
  showFilters(page);
  showPathForm(page);
  rebuild(true);
  select(null);
}

function setTheme(theme) {
  document.documentElement.dataset.theme = theme;
  colours = readColours();
  byId("theme").textContent = theme === "dark" ? "Light" : "Dark";
}

function setUp() {
  byId("system").append(...model.systems.map((system, number) => element("option", { value: String(number) }, system.title)));
  byId("system").hidden = model.systems.length < 2;
  const drawn = page.state.system.drawing ? "as drawn" : "as usual";
  byId("group").append(...Object.entries(GROUPINGS).map(([value, words]) => (
    element("option", { value }, words ? `by ${words}` : value === "none" ? "no groups" : `groups ${drawn}`))));
  byId("system").addEventListener("change", (event) => showSystem(Number(event.target.value)));
  byId("group").addEventListener("change", (event) => {
    page.state.grouping = event.target.value;
    page.state.collapsed.clear();
    rebuild(true);
  });
  byId("search").addEventListener("input", (event) => {
    page.state.query = event.target.value;
    page.state.selected = page.state.path = null;
    showList(page, matching(page.state.system, page.state.query));
    light();
  });
  byId("search").addEventListener("keydown", (event) => {
    if (event.key === "Enter") byId("list").querySelector(".entry")?.click();
    if (event.key === "ArrowDown") walkList(event);
  });
  byId("list").addEventListener("keydown", walkList);
  byId("form").addEventListener("submit", (event) => { event.preventDefault(); tracePath(); });
  const buttons = {
    fit: fitAll, in: () => zoom.scaleBy(d3.select(canvas), 1.3), out: () => zoom.scaleBy(d3.select(canvas), 1 / 1.3),
    collapse: () => { page.state.collapsed = new Set(groupsOf(page.state.system, page.state.grouping).filter(Boolean)); rebuild(true); },
    expand: () => { page.state.collapsed.clear(); rebuild(true); },
    arrange: () => { page.state.arranged = true; rebuild(true); },
    reset: () => { Object.assign(page.state, { arranged: false, focus: null, grouping: "drawn" }); page.state.collapsed.clear();
      byId("group").value = "drawn"; rebuild(true); },
    all: () => { Object.assign(page.state, { focus: null, onlyFound: false, onlyConnected: false }); page.state.hidden.clear();
      showFilters(page); rebuild(true); },
    theme: () => { setTheme(document.documentElement.dataset.theme === "dark" ? "light" : "dark"); repaint(); },
    print: () => print(),
  };
  for (const [id, action] of Object.entries(buttons)) byId(id).addEventListener("click", action);
  canvas.addEventListener("click", (event) => choose(event, false));
  canvas.addEventListener("dblclick", (event) => choose(event, true));
  canvas.addEventListener("mousemove", point);
  canvas.addEventListener("keydown", steer);
  document.addEventListener("keydown", shortcut);
  addEventListener("beforeprint", preparePrint);
  new ResizeObserver(() => scene && repaint()).observe(canvas);
  const dark = matchMedia("(prefers-color-scheme: dark)");
  dark.addEventListener("change", () => { setTheme(dark.matches ? "dark" : "light"); repaint(); });
  setTheme(dark.matches ? "dark" : "light");
}

function pointed(event) {
  const [x, y] = view.invert([event.offsetX, event.offsetY]);
  return thingAt(canvas, scene, { x, y }, view.k);
}

function keyOf({ item, line, frame }) {
  return item?.key ?? line?.key ?? frame?.key ?? null;
}

function choose(event, twice) {
  const thing = pointed(event);
  const title = thing.item?.isGroup ? thing.item.title : thing.frame?.title;
  if (twice && title) act(thing.item ? "expand" : "collapse", title);
  else if (!twice) select(keyOf(thing));
}

/** The name of what the pointer is at. */
function point(event) {
  if (event.buttons) return;
  const thing = pointed(event);
  canvas.classList.toggle("pointing", keyOf(thing) !== null);
  canvas.title = thing.item ? thing.item.text.join("\n") : thing.line ? thing.line.broken : "";
}

function steer(event) {
  const step = { ArrowLeft: [80, 0], ArrowRight: [-80, 0], ArrowUp: [0, 80], ArrowDown: [0, -80] }[event.key];
  if (!step) return;
  event.preventDefault();
  zoom.translateBy(d3.select(canvas), step[0] / view.k, step[1] / view.k);
}

function shortcut(event) {
  const typing = /^(INPUT|SELECT|TEXTAREA)$/.test(event.target.tagName);
  if (event.key === "Escape") {
    if (event.target === byId("search")) byId("search").value = page.state.query = "";
    showList(page, null);
    select(null);
  }
  if (typing || event.ctrlKey || event.metaKey || event.altKey) return;
  const id = { "+": "in", "=": "in", "-": "out", 0: "fit" }[event.key];
  if (id) byId(id).click();
  if (event.key === "/") {
    event.preventDefault();
    byId("search").focus();
  }
}

/** On paper everything that is shown is on one picture, in light colours. */
function preparePrint() {
  const theme = document.documentElement.dataset.theme;
  document.documentElement.dataset.theme = "light";
  byId("paper").replaceChildren(svgOf(scene, readColours()));
  document.documentElement.dataset.theme = theme;
}

function start() {
  setUp();
  const words = new URLSearchParams(location.hash.slice(1));
  const number = model.systems.findIndex((system) => system.title === words.get("system"));
  showSystem(Math.max(number, 0));
  const vertex = page.state.system.vertices.findIndex((other) => nameOf(other) === words.get("show"));
  if (vertex >= 0) select(`v${vertex}`, view.k < READABLE);
  performance.mark("drawn");
}

start();
