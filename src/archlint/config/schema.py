"""What a configuration may hold, as types: a file is converted into a :class:`ConfigurationFile` in one step.

What the values mean is said in ``values.py``, ``architecture_tables.py`` and ``rule_options.py``.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, cast

import msgspec

from archlint.architecture import ContractKind
from archlint.config.preset_names import PresetName
from archlint.finding import Severity
from archlint.ros.distros import DISTROS
from archlint.ros.parameter_types import ParameterType

if TYPE_CHECKING:
    Distro = str
    Level = str
else:
    Distro = Literal[DISTROS]
    Level = Literal[tuple(severity.label for severity in Severity)]

Texts = tuple[str, ...]
OneOrMore = str | tuple[str, ...]
Number = int | float

_Amount = Annotated[int, msgspec.Meta(ge=0)] | Annotated[float, msgspec.Meta(ge=0)]
_Amounts = _Amount | Annotated[tuple[_Amount, ...], msgspec.Meta(min_length=1)]
Messages = Annotated[_Amounts, msgspec.Meta(description="a number of messages, or a list of numbers")]
Seconds = Annotated[_Amounts, msgspec.Meta(description="a number of seconds, or a list of numbers")]

WORDS: dict[object, str] = {
    str: "a string",
    bool: "true or false",
    Number: "a number",
    Texts: "a list of strings",
    OneOrMore: "a string or a list of strings",
}
"""What a value has to be, for people; an ``Annotated`` type brings its own words."""


class Table(
    msgspec.Struct,
    frozen=True,
    forbid_unknown_fields=True,
    rename=lambda name: name.rstrip("_").replace("_", "-"),
):
    """A table of a configuration.  TOML has no null: what is None is not in the file."""

    UNKNOWN: ClassVar[str] = "unknown key"
    """The words for a key that it does not have."""
    MISSING: ClassVar[str] = "this table has no"
    """The words for a key that it must have."""

    def given(self) -> dict[str, Any]:
        """What is in the file, by the keys as they are written, in the order of the fields."""
        keys = zip(self.__struct_encode_fields__, self.__struct_fields__, strict=True)
        return {key: value for key, field in keys if (value := getattr(self, field)) is not None}


class ContractTable(Table, frozen=True):
    """An entry of ``[[contracts]]``."""

    UNKNOWN: ClassVar[str] = "unknown key of a contract"
    MISSING: ClassVar[str] = "this contract has no"

    name: str
    kind: ContractKind
    from_: OneOrMore | None = None
    to: OneOrMore | None = None
    publisher: OneOrMore | None = None
    subscriber: OneOrMore | None = None
    server: OneOrMore | None = None
    client: OneOrMore | None = None
    through: OneOrMore | None = None
    nodes: OneOrMore | None = None
    topic: OneOrMore | None = None
    service: OneOrMore | None = None
    action: OneOrMore | None = None
    types: OneOrMore | None = None
    history: OneOrMore | None = None
    reliability: OneOrMore | None = None
    durability: OneOrMore | None = None
    liveliness: OneOrMore | None = None
    depth: Messages | None = None
    deadline: Seconds | None = None
    lifespan: Seconds | None = None
    liveliness_lease: Seconds | None = None


class ExternalNodeTable(Table, frozen=True):
    """An entry of ``[[external-nodes]]``."""

    UNKNOWN: ClassVar[str] = "unknown key of an external node"
    MISSING: ClassVar[str] = "this external node has no"

    package: str
    executable: OneOrMore
    name: str | None = None
    complete: bool | None = None
    publishers: dict[str, str] | None = None
    subscribers: dict[str, str] | None = None
    services: dict[str, str] | None = None
    clients: dict[str, str] | None = None
    action_servers: dict[str, str] | None = None
    action_clients: dict[str, str] | None = None
    parameters: dict[str, ParameterType] | None = None


_ExternalNodes = Annotated[
    tuple[ExternalNodeTable, ...], msgspec.Meta(description="a list of tables, each headed by [[external-nodes]]")
]
_Contracts = Annotated[
    tuple[ContractTable, ...], msgspec.Meta(description="a list of tables, each headed by [[contracts]]")
]


class ConfigurationFile(Table, frozen=True):
    """All that one file may say."""

    baseline: str | None = None
    cache_dir: str | None = None
    closed_world: bool | None = None
    contracts: _Contracts | None = None
    distro: Distro | None = None
    exclude: Texts | None = None
    extend: str | None = None
    extend_select: Texts | None = None
    external: Texts | None = None
    external_nodes: _ExternalNodes | None = None
    ignore: Texts | None = None
    launch: Texts | None = None
    layers: dict[str, OneOrMore] | None = None
    owners: dict[str, OneOrMore] | None = None
    per_file_ignores: dict[str, Texts] | None = None
    per_package_ignores: dict[str, Texts] | None = None
    plugins: Texts | None = None
    preset: PresetName | None = None
    rules: dict[str, dict[str, Any]] | None = None
    """The options of each rule, which :func:`options_of` has the type of."""
    select: Texts | None = None
    severity: dict[str, Level] | None = None
    shared_topics: Texts | None = None
    unused_files: bool | None = None


_OPTIONS: dict[type, Any] = {bool: bool, str: str, tuple: Texts, int: Number, float: Number}
"""What an option may be, by the type of its default."""


def options_of(title: str, defaults: Mapping[str, object]) -> type[Table]:
    """The table of the options of a rule, each of the type that its default has."""
    fields = [(key.replace("-", "_"), _OPTIONS[type(value)] | None, None) for key, value in defaults.items()]
    words = {"UNKNOWN": f"{title} has no option"}
    options = msgspec.defstruct("Options", fields, bases=(Table,), frozen=True, namespace=words)
    return cast("type[Table]", options)
