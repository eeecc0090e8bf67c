"""Facts written down as the Python that they stand for, so that tests of a front end read like examples."""

from __future__ import annotations

from collections.abc import Sequence

from archlint.syntax import facts
from archlint.syntax.cpp.lowering import lower


def in_python(source: str) -> str:
    """What a C++ source is lowered to, but for its imports."""
    body = [row for row in lower(source.encode()).body if not isinstance(row, (facts.Import, facts.ImportFrom))]
    return "\n".join(_block(body))


def _block(body: Sequence[facts.Stmt], depth: int = 0) -> list[str]:
    return [line for statement in body for line in _statement(statement, depth)]


def _statement(statement: facts.Stmt, depth: int) -> list[str]:
    indent = "    " * depth
    match statement:
        case facts.Assign(targets, value):
            return [indent + " = ".join([*map(_value, targets), _value(value)])]
        case facts.Augmented(target, op, value):
            return [f"{indent}{_value(target)} {op}= {_value(value)}"]
        case facts.Expression(value):
            return [indent + _value(value)]
        case facts.Return(value):
            return [f"{indent}return {'' if value is None else _value(value)}".rstrip()]
        case facts.If(test, body, orelse):
            otherwise = [indent + "else:", *_block(orelse, depth + 1)] if orelse else []
            return [f"{indent}if {_value(test)}:", *_block(body, depth + 1), *otherwise]
        case facts.For(target, iterable, body):
            return [f"{indent}for {_value(target)} in {_value(iterable)}:", *_block(body, depth + 1)]
        case facts.While(test, body):
            return [f"{indent}while {_value(test)}:", *_block(body, depth + 1)]
        case facts.Try(body, handlers):
            rows = [row for handler in handlers for row in (indent + "except:", *_block(handler.body, depth + 1))]
            return [indent + "try:", *_block(body, depth + 1), *rows]
        case facts.Function(name, params, body):
            return [f"{indent}def {name}({', '.join(map(_param, params))}):", *_block(body, depth + 1)]
        case facts.Class(name, bases, body):
            return [f"{indent}class {name}({', '.join(_value(b.value) for b in bases)}):", *_block(body, depth + 1)]
        case facts.Jump(kind):
            return [indent + kind]
        case facts.Raise():
            return [indent + "raise"]
        case facts.Global(kind, names):
            return [f"{indent}{kind} {', '.join(names)}"]
    return [indent + repr(statement)]


def _param(param: facts.Param) -> str:
    return param.name if param.default is None else f"{param.name}={_value(param.default)}"


def _value(value: facts.Expr) -> str:
    match value:
        case facts.Literal(constant):
            return repr(constant)
        case facts.Name(name):
            return name
        case facts.Implicit(name):
            return f"?{name}"  # of the object, or of the file
        case facts.Attribute(owner, name):
            return f"{_value(owner)}.{name}"
        case facts.Call(function, arguments):
            given = ", ".join((f"{a.keyword}=" if a.keyword else "") + _value(a.value) for a in arguments)
            return f"{_value(function)}({given})"
        case facts.Binary(op, left, right):
            return f"{_value(left)} {op} {_value(right)}"
        case facts.Compare(left, [op], [right]):
            return f"{_value(left)} {op} {_value(right)}"
        case facts.Boolean(op, values):
            return f" {op} ".join(map(_value, values))
        case facts.Unary(op, operand):
            return f"{op} {_value(operand)}"
        case facts.Conditional(test, body, orelse):
            return f"{_value(body)} if {_value(test)} else {_value(orelse)}"
        case facts.Sequence(_, elements):
            return f"[{', '.join(map(_value, elements))}]"
        case facts.Mapping(keys, values):
            rows = (f"{_value(key)}: {_value(item)}" for key, item in zip(keys, values, strict=True) if key is not None)
            return "{" + ", ".join(rows) + "}"
        case facts.Subscript(owner, index):
            return f"{_value(owner)}[{_value(index)}]"
        case facts.FormatString(parts):
            return "".join(part if isinstance(part, str) else f"{{{_value(part.value)}}}" for part in parts)
        case facts.Opaque(what):
            return f"<{what}>"
    return repr(value)
