"""A second try for programs that stop early: a statement that fails is skipped, and what it would have
set is unknown.

The source is rewritten as it is loaded: each statement of a function, class or module body is put into
a `try`. Statements inside the program's own `try` are left alone, and an exception that the program
raises itself still leaves the function, so that its own handling of errors keeps its meaning.
"""

from __future__ import annotations

import ast
import importlib.machinery
import sys
import types
from typing import Any

from .record import recorder
from .sandbox import EndlessWait
from .unknown import Unknown

_SKIP, _CATCH, _CATCH_LOOP, _UNKNOWN = (
    "__oracle_skip__",
    "__oracle_catch__",
    "__oracle_catch_loop__",
    "__oracle_unknown__",
)
_DEEPEST = 6  # Python nests at most 20 blocks in a function, and a guard takes two
_BARE = (
    ast.FunctionDef,
    ast.AsyncFunctionDef,
    ast.Global,
    ast.Nonlocal,
    ast.Pass,
    ast.Break,
    ast.Continue,
    ast.Raise,
)


class Left(Exception):
    """The program wanted to exit; a second try goes on."""


class _Rewriter:
    def __init__(self) -> None:
        self.raises: set[int] = set()
        self._depth = 0

    def body(self, statements: list[ast.stmt]) -> list[ast.stmt]:
        self._depth += 1
        rewritten = [self.statement(statement) for statement in statements]
        self._depth -= 1
        return rewritten

    def statement(self, node: ast.stmt) -> ast.stmt:
        if isinstance(node, ast.Raise):
            self.raises.update(range(node.lineno, (node.end_lineno or node.lineno) + 1))
        self._inside(node)
        if isinstance(node, _BARE) or _is_docstring(node) or _is_future(node) or self._depth > _DEEPEST:
            return node
        return self._guarded(node)

    def _inside(self, node: ast.stmt) -> None:
        if isinstance(node, ast.Try):
            if not node.handlers:
                node.body = self.body(node.body)
            else:
                for statement in node.body:
                    self._functions(statement)
            for handler in node.handlers:
                handler.body = self.body(handler.body)
            node.orelse, node.finalbody = self.body(node.orelse), self.body(node.finalbody)
            return
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            outer, self._depth = self._depth, 0
            node.body = self.body(node.body)
            self._depth = outer
            return
        if isinstance(node, ast.If) and len(node.orelse) == 1 and isinstance(node.orelse[0], ast.If):
            self._inside(node.orelse[0])  # an elif belongs to its chain
            node.body = self.body(node.body)
            return
        for field in ("body", "orelse"):
            if isinstance(getattr(node, field, None), list):
                setattr(node, field, self.body(getattr(node, field)))
        for case in getattr(node, "cases", []):
            case.body = self.body(case.body)

    def _functions(self, node: ast.stmt) -> None:
        """Functions that are defined inside a `try` of the program."""
        for inner in ast.walk(node):
            if isinstance(inner, (ast.FunctionDef, ast.AsyncFunctionDef)):
                inner.body = self.body(inner.body)

    def _guarded(self, node: ast.stmt) -> ast.stmt:
        loops = isinstance(node, (ast.For, ast.While, ast.AsyncFor))
        recover: list[ast.stmt] = [
            _expression(ast.Call(_name(_SKIP), [_name("__oracle_error__"), ast.Constant(node.lineno)], []))
        ]
        for target in _targets(node):
            recover.append(_assign(target))
        if isinstance(node, ast.Return):
            recover.append(ast.Return(_unknown(node.lineno)))
        handler = ast.ExceptHandler(_name(_CATCH_LOOP if loops else _CATCH), "__oracle_error__", recover)
        guarded = ast.Try([node], [handler], [], [])
        ast.copy_location(guarded, node)
        for inner in [handler, *recover]:
            ast.copy_location(inner, node)
        return guarded


def _is_docstring(node: ast.stmt) -> bool:
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)


def _is_future(node: ast.stmt) -> bool:
    return isinstance(node, ast.ImportFrom) and node.module == "__future__"


def _targets(node: ast.stmt) -> list[ast.expr]:
    if isinstance(node, ast.Assign):
        found = [each for target in node.targets for each in _flat(target)]
    elif isinstance(node, (ast.AnnAssign, ast.AugAssign)):
        found = _flat(node.target)
    elif isinstance(node, ast.ClassDef):
        found = [ast.Name(node.name, ast.Store())]
    elif isinstance(node, (ast.Import, ast.ImportFrom)):
        names = [(alias.asname or alias.name).partition(".")[0] for alias in node.names if alias.name != "*"]
        found = [ast.Name(name, ast.Store()) for name in names]
    else:
        found = []
    return found


def _flat(target: ast.expr) -> list[ast.expr]:
    if isinstance(target, (ast.Tuple, ast.List)):
        return [each for element in target.elts for each in _flat(element)]
    return [target] if isinstance(target, (ast.Name, ast.Attribute)) else []


def _assign(target: ast.expr) -> ast.stmt:
    """`target = unknown`, in a try of its own: `self.x` may fail where `self` does."""
    copy = ast.Name(target.id, ast.Store()) if isinstance(target, ast.Name) else target
    setting = ast.Assign([copy], _unknown(0))
    return ast.Try([setting], [ast.ExceptHandler(_name(_CATCH), None, [ast.Pass()])], [], [])


def _name(name: str) -> ast.Name:
    return ast.Name(name, ast.Load())


def _unknown(line: int) -> ast.expr:
    return ast.Call(_name(_UNKNOWN), [ast.Constant(f"line {line}")], [])


def _expression(value: ast.expr) -> ast.stmt:
    return ast.Expr(value)


def rewritten(source: bytes | str, filename: str) -> types.CodeType:
    """The code of a file whose statements are guarded."""
    tree = ast.parse(source, filename)
    rewriter = _Rewriter()
    tree.body = rewriter.body(tree.body)
    _raises[filename] = rewriter.raises
    return compile(ast.fix_missing_locations(tree), filename, "exec", dont_inherit=True)


_raises: dict[str, set[int]] = {}


def _skip(error: BaseException, line: int) -> None:
    """Let an exception pass that this function raised by itself; note any other, and go on."""
    traceback = error.__traceback__
    if traceback is not None and traceback.tb_next is None:
        raised_here = _raises.get(traceback.tb_frame.f_code.co_filename, set())
        if traceback.tb_lineno in raised_here:
            raise error
    filename = sys._getframe(1).f_code.co_filename
    recorder.write(
        "skipped",
        file=filename[len(recorder.root) :],
        line=line,
        reason=f"{type(error).__name__}: {error}"[:300],
    )


def _leave(code: object = None) -> None:
    raise Left(f"exit({code!r})")


def install() -> None:
    """From here on the repository's own files are loaded in their guarded form."""
    import builtins

    names: dict[str, Any] = {
        _SKIP: _skip,
        _CATCH: Exception,
        _CATCH_LOOP: (Exception, EndlessWait),
        _UNKNOWN: Unknown,
    }
    vars(builtins).update(names, exit=_leave, quit=_leave)
    sys.exit = _leave
    plain = importlib.machinery.SourceFileLoader.source_to_code

    def source_to_code(self: Any, data: Any, path: Any, *, _optimize: int = -1) -> Any:
        if str(path).startswith(recorder.root):
            return rewritten(data, str(path))
        return plain(self, data, path, _optimize=_optimize)  # type: ignore[call-arg]

    importlib.machinery.SourceFileLoader.source_to_code = source_to_code  # type: ignore[assignment,method-assign]
