"""``import`` and ``from … import``."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.values import Declared, External, Unknown, Value
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine, Status
    from archlint.interpreter.modules import Module


def import_module(machine: Machine, s: facts.Import) -> Status:
    importer = machine.activation.module
    module = machine.index.find(importer, s.module)
    if s.alias is not None:
        machine.assign_name(s.alias, External(s.module) if module is None else machine.import_module(module))
        return None
    if module is not None:
        machine.import_module(module)
    top = s.module.partition(".")[0]
    first = machine.index.find(importer, top)
    machine.assign_name(top, External(top) if first is None else machine.import_module(first))
    return None


def import_from(machine: Machine, s: facts.ImportFrom) -> Status:
    importer = machine.activation.module
    module = machine.index.find(importer, s.module, s.level)
    dotted = machine.index.absolute_name(importer, s.module, s.level)
    for name, bound in s.names:
        if name == "*":
            _import_star(machine, module, dotted, s.span)
            continue
        value: Value | None = None
        if machine.library.speaks_for(f"{dotted}.{name}"):
            value = machine.library.imported(f"{dotted}.{name}", s.span)
        elif module is not None and module is not importer:
            value = machine.module_attribute(module, name)
            if value is None:
                value = (
                    Unknown(f"'{name}' is defined later in an import cycle")
                    if module.state == "running"
                    else Unknown(f"{module.name} has no '{name}'")
                )
        else:
            below = machine.index.find(importer, f"{s.module}.{name}" if s.module else name, s.level)
            if below is None:
                value = machine.library.imported(f"{dotted}.{name}", s.span)
            else:
                value = machine.import_module(below)
        machine.assign_name(bound, value)
    return None


def _import_star(machine: Machine, module: Module | None, dotted: str, span: facts.Span) -> None:
    if module is None:
        of_header = machine.activation.module.file.kind == "cpp" and not dotted.endswith((".msg", ".srv", ".action"))
        if of_header:
            machine.library.header_missing(dotted, span)
        else:  # a header of elsewhere has no names that are looked for here
            machine.activation.module.star_externals.append(dotted)
        return
    machine.import_module(module)
    if module.scope is None:
        return
    if module.file.kind == "cpp":
        machine.activation.module.includes.append(module)
        module.includers.append(machine.activation.module)
    exports = module.facts.exports
    for name, value in machine.store.variables(module.scope.key):
        if isinstance(value, Declared) and machine.store.get(machine.activation.scope.key, name) is not None:
            continue  # what defines it is known, or what declares it first
        if name in exports if exports is not None else not name.startswith("_"):
            machine.assign_name(name, value)
    machine.activation.module.star_externals.extend(module.star_externals)


__all__ = ["import_from", "import_module"]
