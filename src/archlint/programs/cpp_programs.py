"""What starts nodes of C++: the executables that CMake builds, and components by the names of their classes."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from archlint.interpreter.activation import Activation
from archlint.interpreter.values import ClassValue, FunctionValue
from archlint.programs.entry import EntryPoint
from archlint.syntax import facts
from archlint.syntax.walk import main_guard

if TYPE_CHECKING:
    from archlint.interpreter.modules import Module
    from archlint.libraries.run import Run
    from archlint.workspace.installed import Executable, Installs
    from archlint.workspace.model import SourceFile

REGISTERS = "RCLCPP_COMPONENTS_REGISTER_NODE"


def cpp_entry_points(
    installs: Mapping[str, Installs],
    files: Sequence[SourceFile],
    facts_of: Callable[[SourceFile], facts.Facts | None],
    relevant: Callable[[SourceFile], bool],
) -> list[EntryPoint]:
    """Every executable and component of the workspace whose source is C++, as the linker wants it.

    A component goes by the name of its class (``demo::Talker``), by which launch files and containers load it.
    """
    sources = {file.relative: file for file in files if file.kind == "cpp" and relevant(file)}
    components = _certain(list(_components(sources.values(), facts_of)), facts_of)
    entries = [
        EntryPoint(plugin, package, "", _class_of(plugin), file) for (package, plugin), file in components.items()
    ]
    for package in sorted(installs):
        for executable in installs[package].executables.values():
            file = components.get((package, executable.plugin))
            if file is not None:
                entries.append(EntryPoint(executable.name, package, "", _class_of(executable.plugin), file))
                continue
            main = _main_of(executable, sources, facts_of)
            if main is not None:
                others = tuple(
                    sources[path] for path in executable.sources if path in sources and sources[path] != main
                )
                entries.append(EntryPoint(executable.name, package, "", None, main, others))
    return entries


def _main_of(
    executable: Executable,
    sources: Mapping[str, SourceFile],
    facts_of: Callable[[SourceFile], facts.Facts | None],
) -> SourceFile | None:
    """The source of an executable that has ``main``."""
    for path in executable.sources:
        code = facts_of(sources[path]) if path in sources else None
        if code is not None and main_guard(code) is not None:
            return sources[path]
    return None


def _components(
    files: Iterable[SourceFile], facts_of: Callable[[SourceFile], facts.Facts | None]
) -> Iterator[tuple[tuple[str | None, str], SourceFile]]:
    """The classes that are registered as components, by package and name, with the files that register them."""
    for file in sorted(files, key=lambda file: file.relative):
        code = facts_of(file)
        for statement in [] if code is None else code.body:
            match statement:
                case facts.Expression(facts.Call(facts.Name(name), [facts.Argument(facts.Literal(str(plugin)))])):
                    if name == REGISTERS:
                        yield (file.package, plugin), file


def _certain(
    registered: Sequence[tuple[tuple[str | None, str], SourceFile]],
    facts_of: Callable[[SourceFile], facts.Facts | None],
) -> dict[tuple[str | None, str], SourceFile]:
    """The components of which it is known what they start: not those that two files register, nor those whose file has
    two classes, or registers two, that are called alike but for their namespaces."""
    files: dict[tuple[str | None, str], set[str]] = {}
    names: dict[tuple[str, str], set[str]] = {}
    for (package, plugin), file in registered:
        files.setdefault((package, plugin), set()).add(file.relative)
        names.setdefault((file.relative, _class_of(plugin)), set()).add(plugin)
    return {
        key: file
        for key, file in registered
        if len(files[key]) == 1
        and len(names[file.relative, _class_of(key[1])]) == 1
        and _classes_called(_class_of(key[1]), facts_of(file)) < 2
    }


def _classes_called(name: str, code: facts.Facts | None) -> int:
    """How many classes of a file have a name, whatever their namespaces."""
    return sum(isinstance(row, facts.Class) and row.name == name for row in ([] if code is None else code.body))


def _class_of(plugin: str) -> str:
    return plugin.rpartition("::")[2]


def use_own_methods(run: Run, *own: Module) -> None:
    """Let a program of C++ have the methods that the files define which it is built of, the one with ``main`` among
    them.

    A header may declare one class for several programs, each of which defines the methods itself; which file was read
    last says nothing then.
    """
    if len(own) == 1 and own[0].file.kind != "cpp":
        return
    for module in own:
        if module.scope is not None:
            run.activations[-1] = Activation(module.name, module, module.scope, module.facts.body, run.store.depth)
            run.execute([statement for statement in module.facts.body if _is_of_another(run, own, statement)])


def _is_of_another(run: Run, own: Sequence[Module], statement: facts.Stmt) -> bool:
    """Whether a statement sets a method on a class that now has the one of a file besides a program's ``own``."""
    match statement:
        case facts.Assign([facts.Attribute(facts.Name() as owner, method)], facts.Name(defined)) if "::" in defined:
            cls = run.evaluate(owner)
            known = run.store.get(cls.key, method) if isinstance(cls, ClassValue) else None
            return isinstance(known, FunctionValue) and known.scope.module not in own
    return False


__all__ = ["REGISTERS", "cpp_entry_points", "use_own_methods"]
