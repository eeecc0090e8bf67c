"""From the values that TOML gives to typed ones, and from what does not fit to an error with its line.

msgspec says that something does not fit; what that is, is found by asking it about ever smaller parts.
"""

from __future__ import annotations

from collections.abc import Iterator
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, TypeVar, Union, get_args, get_origin, get_type_hints

import msgspec

from archlint.config.schema import WORDS, Table
from archlint.config.source import ConfigurationError, Key
from archlint.config.values import unknown_key
from archlint.suggestions import did_you_mean

_Kind = TypeVar("_Kind")


def converted(value: object, kind: type[_Kind], key: Key) -> _Kind:
    """What a key holds, as what it has to be.  Raises :class:`ConfigurationError`."""
    try:
        return msgspec.convert(value, kind)
    except msgspec.ValidationError:
        raise _fault(value, kind, key) from None


def _fault(value: Any, kind: Any, key: Key) -> ConfigurationError:
    """What is wrong with a value that does not fit: a key too many or too few, or its first part that does not."""
    wrong_key = _fault_of_keys(value, kind, key)
    if wrong_key is not None:
        return wrong_key
    for part, part_kind, part_key in _parts(value, kind, key):
        if not _fits(part, part_kind):
            return _fault(part, part_kind, part_key)
    if get_origin(kind) is Literal:
        words = get_args(kind)
        near = did_you_mean(str(value), words, quote="")
        return key.error(f"`{key}` must be one of {', '.join(words)}{near}")
    return key.wrong(_words(kind), value)


def _fits(value: object, kind: Any) -> bool:
    try:
        msgspec.convert(value, kind)
    except msgspec.ValidationError:
        return False
    return True


def _words(kind: Any) -> str:
    """What has to be there."""
    if get_origin(kind) is Annotated:
        return str(get_args(kind)[1].description)
    return WORDS.get(kind, "a table")


def _fault_of_keys(value: Any, kind: Any, key: Key) -> ConfigurationError | None:
    match value:
        case dict() if _is_table(kind):
            fields = {field.encode_name: field for field in msgspec.structs.fields(kind)}
            for name in value:
                if name not in fields:
                    return key.at(name).error(unknown_key(name, fields, kind.UNKNOWN))
            for name, field in fields.items():
                if field.required and name not in value:
                    return key.error(f"{kind.MISSING} `{name}`")
    return None


def _parts(value: Any, kind: Any, key: Key) -> Iterator[tuple[Any, Any, Key]]:
    """The parts of a table, or of a list of tables: each with what it has to be, and where it stands."""
    match value:
        case dict() if _is_table(kind):
            kinds = get_type_hints(kind, include_extras=True)
            for field in msgspec.structs.fields(kind):
                if field.encode_name in value:
                    yield value[field.encode_name], _present(kinds[field.name]), key.at(field.encode_name)
        case dict() if get_origin(kind) is dict:
            for name, part in value.items():
                yield part, get_args(kind)[1], key.at(name)
        case [*tables] if (kind_of_tables := _table_of(kind)) and all(type(part) is dict for part in tables):
            for number, part in enumerate(tables):
                yield part, kind_of_tables, key.under_header(number)


def _is_table(kind: Any) -> bool:
    return type(kind) is type(Table)


def _table_of(kind: Any) -> type[Table] | None:
    """The table that a list is of, if it is of tables."""
    described = get_args(kind)[0] if get_origin(kind) is Annotated else kind
    items = get_args(described)[:1]
    return items[0] if items and _is_table(items[0]) else None


def _present(kind: Any) -> Any:
    """What a field holds that is in the file: all but None."""
    if get_origin(kind) not in (Union, UnionType):
        return kind
    return Union[tuple(option for option in get_args(kind) if option is not NoneType)]
