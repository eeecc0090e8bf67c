"""Whole runs over small workspaces on disk."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

import archlint
from archlint.checks.registry import Check, Options, finding, rule
from archlint.checks.scope import Scope
from archlint.config.settings import load
from archlint.engine.own_code import own_code
from archlint.engine.pipeline import NothingToDo, Request, check, graph
from archlint.finding import Place, Severity
from archlint.report.model import Report
from registering import only

NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_publisher(String, 'chatter', 10)


def main():
    rclpy.init()
    rclpy.spin(Talker())


if __name__ == '__main__':
    main()
"""
PACKAGE = "<package format='3'><name>{name}</name><version>0.0.0</version></package>\n"


@pytest.fixture
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


@rule("OWN001", scope=Scope.SYSTEM)
def every_publisher(system, options: Options):
    for node in system.nodes:
        for endpoint in node.of_kind("publisher"):
            yield finding("OWN001", endpoint.place, f"publishes {endpoint.name}", node=node.name)


Add = Callable[[Check], None]


@pytest.fixture(autouse=True)
def add(monkeypatch: pytest.MonkeyPatch) -> Add:
    """Instead of the real rules one that finds every publisher, so that findings are easy to place; a test may add
    another to it."""
    only(monkeypatch, every_publisher)
    return lambda another: only(monkeypatch, every_publisher, another)


def write(path: str, text: str | bytes = NODE) -> Path:
    file = Path(path)
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(text.encode() if isinstance(text, str) else text)
    return file


def run(*paths: str, cached: bool = False, jobs: int | None = None) -> Report:
    return check(Request(paths or (".",), load(Path()), cached, jobs))


def places(report: Report) -> list[tuple[str, str, int]]:
    return [(one.code, one.place.file, one.place.line) for one in report.findings]


pytestmark = pytest.mark.usefixtures("workspace")


# --- what is found


def test_a_workspace_is_read_linked_and_judged():
    write("src/pkg/package.xml", PACKAGE.format(name="pkg"))
    write("src/pkg/pkg/talker.py")
    report = run()
    assert places(report) == [("OWN001", "src/pkg/pkg/talker.py", 9)]
    assert report.findings[0].message == "publishes /chatter"
    assert report.source_line("src/pkg/pkg/talker.py", 6) == "class Talker(Node):"
    summary = report.summary
    assert (summary.files, summary.nodes, summary.warnings, summary.errors) == (1, 1, 1, 0)
    assert summary.elapsed_s > 0


def test_the_order_is_by_file_line_and_column():
    for name in ("b.py", "a.py", "sub/c.py", "B.py"):
        write(name)
    assert [file for _, file, _ in places(run())] == ["B.py", "a.py", "b.py", "sub/c.py"]


def test_without_any_input_there_is_nothing_to_do():
    with pytest.raises(NothingToDo, match="no Python or C"):
        run()
    write("README.md", "# nothing\n")
    with pytest.raises(NothingToDo):
        run()


def test_paths_are_those_a_user_would_type(workspace: Path, monkeypatch: pytest.MonkeyPatch):
    write("src/a.py")
    write("elsewhere/empty")
    monkeypatch.chdir("elsewhere")
    assert places(run("../src")) == [("OWN001", "../src/a.py", 9)]
    assert places(run(str(workspace / "src" / "a.py"))) == [("OWN001", "../src/a.py", 9)]


def test_only_what_was_asked_for_is_reported_but_the_package_around_it_is_read():
    write("pkg/package.xml", PACKAGE.format(name="pkg"))
    write("pkg/pkg/base.py", NODE.replace("Talker", "Base"))
    write("pkg/pkg/talker.py", "from pkg.base import Base\n\n\nclass Talker(Base):\n    pass\n")
    assert places(run("pkg/pkg/talker.py")) == []
    assert places(run("pkg/pkg/base.py")) == [("OWN001", "pkg/pkg/base.py", 9)]


# --- bad input


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"import rclpy\ndef f(:\n", "syntax error"),
        (b"import rclpy\nprint 'hello'\n", "Python 2"),
        (b"import rclpy\nif True:\n\tx = 1\n        y = 2\n", ""),
        (b"import rclpy\n\x00\n", "NUL"),
        (b"import rclpy\nx = '\xff'\n", "0xff"),
        (b"import rclpy\nx = " + b"(" * 300 + b")" * 300 + b"\n", "nested"),
        (b"import rclpy\nf(a=1, a=2)\n", "repeated"),
    ],
    ids=["syntax", "Python 2", "tabs", "NUL", "undecodable", "nesting", "does not compile"],
)
def test_a_file_that_cannot_be_read_is_a_finding_and_the_rest_is_checked(content: bytes, message: str):
    write("bad.py", content)
    write("good.py")
    report = run()
    assert [code for code, _, _ in places(report)] == ["LNT002", "OWN001"]
    assert report.findings[0].place.file == "bad.py"
    assert message in report.findings[0].message


@pytest.mark.parametrize("imports", ["import motor", "from motor import start", "def f():\n    import motor\n\n\nf()"])
def test_a_broken_module_that_is_imported_is_a_finding_though_it_does_not_look_like_ros(imports: str):
    write("motor.py", "def start()\n    return 1\n")
    write("template.py", "class {{name}}:\n    pass\n")  # nobody imports it
    write("driver.py", f"{imports}\n{NODE}")
    assert [place for place in places(run()) if place[0] == "LNT002"] == [("LNT002", "motor.py", 1)]


def test_a_broken_file_is_a_finding_where_it_is_named():
    write("template.py", "class {{name}}:\n    pass\n")
    write("good.py")
    assert [code for code, _, _ in places(run())] == ["OWN001"]
    assert places(run("./template.py", "good.py"))[1:] == [("LNT002", "template.py", 1)]
    assert places(run("template.py")) == [("LNT002", "template.py", 1)]


@pytest.mark.parametrize(
    ("broken", "files", "told"),
    [
        ("view_old.py", {}, False),
        ("old/view.py", {}, False),
        ("old_view.py", {"view.py": NODE}, False),
        ("old_view.py", {}, True),  # nothing has replaced it
        ("view.py", {"view_old.py": NODE}, True),
        ("view_old.py", {"main.py": f"import view_old\n{NODE}"}, True),
        ("old/view.py", {"main.py": f"from old.view import View\n{NODE}"}, True),
        ("old/__init__.py", {"main.py": f"from old import view\n{NODE}", "old/view.py": ""}, True),
    ],
)
def test_a_broken_file_that_is_put_aside(broken: str, files: dict[str, str], told: bool):
    write(broken, "import rclpy\ndef start()\n")
    for path, text in {"good.py": NODE, **files}.items():
        write(path, text)
    assert [place[1] for place in places(run()) if place[0] == "LNT002"] == [broken] * told
    assert ("LNT002", broken, 2) in places(run(broken))


@pytest.mark.parametrize("line", ["from pkg import motor", "from pkg.motor import Motor", "from .motor import Motor"])
def test_a_broken_module_beside_a_file_is_told_where_that_file_imports_it(workspace: Path, line: str):
    write("pkg/package.xml", PACKAGE.format(name="pkg"))
    write("pkg/pkg/__init__.py", "")
    write("pkg/pkg/motor.py", "class Motor(\n")
    write("pkg/pkg/other.py", NODE)
    write("pkg/pkg/node.py", NODE.replace("import rclpy\n", f"import rclpy\n{line}\n", 1))
    [found] = [one for one in run("pkg/pkg/node.py").findings if one.code == "LNT002"]
    assert found.place.file == "pkg/pkg/motor.py"
    assert [(one.place.file, one.place.line) for one in found.related] == [("pkg/pkg/node.py", 2)]
    assert not any(one.code == "LNT002" for one in run("pkg/pkg/other.py").findings)


def test_a_workspace_of_packages_without_python_is_judged(add: Add):
    @add
    @rule("PKG003", scope=Scope.WORKSPACE)
    def each_package(system, options):
        for name in system.workspace.packages:
            yield finding("PKG003", Place(f"{name}/package.xml", 1, 1, 1, 1), name)

    write("arm/package.xml", PACKAGE.format(name="arm"))
    write("arm/src/arm.cpp", "int main() {}\n")
    write("arm_msgs/package.xml", PACKAGE.format(name="arm_msgs"))
    report = run()
    assert [one.message for one in report.findings] == ["arm", "arm_msgs"]
    assert report.summary.files == 1


def test_a_malformed_manifest_is_a_finding():
    write("pkg/package.xml", "<package><name>pkg</nam")
    write("pkg/talker.py")
    assert [code for code, _, _ in places(run())] == ["LNT002", "OWN001"]


def test_ten_thousand_lines_are_no_trouble():
    write("long.py", NODE + "x = 1\n" * 10_000)
    assert places(run()) == [("OWN001", "long.py", 9)]


def test_unreadable_files_count_whatever_is_selected_unless_they_are_ignored():
    write("bad.py", "import rclpy\ndef f(:\n")
    write("archlint.toml", "select = ['SRV']")
    assert [code for code, _, _ in places(run())] == ["LNT002"]
    write("archlint.toml", "select = ['SRV']\nignore = ['LNT002']")
    assert places(run()) == []


BROKEN_SRV = "int33 first\n---\nbool ok\nstring \n"
MESSAGES = "cmake_minimum_required(VERSION 3.8)\nproject(msgs)\nfind_package(rosidl_default_generators REQUIRED)\n"


@pytest.mark.parametrize(
    ("listed", "built"),
    [
        ('rosidl_generate_interfaces(msgs "srv/Bad.srv")\n', True),
        ('rosidl_generate_interfaces(msgs "srv/Good.srv")\n', False),
        ("file(GLOB all srv/*.srv)\nrosidl_generate_interfaces(msgs ${all})\n", True),
        ("include(messages.cmake)\n", True),
        ("", False),
    ],
)
def test_a_broken_interface_is_one_finding_if_anything_builds_it(listed: str, built: bool):
    cmake = "<export><build_type>ament_cmake</build_type></export></package>"
    write("msgs/package.xml", PACKAGE.format(name="msgs").replace("</package>", cmake))
    write("msgs/CMakeLists.txt", MESSAGES + listed + "ament_package()\n")
    write("msgs/srv/Bad.srv", BROKEN_SRV)
    write("msgs/srv/Good.srv", "---\nbool ok\n")
    found = run().findings
    assert [(one.code, one.place.line, one.severity) for one in found] == [("LNT002", 1, Severity.WARNING)] * built
    assert [[one.place.line for one in finding.related] for finding in found] == [[4]] * built


def test_a_python_package_builds_no_interface():
    python = "<export><build_type>ament_python</build_type></export></package>"
    write("msgs/package.xml", PACKAGE.format(name="msgs").replace("</package>", python))
    write("msgs/setup.py", "from setuptools import setup\nsetup(name='msgs', packages=['msgs'])\n")
    write("msgs/srv/Bad.srv", BROKEN_SRV)
    assert run().findings == []


ROS_1 = '<launch><node pkg="robot" type="talker.py" name="a"/>'
ROS_2 = '<launch><node pkg="robot" exec="talker.py" name="a"/>'


@pytest.mark.parametrize(
    ("path", "text", "codes"),
    [
        ("robot/launch/up.launch", ROS_2, ["LNT002"]),
        ("robot/launch/up.launch", "<launch>", ["LNT002"]),
        ("robot/launch/up.launch", ROS_1, []),
        ("robot/launch/up.launch", '<launch><arg name="a" default="$(find robot)/a.yaml"/>', []),
        ("robot/launch/up.launch", '<launch><arg name="a" default="$(find robot)/a.yaml"/><let name="b"/>', ["LNT002"]),
        ("robot/launch/up.launch", ROS_1 + ROS_2, ["LNT002"]),
        ("robot/_archive/launch/up.launch", ROS_2, []),
        ("robot/templates/launch/up.launch", ROS_2, []),
    ],
)
def test_a_malformed_launch_file_that_nobody_means_to_launch(path: str, text: str, codes: list[str]):
    write("robot/package.xml", PACKAGE.format(name="robot"))
    write(path, text)
    assert [one.code for one in run().findings] == codes


def test_a_rule_that_raises_is_a_finding_and_the_others_run(add: Add):
    @add
    @rule("SRV002", scope=Scope.SYSTEM)
    def broken(system, options):
        yield finding("SRV002", Place("a.py", 1, 1, 1, 1), "lost when the rule fails")
        raise KeyError("gone")

    write("a.py")
    report = run()
    assert [code for code, _, _ in places(report)] == ["LNT003", "OWN001"]
    [failure] = [one for one in report.findings if one.code == "LNT003"]
    assert failure.message.startswith("the rule SRV002 service-type-mismatch failed with KeyError: 'gone' (")
    assert "please report it" in failure.help
    assert failure.severity == Severity.ERROR


# --- configuration and suppressions


def test_findings_are_suppressed_in_place():
    write("a.py", NODE.replace(", 10)", ", 10)  # archlint: ignore[OWN001]"))
    write("b.py", "# archlint: ignore-file[multiple-publishers]\n" + NODE)
    write("c.py", NODE.replace(", 10)", ", 10)  # archlint: ignore"))
    report = run()
    assert places(report) == [("OWN001", "c.py", 9)]
    assert report.summary.suppressed == 2
    assert list(report.notices) == [
        "c.py:9:55: a bare `archlint: ignore` has no effect; name the rule, as in `# archlint: ignore[SRV003]`"
    ]


@pytest.mark.parametrize(
    ("configuration", "files"),
    [
        ("ignore = ['OWN001']", []),
        ("ignore = ['multiple-publishers']", []),
        ("select = ['SRV']", []),
        ("exclude = ['two']", ["one/pkg_a/a.py", "one/pkg_b/b.py"]),
        ("exclude = ['one/**']", ["two/c.py"]),
        ("exclude = ['*/c.py']", ["one/pkg_a/a.py", "one/pkg_b/b.py"]),
        ("[per-file-ignores]\n'**/b.py' = ['OWN']", ["one/pkg_a/a.py", "two/c.py"]),
        ("[per-file-ignores]\n'one' = ['OWN001']", ["two/c.py"]),
        ("[per-file-ignores]\n'c.py' = ['SRV', 'OWN001']", ["one/pkg_a/a.py", "one/pkg_b/b.py"]),
        ("[per-file-ignores]\n'**/c.py' = ['SRV']", ["one/pkg_a/a.py", "one/pkg_b/b.py", "two/c.py"]),
        ("[per-package-ignores]\n'pkg_*' = ['ALL']", ["two/c.py"]),
        ("[per-package-ignores]\npkg_b = ['OWN']", ["one/pkg_a/a.py", "two/c.py"]),
    ],
)
def test_the_configuration_chooses(configuration: str, files: list[str]):
    for name, file in (("pkg_a", "a.py"), ("pkg_b", "b.py")):
        write(f"one/{name}/package.xml", PACKAGE.format(name=name))
        write(f"one/{name}/{file}")
    write("two/c.py", NODE.replace("super()", "self.told = None\n        super()"))  # no copy of these
    write("archlint.toml", configuration)
    assert [file for _, file, _ in places(run())] == files


@pytest.mark.parametrize(
    ("configuration", "severity"),
    [
        ("[severity]\nOWN001 = 'info'", Severity.INFO),
        ("[severity]\nmultiple-publishers = 'error'", Severity.ERROR),
        ("[severity]\nOWN001 = 'error'\nOWN = 'info'", Severity.ERROR),
        ("[severity]\nSRV = 'error'", Severity.WARNING),
    ],
)
def test_the_configuration_sets_severities(configuration: str, severity: Severity):
    write("a.py")
    write("archlint.toml", configuration)
    assert [one.severity for one in run().findings] == [severity]


def test_a_rule_is_handed_its_options(add: Add):
    handed: list[Options] = []

    @add
    @rule("SRV003", scope=Scope.CODE, rate=1.0, names=())
    def listening(system, options):
        handed.append(options)
        return iter(())

    write("a.py")
    write("archlint.toml", "distro = 'humble'\nshared-topics = ['/bus/*']\nexternal = ['/joy']")
    run()
    [options] = handed
    assert options.distros == ("humble",)
    assert options.is_shared("/bus/left") and not options.is_shared("/bus")
    assert options.is_external("/joy") and not options.is_external("/joystick")
    assert (options.number("rate"), options.texts("names")) == (1.0, ())


# --- the cache


def test_an_edited_rule_is_not_answered_from_the_cache():
    package = Path(archlint.__file__).parent
    names = {name for name, *_ in own_code()}
    assert {str(package / one) for one in ("checks/qos.py", "engine/pipeline.py", "ros/names.py")} <= names


def summary_without_time(report: Report) -> list[object]:
    return [*report.findings, *report.notices, replace(report.summary, elapsed_s=0.0)]


def tree_of_two_packages() -> None:
    for name in ("pkg_a", "pkg_b"):
        write(f"{name}/package.xml", PACKAGE.format(name=name))
        write(f"{name}/node.py", NODE + "# archlint: ignore\n")
    write("broken.py", "import rclpy\ndef f(:\n")


def age(*names: str) -> None:
    """Make files look as if they had been changed long ago, so that their times can be trusted."""
    for path in (Path(name) for name in names) if names else Path().rglob("*"):
        status = path.stat()
        os.utime(path, ns=(status.st_atime_ns, status.st_mtime_ns - 100 * 10**9))


@pytest.fixture
def no_linking(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("archlint.engine.findings.systems_of", lambda *_: pytest.fail("linked again"))


def test_the_same_is_found_with_and_without_cache_and_for_any_number_of_jobs():
    tree_of_two_packages()
    expected = summary_without_time(run())
    assert len(run().findings) == 3
    for jobs in (1, 4):
        assert summary_without_time(run(jobs=jobs)) == expected
        assert summary_without_time(run(cached=True, jobs=jobs)) == expected


def test_a_second_run_on_an_unchanged_workspace_links_nothing(request: pytest.FixtureRequest):
    tree_of_two_packages()
    age()
    first = summary_without_time(run(cached=True))
    request.getfixturevalue("no_linking")
    assert summary_without_time(run(cached=True)) == first


def test_a_file_that_was_only_touched_is_not_linked_again(request: pytest.FixtureRequest):
    tree_of_two_packages()
    first = summary_without_time(run(cached=True))
    age("pkg_a/node.py")
    request.getfixturevalue("no_linking")
    assert summary_without_time(run(cached=True)) == first


@pytest.mark.parametrize(
    "change",
    [
        lambda: write("pkg_a/node.py", NODE.replace("chatter", "changed")),
        lambda: write("pkg_a/other.py", NODE),
        lambda: Path("pkg_a/node.py").unlink(),
        lambda: write("archlint.toml", "ignore = ['OWN001']"),
        lambda: write("archlint.toml", "exclude = ['pkg_a']"),
        lambda: write("pkg_a/COLCON_IGNORE", ""),
        lambda: write("pkg_a/package.xml", PACKAGE.format(name="renamed")),
    ],
    ids=["edit", "new file", "deletion", "ignore", "exclude", "COLCON_IGNORE", "package.xml"],
)
def test_any_change_that_matters_is_seen(change):
    tree_of_two_packages()
    age()
    run(cached=True)
    change()
    assert summary_without_time(run(cached=True)) == summary_without_time(run())


def test_a_change_of_the_same_size_within_the_same_instant_is_seen():
    file = write("a.py")
    run(cached=True)
    status = file.stat()
    file.write_text(NODE.replace("chatter", "changed"))
    os.utime(file, ns=(status.st_atime_ns, status.st_mtime_ns))
    assert run(cached=True).findings[0].message == "publishes /changed"


@pytest.mark.parametrize("damage", [b"", b"\xff\x00", b"{}", b"[" * 10_000])
def test_a_damaged_cache_is_no_cache(damage: bytes):
    tree_of_two_packages()
    expected = summary_without_time(run(cached=True))
    for path in Path(".archlint_cache").rglob("*"):
        if path.is_file():
            path.write_bytes(damage)
    assert summary_without_time(run(cached=True)) == expected
    assert summary_without_time(run(cached=True)) == expected


def test_a_cache_that_cannot_be_written_is_no_error():
    write("a.py")
    write(".archlint_cache", "a file, not a folder")
    assert len(run(cached=True).findings) == 1


def test_entries_that_came_with_the_repository_are_not_believed():
    from archlint import __version__
    from archlint.syntax.cache import Store
    from archlint.syntax.files import source_digest

    file = write("a.py")
    age()
    theirs = Store(".archlint_cache", __version__, b"t" * 32)
    theirs.put(source_digest(file.read_bytes()), b"-")  # as if the file held no word that matters
    theirs.close()
    assert places(run(cached=True)) == [("OWN001", "a.py", 9)]
    assert places(run(cached=True)) == [("OWN001", "a.py", 9)]


def test_without_a_key_nothing_is_kept(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setenv("XDG_CONFIG_HOME", "/dev/null/nowhere")
    write("a.py")
    assert places(run(cached=True)) == [("OWN001", "a.py", 9)]
    assert not Path(".archlint_cache").exists()


@pytest.fixture
def launched_with_ignored_parameters(add: Add) -> Path:
    """A launch file that loads a parameter file which git ignores, and another that is not there."""
    add(rule("LCH004", scope=Scope.LAUNCH_FILE)(missing_files))
    write(".git/HEAD")
    write(".gitignore", "local.yaml")
    write("p/package.xml", PACKAGE.format(name="p"))
    write("p/CMakeLists.txt", "install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})")
    write("p/launch/a.launch.xml", LAUNCH)
    file = write("p/config/local.yaml", "/**:\n  ros__parameters:\n    rate: 1\n")
    age()
    return file


LAUNCH = """\
<launch>
  <node pkg="p" exec="e" name="n"><param from="$(find-pkg-share p)/config/local.yaml"/></node>
  <node pkg="p" exec="e" name="m"><param from="$(find-pkg-share p)/config/other.yaml"/></node>
</launch>
"""


def missing_files(system, options: Options):
    for launched in system.workspace.launched:
        for one in launched.references:
            rows = system.workspace.parameters_of(one.source).sections if one.source else ()
            yield finding("LCH004", one.place, f"{one.written}: {one.status}, {rows}")


@pytest.mark.parametrize(
    "change",
    [
        lambda file: file.unlink(),
        lambda file: file.write_text(file.read_text().replace("1", "2")),
        lambda file: (file.parent / "other.yaml").write_text(file.read_text()),
    ],
    ids=["deleted", "edited", "one that was missing"],
)
def test_a_change_of_a_file_that_git_ignores_is_seen(launched_with_ignored_parameters: Path, change):
    write(".gitignore", "local.yaml\nother.yaml")
    first = summary_without_time(run(cached=True))
    assert summary_without_time(run(cached=True)) == first
    change(launched_with_ignored_parameters)
    fresh = summary_without_time(run())
    assert fresh != first
    assert summary_without_time(run(cached=True)) == fresh


def test_a_run_that_read_ignored_files_is_answered_from_the_cache(launched_with_ignored_parameters: Path, request):
    first = summary_without_time(run(cached=True))
    request.getfixturevalue("no_linking")
    assert summary_without_time(run(cached=True)) == first


def test_the_cache_lies_beside_the_configuration_and_git_does_not_see_it():
    write("src/a.py")
    write("archlint.toml", "")
    check(Request(("src",), load(Path("src")), cached=True))
    assert Path(".archlint_cache/.gitignore").read_text() == "*\n"
    assert not Path("src/.archlint_cache").exists()


# --- the graph


def test_the_graph_shows_what_was_asked_for():
    write("pkg/package.xml", PACKAGE.format(name="pkg"))
    write("pkg/pkg/one.py")
    write("pkg/pkg/two.py", NODE.replace("talker", "other"))
    request = Request(("pkg/pkg/two.py",), load(Path()), cached=False)
    assert [node.name for node in graph(request).nodes] == ["/other"]
    implicit = {endpoint.name for endpoint in graph(request, everything=True).endpoints}
    assert {"/other/get_parameters", "/rosout", "/chatter"} <= implicit


def test_of_a_large_file_the_beginning_and_the_size_are_hashed(monkeypatch: pytest.MonkeyPatch):
    from archlint.engine import result_cache

    monkeypatch.setattr(result_cache, "TEXT_LIMIT", 100)
    digests = [
        result_cache._digest(write("map.yaml", text))
        for text in ("x" * 1_000, "x" * 1_001, "y" + "x" * 999, "x" * 999 + "y", "x" * 100, "x" * 101)
    ]
    assert digests[0] == digests[3]  # nobody reads what is behind the limit
    assert len(set(digests)) == 5


def test_interfaces_of_a_package_with_one_flaw_are_one_finding(workspace: Path):
    write("robot/package.xml", PACKAGE.format(name="robot"))
    names = ("Fly", "Hold", "Land")
    for name in names:
        write(f"robot/srv/{name}.srv", "---\nbool Success\n")
    write("robot/srv/Stop.srv", "---\nbool Done\n")
    listed = " ".join(f"srv/{name}.srv" for name in (*names, "Stop"))
    write("robot/CMakeLists.txt", f"project(robot)\nrosidl_generate_interfaces(robot {listed})\n")
    told = [finding for finding in run().findings if finding.code == "LNT002"]
    assert [finding.place.file for finding in told] == ["robot/srv/Fly.srv", "robot/srv/Stop.srv"]
    assert told[0].message.endswith("; 2 more files have the same")
    assert [row.place.file for row in told[0].related] == ["robot/srv/Hold.srv", "robot/srv/Land.srv"]
