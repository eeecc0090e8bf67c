"""Files of GitHub and GitLab, judged by the public schemas that check-jsonschema carries."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

from check_jsonschema import main
from click.testing import CliRunner

Schema = Literal["github-actions", "github-workflows", "gitlab-ci"]


def problems(path: Path, schema: Schema) -> str:
    """What the schema says against a file; empty where it is valid.  Nothing is asked of the network."""
    words = ["--builtin-schema", f"vendor.{schema}", "--default-filetype", "yaml", str(path)]
    if schema == "gitlab-ci":
        words = ["--data-transform", "gitlab-ci", *words]
    done = CliRunner().invoke(main, words)
    return "" if done.exit_code == 0 else done.output or repr(done.exception)
