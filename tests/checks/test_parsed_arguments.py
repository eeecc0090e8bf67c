"""API002: what code asks the arguments for that a parser of argparse has made."""

from __future__ import annotations

import pytest

from checks.judging import Judge

PROGRAM = """
    import argparse

    import rclpy
    from rclpy.node import Node

    class Robot(Node):
        def __init__(self, path):
            super().__init__('robot')
            self.path = path

    def main():
        parser = argparse.ArgumentParser(description='Drives.')
        parser.add_argument('folder')
        parser.add_argument('-l', '--log-file', default='log')
        parser.add_argument('--rate', '-r', type=float, dest='hertz')
        parser.add_argument('-v', action='store_true')
        {more}
        args = parser.parse_args({given})
        rclpy.init()
        {line}

    if __name__ == '__main__':
        main()
"""


def program(line: str, more: str = "pass", given: str = "") -> str:
    return PROGRAM.format(line=line, more=more, given=given)


@pytest.mark.parametrize(
    ("line", "name", "near"),
    [
        ("rclpy.spin(Robot(args.logfile))", "logfile", "; did you mean 'log_file'?"),
        ("rclpy.spin(Robot(args.foldr))", "foldr", "; did you mean 'folder'?"),
        ("print(args.rate)", "rate", ""),
        ("print(args.verbose)", "verbose", ""),
        ("print(args.l)", "l", ""),
    ],
)
def test_an_argument_that_the_parser_does_not_set(judge: Judge, line: str, name: str, near: str):
    (finding,) = judge("API002", program(f"{line}  # here"))
    assert finding.message == (
        f"what parse_args() returns has no '{name}': this line fails with an AttributeError{near}"
    )


def test_the_arguments_that_a_parser_leaves_others(judge: Judge):
    source = program("print(args.rate, others)  # here").replace(
        "args = parser.parse_args()", "args, others = parser.parse_known_args()"
    )
    judge("API002", source)


@pytest.mark.parametrize(
    ("line", "more", "given"),
    [
        ("print(args.folder, args.log_file, args.hertz, args.v)", "pass", ""),
        ("print(args.__dict__)", "pass", ""),
        ("print(args.verbose)", "add_common(parser)", ""),
        ("print(args.verbose)", "parser.set_defaults(verbose=True)", ""),
        ("print(args.verbose)", "sub = parser.add_subparsers()", ""),
        ("print(args.verbose)", "parser.add_argument(*FLAGS)", ""),
        ("print(args.verbose)", "parser.add_argument(NAME)", ""),
        ("print(args.verbose)", "pass", "namespace=SETTINGS"),
        ("args.verbose = True; print(args.verbose)", "pass", ""),
        ("setattr(args, 'verbose', True); print(args.verbose)", "pass", ""),
        ("args = load(args); print(args.verbose)", "pass", ""),
    ],
)
def test_arguments_that_may_be_there(judge: Judge, line: str, more: str, given: str):
    judge("API002", program(line, more, given))


def test_a_try_that_expects_it(judge: Judge):
    line = "try:\n            print(args.verbose)\n        except AttributeError:\n            pass"
    judge("API002", program(line))
