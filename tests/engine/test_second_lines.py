"""Findings about what no run comes to, since another finding says that a line before it always fails."""

from __future__ import annotations

from pathlib import Path
from textwrap import dedent, indent

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check

ALL = ("API001", "API002", "API005", "EXE015", "EXE016", "MSG003")


def told(folder: Path, source: str, codes: tuple[str, ...] = ALL) -> list[str]:
    """The codes of what is found, which has to be at the lines that end in ``# here``."""
    text = dedent(source).lstrip("\n")
    (folder / "node.py").write_text(text, encoding="utf-8")
    (folder / "archlint.toml").write_text(f"select = {[*codes]!r}\n".replace("'", '"'), encoding="utf-8")
    report = check(Request((str(folder),), load(folder), cached=False, jobs=1))
    found = sorted((one.place.line, one.code) for one in report.findings)
    marked = [line for line, row in enumerate(text.splitlines(), 1) if row.endswith("# here")]
    assert [line for line, _ in found] == marked, found
    return [code for _, code in found]


TALKER = """
    from contextlib import suppress

    import rclpy
    from rclpy.node import Node


    class Talker(Node):
        def __init__(self):
            super().__init__('talker')

        def close(self, speed):
            pass


    def main():
        rclpy.init()
        talker = Talker()
        try:
            rclpy.spin(talker)
        except KeyboardInterrupt:
            pass
{end}


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(
    "end",
    [
        """
        finally:
            talker.close()  # here
            rclpy.shutdown()
        """,
        """
        talker.close()  # here
        rclpy.shutdown()
        """,
        # both ways fail
        """
        if talker.context.ok():
            talker.close()  # here
        else:
            talker.clsoe()  # here
        rclpy.shutdown()
        """,
    ],
)
def test_the_end_behind_a_line_that_fails(tmp_path: Path, end: str) -> None:
    source = TALKER.format(end=indent(dedent(end).strip("\n"), " " * 8))
    told(tmp_path, source)
    mended = source.replace("close()  # here", "close(1.0)").replace("talker.clsoe()  # here", "pass")
    told(tmp_path, mended.replace("shutdown()", "shutdown()  # here"))


@pytest.mark.parametrize(
    "end",
    [
        """
        if talker.context.ok():
            talker.close()  # here
        rclpy.shutdown()  # here
        """,
        """
        try:
            talker.close()  # here
        except Exception as error:
            pass
        rclpy.shutdown()  # here
        """,
        """
        with suppress(TypeError):
            talker.close()  # here
        rclpy.shutdown()  # here
        """,
        """
        for each in talker.timers:
            talker.close()  # here
        rclpy.shutdown()  # here
        """,
        """
        closed = talker.timers and talker.close()  # here
        rclpy.shutdown()  # here
        """,
        """
        closed = talker.close() if talker.timers else None  # here
        rclpy.shutdown()  # here
        """,
        """
        later = lambda: talker.close()  # here
        rclpy.shutdown()  # here
        """,
        """
        talker.close()  # archlint: ignore[API001]: a subclass takes none
        rclpy.shutdown()  # here
        """,
    ],
)
def test_ends_that_may_be_reached(tmp_path: Path, end: str) -> None:
    told(tmp_path, TALKER.format(end=indent(dedent(end).strip("\n"), " " * 8)))


def test_two_lines_are_two_mistakes(tmp_path: Path) -> None:
    end = """
        talker.close()  # here
        talekr.close(1.0)  # here
        rclpy.shutdown()
    """
    source = TALKER.format(end=indent(dedent(end).strip("\n"), " " * 8))
    assert told(tmp_path, source) == ["API001", "API005"]


def test_an_except_to_which_a_line_before_keeps_every_run_from_coming(tmp_path: Path) -> None:
    source = """
        import rclpy


        def main(args=None):
            rclpy.init(args=args)
            try:
                with open(self.path) as file:  # here
                    data = file.read()
            except {caught}:
                print('no file')
            print(data){mark}


        main()
    """
    assert told(tmp_path, source.format(caught="OSError", mark="")) == ["API005"]
    told(tmp_path, source.format(caught="(NameError, OSError)", mark="").replace("  # here", ""))
    told(tmp_path, source.format(caught="Exception", mark="  # here"))


@pytest.mark.parametrize(("tells", "mark"), [("noted(error)  # here", ""), ("print(error)", "  # here")])
def test_an_except_that_fails_itself(tmp_path: Path, tells: str, mark: str) -> None:
    source = f"""
        import rclpy


        def main(args=None):
            rclpy.init(args=args)
            try:
                data = open('robot.yaml').read()
            except OSError as error:
                {tells}
            print(data){mark}


        main()
    """
    told(tmp_path, source)


CALLED = """
    import rclpy


    def send(speed):
        rest(speed)


    def rest(speed):
        slepe(speed){rest}


    def stop(speed):
        halt(speed)  # here


    if __name__ == '__main__':
        rclpy.init(){before}
        rate = Rate(10)  # here
        send(rate)
        stop(rate)


    def on_exit():
        stop(0.0)


    rclpy.get_default_context().on_shutdown(on_exit)
"""


def test_functions_that_are_called_from_such_lines_alone(tmp_path: Path) -> None:
    told(tmp_path, CALLED.format(rest="", before=""))
    told(tmp_path, CALLED.format(rest="  # here", before="\n        rest(1.0)"))


def test_functions_that_other_files_name(tmp_path: Path) -> None:
    (tmp_path / "other.py").write_text("import rclpy\nfrom node import rest\n\nrclpy.init()\nrest(1.0)\n")
    told(tmp_path, CALLED.format(rest="  # here", before=""))


AT_THE_END = """
    import rclpy
    from rclpy.node import Node


    class Robot(Node):
        def __init__(self):
            super().__init__('robot')
            {last}

        def drive(self):
            while True:
                rclpy.spin_once(self)


    def main():
        rclpy.init()
        robot = Robot()
        {lines}


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(
    "lines",
    [
        ("rclpy.spin(robot)", "robot.destroy()"),
        ("rclpy.spin(robot)", "if rclpy.ok():", "    robot.destroy()"),
        ("try:", "    rclpy.spin(robot)", "finally:", "    robot.destroy()  # here"),
        ("try:", "    rclpy.spin(robot)", "except KeyboardInterrupt:", "    pass", "robot.destroy()  # here"),
        ("rclpy.spin_once(robot)", "robot.destroy()  # here"),
    ],
)
def test_lines_behind_a_spin_that_only_an_exception_ends(tmp_path: Path, lines: tuple[str, ...]) -> None:
    source = AT_THE_END.replace("{lines}", "\n        ".join(lines))
    told(tmp_path, source.replace("{last}", "self.create_timer(1.0, self.drive)"), ("API002",))


def test_lines_behind_a_spin_that_a_line_of_the_program_ends(tmp_path: Path) -> None:
    ended = AT_THE_END.replace("rclpy.spin_once(self)", "rclpy.shutdown()").replace("{last}", "pass")
    told(tmp_path, ended.replace("{lines}", "rclpy.spin(robot)\n        robot.destroy()  # here"), ("API002",))


def test_lines_behind_a_constructor_that_never_returns(tmp_path: Path) -> None:
    source = AT_THE_END.replace("{lines}", "robot.destroy(){mark}")
    told(tmp_path, source.replace("{last}", "self.drive()").replace("{mark}", ""), ("API002",))
    told(tmp_path, source.replace("{last}", "pass").replace("{mark}", "  # here"), ("API002",))


ASKS = """
    import rclpy
    from rclpy.node import Node
    from std_srvs.srv import Empty


    class Asks(Node):
        def __init__(self):
            super().__init__('asks')
            self.client = self.create_client(Empty, 'go')
            {wait}  # here


    def main():
        rclpy.init()
        rclpy.spin(Asks())


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(
    ("wait", "codes"),
    [
        ("self.client.wait_for_service(timeout=10)", ["API001"]),
        ("self.client.wait_for_service()", ["TMO001"]),
    ],
)
def test_a_call_that_always_fails_waits_for_nothing(tmp_path: Path, wait: str, codes: list[str]):
    assert told(tmp_path, ASKS.format(wait=wait), ("API001", "TMO001")) == codes
