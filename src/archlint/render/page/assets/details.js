// The panel beside the picture: everything that is known of what was clicked.
"use strict";
import { across, isNode, nameOf } from "./model.js";
import { element, place, plural } from "./elements.js";

const TOWARDS = { subscriber: true, service: true, action_server: true };
const VERBS = {
  publisher: "publishes", subscriber: "subscribes", service: "serves", client: "calls", action_server: "acts on",
  action_client: "sends goals to",
};

/** @typedef {{model: any, state: any, select: (key: string) => void, act: (name: string, value: any) => void}} Page */

/** @param {Page} page */
export function vertexDetails(page, number) {
  const { system } = page.state;
  const vertex = system.vertices[number];
  return isNode(vertex) ? nodeDetails(page, vertex, number) : interfaceDetails(page, vertex, number);
}

function heading(words, kind) {
  return element("h2", { tabIndex: -1 }, element("span", { class: `kind ${kind}`, "aria-hidden": "true" }), words);
}

function nodeDetails(page, node, number) {
  const { system } = page.state;
  const facts = [
    ["class", node.class], ["package", node.package], ["executable", (node.executables ?? []).join(", ")],
    ["executor", node.executor?.replace("_", " ")], ["launch file", node.launched_by], ["started", node.condition],
    ["lifecycle", node.lifecycle && "a managed node"], ["domain", node.domain],
    ["source", node.external ? "not in this workspace" : !node.complete && "followed in part"],
    ["test code", node.test && "yes"], ["when it runs", node.look in SEEN && SEEN[node.look]],
  ];
  return [
    heading(nameOf(node), "node"),
    ...(node.remarks ?? []).map((words) => element("p", { class: "warning" }, words)),
    node.error && element("p", { class: "error" }, node.error),
    node.documentation && element("p", {}, node.documentation),
    node.file && element("p", {}, place(page.model, node)),
    list(facts),
    actions(page, number),
    findings(page, node.findings),
    ...Object.entries(VERBS).flatMap(([kind, verb]) => endsOf(page, system, number, kind, verb)),
    ...timers(page, node.timers ?? []),
    ...parameters(page, node.parameters ?? []),
    ...remappings(node.remappings ?? []),
  ];
}

const SEEN = { missing: "it is missing", unexpected: "only there", different: "it is different" };

function endsOf(page, system, number, kind, verb) {
  const rows = [];
  for (const edgeNumber of system.at[number]) {
    const edge = system.edges[edgeNumber];
    for (const end of edge.ends) if (end.kind === kind) rows.push([edge, end]);
  }
  if (!rows.length) return [];
  return [
    element("h3", {}, verb),
    ...rows.map(([edge, end]) => endCard(page, end, goto(page, across(edge, number)), system.vertices[across(edge, number)])),
  ];
}

/** One end of a connection: its type, QoS, callback, group and place. */
function endCard(page, end, title, other) {
  const level = end.broken ? "error" : "";
  const typed = end.type && other && (other.types ?? []).length > 1 ? end.type : end.type?.split("/").at(-1);
  return element(
    "div", { class: `card ${level}` },
    element("p", {}, title, typed && element("span", { class: "quiet", title: end.type }, `  ${typed}`)),
    end.broken && element("p", { class: "error" }, `✕ nothing gets through: ${end.broken}`),
    end.observed && element("p", { class: "warning" }, `when it runs: ${end.remark ?? end.observed}`),
    end.error && element("p", { class: "error" }, end.error),
    list([
      ["QoS", ["publisher", "subscriber"].includes(end.kind) && qosWords(end.qos)],
      ["callback", end.callback],
      ["group", end.callback_group !== "default" && end.callback_group?.replaceAll("_", " ")],
      ["name", end.parameter ? `from the parameter ${end.parameter}` : end.written !== nameOf(other ?? {label: [""]}) && end.written],
      ["known", end.resolution !== "exact" && [end.resolution, end.reason].filter(Boolean).join(": ")],
      ["when", end.conditional && "only under a condition"],
    ]),
    element("p", {}, place(page.model, end)),
    findings(page, end.findings),
  );
}

export function qosWords(qos) {
  if (!qos) return "not known";
  const { history, depth, reliability, durability, ...more } = qos;
  const kept = history === "keep_last" ? `keep last ${depth ?? "?"}` : history?.replace("_", " ");
  const rest = Object.entries(more).map(([name, value]) => `${name.replace(/_s$/, "")} ${value}${name.endsWith("_s") ? " s" : ""}`);
  return [reliability ?? "?", durability ?? "?", kept ?? "?", ...rest].join(", ").replaceAll("_", " ");
}

function interfaceDetails(page, vertex, number) {
  const { system } = page.state;
  const ends = system.at[number].flatMap((edge) => system.edges[edge].ends.map((end) => ({ edge: system.edges[edge], end })));
  const side = (towards) => ends.filter(({ end }) => Boolean(TOWARDS[end.kind]) === towards);
  const topic = vertex.kind === "topic";
  const sides = topic ? [["published by", side(false)], ["subscribed by", side(true)]]
    : [["served by", side(true)], ["called by", side(false)]];
  return [
    heading(nameOf(vertex), vertex.kind),
    element("p", {}, vertex.kind, (vertex.types ?? []).length > 1 && element("span", { class: "error" }, ", with different types")),
    ...(vertex.remarks ?? []).map((words) => element("p", { class: "warning" }, words)),
    vertex.error && element("p", { class: "error" }, vertex.error),
    vertex.resolution && element("p", { class: "quiet" }, `the name is known as far as this: ${vertex.resolution}`),
    actions(page, number),
    findings(page, vertex.findings),
    ...sides.flatMap(([words, rows]) => [
      element("h3", {}, words),
      ...(rows.length ? rows.map(({ edge, end }) => endCard(page, end, goto(page, across(edge, number)), null))
        : [element("p", { class: "quiet" }, "no node here")]),
    ]),
    ...(vertex.types ?? []).flatMap((type) => definition(page, type)),
  ];
}

/** A line of the picture: both ends of each connection that it stands for. */
export function lineDetails(page, line) {
  const { system } = page.state;
  const parts = line.edges.map((number) => system.edges[number]);
  if (parts.length > 1) {
    return [
      element("h2", { tabIndex: -1 }, plural(parts.length, "connection")),
      ...parts.map((edge) => element("p", {}, goto(page, edge.tail), " → ", goto(page, edge.head))),
    ];
  }
  const [edge] = parts;
  const number = isNode(system.vertices[edge.tail]) ? edge.head : edge.tail;
  const vertex = system.vertices[number];
  const mine = across(edge, number);
  const others = system.at[number].map((other) => system.edges[other]).filter((other) => other !== edge && other.ends.length);
  const facing = others.filter((other) => (other.head === number) !== (edge.head === number));
  const cards = (edges) => edges.flatMap((other) => other.ends.map((end) => (
    endCard(page, end, element("span", {}, goto(page, across(other, number)), ` ${VERBS[end.kind]}`), null))));
  return [
    element("h2", { tabIndex: -1 }, `${nameOf(system.vertices[edge.tail])} → ${nameOf(system.vertices[edge.head])}`),
    element("p", {}, `${vertex.kind} `, goto(page, number)),
    element("h3", {}, "this end"),
    ...(edge.ends.length ? cards([edge]) : [goto(page, mine), element("p", { class: "quiet" },
      "remapped by the launch file; the source is not in this workspace, so the direction is not known")]),
    element("h3", {}, "at the other end"),
    ...(facing.length ? cards(facing) : [element("p", { class: "quiet" }, "no node here")]),
    ...(vertex.types ?? []).flatMap((type) => definition(page, type)),
  ];
}

export function groupDetails(page, title, vertices, collapsed) {
  const { system } = page.state;
  const nodes = vertices.filter((number) => isNode(system.vertices[number]));
  return [
    element("h2", { tabIndex: -1 }, title),
    element("p", {}, plural(nodes.length, "node")),
    element("p", { class: "buttons" }, element(
      "button", { onclick: () => page.act(collapsed ? "expand" : "collapse", title) }, collapsed ? "Expand" : "Collapse")),
    ...nodes.map((number) => element("p", {}, goto(page, number))),
  ];
}

/** What there is to say of the whole system, and of findings that belong to nothing in the picture. */
export function systemDetails(page) {
  const { system } = page.state;
  const unresolved = system.unresolved.map((gap) => element(
    "div", { class: "card" }, element("p", {}, `${gap.kind}: ${gap.reason ?? ""}`), element("p", {}, place(page.model, gap))));
  return [
    element("h2", { tabIndex: -1 }, system.title),
    element("p", { class: "quiet" }, system.caption),
    element("p", {}, "Click a node, a line or a group for what is known of it."),
    ...(system.launch_arguments.length ? [element("h3", {}, "launch arguments"), list(system.launch_arguments.map((a) => (
      [a.name, [a.default ?? "(required)", a.choices && `one of ${a.choices.join(", ")}`].filter(Boolean).join("; ")])))] : []),
    system.findings.length > 0 && element("h3", {}, "findings elsewhere"),
    findings(page, system.findings),
    unresolved.length > 0 && element("h3", {}, plural(unresolved.length, "thing") + " not followed"),
    ...unresolved,
  ];
}

export function pathDetails(page, path) {
  const { system } = page.state;
  const name = (number) => nameOf(system.vertices[number]);
  const title = element("h2", { tabIndex: -1 }, `${name(path.from)} → ${name(path.to)}`);
  if (!path.edges) {
    return [title, element("p", {}, "Nothing that the first sends gets to the second, over any number of nodes."),
      element("p", { class: "quiet" }, "Only the direction of data and requests counts, and broken connections do not.")];
  }
  const steps = [path.from, ...path.edges.map((edge) => system.edges[edge].head)];
  return [title, element("p", {}, `${plural(steps.filter((n) => isNode(system.vertices[n])).length, "node")} on the shortest way`),
    element("ol", {}, ...steps.map((number) => element("li", {}, goto(page, number))))];
}

function goto(page, number) {
  const vertex = page.state.system.vertices[number];
  return element("button", { class: "goto", onclick: () => page.select(`v${number}`) }, nameOf(vertex));
}

function actions(page, number) {
  const button = (words, name) => element("button", { onclick: () => page.act(name, number) }, words);
  const focused = page.state.focus === number;
  return element("p", { class: "buttons" }, button(focused ? "Show all" : "Only what is near", focused ? "unfocus" : "focus"),
    button("Path from here", "pathFrom"), button("Path to here", "pathTo"));
}

function findings(page, numbers) {
  if (!numbers?.length) return null;
  return element("div", {}, ...numbers.map((number) => findingCard(page, page.model.findings[number])));
}

function findingCard(page, finding) {
  return element(
    "div", { class: `card ${finding.severity}` },
    element("p", {}, element("strong", { class: finding.severity }, `${finding.code} ${finding.severity}`), ` ${finding.message}`),
    finding.help && element("p", { class: "quiet" }, finding.help),
    element("p", {}, place(page.model, finding)),
    ...(finding.related ?? []).map((other) => element("p", {}, place(page.model, other), ` ${other.message}`)),
  );
}

function timers(page, rows) {
  if (!rows.length) return [];
  return [element("h3", {}, "timers"), ...rows.map((timer) => element(
    "div", { class: "card" },
    element("p", {}, timer.period_s === null ? "period not known" : `every ${timer.period_s} s`),
    list([["callback", timer.callback], ["parameter", timer.parameter],
      ["group", timer.callback_group !== "default" && timer.callback_group?.replaceAll("_", " ")]]),
    element("p", {}, place(page.model, timer))))];
}

function parameters(page, rows) {
  if (!rows.length) return [];
  return [element("h3", {}, "parameters"), ...rows.map((parameter) => {
    const given = "override" in parameter ? parameter.override : parameter.value;
    return element("div", { class: "card" },
      element("p", {}, element("strong", {}, parameter.name ?? "name not known"), " ", element("span", { class: "quiet" }, parameter.type ?? "")),
      parameter.description && element("p", {}, parameter.description),
      list([["default", shown(parameter.default)], ["set to", shown(given)], ["not known", parameter.reason ?? parameter.override_reason]]),
      element("p", {}, place(page.model, parameter)));
  })];
}

function shown(value) {
  return value === null || value === undefined ? "" : JSON.stringify(value);
}

function remappings(rows) {
  if (!rows.length) return [];
  return [element("h3", {}, "remapped"), list(rows.map((row) => [row.from ?? "?", `→ ${row.to ?? "?"}`]))];
}

function definition(page, type) {
  const known = page.model.interfaces[type];
  if (!known) return [element("h3", {}, type)];
  const rows = known.fields.map((field) => element(
    "tr", {}, element("td", { class: "quiet" }, field.section), element("td", {}, field.name), element("td", {}, field.type)));
  return [element("h3", {}, type), element("table", {}, element("tbody", {}, ...rows))];
}

/** Pairs of a word and what there is, without those of which there is nothing. */
function list(rows) {
  const known = rows.filter(([, value]) => value);
  if (!known.length) return null;
  return element("dl", {}, ...known.flatMap(([word, value]) => [element("dt", {}, word), element("dd", {}, String(value))]));
}
