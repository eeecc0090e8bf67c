"""The command line of a program: ``sys.argv``, what argparse makes of it, and what rclpy takes out of it.

Its words are known where a launch file starts the program.  argparse itself divides them up, on plain texts; no
function of the program is handed to it.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import dataclass
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
    ListValue,
    Unknown,
    Value,
    as_default,
    one_of,
    reason,
)
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.libraries.api_use import ApiUse
    from archlint.libraries.run import Run

WORDS = 400
"""How many words of a command line are divided up."""
ROS_ARGUMENTS, END_OF_ROS_ARGUMENTS = "--ros-args", "--"

_UNKNOWN_WORD = Unknown("a command-line argument that the launch file does not set")
_MARK = "\0"
"""Starts what stands for a word that is not known: no command line can hold it."""


@dataclass(frozen=True)
class Option:
    """One ``add_argument(…)`` call."""

    flags: tuple[str, ...]
    keywords: dict[str, Value]


OPEN: Field[bool] = Field("more than is followed")
"""Whether a parser has arguments that are not known."""
ARGUMENTS: Fields[Value] = Fields("argument", one_of)
"""What the attributes of a parser's namespace may hold."""
OPTIONS: Fields[Option] = Fields("option")


class _NotDivided(Exception):
    """A command line, or a parser, with more in it than is followed."""


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> Any:
        raise _NotDivided(message)


# ------------------------------------------------------------------------------------------------ sys.argv


def program_arguments(run: Run) -> Value:
    """``sys.argv``."""
    run.program.reads_command_line = True
    return External("sys.argv") if run.argv is None else run.argv


def give_words(run: Run, words: Sequence[str | None]) -> None:
    """Start a run with the words after the program's name; None for those that are not known."""
    values = [Unknown("the path of the program"), *(_value_of_word(word) for word in words)]
    run.argv = containers.new_list(run, values)


def _value_of_word(word: str | None) -> Value:
    return _UNKNOWN_WORD if word is None else Known(word)


def remove_ros_args(run: Run, args: list[Value], keywords: dict[str, Value], e: facts.Call | None) -> Value:
    """``rclpy.utilities.remove_ros_args(args)``: what is outside of ``--ros-args … --``."""
    given = args[0] if args else keywords.get("args", NONE)
    words = _items(run, program_arguments(run) if given == NONE else given)
    if words is None:
        return Unknown(reason(given))
    return containers.new_list(run, without_ros_arguments(words))


def without_ros_arguments(words: Sequence[Value]) -> list[Value]:
    found, inside = [], False
    for word in words:
        text = word.text
        if text == ROS_ARGUMENTS or (inside and text == END_OF_ROS_ARGUMENTS):
            inside = text == ROS_ARGUMENTS
        elif not inside:
            found.append(word)
    return found


def _items(run: Run, value: Value) -> list[Value] | None:
    """The items of a list of which all are there; None for anything else."""
    items = containers.items_of(run, value) if isinstance(value, ListValue) else None
    return None if items is None or items.open or len(items.values) > WORDS else list(items.values)


# ------------------------------------------------------------------------------------------------ argparse


def argument_parser(run: Run, call: ApiUse) -> Value:
    made = Instance(External("argparse.ArgumentParser"), run.store.new_key())
    if call.open or "parents" in call.keywords or "prefix_chars" in call.keywords:
        run.store.set(made.key, OPEN, True)
    return made


def add_argument(
    run: Run, receiver: Value, args: list[Value], keywords: dict[str, Value], e: facts.Call | None
) -> Value:
    if not isinstance(receiver, Instance):
        return NONE
    names = tuple(arg.text for arg in args if arg.text is not None)
    name = _destination(names, keywords.get("dest"))
    if name is None or len(names) != len(args) or (e is not None and any(a.star for a in e.args)) or run.branch_arms:
        run.store.set(receiver.key, OPEN, True)
    if name is not None:
        what = Unknown(f"the command-line argument '{name}'")
        default = keywords.get("default") or _default_of_action(keywords.get("action"))
        value: Value = what if default is None else one_of((as_default(default), what))
        run.store.set(receiver.key, ARGUMENTS[name], value)
        run.store.set(receiver.key, OPTIONS[name], Option(names, keywords))
    return NONE


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


def subparsers(run: Run, receiver: Value, args: list[Value], keywords: dict[str, Value], e: facts.Call | None) -> Value:
    if isinstance(receiver, Instance):
        run.store.set(receiver.key, OPEN, True)
    return Unknown("subcommands are not followed")


def parse_args(run: Run, receiver: Value, args: list[Value], keywords: dict[str, Value], e: facts.Call | None) -> Value:
    return _parsed(run, receiver, args, keywords, False)[0]


def parse_known_args(
    run: Run, receiver: Value, args: list[Value], keywords: dict[str, Value], e: facts.Call | None
) -> Value:
    return containers.new_list(run, _parsed(run, receiver, args, keywords, True), "tuple")


def _parsed(
    run: Run, receiver: Value, args: list[Value], keywords: dict[str, Value], some: bool
) -> tuple[Value, Value]:
    """The namespace, and the words that no option takes where ``some`` may be left."""
    made = Instance(External("argparse.Namespace"), run.store.new_key())
    rest: Value = Unknown("the rest of the command line")
    if not isinstance(receiver, Instance):
        return made, rest
    for name, value in run.store.family(receiver.key, ARGUMENTS).items():
        run.store.set(made.key, name, value)
    words = _words(run, args[0] if args else keywords.get("args", NONE))
    if words is None or run.store.get(receiver.key, OPEN):
        return made, rest
    options = run.store.family(receiver.key, OPTIONS)
    try:
        found, left = _divide(options, words, some)
    except (_NotDivided, SystemExit, ValueError, TypeError, argparse.ArgumentError):
        return made, rest
    for name, option in options.items():
        run.store.set(made.key, name, _value(run, option, found, name, words))
    return made, containers.new_list(run, [_word(text, words) for text in left])


def _words(run: Run, given: Value) -> list[Value] | None:
    """What a parser is given to divide up: without an argument all after the program's name."""
    run.program.parses_command_line = True
    if given != NONE:
        return _items(run, given)
    words = None if run.argv is None else _items(run, run.argv)
    return None if words is None else words[1:]


def _divide(options: dict[str, Option], words: list[Value], some: bool) -> tuple[dict[str, Any], list[str]]:
    parser = _Parser(add_help=False, argument_default=argparse.SUPPRESS)
    optional: set[str] = set()
    for name, option in options.items():
        parser.add_argument(*option.flags, **_plain_keywords(option, name))
        if not option.flags[0].startswith("-") and "nargs" in option.keywords:
            optional.add(name)
    texts = [f"{_MARK}{n}" if word.text is None else word.text for n, word in enumerate(words)]
    found, left = parser.parse_known_args(texts)
    if left and not some:
        raise _NotDivided
    # What is not known may be an option: it must be where only a value can be.
    loose = [*left, *(text for name in optional for text in _texts(vars(found).get(name)))]
    if any(text.startswith(_MARK) for text in loose):
        raise _NotDivided
    return vars(found), left


def _texts(value: object) -> list[str]:
    return [value] if isinstance(value, str) else [str(item) for item in value] if isinstance(value, list) else []


_ACTIONS = frozenset({"store", "store_true", "store_false", "store_const", "append", "count", "extend"})


def _plain_keywords(option: Option, name: str) -> dict[str, Any]:
    """The keywords of ``add_argument`` that divide words up, without anything of the program in them."""
    given: dict[str, Any] = {"dest": name} if option.flags[0].startswith("-") else {}
    action = option.keywords.get("action", Known("store"))
    if action == External("argparse.BooleanOptionalAction"):
        return {**given, "action": argparse.BooleanOptionalAction}
    if not isinstance(action, Known) or action.value not in _ACTIONS:
        raise _NotDivided
    given["action"] = action.value
    if "nargs" in option.keywords:
        given["nargs"] = _count(option.keywords["nargs"])
    if action.value == "store_const" or ("const" in option.keywords and given.get("nargs") == "?"):
        given["const"] = _CONST
    return given


_CONST = "\0const"


def _count(value: Value) -> Any:
    if value == External("argparse.REMAINDER"):
        return argparse.REMAINDER
    if not isinstance(value, Known) or not (value.value in ("?", "*", "+") or isinstance(value.value, int)):
        raise _NotDivided
    return value.value


def _value(run: Run, option: Option, found: dict[str, Any], name: str, words: list[Value]) -> Value:
    """What an attribute of the namespace holds."""
    if name not in found:
        default = option.keywords.get("default") or _default_of_action(option.keywords.get("action")) or NONE
        return as_default(default if default.text is None else _converted(run, option, default))
    given = found[name]
    if given == _CONST:
        return option.keywords.get("const", NONE)
    if isinstance(given, (bool, int)) or given is None:
        return Known(given)
    if isinstance(given, list):
        if option.keywords.get("default", NONE) != NONE and option.keywords.get("action") is not None:
            return Unknown("arguments that are added to a default")
        rows = [[item] if isinstance(item, str) else item for item in given]
        flat = [_converted(run, option, _word(text, words)) for row in rows for text in row]
        nested = any(isinstance(item, list) for item in given)
        return Unknown("a list of lists of words") if nested else containers.new_list(run, flat)
    return _converted(run, option, _word(given, words))


def _word(text: str, words: list[Value]) -> Value:
    """The word that argparse gave back as a text."""
    return words[int(text[len(_MARK) :])] if text.startswith(_MARK) else Known(text)


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


def argument_group(
    run: Run, receiver: Value, args: list[Value], keywords: dict[str, Value], e: facts.Call | None
) -> Value:
    return receiver


METHODS = {
    "argparse.ArgumentParser.add_argument": add_argument,
    "argparse.ArgumentParser.parse_args": parse_args,
    "argparse.ArgumentParser.parse_known_args": parse_known_args,
    "argparse.ArgumentParser.add_argument_group": argument_group,
    "argparse.ArgumentParser.add_mutually_exclusive_group": argument_group,
    "argparse.ArgumentParser.add_subparsers": subparsers,
}
PLAIN = {"rclpy.utilities.remove_ros_args": remove_ros_args}
