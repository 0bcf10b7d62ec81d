"""Planning."""

from __future__ import annotations

import os
from typing import Any, Mapping, Optional

from . import _amble, _scenarios
from ._errors import InputError
from ._walk import Walk


def _threads(threads: Optional[int]) -> int:
    return _amble.usual_threads() if threads is None else threads


def plan(scenario: _scenarios.Scenario, *, planner: Optional[str] = None, seed: Optional[int] = None,
         time_limit: Optional[float] = None, fps: float = 60.0, names: str = "",
         roadmap: Optional["os.PathLike[str] | str"] = None, threads: Optional[int] = None,
         name: str = "scenario") -> Walk:
    """Plans one walk, as `amble plan` does: the same bytes.

    scenario:   a scenario file; the name of one that comes with Amble ("living-room"); or a dict of
                what such a file says (metres, seconds, degrees), whose paths are relative to the
                current folder
    planner, seed, time_limit [s]: in place of the scenario's
    fps:        frames a second [24 to 240]
    names:      names joints as "mixamo", "vrm", "unreal", "unity" or "acclaim" do; "": as they are
    roadmap:    file of a kept roadmap, which is asked first (`amble roadmap build`)
    threads:    changes no result; None: as many as there are cores
    name:       of a scenario that is a dict

    That no walk is found is a result: `walk.solved` is False, `walk.why` says why.
    Raises InputError; KeyboardInterrupt at Ctrl-C, which ends the planning.
    """
    asked = _amble.Asked()
    asked.planner, asked.seed, asked.time_limit = planner, seed, time_limit
    asked.fps, asked.names, asked.threads = fps, names, _threads(threads)
    if roadmap is not None:
        asked.roadmap = roadmap
    file, text = _scenarios.find(scenario, name)
    try:
        return Walk(_amble.plan(file, text, asked))
    except InputError as error:
        if text is None or error.file != file:
            raise
        raise InputError(f"{file}: {error.problem}; expected {error.expected}", file, None, error.problem,
                         error.expected) from None
