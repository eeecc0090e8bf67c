"""The texts that ``archlint init`` writes for pre-commit and CI."""

from __future__ import annotations

import json
import re
import shlex


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
