"""How a rule is written down.

A rule is a generator function with its code and its scope, which says when it is asked; everything else about it
(name, severity, summary) comes from its page in the rule book.  Its own options are keyword arguments of the
decorator: the default gives the type, and an underscore is a dash in the configuration::

    @rule("SRV004", scope=Scope.AS_LAUNCHED, min_rate=1.0)
    def service_for_continuous_data(system: System, options: Options) -> Iterator[Finding]:
        threshold = options.number("min-rate")
"""

from __future__ import annotations

import importlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextvars import ContextVar
from dataclasses import field, replace
from fnmatch import fnmatchcase
from functools import cache
from types import MappingProxyType
from typing import TYPE_CHECKING, TypeVar

from archlint import checks
from archlint.checks.folding import Fold
from archlint.checks.scope import Scope
from archlint.edit_sites import Sites
from archlint.faults import Fault
from archlint.finding import Finding, Place, Related, Severity
from archlint.project import issue_tracker
from archlint.records import dataclass
from archlint.rulebook import rules

if TYPE_CHECKING:
    from archlint.architecture import Contract, Layers
    from archlint.globs import Glob
    from archlint.systems.model import System

_REPORT = (
    f"please report it on {issue_tracker()} with this message, the output of `archlint --version` and, if you may "
    "share it, the smallest file that shows it"
)

OptionValue = bool | int | float | str | tuple[str, ...]


@dataclass(frozen=True)
class Options:
    """What the configuration says to one rule.

    ``distros`` are the ROS distributions to judge for, oldest first; ``own`` the rule's own options under
    the names that the configuration uses.
    """

    distros: tuple[str, ...] = ()
    shared_topics: tuple[str, ...] = ()
    external: tuple[str, ...] = ()
    owners: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    contracts: tuple[Contract, ...] = ()
    layers: Layers | None = None
    own: Mapping[str, OptionValue] = field(default_factory=dict)
    ignored_in: tuple[Glob, ...] = ()
    """The files whose findings ``per-file-ignores`` drops."""

    def is_ignored_in(self, file: str) -> bool:
        """Whether ``per-file-ignores`` turns the rule off for a file."""
        return any(glob.matches(file) for glob in self.ignored_in)

    def is_shared(self, topic: str) -> bool:
        """Whether the configuration declares a topic as one that many may publish."""
        return _matches(topic, self.shared_topics)

    def is_external(self, name: str) -> bool:
        """Whether the configuration says that something outside this workspace provides a name."""
        return _matches(name, self.external)

    def flag(self, name: str) -> bool:
        return bool(self.own[name])

    def number(self, name: str) -> float:
        value = self.own[name]
        assert isinstance(value, (int, float)), name
        return value

    def text(self, name: str) -> str:
        return str(self.own[name])

    def texts(self, name: str) -> tuple[str, ...]:
        value = self.own[name]
        assert isinstance(value, tuple), name
        return value


def _matches(name: str, patterns: Sequence[str]) -> bool:
    return any(fnmatchcase(name, pattern) for pattern in patterns)


RuleFunction = Callable[["System", Options], Iterator[Finding]]


@dataclass(frozen=True)
class Check:
    """A rule as it is written down: called as its function is."""

    code: str
    function: RuleFunction
    scope: Scope
    """What it judges, and so when it is asked."""
    defaults: Mapping[str, OptionValue]
    """Its own options as the configuration names them."""
    taste: bool = False
    """Whether it judges how well code is made, and not whether it works: nobody wants to hear that of code that is
    put aside or tries something out."""
    in_use: bool = False
    """Whether it says nothing of what is put aside, but what it says of a trial is worth knowing."""
    says_if_installed: bool = False
    """Whether it weighs by itself that no package installs a file; others say no more than information of such code."""
    by_program: bool = False
    """Whether what it says of a file follows from the programs that run code of it, whatever other programs there
    are."""

    def __call__(self, system: System, options: Options) -> Iterator[Finding]:
        return self.function(system, options)


def rule(
    code: str,
    *,
    scope: Scope,
    taste: bool = False,
    in_use: bool = False,
    says_if_installed: bool = False,
    by_program: bool = False,
    **defaults: OptionValue,
) -> Callable[[RuleFunction], Check]:
    """Make the decorated generator function the rule with this code; a rule of ``taste`` says nothing of files
    that are put aside or try something out (:func:`archlint.analysis.aside.is_aside`), one of what is ``in_use``
    nothing of those that are put aside, and one that ``says_if_installed`` weighs itself what no package installs.  One
    that judges ``by_program`` is asked again, after an edit, only of the programs that run edited code."""
    options = {name.replace("_", "-"): value for name, value in defaults.items()}
    defaults_ = MappingProxyType(options)
    return lambda function: Check(
        code, function, scope, defaults_, taste, in_use, says_if_installed, by_program=by_program
    )


_ADDED: ContextVar[Mapping[str, Check]] = ContextVar("the checks of plugins", default=MappingProxyType({}))


def add_checks(added: Mapping[str, Check]) -> None:
    """Let these rules run, too, for the rest of this context (:mod:`contextvars`)."""
    _ADDED.set(MappingProxyType(dict(added)))


def registered() -> Mapping[str, Check]:
    """Every rule that can run, in code order: those that the modules of ``checks.MODULES`` define, and those of the
    plugins of the run."""
    own, added = _defined(Check, checks.MODULES), _ADDED.get()
    return own if not added else MappingProxyType(dict(sorted({**own, **added}.items())))


def registered_folds() -> Mapping[str, Fold]:
    """What makes one finding of several, by the code of the rule."""
    return _defined(Fold, checks.MODULES)


_Defined = TypeVar("_Defined", Check, Fold)


@cache
def _defined(kind: type[_Defined], modules: tuple[str, ...]) -> Mapping[str, _Defined]:
    """What these modules define of a kind, by code; raises ``ValueError`` for a code that stands twice."""
    by_code: dict[str, tuple[_Defined, str]] = {}
    for name in modules:
        for definition in vars(importlib.import_module(f"archlint.checks.{name}")).values():
            if isinstance(definition, kind):
                other, home = by_code.setdefault(definition.code, (definition, name))
                if other is not definition:
                    raise ValueError(f"{definition.code} is registered twice: {home}, {name}")
    return MappingProxyType({code: by_code[code][0] for code in sorted(by_code)})


def finding(
    code: str,
    place: Place,
    message: str,
    *,
    help: str = "",
    related: Sequence[Related] = (),
    node: str | None = None,
    identity: Sequence[str] = (),
    group: Sequence[str] = (),
    meant: str = "",
    sites: Sites | None = None,
    fails: bool = False,
) -> Finding:
    """A finding of a rule, with the rule's name and severity from its page."""
    page = rules()[code]
    return Finding(
        code=code,
        name=page.name,
        severity=page.severity,
        message=message,
        place=place,
        help=help,
        node=node,
        related=tuple(dict.fromkeys(related)),
        identity=tuple(identity),
        group=tuple(group),
        meant=meant,
        sites=sites,
        fails=fails,
    )


def failure(fault: Fault, plugin: str = "") -> Finding:
    """The LNT003 finding for a part of archlint, or for a rule of a ``plugin``, that raised."""
    return finding(
        "LNT003",
        fault.place,
        f"{fault.what} failed with {fault.message}; everything else was checked",
        help=f"this is an error in {plugin}, which brings the rule" if plugin else _REPORT,
        identity=(fault.what, fault.kind),
    )


def unreadable(
    file: str,
    line: int,
    column: int,
    message: str,
    internal: bool = False,
    *,
    help: str | None = None,
    leads_out: bool = False,
) -> Finding:
    """The LNT002 finding for what could not be read, or LNT003 where reading failed by a fault of ours (``internal``);
    information where ``help`` says what to do."""
    place = Place(file, line, column, line, column)
    if not internal:
        is_manifest = file.rpartition("/")[2] == "package.xml"  # copied from package to package
        group = (LEADS_OUT, message) if leads_out else (message,) if is_manifest else ()
        advice = _ADVICE_FOR_LINKS if leads_out else _UNREAD
        diagnostic = finding("LNT002", place, message, help=help or advice, identity=(message,), group=group)
        return diagnostic if help is None else replace(diagnostic, severity=Severity.INFO)
    what = f"reading this file failed with {message}; everything else was checked"
    return finding("LNT003", place, what, help=_REPORT, identity=(f"internal error: {message}",))


EMPTY = "empty"
"""The first part of the group of what is found of files with nothing in them."""
LEADS_OUT = "leads out"
"""That of links by absolute paths to what is not there."""
_ADVICE_FOR_LINKS = "remove it, or make it a link to a file of the workspace, by a relative path"
_UNREAD = "correct it: until then nothing in this file is checked"


def unreadable_interface(file: str, problems: Sequence[tuple[int, int, str]]) -> Finding:
    """The LNT002 finding for all lines of an interface file."""
    first, *others = problems
    related = tuple(Related(Place(file, line, column, line, column), message) for line, column, message in others)
    return replace(unreadable(file, *first), related=related)
