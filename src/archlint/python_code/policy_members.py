"""Members that the enums of rclpy do not have: ``ReliabilityPolicy.KEEP_LAST``, ``Parameter.Type.FLOAT``.

Source: rclpy/qos.py and rclpy/parameter.py; what distributions before humble called ``RMW_QOS_POLICY_…`` is left out.
"""

from __future__ import annotations

import enum
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.libraries.api_signatures import attributes_of
from archlint.libraries.rclpy.names import canonical
from archlint.place import Place
from archlint.python_code.absent_members import AbsentMember
from archlint.python_code.annotations import imported_as
from archlint.python_code.tried_code import tried_for
from archlint.suggestions import nearest
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_POLICIES = tuple(f"rclpy.qos.{kind}Policy" for kind in ("Durability", "History", "Liveliness", "Reliability"))
_TYPE = "rclpy.parameter.Parameter.Type"
_TYPES = frozenset(
    {"BOOL", "BOOL_ARRAY", "BYTE_ARRAY", "DOUBLE", "DOUBLE_ARRAY", "INTEGER", "INTEGER_ARRAY", "NOT_SET", "STRING"}
    | {"STRING_ARRAY", "check", "from_parameter_value"}
)
_INSTEAD: Mapping[tuple[str, str], str] = {
    (_TYPE, "FLOAT"): "DOUBLE",
    (_TYPE, "FLOAT_ARRAY"): "DOUBLE_ARRAY",
    (_TYPE, "INT"): "INTEGER",
    (_TYPE, "STR"): "STRING",
    (_TYPE, "BOOLEAN"): "BOOL",
}
_OF_ALL = frozenset(dir(enum.IntEnum)).union(dir(enum.EnumMeta), dir(int), {"name", "value"})


def absent_policies(workspace: WorkspaceIndex) -> Iterator[AbsentMember]:
    """Every such use in the files that use rclpy, outside of test code; the first one of each member in a file."""
    for path in workspace.python_files(mentioning="rclpy"):
        for owner, name, span in _asked(workspace, path) or ():
            shown = owner.removeprefix("rclpy.qos.").removeprefix("rclpy.parameter.")
            yield AbsentMember(Place(path, *span), shown, name, _meant(owner, name), False)


@kept_for_each_file
def _asked(code: facts.Facts) -> list[tuple[str, str, facts.Span]]:
    """What a file asks the enums for that they do not have, each by the canonical name of the enum."""
    forgiven = tried_for(code.body, ("AttributeError",))
    rows: dict[tuple[str, str], facts.Span] = {}
    for part in everything_in(code.body, facts.Attribute):
        owner = part.value.dotted
        if not owner or part.attr.startswith(("_", "RMW_")) or Itself[facts.Base](part) in forgiven:
            continue
        if owner.rpartition(".")[2].endswith("Policy") or owner.endswith(".Type"):
            enum_ = canonical(imported_as(code, owner) or "")
            members = _members(enum_)
            if members is not None and part.attr not in members | _OF_ALL:
                rows.setdefault((enum_, part.attr), part.span)
    return [(owner, name, span) for (owner, name), span in rows.items()]


def _members(owner: str) -> frozenset[str] | None:
    if owner == _TYPE:
        return _TYPES
    return attributes_of(owner) if owner in _POLICIES else None


def _meant(owner: str, name: str) -> str:
    """The member of almost the same name, or the enum that has it."""
    if (owner, name) in _INSTEAD:
        return _INSTEAD[owner, name]
    members = sorted(each for each in _members(owner) or () if each.isupper())
    alike = [each for each in members if each.replace("_", "") == name.replace("_", "").upper()]
    other = [policy for policy in _POLICIES if owner in _POLICIES and name in (_members(policy) or ())]
    if len(other) == 1:
        return f"{other[0].rpartition('.')[2]}.{name}"
    return alike[0] if alike else nearest(name, members) or ""


__all__ = ["absent_policies"]
