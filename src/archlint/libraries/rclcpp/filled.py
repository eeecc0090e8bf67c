"""What fills the containers of C++'s standard library, and what is taken out of its texts and optional values."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.interpreter.attributes import get_attribute
from archlint.interpreter.call_site import CallSite
from archlint.interpreter.containers import new_list
from archlint.interpreter.items import set_item
from archlint.interpreter.values import (
    NONE,
    DictValue,
    ForeignValue,
    Known,
    ListValue,
    OneOf,
    Unknown,
    Value,
    alternatives,
    one_of,
    via,
)
from archlint.syntax.cpp.known_names import ITEM, NUMBER, PUT, SETTLED, SUBSTRING, TYPE_OF, VALUE_OR

if TYPE_CHECKING:
    from archlint.libraries.api_use import Plain
    from archlint.libraries.run import Run


def _put(run: Run, site: CallSite) -> Value:
    """``put(container, method, …)``: ``names.insert(name)``, ``rows.emplace(key, value)``, and methods that are called
    alike of anything else."""
    container, method, *values = site.args
    for option in alternatives(container):
        match option:
            case DictValue():
                _put_pair(run, option, values)
            case ListValue():
                _put_item(run, option, method.text or "", values)
            case _ if option.is_text or not isinstance(container, OneOf):
                return run.call(get_attribute(run, container, method.text or ""), replace(site, args=values))
    return Unknown("what a container gives back")


def _put_pair(run: Run, container: DictValue, values: list[Value]) -> None:
    """``insert({key, value})`` and ``emplace(key, value)``; of anything else it is not known what it puts in."""
    items = values[0].items(run) if len(values) == 1 else None
    pair = list(items.values) if items is not None and not items.open else values
    unknown = Unknown("what is put into a map")
    key, value = pair if len(pair) == 2 else (unknown, unknown)
    set_item(run, container, key, value)


def _put_item(run: Run, container: ListValue, method: str, values: list[Value]) -> None:
    """``insert(item)``, ``insert(position, item)``; several arguments of ``emplace_back`` make one item."""
    if method == "assign":
        run.call(get_attribute(run, container, "clear"), CallSite([]))
        method, values = "insert", [container, *values]
    if method == "insert" and len(values) > 1:
        values = values[1:]
        if len(values) > 1 or isinstance(values[0], ListValue):  # another container, or a part of it
            more = values[0] if len(values) == 1 else Unknown("a part of a container")
            run.call(get_attribute(run, container, "extend"), CallSite([more]))
            return
    item = values[0] if len(values) == 1 else new_list(run, values, "tuple")
    run.call(get_attribute(run, container, "append"), CallSite([item]))


def _item(run: Run, site: CallSite) -> Value:
    """``item(object, attribute, …)``: what ``rows_.push_back({"left", 1})`` puts into a field."""
    owner, attribute, *values = site.args
    cls = run.store.get(owner.heap_key, attribute.text) if owner.heap_key and attribute.text else None
    return new_list(run, values) if cls is None else run.call(cls, replace(site, args=values))


def _value_or(run: Run, site: CallSite) -> Value:
    """``optional.value_or(other)``."""
    value, other = site.args
    return one_of(other if option.is_none else option for option in alternatives(value))


def _number(run: Run, site: CallSite) -> Value:
    """What a parameter of a type of numbers is declared with: ``declare_parameter<double>("rate", rate)``."""
    value, kind = site.args
    convert = float if kind.text == "DOUBLE" else int
    rows: list[Value] = []
    for option in alternatives(value):
        match option:
            case Known(value=bool() | int() | float() as number):
                rows.append(Known(convert(number), option.via))
            case Unknown():
                rows.append(replace(option, of_class=convert.__name__))
            case _:
                rows.append(option)
    return one_of(rows)


def _settled(run: Run, site: CallSite) -> Value:
    """A text after a loop that changes it."""
    value = site.args[0]
    return next((option for option in alternatives(value) if isinstance(option, Unknown)), value)


def _substring(run: Run, site: CallSite) -> Value:
    """``text.substr(start, count)``."""
    text, *bounds = site.args
    numbers = [bound.whole_number for bound in bounds]
    if text.text is None or None in numbers:
        return Unknown("a part of a text")
    start, *count = (number for number in numbers if number is not None)
    if not 0 <= start <= len(text.text):
        return Unknown("a part of a text that it does not have")
    whole = len(text.text) if not count or count[0] < 0 else start + count[0]
    return Known(text.text[start:whole], via(text, *bounds))


def _type_of(run: Run, site: CallSite) -> Value:
    """``decltype(message)``."""
    value = site.args[0] if site.args else NONE
    cls = run.library.class_of(value) if isinstance(value, ForeignValue) else value.own_class
    return cls or Unknown("the type of a value")


PLAIN: dict[str, Plain] = {
    ITEM: _item,
    NUMBER: _number,
    PUT: _put,
    SETTLED: _settled,
    SUBSTRING: _substring,
    TYPE_OF: _type_of,
    VALUE_OR: _value_or,
}

__all__ = ["PLAIN"]
