"""Planning."""

from __future__ import annotations

from typing import Any, Dict, Optional

from . import _amble, _check, _scenarios
from ._errors import InputError
from ._walk import Path, Walk


def _command(function: str, scenario: Any, changed: Dict[str, Any]) -> str:
    """That gives the same again."""
    settings = [f"{key}={value!r}" for key, value in changed.items() if value is not None]
    return f"amble.{function}({', '.join([repr(scenario), *settings])})"


def _asked(planner: Optional[str], seed: Optional[int], time_limit: Optional[float], fps: float, names: str,
           roadmap: Optional[Path], threads: Optional[int]) -> _amble.Asked:
    asked = _amble.Asked()
    asked.planner = planner
    asked.seed = None if seed is None else _check.whole("seed", seed, 0, 2**31 - 1)
    asked.time_limit = _check.optional("time_limit", time_limit, 0.001, 86400, "s")
    asked.fps, asked.names, asked.threads = _check.fps(fps), _check.naming(names), _check.threads(threads)
    if roadmap is not None:
        asked.roadmap = roadmap
    return asked


def plan(scenario: _scenarios.Scenario, *, planner: Optional[str] = None, seed: Optional[int] = None,
         time_limit: Optional[float] = None, fps: float = 60.0, names: str = "",
         roadmap: Optional[Path] = None, threads: Optional[int] = None, name: str = "scenario") -> Walk:
    """Plans one walk, as `amble plan` does: the same bytes.

    scenario:   a scenario file; the name of one that comes with Amble ("living-room"); or a dict of
                what such a file says (metres, seconds, degrees), whose paths are relative to the
                current folder
    planner, seed, time_limit [s]: in place of the scenario's
    fps:        frames a second [24 to 240]
    names:      names joints as "mixamo", "vrm", ... do; "": as they are
    roadmap:    file of a kept roadmap, which is asked first (Planner.save, `amble roadmap build`)
    threads:    changes no result; None: as many as there are cores
    name:       of a scenario that is a dict

    That no walk is found is a result: `walk.solved` is False, `walk.why` says why.
    Raises InputError; KeyboardInterrupt at Ctrl-C, which ends the planning.
    """
    asked = _asked(planner, seed, time_limit, fps, names, roadmap, threads)
    changed = {"planner": planner, "seed": seed, "time_limit": time_limit, "roadmap": roadmap}
    asked.command = _command("plan", scenario, changed)
    file, text = _scenarios.find(scenario, name)
    try:
        return Walk(_amble.plan(file, text, asked))
    except InputError as error:
        raise _scenarios.without_line(error, file, text) from None


def plan_queries(scenario: _scenarios.Scenario, *, planner: Optional[str] = None, seed: Optional[int] = None,
                 time_limit: Optional[float] = None, fps: float = 60.0, names: str = "",
                 roadmap: Optional[Path] = None, threads: Optional[int] = None,
                 name: str = "scenario") -> Dict[str, Walk]:
    """Plans each walk that a scenario's `queries:` asks for, on one roadmap: by the queries' names, in order.

    Arguments are plan()'s.
    """
    asked = _asked(planner, seed, time_limit, fps, names, roadmap, threads)
    changed = {"planner": planner, "seed": seed, "time_limit": time_limit, "roadmap": roadmap}
    asked.command = _command("plan_queries", scenario, changed)
    file, text = _scenarios.find(scenario, name)
    try:
        made = _amble.plan_queries(file, text, asked)
    except InputError as error:
        raise _scenarios.without_line(error, file, text) from None
    return {query: Walk(walk) for query, walk in made.items()}


def planners() -> Dict[str, str]:
    """Names of planners, each with a line that explains it; the default first."""
    return _amble.planners()
