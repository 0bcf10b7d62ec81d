"""Amble: how a person walks through a 3D scene.

    import amble
    walk = amble.plan("living-room")
    walk.positions                     # frames x joints x 3, metres, z up
    walk.write("out")                  # walk.bvh, report.json, ...

World is right-handed, z up, in metres and seconds; angles of arrays are in radians, those of
scenarios and reports in degrees, as in their files. Functions that work for long let go of the
interpreter's lock: threads plan at the same time.
"""

from ._amble import version as __version__
from ._errors import Error, InputError, NoWalkError
from ._plan import plan
from ._walk import Walk

__all__ = ["Error", "InputError", "NoWalkError", "Walk", "plan"]
