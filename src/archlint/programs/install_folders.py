"""Folders below the install prefix, as the commands of CMake name them."""

from __future__ import annotations

import posixpath
import re

_OF_GNU = {
    "BINDIR": "bin",
    "SBINDIR": "sbin",
    "LIBEXECDIR": "libexec",
    "LIBDIR": "lib",
    "INCLUDEDIR": "include",
    "DATAROOTDIR": "share",
    "DATADIR": "share",
    "SYSCONFDIR": "etc",
    "SHAREDSTATEDIR": "com",
    "LOCALSTATEDIR": "var",
    "INFODIR": "share/info",
    "LOCALEDIR": "share/locale",
    "MANDIR": "share/man",
}
"""What ``include(GNUInstallDirs)`` says.  Debian's ``lib/x86_64-linux-gnu`` is for the prefix ``/usr`` alone."""
_VARIABLE = re.compile(rf"\$\{{CMAKE_INSTALL_(?:FULL_)?({'|'.join(_OF_GNU)})\}}")


def below_prefix(text: str) -> str:
    """A destination with the variables of CMake that have one value everywhere, relative to the prefix."""
    text = re.sub(r"^\$\{(?:CMAKE_INSTALL_PREFIX)\}/?", "", text)
    text = text.replace("${PYTHON_INSTALL_DIR}", "lib/python3/site-packages")
    text = _VARIABLE.sub(lambda match: _OF_GNU[match[1]], text)
    return posixpath.normpath(text) if text else "."


def may_be_of_programs(destination: str | None, package: str) -> bool:
    """Whether a destination that is not known may be the folder in which launch looks for programs: one that begins
    otherwise is not."""
    known = (destination or "").partition("$")[0]
    return f"lib/{package}/".startswith(known)


__all__ = ["below_prefix", "may_be_of_programs"]
