"""``[[external-nodes]]``: what nodes offer whose source is not in the workspace."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.cli import main
from archlint.config.settings import ConfigurationError, load
from archlint.ros.external_nodes import ExternalEnd, ExternalParameter

BASE = """
[[external-nodes]]
package = "acme"
executable = ["base", "acme::Base"]
complete = true
publishers = { odom = "nav_msgs/msg/Odometry" }
action-servers = { "~/dock" = "acme_msgs/action/Dock" }
parameters = { wheel_base = "double" }
"""


def read(folder: Path, text: str):
    (folder / "archlint.toml").write_text(text, "utf-8")
    return load(folder).external_nodes


def test_a_node_is_read_as_the_table_has_it(tmp_path: Path):
    [node] = read(tmp_path, BASE)
    assert (node.package, node.executables, node.name, node.open) == ("acme", ("base", "acme::Base"), "base", ())
    assert node.ends == (
        ExternalEnd("publisher", "odom", "nav_msgs/msg/Odometry"),
        ExternalEnd("action_server", "~/dock", "acme_msgs/action/Dock"),
    )
    assert node.parameters == (ExternalParameter("wheel_base", "double"),)


def test_a_node_may_have_more_unless_it_is_said_to_be_complete(tmp_path: Path):
    [node] = read(tmp_path, BASE.replace("complete = true", ""))
    assert node.open and node.takes_any_parameter


@pytest.mark.parametrize(
    ("wrong", "told"),
    [
        (BASE.replace('package = "acme"', ""), "this external node has no `package`"),
        (BASE.replace("publishers", "publisher"), "unknown key of an external node `publisher`"),
        (BASE.replace("nav_msgs/msg/Odometry", "Odometry"), "`odom` must have a type such as `package/msg/Name`"),
        (BASE.replace("acme_msgs/action/Dock", "acme_msgs/msg/Dock"), "must have a type such as `package/action/Name`"),
        (BASE.replace('"double"', '"float"'), "must be one of bool, integer, double"),
        (BASE.replace('["base", "acme::Base"]', "[]"), "`executable` names no executable"),
    ],
)
def test_a_mistake_is_told_with_its_line(tmp_path: Path, wrong: str, told: str):
    with pytest.raises(ConfigurationError) as caught:
        read(tmp_path, wrong)
    assert told in str(caught.value)
    assert "archlint.toml:" in str(caught.value)


def test_the_effective_configuration_can_be_read_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    nodes = read(tmp_path, BASE)
    monkeypatch.chdir(tmp_path)
    main(["config"])
    assert read(tmp_path, capsys.readouterr().out) == nodes
