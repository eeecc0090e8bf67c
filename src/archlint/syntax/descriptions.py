"""Descriptions of robots, worlds and plugins, which ROS and Gazebo read at run time: whether they are XML.

xacro reads its files with Python's expat and wants all of XML.  TinyXML, which reads the others, passes over more:
what is inside of a comment, blanks in front of the declaration, an ``&`` that begins no entity, and what stands behind
the document; in models and worlds, tags such as ``<?ignore>`` and ``<?>``, too, and what stands in front of the first
element, unless a declaration follows it.
"""

from __future__ import annotations

import re
from xml.parsers import expat

from archlint.syntax.facts import FileProblem
from archlint.workspace.comments import replace_xml_comments

_XACRO = ".xacro"
_WORLD = ".world"
"""Gazebo's worlds are XML; those of the simulator Stage are called the same, and have a syntax of their own."""
ENDINGS = (_XACRO, ".urdf", ".srdf", ".sdf", _WORLD)
_PLUGINS = re.compile(r"[\w-]*plugins?(?:_description)?s?\.xml")
"""What the files are called that say which classes a library has for pluginlib."""
_OF_PLUGINS = "base_class_type="
_ELEMENT = re.compile(r"^[ \t\ufeff]*<", re.MULTILINE)
_LARGEST = 500_000
"""Characters of what people write by hand."""
_UNKNOWN_TAG = re.compile(r"<\?(?!xml\s)[^>]*>")
"""What TinyXML has no meaning for, and skips up to the bracket; how XML wants such tags, it does not ask."""
_OF_GAZEBO = (".sdf", _WORLD)
_NOTES = re.compile(r"\A(\s*(?:<\?xml[^>]*>)?)([^<]*)(?=<[A-Za-z_])")
"""What stands in front of the first element of a model or world.  Source: ``XMLDocument::ParseDeep`` of TinyXML2, for
which text is a node like others, and which refuses a declaration behind anything else."""
_NO_ENTITY = re.compile(r"&(?!(?:lt|gt|amp|quot|apos|#\d+|#x[\da-fA-F]+);)")
_TEMPLATE = re.compile(r"\{\{|\{%|<%|@\(|@\[|<!DOCTYPE")
"""What a program fills in before anybody reads the file; what a document type declares is not followed here."""
_BEHIND = "junk after document element"


def may_be_description(name: str) -> bool:
    """Whether a file of this name is such a description, or XML of any kind."""
    return name.endswith((*ENDINGS, ".xml")) and name != "package.xml"


def _is_description(name: str, text: str) -> bool:
    return name.endswith(ENDINGS) or _PLUGINS.fullmatch(name) is not None or _OF_PLUGINS in text


def malformed_description(name: str, text: str) -> FileProblem | None:
    """Where the reader of a description stops; None where it does not, or that is not known."""
    if not text.strip() or len(text) > _LARGEST or _TEMPLATE.search(text) or not _is_description(name, text):
        return None
    if name.endswith(_WORLD) and _ELEMENT.search(text) is None:
        return None
    strict = name.endswith(_XACRO)
    parser = expat.ParserCreate(namespace_separator=" " if strict else None)
    read = text if strict else _as_tinyxml(name, text)
    before = len(read) - len(read.lstrip())
    first = 0 if strict else read.count("\n", 0, before)
    try:
        parser.Parse(read if strict else read.lstrip(), True)
    except expat.ExpatError as error:
        words = expat.errors.messages.get(error.code, str(error))
        if words == _BEHIND and not strict:
            return None
        return FileProblem(error.lineno + first, error.offset + 1, f"malformed XML: {words}")
    except (ValueError, LookupError):  # an encoding that nobody knows
        return None
    return None


def _as_tinyxml(name: str, text: str) -> str:
    """A text without what TinyXML passes over, with the same lines."""
    read = replace_xml_comments(text, _blank)
    if name.endswith(_OF_GAZEBO):
        read = _NOTES.sub(lambda notes: notes[1] + _blank(notes[2]), read, count=1)
    if name.endswith(ENDINGS):
        end = read.rfind(">") + 1  # behind it no tag ends, and each start there would be held against all that follows
        read = _UNKNOWN_TAG.sub(lambda tag: _blank(tag[0]), read[:end]) + read[end:]
    return _NO_ENTITY.sub(" ", read)


def _blank(passed_over: str) -> str:
    """As many lines as what is passed over has."""
    return "\n" * passed_over.count("\n")
