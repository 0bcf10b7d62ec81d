"""Runs of benchmark programs and of amble, for scripts/bench."""
import json
import os
import pathlib
import re
import statistics
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = pathlib.Path(os.environ.get("AMBLE_BUILD") or ROOT / "build" / os.environ.get("AMBLE_PRESET", "release"))
AMBLE = BUILD / "app" / "amble"


def program(name):
    return BUILD / "benchmarks" / f"{name}_benchmark"


def rows(name, arguments=(), repetitions=5, least=0.1, only=None, quick=False):
    """Medians by row of a benchmark program: {row: {"real_time", "cpu_time", "time_unit", counters...}}.

    Repetitions of all rows in mixed order, so that what disturbs one disturbs its peer."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "rows.json"
        command = [program(name), f"--benchmark_out={out}", f"--benchmark_min_time={least}"]
        command.append(f"--benchmark_repetitions={repetitions}")
        if repetitions > 1:
            command += ["--benchmark_enable_random_interleaving=true", "--benchmark_report_aggregates_only=true"]
        if only:
            command.append(f"--benchmark_filter={only}")
        environment = dict(os.environ, **({"AMBLE_QUICK": "1"} if quick else {}))
        subprocess.run(command + list(arguments), check=True, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        entries = json.loads(out.read_text())["benchmarks"]
    found = {}
    for entry in entries:
        if entry.get("error_occurred"):
            raise RuntimeError(f"{entry['run_name']}: {entry['error_message']}")
        if repetitions == 1 or entry.get("aggregate_name") == "median":
            found[re.sub(r"/(iterations:\d+|real_time|repeats:\d+)", "", entry["run_name"])] = entry
    if not found:
        raise RuntimeError(f"{name}_benchmark printed no row")
    return found


def seconds(entry, clock="cpu_time"):
    return entry[clock] * {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}[entry["time_unit"]]


def plan(scenario, *options, formats="bvh,json"):
    """One run of `amble plan`: its report, with `wall` [s] and `memory` [bytes] of the whole process."""
    with tempfile.TemporaryDirectory() as folder:
        command = [AMBLE, "plan", scenario, "-o", folder, "--formats", formats, *map(str, options)]
        begin = time.monotonic()
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        complaint = process.stderr.read()
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        wall = time.monotonic() - begin
        if process.returncode not in (0, 1):
            raise RuntimeError(f"amble plan {scenario}: {complaint.strip()}")
        report = json.loads((pathlib.Path(folder) / "report.json").read_text())
    return {**report, "wall": wall, "memory": used.ru_maxrss * 1024}


def plans(scenario, count, *options):
    """Medians of `count` runs: the last report, with `wall` and `memory`."""
    runs = [plan(scenario, *options) for _ in range(count)]
    return {**runs[-1], **{key: statistics.median(run[key] for run in runs) for key in ("wall", "memory")}}


def machine():
    """What the figures were taken on, a line each."""
    about = pathlib.Path("/proc/cpuinfo").read_text()
    model = re.search(r"model name\s*: (.*)", about)
    cache = (BUILD / "CMakeCache.txt").read_text()
    compiler = re.search(r"CMAKE_CXX_COMPILER:\w+=(.*)", cache).group(1)
    version = subprocess.run([compiler, "--version"], capture_output=True, text=True, check=True).stdout.splitlines()[0]
    flags = re.search(r"CMAKE_BUILD_TYPE:\w+=(.*)", cache).group(1)

    def git(*words):
        return subprocess.run(["git", "-C", ROOT, *words], capture_output=True, text=True).stdout.strip()

    commit = git("rev-parse", "--short", "HEAD") or "unknown"
    changed = ", with changes that are not committed" if git("status", "--porcelain", "--untracked-files=no") else ""
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30
    return [
        f"machine: {model.group(1) if model else os.uname().machine}, {os.cpu_count()} cores, {memory:.0f} GB",
        f"load when it began: {os.getloadavg()[0]:.1f}",
        f"commit: {commit}{changed}",
        f"compiler: {version}, {flags}",
    ]
