"""The methods that a method gets to by calls on the same object, and the attributes of it that they change and read."""

from __future__ import annotations

from collections.abc import Iterator

from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, parts_of


@dataclass(frozen=True)
class Method:
    """A method of a class, and what it calls the object: ``self``."""

    code: facts.Function
    self_name: str

    def is_own(self, part: facts.Base) -> bool:
        """Whether a part of it is an attribute of the object."""
        return isinstance(part, facts.Attribute) and part.value.variable == self.self_name


def methods_reached(function: facts.Function, file: facts.Facts) -> list[Method]:
    """A method, and those of the same class that it calls on its object, directly or through others."""
    cls = next((c for c in everything_in(file.body, facts.Class) if any(m is function for m in c.body)), None)
    if cls is None or not function.params:
        return []
    by_name = {member.name: member for member in cls.body if isinstance(member, facts.Function)}
    reached: dict[str, Method] = {}
    waiting = [function]
    while waiting:
        code = waiting.pop()
        if code.name in reached or code.decorators or not code.params:
            continue
        method = reached[code.name] = Method(code, code.params[0].name)
        for call in parts_of(code.body, facts.Call):
            if method.is_own(call.func) and call.func.attribute in by_name:
                waiting.append(by_name[call.func.attribute])
    return list(reached.values())


def statements_with_guards(body: list[facts.Stmt], guarded: bool = False) -> Iterator[tuple[facts.Stmt, bool]]:
    """Each statement of a method, and whether it runs under a lock."""
    for statement in body:
        if isinstance(statement, (facts.Function, facts.Class)):
            continue
        yield statement, guarded
        inside = guarded or (isinstance(statement, facts.With) and any(map(_is_lock, statement.items)))
        for block in statement.blocks:
            yield from statements_with_guards(block, inside)


_LOCKS = ("lock", "mutex", "cond", "condition", "semaphore", "sem", "guard")


def _is_lock(item: facts.WithItem) -> bool:
    names = [part.last_name.lower() for part in everything_in(item, facts.Base) if part.last_name]
    return any(name.strip("_").endswith(_LOCKS) or "lock" in name for name in names)


__all__ = ["Method", "methods_reached", "statements_with_guards"]
