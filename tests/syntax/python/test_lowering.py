"""What the lowering keeps of a Python file."""

from __future__ import annotations

import ast

import libcst
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from archlint.syntax.facts import FACTS_VERSION, Facts, decode, encode
from archlint.syntax.python.lower_expressions import MAX_DEPTH
from archlint.syntax.python.lower_statements import MAX_NESTING
from archlint.syntax.python.lowering import lower
from syntax.shape import expression, shape, statement, statements


class TestLiterals:
    @pytest.mark.parametrize(
        ("source", "value"),
        [
            ("'chatter'", "chatter"),
            ('"it\'s"', "it's"),
            ("'''it's \"quoted\"'''", 'it\'s "quoted"'),
            ("''", ""),
            ('""""a"""', '"a'),
            (r"'tab\there'", "tab\there"),
            (r"r'tab\there'", r"tab\there"),
            (r"R'\''", r"\'"),
            ("u'ros'", "ros"),
            (r"'\x41\u00e9\U0001F916\101\N{BULLET}'", "Aé🤖A•"),
            (r"'\d'", "\\d"),
            ("'one\\\ntwo'", "onetwo"),
            ("'/a' '/b'", "/a/b"),
            ("('/a'\n   r'\\b' # why\n   '/c')", "/a\\b/c"),
            ("f'/plain'", "/plain"),
            ("'{}' f'{{}}'", "{}{}"),
            ("10", 10),
            ("0x1F", 31),
            ("0o17", 15),
            ("1_000", 1000),
            ("00", 0),
            ("1.5", 1.5),
            ("1e-3", 0.001),
            (".5", 0.5),
            ("1_0.0_1", 10.01),
            ("True", True),
            ("None", None),
            ("-1", -1),
            ("+2.5", 2.5),
            ("- - 3", 3),
            ("~0", -1),
            ("not 1", False),
            ("(((1)))", 1),
            ("18446744073709551615", 2**64 - 1),
            ("-9223372036854775808", -(2**63)),
        ],
    )
    def test_is_kept_with_its_value(self, source, value):
        (assignment,) = lower(f"x = {source}\n").body
        assert assignment.value.value == value
        assert type(assignment.value.value) is type(value)

    @pytest.mark.parametrize(
        ("source", "what"),
        [
            ("b'raw'", "bytes"),
            ("b'a' b'b'", "bytes"),
            ("...", "ellipsis"),
            ("2j", "complex number"),
            ("18446744073709551616", "huge integer"),
            ("9" * 5000, "huge integer"),
            (r"'\ud800'", "string with a lone surrogate"),
            (r"f'\ud800{x}'", "string with a lone surrogate"),
            (r"'\x4'", r"string with truncated \x escape"),
            (r"'\N{NO SUCH LETTER}'", "string with unknown character name 'NO SUCH LETTER'"),
        ],
    )
    def test_is_opaque_where_no_cache_could_hold_it(self, source, what):
        assert expression(source) == f"Opaque({what!r})"

    def test_a_negative_number_beyond_64_bits_stays_an_operation(self):
        assert expression("-18446744073709551615") == "Unary('-', Literal(18446744073709551615))"

    def test_minus_true_is_not_folded(self):
        assert expression("-True") == "Unary('-', Literal(True))"

    def test_newlines_in_strings_are_those_of_python(self):
        (assignment,) = lower("x = '''a\r\nb'''\r\n").body
        assert assignment.value.value == "a\nb"

    @settings(derandomize=True, deadline=None)
    @given(st.text(alphabet=st.characters(codec="utf-8", exclude_characters="\r\0"), max_size=20))
    def test_every_string_means_what_python_says(self, text):
        escaped = text.replace("\\", "\\\\").replace('"', '\\"')
        for source in (repr(text), ascii(text), f'"""{escaped}"""'):
            (assignment,) = lower(f"x = {source}\n").body
            assert assignment.value.value == ast.literal_eval(source) == text


class TestFormatStrings:
    def test_neighbouring_text_is_joined(self):
        assert expression("'/' f'{ns}' '/a' f'/b{i}'") == (
            "FormatString(['/', Field(Name('ns')), '/a/b', Field(Name('i'))])"
        )

    def test_braces_and_escapes_in_the_text(self):
        assert expression(r"f'{{\x41\n}}{x}\N{BULLET}'") == r"FormatString(['{A\n}', Field(Name('x')), '•'])"

    def test_a_raw_one_keeps_its_backslashes(self):
        assert expression(r"rf'\d{x}'") == r"FormatString(['\\d', Field(Name('x'))])"

    def test_escaped_braces_are_not_doubled_braces(self):
        assert expression(r"f'\x7b\x7b{x}'") == "FormatString(['{{', Field(Name('x'))])"

    def test_conversion_and_format_specification(self):
        assert expression("f'{x!r:>10}'") == "FormatString([Field(Name('x'), 'r', '>10')])"

    def test_a_field_in_the_specification_keeps_its_spelling(self):
        assert expression("f'{x:{width}.2f}'") == "FormatString([Field(Name('x'), None, '{width}.2f')])"

    def test_self_documenting_field(self):
        assert expression("f'{x = }'") == "FormatString(['x = ', Field(Name('x'), 'r')])"


class TestExpressions:
    @pytest.mark.parametrize(
        ("source", "expected"),
        [
            ("a.b.c", "Attribute(Attribute(Name('a'), 'b'), 'c')"),
            (
                "f(a, *b, k=c, **d)",
                "Call(Name('f'), [Argument(Name('a')), Argument(Name('b'), None, '*'), "
                "Argument(Name('c'), 'k'), Argument(Name('d'), None, '**')])",
            ),
            ("a[0]", "Subscript(Name('a'), Literal(0))"),
            ("a[0,]", "Subscript(Name('a'), Sequence('tuple', [Literal(0)]))"),
            (
                "a[1:n, ::2]",
                "Subscript(Name('a'), Sequence('tuple', [Slice(Literal(1), Name('n'), None), "
                "Slice(None, None, Literal(2))]))",
            ),
            ("a[*b]", "Subscript(Name('a'), Starred(Name('b')))"),
            ("a + b * c", "Binary('+', Name('a'), Binary('*', Name('b'), Name('c')))"),
            ("a - b - c", "Binary('-', Binary('-', Name('a'), Name('b')), Name('c'))"),
            ("a - (b - c)", "Binary('-', Name('a'), Binary('-', Name('b'), Name('c')))"),
            ("'%s' % x", "Binary('%', Literal('%s'), Name('x'))"),
            ("not a", "Unary('not', Name('a'))"),
            ("a and b and c", "Boolean('and', [Name('a'), Name('b'), Name('c')])"),
            ("a and (b and c)", "Boolean('and', [Name('a'), Name('b'), Name('c')])"),
            ("a or b and c", "Boolean('or', [Name('a'), Boolean('and', [Name('b'), Name('c')])])"),
            ("0 < a <= 9", "Compare(Literal(0), ['<', '<='], [Name('a'), Literal(9)])"),
            ("a is not b", "Compare(Name('a'), ['is not'], [Name('b')])"),
            ("a not in b", "Compare(Name('a'), ['not in'], [Name('b')])"),
            ("a if t else b", "Conditional(Name('t'), Name('a'), Name('b'))"),
            ("(1, *a)", "Sequence('tuple', [Literal(1), Starred(Name('a'))])"),
            ("1, 2", "Sequence('tuple', [Literal(1), Literal(2)])"),
            ("()", "Sequence('tuple', [])"),
            ("[a]", "Sequence('list', [Name('a')])"),
            ("{a}", "Sequence('set', [Name('a')])"),
            ("{'k': a, **b}", "Mapping([Literal('k'), None], [Name('a'), Name('b')])"),
            ("(y := 1)", "Assigned(Name('y'), Literal(1))"),
            ("await f()", "Await(Call(Name('f'), []))"),
            ("(yield)", "Yield(None, False)"),
            ("(yield from a)", "Yield(Name('a'), True)"),
        ],
    )
    def test_lowered(self, source, expected):
        assert expression(source) == expected

    def test_comprehension_with_two_loops_and_conditions(self):
        assert expression("[x for row in rows if row for x in row if x > 0 if x]") == (
            "Comprehension('list', Name('x'), None, ["
            "Generator(Name('row'), Name('rows'), [Name('row')]), "
            "Generator(Name('x'), Name('row'), [Compare(Name('x'), ['>'], [Literal(0)]), Name('x')])])"
        )

    def test_dict_comprehension_and_bare_generator(self):
        assert expression("{k: v for k, v in a}").startswith("Comprehension('dict', Name('k'), Name('v'), ")
        assert "Argument(Comprehension('generator', Name('x')" in expression("f(x for x in a)")

    def test_lambda_with_every_kind_of_parameter(self):
        assert expression("lambda a, /, b, c=1, *d, e=2, **f: a") == (
            "Lambda([Param('a', 'positional_only'), Param('b', 'normal'), Param('c', 'normal', Literal(1)), "
            "Param('d', 'star'), Param('e', 'keyword_only', Literal(2)), Param('f', 'double_star')], "
            "Name('a'))"
        )

    def test_a_long_sum_is_given_up_rather_than_overrunning_a_reader(self):
        assert expression(" + ".join("a" * (MAX_DEPTH + 1))) == "Opaque('expression nested too deeply')"
        assert expression(" + ".join("a" * (MAX_DEPTH - 1))).startswith("Binary(")

    def test_deep_nesting_is_cut_where_it_becomes_too_deep(self):
        facts = lower("x = " + "f(" * (MAX_DEPTH + 5) + ")" * (MAX_DEPTH + 5) + "\n")
        assert "Opaque('expression nested too deeply')" in shape(facts.body)
        assert decode(encode(facts)) == facts


class TestNames:
    def test_private_names_are_mangled_inside_a_class(self):
        (definition,) = statements("class _Arm:\n  def __move(self, __x):\n    self.__speed = __x\n")
        assert "Function('_Arm__move', [Param('self', 'normal'), Param('_Arm__x', 'normal')]" in definition
        assert "Assign([Attribute(Name('self'), '_Arm__speed')], Name('_Arm__x'))" in definition

    def test_nested_functions_belong_to_the_class_and_its_bases_do_not(self):
        (definition,) = statements("class A(__B):\n  def f(self):\n    def g():\n      return __x\n")
        assert "[Argument(Name('__B'))]" in definition
        assert "Return(Name('_A__x'))" in definition

    def test_the_inner_class_wins_and_the_outer_one_comes_back(self):
        (definition,) = statements("class A:\n  class B:\n    __x = 1\n  __y = 2\n")
        assert "Name('_B__x')" in definition
        assert "Name('_A__y')" in definition

    @pytest.mark.parametrize("name", ["__init__", "_x", "x__", "__"])
    def test_other_names_are_not(self, name):
        assert f"Name({name!r})" in statement(f"class A:\n  {name} = 1\n")

    def test_not_outside_of_classes_nor_in_a_class_of_underscores(self):
        assert statement("__x = 1\n") == "Assign([Name('__x')], Literal(1))"
        assert "Name('__x')" in statement("class __:\n  __x = 1\n")

    def test_identifiers_are_normalised(self):
        assert statement("ﬁne = 1\n") == "Assign([Name('fine')], Literal(1))"


class TestSimpleStatements:
    @pytest.mark.parametrize(
        ("source", "expected"),
        [
            ("a = b = 1", "Assign([Name('a'), Name('b')], Literal(1))"),
            (
                "a, *b = c",
                "Assign([Sequence('tuple', [Name('a'), Starred(Name('b'))])], Name('c'))",
            ),
            ("self.a: int = 1", "Annotated(Attribute(Name('self'), 'a'), Name('int'), Literal(1))"),
            ("a: int", "Annotated(Name('a'), Name('int'), None)"),
            ("a //= 2", "Augmented(Name('a'), '//', Literal(2))"),
            ("type Pose = tuple", "Assign([Name('Pose')], Name('tuple'))"),
            ("del a, b[0]", "Delete([Name('a'), Subscript(Name('b'), Literal(0))])"),
            ("del a", "Delete([Name('a')])"),
            ("assert a, 'why'", "Assert(Name('a'))"),
            ("raise E from e", "Raise(Name('E'))"),
            ("raise", "Raise(None)"),
            ("return", "Return(None)"),
            ("pass", "Jump('pass')"),
            ("global a, b", "Global('global', ['a', 'b'])"),
            ("nonlocal a", "Global('nonlocal', ['a'])"),
            ("import a.b.c", "Import('a.b.c', None)"),
            ("import a.b as c", "Import('a.b', 'c')"),
            ("from . import a", "ImportFrom('', 1, [('a', 'a')])"),
            ("from ..m.n import (a, b as c,)", "ImportFrom('m.n', 2, [('a', 'a'), ('b', 'c')])"),
            ("from m import *", "ImportFrom('m', 0, [('*', '*')])"),
            ("f()", "Expression(Call(Name('f'), []))"),
        ],
    )
    def test_lowered(self, source, expected):
        assert statement(source + "\n") == expected

    def test_an_import_of_two_modules_is_two_imports(self):
        assert statements("import a, b as c\n") == ["Import('a', None)", "Import('b', 'c')"]

    def test_semicolons(self):
        assert statements("a(); b()\n") == [
            "Expression(Call(Name('a'), []))",
            "Expression(Call(Name('b'), []))",
        ]

    @pytest.mark.parametrize("source", ['"""A docstring."""', "...", "42", "'a' 'b'", "b'x'"])
    def test_a_statement_without_effect_is_dropped(self, source):
        assert statements(source + "\n") == []

    def test_an_f_string_may_have_an_effect(self):
        assert statement("f'{g()}'\n").startswith("Expression(FormatString(")


class TestCompoundStatements:
    def test_elif_is_an_if_in_the_else(self):
        assert statement("if a:\n  pass\nelif b:\n  f()\nelse:\n  g()\n") == (
            "If(Name('a'), [Jump('pass')], [If(Name('b'), [Expression(Call(Name('f'), []))], "
            "[Expression(Call(Name('g'), []))])])"
        )

    def test_loops(self):
        assert statement("for i, j in x:\n  break\nelse:\n  f()\n") == (
            "For(Sequence('tuple', [Name('i'), Name('j')]), Name('x'), [Jump('break')], "
            "[Expression(Call(Name('f'), []))], False)"
        )
        assert statement("while True: continue\n") == "While(Literal(True), [Jump('continue')], [])"

    def test_with(self):
        assert statement("with a as b, c:\n  f()\n") == (
            "With([WithItem(Name('a'), Name('b')), WithItem(Name('c'))], [Expression(Call(Name('f'), []))], False)"
        )

    def test_async_statements(self):
        (function,) = lower("async def f():\n  async for a in b:\n    pass\n  async with a:\n    await b\n").body
        loop, block = function.body
        assert (function.is_async, loop.is_async, block.is_async) == (True, True, True)

    def test_try(self):
        assert statement("try:\n  a()\nexcept (E, F) as e:\n  pass\nexcept:\n  pass\nfinally:\n  b()\n") == (
            "Try([Expression(Call(Name('a'), []))], "
            "[Handler(Sequence('tuple', [Name('E'), Name('F')]), 'e', [Jump('pass')]), "
            "Handler(None, None, [Jump('pass')])], [], [Expression(Call(Name('b'), []))])"
        )

    def test_exception_groups(self):
        assert statement("try:\n  a()\nexcept* E:\n  b()\n") == (
            "Try([Expression(Call(Name('a'), []))], "
            "[Handler(Name('E'), None, [Expression(Call(Name('b'), []))])], [], [])"
        )

    def test_a_chain_of_elif_too_long_to_follow_is_reported(self):
        arms = "".join(f"elif a == {i}:\n  f()\n" for i in range(MAX_NESTING + 10))
        facts = lower("if a:\n  f()\n" + arms)
        (problem,) = facts.problems
        assert (problem.line, problem.column) == (2 * MAX_NESTING, 3)
        assert "nested too deeply" in problem.message
        assert decode(encode(facts)) == facts


class TestPatterns:
    @pytest.mark.parametrize(
        ("pattern", "expected"),
        [
            ("'go'", "Pattern('value', Literal('go'))"),
            ("None", "Pattern('value', Literal(None))"),
            ("Mode.AUTO", "Pattern('value', Attribute(Name('Mode'), 'AUTO'))"),
            ("-1", "Pattern('value', Literal(-1))"),
            ("x", "Pattern('capture', None, 'x')"),
            ("_", "Pattern('capture')"),
            ("1 | 2", "Pattern('or', None, None, "
             "[Pattern('value', Literal(1)), Pattern('value', Literal(2))])"),
            ("[a, _]", "Pattern('sequence', None, None, "
             "[Pattern('capture', None, 'a'), Pattern('capture')])"),
            ("a, b", "Pattern('sequence', None, None, "
             "[Pattern('capture', None, 'a'), Pattern('capture', None, 'b')])"),
            ("[a, *rest]", "Pattern('other', None, None, "
             "[Pattern('capture', None, 'a'), Pattern('capture', None, 'rest')])"),
            ("'a' as b", "Pattern('as', None, 'b', [Pattern('value', Literal('a'))])"),
            ("Point(0, y=c)", "Pattern('other', Name('Point'), None, "
             "[Pattern('value', Literal(0)), Pattern('capture', None, 'c')])"),
            ("{'k': v, **rest}", "Pattern('mapping', None, None, "
             "[Pattern('entry', Literal('k'), None, [Pattern('capture', None, 'v')]), "
             "Pattern('rest', None, None, [Pattern('capture', None, 'rest')])])"),
        ],
    )  # fmt: skip
    def test_lowered(self, pattern, expected):
        (match,) = lower(f"match s:\n  case {pattern} if g:\n    f()\n").body
        (case,) = match.cases
        assert shape(case.pattern) == expected
        assert shape(case.guard) == "Name('g')"
        assert shape(match.subject) == "Name('s')"


class TestDefinitions:
    def test_a_function(self):
        source = "@timed\n@retry(3)\ndef f(a: int, *, b=1) -> str:\n  '''Docs.'''\n  return a\n"
        assert statement(source) == (
            "Function('f', [Param('a', 'normal', None, Name('int')), "
            "Param('b', 'keyword_only', Literal(1))], [Return(Name('a'))], "
            "[Name('timed'), Call(Name('retry'), [Argument(Literal(3))])], "
            "Name('str'), False, False, 'Docs.')"
        )

    @pytest.mark.parametrize(
        ("body", "docstring"),
        [
            ("'''First.\n\n    Next.\n      Deep.\n    '''", "First.\n\nNext.\n  Deep."),
            ("'in ' 'two'", "in two"),
            ("'on the line of the def'; f()", "on the line of the def"),
            ("f'no {docstring}'", ""),
            ("b'bytes'", ""),
            ("x = 'assigned'", ""),
            ("f()\n    'too late'", ""),
        ],
    )
    def test_docstrings(self, body, docstring):
        function, cls = lower(f"def f():\n    {body}\nclass A:\n    {body}\n").body
        assert (function.docstring, cls.docstring) == (docstring, docstring)

    def test_a_definition_on_one_line_has_a_docstring(self):
        (cls,) = lower("class A: 'Short.'\n").body
        assert cls.docstring == "Short."

    def test_a_docstring_of_a_book_is_cut(self):
        (function,) = lower(f"def f():\n    '{'a' * 3_000}'\n").body
        assert function.docstring == "a" * 2_000 + " …"

    def test_a_class(self):
        assert statement("@node\nclass A(B, C[int], metaclass=M):\n  x = 1\n") == (
            "Class('A', [Argument(Name('B')), Argument(Subscript(Name('C'), Name('int'))), "
            "Argument(Name('M'), 'metaclass')], [Assign([Name('x')], Literal(1))], [Name('node')])"
        )

    @pytest.mark.parametrize(
        ("body", "is_generator"),
        [
            ("yield 1", True),
            ("x = yield", True),
            ("yield from a", True),
            ("return 1", False),
            ("g = lambda: (yield)", False),
            ("def g():\n    yield", False),
            ("def g(x=(yield)): pass", True),
        ],
    )
    def test_a_generator_is_one_whose_own_body_yields(self, body, is_generator):
        (function,) = lower(f"def f():\n  {body}\n").body
        assert function.is_generator is is_generator

    def test_a_generator_inside_does_not_hide_the_one_around_it(self):
        (function,) = lower("def f():\n  yield\n  def g(): return 1\n").body
        assert function.is_generator
        assert not function.body[1].is_generator


class TestExports:
    @pytest.mark.parametrize(
        ("source", "exports"),
        [
            ("__all__ = ['a', 'b']", ["a", "b"]),
            ("__all__ = ('a',)", ["a"]),
            ("__all__: list[str] = ['a']", ["a"]),
            ("__all__ = ['a']\n__all__ += ['b']", ["a", "b"]),
            ("__all__ = ['a']\n__all__.extend(['b'])\n__all__.append('c')", ["a", "b", "c"]),
            ("__all__ = ['a'] + ['b']", ["a", "b"]),
            ("__all__ = []", []),
            ("__all__ = ['a']\n__all__ += other.__all__", None),
            ("__all__ = ['a']\n__all__.remove('a')", None),
            ("__all__ = names", None),
            ("x = ['a']", None),
        ],
    )
    def test_only_a_literal_list_is_known(self, source, exports):
        assert lower(source + "\n").exports == exports


class TestFacts:
    def test_an_empty_file_has_empty_facts(self):
        assert lower("") == Facts(FACTS_VERSION)

    def test_only_comments(self):
        assert lower("# nothing here").body == []

    def test_a_syntax_error_is_left_to_the_caller(self):
        with pytest.raises(libcst.ParserSyntaxError):
            lower("def f(:\n")

    def test_facts_survive_storage(self):
        source = (
            "from __future__ import annotations\nimport rclpy\n\n"
            "class A(Node):\n  def __init__(self):\n    super().__init__('a', x=[1, 2.0, None, -3, True])\n"
            "    self.t = self.create_timer(0.5, lambda: [f'{i!r}' for i in range(3)])\n"
            "    with a as b:\n      match b:\n        case {'k': [1, *_]}: pass\n"
        )
        facts = lower(source)
        assert decode(encode(facts)) == facts

    @pytest.mark.parametrize("operator", ["==", "not in", "-", "and"])
    def test_facts_with_an_operator_that_there_is_not_are_a_miss(self, operator: str):
        payload = encode(lower(f"found = a {operator} b"))
        assert decode(payload) is not None
        assert decode(payload.replace(operator.encode(), b"~" * len(operator))) is None
