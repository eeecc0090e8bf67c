"use strict";
// What the built VS Code extension ($EXTENSION) shows of the file $TRIED, written to $ANSWERS as JSON.  VS Code itself is
// not here: the part of its API that vscode-languageclient asks for is below, and what is missing is made up on demand.

const fs = require("fs");
const Module = require("module");
const { fileURLToPath, pathToFileURL } = require("url");

const PATIENCE = 60000;
const { ANSWERS, EXTENSION, NEW_NAME, TRIED, TRIED_LINE, TRIED_COLUMN, WORKSPACE } = process.env;

class Disposable {
  constructor(end) {
    this.end = end;
  }
  dispose() {
    this.end?.();
  }
}

class EventEmitter {
  constructor() {
    this.listeners = new Set();
    this.event = (listener, self) => {
      const bound = listener.bind(self);
      this.listeners.add(bound);
      return new Disposable(() => this.listeners.delete(bound));
    };
  }
  fire(event) {
    this.listeners.forEach((listener) => listener(event));
  }
  dispose() {
    this.listeners.clear();
  }
}

class Position {
  constructor(line, character) {
    Object.assign(this, { line, character });
  }
}

class Range {
  constructor(...ends) {
    const [start, end] = ends.length === 4 ? [new Position(ends[0], ends[1]), new Position(ends[2], ends[3])] : ends;
    Object.assign(this, { start, end });
  }
}

class Uri {
  constructor(text) {
    Object.assign(this, { text, scheme: text.split(":")[0] });
    this.fsPath = this.path = this.scheme === "file" ? fileURLToPath(text) : text;
  }
  static parse(text) {
    return new Uri(text);
  }
  static file(path) {
    return new Uri(pathToFileURL(path).href);
  }
  toString() {
    return this.text;
  }
}

class Diagnostic {
  constructor(range, message, severity) {
    Object.assign(this, { range, message, severity });
  }
}

class Location {
  constructor(uri, range) {
    Object.assign(this, { uri, range });
  }
}

class Hover {
  constructor(contents, range) {
    Object.assign(this, { contents, range });
  }
}

class MarkdownString {
  constructor(value = "") {
    this.value = value;
  }
}

class CodeActionKind {
  constructor(value) {
    this.value = value;
  }
  append(part) {
    return new CodeActionKind([this.value, part].filter(Boolean).join("."));
  }
  static Empty = new CodeActionKind("");
}

class WorkspaceEdit {
  files = new Map();
  set(uri, edits) {
    this.files.set(uri.fsPath, edits);
  }
  replace(uri) {
    this.set(uri, []);
  }
}

const never = new EventEmitter().event;
const token = { isCancellationRequested: false, onCancellationRequested: never };
const text = fs.readFileSync(TRIED, "utf8");
const tried = { uri: Uri.file(TRIED), fileName: TRIED, languageId: "python", version: 1, getText: () => text };
const shown = new Map();
const providers = {};
const commands = [];
const said = [];

/** A namespace of the API: its events never come, what is registered is kept, everything else is not there. */
function namespace(members) {
  return new Proxy(members, {
    get(known, name) {
      if (name in known || typeof name !== "string") return known[name];
      if (name.startsWith("on")) return never;
      if (!name.startsWith("register")) return undefined;
      return (_selector, provider) => {
        providers[name] = provider;
        return new Disposable();
      };
    },
  });
}

const say = async (message) => void said.push(message);
const output = { name: "archlint", append: say, appendLine: say, show() {}, clear() {}, dispose() {} };
const collection = { set: (uri, found) => shown.set(uri.fsPath, found), delete() {}, clear() {}, dispose() {} };
const api = {
  Disposable, EventEmitter, Position, Range, Uri, Diagnostic, Location, Hover, MarkdownString, CodeActionKind, WorkspaceEdit,
  version: "1.91.0",
  CancellationTokenSource: class {
    token = token;
    cancel() {}
    dispose() {}
  },
  env: namespace({ appName: "none", language: "en" }),
  commands: namespace({
    registerCommand: (name) => {
      commands.push(name);
      return new Disposable();
    },
  }),
  window: namespace({
    visibleTextEditors: [],
    tabGroups: { all: [], onDidChangeTabs: never, onDidChangeTabGroups: never },
    createOutputChannel: () => output,
    showErrorMessage: say,
    showWarningMessage: say,
    showInformationMessage: say,
  }),
  languages: namespace({ match: () => 10, createDiagnosticCollection: () => collection }),
  workspace: namespace({
    textDocuments: [tried],
    notebookDocuments: [],
    workspaceFolders: [{ uri: Uri.file(WORKSPACE), name: "workspace", index: 0 }],
    getWorkspaceFolder: () => undefined,
    getConfiguration: () => ({ get: (_name, other) => other }),
    createFileSystemWatcher: () => ({ onDidCreate: never, onDidChange: never, onDidDelete: never, dispose() {} }),
  }),
};

/** The API; a class or an enumeration that is not above exists, and the members of an enumeration are their names. */
const vscode = new Proxy(api, {
  get(known, name) {
    if (name in known || typeof name !== "string" || name === "then" || name === "__esModule") return known[name];
    const get = (made, member) => (member in made || typeof member !== "string" ? made[member] : member);
    return (known[name] = new Proxy(class {}, { get }));
  },
});

const load = Module._load;
Module._load = (request, ...rest) => (request === "vscode" ? vscode : load(request, ...rest));

async function answers(extension) {
  await extension.activate({ subscriptions: [] });
  for (const end = Date.now() + PATIENCE; !shown.get(TRIED)?.length && Date.now() < end; ) {
    await new Promise((soon) => setTimeout(soon, 50));
  }
  const here = [tried, new Position(TRIED_LINE - 1, TRIED_COLUMN - 1)];
  const hover = await providers.registerHoverProvider?.provideHover(...here, token);
  const ends = await providers.registerDefinitionProvider?.provideDefinition(...here, token);
  const edit = await providers.registerRenameProvider?.provideRenameEdits(...here, NEW_NAME, token);
  await extension.deactivate();
  return {
    shown: (shown.get(TRIED) ?? []).map((found) => [found.code.value ?? found.code, found.range.start.line + 1]),
    hover: [hover?.contents].flat().map((part) => part?.value ?? "").join("\n"),
    ends: (ends ?? []).map((place) => (place.targetUri ?? place.uri).fsPath),
    renamed: [...(edit?.files.keys() ?? [])],
    commands,
    said,
  };
}

answers(require(EXTENSION)).then((all) => {
  fs.writeFileSync(ANSWERS, JSON.stringify(all));
  process.exit(0);
});
