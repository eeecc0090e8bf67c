"""The text format on a terminal: as wide as that is."""

from __future__ import annotations

from dataclasses import replace

import pytest
from reports import NESTED, SAFE, report

from archlint import cells
from archlint.finding import Place, Severity
from archlint.report import render


def on_terminal(columns: int, *findings: object, source: str | None = None) -> list[str]:
    sources = None if source is None else {"pkg/node.py": source}
    return render("text", report(*findings, sources=sources), columns=columns).splitlines()


def test_messages_and_help_continue_below_themselves():
    long = replace(
        NESTED,
        message="the handler of /plan waits for /map and for nothing else",
        help="use call_async and await it",
        related=(),
    )
    assert on_terminal(60, long) == [
        "error[SRV003] nested-service-call: the handler of /plan",
        "    waits for /map and for nothing else",
        " --> pkg/node.py:8:18",
        "  |",
        "7 |     def on_plan(self, request, response):",
        "8 |         answer = self.map.call(GetMap.Request())",
        "  |                  ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^",
        "9 |         response.map = answer.map",
        "  |",
        "  = help: use call_async and await it",
    ]


def test_a_related_message_without_room_beside_its_place_stands_below_it():
    lines = on_terminal(60, NESTED)
    at = next(number for number, line in enumerate(lines) if "-----" in line)
    assert lines[at : at + 2] == [
        "  |                    ---------------------------------",
        "  |                    the client is created here",
    ]


@pytest.mark.parametrize("columns", [36, 40, 60, 80, 120])
def test_no_line_is_wider_than_the_terminal(columns: int):
    source = NESTED_SOURCE.replace("map", "机器人地图")
    finding = replace(NESTED, message="the service '机器人' waits " * 6, help="等待服务器的时候不要阻塞执行器。" * 4)
    lines = on_terminal(columns, finding, source=source)
    assert max(cells.width(line) for line in lines if "-->" not in line) <= columns


NESTED_SOURCE = "".join(f"        self.map_{number} = self.map(map, 'map')  # map map map map\n" for number in range(9))


def test_the_underlined_part_of_a_long_line_of_wide_characters_is_seen():
    source = "\n" * 7 + "x" * 90 + "机" * 20 + "WRONG" + "器" * 90
    finding = replace(NESTED, place=Place("pkg/node.py", 8, 111, 8, 116), related=())
    lines = on_terminal(60, finding, source=source)
    code, marks = (line for line in lines if "WRONG" in line or "^" in line)
    assert cells.width(code[: code.index("WRONG")]) == marks.index("^^^^^")


def test_without_a_terminal_nothing_is_wrapped():
    long = replace(NESTED, message="word " * 60)
    assert "word " * 60 in render("text", report(long)).splitlines()[0]


def test_a_safe_fix_is_marked():
    assert on_terminal(80, SAFE)[0] == "warning[LNT001] [*] unused-suppression: it hides nothing"


def test_errors_come_last_on_a_terminal_and_stay_in_the_order_of_the_files_in_a_pipe():
    note = replace(NESTED, severity=Severity.INFO, code="TMO004", place=Place("pkg/z.py", 1, 1, 1, 2), related=())
    warning = replace(note, severity=Severity.WARNING, code="TMO001")
    findings = [replace(NESTED, related=()), warning, note]
    heads = [
        line.split("]")[0] for line in on_terminal(80, *findings) if line.split("[")[0] in ("info", "warning", "error")
    ]
    assert heads == ["info[TMO004", "warning[TMO001", "error[SRV003"]
    piped = render("text", report(*findings)).splitlines()
    assert [line[:4] for line in piped if line.startswith(("info[", "warn", "erro"))] == ["erro", "warn", "info"]
