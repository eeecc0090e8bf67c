"""The patterns of ``match`` statements lowered to :class:`archlint.syntax.facts.Pattern`."""

from __future__ import annotations

import libcst as cst

from archlint.syntax.facts import Expr, Pattern
from archlint.syntax.python.lower_expressions import ExpressionLowering


class PatternLowering:
    """Lowers patterns.

    Class patterns are of kind ``other``: whether they match is not followed, but the names that they bind are
    among the parts.
    """

    def __init__(self, expressions: ExpressionLowering) -> None:
        self._expressions = expressions

    def lower(self, node: cst.MatchPattern) -> Pattern:
        """One pattern with its parts."""
        match node:
            case cst.MatchValue() | cst.MatchSingleton():
                return Pattern("value", value=self._value(node.value))
            case cst.MatchAs(pattern=None):
                return self._capture(node.name)
            case cst.MatchAs(pattern=cst.MatchPattern() as inner):
                return Pattern("as", name=self._capture(node.name).name, parts=[self.lower(inner)])
            case cst.MatchOr():
                return Pattern("or", parts=[self.lower(element.pattern) for element in node.patterns])
            case cst.MatchList() | cst.MatchTuple():
                return self._sequence(node)
            case cst.MatchClass():
                given = [*(element.value for element in node.patterns), *(element.pattern for element in node.kwds)]
                return Pattern("other", value=self._value(node.cls), parts=[self.lower(part) for part in given])
            case cst.MatchMapping():
                entries = [
                    Pattern("entry", value=self._value(element.key), parts=[self.lower(element.pattern)])
                    for element in node.elements
                ]
                rest = [] if node.rest is None else [Pattern("rest", parts=[self._capture(node.rest)])]
                return Pattern("mapping", parts=entries + rest)
        return Pattern("other")

    def _value(self, node: cst.BaseExpression) -> Expr:
        return self._expressions.lower(node)

    def _capture(self, name: cst.Name | None) -> Pattern:
        return Pattern("capture", name=None if name is None else self._expressions.identifier(name.value))

    def _sequence(self, node: cst.MatchList | cst.MatchTuple) -> Pattern:
        starred = any(isinstance(element, cst.MatchStar) for element in node.patterns)
        parts = [
            self._capture(element.name) if isinstance(element, cst.MatchStar) else self.lower(element.value)
            for element in node.patterns
        ]
        # With a star the number of parts says nothing about the length of the subject.
        return Pattern("other" if starred else "sequence", parts=parts)
