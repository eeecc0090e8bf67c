"""What of a system a picture is to show, and how: the options of ``archlint graph`` as plain data."""

from __future__ import annotations

from typing import Final, Literal

from archlint.records import dataclass

Style = Literal["nodes", "topics", "full"]
"""``nodes``: nodes alone, with what connects them written on the lines; ``topics``: nodes and topics; ``full``: also
services and actions."""
GroupBy = Literal["namespace", "package", "folder", "launch", "process"]
"""What nodes that are drawn in one frame have in common: ``folder`` is the one that their packages lie in, ``launch``
the launch file that starts them, ``process`` the executable or the container that they run in."""


@dataclass(frozen=True)
class View:
    """A selection of a system, and how it is drawn.  Names are patterns for fully qualified names, as in a shell."""

    style: Style = "full"
    focus: tuple[str, ...] = ()
    """Show what is near these nodes, topics, services and actions."""
    depth: int = 1
    """How many nodes away from the focus is near."""
    only: tuple[str, ...] = ()
    """Show these, with the ends of what is no node and with what nodes have."""
    hide: tuple[str, ...] = ()
    group: GroupBy | None = None
    """None for namespaces where the nodes have several, else packages."""
    collapse: tuple[str, ...] = ()
    """The groups, by their titles, that are drawn as one box."""
    expand: tuple[str, ...] = ()
    """The groups whose nodes are drawn where there are so many that each group would be a box."""
    matched: bool = False
    """Whether what has nothing at its other end is left out."""
    every_line: bool = False
    """Whether a picture of very many lines is drawn with each of them."""
    everything: bool = False
    """Whether what ROS gives every node is shown, too."""

    @property
    def selects(self) -> bool:
        """Whether it was asked to leave something out."""
        return bool(self.focus or self.only or self.hide or self.matched or self.style != "full")


WHOLE: Final = View()
"""What is shown where nothing else is asked for."""

__all__ = ["WHOLE", "GroupBy", "Style", "View"]
