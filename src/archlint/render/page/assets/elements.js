// Small helpers to make elements.  Every text of the user's becomes a text node and never markup.
"use strict";

/** @param {string} tag @param {Record<string, any>} [properties] @param {...(Node | string | null | undefined | false)} children */
export function element(tag, properties = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name === "class") made.className = value;
    else if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else if (name in made && !name.includes("-")) made[name] = value;
    else made.setAttribute(name, value);
  }
  made.append(...children.filter((child) => child !== null && child !== undefined && child !== false));
  return made;
}

export function byId(id) {
  const found = document.getElementById(id);
  if (!found) throw new Error(`no element ${id}`);
  return found;
}

export function plural(number, noun) {
  return `${number} ${noun}${number === 1 ? "" : "s"}`;
}

/**
 * A place in the source: a link where the page was written with an address for it, else a text.
 * @param {{source_link: {address: string, root: string, folder: string} | null}} model
 */
export function place(model, at) {
  const text = `${at.file}:${at.line}`;
  const address = sourceAddress(model.source_link, at);
  return address === null ? element("span", { class: "quiet" }, text) : element("a", { href: address }, text);
}

/** The address of a place, or null where there is none: `{file}` is seen from the root of the repository. */
export function sourceAddress(link, at) {
  if (!link || !at.file) return null;
  const absolute = at.file.startsWith("/") || /^[A-Za-z]:/.test(at.file);
  const file = absolute ? null : plainPath(`${link.folder}/${at.file}`);
  const path = plainPath(absolute ? at.file : `${link.root}/${at.file}`);
  if (link.address.includes("{file}") && (file === null || file.startsWith("../"))) return null;
  const values = { file: quoted(file ?? ""), path: `/${quoted(path)}`, line: at.line ?? 1, column: at.column ?? 1 };
  return link.address.replace(/\{(file|path|line|column)\}/g, (_, name) => values[name]);
}

function quoted(path) {
  return path.split("/").map(encodeURIComponent).join("/").replaceAll("%3A", ":");
}

/** Without `.`, `..` and a slash in front. */
function plainPath(path) {
  const parts = [];
  for (const part of path.split("/")) {
    if (part === "..") parts.length && parts.at(-1) !== ".." ? parts.pop() : parts.push(part);
    else if (part && part !== ".") parts.push(part);
  }
  return parts.join("/");
}
