"""Long names in rows."""

from __future__ import annotations

import pytest

from archlint.render.wrapping import wrapped


@pytest.mark.parametrize(
    ("text", "rows"),
    [
        ("/scan", ["/scan"]),
        ("/funmap/trigger_align_with_nearest_cliff", ["/funmap/trigger_align_", "with_nearest_cliff"]),
        ("/camera/color/image_raw", ["/camera/color/image_raw"]),
        ("/arm/a_name_that_is_longer", ["/arm/a_name_that_is_", "longer"]),
        ("without_any_end" * 3, ["without_any_endwithout_", "any_endwithout_any_end"]),
        ("Nothingtopartbutverylongallthesame", ["Nothingtopartbutverylongallthesame"]),
        ("three words of which some are long", ["three words of which", "some are long"]),
        ("", [""]),
    ],
)
def test_rows_of_24_characters(text: str, rows: list[str]) -> None:
    assert wrapped(text, 24) == rows
    assert "".join(rows).replace(" ", "") == text.replace(" ", "")
