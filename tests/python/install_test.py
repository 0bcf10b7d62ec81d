"""pip installs the module with all that it needs: nothing of the clone is asked for."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from inputs import ROOT

BUILD = pathlib.Path(os.environ["AMBLE_PROGRAM"]).parents[1]

USE = """
import pathlib, amble
here = pathlib.Path(amble.__file__).parent
assert here.is_relative_to({target!r}), here
assert amble.data_directory() == here / "data", amble.data_directory()
walk = amble.plan("kerb")
assert walk.solved and walk.report["inputs"], walk
assert all("data" in str(file) or file == "kerb.yaml" or "animation" in file or "environments" in file
           for file in walk.report["inputs"]), walk.report["inputs"]
print(amble.__version__, walk)
"""


class Install(unittest.TestCase):
    def test_pip_installs_what_works_by_itself(self):
        with tempfile.TemporaryDirectory() as folder:
            target = pathlib.Path(folder).resolve() / "target"
            environment = {**os.environ, "AMBLE_BUILD": str(BUILD)}
            ended = subprocess.run([sys.executable, "-m", "pip", "install", "--no-build-isolation", "--no-deps",
                                    "--no-index", "--quiet", "--target", str(target), str(ROOT)],
                                   env=environment, capture_output=True, text=True)
            self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)
            environment = {**os.environ, "PYTHONPATH": str(target)}
            ended = subprocess.run([sys.executable, "-c", USE.format(target=str(target))], cwd=folder,
                                   env=environment, capture_output=True, text=True)
            self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)
            self.assertIn("0.1.0 <amble.Walk:", ended.stdout)
            for file in ("py.typed", "_amble.pyi", "data/animation/motions/default.yaml"):
                self.assertTrue((target / "amble" / file).exists(), file)


if __name__ == "__main__":
    unittest.main()
