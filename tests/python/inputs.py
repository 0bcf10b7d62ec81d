"""What the tests of the module share."""

import os
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ["AMBLE_PROGRAM"]

# A floor and nothing on it: a metre and a half to walk.
FLOOR = """name: floor
objects:
  - name: floor
    box: {size: [4, 3, 0.1]}
    at: [2, 1.5, -0.05]
"""


def write_floor(folder):
    """The scene's file."""
    file = pathlib.Path(folder) / "floor.yaml"
    file.write_text(FLOOR)
    return file


def short_walk(scene, **more):
    return {"scene": str(scene), "start": {"at": [1, 1.5], "heading": 0}, "goal": {"at": [2.5, 1.5], "heading": 0},
            **more}


def run(*arguments):
    """What the program prints."""
    return subprocess.run([PROGRAM, *map(str, arguments)], check=True, capture_output=True, text=True).stdout
