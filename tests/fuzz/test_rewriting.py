"""Code that is written differently, so that the same must be found in it."""

from __future__ import annotations

import ast

from benchmarks.fuzz.rewriting import renamed, reordered, spaced

NODE = """\
class Talker(Node):
    '''Says
    something.'''

    def __init__(self):
        name = 'x'
        for part in (1,
                     2):
            self.say(name, f'{part}')

    def say(self, name):
        count = self.count = len(name)
        print(count, name=count)

    def stop(self):
        return [name for name in self.names]
"""


def test_lines_move_with_what_is_on_them():
    text, now = spaced(NODE, 2)
    before, after = NODE.splitlines(), text.splitlines()
    assert len(after) > len(before)
    assert all(after[now[number] - 1] == line for number, line in enumerate(before, 1))
    assert ast.dump(ast.parse(text)) == ast.dump(ast.parse(NODE))


def test_only_names_of_the_function_itself_are_other_ones():
    lines = renamed(NODE).splitlines()
    assert lines[5] == "        name_too = 'x'"
    assert lines[8] == "            self.say(name_too, f'{part}')"
    assert lines[11:13] == ["        count_too = self.count = len(name)", "        print(count_too, name=count_too)"]
    assert lines[15] == "        return [name_too for name_too in self.names]"


def test_methods_the_other_way_around():
    text, now = reordered(NODE)
    names = [part.name for part in ast.parse(text).body[0].body if isinstance(part, ast.FunctionDef)]
    assert names == ["stop", "say", "__init__"]
    before, after = NODE.splitlines(), text.splitlines()
    assert all(after[now[number] - 1] == line for number, line in enumerate(before, 1))


def test_decorated_methods_stay_where_they_are():
    text = NODE.replace("    def say", "    @property\n    def say")
    assert reordered(text)[0] == text
