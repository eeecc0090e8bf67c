"""For the tests of a ROS package: archlint as a test, in the form of ament's linters.

::

    from archlint.testing import main_with_errors

    def test_archlint():
        rc, errors = main_with_errors(argv=[])
        assert rc == 0, "\\n".join(errors)

``colcon test`` runs the tests of a Python package in the folder of the package, so that without a path this is what is
checked, with the rest of the workspace as context.
"""

from __future__ import annotations

from archlint.testing.package import main_with_errors

__all__ = ["main_with_errors"]
