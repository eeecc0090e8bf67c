"""What a shell offers for the values of options, and the script that makes it do so, which shtab writes."""

from __future__ import annotations

import argparse
from collections.abc import Mapping

import shtab

from archlint.cli.all_options import commands_of, whole_parser
from archlint.rulebook import Rule, rules

_FIND = (
    "find . -maxdepth 8 \\( -name '.?*' -o -name build -o -name install -o -name log \\) -prune "
    "-o -type f -name '*.launch*' -print 2>/dev/null | sed 's|^\\./||' | sort"
)
"""Lists the launch files of a workspace: they lie deep in it."""
_LAUNCH_FILES = {"bash": "_archlint_launch_files", "zsh": "_archlint_launch_files", "fish": f"({_FIND})"}
_RULES = {"bash": "_archlint_rules", "zsh": "_archlint_rules", "fish": "(_archlint_rules)"}
_COMPLETERS: Mapping[str, object] = {
    "paths": shtab.FILE,
    "path": shtab.FILE,
    "base": shtab.FILE,
    "head": shtab.FILE,
    "file": shtab.FILE,
    "config": shtab.FILE,
    "baseline": shtab.FILE,
    "observed": shtab.FILE,
    "cache_dir": shtab.DIRECTORY,
    "facts": shtab.DIRECTORY,
    "folder": shtab.DIRECTORY,
    "launch": _LAUNCH_FILES,
    "select": _RULES,
    "extend_select": _RULES,
    "ignore": _RULES,
    "rule": _RULES,
}
"""By the names under which the options are kept."""


def script(shell: str) -> str:
    """The script for one of the shells of shtab."""
    parser = whole_parser()
    for command in commands_of(parser).values():
        for action in command._actions:
            if action.dest in _COMPLETERS and action.nargs != 0:
                action.complete = _COMPLETERS[action.dest]  # type: ignore[attr-defined]
            _shorten(action)
    text: str = shtab.complete(parser, shell, root_prefix="archlint", preamble=_PREAMBLES[shell](rules()))
    return text


def _shorten(action: argparse.Action) -> None:
    """A help line beside an option is one line, and zsh takes brackets, colons and quotes for its own."""
    if isinstance(action.metavar, tuple):
        action.metavar = action.metavar[0]
    if action.help is not None and action.help is not argparse.SUPPRESS:
        words = action.help.replace("[", "(").replace("]", ")").replace("`", "").replace('"', "").replace("$", "")
        action.help = words.partition(";")[0].replace(":", " -")


def _selectors(book: Mapping[str, Rule]) -> dict[str, str]:
    """What an option for rules takes, with what it is: families, codes."""
    families = {code[:3] for code in book}
    return {"ALL": "all rules", **{family: f"all rules {family}" for family in sorted(families)}} | {
        code: rule.name for code, rule in sorted(book.items())
    }


def _bash(book: Mapping[str, Rule]) -> str:
    return f"""\
_archlint_rules() {{  # after the last comma
  local before=""
  [[ $1 == *,* ]] && before="${{1%,*}},"
  compgen -P "$before" -W "{" ".join(_selectors(book))}" -- "${{1##*,}}"
}}
_archlint_launch_files() {{
  local IFS=$'\\n'
  compgen -W "$({_FIND})" -- "$1"
}}
"""


def _zsh(book: Mapping[str, Rule]) -> str:
    rows = "\n".join(f"    '{code}[{name}]' \\" for code, name in _selectors(book).items())
    return f"""\
_archlint_rules() {{
  _values -s , rule \\
{rows}
    && return
}}
_archlint_launch_files() {{
  local -a files
  files=(${{(f)"$({_FIND})"}})
  compadd -a files
}}
"""


def _fish(book: Mapping[str, Rule]) -> str:
    rows = "\n".join(f"    '{code}\t{name}' \\" for code, name in _selectors(book).items())
    return f"""\
function _archlint_rules
  set -l before (string match -r '.*,' -- (commandline -ct))
  printf "$before%s\\n" \\
{rows}
    ;
end
"""


_PREAMBLES = {"bash": _bash, "zsh": _zsh, "fish": _fish}

__all__ = ["script"]
