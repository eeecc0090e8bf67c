"""For tests of your own: archlint as a test of a ROS package, and the examples on the pages of your rules.

In the form of ament's linters::

    from archlint.testing import main_with_errors

    def test_archlint():
        rc, errors = main_with_errors(argv=[])
        assert rc == 0, "\\n".join(errors)

``colcon test`` runs the tests of a Python package in the folder of the package, so that without a path this is what is
checked, with the rest of the workspace as context.  The pages of rules of your own::

    from archlint.testing import examples_of

    @pytest.mark.parametrize("example", examples_of("tools/our_rules.py"), ids=str)
    def test_a_page_keeps_its_word(example, tmp_path):
        assert example.found(tmp_path) == example.expected
"""

from __future__ import annotations

from archlint.testing.package import main_with_errors
from archlint.testing.running import PageExample, examples_of

__all__ = ["PageExample", "examples_of", "main_with_errors"]
