"""``archlint config --schema``: it accepts what archlint accepts, and refuses what archlint refuses."""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path
from typing import Any

import jsonschema
import msgspec
import pytest

from archlint.cli import main
from archlint.cli.starter_files import Seen, configuration
from archlint.config.json_schema import DESCRIPTIONS, json_schema
from archlint.config.schema import ConfigurationFile
from archlint.config.settings import ConfigurationError, load

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).parents[2]
ALL_ON = re.sub(r"^#(?! )", "", configuration(Seen("jazzy"), held=True), flags=re.MULTILINE)
"""What `archlint init` writes, with all that is commented out."""


def documented() -> dict[str, str]:
    """The configurations of the README, of the rule pages and of `archlint init`."""
    pages = [ROOT / "README.md", *sorted((ROOT / "rules").glob("*.md"))]
    examples = {
        f"{page.stem}-{number}": text
        for page in pages
        for number, text in enumerate(re.findall(r"```toml\n(.*?)```", page.read_text("utf-8"), re.DOTALL))
    }
    return {**examples, "init": configuration(Seen(), held=False), "init-all": ALL_ON}


EXAMPLES = documented()


def parsed(text: str) -> dict[str, Any]:
    values = tomllib.loads(text)
    return values.get("tool", {}).get("archlint", values)


def accepts(values: object) -> bool:
    return jsonschema.Draft7Validator(json_schema()).is_valid(values)


def test_there_are_examples_of_pages():
    assert len(EXAMPLES) > 8


def test_the_command_prints_it(capsys: pytest.CaptureFixture[str]):
    assert main(["config", "--schema"]) == 0
    printed = json.loads(capsys.readouterr().out)
    jsonschema.Draft7Validator.check_schema(printed)
    assert printed == json.loads(json.dumps(json_schema()))


@pytest.mark.parametrize("text", EXAMPLES.values(), ids=EXAMPLES)
def test_it_accepts_what_is_documented(text: str):
    jsonschema.validate(parsed(text), json_schema(), jsonschema.Draft7Validator)


@pytest.mark.parametrize(
    "text",
    [
        'distros = "jazzy"',
        'distro = "jezzy"',
        'select = "SRV"',
        "closed-world = 1",
        "closed_world = true",
        'severity = {SRV001 = "fatal"}',
        "[rules.GRF003]\ntopic = 3",
        '[rules.hub-bottleneck]\ntopics = "three"',
        "[rules.GRF]\ntopics = 3",
        '[layers]\nmission = ["/mission/*"]',
        '[[contracts]]\nname = "a"\nkind = "forbids"\nfrom = "/a"\nto = "/b"',
        '[[contracts]]\nname = "a"\nkind = "forbid"\nform = "/a"\nto = "/b"',
        '[[contracts]]\nkind = "forbid"\nfrom = "/a"\nto = "/b"',
    ],
)
def test_it_refuses_what_archlint_refuses(text: str, tmp_path: Path):
    (tmp_path / "archlint.toml").write_text(text, "utf-8")
    with pytest.raises(ConfigurationError):
        load(tmp_path)
    assert not accepts(parsed(text))


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[rules.GRF003]\ntopics = 3",
        "[rules.hub-bottleneck]\ntopics = 3\nrate = 2.5",
        'severity = {SRV = "info", hub-bottleneck = "error"}',
        '[owners]\n"/cmd_vel" = "/mux"\n"/scan" = ["/front", "/back"]',
    ],
)
def test_it_accepts_what_archlint_accepts(text: str, tmp_path: Path):
    (tmp_path / "archlint.toml").write_text(text, "utf-8")
    load(tmp_path)
    assert accepts(parsed(text))


def test_each_key_says_what_it_is():
    assert list(DESCRIPTIONS) == sorted(field.encode_name for field in msgspec.structs.fields(ConfigurationFile))


def test_nothing_in_it_is_null():
    assert "null" not in json.dumps(json_schema())
