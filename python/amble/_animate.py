"""Walks without a scene, and the libraries and engines that they are made of."""

from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Sequence, Tuple

from . import _amble, _check
from ._clips import Clip
from ._errors import InputError, NoWalkError
from ._motion import Steps
from ._walk import Path

if TYPE_CHECKING:  # arrays bring NumPy when they are made: to load it takes as long as the rest
    import numpy as np
    from numpy.typing import NDArray


class Animation(Steps):
    """A walk without a scene."""

    _made: _amble.Animation

    def __repr__(self) -> str:
        return f"<amble.Animation: {self.path_arcs[-1]:.2f} m, {self.duration:.2f} s, {self.frames} frames>"

    @property
    def clip(self) -> Clip:
        """The same as a clip, which can be analysed and edited."""
        return Clip(self._made.clip())

    def write(self, path: Path, *, bvh_units: str = "m", names: str = "") -> None:
        """Writes it as .bvh, or as .glb with a body (Clip.write)."""
        self.clip.write(path, bvh_units=bvh_units, names=names)


def animate(*, speed: Optional[float] = None, turn: float = 0.0, duration: float = 5.0,
            stride: Optional[_check.Range] = None, lift: Optional[_check.Range] = None,
            incline: Optional[_check.Range] = None, stairs: Optional[Tuple[float, float]] = None,
            height: Optional[float] = None, actions: Sequence[str] = (), library: Path = "default",
            style: str = "", fps: float = 60.0) -> Animation:
    """A walk along +x, from standing to standing, as `amble animate` makes it.

    speed:    on the straight, less in turns [m/s, 0.3 to 2]; None: 1.2, or the style's own
    turn:     turn rate at that speed, left positive [degrees/s]
    duration: about how long: steps are whole [s, 1 to 600]
    stride:   step length along the ground [m]; of two values, from the begin to the end
    lift:     how high feet swing over the line between prints [m], the same
    incline:  slope, up positive [degrees], the same
    stairs:   (rise, going) of a flight of stairs [m]; a negative rise goes down
    height:   stature [m, 0.5 to 2.5]; None: the library's own
    actions:  movements and postures of the library, over the whole walk
    library:  "default", or a file
    style:    in whose manner, of those that the library has
    fps:      frames a second [24 to 240]

    Raises InputError for what is beyond the library's walks, NoWalkError where there is no such walk.
    """
    if stairs is not None and (incline is not None or stride is not None or turn):
        raise ValueError("stairs beside stride, incline or turn; expected them alone")
    asked = _amble.AnimateAsked()
    asked.library, asked.style, asked.speed = os.fspath(library), style, speed
    asked.height = 0.0 if height is None else _check.number("height", height, 0.5, 2.5, "m")
    asked.fps = _check.fps(fps)
    asked.duration = _check.number("duration", duration, 1, 600, "s")
    asked.turn = _check.number("turn", turn, -180, 180, "degrees/s")
    asked.actions = list(actions)
    asked.stride = _check.ramp("stride", stride, 0.05, 2.0, "m")
    asked.lift = _check.ramp("lift", lift, 0.005, 0.5, "m")
    asked.incline = _check.ramp("incline", incline, -45, 45, "degrees")
    asked.stairs = stairs and _check.pair("stairs", stairs, (-0.5, 0.5), (0.15, 1.5), "m")
    made = _amble.animate(asked)
    if made.refused:
        raise NoWalkError(f"there is no such walk: {made.refused}")
    return Animation(made)


class Library:
    """A motion library: prepared motions of one skeleton, with where they come from."""

    def __init__(self, name: Path = "default") -> None:
        """name: "default", or a library's file"""
        self._made = _amble.open_library(os.fspath(name))

    @classmethod
    def build(cls, recipe: Path, captures: Path = "") -> "Library":
        """Prepares the motions that a recipe names, as `amble library build` does.

        captures: folder of the clips; "": the recipe's
        """
        library = cls.__new__(cls)
        library._made = _amble.build_library(recipe, captures)
        return library

    @classmethod
    def new(cls, path: Path) -> "Library":
        """An empty one for add(), that is going to be written there; the file's, where there is one."""
        library = cls.__new__(cls)
        library._made = _amble.new_library(path)
        return library

    @staticmethod
    def find(type: str, paths: Sequence[Path] = ("default",), *, at_least: float = 0.75,
             threads: Optional[int] = None) -> List[Dict[str, Any]]:
        """Clips and motions that are mostly of a type, as `amble library find --json` says them, the surest first.

        type:     "stand", "walk", "run", "jump" or "unknown"
        paths:    clips, folders of them, libraries
        at_least: share of the clip's frames that are of that type [0 to 1]

        Raises InputError for a clip that cannot be read.
        """
        _check.one_of("type", type, ("stand", "walk", "run", "jump", "unknown"))
        found, wrong = _amble.find_motions([os.fspath(path) for path in paths], type,
                                           _check.number("at_least", at_least, 0, 1, ""), _check.threads(threads))
        if wrong:
            raise InputError(wrong[0])
        return json.loads(found)

    def add(self, *clips: Path, name: str = "", kind: str = "walk", turning: Optional[bool] = None, style: str = "",
            joints: Sequence[str] = (), frames: Optional[Tuple[int, int]] = None, mirror: Optional[bool] = None,
            licence: str = "unknown", credit: str = "unknown", speed: Sequence[float] = ()) -> None:
        """Adds motions of captures, as `amble library add` does; write() keeps them. All of the clips, or none.

        name:    of the motion; "": the clip's
        kind:    "walk", "movement", "posture", "start", "stop", "blocking" or "turn_on_spot"
        turning: of a walk; None: as it is found
        style:   in whose manner it walks; it is blended with none but its like
        joints:  chains that a movement or a posture moves; none: all
        frames:  first and last to look at, as the file numbers them; None: all
        mirror:  whether the mirror image of a walk or a turn on the spot is added too; None: where it has no style
        speed:   of a speed engine, which a clip may be: a walk at each of these speeds [m/s]
        """
        if style and kind not in ("walk", "start", "stop", "turn_on_spot"):
            raise ValueError(f"style of a {kind}; expected a walk, a start, a stop or a turn on the spot")
        if turning is not None and kind != "walk":
            raise ValueError(f"turning of a {kind}; expected a walk")
        if joints and kind not in ("movement", "posture", "blocking"):
            raise ValueError(f"joints of a {kind}; expected a movement, a posture or a blocking motion")
        if mirror and kind not in ("walk", "turn_on_spot"):
            raise ValueError(f"mirror image of a {kind}; expected a walk or a turn on the spot")
        for chain in joints:
            _check.one_of("joints", chain, _amble.chain_names())
        asked = _amble.AdditionAsked()
        asked.kind, asked.name = _check.one_of("kind", kind, _amble.motion_kinds()), name
        asked.choose(turning, style, list(joints), frames, mirror, licence, credit,
                     [_check.number("speed", one, 0.3, 5, "m/s") for one in speed])
        self._made.add(list(clips), asked)

    def __repr__(self) -> str:
        return f"<amble.Library {os.fspath(self.file)}: {len(self.motions)} motions, {self.stature:.2f} m>"

    @property
    def file(self) -> "os.PathLike[str]":
        return self._made.file

    @property
    def stature(self) -> float:
        """Of the captured person [m]."""
        return self._made.stature

    @property
    def joint_names(self) -> Tuple[str, ...]:
        return self._made.joint_names

    @property
    def styles(self) -> Tuple[str, ...]:
        """In whose manner its people walk."""
        return self._made.styles

    @property
    def motions(self) -> List[Dict[str, Any]]:
        """name, kind, style, joints, source (clip, frames or, of an engine, speed [m/s], licence, credit); of cycles also speed [m/s],
        turn_rate [rad/s], period [s]."""
        return self._made.motions

    def write(self, path: Path) -> None:
        """Writes it as YAML, with its skeleton beside it."""
        self._made.write(path)


class EngineWalk:
    """A walk or run of a speed engine."""

    def __init__(self, clip: Clip, speeds: NDArray[np.float64], phases: NDArray[np.float64],
                 planted: NDArray[np.bool_]) -> None:
        self.clip = clip
        self.speeds = speeds
        """(F,): what is walked [m/s]"""
        self.phases = phases
        """(F,): from the first frame's on [cycles]"""
        self.planted = planted
        """(F, 2): whether the left and the right foot stand"""


class Engine:
    """A speed engine, which walks and runs at any speed (`amble library engine build`)."""

    def __init__(self, path: Path) -> None:
        self._made = _amble.Engine(path)

    def walk(self, speed: _check.Range = 1.2, *, duration: float = 5.0, height: Optional[float] = None,
             fps: float = 60.0) -> EngineWalk:
        """Straight ahead along +x over level ground; feet that stand are held.

        speed:    [m/s, 0 to 12]; of two values, from the begin to the end; beyond what was captured the
                  nearest that was
        duration: [s, 1 to 600]
        height:   stature [m]; None: the captured person's
        """
        ends = _check.ramp("speed", speed, 0, 12, "m/s")
        assert ends is not None
        clip, speeds, phases, planted = self._made.walk(
            *ends, _check.number("duration", duration, 1, 600, "s"), _check.fps(fps),
            0.0 if height is None else _check.number("height", height, 0.5, 2.5, "m"))
        return EngineWalk(Clip(clip), speeds, phases, planted)
