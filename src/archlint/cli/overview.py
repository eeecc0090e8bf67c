"""The help of ``archlint`` itself."""

from __future__ import annotations

DESCRIPTION = "The architecture linter and graph analyzer for ROS 2: it reads rclpy code without running it."
OPTIONS = {
    "-V, --version": "print the version",
    "-h, --help": "print this; after a command, print its options",
}
EXIT_STATUSES = {
    0: "everything was analysed and nothing is at or above the failing severity",
    1: "findings",
    2: "the run failed: wrong options, no input, an internal error",
}


def overview() -> str:
    """What ``archlint --help`` prints."""
    options = "".join(f"  {names:<18}  {words}\n" for names, words in OPTIONS.items())
    statuses = "".join(f"  {status}  {words}\n" for status, words in EXIT_STATUSES.items())
    return f"{_USAGE}\noptions:\n{options}\nexit status:\n{statuses}"


_USAGE = """\
usage: archlint [COMMAND] [OPTIONS] [PATH ...]

The architecture linter and graph analyzer for ROS 2: it reads rclpy code
without running it.

commands:
  check [PATH ...]    find what is wrong between nodes and in their callbacks
                      (`archlint PATH` and `archlint` alone mean this)
  graph [PATH ...]    the communication graph: text, json, dot, svg, png, pdf,
                      mermaid ...
  diff BASE [HEAD]    what a change does to the architecture, and what it
                      breaks: git revisions, folders or saved graphs
  show NAME           one node, topic, service, action or parameter: both ends,
                      types, QoS, places
  trace NAME          where what arrives there comes from and what depends on
                      it, with periods and waits; --from NAME, --to NAME
  impact NAME         what breaks when a node, topic, service, action or
                      interface is taken away or changed
  advise [PATH ...]   what each topic, service and action is used as, and
                      whether another of the three fits better
  docs [PATH ...]     a page of Markdown for each node and each launch file;
                      --check fails where committed pages are stale
  export --format F   declarations made from the source: interface-yaml, nodl,
                      json, sros2-policy, graphml
  facts -o DIR        compile this workspace into DIR; `check --facts DIR ...`
                      links it elsewhere
  observe             a script that records a running system; `--observed FILE`
                      of check and graph compares it with the source
  explain CODE        a rule's page: what it finds, why it matters, what to
                      write instead
  rules [CODES ...]   the table of rules
  config [PATH]       the effective configuration and the origin of each value;
                      `config --schema` prints its JSON Schema
  server              the language server for editors (needs archlint[lsp])
  init [PATH]         a commented configuration, a pre-commit hook and a CI job
  completion SHELL    a script with which bash, zsh or fish completes commands,
                      options, rules and launch files
  man                 the manual page; `archlint man | man -l -` shows it
"""
