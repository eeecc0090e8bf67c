"""Several workspaces in one process: none of them changes what is said of another."""

from __future__ import annotations

import ast
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from itertools import pairwise, permutations
from pathlib import Path
from textwrap import dedent

import pytest

import archlint
from archlint.cli import main
from archlint.config.settings import Settings, load
from archlint.engine import findings
from archlint.engine.inputs import find_files, tree_of
from archlint.engine.pipeline import Request, check
from learners import learned
from robot_package import TALKER, write_robot

ROOT = Path(__file__).parents[2]
WORKSPACES = [ROOT / "fixtures" / name for name in ("launched", "lesson_extended", "alternatives")]
COMMANDS = [
    ["check", ".", "--format", "json", "--no-cache", "--jobs", "1", "--isolated"],
    ["graph", ".", "--format", "json", "--no-cache", "--jobs", "1", "--isolated"],
]


def _without_time(output: str) -> str:
    return re.sub(r'"elapsed_s": [\d.]+', "", output)


@pytest.fixture(scope="module")
def alone() -> dict[Path, list[str]]:
    """What each workspace gives in a process of its own."""
    environment = {**os.environ, "PYTHONPATH": str(Path(archlint.__file__).parents[1])}
    return {
        workspace: [
            _without_time(
                subprocess.run(
                    [sys.executable, "-m", "archlint", *command],
                    cwd=workspace,
                    env=environment,
                    stdout=subprocess.PIPE,
                    text=True,
                    check=False,
                ).stdout
            )
            for command in COMMANDS
        ]
        for workspace in WORKSPACES
    }


def test_one_after_the_other_gives_what_each_gives_alone(
    alone: dict[Path, list[str]], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    assert all('"diagnostics"' in outputs[0] and '"nodes"' in outputs[1] for outputs in alone.values())
    first, second, third = WORKSPACES
    order = [first, second, third, second, first, third, first]
    assert set(pairwise(order)) == set(permutations(WORKSPACES, 2))
    for workspace in order:
        monkeypatch.chdir(workspace)
        for command, expected in zip(COMMANDS, alone[workspace], strict=True):
            capsys.readouterr()
            main(command)
            assert _without_time(capsys.readouterr().out) == expected, workspace.name


NODE = """
    import rclpy
    from rclpy.node import Node
    from std_srvs.srv import Trigger


    class Robot(Node):
        def __init__(self):
            super().__init__('robot')
            self.client = self.create_client(Trigger, 'reset')
            self.client.wait_for_service()


    def main():
        rclpy.init()
        rclpy.spin(Robot())


    if __name__ == '__main__':
        main()
"""


def test_another_workspace_is_judged_in_between(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """The folder ``tests`` above a workspace makes nothing of it a test, whatever is read after it."""
    for folder in ("tests/robot", "other"):
        (tmp_path / folder).mkdir(parents=True)
        (tmp_path / folder / "robot.py").write_text(dedent(NODE).lstrip(), encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    judged, inside = findings._rules, []

    def rules(settings, systems, memory):
        if not inside:
            inside.append("other")
            inside.append(places("other"))
        return judged(settings, systems, memory)

    def places(folder: str) -> list[tuple[str, str]]:
        report = check(Request((folder,), Settings(), cached=False, jobs=1))
        return [(one.code, one.place.file) for one in report.findings if one.code == "TMO001"]

    monkeypatch.setattr(findings, "_rules", rules)
    assert places("tests/robot") == [("TMO001", "tests/robot/robot.py")]
    assert inside == ["other", [("TMO001", "other/robot.py")]]


PURE = {
    "checks/near_misses.py": {"_names_of_ros"},
    "checks/registry.py": {"_defined"},
    "engine/own_code.py": {"own_code"},
    "engine/remote.py": {"identity"},
    "libraries/api_signatures.py": {"_table"},
    "libraries/module_names.py": {"_table"},
    "libraries/python_names.py": {"_table"},
    "ros/bridged_types.py": {"pairs"},
    "ros/external_nodes.py": {"well_known"},
    "ros/launch_arguments.py": {"well_known"},
    "ros/plugin_parameters.py": {"well_known"},
    "packaging/mistaken_imports.py": {"_by_length"},
    "ros/packages.py": {"released_names", "table"},
    "ros/python_modules.py": {"names"},
    "ros/rosdep.py": {"_on_ubuntu", "keys"},
    "ros/standard_interfaces.py": {"table"},
    "rulebook.py": {"own_rules"},
    "syntax/cpp/parser.py": {"_parser"},
    "syntax/facts.py": {"_decoder"},
    "syntax/fields_with_facts.py": {"fields_with_facts"},
}
"""What is kept for the process, since it follows from archlint's own files alone."""
PURE_KEYS = re.compile(
    r"(?:str|int|bool|tuple\[str, \.\.\.\]|frozenset\[str\]|Itself\[.*\]"
    r"|ParameterFileUse|tuple\[Rewriting \| Replacing \| Written, \.\.\.\])(?: \| None)?"
)
"""Of these alone may anything else that is kept for the process be made: texts, numbers, truth, what a launch file says
of a parameter file, compared as texts are, and pieces of source, each known by its identity.  What a function says of
them is the same in every workspace."""


def sources(words: str = "") -> Iterator[tuple[str, ast.Module]]:
    """The modules in which a pattern occurs; the others need not be parsed."""
    folder = Path(archlint.__file__).parent
    for file in sorted(folder.rglob("*.py")):
        text = file.read_text(encoding="utf-8")
        if re.search(words, text):
            yield file.relative_to(folder).as_posix(), ast.parse(text)


def is_cached(function: ast.FunctionDef) -> bool:
    return any(re.match(r"(functools\.)?(lru_)?cache\b", ast.unparse(one)) for one in function.decorator_list)


def is_made_of_pure_keys(function: ast.FunctionDef) -> bool:
    """Whether all that a function is given is a pure key: then the cache has nothing of a workspace but its source."""
    given = [one.annotation for one in function.args.args]
    return bool(given) and all(one is not None and PURE_KEYS.fullmatch(ast.unparse(one)) for one in given)


def test_nothing_of_a_workspace_is_kept_in_a_module():
    """A cache lives on what it is of: a ``System`` or a ``WorkspaceIndex`` (:mod:`archlint.analysis.kept`)."""
    kept: dict[str, set[str]] = {}
    for file, tree in sources(r"\bglobal\b|cache\b"):
        for item in ast.walk(tree):
            match item:
                case ast.Global(names=names):
                    kept.setdefault(file, set()).update(names)
                case ast.FunctionDef(name=name) if is_cached(item) and not is_made_of_pure_keys(item):
                    kept.setdefault(file, set()).add(name)
    assert kept == PURE


CONTAINER = re.compile(r"\{\}|\[\]|(set|dict|list)\(\)|(\w+\.)?(defaultdict|deque|Counter|Weak\w+)\(.*\)")


def test_no_module_has_a_container_to_be_filled():
    filled: dict[str, set[str]] = {}
    for file, tree in sources():
        for item in tree.body:
            match item:
                case ast.Assign(targets=[name], value=value) | ast.AnnAssign(target=name, value=ast.expr() as value):
                    if CONTAINER.fullmatch(ast.unparse(value)):
                        filled.setdefault(file, set()).add(ast.unparse(name))
    assert not filled


def test_what_two_copies_of_a_package_show_is_said_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    write_robot(tmp_path / "src/robot", **{"robot/talker.py": TALKER.replace("'chatter'", "'/said'")})
    write_robot(tmp_path / "vendor/robot", **{"robot/talker.py": "\n" + TALKER.replace("'chatter'", "'/said'")})
    (tmp_path / "archlint.toml").write_text('select = ["NME001"]\n[rules.NME001]\neverywhere = true\n')
    monkeypatch.chdir(tmp_path)

    def told() -> list[tuple[str, list[str]]]:
        report = check(Request((".",), load(tmp_path), cached=False, jobs=1))
        assert report.summary.warnings == len(report.findings)
        return [(one.place.file, [related.place.file for related in one.related]) for one in report.findings]

    assert told() == [("src/robot/robot/talker.py", ["vendor/robot/robot/talker.py"])]
    # Another name, or another file, is another finding.
    changed = tmp_path / "vendor/robot/robot/talker.py"
    changed.write_text(changed.read_text().replace("/said", "/told"))
    assert [file for file, _ in told()] == ["src/robot/robot/talker.py", "vendor/robot/robot/talker.py"]


def test_packages_of_one_name_that_are_no_copies_are_told_apart(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    other = TALKER.replace("String, 'chatter', 10", "String, 'chatter', qos_profile=5")
    assert other != TALKER
    for student, text in (("anna", TALKER), ("ben", other)):
        write_robot(tmp_path / student / "src/robot", **{"robot/talker.py": text.replace("'chatter'", "'/said'")})
    (tmp_path / "archlint.toml").write_text('select = ["NME001"]\n[rules.NME001]\neverywhere = true\n')
    monkeypatch.chdir(tmp_path)

    report = check(Request((".",), load(tmp_path), cached=False, jobs=1))

    assert [(one.place.file, one.related) for one in report.findings] == [
        ("anna/src/robot/robot/talker.py", ()),
        ("ben/src/robot/robot/talker.py", ()),
    ]


def test_another_workspace_does_not_know_the_interfaces_of_this_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """Both students define GetSensorData.  Anna calls it, and nobody serves it; Ben only imports it."""
    name = "nobody_serves_what_the_workspace_defines"
    workspace = next(workspace for workspace in learned() if workspace.name == name)
    for student in ("anna", "ben"):
        workspace.write(tmp_path / student)
    [control] = (tmp_path / "ben").rglob("control.py")
    control.write_text("from my_robot_interfaces.srv import GetSensorData\n\nREQUEST = GetSensorData.Request\n")
    (tmp_path / "archlint.toml").write_text('select = ["SRV001"]')
    monkeypatch.chdir(tmp_path)

    report = check(Request((".",), load(tmp_path), cached=False, jobs=1))

    assert [one.place.file.partition("/")[0] for one in report.findings] == ["anna"]


def test_what_two_folders_share_is_not_searched(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It may be the folder of a user: only what is in the two is there."""
    monkeypatch.chdir(tmp_path)
    for name in ("arm/src/robot", "base/src/robot"):
        write_robot(Path(name))
    Path("private").mkdir()
    Path("private/notes.md").write_text("secret", encoding="utf-8")
    request = Request(("arm", "base"), load(tmp_path), cached=False)
    tree = tree_of(request, find_files(request))
    listed = tree.files_below(".")
    assert {path.split("/")[0] for path in listed} == {"arm", "base"}
    assert tree.text("private/notes.md") is None
