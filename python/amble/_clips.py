"""Captures: read, looked at, changed, checked."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, Dict, Optional, Sequence, Tuple, Union

from . import _amble, _check
from ._errors import NoWalkError
from ._motion import Motion
from ._walk import Path

if TYPE_CHECKING:  # arrays bring NumPy when they are made: to load it takes as long as the rest
    import numpy as np
    from numpy.typing import NDArray


class Clip(Motion):
    """A captured motion, or one that was made of captures: World, z up, metres, whatever file it is from."""

    _made: _amble.Clip

    def __repr__(self) -> str:
        return f"<amble.Clip {self.name}: {self.duration:.2f} s, {self.frames} frames, {len(self.joint_names)} joints>"

    @property
    def name(self) -> str:
        return self._made.name

    @property
    def warnings(self) -> Tuple[str, ...]:
        """What was unsure when it was read, or is likely not meant."""
        return self._made.warnings

    @property
    def report(self) -> Dict[str, Any]:
        """Of one that was made: what was asked for and what it came to, as the command's --json says it."""
        return json.loads(self._made.report)

    def write(self, path: Path, *, bvh_units: str = "m", names: str = "") -> None:
        """Writes it as .bvh, or as .glb with a body.

        bvh_units: "m" or "cm"
        names:     names joints as "mixamo", "vrm", ... do; "": as they are
        """
        unit = 0.01 if _check.one_of("bvh_units", bvh_units, ("m", "cm")) == "cm" else 1.0
        self._made.write(path, unit, _check.naming(names))


def read_clip(path: Path, *, unit: Optional[float] = None, up: Optional[str] = None,
              facing: Optional[float] = None, fps: Optional[float] = None, asf: Optional[Path] = None,
              roles: Optional[Path] = None, take: str = "") -> Clip:
    """Reads a capture: BVH; AMC with its ASF; FBX, glTF, GLB, VRMA or Collada.

    unit:   length of the file's unit [m]; None: said by the file, or guessed from the legs
    up:     "y" or "z"; None: said by the file, or guessed
    facing: heading of the pelvis in the first frame, to which the clip is turned [degrees]
    fps:    frames a second instead of the file's
    asf:    skeleton of an AMC; None: the one beside it
    roles:  YAML map of role to joint name, which overrides the guess
    take:   animation of an FBX, glTF or Collada file; "": what moves
    """
    how = _amble.Reading()
    how.unit = _check.optional("unit", unit, 1e-6, 1e3, "m")
    how.z_up = _check.is_z_up(up)
    how.facing = _check.optional("facing", facing, -360, 360, "degrees")
    how.fps = _check.optional("fps", fps, 1, 1000, "frames a second")
    if asf is not None:
        how.asf = asf
    if roles is not None:
        how.roles = roles
    how.take = take
    return Clip(_amble.read_clip(path, how))


def _clip(clip: Union[Clip, Path]) -> Clip:
    return clip if isinstance(clip, Clip) else read_clip(clip)


class Analysis:
    """What was measured of a clip, as `amble analyse --json` says it: lengths in metres, angles in degrees."""

    def __init__(self, report: Dict[str, Any], planted: NDArray[np.bool_]) -> None:
        self.report = report
        self.planted = planted
        """(F, 2): whether the left and the right foot are planted, by frame of the clip."""

    def __repr__(self) -> str:
        return f"<amble.Analysis: {self.type}, {self.gait['speed']:.2f} m/s, {len(self.steps)} steps>"

    @property
    def type(self) -> str:
        """ "walk", "run", "stand", ...; "mixed" and the like."""
        return self.report["class"]["type"]

    @property
    def gait(self) -> Dict[str, Any]:
        """speed [m/s], step_length [m], cadence [1/min], turn_rate [degrees/s], ...; None for what was not seen."""
        return self.report["gait"]

    @property
    def steps(self) -> Sequence[Dict[str, Any]]:
        """foot, begin, end [s], length, width, lift, rise [m], ..."""
        return self.report["steps"]

    @property
    def plants(self) -> Sequence[Dict[str, Any]]:
        """foot, first_frame, last_frame, strike, lift_off [s], at [m], drift [m]"""
        return self.report["plants"]

    @property
    def events(self) -> Sequence[Dict[str, Any]]:
        """Of each swing of each foot: lift, lift_off, strike, landing [s], of heel and toe too."""
        return self.report["events"]


def analyse(clip: Union[Clip, Path], *, as_is: bool = False) -> Analysis:
    """Measures a clip: foot plants, gait events, type, speed, stride, lift, quality.

    as_is: all frames, and z = 0 is the floor: no bad start is cut off, no floor levelled
    """
    report, planted = _clip(clip)._made.analyse(as_is)
    return Analysis(json.loads(report), planted)


def edit(clip: Union[Clip, Path], *, stride: Optional[_check.Amount] = None,
         lift: Optional[_check.Amount] = None, incline: Optional[_check.Range] = None,
         stairs: Optional[Tuple[float, float]] = None, arrive: Optional[Tuple[float, float]] = None,
         footlock: bool = False) -> Clip:
    """A captured walk changed, as `amble edit` does.

    stride:   mean step length along the ground [m]; "1.2x" is as many times the captured one; of
              two values, from the begin to the end
    lift:     how high feet swing over the line between their prints, the same
    incline:  slope, up positive [degrees, -20 to 20]
    stairs:   (rise, going) [m], a step each; a negative rise goes down
    arrive:   (x, y) where the root shall be in the last frame [m]
    footlock: hold planted feet; alone, those of any motion

    Raises InputError for a clip that is no walk and for what is beyond its limits; NoWalkError where
    legs are too short.
    """
    if stairs is not None and (incline is not None or stride is not None or arrive is not None):
        raise ValueError("stairs beside stride, incline or arrive; expected them alone")
    if arrive is not None and stride is not None:
        raise ValueError("arrive beside stride; expected one of them")
    made, refused = _clip(clip)._made.edit(
        _check.amount("stride", stride, 0.05, 2.0, "m"), _check.amount("lift", lift, 0.005, 0.5, "m"),
        _check.ramp("incline", incline, -20, 20, "degrees"),
        stairs and _check.pair("stairs", stairs, (-0.25, 0.25), (0.25, 0.6), "m"),
        arrive and _check.pair("arrive", arrive, (-1e4, 1e4), (-1e4, 1e4), "m"), footlock)
    if made is None:
        raise NoWalkError(f"there is no such walk: {refused}")
    return Clip(made)


def graft(base: Union[Clip, Path], upper: Union[Clip, Path], *,
          chains: Sequence[str] = ("left_arm", "right_arm"), alternative: int = 0,
          ease: Optional[float] = None, as_it_falls: bool = False) -> Clip:
    """Chains of one clip on the body of another, in step with it, as `amble graft` does.

    chains:      "left_arm", "right_arm", "head", "trunk", "upper", or a first joint's name
    alternative: which of the ways in which the steps match, the best first [>= 0]
    ease:        time of each passage [s, >= 0]; None: as long as the motion needs
    as_it_falls: arms that are in the body stay there

    Raises NoWalkError where the two do not go together.
    """
    made, refused = _amble.graft(_clip(base)._made, _clip(upper)._made, list(chains),
                                 _check.whole("alternative", alternative, 0, 1000),
                                 _check.optional("ease", ease, 0, 60, "s"), as_it_falls)
    if made is None:
        raise NoWalkError(refused)
    return Clip(made)


class Validation:
    """What `amble validate` finds of a BVH in a scene. `bool(validation)`: all is well."""

    def __init__(self, report: Dict[str, Any], clean: bool) -> None:
        self.report = report
        """As --json has it: contacts, clearance, foot_skate, hover, steps, pops, ... in metres and seconds."""
        self.clean = clean
        """No contact, no planted sole that hangs in the air or slides, no step too high, no joint that jumps."""

    def __bool__(self) -> bool:
        return self.clean

    def __repr__(self) -> str:
        return f"<amble.Validation: {'clean' if self.clean else 'not clean'}, {len(self.contacts)} contacts>"

    @property
    def contacts(self) -> Sequence[Dict[str, Any]]:
        """start, end [s], part, object"""
        return self.report["contacts"]


def validate(walk: Path, scene: Path, *, unit: Optional[float] = None, up: str = "y", height: float = 0.0,
             fps: float = 0.0, floor: Optional[float] = None, max_slope: float = 20.0,
             max_climb: Optional[float] = None, max_drop: Optional[float] = None) -> Validation:
    """Checks any BVH against a scene: contacts, clearance, hovering and sliding feet, steps, pops.

    unit:      length of the BVH's unit [m]; None: from its legs
    up:        the BVH's vertical axis, "y" or "z"
    height:    stature [m]; 0: from the skeleton
    fps:       check between the frames too, at this rate [1/s]; 0: at the frames only
    floor:     its height [m]; None: the one below the feet
    max_slope: steepest ground of the walk [degrees]; max_climb, max_drop: highest steps [m]
    """
    how = _amble.Validating()
    how.unit = _check.optional("unit", unit, 1e-6, 1e3, "m")
    how.z_up = _check.one_of("up", up, ("y", "z")) == "z"
    how.height = height and _check.number("height", height, 0.5, 2.5, "m")
    how.fps = fps and _check.number("fps", fps, 1, 10000, "1/s")
    how.floor = _check.optional("floor", floor, -1e5, 1e5, "m")
    how.max_slope = _check.number("max_slope", max_slope, 0, 45, "degrees")
    how.max_climb = _check.optional("max_climb", max_climb, 0, 1, "m")
    how.max_drop = _check.optional("max_drop", max_drop, 0, 1, "m")
    report, clean = _amble.validate(walk, scene, how)
    return Validation(json.loads(report), clean)
