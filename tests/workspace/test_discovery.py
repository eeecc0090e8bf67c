"""Which files are found, which are left out, and as what they are found."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from archlint.workspace.discovery import PathNotFound
from archlint.workspace.model import Problem
from workspace.trees import file_in, found, look, manifest, plant

SHEBANG = "#!/usr/bin/env python3\nimport rclpy\n"

# --- kinds of files


def test_files_are_known_by_their_names(tmp_path):
    plant(
        tmp_path,
        {
            "pkg/package.xml": manifest("pkg"),
            "pkg/setup.py": "",
            "pkg/setup.cfg": "",
            "pkg/pyproject.toml": "",
            "pkg/CMakeLists.txt": "",
            "pkg/pkg/node.py": "",
            "pkg/launch/robot.launch.py": "",
            "pkg/bringup_launch.py": "",
            "pkg/launch/helper.py": "",
            "pkg/launch/robot.launch.xml": "",
            "pkg/launch/old.launch": "",
            "pkg/launch/plain.xml": "",
            "pkg/launch/robot.launch.yaml": "",
            "pkg/config/robot.yaml": "",
            "pkg/msg/Speed.msg": "",
            "pkg/srv/Stop.srv": "",
            "pkg/action/Dock.action": "",
        },
    )
    kinds = {file.relative: file.kind for file in look(tmp_path, "pkg").files}
    assert kinds == {
        "pkg/CMakeLists.txt": "cmake",
        "pkg/action/Dock.action": "interface",
        "pkg/bringup_launch.py": "launch_python",
        "pkg/config/robot.yaml": "parameters",
        "pkg/launch/helper.py": "launch_python",
        "pkg/launch/old.launch": "launch_xml",
        "pkg/launch/plain.xml": "launch_xml",
        "pkg/launch/robot.launch.py": "launch_python",
        "pkg/launch/robot.launch.xml": "launch_xml",
        "pkg/launch/robot.launch.yaml": "launch_yaml",
        "pkg/msg/Speed.msg": "interface",
        "pkg/package.xml": "package_xml",
        "pkg/pkg/node.py": "python",
        "pkg/pyproject.toml": "pyproject",
        "pkg/setup.cfg": "setup_cfg",
        "pkg/setup.py": "setup_py",
        "pkg/srv/Stop.srv": "interface",
    }


def test_what_nobody_reads_is_not_found(tmp_path):
    plant(
        tmp_path,
        {
            "README.md": "",
            "robot.urdf": "",
            "mail/letter.msg": "a letter, not an interface",
            "world/robot.xml": "<robot/>",
            ".hidden.py": "",
            ".github/workflows/ci.yaml": "",
        },
    )
    assert found(tmp_path) == []


def test_modules_of_a_python_package_called_launch_are_no_launch_files(tmp_path):
    plant(tmp_path, {"launch/__init__.py": "", "launch/actions.py": ""})
    assert file_in(look(tmp_path), "launch/actions.py").kind == "python"


def test_a_script_is_known_by_its_shebang(tmp_path):
    plant(
        tmp_path,
        {
            "scripts/talker": SHEBANG,
            "scripts/setup": "#!/bin/bash\necho python3\n",
            "scripts/notes": "python\n",
            "tools/listener": SHEBANG,
            "tools/not_executable": SHEBANG,
            "tools/old": "#!/usr/bin/python2.7\n",
            "LICENSE": "",
        },
    )
    for name in ("listener", "old"):
        (tmp_path / "tools" / name).chmod(0o755)
    workspace = look(tmp_path)
    assert [file.relative for file in workspace.files] == ["scripts/talker", "tools/listener", "tools/old"]
    assert {file.kind for file in workspace.files} == {"python"}


def test_status_of_a_file_comes_along(tmp_path):
    plant(tmp_path, {"node.py": "x = 1\n"})
    file = file_in(look(tmp_path), "node.py")
    status = (tmp_path / "node.py").stat()
    assert (file.path, file.size, file.inode) == (str(tmp_path / "node.py"), 6, status.st_ino)
    assert (file.mtime_ns, file.ctime_ns) == (status.st_mtime_ns, status.st_ctime_ns)


def test_setting_the_clock_of_a_file_back_does_not_hide_a_change(tmp_path):
    plant(tmp_path, {"node.py": "x = 1\n"})
    before = file_in(look(tmp_path), "node.py").stamp
    status = (tmp_path / "node.py").stat()
    while (tmp_path / "node.py").stat().st_ctime_ns == status.st_ctime_ns:
        (tmp_path / "node.py").write_text("x = 2\n")
        os.utime(tmp_path / "node.py", ns=(status.st_atime_ns, status.st_mtime_ns))
    after = file_in(look(tmp_path), "node.py")
    assert (after.mtime_ns, after.size, after.inode) == (status.st_mtime_ns, status.st_size, status.st_ino)
    assert after.stamp != before


# --- folders that are left out


@pytest.mark.parametrize("folder", [".git", ".venv", "venv", "__pycache__", "node_modules", ".tox", "pkg.egg-info"])
def test_folders_of_other_tools_are_left_out(tmp_path, folder):
    plant(tmp_path, {f"{folder}/x.py": "", "a.py": ""})
    assert found(tmp_path) == ["a.py"]


def test_a_virtual_environment_is_known_by_what_is_in_it(tmp_path):
    plant(tmp_path, {"env/pyvenv.cfg": "", "env/lib/x.py": "", "a.py": ""})
    assert found(tmp_path) == ["a.py"]


@pytest.mark.parametrize("marker", ["COLCON_IGNORE", "AMENT_IGNORE"])
def test_a_marked_folder_is_left_out_unless_asked_for(tmp_path, marker):
    plant(tmp_path, {f"old/{marker}": "", "old/deep/x.py": "", "a.py": ""})
    assert found(tmp_path) == ["a.py"]
    assert found(tmp_path, "old") == ["old/deep/x.py"]
    assert found(tmp_path, "old/deep/x.py") == ["old/deep/x.py"]


@pytest.mark.parametrize("folder", ["build", "install", "log"])
def test_what_colcon_built_is_left_out(tmp_path, folder):
    plant(tmp_path, {f"ws/{folder}/pkg/lib/node.py": "", "ws/src/pkg/node.py": ""})
    assert found(tmp_path) == ["ws/src/pkg/node.py"]


@pytest.mark.parametrize(
    "trace", ["COLCON_IGNORE", ".built_by", ".colcon_install_layout", "local_setup.bash", "latest_build/x"]
)
def test_what_colcon_built_elsewhere_is_known_by_its_traces(tmp_path, trace):
    plant(tmp_path, {f"build/{trace}": "", "build/pkg/node.py": "", "pkg/node.py": ""})
    assert found(tmp_path) == ["pkg/node.py"]


@pytest.mark.parametrize("trace", [".catkin", "setup.bash"])
def test_what_catkin_built_is_left_out(tmp_path, trace):
    plant(tmp_path, {f"devel/{trace}": "", "devel/lib/pkg/node.py": "", "src/devel/node.py": ""})
    assert found(tmp_path) == ["src/devel/node.py"]


def test_copies_that_setuptools_makes_are_left_out(tmp_path):
    plant(tmp_path, {"pkg/setup.py": "", "pkg/build/lib/pkg/node.py": "", "pkg/pkg/node.py": ""})
    assert found(tmp_path) == ["pkg/pkg/node.py", "pkg/setup.py"]


@pytest.mark.parametrize("name", ["build", "install", "log"])
def test_sources_in_folders_of_such_names_are_kept(tmp_path, name):
    plant(
        tmp_path,
        {
            f"src/{name}/package.xml": manifest(name),
            f"src/{name}/{name}/__init__.py": "",
            f"src/{name}/{name}/node.py": "",
            "src/robot/package.xml": manifest("robot", "ament_cmake"),
            "src/robot/src/main.cpp": "",
            f"src/robot/{name}/node.py": "",
            "src/src/package.xml": manifest("src"),
        },
    )
    python = [path for path in found(tmp_path) if path.endswith(".py")]
    assert python == [f"src/{name}/{name}/__init__.py", f"src/{name}/{name}/node.py", f"src/robot/{name}/node.py"]


# --- what the user leaves out


def test_excluded_files_and_folders_are_left_out_unless_asked_for(tmp_path):
    plant(tmp_path, {"pkg/node.py": "", "pkg/node_test.py": "", "third_party/x.py": "", "pkg/third_party/y.py": ""})
    exclude = ("third_party/", "*_test.py")
    assert found(tmp_path, exclude=exclude) == ["pkg/node.py"]
    assert found(tmp_path, "pkg/node_test.py", exclude=exclude) == ["pkg/node_test.py"]
    assert found(tmp_path, "third_party", exclude=exclude) == ["third_party/x.py"]


def test_an_exclusion_with_a_slash_is_for_one_path(tmp_path):
    plant(tmp_path, {"a/test/x.py": "", "b/test/x.py": ""})
    assert found(tmp_path, exclude=("a/test",)) == ["b/test/x.py"]
    assert found(tmp_path, exclude=("./b/test/*",)) == ["a/test/x.py"]


def test_an_exclusion_from_a_folder_above_is_for_what_is_here_too(tmp_path):
    plant(tmp_path, {"pkg/gen/x.py": "", "pkg/sub/gen/x.py": "", "pkg/x.py": ""})
    here = tmp_path / "pkg"
    assert found(here) == ["gen/x.py", "sub/gen/x.py", "x.py"]
    assert found(here, exclude=("../pkg/gen/*",)) == ["sub/gen/x.py", "x.py"]
    assert found(here, exclude=("../pkg/x.py",)) == ["gen/x.py", "sub/gen/x.py"]
    assert found(here / "sub", exclude=("../../pkg/sub/gen",)) == []
    assert found(here / "sub", "..", exclude=("../../pkg/gen",)) == ["../sub/gen/x.py", "../x.py"]


# --- paths


def test_paths_are_shown_from_the_working_directory(tmp_path):
    plant(tmp_path, {"ws/a.py": "", "here/b.py": ""})
    assert found(tmp_path / "here", ".", "../ws") == ["../ws/a.py", "b.py"]
    assert found(tmp_path / "here", str(tmp_path / "ws")) == ["../ws/a.py"]
    assert found(tmp_path / "ws", "./a.py") == ["a.py"]


def test_overlapping_paths_give_each_file_once_in_one_order(tmp_path):
    plant(tmp_path, {"pkg/a.py": "", "pkg/sub/b.py": "", "z.py": ""})
    expected = ["pkg/a.py", "pkg/sub/b.py", "z.py"]
    assert found(tmp_path, ".", "pkg", "pkg/sub/b.py") == expected
    assert found(tmp_path, "pkg/sub", "z.py", "pkg/a.py", ".") == expected


def test_two_looks_at_the_same_tree_are_equal(tmp_path):
    plant(tmp_path, {f"pkg_{n}/node_{n}.py": "" for n in range(20)})
    assert look(tmp_path) == look(tmp_path)


@pytest.mark.parametrize("path", ["nowhere", "a.py/below", "", "nul\0byte"])
def test_a_path_that_does_not_exist_is_told_as_it_was_typed(tmp_path, path):
    plant(tmp_path, {"a.py": ""})
    with pytest.raises(PathNotFound) as raised:
        look(tmp_path, "a.py", path)
    assert raised.value.path == path


def test_an_empty_folder_holds_nothing(tmp_path):
    workspace = look(tmp_path)
    assert (workspace.files, workspace.packages, workspace.problems) == ((), (), ())


def test_a_file_asked_for_is_known_by_what_is_in_it(tmp_path):
    plant(tmp_path, {"robot.xml": "<launch/>", "talker": SHEBANG, "notes": "", "notes.txt": ""})
    assert found(tmp_path, "robot.xml", "talker", "notes", "notes.txt") == ["robot.xml", "talker"]


def test_names_that_are_not_utf8_are_found(tmp_path):
    os.close(os.open(os.fsencode(tmp_path) + b"/caf\xe9.py", os.O_CREAT | os.O_WRONLY))
    assert found(tmp_path) == ["caf\udce9.py"]


# --- what lies around a path


@pytest.fixture
def package(tmp_path: Path) -> Path:
    return plant(
        tmp_path,
        {
            "src/pkg/package.xml": manifest("pkg"),
            "src/pkg/pkg/__init__.py": "",
            "src/pkg/pkg/base.py": "",
            "src/pkg/pkg/node.py": "",
            "src/other/package.xml": manifest("other"),
            "src/other/other/x.py": "",
        },
    )


def test_the_rest_of_the_package_and_of_the_workspace_comes_as_context(package):
    workspace = look(package, "src/pkg/pkg/node.py")
    assert {file.relative: file.context for file in workspace.files} == {
        "src/other/other/x.py": True,
        "src/other/package.xml": True,
        "src/pkg/package.xml": True,
        "src/pkg/pkg/__init__.py": True,
        "src/pkg/pkg/base.py": True,
        "src/pkg/pkg/node.py": False,
    }
    assert file_in(workspace, "src/pkg/pkg/node.py").module == "pkg.node"


def test_a_folder_in_a_package_is_checked_the_rest_is_context(package):
    assert found(package, "src/pkg/pkg") == [
        "src/pkg/pkg/__init__.py",
        "src/pkg/pkg/base.py",
        "src/pkg/pkg/node.py",
    ]
    assert file_in(look(package, "src/pkg/pkg"), "src/pkg/package.xml").context


def test_beside_a_package_the_rest_of_the_workspace_is_context(package):
    context = [file.relative for file in look(package, "src/pkg").files if file.context]
    assert context == ["src/other/other/x.py", "src/other/package.xml"]


def test_a_whole_workspace_needs_no_context(package):
    for path in ("src", "."):
        assert not any(file.context for file in look(package, path).files)


def test_a_repository_is_a_workspace_too(tmp_path):
    plant(
        tmp_path,
        {
            "robot/.git/": "",
            "robot/drive/package.xml": manifest("drive"),
            "robot/drive/drive/a.py": "",
            "robot/sense/package.xml": manifest("sense"),
            "robot/sense/sense/b.py": "",
            "elsewhere/c.py": "",
        },
    )
    names = [file.relative for file in look(tmp_path, "robot/drive").files]
    assert "robot/sense/sense/b.py" in names
    assert "elsewhere/c.py" not in names


def test_repositories_cloned_into_one_workspace_are_known_together(tmp_path):
    plant(
        tmp_path,
        {
            "ws/build/x/.built_by": "colcon",
            "ws/src/one/.git/": "",
            "ws/src/one/drive/package.xml": manifest("drive"),
            "ws/src/one/drive/drive/a.py": "",
            "ws/src/two/.git/": "",
            "ws/src/two/sense/package.xml": manifest("sense"),
            "ws/src/two/sense/sense/b.py": "",
        },
    )
    for path in ("ws/src/one", "ws/src/one/drive"):
        names = [file.relative for file in look(tmp_path, path).files]
        assert "ws/src/two/sense/sense/b.py" in names


def test_repositories_in_a_folder_called_src_are_strangers_where_nothing_was_built(tmp_path):
    plant(
        tmp_path,
        {
            "src/one/.git/": "",
            "src/one/package.xml": manifest("one"),
            "src/one/one/a.py": "",
            "src/two/.git/": "",
            "src/two/package.xml": manifest("two"),
            "src/two/two/b.py": "",
        },
    )
    assert not any("two" in file.relative for file in look(tmp_path, "src/one").files)


def test_workspaces_side_by_side_are_told_apart_by_packages_of_one_name(tmp_path):
    """As in a course, where each week has a workspace of its own."""
    weeks = {
        f"course/{week}/{package}/{file}": text
        for week in ("week1", "week2")
        for package in ("robot", "helpers")
        for file, text in {"package.xml": manifest(package), f"{package}/a.py": ""}.items()
    }
    plant(tmp_path, {"course/.git/": "", **weeks})
    context = {file.relative for file in look(tmp_path, "course/week1/robot").files if file.context}
    assert context == {"course/week1/helpers/helpers/a.py", "course/week1/helpers/package.xml"}


def test_the_src_of_a_package_is_no_workspace(tmp_path):
    plant(
        tmp_path,
        {
            "ws/src/pkg/package.xml": manifest("pkg", "ament_cmake"),
            "ws/src/pkg/src/pkg/node.py": "",
            "ws/src/other/package.xml": manifest("other"),
            "ws/src/other/other/x.py": "",
        },
    )
    names = [file.relative for file in look(tmp_path, "ws/src/pkg/src/pkg").files]
    assert "ws/src/other/other/x.py" in names


def test_a_home_folder_is_never_a_workspace(tmp_path, monkeypatch):
    plant(tmp_path, {".git/": "", "pkg/package.xml": manifest("pkg"), "pkg/pkg/a.py": "", "other/b.py": ""})
    monkeypatch.setenv("HOME", str(tmp_path))
    assert not any("other" in file.relative for file in look(tmp_path, "pkg").files)


def test_what_is_wrong_beside_what_was_asked_for_is_not_told(package):
    (package / "src/other/broken.py").symlink_to("nowhere")
    assert not look(package, "src/pkg").problems


def test_the_search_for_the_package_around_ends_with_the_repository(tmp_path):
    plant(tmp_path, {"package.xml": manifest("outer"), "outer.py": "", "clone/.git/": "", "clone/a/x.py": ""})
    assert [file.relative for file in look(tmp_path, "clone/a").files] == ["clone/a/x.py"]


# --- the root


def test_the_root_is_the_repository_or_the_workspace(tmp_path):
    plant(
        tmp_path,
        {
            "repo/.git/": "",
            "repo/pkg/package.xml": manifest("pkg"),
            "repo/pkg/pkg/a.py": "",
            "ws/install/setup.bash": "",
            "ws/src/pkg/package.xml": manifest("pkg"),
            "ws/src/pkg/pkg/a.py": "",
            "loose/pkg/package.xml": manifest("pkg"),
            "loose/pkg/pkg/a.py": "",
            "single/a.py": "",
        },
    )
    roots = {
        "repo/pkg/pkg/a.py": "repo",
        "ws/src/pkg": "ws",
        "ws": "ws",
        "loose/pkg/pkg/a.py": "loose/pkg",
        "loose": "loose",
        "single/a.py": "single",
    }
    assert {path: look(tmp_path, path).root for path in roots} == {
        path: str(tmp_path / root) for path, root in roots.items()
    }
    assert look(tmp_path, "single/a.py", "loose").root == str(tmp_path)


def test_the_root_holds_what_is_read_as_context(tmp_path):
    names = ("talker", "bringup")
    plant(
        tmp_path, {f"ws/src/{name}/package.xml": manifest(name) for name in names} | {"ws/src/bringup/a.launch.xml": ""}
    )
    for path in ("ws/src/talker", "ws/src/talker/package.xml"):
        workspace = look(tmp_path, path)
        assert "ws/src/bringup/a.launch.xml" in [file.relative for file in workspace.files]
        assert workspace.root == str(tmp_path / "ws/src")


# --- links and other obstacles


def test_links_that_run_in_circles_are_survived(tmp_path):
    plant(tmp_path, {"pkg/a.py": ""})
    (tmp_path / "pkg" / "loop").symlink_to(".")
    (tmp_path / "pkg" / "up").symlink_to("..")
    (tmp_path / "pkg" / "root").symlink_to("/")
    (tmp_path / "pkg" / "self").symlink_to("self")
    (tmp_path / "one").mkdir()
    (tmp_path / "two").mkdir()
    (tmp_path / "one" / "other").symlink_to("../two")
    (tmp_path / "two" / "other").symlink_to("../one")
    assert found(tmp_path) == ["pkg/a.py"]


def test_a_linked_package_is_followed(tmp_path):
    plant(tmp_path, {"dev/pkg/package.xml": manifest("pkg"), "dev/pkg/pkg/node.py": "", "ws/src/": ""})
    (tmp_path / "ws/src/pkg").symlink_to("../../dev/pkg")
    workspace = look(tmp_path, "ws")
    assert [file.relative for file in workspace.files] == ["ws/src/pkg/package.xml", "ws/src/pkg/pkg/node.py"]
    assert file_in(workspace, "ws/src/pkg/pkg/node.py").module == "pkg.node"


def test_a_file_goes_by_its_own_path_not_by_a_link_to_it(tmp_path):
    plant(tmp_path, {"z/server.py": "", "z/pkg/x.py": ""})
    (tmp_path / "a.py").symlink_to("z/server.py")
    (tmp_path / "z/server").symlink_to("server.py")
    (tmp_path / "linked").symlink_to("z/pkg")
    assert found(tmp_path) == ["z/pkg/x.py", "z/server.py"]


def test_of_several_links_to_a_file_outside_the_first_counts(tmp_path):
    plant(tmp_path, {"shared/common.py": "", "ws/b/": "", "ws/a/": ""})
    for folder in ("b", "a"):
        (tmp_path / "ws" / folder / "common.py").symlink_to("../../shared/common.py")
    assert found(tmp_path, "ws") == ["ws/a/common.py"]


def test_a_link_out_of_the_repository_is_followed_to_packages_and_to_python_only(tmp_path):
    plant(
        tmp_path,
        {
            "secret": "password: 1",
            "dev/pkg/package.xml": manifest("pkg"),
            "dev/pkg/msg/Pose.msg": "",
            "dev/notes/rooms.yaml": "",
            "ws/msg/Plan.msg": "",
            "ws/config/": "",
        },
    )
    (tmp_path / "ws/msg/A.msg").symlink_to("../../secret")
    (tmp_path / "ws/config/a.yaml").symlink_to("../../secret")
    (tmp_path / "ws/config/plan.yaml").symlink_to("../msg/Plan.msg")
    (tmp_path / "ws/pkg").symlink_to("../dev/pkg")
    (tmp_path / "ws/notes").symlink_to("../dev/notes")
    workspace = look(tmp_path, "ws")
    assert [file.relative for file in workspace.files] == [
        "ws/msg/Plan.msg",
        "ws/pkg/msg/Pose.msg",
        "ws/pkg/package.xml",
    ]
    assert [(problem.file, problem.message) for problem in workspace.problems] == [
        (name, "is a symbolic link that leads out of the repository, so it is not read")
        for name in ("ws/config/a.yaml", "ws/msg/A.msg")
    ]
    asked = look(tmp_path, "ws", "dev")
    added = {file.relative for file in asked.files} - {file.relative for file in workspace.files}
    assert added == {"ws/notes/rooms.yaml"}


def test_hard_links_are_files_of_their_own(tmp_path):
    plant(tmp_path, {"a/__init__.py": "", "b/": ""})
    os.link(tmp_path / "a/__init__.py", tmp_path / "b/__init__.py")
    assert found(tmp_path) == ["a/__init__.py", "b/__init__.py"]


def test_a_link_to_nothing_is_told(tmp_path):
    plant(tmp_path, {"a.py": ""})
    (tmp_path / "gone.py").symlink_to("nowhere.py")
    (tmp_path / "circle.py").symlink_to("circle.py")
    (tmp_path / "gone.txt").symlink_to("nowhere.txt")
    (tmp_path / "home.py").symlink_to(tmp_path / "home/a/robot/home.py")
    workspace = look(tmp_path)
    assert workspace.problems == (
        Problem("circle.py", 1, 1, "is a symbolic link that leads back to itself"),
        Problem("gone.py", 1, 1, "is a broken symbolic link"),
        Problem("home.py", 1, 1, f"is a broken symbolic link: there is no '{tmp_path / 'home'}' here", leads_out=True),
    )


def test_a_link_into_an_empty_folder_waits_for_what_is_to_be_in_it(tmp_path):
    plant(tmp_path, {"filled/b.py": ""})
    (tmp_path / "submodule").mkdir()
    for folder in ("submodule", "filled"):
        (tmp_path / f"{folder}_setup.py").symlink_to(f"{folder}/setup.py")
    assert look(tmp_path).problems == (Problem("filled_setup.py", 1, 1, "is a broken symbolic link"),)


def test_a_link_to_nothing_among_sources_of_c_is_told_in_packages(tmp_path):
    plant(tmp_path, {"firmware/a.cpp": "", "robot/package.xml": "<package><name>robot</name></package>"})
    for folder in ("firmware", "robot"):
        (tmp_path / folder / "gone.hpp").symlink_to("nowhere.hpp")
    assert [problem.file for problem in look(tmp_path).problems if "link" in problem.message] == ["robot/gone.hpp"]


def test_a_pipe_is_told_and_not_waited_for(tmp_path):
    os.mkfifo(tmp_path / "pipe.py")
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "pipe").chmod(0o755)
    for paths in ((), ("pipe.py", "pipe")):
        workspace = look(tmp_path, *paths)
        assert workspace.files == ()
        assert workspace.problems == (Problem("pipe.py", 1, 1, "is not a regular file"),)


@pytest.mark.skipif(os.geteuid() == 0, reason="root may list every folder")
def test_a_folder_that_cannot_be_listed_is_told(tmp_path):
    plant(tmp_path, {"closed/a.py": "", "b.py": ""})
    (tmp_path / "closed").chmod(0)
    try:
        workspace = look(tmp_path)
    finally:
        (tmp_path / "closed").chmod(0o755)
    assert [file.relative for file in workspace.files] == ["b.py"]
    assert workspace.problems == (Problem("closed", 1, 1, "cannot be listed: Permission denied"),)
