"""Functions and methods of Python whose result is known where what they are given is."""

from __future__ import annotations

import pytest

from launching import names


@pytest.mark.parametrize(
    ("expression", "text"),
    [
        ("str(['a', 'b', 'c'].index('b'))", "1"),
        ("str(('a', 'b').index(os.environ['NAME']))", "?"),
        ("str([os.environ['NAME'], 'b'].index('b'))", "?"),
        ("str(['a'].index('b'))", "?"),
        ("str(['a', 'b', 'a'].count('a'))", "2"),
        ("str(['a', os.environ['NAME']].count('a'))", "?"),
        ("str(divmod(7, 3)[0]) + str(divmod(7, 3)[1])", "21"),
        ("str(divmod(7, 0)[0])", "?"),
        ("str(round(2.567, 1))", "2.6"),
        ("str(round(float(os.environ['RATE'])))", "?"),
        ("Path('/a/b/c.tar.gz').stem", "c.tar"),
        ("Path('/a/b/c.yaml').name + Path('/a/b/c.yaml').suffix", "c.yaml.yaml"),
        ("str(Path('/a/b/c.yaml').parents[1])", "/a"),
        ("str(len(Path('/a/b/c.yaml').parents))", "3"),
        ("f\"{list((1, 'a'))} {(2,)} {[]}\"", "[1, 'a'] (2,) []"),
        ("str([os.environ['NAME']])", "?"),
        ("str({1, 2})", "?"),
        ("str(len(Path(__file__).parents))", "?"),  # nobody knows where the workspace is
    ],
)
def test_results(launches, expression: str, text: str):
    before = f"from pathlib import Path\nname = {expression}"
    assert names(launches.python("[Node(package='robot', executable='talker', name=name)]", before)) == [text]
