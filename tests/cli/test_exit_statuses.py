"""What the exit status says, and what goes to standard output and what to standard error."""

from __future__ import annotations

import errno
import json
from pathlib import Path

import pytest

from archlint.cli import check as check_command
from archlint.cli import main
from archlint.engine.pipeline import NothingToDo, Request
from archlint.finding import Finding, Place, Severity
from archlint.report.model import Report, summarise
from archlint.systems.model import System


def finding(severity: Severity, code: str = "OWN001", name: str = "multiple-publishers") -> Finding:
    return Finding(code, name, severity, "two nodes publish /cmd_vel", Place("a.py", 1, 1, 1, 2))


ERROR = finding(Severity.ERROR)
WARNING = finding(Severity.WARNING)
INFO = finding(Severity.INFO)
UNREADABLE = finding(Severity.WARNING, "LNT002", "unreadable-file")
FAILURE = finding(Severity.ERROR, "LNT003", "internal-error")


class Run:
    """A session that finds what a test says, and remembers what it was asked."""

    def __init__(self) -> None:
        self.findings: list[Finding] = []
        self.notices: list[str] = []
        self.raises: BaseException | None = None
        self.request: Request | None = None

    def __call__(self, request: Request, shown: list[System] | None = None) -> Report:
        self.request = request
        if self.raises is not None:
            raise self.raises
        summary = summarise(self.findings, files=2, nodes=1, suppressed=0, unresolved=0, elapsed_s=0.1)
        return Report(self.findings, summary, lambda file, line: "x = 1", self.notices)


@pytest.fixture
def run(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Run:
    fake = Run()
    monkeypatch.setattr(check_command, "check", fake)
    monkeypatch.chdir(tmp_path)
    return fake


@pytest.mark.parametrize(
    ("findings", "options", "status"),
    [
        ([], [], 0),
        ([INFO], [], 0),
        ([WARNING], [], 1),
        ([ERROR], [], 1),
        ([WARNING, ERROR, INFO], [], 1),
        ([INFO], ["--severity", "info"], 1),
        ([WARNING], ["--severity", "error"], 0),
        ([ERROR], ["--severity", "error"], 1),
        ([UNREADABLE], [], 1),
        ([ERROR], ["--exit-zero"], 0),
        ([FAILURE], [], 2),
        ([FAILURE], ["--exit-zero"], 2),
        ([ERROR] * 300, [], 1),
    ],
)
def test_what_was_found_decides(run: Run, findings: list[Finding], options: list[str], status: int):
    run.findings = findings
    assert main(["check", *options]) == status


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--slect", "SRV"], "unrecognized arguments: --slect; did you mean --select?"),
        (["--select", "SRV03"], "--select: unknown rule `SRV03`; did you mean SRV003?"),
        (
            ["--ignore", "OWN001,nested-servce-call"],
            "--ignore: unknown rule `nested-servce-call`; did you mean",
        ),
        (["--extend-select", "XYZ"], "--extend-select: unknown rule `XYZ`"),
        (["--format", "xml"], "argument --format: invalid choice: 'xml'"),
        (["--output", "sarif"], "argument --output: must be FORMAT=FILE"),
        (
            ["--output", "html=a.html"],
            "argument --output: must be FORMAT=FILE with a format of text, concise",
        ),
        (["--severity", "fatal"], "argument --severity: invalid choice: 'fatal'"),
        (["--jobs", "0"], "argument --jobs: must be a number of at least 1, not 0"),
        (["--config", "no.toml"], "no.toml: cannot be read: No such file or directory"),
        (["--config", "a.toml", "--isolated"], "not allowed with argument"),
        (["nowhere"], "no such file or directory: nowhere"),
        (["chek"], "no such file or directory: chek; did you mean the command `check`?"),
        (["-o", "no/such/folder/out.txt"], "cannot write no/such/folder/out.txt: No such file or directory"),
    ],
)
def test_a_job_that_cannot_be_done_ends_with_2_and_a_reason(
    run: Run, capsys: pytest.CaptureFixture[str], arguments: list[str], message: str
):
    assert main(["check", *arguments]) == 2
    shown = capsys.readouterr()
    assert shown.out == ""
    assert "Traceback" not in shown.err
    assert message in shown.err


def test_a_wrong_configuration_ends_with_2_and_its_line(run: Run, capsys: pytest.CaptureFixture[str]):
    Path("archlint.toml").write_text("selct = []\n")
    assert main([]) == 2
    assert "archlint.toml:1: unknown key `selct`; did you mean `select`?" in capsys.readouterr().err
    assert main(["--isolated"]) == 0


def test_nothing_to_check_is_not_success(run: Run, capsys: pytest.CaptureFixture[str]):
    run.raises = NothingToDo("no Python file under .")
    assert main(["."]) == 2
    assert capsys.readouterr() == ("", "archlint: error: no Python file under .\n")


def test_an_error_of_ours_is_told_in_short(run: Run, capsys: pytest.CaptureFixture[str]):
    run.raises = KeyError("gone")
    assert main(["check"]) == 2
    told = capsys.readouterr().err
    assert "internal error: KeyError: 'gone'" in told
    assert "Please report it" in told
    assert "Traceback" not in told
    assert main(["check", "--verbose"]) == 2
    assert "Traceback" in capsys.readouterr().err


def test_an_interrupted_run_says_nothing(run: Run, capsys: pytest.CaptureFixture[str]):
    run.raises = KeyboardInterrupt()
    assert main(["check"]) == 130
    assert capsys.readouterr() == ("", "")


def test_a_reader_that_goes_away_is_no_error(run: Run, capsys: pytest.CaptureFixture[str]):
    run.raises = BrokenPipeError(errno.EPIPE, "Broken pipe")
    assert main(["check"]) == 141
    assert capsys.readouterr() == ("", "")


@pytest.mark.parametrize(
    ("arguments", "paths"),
    [
        ([], (".",)),
        (["check"], (".",)),
        (["pkg"], ("pkg",)),
        (["check", "pkg", "b.py"], ("pkg", "b.py")),
        (["--quiet", "pkg"], ("pkg",)),
        (["pkg", "--select", "SRV", "b.py"], ("pkg", "b.py")),
    ],
)
def test_without_a_command_it_checks(run: Run, arguments: list[str], paths: tuple[str, ...]):
    Path("pkg").mkdir()
    Path("b.py").touch()
    assert main(arguments) == 0
    assert run.request is not None
    assert run.request.paths == paths


def test_the_command_line_is_the_last_layer_of_the_configuration(run: Run):
    Path("archlint.toml").write_text('ignore = ["SRV003"]\ndistro = "jazzy"')
    assert main(["--select", "SRV003,own", "--select", "TMO001", "--jobs", "3", "--no-cache"]) == 0
    assert run.request is not None
    settings = run.request.settings
    assert settings.distro == "jazzy"
    assert {"SRV003", "OWN001", "OWN002", "TMO001"} <= settings.selection.always
    assert "TMO002" not in settings.selection.always
    assert settings.origins["select"] == "command line"
    assert (run.request.jobs, run.request.cached) == (3, False)


def test_findings_go_to_standard_output_and_all_else_to_standard_error(run: Run, capsys: pytest.CaptureFixture[str]):
    run.findings, run.notices = [ERROR, WARNING], ["a bare ignore"]
    assert main(["--format", "concise"]) == 1
    assert capsys.readouterr() == (
        "a.py:1:1: error: OWN001 two nodes publish /cmd_vel\na.py:1:1: warning: OWN001 two nodes publish /cmd_vel\n",
        "archlint: warning: a bare ignore\nFound 1 error, 1 warning in 2 files with 1 node.\n",
    )


def test_a_quiet_run_tells_findings_only(run: Run, capsys: pytest.CaptureFixture[str]):
    run.findings, run.notices = [ERROR], ["a bare ignore"]
    assert main(["--quiet", "--format", "concise"]) == 1
    assert capsys.readouterr() == ("a.py:1:1: error: OWN001 two nodes publish /cmd_vel\n", "")


def test_machines_are_told_nothing_but_the_findings(run: Run, capsys: pytest.CaptureFixture[str]):
    for format in ("json", "sarif", "gitlab", "junit"):
        assert main(["--format", format]) == 0
        assert capsys.readouterr().err == ""


def test_several_formats_of_one_run(run: Run, capsys: pytest.CaptureFixture[str]):
    run.findings = [ERROR]
    assert main(["-o", "a.txt", "--format", "concise", "--output", "json=b.json", "--output", "sarif=c.sarif"]) == 1
    assert capsys.readouterr().out == ""
    assert Path("a.txt").read_text() == "a.py:1:1: error: OWN001 two nodes publish /cmd_vel\n"
    assert Path("b.json").read_text().startswith('{\n "version": 1')
    assert '"version": "2.1.0"' in Path("c.sarif").read_text()
    assert sorted(path.name for path in Path().iterdir()) == ["a.txt", "b.json", "c.sarif"]


def test_an_old_result_stays_where_the_new_one_cannot_be_made(run: Run):
    Path("out.json").write_text("old")
    run.raises = KeyError("gone")
    assert main(["--format", "json", "-o", "out.json"]) == 2
    assert Path("out.json").read_text() == "old"


def test_a_file_that_is_a_link_stays_one(run: Run):
    Path("real").mkdir()
    Path("out.txt").symlink_to("real/out.txt")
    assert main(["-o", "out.txt"]) == 0
    assert Path("out.txt").is_symlink()
    assert Path("real/out.txt").is_file()


def test_what_is_told_cannot_steer_the_terminal(run: Run, capsys: pytest.CaptureFixture[str]):
    assert main(["--select", "\x1b[31mX"]) == 2
    assert "\x1b" not in capsys.readouterr().err


def test_a_part_of_the_findings_ends_as_all_of_them(run: Run, capsys: pytest.CaptureFixture[str]):
    run.findings = [WARNING, ERROR]
    assert main(["--format", "concise", "--max", "1", "--severity", "error", "--output", "json=all.json"]) == 1
    shown = capsys.readouterr()
    assert shown.out == "a.py:1:1: error: OWN001 two nodes publish /cmd_vel\n"
    assert shown.err.startswith("Shown: the 1 most important of 2 findings; 1 more without --max.\n")
    assert len(json.loads(Path("all.json").read_text("utf-8"))["diagnostics"]) == 2


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        ("--format json --max 3", "--max is for text and concise: json has all findings, in its own order"),
        ("--format github --group-by rule", "--group-by is for text and concise"),
        ("--max 3 --statistics", "--max does not go together with --statistics"),
        ("--group-by colour", "argument --group-by: invalid choice: 'colour' (choose from rule, package, node, file)"),
        ("--max 0", "argument --max: must be a number of at least 1, not 0"),
    ],
)
def test_machines_get_all_findings(run: Run, capsys: pytest.CaptureFixture[str], words: str, reason: str):
    assert main(["check", *words.split()]) == 2
    assert reason in capsys.readouterr().err
