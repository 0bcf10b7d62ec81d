#!/usr/bin/env python3
"""A Slurm of two nodes on this machine, to try what is meant for a cluster: without systemd, /etc and other users.

    python3 examples/batch/slurm_here.py start FOLDER [--nodes 2]   then  export SLURM_CONF=FOLDER/slurm.conf
    python3 examples/batch/slurm_here.py kill FOLDER NODE           n2, say, with all that runs there, as if its plug were pulled
    python3 examples/batch/slurm_here.py revive FOLDER NODE         it comes back
    python3 examples/batch/slurm_here.py stop FOLDER

FOLDER holds the configuration, a key of its own for munge, logs and state. Debian's packages slurmctld, slurmd, slurm-client
and munge are all that it takes; as root or as any user, with free ports of the loopback. Each node has one processor, so a
machine of two cores is used as it is. What a node asks of a real machine (control groups, processors bound to jobs) is off.
"""
import argparse
import os
import pathlib
import pwd
import shutil
import signal
import socket
import subprocess
import sys
import time

# SlurmdTimeout: after about twice this without an answer a node is down and its jobs go elsewhere [s]. cred_expire: for so
# long a job that was put back waits before it starts again [s].
CONFIGURATION = """\
ClusterName=here
SlurmctldHost=localhost(127.0.0.1)
SlurmctldPort={control}
SlurmctldPidFile={folder}/slurmctld.pid
SlurmctldLogFile={folder}/slurmctld.log
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/%n.spool
SlurmdPidFile={folder}/%n.pid
SlurmdLogFile={folder}/%n.log
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket,cred_expire=5
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
SchedulerParameters=sched_interval=2,bf_interval=2
ReturnToService=2
SlurmdTimeout=4
{nodes}
PartitionName=here Nodes=ALL Default=YES State=UP
"""
NEEDED = ("munged", "slurmctld", "slurmd", "sbatch", "sinfo")


def missing():
    """Programs that are not installed."""
    return [name for name in NEEDED if not find(name)]


def find(name):
    return shutil.which(name, path=os.environ.get("PATH", "") + ":/usr/sbin:/sbin")


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for each in sockets:
        each.bind(("127.0.0.1", 0))
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


def run(*command, **environment):
    subprocess.run([find(command[0]), *map(str, command[1:])], check=True, env={**os.environ, **environment})


def configure(folder, count):
    control, *ports = free_ports(1 + count)
    names = [f"n{i + 1}" for i in range(count)]
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") // (count << 20)  # [MB]
    nodes = "\n".join(
        f"NodeName={name} NodeHostname=localhost NodeAddr=127.0.0.1 Port={port} CPUs=1 RealMemory={memory}"
        for name, port in zip(names, ports)
    )
    user = pwd.getpwuid(os.getuid()).pw_name
    (folder / "state").mkdir(exist_ok=True)
    for name in names:
        (folder / f"{name}.spool").mkdir(exist_ok=True)
    (folder / "slurm.conf").write_text(CONFIGURATION.format(folder=folder, control=control, user=user, nodes=nodes))
    return names


def start_node(folder, name):
    run("slurmd", "-N", name, SLURM_CONF=str(folder / "slurm.conf"))


def await_nodes(folder, names):
    environment = {**os.environ, "SLURM_CONF": str(folder / "slurm.conf")}
    for _ in range(300):
        answer = subprocess.run([find("sinfo"), "-hN", "-o", "%N %T"], env=environment, capture_output=True, text=True)
        states = dict(line.split() for line in answer.stdout.splitlines())
        if all(states.get(name) in ("idle", "mixed", "allocated") for name in names):
            return
        time.sleep(0.1)
    sys.exit(f"{folder}: Slurm did not come up: {answer.stdout} {answer.stderr}; see {folder}/*.log")


def start(folder, count):
    absent = missing()
    if absent:
        sys.exit(f"not installed: {', '.join(absent)}; apt install munge slurmctld slurmd slurm-client")
    folder.mkdir(parents=True, exist_ok=True)
    key = folder / "munge.key"
    key.touch(mode=0o600)
    key.write_bytes(os.urandom(1024))
    # --force: munge asks that nobody else may write to any folder above, which /tmp does not keep.
    run("munged", "--force", f"--key-file={key}", f"--socket={folder}/munge.socket", f"--log-file={folder}/munge.log",
        f"--pid-file={folder}/munge.pid", f"--seed-file={folder}/munge.seed")
    names = configure(folder, count)
    run("slurmctld", "-c", "-f", folder / "slurm.conf")
    for name in names:
        start_node(folder, name)
    await_nodes(folder, names)
    print(f"export SLURM_CONF={folder}/slurm.conf")


def processes():
    """(id, its parent's, its name, its environment) of all that may be looked at."""
    for entry in pathlib.Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        try:
            name, rest = (entry / "stat").read_text().split("(", 1)[1].rsplit(")", 1)
            yield int(entry.name), int(rest.split()[1]), name, set((entry / "environ").read_bytes().split(b"\0"))
        except OSError:
            continue


def kill(folder, node):
    """At once the daemon, what watches over the node's jobs, and the jobs."""
    mark = {f"SLURM_CONF={folder}/slurm.conf".encode(), f"SLURMD_NODENAME={node}".encode()}
    found = list(processes())
    jobs = [(pid, parent) for pid, parent, _, environment in found if mark <= environment]
    parents = {parent for _, parent in jobs}
    watchers = [pid for pid, _, name, _ in found if pid in parents and name == "slurmstepd"]
    daemon = int((folder / f"{node}.pid").read_text())
    for pid in [daemon, *watchers, *(pid for pid, _ in jobs)]:
        try:
            os.kill(pid, signal.SIGKILL)
        except ProcessLookupError:
            pass


def stop(folder):
    pid_files = [*folder.glob("n*.pid"), folder / "slurmctld.pid", folder / "munge.pid"]
    for file in sorted(pid_files, key=lambda each: each.name == "munge.pid"):
        try:
            pid = int(file.read_text())
            os.kill(pid, signal.SIGTERM)
            for _ in range(100):
                if "Z" in pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[:1]:
                    break  # only waits to be counted
                time.sleep(0.05)
            else:
                os.kill(pid, signal.SIGKILL)
        except (OSError, ValueError):
            continue  # it is gone


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("start", "kill", "revive", "stop"))
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("node", nargs="?")
    parser.add_argument("--nodes", type=int, default=2)
    asked = parser.parse_args()
    folder = asked.folder.resolve()
    if asked.what in ("kill", "revive") and not asked.node:
        parser.error("which NODE? n1, n2, ...")
    if asked.what == "start":
        start(folder, asked.nodes)
    elif asked.what == "stop":
        stop(folder)
    elif asked.what == "kill":
        kill(folder, asked.node)
    else:
        start_node(folder, asked.node)


if __name__ == "__main__":
    main()
