"""Classes of Python's own library that classes of the workspace derive from."""

PLAIN_BASES = frozenset(
    {
        "abc.ABC",
        "abc.ABCMeta",
        "builtins.object",
        "enum.Enum",
        "enum.Flag",
        "enum.IntEnum",
        "enum.IntFlag",
        "enum.StrEnum",
        "object",
        "str",
        "int",
        "typing.Generic",
        "typing.NamedTuple",
        "typing.Protocol",
        "typing_extensions.Protocol",
    }
)
"""Bases that give their subclasses no attributes that matter here."""

ENUM_BASES = frozenset({"enum.Enum", "enum.IntEnum", "enum.StrEnum", "enum.Flag", "enum.IntFlag"})

__all__ = ["ENUM_BASES", "PLAIN_BASES"]
