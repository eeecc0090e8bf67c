"""The state of a launch: configurations, namespace, remappings and global parameters, and their scopes."""

from __future__ import annotations

from dataclasses import field

from archlint.interpreter.values import Known, Unknown, Value, one_of
from archlint.launch.objects import known_text
from archlint.launch.parameter_sources import OpenParameters, ParameterFileUse, ParameterSetting
from archlint.launch.started import Remap
from archlint.records import dataclass

Global = list["ParameterSetting | ParameterFileUse | OpenParameters"]


@dataclass(eq=False)
class Context:
    """``remaps`` and ``parameters`` are lists that scopes share: launch_ros keeps them in the configurations,
    which a scoped group copies shallowly, so that a group adds to a list that was there before it."""

    configurations: dict[str, Value] = field(default_factory=dict)
    environment: dict[str, Value] = field(default_factory=dict)
    namespace: Value | None = None
    remaps: list[Remap] | None = None
    parameters: Global | None = None

    def known_configurations(self) -> dict[str, str]:
        """The launch configurations whose text is known."""
        texts = ((name, known_text(value)) for name, value in self.configurations.items())
        return {name: text for name, text in texts if text is not None}

    def copy(self) -> Context:
        """What ``PushLaunchConfigurations`` and ``PushEnvironment`` keep."""
        return Context(dict(self.configurations), dict(self.environment), self.namespace, self.remaps, self.parameters)

    def fork(self) -> Context:
        """A copy that shares nothing, for a branch that may not be taken."""
        context = self.copy()
        context.remaps = None if self.remaps is None else list(self.remaps)
        context.parameters = None if self.parameters is None else list(self.parameters)
        return context

    def set_aside(self) -> Context:
        """The context as it is, with the lists that it shares with the scopes around it; what comes next goes to
        copies of them."""
        kept, forked = self.copy(), self.fork()
        self.remaps, self.parameters = forked.remaps, forked.parameters
        return kept

    def restore(self, kept: Context) -> None:
        self.configurations = kept.configurations
        self.environment = kept.environment
        self.namespace = kept.namespace
        self.remaps = kept.remaps
        self.parameters = kept.parameters

    def add_remap(self, remap: Remap) -> None:
        if self.remaps is None:
            self.remaps = []
        self.remaps.append(remap)

    def add_parameter(self, parameter: ParameterSetting | ParameterFileUse | OpenParameters) -> None:
        if self.parameters is None:
            self.parameters = []
        self.parameters.append(parameter)

    def join(self, before: Context, why: str) -> None:
        """After a branch that may not have been taken: each value is that of before or of now."""
        for name in sorted({*self.configurations, *before.configurations}):
            now, then = self.configurations.get(name), before.configurations.get(name)
            if now is not then:
                missing = Unknown(f"the launch configuration '{name}' is set in {why}")
                self.configurations[name] = one_of((then or missing, now or missing))
        for name in sorted({*self.environment, *before.environment}):
            now, then = self.environment.get(name), before.environment.get(name)
            if now is not then:
                missing = Unknown(f"the environment variable {name} is set in {why}")
                self.environment[name] = one_of((then or missing, now or missing))
        if self.namespace is not before.namespace:
            self.namespace = one_of((before.namespace or Known("/"), self.namespace or Known("/")))
