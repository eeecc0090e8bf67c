"""What rcl reads of unquoted texts; each row was asked of the running rcl of jazzy, as a parameter file."""

from __future__ import annotations

import pytest

from archlint.syntax.safe_yaml import plain_scalar

INFINITE = float("inf")


@pytest.mark.parametrize(
    ("text", "value"),
    [
        *((text, True) for text in ("y", "Y", "yes", "Yes", "on", "TRUE")),
        *((text, False) for text in ("n", "N", "no", "off", "False")),
        *((text, text) for text in ("yEs", "oN", "tRue")),
        *(("-0", 0), ("+5", 5), ("0777", 511), ("-017", -15), ("0x10", 16), ("0X10", 16)),
        *(("9223372036854775807", 2**63 - 1), ("-9223372036854775808", -(2**63)), ("9223372036854775808", 2.0**63)),
        *(("08", 8.0), ("09.5", 9.5), ("1.", 1.0), (".5", 0.5), ("1e5", 100000.0), ("1.e3", 1000.0)),
        *(("0x1p3", 8.0), ("0x1.8", 1.5), ("0x.8", 0.5)),
        *((text, INFINITE) for text in ("inf", "+Inf", "INF", "infinity", ".inf", ".Inf", "+.INF")),
        *(("-inf", -INFINITE), ("-Infinity", -INFINITE), ("-.inf", -INFINITE)),
        *((text, text) for text in (".iNf", ".nAn", "+.nan", "0o17", "0b11", "0x", "1_000", "1:30", "e3", "0.1e")),
        *((text, text) for text in ("1e400", "-1e400", "1e-400")),
    ],
)
def test_a_plain_text(text: str, value: object):
    read = plain_scalar(text)
    assert read == value and type(read) is type(value)


@pytest.mark.parametrize("text", ["nan", "-nan", "NaN", "NAN", ".nan", ".NaN", ".NAN"])
def test_no_number(text: str):
    read = plain_scalar(text)
    assert isinstance(read, float) and read != read
