#!/usr/bin/python3
"""A Slurm cluster of its own: munge, a controller and nodes on loopback, without systemd and cgroups, as root or an ordinary user.

    cluster.py FOLDER [--nodes 2] [--cpus 2]      starts it, prints "ready", and ends it when its standard input does

All its files lie in FOLDER, which it makes (a short path, without blanks). SLURM_CONF=FOLDER/slurm.conf makes sbatch and the others use it. Whatever
runs in it is a descendant of this process, which adopts orphans: when the one who started it is killed, its standard input ends, and
all of them are killed.
"""
import argparse
import contextlib
import ctypes
import os
import pathlib
import pwd
import secrets
import shutil
import signal
import socket
import subprocess
import sys
import time

PROGRAMS = ("munged", "munge", "slurmctld", "slurmd", "sbatch", "squeue", "scontrol", "sinfo", "scancel")
PR_SET_CHILD_SUBREAPER = 36

# Heartbeats and credentials are of seconds instead of minutes, so that a dead node is noticed soon.
CONFIG = """\
ClusterName=fissuretest
SlurmctldHost={host}({address})
SlurmctldPort={port}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge/socket,cred_expire=5
CredType=cred/munge
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd-%n.pid
SlurmctldLogFile={folder}/log/slurmctld.log
SlurmdLogFile={folder}/log/slurmd-%n.log
MailProg=/bin/true
SlurmdParameters=config_overrides
MpiDefault=none
SwitchType=switch/none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerType=sched/builtin
SchedulerParameters=sched_interval=1,batch_sched_delay=0,sched_min_interval=0
MaxArraySize={array_size}
MaxJobCount=10000
ReturnToService=2
SlurmctldTimeout=10
SlurmdTimeout={node_timeout}
TCPTimeout=1
MessageTimeout=3
KillWait=2
InactiveLimit=0
"""


def missing_programs():
    return [name for name in PROGRAMS if not shutil.which(name)]


def free_ports(count):
    """As many neighbours that nobody listens on."""
    for _ in range(200):
        first = 20000 + secrets.randbelow(10000)
        try:
            with contextlib.ExitStack() as stack:
                for port in range(first, first + count):
                    one = stack.enter_context(socket.socket())
                    one.bind(("127.0.0.1", port))
            return first
        except OSError:
            continue
    sys.exit("cluster.py: no free ports")


def name_space():
    """A command in front of daemons: they listen on the address of the host's name, which must be a loopback one, else they get a host name
    of their own."""
    with contextlib.suppress(OSError):
        if socket.gethostbyname(socket.gethostname()) == "127.0.0.1":
            return [], socket.gethostname().split(".")[0]
    own = ["unshare", "--uts"] if os.geteuid() == 0 else ["unshare", "--user", "--map-current-user", "--keep-caps", "--uts"]
    own += ["sh", "-c", 'hostname localhost && exec "$@"', "sh"]
    if subprocess.run([*own, "true"], capture_output=True, check=False).returncode == 0:
        return own, "localhost"
    sys.exit("cluster.py: the host's name is not that of 127.0.0.1, and no other can be given to the daemons")


class Cluster:
    def __init__(self, folder, nodes, cpus, array_size, node_timeout):
        self.folder, self.nodes = folder, nodes
        folder.mkdir()  # not one that another cluster may still use
        for name in ("munge", "state", "log", *(f"spool-n{i + 1}" for i in range(nodes))):
            (folder / name).mkdir()
        folder.chmod(0o755)
        (folder / "munge").chmod(0o711)
        self.prefix, host = name_space()
        port = free_ports(nodes + 1)
        text = CONFIG.format(folder=folder, host=host, address="127.0.0.1", port=port, user=pwd.getpwuid(os.geteuid()).pw_name,
                             array_size=array_size, node_timeout=node_timeout)
        for i in range(nodes):
            text += f"NodeName=n{i + 1} NodeHostname={host} NodeAddr=127.0.0.1 Port={port + 1 + i} CPUs={cpus} State=UNKNOWN\n"
        text += f"PartitionName=all Nodes=n[1-{nodes}] Default=YES MaxTime=INFINITE State=UP\n"
        self.config = folder / "slurm.conf"
        self.config.write_text(text)
        os.environ["SLURM_CONF"] = str(self.config)
        key = folder / "munge/key"
        key.touch(mode=0o600)
        key.write_bytes(secrets.token_bytes(1024))

    def spawn(self, name, *command):
        with open(self.folder / "log" / f"{name}.out", "ab") as log:
            return subprocess.Popen([*self.prefix, *command], stdin=subprocess.DEVNULL, stdout=log, stderr=log, start_new_session=True)

    def wait_for(self, what, process, *command, until=lambda out: True):
        end = time.monotonic() + 60
        while True:
            answer = subprocess.run(command, capture_output=True, text=True, check=False)
            if answer.returncode == 0 and until(answer.stdout):
                return
            if process.poll() is not None or time.monotonic() > end:
                logs = "\n".join(f"== {log.name}\n{log.read_text(errors='replace')[-2000:]}"
                                 for log in sorted((self.folder / "log").iterdir()))
                sys.exit(f"cluster.py: {what} does not answer\n{logs}\n{answer.stderr}")
            time.sleep(0.05)

    def start_node(self, number):
        return self.spawn(f"slurmd-n{number}", "slurmd", "-D", "-N", f"n{number}", "-f", self.config)

    def start_controller(self):
        return self.spawn("slurmctld", "slurmctld", "-D", "-i", "-f", self.config)

    def start(self):
        munge = self.folder / "munge"
        munged = self.spawn("munged", "munged", "--foreground", "--force", f"--socket={munge}/socket", f"--key-file={munge}/key",
                            f"--pid-file={munge}/pid", f"--log-file={munge}/log", f"--seed-file={munge}/seed")
        self.wait_for("munged", munged, "munge", "-S", f"{munge}/socket", "-n")
        controller = self.start_controller()
        self.wait_for("slurmctld", controller, "scontrol", "ping", until=lambda out: " UP" in out)
        for number in range(1, self.nodes + 1):
            node = self.start_node(number)
        self.wait_for("a node", node, "sinfo", "-h", "-N", "-o", "%T", until=lambda out: out.split() == ["idle"] * self.nodes)


def descendants():
    """Of this process, from /proc: [(pid, is a zombie)]."""
    parents, zombies = {}, set()
    for entry in pathlib.Path("/proc").iterdir():
        if entry.name.isdigit():
            with contextlib.suppress(OSError):
                state, parent = (entry / "stat").read_text().rpartition(")")[2].split()[:2]
                parents[int(entry.name)] = int(parent)
                if state == "Z":
                    zombies.add(int(entry.name))
    found, grown = {os.getpid()}, True
    while grown:
        more = {pid for pid, parent in parents.items() if parent in found} - found
        found |= more
        grown = bool(more)
    return [(pid, pid in zombies) for pid in found - {os.getpid()}]


def reap(*_):
    """Orphans that have ended: nodes wait for zombies."""
    with contextlib.suppress(OSError):
        while os.waitpid(-1, os.WNOHANG)[0] > 0:
            pass


def end_all():
    """Kills until nobody is left: whom it kills last may have started another."""
    while alive := descendants():
        for pid, is_zombie in alive:
            if not is_zombie:
                with contextlib.suppress(OSError):
                    os.kill(pid, signal.SIGKILL)
        reap()
        time.sleep(0.01)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--nodes", type=int, default=2)
    parser.add_argument("--cpus", type=int, default=2)
    parser.add_argument("--array-size", type=int, default=1001)
    parser.add_argument("--node-timeout", type=int, default=3)
    arguments = parser.parse_args()
    os.environ["PATH"] += ":/usr/sbin:/sbin"
    if missing := missing_programs():
        sys.exit(f"cluster.py: there is no {missing[0]}: scripts/setup tests")
    if ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0) != 0:
        sys.exit("cluster.py: cannot adopt orphans")
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, lambda *_: sys.exit(1))
    try:
        cluster = Cluster(arguments.folder.resolve(), arguments.nodes, arguments.cpus, arguments.array_size, arguments.node_timeout)
        cluster.start()
        signal.signal(signal.SIGCHLD, reap)
        print("ready", flush=True)
        for line in sys.stdin:  # "node 2", "controller": the daemon of that name, after it was killed
            word, *number = line.split()
            if word == "node":
                cluster.start_node(int(number[0]))
            if word == "controller":
                cluster.start_controller()
    finally:
        end_all()


if __name__ == "__main__":
    main()
