"""PKG010: options of a setup.cfg that are written with a dash."""

from __future__ import annotations

import pytest

OLD = "[develop]\nscript-dir=$base/lib/robot\n[install]\ninstall-scripts=$base/lib/robot\n"


def test_the_old_template(findings):
    (finding,) = findings("PKG010", **{"setup.cfg": OLD})
    assert finding.message == (
        "'script-dir' has a dash: setuptools warns of it at each build, and says that it will refuse it; another "
        "option of the file has one, too"
    )
    assert finding.help == "write 'script_dir'"
    assert [row.place.line for row in (finding, *finding.related)] == [2, 4]


@pytest.mark.parametrize(
    "text",
    [
        OLD.replace("-dir", "_dir").replace("-scripts", "_scripts"),
        "[flake8]\nmax-line-length = 99\n",
        "[tool:pytest]\njunit-family = xunit2\n",
        "# script-dir=$base\n",
    ],
)
def test_underscores_and_other_tools(findings, text):
    assert findings("PKG010", **{"setup.cfg": text}) == []
