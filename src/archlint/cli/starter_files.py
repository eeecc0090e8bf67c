"""The configuration that ``archlint init`` writes.

In it a comment that starts with ``# `` is prose, and one that starts with ``#`` alone is a setting to
switch on.
"""

from __future__ import annotations

import json
from collections.abc import Sequence

from archlint.records import dataclass

BASELINE = "archlint-baseline.txt"
ATTRIBUTES = f"{BASELINE} merge=union"
"""What `.gitattributes` says of the baseline: after a merge it has the lines of both sides."""


@dataclass(frozen=True)
class Seen:
    """What the comments of a configuration take from a workspace."""

    distro: str | None = None
    """The distribution of this shell, where there is one."""
    launch_files: Sequence[str] = ()
    """Paths from the folder of the configuration."""
    owners: Sequence[tuple[str, str]] = ()
    """Topics that one node publishes and others read, each with that node."""


_CONFIGURATION = """\
# What archlint checks here.  `archlint config` prints all values and where each comes from, `archlint rules` lists the
# rules, and `archlint explain CODE` prints the page of one.  To switch on a line that starts with #, remove the #.

# The ROS distribution to judge for; {why}.
{distro}

# The findings that are there already are held back: only what is new fails.  `archlint check --no-baseline` shows them
# all, `archlint check --prune-baseline` removes what is mended, and `archlint check --write-baseline` writes the file.
{held}baseline = "{baseline}"

# Where to start from.  "course": errors fail, warnings only inform.  "team": errors and warnings fail, and a
# suppression needs a reason.  "safety": every finding fails, and most rules that are off by default run.
#preset = "team"

# Rules by code, prefix, name or "ALL".  NME, for example, are the rules about names.
#extend-select = ["NME"]
#ignore = ["OWN001"]

# Folders and files that are not checked.
#exclude = ["**/experimental/**"]

# The launch files that are systems of their own; unset: all of them.
#launch = [{launch}]

# Names that other machines or C++ packages provide.
#external = ["/joint_states"]

# Whether nothing outside this workspace takes part: then a topic that nobody publishes is a finding.
#closed-world = true

# How much a finding of a rule weighs; errors and warnings fail `archlint check`.
[severity]
#NME001 = "info"

# Rules that are off for some files or packages.
[per-file-ignores]
#"**/test/**" = ["TMO"]

[per-package-ignores]
#my_experiments = ["EXE", "QOS"]

# The only nodes that may publish a topic (OWN003).
[owners]
{owners}

# What must be connected, and what must not be (ARC001 and ARC003).
#[[contracts]]
#name = "the planner never drives the motor itself"
#kind = "forbid"
#from = "/planner"
#to = "/motor"
"""


def configuration(seen: Seen, held: bool) -> str:
    """An ``archlint.toml``; ``held`` says whether a baseline holds back what is found today."""
    owners = "\n".join(f"#{json.dumps(topic)} = {json.dumps(node)}" for topic, node in seen.owners)
    return _CONFIGURATION.format(
        why="as $ROS_DISTRO was when this file was written" if seen.distro else "unset: for all that are supported",
        distro=f'distro = "{seen.distro}"' if seen.distro else '#distro = "jazzy"',
        held="" if held else "#",
        baseline=BASELINE,
        launch=", ".join(map(json.dumps, seen.launch_files)) or '"**/bringup.launch.py"',
        owners=owners or '#"/cmd_vel" = "/safety_mux"',
    )
