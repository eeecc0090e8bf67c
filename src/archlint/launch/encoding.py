"""What launches are made of, where they are written as MessagePack."""

from __future__ import annotations

from typing import Final

from archlint import branches
from archlint.finding import Place
from archlint.launch.kinds import FileKind, FileStatus, GapKind, StartedKind
from archlint.launch.mistakes import (
    AbsentKey,
    IdleGroup,
    JoinedFolder,
    LeakedArgument,
    MissingArguments,
    NoAction,
    NotAChoice,
    NotACondition,
    NotAPath,
    RefusedExpression,
    RefusedValue,
    UndeclaredUse,
    UnknownAttribute,
    WithoutContext,
)
from archlint.launch.model import DeclaredArgument, Gap, Included, Launched
from archlint.launch.named_files import FileReference, Replacing, Rewriting, Written
from archlint.launch.parameter_sources import OpenParameters, ParameterFileUse, ParameterSetting
from archlint.launch.started import Bridged, Remap, Started
from archlint.model import Text
from archlint.model.encoding import Language
from archlint.syntax.parameter_files import NotKnown

LAUNCHES: Final = Language(
    (FileKind, FileStatus, GapKind, StartedKind),
    (
        *(Launched, Started, Bridged, Remap, Included, DeclaredArgument, Gap, Place, Text),
        *(ParameterSetting, ParameterFileUse, OpenParameters, FileReference, Rewriting, Replacing, Written),
        *(NotKnown, AbsentKey, LeakedArgument, NotACondition, NotAPath, RefusedExpression, RefusedValue, UndeclaredUse),
        *(UnknownAttribute, WithoutContext, MissingArguments, NotAChoice, IdleGroup, JoinedFolder, NoAction),
        *(branches.CodeBranch, branches.ChoiceOfCallee, branches.ChoiceOfArgument, branches.AttributeBranch),
        *(branches.ArgumentBranch, branches.UnfollowedCondition, branches.ChoiceOfValue, branches.ChoiceOfVisit),
    ),
)

__all__ = ["LAUNCHES"]
