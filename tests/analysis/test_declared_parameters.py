"""Which parameters a node is known not to have."""

from __future__ import annotations

from archlint.analysis.declared_parameters import parts_of_name


def test_what_code_may_put_a_name_together_of():
    assert parts_of_name("gain") == ["gain"]
    assert parts_of_name("left_ir_enable") == [
        *("left_ir_enable", "left_", "_ir_enable"),  # "left" + "_ir_enable"
        *("left_ir_", "_enable"),
    ]
    assert parts_of_name("_a_") == ["_a_"]
