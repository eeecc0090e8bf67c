"""Code in which nobody wants to hear what could be better: it is put aside, or there to try something out.

Rules that judge the taste of code, and not whether it works, ask here.
"""

from __future__ import annotations

import posixpath
import re
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept, once
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name, main_guard
from archlint.workspace.comments import without_comments
from archlint.workspace.test_code import FileRoles

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Installs


_SHOWS = frozenset({"demo", "demos", "example", "examples", "sample", "samples", "tutorial", "tutorials"})


def is_example(file: str) -> bool:
    """Whether a file shows how something is used, by a word in its own name or in that of a folder: ``examples/``,
    ``turtle_tutorial/``, ``drive_demo.py``.  Whoever runs it reads it, and looks on."""
    parts = posixpath.splitext(file)[0].lower().replace("-", "_").split("/")
    return any(not _SHOWS.isdisjoint(part.split("_")) for part in parts)


def is_aside(workspace: WorkspaceIndex | None, file: str) -> bool:
    """Whether a file is a trial, or put aside and no launch file of what is in use starts a node of it."""
    roles = FileRoles() if workspace is None else workspace.roles
    return roles.is_trial(file) or is_disused(workspace, file)


def is_disused(workspace: WorkspaceIndex | None, file: str) -> bool:
    """Whether a file is put aside, and no launch file of what is in use starts a node of it or includes it; or whether
    it is an ``old_driver.py`` beside ``driver.py``, and nothing names it."""
    roles = FileRoles() if workspace is None else workspace.roles
    if not roles.is_put_aside(file):
        return workspace is not None and _is_retired(workspace, file)
    return workspace is None or not (file in _in_use(workspace) or file in _included(workspace))


def is_left_alone(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a file is put aside and no Python code has a word for it: nobody imports it, or misses what it says."""
    aside = workspace.roles.is_put_aside(file) or _is_retired(workspace, file)
    return aside and not (file in _in_use(workspace) or file in workspace.code.in_use or _is_mentioned(workspace, file))


def _is_retired(workspace: WorkspaceIndex, file: str) -> bool:
    successor = workspace.roles.successor_of(file)
    if successor is None or not workspace.tree.is_file(successor):
        return False
    installs = workspace.installs.get(workspace.package_of(file) or "")
    named = file in workspace.code.in_use or (installs is not None and _is_named(workspace, installs, file))
    return not named and not _is_mentioned(workspace, file)


def _is_mentioned(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether other code has a word for a module, as whoever imports it must."""
    stem = posixpath.basename(file.removesuffix("/__init__.py")).removesuffix(".py")
    return any(path != file for path in workspace.code.files_that_mention(stem))


@once
def _included(workspace: WorkspaceIndex) -> frozenset[str | None]:
    """The launch files that others include which are not put aside."""
    return frozenset(
        include.reference.source
        for launched in workspace.launched
        if not workspace.roles.is_put_aside(launched.file)
        for include in launched.included
    )


@once
def _in_use(workspace: WorkspaceIndex) -> frozenset[str]:
    """The files of the nodes that launch files start which are not put aside themselves."""
    return frozenset(
        blueprint.place.file
        for system in workspace.systems
        if system.name is not None and not workspace.roles.is_put_aside(system.name)
        for node in system.nodes
        for blueprint in node.blueprints
    )


def is_not_installed(workspace: WorkspaceIndex | None, file: str) -> bool:
    """Whether a script is in a package that installs programs, but is none of them, and none of them imports it: only
    who knows where it lies can start it.  So it is with what is put aside there, with what no file can import, for the
    name of its folder, with what such scripts import that lies in no Python package, with scripts beside the packages
    of a workspace or without any, and what these import."""
    if workspace is None or file in _in_use(workspace):
        return False
    package = workspace.package_of(file)
    if package is None:
        return file in _stray(workspace) and file not in workspace.code.in_use
    installs = None if package is None else workspace.installs.get(package)
    if installs is None or installs.open_executables or not installs.executables:
        return False
    if not file.startswith(f"{installs.folder}/") and installs.folder not in ("", "."):
        return False  # another package of that name
    if posixpath.basename(file) in installs.too_deep:
        return False  # `ros2 run` finds it
    if file in workspace.code.in_use or _is_named(workspace, installs, file):
        return False
    if workspace.roles.is_put_aside(file) or _cannot_be_imported(installs, file):
        return True
    if _is_script(workspace, file) or _starts_in_main(workspace, file):
        return True
    return _in_no_module(workspace, file) and file in _reached_by_loose(workspace)


def is_loose_module(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a module of a package is no program, and no other file has a word for it."""
    code = workspace.facts_at(file)
    if code is None or workspace.package_of(file) is None or file in workspace.code.in_use:
        return False
    return main_guard(code) is None and not _is_mentioned(workspace, file)


def import_that_fails(workspace: WorkspaceIndex | None, file: str) -> str | None:
    """The first module that a file imports as it starts and that is not there: one of a package here, or of ROS 1."""
    package = None if workspace is None else workspace.package_of(file)
    file_facts = None if workspace is None else workspace.facts_at(file)
    of_ros1 = None if file_facts is None else ros1_module(file_facts)
    if of_ros1 is not None:
        return of_ros1
    if workspace is None or package is None or file_facts is None or package not in workspace.code.top_modules:
        return None
    imports = (
        statement for statement in file_facts.body if isinstance(statement, facts.ImportFrom) and not statement.level
    )
    for statement in imports:
        top, _, rest = statement.module.partition(".")
        if top in workspace.code.top_modules and rest and rest.partition(".")[0] not in _GENERATED:
            names = [statement.module, *(f"{statement.module}.{name}" for name, _ in statement.names)]
            if all(workspace.code.imported(file, name) is None for name in names):
                return statement.module
    return None


def starts_ros(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a program, or anything here that it imports, calls something named ``init``, as ``rclpy.init()``."""
    return any(_calls_init(workspace, path) for path in sorted({file, *workspace.code.reached_from([file])}))


def _calls_init(workspace: WorkspaceIndex, file: str) -> bool:
    file_facts = workspace.facts_at(file) if workspace.code.mentions(file, "init") else None
    return file_facts is not None and any(
        called_name(call) == "init" for call in everything_in(file_facts.body, facts.Call)
    )


def ros1_module(file_facts: facts.Facts) -> str | None:
    """The first module of ROS 1 that a file imports as it starts; None where it imports none."""
    imports = (part for part in file_facts.body if isinstance(part, (facts.Import, facts.ImportFrom)))
    return next((part.module for part in imports if part.module.partition(".")[0] in _OF_ROS_1), None)


_OF_ROS_1 = frozenset({"actionlib", "dynamic_reconfigure", "roslib", "rospy"})
"""Modules that ROS 2 does not have; the file was not ported to the end."""
_GENERATED = frozenset({"msg", "srv", "action"})


def _cannot_be_imported(installs: Installs, file: str) -> bool:
    """Whether a folder of the package that holds a file has a name that no ``import`` can have: ``(unused)robot``."""
    below = file.removeprefix(f"{installs.folder}/") if installs.folder not in ("", ".") else file
    return any(not folder.isidentifier() for folder in below.split("/")[:-1])


def _in_no_module(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a file is in a folder that ``find_packages`` leaves out."""
    folder = posixpath.dirname(file)
    return not workspace.tree.is_file(posixpath.join(folder, "__init__.py"))


@once
def _reached_by_loose(workspace: WorkspaceIndex) -> frozenset[str]:
    """What the scripts import that their packages do not install."""
    asked_for = workspace.code.asked_for()
    inside = [file.relative for file, _ in asked_for if file.kind == "python" and file.package is not None]
    scripts = [path for path in inside if _is_script(workspace, path) and path not in workspace.code.in_use]
    return workspace.code.reached_from(path for path in scripts if is_not_installed(workspace, path))


@once
def _stray(workspace: WorkspaceIndex) -> frozenset[str]:
    """The scripts that lie beside the packages, and all that they import."""
    beside = [file.relative for file, _ in workspace.code.asked_for() if file.kind == "python" and file.package is None]
    scripts = (path for path in beside if not _may_be_installed(workspace, path))
    return workspace.code.reached_from(path for path in scripts if _is_script(workspace, path))


def _may_be_installed(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a package installs more than is known, and its CMake files have a word for the folder of a file that lies
    beside it: ``install(DIRECTORY ${PARENT_DIR}/scripts/ …)``."""
    folder = posixpath.basename(posixpath.dirname(file))
    return any(installs.open_executables and folder in installs.words for installs in workspace.installs.values())


def _is_script(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a file asks whether it is the program, or starts ROS or reads the command line as it is loaded: no other
    imports it then."""
    file_facts = workspace.facts_at(file)
    return file_facts is not None and (
        main_guard(file_facts) is not None
        or any(
            isinstance(statement, (facts.Expression, facts.Assign)) and _is_for_a_program(statement.value)
            for statement in file_facts.body
        )
    )


def _starts_in_main(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a file has a ``main()`` that starts ROS: an entry point would name it if it was to be a program."""
    file_facts = workspace.facts_at(file)
    functions = (part for part in ([] if file_facts is None else file_facts.body) if isinstance(part, facts.Function))
    return any(
        call.func.dotted == "rclpy.init"
        for function in functions
        if function.name == "main"
        for call in everything_in(function.body, facts.Call)
    )


def _is_for_a_program(value: facts.Expr) -> bool:
    """``rclpy.init()`` or ``parser.parse_args()``."""
    return isinstance(value, facts.Call) and (value.func.dotted == "rclpy.init" or called_name(value) == "parse_args")


def _is_named(workspace: WorkspaceIndex, installs: Installs, file: str) -> bool:
    """Whether the files that build the package mention a script, or a launch file does so as a file or a module."""
    stem = file.rpartition("/")[2].removesuffix(".py")
    same = installs.executables.get(stem)
    meant = () if same is None or same.module is None else workspace.code.files_named(same.package, same.module)
    if meant:
        return file in meant  # or that name means another file
    # One of C++, whose words are about a source of its own.
    target = same is not None and same.script is None and same.module is None
    if f"{stem}.py" in installs.words or (not target and _is_built(workspace, installs, stem)):
        return True
    # A launch file starts executables by their names, and this file is none: only as a file or a module can it run.
    return is_named_by_launch(workspace, stem)


def is_named_by_launch(workspace: WorkspaceIndex, stem: str) -> bool:
    """Whether a launch file has a word for ``stem.py``, as a file or as a module."""
    return kept(
        workspace,
        (is_named_by_launch, stem),
        lambda: any(_mentions_file(text, stem) for text in _launch_texts(workspace)),
    )


def _is_built(workspace: WorkspaceIndex, installs: Installs, stem: str) -> bool:
    """Whether the files that build a package have a word for a script.  One that is called like the package needs more
    than the name of that."""
    if stem in installs.executables or (stem in installs.words and stem != installs.package):
        return True
    built = [path for path in python_build_files(installs) if workspace.code.mentions(path, stem)]
    texts = [without_comments(workspace.tree.text(path) or "") for path in built]
    same = stem == installs.package and not any("py_modules" in text for text in texts)
    words = (f"{stem}.{stem}", f".{stem}") if same else (stem,)
    # An entry that is commented out installs nothing.
    return any(re.search(rf"(?<!\w){re.escape(word)}(?!\w)", text) for text in texts for word in words)


def python_build_files(installs: Installs) -> list[str]:
    """The files of a package, there or not, that say what of its Python code is installed."""
    return [f"{installs.folder}/{name}".removeprefix("./") for name in ("setup.py", "setup.cfg", "pyproject.toml")]


@once
def _launch_texts(workspace: WorkspaceIndex) -> list[str]:
    """The text of each launch file, without comments."""
    return [without_comments(workspace.tree.text(path) or "") for path in workspace.launch_files.all()]


def _mentions_file(text: str, stem: str) -> bool:
    """Whether ``stem.py``, or a module of that name in a package (``robot.stem``), stands anywhere in a file.  What a
    launch file imports of launch is another one: ``launch.actions``."""
    if f"{stem}.py" not in text and f".{stem}" not in text:  # as of most files: to look for a pattern takes long
        return False
    name, own = re.escape(stem), rf"\w(?<!\blaunch)(?<!\blaunch_ros)\.{re.escape(stem)}(?![\w(])"
    return re.search(rf"(?<!\w){name}\.py(?!\w)|{own}", text) is not None


__all__ = [
    "import_that_fails",
    "is_aside",
    "is_disused",
    "is_example",
    "is_left_alone",
    "is_loose_module",
    "is_named_by_launch",
    "is_not_installed",
    "python_build_files",
    "ros1_module",
    "starts_ros",
]
