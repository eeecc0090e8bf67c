"""Dataclasses that are quick to make: the classes, and the objects of a frozen one.

``dataclasses.dataclass`` writes and compiles up to eight methods of a class when its module is imported, which takes
longer than all else that an import does; most classes are never used in a run.  Here a class gets its methods when they
are first asked for, and those that compare, hash and show its objects are not compiled at all.

The ``__init__`` of a frozen dataclass goes through ``object.__setattr__`` for each field, which takes several times as
long as an assignment.  Type checkers see ``dataclasses.dataclass`` here, so that they refuse to write a field; at run
time nothing does.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dataclasses import dataclass as dataclass
else:
    import dataclasses
    import operator
    from collections.abc import Callable
    from dataclasses import fields
    from reprlib import recursive_repr
    from threading import RLock

    def dataclass(
        cls: type | None = None,
        /,
        *,
        frozen: bool = False,
        slots: bool = False,
        eq: bool = True,
        order: bool = False,
        kw_only: bool = False,
        repr: bool = True,
    ) -> type | Callable[[type], type]:
        """A dataclass, which ``dataclasses.fields``, ``replace`` and ``asdict`` take for one of theirs; a frozen one is
        equal and hashed by its fields, where the class itself does not say how."""

        def decorate(cls: type) -> type:
            own = {name for name, value in vars(cls).items() if name != "__hash__" or value is not None}
            if cls.__doc__ is None:
                cls.__doc__ = cls.__name__  # or `dataclasses` writes the signature there, which takes long
            if slots:  # makes another class, which has to be there at once
                cls = dataclasses.dataclass(repr=False, eq=False, slots=True, kw_only=kw_only)(cls)
            else:
                _complete_later(cls, own, kw_only)
            if eq:
                _add_comparisons(cls, own, frozen, order)
            if repr and "__repr__" not in own:
                cls.__repr__ = _repr
            return cls

        return decorate if cls is None else decorate(cls)

    _incomplete: dict[type, bool] = {}
    """The classes without their ``__init__`` and their fields, and whether they take keywords only."""
    _completing = RLock()

    class _Later:
        """Stands for what ``dataclasses`` puts into a class until somebody asks for it."""

        def __init__(self, name: str, cls: type) -> None:
            self.name = name
            self.cls = cls

        def __get__(self, instance: object, owner: type) -> object:
            _complete(self.cls)
            return getattr(owner if instance is None else instance, self.name)

    _LATER = ("__init__", "__dataclass_fields__", "__match_args__")

    def _complete_later(cls: type, own: set[str], kw_only: bool) -> None:
        _incomplete[cls] = kw_only
        for name in _LATER:
            if name not in own:
                setattr(cls, name, _Later(name, cls))

    def _complete(cls: type) -> None:
        with _completing:
            if cls in _incomplete:
                for name in _LATER:
                    if isinstance(vars(cls).get(name), _Later):
                        delattr(cls, name)
                dataclasses.dataclass(repr=False, eq=False, kw_only=_incomplete.pop(cls))(cls)

    def _add_comparisons(cls: type, own: set[str], frozen: bool, order: bool) -> None:
        if "__eq__" not in own:
            _make_later(cls, "__eq__", lambda: _comparison(_compared(cls), operator.eq))
        if "__hash__" not in own and frozen:
            _make_later(cls, "__hash__", lambda: _hash(_hashed(cls)))
        elif "__hash__" not in own:
            cls.__hash__ = None
        for name in ("lt", "le", "gt", "ge") if order else ():
            _make_later(cls, f"__{name}__", lambda name=name: _comparison(_compared(cls), getattr(operator, name)))

    def _make_later(cls: type, name: str, make: Callable[[], Callable[..., object]]) -> None:
        """Give a class a method that is made, and put in its own place, when it is first called."""

        def first(self: object, *others: object) -> object:
            method = make()
            setattr(cls, name, method)
            return method(self, *others)

        setattr(cls, name, first)

    def _comparison(
        values: Callable[[object], tuple[object, ...]], compare: Callable[..., bool]
    ) -> Callable[[object, object], bool]:
        def compared(self: object, other: object) -> bool:
            if other.__class__ is not self.__class__:
                return NotImplemented
            return compare(values(self), values(other))

        return compared

    def _hash(values: Callable[[object], tuple[object, ...]]) -> Callable[[object], int]:
        return lambda self: hash(values(self))

    def _compared(cls: type) -> Callable[[object], tuple[object, ...]]:
        return _values([field.name for field in fields(cls) if field.compare])

    def _hashed(cls: type) -> Callable[[object], tuple[object, ...]]:
        rows = (field for field in fields(cls) if (field.compare if field.hash is None else field.hash))
        return _values([field.name for field in rows])

    def _values(names: list[str]) -> Callable[[object], tuple[object, ...]]:
        """What gets the values of fields, in a tuple."""
        if len(names) > 1:
            return operator.attrgetter(*names)
        return lambda instance: tuple(getattr(instance, name) for name in names)

    @recursive_repr()
    def _repr(self: object) -> str:
        values = (f"{field.name}={getattr(self, field.name)!r}" for field in fields(self) if field.repr)
        return f"{type(self).__qualname__}({', '.join(values)})"


__all__ = ["dataclass"]
