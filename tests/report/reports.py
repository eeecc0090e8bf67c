"""Reports for the tests of this folder."""

from __future__ import annotations

from archlint.finding import Edit, Finding, Fix, Place, Related, Severity
from archlint.report.model import Report, summarise

SOURCES = {
    "pkg/node.py": """\
class Planner(Node):
    def __init__(self):
        super().__init__('planner')
        self.map = self.create_client(GetMap, 'map')
        self.create_service(Plan, 'plan', self.on_plan)

    def on_plan(self, request, response):
        answer = self.map.call(GetMap.Request())
        response.map = answer.map
        return response
""",
    "pkg/main.py": "rclpy.spin(node)\n",
}


def source_line(file: str, line: int) -> str | None:
    lines = SOURCES.get(file, "").splitlines()
    return lines[line - 1] if 0 < line <= len(lines) else None


NESTED = Finding(
    code="SRV003",
    name="nested-service-call",
    severity=Severity.ERROR,
    message="the handler of /plan waits for /map",
    place=Place("pkg/node.py", 8, 18, 8, 49),
    help="use call_async",
    node="/planner",
    related=(
        Related(Place("pkg/node.py", 4, 20, 4, 53), "the client is created here"),
        Related(Place("pkg/main.py", 1, 1, 1, 17), "one thread spins the node"),
    ),
    identity=("/planner", "/map"),
)

UNREADABLE = Finding(
    code="LNT002",
    name="unreadable-file",
    severity=Severity.WARNING,
    message="syntax error: expected ':'",
    place=Place("pkg/broken.py", 3, 1, 3, 1),
)

SAFE = Finding(
    code="LNT001",
    name="unused-suppression",
    severity=Severity.WARNING,
    message="it hides nothing",
    place=Place("pkg/node.py", 2, 1, 2, 5),
    fix=Fix("safe", (Edit(Place("pkg/node.py", 2, 1, 2, 5), ""),)),
)

UNSAFE = Finding(
    code="TMO001",
    name="wait-without-timeout",
    severity=Severity.WARNING,
    message="it waits without a timeout",
    place=Place("pkg/node.py", 4, 20, 4, 53),
    fix=Fix("unsafe", (Edit(Place("pkg/node.py", 4, 53, 4, 53), "timeout_sec=5.0"),)),
)


def report(*findings: Finding, sources: dict[str, str] | None = None) -> Report:
    def line_of(file: str, line: int) -> str | None:
        if sources is None:
            return source_line(file, line)
        lines = sources.get(file, "").split("\n")
        return lines[line - 1] if 0 < line <= len(lines) else None

    summary = summarise(findings, files=42, nodes=21, suppressed=1, unresolved=2, elapsed_s=0.4123)
    return Report(findings, summary, line_of)
