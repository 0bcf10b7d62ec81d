"""Amble: how a person walks through a 3D scene.

    import amble
    walk = amble.plan("living-room")
    walk.positions                     # frames x joints x 3, metres, z up
    walk.write("out")                  # walk.bvh, report.json, ...

World is right-handed, z up, in metres and seconds; angles of arrays are in radians, those of
arguments, scenarios and reports in degrees. Functions that work for long let go of the
interpreter's lock: threads plan at the same time.
"""

import os as _os

from . import _amble
from ._amble import data_directory, version as __version__
from ._animate import Animation, Engine, EngineWalk, Library, animate
from ._clips import Analysis, Clip, Validation, analyse, edit, graft, read_clip, validate
from ._errors import Error, InputError, NoWalkError
from ._graph import Graph
from ._motion import Motion, Steps
from ._plan import plan, plan_queries, planners
from ._planner import Planner
from ._walk import Walk

FORMATS = tuple(_amble.format_names())
"""What Walk.write() can write into a folder."""

_data = _os.path.join(_os.path.dirname(_os.path.abspath(__file__)), "data")
if _os.path.isdir(_data):  # where pip has put it
    _amble.use_data_directory(_data)

__all__ = ["Analysis", "Animation", "Clip", "Engine", "EngineWalk", "Error", "FORMATS", "Graph", "InputError",
           "Library", "Motion", "NoWalkError", "Planner", "Steps", "Validation", "Walk", "analyse", "animate", "data_directory",
           "edit", "graft", "plan", "plan_queries", "planners", "read_clip", "validate"]
