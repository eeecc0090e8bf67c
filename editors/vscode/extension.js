"use strict";

const { commands, window, workspace } = require("vscode");
const { LanguageClient, TransportKind } = require("vscode-languageclient/node");

/** What archlint reads: Python, C++, launch files, parameters, manifests, interfaces and its own configuration. */
const DOCUMENTS = [
  { scheme: "file", language: "python" },
  { scheme: "file", pattern: "**/*.{cpp,cc,cxx,hpp,hh,hxx,h}" },
  { scheme: "file", pattern: "**/*.{xml,launch,yaml,yml}" },
  { scheme: "file", pattern: "**/*.{msg,srv,action}" },
  { scheme: "file", pattern: "**/{CMakeLists.txt,setup.cfg,pyproject.toml,archlint.toml,.archlint.toml}" },
];

let client;

function newClient() {
  const [command, ...words] = workspace.getConfiguration("archlint").get("command", []);
  const run = { command: command || "archlint", args: [...words, "server"], transport: TransportKind.stdio };
  return new LanguageClient("archlint", "archlint", { run, debug: run }, { documentSelector: DOCUMENTS });
}

async function start() {
  client = newClient();
  try {
    await client.start();
  } catch (error) {
    const answer = await window.showErrorMessage(
      `archlint did not start: ${error.message ?? error}. It is installed with: pip install "archlint[lsp]"`,
      "Show the output",
    );
    if (answer) {
      client.outputChannel.show();
    }
  }
}

async function stop() {
  const running = client;
  client = undefined;
  if (running?.isRunning()) {
    await running.stop();
  }
  await running?.dispose();
}

async function restart() {
  await stop();
  await start();
}

async function activate(context) {
  context.subscriptions.push(
    commands.registerCommand("archlint.restart", restart),
    commands.registerCommand("archlint.showOutput", () => client?.outputChannel.show()),
    workspace.onDidChangeConfiguration((event) => {
      if (event.affectsConfiguration("archlint.command")) {
        return restart();
      }
    }),
  );
  await start();
}

module.exports = { activate, deactivate: stop };
