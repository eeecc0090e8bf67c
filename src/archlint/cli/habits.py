"""What users of other linters type, and what does it here."""

from __future__ import annotations

COMMANDS = {
    "lint": "check",
    "run": "check",
    "analyze": "check",
    "analyse": "check",
    "scan": "check",
    "test": "check",
    "ruff": "check",
    "fix": "check --fix",
    "format": "check --fix",
    "draw": "graph",
    "plot": "graph",
    "list": "rules",
    "rule": "explain CODE",
    "why": "explain CODE",
    "settings": "config",
    "baseline": "check --baseline archlint-baseline.txt --write-baseline",
    "version": "--version",
    "completions": "completion",
    "generate-shell-completion": "completion",
}
"""Commands of other tools."""

_KEY = "that is the key `{}` of the configuration"
OPTIONS = {
    "--output-format": "write --format",
    "--output-file": "write -o",
    "-f": "write --format",
    "--json": "write --format json",
    "--sarif": "write --format sarif",
    "--show-source": "the format text, which is the default, shows the source",
    "--disable": "write --ignore",
    "--extend-ignore": "write --ignore, which adds to what the configuration ignores",
    "--enable": "write --extend-select",
    "--rules": "write --select",
    "--exclude": _KEY.format("exclude"),
    "--extend-exclude": _KEY.format("exclude"),
    "--per-file-ignores": _KEY.format("per-file-ignores"),
    "--target-version": 'write the key `distro` of the configuration, such as "jazzy"',
    "--distro": _KEY.format("distro"),
    "--ros-distro": _KEY.format("distro"),
    "--strict": "write --severity info, with which every finding fails the run",
    "--max-warnings": "to let warnings pass, write --severity error",
    "--fail-level": "write --severity",
    "--fail-on": "write --severity",
    "--min-severity": "write --severity",
    "--failure-threshold": "write --severity",
    "--no-fix": "nothing is fixed without --fix",
    "--fix-only": "write --fix",
    "--show-fixes": "write --diff",
    "--add-noqa": "write --add-ignores",
    "--suppress-all": "write --baseline FILE --write-baseline",
    "--generate-baseline": "write --baseline FILE --write-baseline",
    "--show-settings": "`archlint config` prints them",
    "--show-files": "`archlint config` says what is left out, and the summary how many files there were",
    "--explain": "write `archlint explain CODE`",
    "--list-rules": "write `archlint rules`",
    "--version": "write `archlint --version`",
    "-j": "write --jobs",
    "-n": "write --no-cache",
    "-w": "write --watch",
    "-s": "write --quiet",
    "--silent": "write --quiet",
    "--no-color": "write --color never",
    "--line-length": "archlint checks no style: ruff does",
    "--max-line-length": "archlint checks no style: ruff does",
    "--max-complexity": "archlint checks no style: ruff does",
    "--ignore-missing-imports": "it is not needed: an import that is not found is no finding",
    "--python-version": "it is not needed: the code is read for every version of Python that ROS 2 uses",
    "-p": "write the path of the package",
    "--package": "write the path of the package",
    "--packages-select": "write the paths of the packages",
    "--stdin-filename": "archlint reads files: a finding is about more than one of them",
}
"""Options of ruff, flake8, pylint, mypy, colcon and others that archlint does not have, and what to do instead."""


def advice_on_option(word: str) -> str:
    """What to write for an option of another tool; empty where it is none."""
    name = word.partition("=")[0]
    return OPTIONS.get(name) or OPTIONS.get(name[:2] if not name.startswith("--") else "", "")
