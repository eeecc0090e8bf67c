"""The help of ``archlint`` itself."""

from __future__ import annotations

OVERVIEW = """\
usage: archlint [COMMAND] [OPTIONS] [PATH ...]

The architecture linter and graph analyzer for ROS 2: reads rclpy code without running it.

commands:
  check [PATH ...]    find what is wrong between nodes and inside their callbacks
                      (`archlint PATH` and `archlint` alone mean this)
  graph [PATH ...]    the communication graph: text, json, dot, svg, png, pdf, mermaid ...
  show NAME [PATH ...]
                      one node, topic, service, action or parameter: both ends, types, QoS, places
  facts -o DIR        compile this workspace into DIR; `check --facts DIR ...` links it elsewhere
  observe             a script that records a running system; `check --observed FILE` and
                      `graph --observed FILE` compare it with the source
  explain CODE        a rule's page: what it finds, why it matters, what to write instead
  rules               the table of rules
  config [PATH]       the effective configuration, and the origin of each value;
                      `config --schema` prints the JSON Schema of a configuration file
  server              the language server for editors (needs archlint[lsp])
  init [PATH]         a commented configuration, a pre-commit hook and a CI job to start with

options:
  -V, --version       print the version
  -h, --help          print this; `archlint COMMAND --help` prints the options of a command

exit status:
  0  everything was analysed and nothing is at or above the failing severity
  1  findings
  2  the run failed: a wrong option or configuration, no input, an internal error
"""
