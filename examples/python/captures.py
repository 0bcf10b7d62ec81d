#!/usr/bin/python3
"""A capture read, measured, made to step longer, and measured again.

    /usr/bin/python3 examples/python/captures.py [CAPTURE] [OUT]

Without a capture a walk is made to try with.
"""

import pathlib
import sys

import amble


def main(capture=None, out="out/longer.bvh"):
    clip = amble.read_clip(capture) if capture else amble.animate(speed=1.2, duration=8).clip
    before = amble.analyse(clip)
    print(f"{clip.name}: {before.type}, {before.gait['speed']:.2f} m/s, steps of {before.gait['step_length']:.2f} m")
    for warning in clip.warnings:
        print(f"  {warning}")
    longer = amble.edit(clip, stride="1.15x", footlock=True)
    after = amble.analyse(longer)
    print(f"edited: {after.gait['speed']:.2f} m/s, steps of {after.gait['step_length']:.2f} m")
    pathlib.Path(out).parent.mkdir(parents=True, exist_ok=True)
    longer.write(out)


if __name__ == "__main__":
    main(*sys.argv[1:])
