"""Packages that launch files name and that are neither in the workspace nor known to rosdistro."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.analysis.cpp_nodes import CPP_SOURCES
from archlint.analysis.kept import kept, kept_for_each_file, once
from archlint.analysis.pinned import may_be_on_focal
from archlint.launch.kinds import FileStatus
from archlint.ros import packages
from archlint.suggestions import distance, nearest
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.launch.model import Launched
    from archlint.systems.model import WorkspaceIndex

_PLACEHOLDER = re.compile(r"(?:.*_)?your_.+|package_name|(?:your|ros)?_?pkg_name|PACKAGE_NAME|YOUR_.+")
"""What stands in templates and instructions for the name of a package."""
_SLIP = 2
"""By how many letters a name that nobody declares may differ from that of a package which is there."""


def is_nowhere(workspace: WorkspaceIndex, package: str) -> bool:
    """Whether no package of the workspace has a name, none of them declares it, and rosdistro does not have it."""
    if package in workspace.packages or package in packages.table().names or package in workspace.installs:
        return False
    return package not in _declared(workspace)


@once
def _declared(workspace: WorkspaceIndex) -> frozenset[str]:
    return frozenset(d.name for own in workspace.packages.values() for d in own.dependencies)


def is_from_nowhere(workspace: WorkspaceIndex, package: str) -> bool:
    """Whether a name is that of no package which anybody could have: nowhere, in no distribution that has ended, taken
    from elsewhere by no file of the workspace, and that of no folder or manifest here which was not read."""
    if not is_nowhere(workspace, package) or package in packages.table().ended or may_be_on_focal(workspace):
        return False
    if package.startswith(_OF_NVIDIA):
        return False
    return not (is_wanted_from_elsewhere(workspace, package) or package in folders_and_manifests(workspace))


_OF_NVIDIA = ("isaac_ros_", "nvblox_")
"""How the packages of Isaac ROS begin, which NVIDIA releases in a repository of its own and not in rosdistro."""
_NAME = re.compile(r"<name>\s*([^<\s]+)\s*</name>")


@once
def folders_and_manifests(workspace: WorkspaceIndex) -> frozenset[str]:
    """The names of all folders, and those that any package.xml gives a package."""
    tree = workspace.tree
    paths = tree.files_below(tree.top)
    manifests = (path for path in paths if posixpath.basename(path) == "package.xml")
    named = {match[1] for path in manifests for match in _NAME.finditer(tree.text(path) or "")}
    return frozenset(named.union(*(posixpath.dirname(path).split("/") for path in paths)))


def is_told_as_another(workspace: WorkspaceIndex, package: str) -> bool:
    """Whether it is known which package of the workspace was meant by one that is nowhere, wherever a launch file names
    it: LCH001 and LCH004 say so there."""
    if is_placeholder(package) or package != package.strip():
        return True
    for launched in workspace.launched:
        if is_told_at_a_start(workspace, launched, package):
            return True
        for reference in launched.references:
            if reference.package == package:
                path = _BELOW.sub("", reference.written or "")
                file = reference.place.file
                if package_meant(workspace, package, path, file) or package_with(workspace, package, path, file):
                    return True
    return False


def is_told_at_a_start(workspace: WorkspaceIndex, launched: Launched, package: str) -> bool:
    """The same where a launch file starts a program of it: LCH001 says so, and where its share folder is looked for."""
    for started in launched.started:
        name = started.executable.text
        if started.package.text == package and started.package.resolution == "exact" and name is not None:
            here = [own for own, installs in workspace.installs.items() if name in installs.executables]
            if nearest(package, here) or package_that_installs(workspace, package, name, started.file):
                return True
    return False


_BELOW = re.compile(r"^\$\(find-pkg-share [\w.-]+\)/?")


def is_placeholder(package: str) -> bool:
    """Whether a name stands for another one that was to be put in."""
    return _PLACEHOLDER.fullmatch(package) is not None


@kept_for_each_file
def is_untouched_template(file_facts: facts.Facts) -> bool:
    """Whether a file of Python has the name of no package where one was to be put in: nobody has run it yet."""
    texts = (literal.value for literal in everything_in(file_facts.body, facts.Literal))
    return any(isinstance(text, str) and (text in _MINE or is_placeholder(text)) for text in texts)


_MINE = frozenset({"my_package", "my_package_name"})


def package_meant(workspace: WorkspaceIndex, package: str, path: str, launch_file: str) -> str | None:
    """The package of the workspace whose name differs from one that is nowhere by a slip.  It has the file at ``path``
    below its folder, too: ``xarm_description``, which is installed, is no slip for ``arm_description``.  It is not the
    ``launch_file`` itself, which would include itself."""
    near = nearest(package, workspace.packages)
    if near is None or distance(package, near, _SLIP) > _SLIP:
        return None
    there = posixpath.normpath(posixpath.join(workspace.packages[near].relative, path))
    is_there = workspace.tree.is_file(there) or workspace.tree.is_folder(there)
    return near if is_there and there != launch_file else None


def package_with(workspace: WorkspaceIndex, package: str, path: str, launch_file: str) -> str | None:
    """The one package of the workspace that was meant by one which is nowhere: it has a file that the launch file looks
    for, by its ``path`` below the folder, and is that of the launch file, or has a word of the name."""
    path = posixpath.normpath(path)
    if posixpath.dirname(path) in ("", ".") or path.startswith(".."):
        return None
    having = [
        name
        for name, manifest in workspace.packages.items()
        if (file := posixpath.normpath(posixpath.join(manifest.relative, path))) != launch_file
        and workspace.tree.is_file(file)
    ]
    alone = _alone(workspace, package, having, launch_file)
    return alone if alone is not None and _has_all(workspace, alone, package) else None


def folder_of_description(workspace: WorkspaceIndex, folder: str, path: str, description: str) -> str | None:
    """The folder of a package that a description of a robot takes for a package itself, ``package://meshes/arm.stl``,
    behind the name of the package that has it, as it is the description's own."""
    own = workspace.packages.get(workspace.package_of(description) or "")
    if own is None or not description.endswith((".urdf", ".xacro")):
        return None
    there = posixpath.normpath(posixpath.join(own.relative, folder, path))
    return f"{own.name}/{folder}" if workspace.tree.is_file(there) else None


def _has_all(workspace: WorkspaceIndex, own: str, package: str) -> bool:
    """Whether a package has all files that launch files look for in another one: what has only some of them is no other
    name for it, as packages that are made of one template have files of one name."""
    folder = workspace.packages[own].relative
    return all(
        workspace.tree.is_file(posixpath.normpath(posixpath.join(folder, path)))
        for path in _looked_for(workspace).get(package, ())
    )


@once
def _looked_for(workspace: WorkspaceIndex) -> dict[str, set[str]]:
    """The files that launch files look for in packages which are not here, by their paths."""
    paths: dict[str, set[str]] = {}
    for launched in workspace.launched:
        for reference in launched.references:
            path = _BELOW.sub("", reference.written or "")
            if reference.status == FileStatus.EXTERNAL and posixpath.splitext(path)[1]:
                paths.setdefault(reference.package or "", set()).add(path)
    return paths


def package_that_installs(workspace: WorkspaceIndex, package: str, executable: str, launch_file: str) -> str | None:
    """The same for one that installs an executable, whose name is more than a word such as ``talker``."""
    if len(_words(executable)) < _DISTINCT:
        return None
    having = [own for own, installs in workspace.installs.items() if executable in installs.executables]
    return _alone(workspace, package, having, launch_file)


_DISTINCT = 2
_SHORT = 3
_KINDS = frozenset(
    {"bringup", "common", "config", "control", "controller", "description", "driver", "drivers", "gazebo", "hardware"}
    | {"interfaces", "launch", "moveit", "msgs", "navigation", "robot", "ros2", "sensor", "simulation"}
)
"""Words that say what a package is for: those of very different robots have them in common."""


def _alone(workspace: WorkspaceIndex, package: str, having: Sequence[str], launch_file: str) -> str | None:
    if len(having) != 1 or is_wanted_from_elsewhere(workspace, package):
        return None
    own = having[0]
    if _has_programs_of_its_own(workspace, package):
        return None
    is_like = any(len(word) > _SHORT and word not in _KINDS for word in _words(own) & _words(package))
    return own if is_like or own == workspace.package_of(launch_file) else None


def _has_programs_of_its_own(workspace: WorkspaceIndex, package: str) -> bool:
    """Whether launch files start what no package here has as a program of the absent one: it is then elsewhere."""
    named = {
        started.executable.text
        for launched in workspace.launched
        for started in launched.started
        if started.package.text == package
    }
    here = {name for installs in workspace.installs.values() for name in installs.executables}
    return any(name is not None and name not in here for name in named)


def _words(name: str) -> set[str]:
    return set(re.split(r"[_.-]", name))


_ASKING = re.compile(
    r"requirements[^/]*\.txt|pyproject\.toml|setup\.(?:py|cfg)|environment\.ya?ml|[^/]*Dockerfile[^/]*"
    r"|[^/]*\.(?:repos|rosinstall|sh)|\.gitmodules"
)
"""Where a project names the packages that it takes from elsewhere."""
_DOCUMENT = re.compile(r".*\.(?:md|rst)")
_FETCHED = r"://|\bclone\b|\bapt\b"
"""What the lines of a document have that say where a package comes from."""
_LAUNCHED = re.compile(r".*\.(?:py|launch|xml|ya?ml)")
_LINK_BESIDE = r"^[ \t]*(?:#|<!--).*://"
"""The same in a comment of a launch file."""


def is_wanted_from_elsewhere(workspace: WorkspaceIndex, package: str) -> bool:
    """Whether the workspace says that it takes a package of that name from elsewhere, or a CMake file asks for it."""
    return kept(workspace, (is_wanted_from_elsewhere, package), lambda: _is_wanted_from_elsewhere(workspace, package))


def _is_wanted_from_elsewhere(workspace: WorkspaceIndex, package: str) -> bool:
    name = re.escape(package).replace("_", "[_-]")
    word = re.compile(rf"(?<![\w-]){name}(?:[_-](?:node|ros2?))?(?![\w-])")
    if any(package in installs.words for installs in workspace.installs.values()):
        return True
    return any(word.search(text) for text in _asking_texts(workspace))


@once
def _asking_texts(workspace: WorkspaceIndex) -> tuple[str, ...]:
    texts = []
    for path in sorted(workspace.tree.files_below(workspace.tree.top)):
        name = posixpath.basename(path)
        if _ASKING.fullmatch(name):
            texts.append(workspace.tree.text(path) or "")
        elif _DOCUMENT.fullmatch(name):
            texts.extend(line for _, line in workspace.tree.lines_with(path, _FETCHED))
        elif _LAUNCHED.fullmatch(name):
            linked = workspace.tree.lines_with(path, _LINK_BESIDE)
            if linked and workspace.launch_files.can_be_launched(path):
                texts.extend(line for _, line in linked)
    return tuple(texts)


def is_in_a_document(workspace: WorkspaceIndex, name: str) -> bool:
    """Whether a document has a word for a package besides the commands that it tells to type."""
    word = rf"(?<![\w-]){re.escape(name)}(?![\w-])"
    files = (file for file in workspace.tree.files_below(workspace.tree.top) if file.endswith((".md", ".rst")))
    return any(not _TYPED.search(line) for file in files for _, line in workspace.tree.lines_with(file, word))


_TYPED = re.compile(r"\b(?:ros2|colcon|cd|source)\b")


def is_a_key_of_some_file(workspace: WorkspaceIndex, name: str) -> bool:
    """Whether a YAML file of the workspace has a name for a key: it may be one with rules of the team for rosdep."""
    rule = re.compile(rf"^['\"]?{re.escape(name)}['\"]?[ \t]*:", re.MULTILINE)
    paths = (path for path in workspace.tree.files_below(workspace.tree.top) if path.endswith((".yaml", ".yml")))
    texts = (workspace.tree.text(path) or "" for path in paths)
    return any(name in text and rule.search(text) for text in texts)


_WITH_RULES = re.compile(r"[^/]*(?:\.ya?ml|\.sh|\.bash|[Dd]ockerfile[^/]*)")
_SYSTEM = r"['\"]?(?:ubuntu|debian|fedora|rhel|arch|gentoo|osx|macports|alpine|nixos|opensuse)['\"]?[ \t]*:"


def has_a_rule_for_rosdep(workspace: WorkspaceIndex, name: str) -> bool:
    """Whether a file of the workspace says what rosdep installs for a name, or a script that writes such a file."""
    rule = re.compile(
        rf"^[ \t]*['\"]?{re.escape(name)}['\"]?[ \t]*:[ \t]*(?:\{{[ \t]*|\n[ \t]+){_SYSTEM}", re.MULTILINE
    )
    paths = workspace.tree.files_below(workspace.tree.top)
    named = (path for path in paths if _WITH_RULES.fullmatch(posixpath.basename(path)))
    texts = (workspace.tree.text(path) or "" for path in named)
    return any(name in text and rule.search(text) for text in texts)


def owners_of_component(workspace: WorkspaceIndex, plugin: str) -> list[str]:
    """The packages whose CMake files, or C++ sources, register a component under its name."""
    name = rf"(?<![\w:])(?:::)?{re.escape(plugin)}(?![\w:])"
    macro = re.compile(rf"RCLCPP_COMPONENTS_REGISTER_NODE\(\s*{name}\s*\)")
    return sorted(
        package
        for package, installs in workspace.installs.items()
        if _stands_in(workspace, installs.build_files, re.compile(name))
        or _stands_in(workspace, _sources_below(workspace, installs.folder), macro)
    )


def _sources_below(workspace: WorkspaceIndex, folder: str) -> list[str]:
    return [path for path in workspace.tree.files_below(folder) if path.endswith(CPP_SOURCES)]


def _stands_in(workspace: WorkspaceIndex, files: Sequence[str], text: re.Pattern[str]) -> bool:
    return any(text.search(workspace.tree.text(file) or "") for file in files)


__all__ = [
    "folder_of_description",
    "has_a_rule_for_rosdep",
    "is_a_key_of_some_file",
    "is_from_nowhere",
    "is_in_a_document",
    "is_nowhere",
    "is_placeholder",
    "is_told_as_another",
    "is_told_at_a_start",
    "is_wanted_from_elsewhere",
    "owners_of_component",
    "package_meant",
    "package_that_installs",
    "package_with",
]
