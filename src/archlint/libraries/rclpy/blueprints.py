"""What a program says of a node."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint import model
from archlint.finding import Place

if TYPE_CHECKING:
    from archlint.libraries.run import Run

ROOT = model.Text("/", "exact")


def new_blueprint(run: Run, class_name: str, place: Place, key: str, package: str | None) -> model.Blueprint:
    blueprint = model.Blueprint(
        class_name,
        model.Text(None, "unknown", reason=model.NEVER_CONSTRUCTED),
        ROOT,
        place,
        package,
        test=run.index.roles.is_test(place.file),
        number=len(run.nodes.by_key),
        branch_arms=frozenset(run.branch_arms),
        ended_arms=run.ended_arms(),
        made_by=run.context,
    )
    run.nodes.by_key[key] = blueprint
    run.program.nodes.append(blueprint)
    return blueprint
