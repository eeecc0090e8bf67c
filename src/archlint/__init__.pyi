"""What a type checker sees: the names that :mod:`archlint` fetches when they are asked for."""

from archlint.api import ArchlintError as ArchlintError
from archlint.api import CheckResult as CheckResult
from archlint.api import Finding as Finding
from archlint.api import Graph as Graph
from archlint.api import Severity as Severity
from archlint.api import Workspace as Workspace
from archlint.api import load as load

__version__: str
