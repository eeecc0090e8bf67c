"""Command lines that argparse divides up."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from archlint.interpreter import containers
from archlint.interpreter.call_site import CallSite
from archlint.interpreter.fields import Field, Fields
from archlint.interpreter.values import (
    NONE,
    Builtin,
    External,
    FunctionValue,
    Instance,
    Known,
    Unknown,
    Value,
    as_default,
    one_of,
)
from archlint.libraries.python.command_line import ROS_ARGUMENTS, known_words
from archlint.libraries.python.divided_words import CONST, NotDivided, Option, divide, word_of
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.libraries.api_use import ApiUse
    from archlint.libraries.run import Run


OPEN: Field[bool] = Field("more than is followed")
"""Whether a parser has arguments that are not known."""
ARGUMENTS: Fields[Value] = Fields("argument", one_of)
"""What the attributes of a parser's namespace may hold."""
OPTIONS: Fields[Option] = Fields("option")


# ------------------------------------------------------------------------------------------------ argparse


def argument_parser(run: Run, call: ApiUse) -> Value:
    instance = Instance(External("argparse.ArgumentParser"), run.store.new_key())
    if call.open or "parents" in call.keywords or "prefix_chars" in call.keywords:
        run.store.set(instance.key, OPEN, True)
    return instance


def add_argument(run: Run, receiver: Value, site: CallSite) -> Value:
    if not isinstance(receiver, Instance):
        return NONE
    names = tuple(arg.text for arg in site.args if arg.text is not None)
    name = _destination(names, site.keywords.get("dest"))
    if name is None or len(names) != len(site.args) or site.is_starred or run.branch_arms:
        run.store.set(receiver.key, OPEN, True)
    if name is not None:
        default = site.keywords.get("default") or _default_of_action(site.keywords.get("action"))
        what = Unknown(f"the command-line argument '{name}'", of_class=_class_of(site, names, default))
        value: Value = what if default is None else one_of((as_default(default), what))
        run.store.set(receiver.key, ARGUMENTS[name], value)
        run.store.set(receiver.key, OPTIONS[name], Option(names, site.keywords))
    return NONE


def _class_of(site: CallSite, names: tuple[str, ...], default: Value | None) -> str | None:
    """What ``type=`` makes of each word of an argument; None where it may be None, a list, or something else."""
    kind = site.keywords.get("type")
    may_be_missing = default is None and any(name.startswith("-") for name in names)
    if may_be_missing or default == NONE or not site.keywords.keys().isdisjoint(("nargs", "action")):
        return None
    match kind:
        case Builtin(name="int" | "float" | "str" as name, self_value=None):
            return name
    return None


def _destination(names: tuple[str, ...], given: Value | None) -> str | None:
    if isinstance(given, Known):
        return str(given.value)
    long = [name for name in names if name.startswith("--")] or list(names)
    return long[0].lstrip("-").replace("-", "_") if long else None


def _default_of_action(action: Value | None) -> Value | None:
    """``store_true`` is false unless it is given, and the other way round."""
    if action is not None and action.text in ("store_true", "store_false"):
        return Known(action.text == "store_false")
    return None


def subparsers(run: Run, receiver: Value, site: CallSite) -> Value:
    if isinstance(receiver, Instance):
        run.store.set(receiver.key, OPEN, True)
    return Unknown("subcommands are not followed")


def parse_args(run: Run, receiver: Value, site: CallSite) -> Value:
    return _parsed(run, receiver, site, False)[0]


def parse_known_args(run: Run, receiver: Value, site: CallSite) -> Value:
    return containers.new_list(run, _parsed(run, receiver, site, True), "tuple")


def _parsed(run: Run, receiver: Value, site: CallSite, some: bool) -> tuple[Value, Value]:
    """The namespace, and the words that no option takes where ``some`` may be left."""
    instance = Instance(External("argparse.Namespace"), run.store.new_key())
    rest: Value = Unknown("the rest of the command line")
    if not isinstance(receiver, Instance):
        return instance, rest
    for name, value in run.store.family(receiver.key, ARGUMENTS).items():
        run.store.set(instance.key, name, value)
    given = site.args[0] if site.args else site.keywords.get("args", NONE)
    if not some:
        _note_strict(run, receiver, site, given)
    words = known_words(run, given)
    if words is None or run.store.get(receiver.key, OPEN):
        return instance, rest
    options = run.store.family(receiver.key, OPTIONS)
    try:
        parsed, left = divide(options, words, some)
    except (NotDivided, SystemExit, ValueError, TypeError, argparse.ArgumentError):
        return instance, rest
    for name, option in options.items():
        run.store.set(instance.key, name, _value(run, option, parsed, name, words))
    return instance, containers.new_list(run, [word_of(text, words) for text in left])


def _note_strict(run: Run, receiver: Instance, site: CallSite, given: Value) -> None:
    """Note a call that gets the whole command line on each way to it, and has no place for options of ROS in it."""
    options = run.store.family(receiver.key, OPTIONS)
    if run.store.get(receiver.key, OPEN) or not all(_takes_no_rest(each) for each in options.values()):
        return
    if given != NONE and not _is_after_name(site):
        return
    is_sure = not run.branch_arms and not site.is_starred and not any(each.tries for each in run.activations)
    if is_sure and site.expression is not None and run.activations:
        place = run.place(site.expression.span)
        if place not in run.program.strict_parsers:
            run.program.strict_parsers.append(place)


def _is_after_name(site: CallSite) -> bool:
    """Whether ``sys.argv[1:]`` is what is given."""
    arguments = [] if site.expression is None else site.expression.args
    match arguments[0].value if len(arguments) == 1 else None:
        case facts.Subscript(value=words, index=facts.Slice(lower=facts.Literal(value=1), upper=None, step=None)):
            return words.dotted == "sys.argv"
    return False


def _takes_no_rest(option: Option) -> bool:
    """Whether an argument takes no option that stands behind it, whatever its name is."""
    count = option.keywords.get("nargs", NONE)
    is_plain = isinstance(count, Known) and count.value not in (argparse.REMAINDER, argparse.PARSER)
    return is_plain and not any(flag.startswith(ROS_ARGUMENTS) for flag in option.flags)


def _value(run: Run, option: Option, parsed: dict[str, Any], name: str, words: list[Value]) -> Value:
    """What an attribute of the namespace holds."""
    if name not in parsed:
        default = option.keywords.get("default") or _default_of_action(option.keywords.get("action")) or NONE
        return as_default(default if default.text is None else _converted(run, option, default))
    given = parsed[name]
    if given == CONST:
        return option.keywords.get("const", NONE)
    if isinstance(given, (bool, int)) or given is None:
        return Known(given)
    if isinstance(given, list):
        if option.keywords.get("default", NONE) != NONE and option.keywords.get("action") is not None:
            return Unknown("arguments that are added to a default")
        rows = [[item] if isinstance(item, str) else item for item in given]
        flat = [_converted(run, option, word_of(text, words)) for row in rows for text in row]
        nested = any(isinstance(item, list) for item in given)
        return Unknown("a list of lists of words") if nested else containers.new_list(run, flat)
    return _converted(run, option, word_of(given, words))


_TYPES = {"int": int, "float": float, "bool": bool, "str": str}


def _converted(run: Run, option: Option, word: Value) -> Value:
    """A word after ``type=``."""
    kind = option.keywords.get("type", NONE)
    if kind == NONE or not isinstance(word, Known) or not isinstance(word.value, str):
        return word
    if isinstance(kind, Builtin) and kind.self_value is None and kind.name in _TYPES:
        try:
            return Known(_TYPES[kind.name](word.value))
        except ValueError:
            return Unknown(f"'{word.value}' is not a valid {kind.name}")
    if isinstance(kind, FunctionValue):
        return run.call(kind, CallSite([word]))
    return Unknown("a command-line argument that other code converts")


def argument_group(run: Run, receiver: Value, site: CallSite) -> Value:
    return receiver


METHODS = {
    "argparse.ArgumentParser.add_argument": add_argument,
    "argparse.ArgumentParser.parse_args": parse_args,
    "argparse.ArgumentParser.parse_known_args": parse_known_args,
    "argparse.ArgumentParser.add_argument_group": argument_group,
    "argparse.ArgumentParser.add_mutually_exclusive_group": argument_group,
    "argparse.ArgumentParser.add_subparsers": subparsers,
}
