"""Containers of C++'s standard library, as far as they are not those of Python."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.interpreter.attributes import get_attribute
from archlint.interpreter.containers import new_list
from archlint.interpreter.declared import Defaults, declare
from archlint.interpreter.values import (
    ClassValue,
    DictValue,
    External,
    FunctionValue,
    Instance,
    Known,
    ListValue,
    Member,
    Unknown,
    Value,
    alternatives,
    one_of,
)
from archlint.libraries.python.copies import copied
from archlint.syntax.cpp.known_names import COPY, DECLARED, FIELDS, ITSELF, PARTS

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.libraries.api_use import Plain
    from archlint.libraries.run import Run


def _pairs(run: Run, site: CallSite) -> Value:
    """What a loop over a container goes through: keys with their values, where it is a map."""
    container = site.args[0] if site.args else Unknown("no container")
    if isinstance(container, ListValue):
        items = container.items(run)
        rows = [_row(run, item) for item in items.values]
        return new_list(run, rows, open_=items.open) if rows != list(items.values) else container
    if not isinstance(container, DictValue):
        return container
    entries = container.entries(run)
    return new_list(run, [new_list(run, pair, "tuple") for pair in entries.entries.values()], open_=entries.open)


def _parts(run: Run, site: CallSite) -> Value:
    """What ``auto [name, depth]`` takes of a value."""
    return _row(run, site.args[0]) if site.args else Unknown("no value")


def _row(run: Run, item: Value) -> Value:
    """The fields of a structure, as ``auto [name, depth]`` takes them; anything else as it is."""
    init = item.own_class.lookup(run, "__init__")[0] if item.own_class is not None else None
    if not isinstance(init, FunctionValue) or not init.ir.params[1:]:
        return item
    return new_list(run, [get_attribute(run, item, param.name) for param in init.ir.params[1:]], "tuple")


def _template_argument(run: Run, site: CallSite) -> Value:
    """What a template argument of a class is: ``template_argument(object, attribute, given, default)``."""
    if len(site.args) != 4:
        return Unknown("a template argument")
    owner, attribute, explicit, default = site.args
    if not explicit.is_none:
        return explicit
    kept = run.store.get(owner.heap_key, attribute.text) if owner.heap_key and attribute.text else None
    return kept or default


def _field(run: Run, site: CallSite) -> Value:
    """A member, before the constructor of its class makes it; an enum, or what is not known, has no value yet."""
    cls = site.args[0] if site.args else None
    if cls is None or not (isinstance(cls, External) or _is_class(run, cls)):
        return Unknown("a variable without a value")
    return Member(cls, tuple(site.keywords.items()))


def _given(run: Run, site: CallSite) -> Value:
    """``given(object, field, value, first)``: what a field holds after ``Limits{1, 2}``, or ``Limits{others}``."""
    owner, field, value, first = site.args
    if first.own_class is not None and first.own_class == owner.own_class and field.text:
        return get_attribute(run, first, field.text)
    if value.is_none and field.text:
        return get_attribute(run, owner, field.text)
    return value


def _object(run: Run, site: CallSite) -> Value:
    """A variable that is an object of a class of another file, made without arguments."""
    cls = site.args[0] if site.args else None
    if cls is None or not _is_class(run, cls):
        return Unknown("a variable without a value")
    return run.call(cls, replace(site, args=[]))


def _is_class(run: Run, cls: Value) -> bool:
    """Whether something is a class of ours, other than an enum."""
    return isinstance(cls, ClassValue) and cls.lookup(run, FIELDS)[0] is not None


def _member(run: Run, site: CallSite) -> Value:
    """``member(object, name, …)``: what the list of a constructor makes of a member with these arguments."""
    owner, name, *given = site.args
    before = run.store.get(owner.heap_key, name.text) if owner.heap_key and name.text else None
    arguments = replace(site, args=given)
    is_given_itself = given == [owner]
    if isinstance(before, Member):
        is_copy = len(given) == 1 and given[0].own_class is not None and given[0].own_class == before.cls
        return given[0] if is_copy else run.call(before.cls, replace(arguments, keywords=dict(before.keywords)))
    if len(given) == 1 and not is_given_itself:
        return given[0]
    made_later = isinstance(before, Instance) and isinstance(before.cls, External)
    maker = get_attribute(run, before, "__made_with__") if before is not None and made_later else None
    return run.call(maker or Unknown("the class of a member is elsewhere"), arguments)


def _declared(run: Run, site: CallSite) -> Value:
    """``declared(name, accepted, default, …)``: a function or variable that is defined elsewhere."""
    name, accepted, *defaults = site.args
    count = accepted.value if isinstance(accepted, Known) and isinstance(accepted.value, int) else len(defaults)
    row = Defaults(count, tuple(value.as_default() for value in defaults))
    return declare(run.index, run.store, run.activation.scope, name.text or "", row)


def _copy(run: Run, site: CallSite) -> Value:
    """A copy of an object, which is changed for itself: a profile, a container, or an object of a plain class."""
    return one_of(_copy_of(run, value) for value in alternatives(site.args[0]))


def _copy_of(run: Run, value: Value) -> Value:
    match value:
        case ListValue() | DictValue() | Instance(cls=External(path="rclpy.qos.QoSProfile")):
            return copied(run, value)
        case Instance(cls=ClassValue() as cls) if not cls.external_bases():
            return copied(run, value)
    return value


def _itself(run: Run, site: CallSite) -> Value:
    """``itself(object, class)``: whose method ``Class::method()`` is, called in one of an object: a static one has its
    class alone."""
    owner, cls = site.args
    is_derived = owner.own_class is not None and isinstance(cls, ClassValue) and cls in owner.own_class.mro
    return owner if is_derived or not isinstance(cls, ClassValue) else cls


PLAIN: dict[str, Plain] = {
    COPY: _copy,
    DECLARED: _declared,
    ITSELF: _itself,
    PARTS: _parts,
    "std.pairs": _pairs,
    "std.template_argument": _template_argument,
    "std.__field__": _field,
    "std.__given__": _given,
    "std.__object__": _object,
    "std.__member__": _member,
}

__all__ = ["PLAIN"]
