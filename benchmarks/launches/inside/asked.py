"""Which launch arguments conditions ask for, and the other values of them that are worth a run."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

TRUTH = {"true": "false", "false": "true", "True": "False", "False": "True", "1": "0", "0": "1"}
MODULES = ("math",)
"""What an expression imports unless it says otherwise: no value of an argument."""
MOST = 10
"""How many other values one launch file is run with."""

declared: dict[str, tuple[str | None, list[str]]] = {}
"""Arguments that took their default, or were given: the value, and the choices."""
_asked: dict[str, list[str]] = {}
_depth = 0


@contextmanager
def asking() -> Iterator[None]:
    global _depth
    _depth += 1
    try:
        yield
    finally:
        _depth -= 1


def note(name: str) -> None:
    if _depth:
        _asked.setdefault(name, [])


def note_text(text: str) -> None:
    """A text that is compared or evaluated: the words in quotes may be values of what is asked."""
    if _depth:
        words = [text] if re.fullmatch(r"[\w.-]+", text) else re.findall(r"""['"]([\w./-]+)['"]""", text)
        for known in _asked.values():
            known.extend(word for word in words if word not in known)


def others(given: dict[str, str]) -> list[dict[str, str]]:
    """The arguments of the other runs: one argument changed in each."""
    found = []
    for name, (value, choices) in declared.items():
        now = given.get(name, value)
        values = [choice for choice in choices if choice != now]
        if not values and now in TRUTH:
            values = [TRUTH[now]]
        elif not values and name in _asked:
            values = [word for word in _asked[name] if word != now and word not in TRUTH][:3]
        found += [{**given, name: one} for one in values]
    return found[:MOST]


def follow(launch: Any) -> None:
    """Have launch's own classes tell what they ask."""
    from launch.conditions import LaunchConfigurationEquals, LaunchConfigurationNotEquals
    from launch.substitutions import LaunchConfiguration, PythonExpression, TextSubstitution
    from launch.utilities import perform_substitutions

    def evaluate(self: Any, context: Any, kept: Any = launch.Condition.evaluate) -> bool:
        with asking():
            name = getattr(self, "_LaunchConfigurationEquals__launch_configuration_name", None)
            name = name or getattr(self, "_LaunchConfigurationNotEquals__launch_configuration_name", None)
            if isinstance(name, (list, tuple)):
                note(perform_substitutions(context, name))
            elif isinstance(name, str):
                note(name)
            return bool(kept(self, context))

    def read(self: Any, context: Any, kept: Any = LaunchConfiguration.perform) -> str:
        if _depth:
            note(perform_substitutions(context, self.variable_name))
        return str(kept(self, context))

    def expression(self: Any, context: Any, kept: Any = PythonExpression.perform) -> str:
        if _depth:
            note_text(perform_substitutions(context, self.expression))
        return str(kept(self, context))

    def text(self: Any, context: Any, kept: Any = TextSubstitution.perform) -> str:
        found = str(kept(self, context))
        if re.fullmatch(r"[\w.-]+", found) and found not in MODULES:
            note_text(found)
        return found

    def declare(self: Any, context: Any, kept: Any = launch.actions.DeclareLaunchArgument.execute) -> Any:
        fresh = self.name not in context.launch_configurations
        result = kept(self, context)
        if fresh or self.name in given_names:
            value = context.launch_configurations.get(self.name)
            declared.setdefault(self.name, (value, list(self.choices or ())))
        return result

    launch.Condition.evaluate = evaluate
    for cls in (LaunchConfigurationEquals, LaunchConfigurationNotEquals):
        if "evaluate" in vars(cls):
            del cls.evaluate
    LaunchConfiguration.perform = read
    PythonExpression.perform = expression
    TextSubstitution.perform = text
    launch.actions.DeclareLaunchArgument.execute = declare


given_names: set[str] = set()
