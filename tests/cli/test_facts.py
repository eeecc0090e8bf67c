"""``archlint facts`` compiles in one place, and ``check --facts`` links in another, where no sources are."""

from __future__ import annotations

import hashlib
import json
import os
import re
import shutil
from collections.abc import Callable
from pathlib import Path

import msgspec
import pytest

from archlint.cli import main
from archlint.engine.facts_file import CodeRow, Shard, packed, unpacked
from archlint.engine.facts_folder import INDEX
from archlint.workspace.snapshot import Entry
from robot_package import manifest, write_files

SETUP = """\
from setuptools import find_packages, setup

setup(name='{0}', packages=find_packages(), entry_points={{'console_scripts': ['{0} = {0}.node:main']}})
"""

NODE = """\
import rclpy
from names.topics import SPEED
from rclpy.node import Node
from std_msgs.msg import {type}


class {name}(Node):
    def __init__(self):
        super().__init__('{node}')
        self.{create}


def main():
    rclpy.init()
    rclpy.spin({name}())
"""

DRIVER = NODE.format(
    type="Float32",
    name="Driver",
    node="driver",
    create="create_subscription(Float32, SPEED, print, 10)\n        self.create_publisher(Float32, '/bad name', 10)",
)
PLANNER = NODE.format(type="String", name="Planner", node="planner", create="create_publisher(String, SPEED, 10)")


DEPENDS = {"names": [], "driver": ["names"], "planner": ["names", "driver"]}


def package(name: str, **files: str) -> dict[str, str]:
    return {
        f"{name}/package.xml": manifest(
            name, more="".join(f"<exec_depend>{other}</exec_depend>" for other in DEPENDS[name])
        ),
        f"{name}/setup.py": SETUP.format(name),
        f"{name}/setup.cfg": f"[install]\ninstall_scripts=$base/lib/{name}\n",
        f"{name}/resource/{name}": "",
        f"{name}/{name}/__init__.py": "",
        **{f"{name}/{name}/{file}.py": text for file, text in files.items()},
    }


@pytest.fixture
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Three packages: two nodes that disagree about a type, and the name of the topic, in a file without any ROS."""
    folder = tmp_path / "workspace"
    files = {
        **package("driver", node=DRIVER),
        **package("planner", node=PLANNER),
        **package("names", topics="SPEED = '/speed'\n"),
    }
    write_files(folder, {f"src/{path}": text for path, text in files.items()})
    monkeypatch.chdir(folder)
    return folder


@pytest.fixture
def elsewhere(tmp_path: Path) -> Path:
    """A folder that has none of the sources."""
    folder = tmp_path / "elsewhere"
    folder.mkdir()
    return folder


Said = tuple[int, str, str]
Say = Callable[..., Said]
"""Runs a command: exit status, standard output, standard error."""


@pytest.fixture
def say(capsys: pytest.CaptureFixture[str]) -> Say:
    def run(*words: str) -> Said:
        status = main(list(words))
        said = capsys.readouterr()
        return status, re.sub(r'("elapsed_s": |\btime=")[0-9.]+', "", said.out), said.err

    return run


COMMANDS = [
    ("check",),
    *(("check", "--format", name) for name in ("json", "concise", "sarif", "github", "gitlab", "junit")),
    ("graph", "--format", "json"),
    ("graph", "--format", "text"),
]


# --------------------------------------------------------------------------------------------- same bytes


def test_facts_say_what_the_sources_say(
    workspace: Path, elsewhere: Path, say: Say, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("GITHUB_WORKSPACE", str(workspace))
    sources = [say(*command, "--isolated", "--no-cache") for command in COMMANDS]
    assert main(["facts", "-o", str(elsewhere / "facts")]) == 0
    shutil.rmtree(workspace / "src")
    monkeypatch.setenv("GITHUB_WORKSPACE", str(elsewhere))
    monkeypatch.chdir(elsewhere)
    say()
    facts = [say(*command, "--isolated", "--facts", "facts") for command in COMMANDS]
    assert facts == sources
    assert "TOP001" in facts[0][1]
    assert "self.create_publisher(Float32, '/bad name', 10)" in facts[0][1]  # the line of a source that is gone


def test_facts_of_cpp_are_linked_with_those_of_python(workspace: Path, elsewhere: Path, say: Say) -> None:
    source = '#include "names.hpp"\nint main() { rclcpp::Node node(NAME); }\n'
    header = '#include <rclcpp/rclcpp.hpp>\n#define NAME "talker"\n'
    write_files(workspace / "src/driver", {"src/talker.cpp": source, "src/names.hpp": header})
    sources = say("graph", "--format", "json", "--isolated", "--no-cache")
    assert main(["facts", "-o", str(elsewhere / "facts")]) == 0
    shutil.rmtree(workspace / "src")
    say()
    facts = say("graph", "--format", "json", "--isolated", "--facts", str(elsewhere / "facts"))
    assert facts == sources
    assert '"name": "/talker"' in facts[1]


def test_the_disk_is_not_looked_at(workspace: Path, elsewhere: Path, say: Say, monkeypatch: pytest.MonkeyPatch) -> None:
    main(["facts", "-o", str(elsewhere / "facts")])
    before = say("check", "--isolated", "--facts", str(elsewhere / "facts"))
    (workspace / "src/driver/driver/node.py").write_text("# nothing is left of it\n")
    (workspace / "src/names/package.xml").write_text("<damaged")
    (workspace / "src/driver/launch.py").write_text("a new file\n")
    assert say("check", "--isolated", "--facts", str(elsewhere / "facts"))[1] == before[1]


def test_the_same_sources_make_the_same_bytes(workspace: Path, elsewhere: Path) -> None:
    main(["facts", "-o", str(elsewhere / "one"), "--jobs", "1", "--no-cache"])
    main(["facts", "-o", str(elsewhere / "two"), "--jobs", "2"])
    first, second = ({path.name: path.read_bytes() for path in (elsewhere / n).iterdir()} for n in ("one", "two"))
    assert first == second
    assert len(first) == 5  # three packages, what lies in none, and the index


def test_only_the_shard_of_the_package_that_changed_is_new(workspace: Path, elsewhere: Path) -> None:
    folder = elsewhere / "facts"
    main(["facts", "-o", str(folder)])
    before = {path.name for path in folder.iterdir()}
    (workspace / "src/planner/planner/node.py").write_text(PLANNER + "# more\n")
    main(["facts", "-o", str(folder)])
    now = {path.name for path in folder.iterdir()}
    [gone], [new] = before - now, now - before
    assert gone.startswith("src-planner-")
    assert new.startswith("src-planner-")


def test_a_launch_file_of_the_facts_is_launched(
    workspace: Path, elsewhere: Path, say: Say, monkeypatch: pytest.MonkeyPatch
) -> None:
    launch = "<launch><node pkg='planner' exec='planner' namespace='front'/></launch>\n"
    write_files(workspace, {"src/planner/launch/robot.launch.xml": launch})
    main(["facts", "-o", str(elsewhere / "facts")])
    monkeypatch.chdir(elsewhere)
    words = "graph", "--isolated", "--facts", "facts", "--launch", "src/planner/launch/robot.launch.xml"
    assert "/front/planner" in say(*words)[1]
    status, _, error = say(*words[:-1], "src/planner/launch/other.launch.xml")
    assert status == 2
    assert "is not a launch file" in error


# ------------------------------------------------------------------------------------- several folders


def test_two_repositories_meet_where_their_facts_are_linked(
    tmp_path: Path, elsewhere: Path, say: Say, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each is checked out by itself, as ``.``, and knows nothing of the other."""
    names = package("names", topics="SPEED = '/speed'\n")
    for name, text in (("driver", DRIVER), ("planner", PLANNER)):
        write_files(tmp_path / name, {path.partition("/")[2]: text for path, text in package(name, node=text).items()})
    write_files(tmp_path / "names", {path.partition("/")[2]: text for path, text in names.items()})
    for name in ("driver", "planner", "names"):
        monkeypatch.chdir(tmp_path / name)
        assert main(["facts", "-o", str(elsewhere / name), "--prefix", f"src/{name}"]) == 0
    monkeypatch.chdir(elsewhere)
    alone = say("check", "--isolated", "--format", "concise", "--facts", "driver", "names")[1]
    both = say("check", "--isolated", "--format", "concise", "--facts", "driver", "planner", "names")[1]
    assert "TOP001" not in alone
    assert "TOP001" in both
    assert "src/driver/driver/node.py" in both


def test_a_package_may_be_in_several_folders_if_it_is_the_same(workspace: Path, elsewhere: Path, say: Say) -> None:
    main(["facts", "-o", str(elsewhere / "all")])
    main(["facts", "src/driver", "-o", str(elsewhere / "driver")])
    whole = say("check", "--isolated", "--facts", str(elsewhere / "all"))
    assert say("check", "--isolated", "--facts", str(elsewhere / "all"), str(elsewhere / "driver"))[1] == whole[1]


def test_facts_that_contradict_each_other_are_refused(workspace: Path, elsewhere: Path, say: Say) -> None:
    main(["facts", "-o", str(elsewhere / "before")])
    (workspace / "src/driver/driver/node.py").write_text(PLANNER)
    main(["facts", "-o", str(elsewhere / "after")])
    say()
    status, _, error = say("check", "--isolated", "--facts", str(elsewhere / "before"), str(elsewhere / "after"))
    assert status == 2
    assert "disagree about src/driver/driver/node.py" in error
    assert "--prefix" in error


# ------------------------------------------------------------------------------- what facts do not hold


def test_what_the_facts_left_out_and_a_launch_file_reads_ends_the_run(
    workspace: Path, elsewhere: Path, say: Say, monkeypatch: pytest.MonkeyPatch
) -> None:
    launch = """\
        <launch><node pkg='planner' exec='planner'>
        <param from='$(find-pkg-share planner)/config/values.csv'/></node></launch>
        """
    setup = SETUP.format("planner").replace(
        "packages=", "data_files=[('share/planner/config', ['config/values.csv'])], packages="
    )
    write_files(
        workspace / "src/planner",
        {"launch/robot.launch.xml": launch, "config/values.csv": "/**:\n", "setup.py": setup},
    )
    main(["facts", "-o", str(elsewhere / "facts")])
    monkeypatch.chdir(elsewhere)
    say()
    status, output, error = say("check", "--isolated", "--facts", "facts")
    assert (status, output) == (2, "")
    assert "src/planner/config/values.csv" in error


def test_a_file_that_cannot_be_read_is_told_of_all_the_same(
    workspace: Path, elsewhere: Path, say: Say, monkeypatch: pytest.MonkeyPatch
) -> None:
    (workspace / "src/driver/driver/broken.py").write_text("import rclpy\ndef f(:\n")
    (workspace / "src/driver/driver/nul.py").write_bytes(b"import rclpy\0")
    (workspace / "src/driver/driver/gone.py").symlink_to("nowhere.py")
    os.mkfifo(workspace / "src/driver/driver/pipe.py")
    words = "check", "--isolated", "--format", "concise", "--select", "LNT002"
    sources = say(*words, "--no-cache")
    assert main(["facts", "-o", str(elsewhere / "facts")]) == 0
    monkeypatch.chdir(elsewhere)
    say()
    facts = say(*words, "--facts", "facts")
    assert facts == sources
    assert facts[1].count("LNT002") == 4


# ---------------------------------------------------------------------------------------- wrong options


@pytest.mark.parametrize(
    ("words", "error"),
    [
        (["check", "--facts", "none"], "there are no facts in none: `archlint facts -o none` writes them"),
        (["check", "src", "--facts", "facts"], "no PATH can be given with it"),
        (["check", "--fix", "--facts", "facts"], "--fix and --diff need the sources"),
        (["check", "--diff", "--facts", "facts"], "--fix and --diff need the sources"),
        (["facts"], "-o"),
        (["facts", "-o", "src"], "src holds other files than facts: name a folder that is new or empty"),
        (["facts", "-o", "new", "--prefix", "../up"], "must be a folder inside the workspace"),
        (["facts", "-o", "new", ".."], "is outside of the working directory"),
        (["facts", "-o", "new", "absent"], "no such file or directory: absent"),
    ],
)
def test_what_cannot_be_done_is_told_and_ends_in_2(workspace: Path, say: Say, words: list[str], error: str) -> None:
    main(["facts", "-o", "facts"])
    say()
    status, output, told = say(*words)
    assert (status, output) == (2, "")
    assert error in told
    assert not (workspace / "new").exists()


# -------------------------------------------------------------------------- what anybody may have written


def index_of(folder: Path) -> dict[str, object]:
    return json.loads((folder / INDEX).read_text())


def refused(say: Say, folder: Path) -> str:
    """What is told of facts that cannot be used."""
    say()
    status, output, error = say("check", "--isolated", "--facts", str(folder))
    assert (status, output) == (2, "")
    assert "internal error" not in error
    return error


@pytest.fixture
def facts(workspace: Path, elsewhere: Path) -> Path:
    main(["facts", "-o", str(elsewhere / "facts")])
    return elsewhere / "facts"


@pytest.mark.parametrize("change", [{"archlint": "0.0.9"}, {"version": 1}, {"facts": 1}])
def test_facts_of_another_version_are_refused(facts: Path, say: Say, change: dict[str, object]) -> None:
    (facts / INDEX).write_text(json.dumps(index_of(facts) | change))
    assert "were written by archlint" in refused(say, facts)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[]",
        "null",
        "\0",
        '{"version": "1"}',
        '{"version": 1e99}',
        "[" * 100_000,
        '{"version":1,"archlint":"0.1.0","facts":9}',
    ],
)
def test_an_index_that_is_none_is_refused(facts: Path, say: Say, text: str) -> None:
    (facts / INDEX).write_text(text)
    refused(say, facts)


@pytest.mark.parametrize(
    "name", ["../../workspace/src/driver/setup.py", "/etc/passwd", "archlint-facts.json", "a\0.shard"]
)
def test_only_shards_of_the_folder_itself_are_read(facts: Path, say: Say, name: str) -> None:
    index = index_of(facts)
    index["shards"] = [{"file": name, "folder": ".", "sha256": "0" * 64}]
    (facts / INDEX).write_text(json.dumps(index))
    assert "is not the name of a shard" in refused(say, facts)


def test_a_shard_that_is_missing_or_not_the_one_of_the_index_is_refused(facts: Path, say: Say) -> None:
    shard = next(facts.glob("*.shard"))
    shard.write_bytes(shard.read_bytes() + b"\0")
    assert "is not the shard that its index names" in refused(say, facts)
    shard.unlink()
    assert f"cannot read {shard}" in refused(say, facts)


def replace_shard(facts: Path, data: bytes) -> None:
    """Put something in the place of the driver's shard, with an index that names it."""
    index = index_of(facts)
    [row] = [row for row in index["shards"] if "driver" in row["file"]]  # type: ignore[attr-defined]
    (facts / row["file"]).write_bytes(data)
    row["sha256"] = hashlib.sha256(data).hexdigest()
    (facts / INDEX).write_text(json.dumps(index))


def shard_in(facts: Path) -> Shard:
    return unpacked(next(facts.glob("src-driver-*.shard")).read_bytes())


NODE_PATH = "src/driver/driver/node.py"


@pytest.mark.parametrize(
    ("change", "error"),
    [
        ({"entries": {"/etc/passwd": Entry(b"")}}, "'/etc/passwd' is not a path inside the workspace"),
        ({"entries": {"a/../../b": Entry(b"")}}, "'a/../../b' is not a path inside the workspace"),
        ({"entries": {"a//b": Entry(b"")}}, "'a//b' is not a path inside the workspace"),
        ({"entries": {"": Entry(b"")}}, "'' is not a path inside the workspace"),
        ({"entries": {"a": Entry(link="../b")}}, "'../b' is not a path inside the workspace"),
        ({"entries": {"a": Entry(b""), "a/b": Entry(b"")}}, "a is both a file and a folder"),
        ({"complete": ["/"]}, "'/' is not a path inside the workspace"),
        ({"entries": {}}, "is missing"),
        ({"code": {}}, "has no facts, or has them without being code"),
        ({"code": {NODE_PATH: CodeRow(b"x", b"")}}, "is damaged"),
        ({"code": {NODE_PATH: CodeRow(b"", b"\x90")}}, "are damaged, or of another version"),
        ({"code": {NODE_PATH: CodeRow(b"", b"\x91" * 5000)}}, "are damaged, or of another version"),
    ],
)
def test_an_odd_shard_is_refused(facts: Path, say: Say, change: dict[str, dict[str, object]], error: str) -> None:
    shard = shard_in(facts)
    rows = {}
    for name, value in change.items():
        before = getattr(shard, name)
        rows[name] = {**before, **value} if isinstance(value, dict) and value else value
    replace_shard(facts, packed(msgspec.structs.replace(shard, **rows)))
    assert error in refused(say, facts)


@pytest.mark.parametrize("data", [b"", b"\0", b"x\x9c", packed(Shard([], {}, {}, [], [], []))[:-1]])
def test_a_shard_that_is_cut_off_is_refused(facts: Path, say: Say, data: bytes) -> None:
    replace_shard(facts, data)
    refused(say, facts)


def test_links_that_lead_to_each_other_end(facts: Path, say: Say) -> None:
    shard = shard_in(facts)
    loop = {"src/driver/a": Entry(link="src/driver/b"), "src/driver/b": Entry(link="src/driver/a")}
    replace_shard(facts, packed(msgspec.structs.replace(shard, entries={**shard.entries, **loop})))
    say()
    assert say("check", "--isolated", "--facts", str(facts))[0] == 1
