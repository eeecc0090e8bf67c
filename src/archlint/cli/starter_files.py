"""The texts that ``archlint init`` writes: a configuration, a hook for pre-commit and a job for CI.

In the configuration a comment that starts with ``# `` is prose, and one that starts with ``#`` alone is a setting to
switch on.
"""

from __future__ import annotations

import json
import re
import shlex
from collections.abc import Sequence
from dataclasses import dataclass

BASELINE = "archlint-baseline.txt"
ATTRIBUTES = f"{BASELINE} merge=union"
"""What `.gitattributes` says of the baseline: after a merge it has the lines of both sides."""


@dataclass(frozen=True)
class Seen:
    """What the comments of a configuration take from a workspace."""

    distro: str | None = None
    """The distribution of this shell, where there is one."""
    launch_files: Sequence[str] = ()
    """Paths from the folder of the configuration."""
    owners: Sequence[tuple[str, str]] = ()
    """Topics that one node publishes and others read, each with that node."""


_CONFIGURATION = """\
# What archlint checks here.  `archlint config` prints all values and where each comes from, `archlint rules` lists the
# rules, and `archlint explain CODE` prints the page of one.  To switch on a line that starts with #, remove the #.

# The ROS distribution to judge for; {why}.
{distro}

# The findings that are there already are held back: only what is new fails.  `archlint check --no-baseline` shows them
# all, `archlint check --prune-baseline` removes what is mended, and `archlint check --write-baseline` writes the file.
{held}baseline = "{baseline}"

# Where to start from.  "course": errors fail, warnings only inform.  "team": errors and warnings fail, and a
# suppression needs a reason.  "safety": every finding fails, and most rules that are off by default run.
#preset = "team"

# Rules by code, prefix, name or "ALL".  NME, for example, are the rules about names.
#extend-select = ["NME"]
#ignore = ["OWN001"]

# Folders and files that are not checked.
#exclude = ["**/experimental/**"]

# The launch files that are systems of their own; unset: all of them.
#launch = [{launch}]

# Names that other machines or C++ packages provide.
#external = ["/joint_states"]

# Whether nothing outside this workspace takes part: then a topic that nobody publishes is a finding.
#closed-world = true

# How much a finding of a rule weighs; errors and warnings fail `archlint check`.
[severity]
#NME001 = "info"

# Rules that are off for some files or packages.
[per-file-ignores]
#"**/test/**" = ["TMO"]

[per-package-ignores]
#my_experiments = ["EXE", "QOS"]

# The only nodes that may publish a topic (OWN003).
[owners]
{owners}

# What must be connected, and what must not be (ARC001 and ARC003).
#[[contracts]]
#name = "the planner never drives the motor itself"
#kind = "forbid"
#from = "/planner"
#to = "/motor"
"""


def configuration(seen: Seen, held: bool) -> str:
    """An ``archlint.toml``; ``held`` says whether a baseline holds back what is found today."""
    owners = "\n".join(f"#{json.dumps(topic)} = {json.dumps(node)}" for topic, node in seen.owners)
    return _CONFIGURATION.format(
        why="as $ROS_DISTRO was when this file was written" if seen.distro else "unset: for all that are supported",
        distro=f'distro = "{seen.distro}"' if seen.distro else '#distro = "jazzy"',
        held="" if held else "#",
        baseline=BASELINE,
        launch=", ".join(map(json.dumps, seen.launch_files)) or '"**/bringup.launch.py"',
        owners=owners or '#"/cmd_vel" = "/safety_mux"',
    )


def hook(folder: str) -> str:
    """The entry below ``repos:`` of a ``.pre-commit-config.yaml``; ``folder`` is the workspace, from there."""
    return f"""\
  - repo: local
    hooks:
      - id: archlint
        name: archlint
        # For the archlint on your PATH.  A finding is about both ends of a connection: all is checked.
        entry: {_scalar(_command(folder, "--quiet"))}
        language: system
        pass_filenames: false
        require_serial: true
        always_run: true
"""


def hooks(folder: str) -> str:
    """A whole ``.pre-commit-config.yaml``."""
    return f"# `pre-commit install` lets git run this before each commit.\nrepos:\n{hook(folder)}"


def github_workflow(folder: str, submodules: bool) -> str:
    more = "\n        with:\n          submodules: true" if submodules else ""
    return f"""\
# Checks the architecture at each push and pull request, and shows the findings at their lines.
name: archlint
on: [push, pull_request]
permissions:
  contents: read
jobs:
  archlint:
    runs-on: ubuntu-latest
    steps:
      - uses: actions/checkout@v5{more}
      - run: {_scalar("pipx run " + _command(folder, "--format", "github"))}
"""


def gitlab_job(folder: str, submodules: bool) -> str:
    more = "\n  variables:\n    GIT_SUBMODULE_STRATEGY: normal" if submodules else ""
    return f"""\
# Checks the architecture, and shows the findings in the merge request.
archlint:
  image: python:3.12{more}
  script:
    - pip install archlint
    - {_scalar(_command(folder, "--output", "gitlab=archlint.json"))}
  artifacts:
    when: always
    reports:
      codequality: archlint.json
"""


def jenkins_stage(folder: str) -> str:
    """The entry below ``stages`` of a Jenkinsfile."""
    check = _command(folder, "--exit-zero", "--output", "junit=archlint.xml")
    return f"""\
    stage('archlint') {{
      steps {{
        sh 'python3 -m venv .archlint-ci && .archlint-ci/bin/pip install --quiet archlint'
        sh {_groovy(f".archlint-ci/bin/{check}")}
      }}
      post {{ always {{ junit 'archlint.xml' }} }}
    }}
"""


def _groovy(text: str) -> str:
    """A text as Groovy writes one in which nothing is replaced."""
    escaped = text.replace("\\", "\\\\").replace("'", "\\'")
    return f"'{escaped}'"


def _command(folder: str, *options: str) -> str:
    return shlex.join(["archlint", "check", *options, *([] if folder == "." else [folder])])


def _scalar(text: str) -> str:
    """A text as a YAML value: quoted where it is more than plain words."""
    return text if re.fullmatch(r"[\w ./=-]+", text, re.ASCII) else json.dumps(text)
