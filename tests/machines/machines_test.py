"""A batch on Slurm, on Dask and by GNU parallel, each of which loses a machine on the way, has the bytes of an undisturbed run.

    AMBLE_PROGRAM=amble AMBLE_ALONE=FOLDER machines_test.py Alone|Slurm|Dask|Parallel

Alone makes the undisturbed run; the others compare with it.
"""
import hashlib
import importlib.util
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

AMBLE = os.environ["AMBLE_PROGRAM"]
ALONE = pathlib.Path(os.environ["AMBLE_ALONE"])
EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples" / "batch"
WALKS, SHARDS = 40, 8

# Two rooms: in one a table is in the way; in the other a wall, which refuses those who want to get across.
ROOMS = {
    "table": '- {name: table, box: {size: [0.8, 1.6, 0.75]}, at: [3, 2, 0.375]}',
    "wall": '- {name: wall, box: {size: [0.1, 4, 2]}, at: [3, 2, 1]}',
}
SCENE = """\
objects:
  - {{name: floor, box: {{size: [6, 4, 0.1]}}, at: [3, 2, -0.05]}}
  {thing}
"""
JOB = """\
scenes:
  - table.yaml
  - scene: wall.yaml
    ways:
      - {name: across, start: {at: [1, 2], heading: 0}, goal: {at: [5, 2]}}
      - {name: along, start: {at: [1, 1]}, goal: {at: [1, 3]}}
ways: {draw: 4, least: 1.5, most: 2.5}
planner: {max_failures: 20}
heights: [1.6, 1.8]
speeds: [1.0, 1.3]
"""


def write_job(folder):
    for name, thing in ROOMS.items():
        (folder / f"{name}.yaml").write_text(SCENE.format(thing=thing))
    (folder / "job.yaml").write_text(JOB)
    return folder / "job.yaml"


def digests(folder):
    """Of all files of a batch, by their path."""
    return {
        str(file.relative_to(folder)): hashlib.sha256(file.read_bytes()).hexdigest()
        for file in sorted(folder.rglob("*")) if file.is_file() and file.relative_to(folder).parts[0] != "log"
    }


def rows(folder):
    """Walks that are there, refused ones too."""
    return len(list(folder.glob("walks/*/*/row.json")))


def await_that(what, holds, seconds=120, pause=0.02):
    end = time.monotonic() + seconds
    while not holds():
        if time.monotonic() > end:
            raise AssertionError(f"waited {seconds} s that {what}")
        time.sleep(pause)


def load(file):
    spec = importlib.util.spec_from_file_location(file.stem, file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Machines(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="amble-machines-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.job, self.out = write_job(self.folder), self.folder / "walks here"

    def expect_undisturbed(self):
        alone, here = digests(ALONE / "out"), digests(self.out)
        self.assertEqual(sorted(alone), sorted(here))
        self.assertEqual(alone, here)


class Alone(unittest.TestCase):
    def test_one_machine_makes_all_walks(self):
        shutil.rmtree(ALONE, ignore_errors=True)
        ALONE.mkdir(parents=True)
        subprocess.run([AMBLE, "batch", write_job(ALONE), "-o", ALONE / "out"], check=True, capture_output=True)
        lines = (ALONE / "out" / "index.jsonl").read_text().splitlines()
        self.assertEqual(len(lines), WALKS)
        statuses = {json.loads(line)["status"] for line in lines}
        self.assertIn("solved", statuses)


    def test_scripts_say_what_is_wrong_with_a_job_before_anything_starts(self):
        with tempfile.TemporaryDirectory() as folder:
            job = write_job(pathlib.Path(folder))
            job.write_text(JOB + "hights: [1.7]\n")
            for script in ("slurm-batch", "parallel.sh"):
                ended = subprocess.run([EXAMPLES / script, job, "out", "2"], cwd=folder, env={**os.environ, "AMBLE": AMBLE},
                                       capture_output=True, text=True)
                self.assertEqual(ended.returncode, 2)
                self.assertRegex(ended.stderr, rf"^{job}:{len(JOB.splitlines()) + 1}: .*hights[^\n]*\n$")
                self.assertFalse((pathlib.Path(folder) / "out").exists())


class Slurm(Machines):
    def setUp(self):
        super().setUp()
        self.here = load(EXAMPLES / "slurm_here.py")
        if self.here.missing():
            self.skipTest(f"not installed: {', '.join(self.here.missing())}")
        self.slurm = self.folder / "slurm"
        self.addCleanup(self.here.stop, self.slurm)
        try:
            self.here.start(self.slurm, 2)
        except (SystemExit, subprocess.CalledProcessError) as error:
            self.skipTest(f"Slurm does not run here: {error}")
        self.environment = {**os.environ, "SLURM_CONF": str(self.slurm / "slurm.conf"), "AMBLE": str(self.interrupted())}

    def interrupted(self):
        """The program, but that the first shard on n2 ends in the middle of its work and its job does not: whenever the node is
        killed then, it is at work."""
        program = self.folder / "amble"
        program.write_text(f"""#!/bin/bash
if [ "$SLURMD_NODENAME" = n2 ] && mkdir "{self.folder}/at-work" 2>/dev/null; then
  timeout --signal=KILL 0.4 "{AMBLE}" "$@"
  touch "{self.folder}/at-work/interrupted"
  sleep 600
fi
exec "{AMBLE}" "$@"
""")
        program.chmod(0o755)
        return program

    def ask(self, *command):
        ended = subprocess.run(command, env=self.environment, cwd=self.folder, check=True, capture_output=True, text=True)
        return ended.stdout.strip()

    def running(self, job):
        return self.ask("squeue", "-h", "-t", "PENDING,RUNNING,COMPLETING,REQUEUED", "-o", "%i").split().count(job)

    def running_on(self, node):
        return self.ask("squeue", "-h", "-w", node, "-t", "RUNNING", "-o", "%i").split()

    def test_a_job_whose_node_dies_is_finished_on_the_other(self):
        merge = self.ask(EXAMPLES / "slurm-batch", self.job, self.out, str(SHARDS), "--time=1:00:00", "--mem=200M")
        await_that("n2 is at work", (self.folder / "at-work" / "interrupted").exists)
        lost = self.running_on("n2")
        self.here.kill(self.slurm, "n2")
        self.assertLess(rows(self.out), WALKS)
        await_that("Slurm merges", lambda: not self.running(merge), 240, pause=0.3)
        log = (self.slurm / "slurmctld.log").read_text()
        self.assertIn("Nodes n2 not responding", log)
        self.assertTrue(lost)
        self.assertIn("requeue", log)
        self.expect_undisturbed()


class Dask(Machines):
    def setUp(self):
        super().setUp()
        try:
            import distributed
        except ImportError:
            self.skipTest("not installed: distributed (Debian's python3-distributed)")
        self.distributed = distributed
        self.started = []
        self.addCleanup(self.stop)
        self.address = self.start_scheduler()
        self.workers = [self.start("distributed.cli.dask_worker", self.address, "--name", name, "--nthreads", "1", "--no-dashboard",
                                   "--local-directory", str(self.folder / name)) for name in ("n1", "n2")]

    def start(self, module, *arguments):
        with (self.folder / f"dask-{len(self.started)}.log").open("w") as log:
            process = subprocess.Popen([sys.executable, "-m", module, *arguments], stdout=log, stderr=log, start_new_session=True)
        self.started.append(process)
        return process

    def start_scheduler(self):
        file = self.folder / "scheduler.json"
        self.start("distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard",
                   "--scheduler-file", str(file))
        await_that("Dask's scheduler is there", lambda: file.exists() and '"address"' in file.read_text(), 60)
        return file.read_text().split('"address": "')[1].split('"')[0]

    def kill(self, process):
        """With all of its session, as a machine dies."""
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        process.wait()

    def stop(self):
        for process in self.started:
            self.kill(process)

    def test_a_shard_whose_worker_dies_is_finished_by_the_other(self):
        import threading

        from amble.dask import plan_many

        with self.distributed.Client(self.address, timeout=60) as client:
            client.wait_for_workers(2, timeout=60)
            killed = []

            def pull_the_plug():
                await_that("walks are made", lambda: rows(self.out) > 2)
                self.kill(self.workers[1])
                killed.append(rows(self.out))

            thread = threading.Thread(target=pull_the_plug)
            thread.start()
            table = plan_many(client, self.job, self.out, shards=SHARDS, program=AMBLE)
            thread.join()
        self.assertEqual(len(table), WALKS)
        self.assertLess(killed[0], WALKS)
        self.expect_undisturbed()

    def test_a_wrong_job_is_an_error_with_its_line(self):
        import amble
        from amble.dask import plan_many

        self.job.write_text(JOB + "hights: [1.7]\n")
        with self.distributed.Client(self.address, timeout=60) as client:
            client.wait_for_workers(1, timeout=60)
            with self.assertRaises(amble.InputError) as raised:
                plan_many(client, self.job, self.out, shards=2, program=AMBLE)
        self.assertEqual(raised.exception.line, len(JOB.splitlines()) + 1)
        self.assertIn("hights", raised.exception.problem)


class Parallel(Machines):
    def test_a_shard_that_is_killed_is_tried_again(self):
        if not shutil.which("parallel"):
            self.skipTest("not installed: parallel (GNU parallel)")
        script = subprocess.Popen([EXAMPLES / "parallel.sh", self.job, self.out, str(SHARDS)], cwd=self.folder,
                                  env={**os.environ, "AMBLE": AMBLE, "HOME": str(self.folder)}, start_new_session=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.addCleanup(script.stdout.close)
        self.addCleanup(lambda: script.poll() is None and os.killpg(script.pid, signal.SIGKILL))
        await_that("walks are made", lambda: rows(self.out) > 2)
        shard = self.shard_at_work(script.pid)
        os.kill(shard, signal.SIGKILL)
        self.assertLess(rows(self.out), WALKS)
        said, _ = script.communicate(timeout=240)
        self.assertEqual(script.returncode, 0, said)
        self.expect_undisturbed()

    def shard_at_work(self, session):
        program = pathlib.Path(AMBLE).resolve()
        for entry in pathlib.Path("/proc").glob("[0-9]*"):
            try:
                if os.getsid(int(entry.name)) == session and (entry / "exe").resolve() == program:
                    return int(entry.name)
            except OSError:
                continue
        self.fail("no shard is at work")


if __name__ == "__main__":
    unittest.main(verbosity=2)
