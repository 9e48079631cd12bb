#!/usr/bin/python3
"""A sweep through a real Slurm of two nodes in which a task is killed, one runs out of time, and a node dies, and another in which the controller
dies: their tables are that of one process.

    sweep_test.py FISSURE RESULT_BITS      exit code 77 where Slurm is not installed
"""
import argparse
import contextlib
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

import cluster

SCENARIO = """\
format: 1
name: press
description: A blade pressed into a soft sphere.
time: {{step_s: 0.001, settle_s: 0.005, duration_s: {duration_s:.3f}}}
ground: {{height_m: 0}}
bodies:
  - name: sphere
    shape: {{type: sphere, radius_m: 0.03, subdivisions: 1}}
    position_m: [0, 0.03, 0]
    mass_kg: 0.1
    material: {{linear_stiffness: 0.5}}
    solver: {{pose_matching: 0.02, damping: 0.01, dynamic_friction: 0.5, position_iterations: 10}}
tools:
  - name: spatula
    shape: {{type: box, size_m: [0.04, 0.002, 0.015]}}
    nodes: {{resolution: [4, 4]}}
    motion:
      type: script
      start_m: [0, 0.062, 0]
      segments:
        - {{move_to_m: [0, 0.052, 0], speed_m_s: 0.5}}
pipelines: [{{pipeline: fukuhara}}]
force: [{{name: hc, model: hunt_crossley, k: 200, lambda: 50, n: 1.3}}]
"""
SWEEP = """\
format: 1
name: blades
description: 24 simulations, two force laws in each.
base: press.yaml
axes:
  - {path: bodies.sphere.mass_kg, linear: {from: 0.05, to: 0.2, count: 8}}
  - {path: bodies.sphere.material.linear_stiffness, values: [0.3, 0.5, 0.7]}
  - {path: force.hc.k, values: [100, 200]}
curves: {quantities: [force, penetration_depth], every_s: 0.01}
"""


def say(*words):
    print(f"{time.monotonic() - START:6.2f} s ", *words, flush=True)


def check(holds, what):
    if not holds:
        raise AssertionError(what)


def wait_until(what, holds, most_s=300):
    end = time.monotonic() + most_s
    while True:
        if found := holds():
            return found
        check(time.monotonic() < end, f"waited {most_s} s in vain: {what}")
        time.sleep(0.02)


START = time.monotonic()


class Fissure:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def __call__(self, *words, code=0):
        ended = subprocess.run([self.program, *words], cwd=self.folder, capture_output=True, text=True, check=False)
        check(ended.returncode == code, f"fissure {words}: exit code {ended.returncode}, expected {code}\n{ended.stdout}{ended.stderr}")
        return ended.stdout if code == 0 else ended.stderr


def processes():
    """{pid: (name, words of the command, environment)} of those that belong to jobs of this cluster."""
    found = {}
    for entry in pathlib.Path("/proc").iterdir():
        if entry.name.isdigit():
            with contextlib.suppress(OSError):
                environment = dict(word.partition("=")[::2] for word in (entry / "environ").read_text(errors="replace").split("\0"))
                if environment.get("SLURM_CONF") == os.environ["SLURM_CONF"]:
                    command = (entry / "cmdline").read_text(errors="replace").split("\0")
                    found[int(entry.name)] = ((entry / "comm").read_text().strip(), command, environment)
    return found


def fronts():
    """{shard: (pid, node)} of the sessions that run."""
    return {int(environment["SLURM_ARRAY_TASK_ID"]): (pid, environment["SLURMD_NODENAME"])
            for pid, (name, command, environment) in processes().items() if name == "fissure" and "--shard" in command}


def has_recorded(pid):
    """Whether a session has finished a simulation: something is in the journal that it has open."""
    with contextlib.suppress(OSError):
        for number in pathlib.Path(f"/proc/{pid}/fd").iterdir():
            if os.readlink(number).endswith(".journal") and number.stat().st_size > 0:
                return True
    return False


def recorded_bytes(folder):
    return sum(journal.stat().st_size for journal in (folder / "journals").glob("*.journal"))


def parent_of(pid):
    return int(pathlib.Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[1])


def kill(pids):
    for pid in pids:
        with contextlib.suppress(ProcessLookupError):
            os.kill(pid, signal.SIGKILL)


def daemon(*words):
    """The process of this cluster whose command begins with these words."""
    for entry in pathlib.Path("/proc").iterdir():
        if entry.name.isdigit():
            with contextlib.suppress(OSError):
                command = (entry / "cmdline").read_text().split("\0")[:-1]
                if command[: len(words)] == list(words) and os.environ["SLURM_CONF"] in command:
                    return int(entry.name)
    raise AssertionError(f"no daemon {words}")


def kill_node(node):
    """What a loss of power ends: the daemon of a node, the step daemons, and all that they run."""
    kill([daemon("slurmd", "-D", "-N", node)])
    lost = {pid for pid, (_, _, environment) in processes().items() if environment.get("SLURMD_NODENAME") == node}
    steps = set()
    for pid in lost:
        with contextlib.suppress(OSError):
            if pathlib.Path(f"/proc/{parent_of(pid)}/comm").read_text().strip() == "slurmstepd":
                steps.add(parent_of(pid))
    kill(steps)
    kill(lost)


def queued():
    return subprocess.run(["squeue", "-h", "-r", "-o", "%i %T %r"], capture_output=True, text=True, check=True).stdout.split("\n")[:-1]


class Cluster:
    """cluster.py, in a process of its own; it ends all when this one ends, however it does."""

    def __init__(self, folder):
        os.environ["SLURM_CONF"] = str(folder / "slurm.conf")
        self.guardian = subprocess.Popen([sys.executable, "-B", cluster.__file__, folder], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                         text=True, start_new_session=True)
        check(self.guardian.stdout.readline() == "ready\n", "the cluster did not start")

    def start(self, daemon_name):
        """Again, after it was killed: "controller", or "node 2"."""
        self.guardian.stdin.write(daemon_name + "\n")
        self.guardian.stdin.flush()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.guardian.stdin.close()
        self.guardian.wait(60)


def break_things(job):
    """The session of one task is killed, the other node dies, and another task's time is up. The shard of the first."""
    def sessions(node):
        return {shard: pid for shard, (pid, where) in fronts().items() if where == node}

    wait_until("two sessions on each node", lambda: len(sessions("n1")) == 2 and len(sessions("n2")) == 2)
    killed, late = sorted(sessions("n1"))
    kill([sessions("n1")[killed]])
    say(f"session of shard {killed} killed")
    kill_node("n2")
    say("node n2 killed")
    wait_until(f"a simulation of shard {late}", lambda: has_recorded(sessions("n1").get(late, 0)))
    subprocess.run(["scancel", "--batch", "--signal=USR1", f"{job}_{late}"], check=True)
    say(f"time is up for shard {late}")
    return killed, late


def break_and_resume(fissure, folder):
    refused = fissure("sweep", "sweep.yaml", "-o", "d", "--engine", "slurm", "--shards", "1001", code=2)
    check("takes 1000 " in refused, refused)
    submitted = json.loads(fissure("sweep", "sweep.yaml", "-o", "d", "--engine", "slurm", "--shards", "4", "--json"))
    check(submitted["missing"] == "1-4", submitted)
    job = submitted["array_job"]
    refused = fissure("sweep", "d", "--engine", "slurm", code=2)
    check("jobs of this sweep are queued" in refused, refused)
    killed, late = break_things(job)
    check(f"{job} (array)" in fissure("sweep", "status", "d"), "status names no job")

    wait_until("an empty queue", lambda: not queued())
    say("the queue is empty")
    logs = {log.name: log.read_text() for log in (folder / "d/slurm/logs").iterdir()}
    check("back to the queue" in logs[f"{job}_{late}.log"], logs)
    check(f"merge_{submitted['merge_job']}.log" in logs, logs)
    left = json.loads(fissure("sweep", "status", "d", "--json"))["unfinished_simulations"]
    check(left > 0, "the killed session left nothing to do")

    array = folder / "d/slurm/array.sbatch"
    array.write_text(array.read_text().replace("# What the program needs", "echo edited\n# What the program needs"))
    again = json.loads(fissure("sweep", "d", "--engine", "slurm", "--json"))
    check(again["missing"] == str(killed) and again["shards"] == 4, again)
    twice = json.loads(fissure("sweep", "d", "--engine", "slurm", "--json", "--again"))
    say(f"{left} simulations of shard {killed} submitted again, twice")
    wait_until("an empty queue", lambda: not queued())
    for submission in (again, twice):
        log = (folder / f"d/slurm/logs/{submission['array_job']}_{killed}.log").read_text()
        check(log.startswith("edited\n"), log)


def idle_nodes():
    return subprocess.run(["sinfo", "-h", "-N", "-o", "%T"], capture_output=True, text=True, check=False).stdout.split().count("idle")


def resubmitted(fissure, name):
    """Whether something of a sweep is missing once the cluster has nothing to do; then it is submitted again, and ended."""
    wait_until("an empty queue", lambda: not queued())
    wait_until("the end of sessions that the controller has forgotten", lambda: not fronts())
    missing = json.loads(fissure("sweep", "status", name, "--json"))["unfinished_simulations"]
    if missing == 0 and (fissure.folder / name / "sweep.h5").exists():
        return False
    say("submitted again:", json.loads(fissure("sweep", name, "--engine", "slurm", "--json")))
    return True


def lose_controller_midway(fissure, folder, the_cluster):
    """slurmctld is killed in the middle of an array, simulations go on without it, and it starts again. It writes its queue every five seconds: jobs
    that it took after it last did are lost with it, and their sessions are killed as nobody's, or end by themselves. Jobs that had ended may run
    once more. Then the user submits the sweep again, and what is recorded counts."""
    fissure("sweep", "sweep.yaml", "-o", "e", "--engine", "slurm", "--shards", "4")
    wait_until("a record", lambda: recorded_bytes(folder / "e") > 0)
    kill([daemon("slurmctld")])
    before = recorded_bytes(folder / "e")
    unknown = fissure("sweep", "d", "--engine", "slurm", code=3)
    check(unknown.count("\n") == 1, unknown)
    wait_until("a record that is made without the controller", lambda: recorded_bytes(folder / "e") > before)
    recorded = {path: path.read_bytes() for path in (folder / "e/journals").glob("*.journal")}
    the_cluster.start("controller")
    wait_until("the controller", lambda: " UP" in subprocess.run(["scontrol", "ping"], capture_output=True, text=True, check=False).stdout)
    say("controller killed and started again")
    submissions = 1
    while resubmitted(fissure, "e"):
        submissions += 1
        check(submissions < 4, "a sweep that was submitted three times is not complete")
    for path, content in recorded.items():
        if content:  # sessions that end without a record remove their journals
            check(path.read_bytes().startswith(content), f"{path}: lost what was recorded before the controller came back")


def check_table(arguments, folder, name):
    same = subprocess.run([sys.executable, "-B", arguments.result_bits, folder / "truth/sweep.h5", folder / name / "sweep.h5"],
                          capture_output=True, text=True, check=False)
    check(same.returncode == 0, f"{name}: other data in\n{same.stdout}{same.stderr}")
    check((folder / "truth/sweep.csv").read_bytes() == (folder / name / "sweep.csv").read_bytes(), f"{name}: another sweep.csv")


def write_scenario(fissure, path):
    """A simulation that takes about a second of this machine, so that sessions of six last until something is done to them."""
    path.write_text(SCENARIO.format(duration_s=2))
    start = time.monotonic()
    fissure("run", path.name, "-o", "timed.h5")
    taken_s = time.monotonic() - start
    path.write_text(SCENARIO.format(duration_s=min(40, 5 / taken_s)))
    say(f"two simulated seconds take {taken_s:.2f} s")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("fissure")
    parser.add_argument("result_bits", help="the script that compares two results")
    arguments = parser.parse_args()
    os.environ["PATH"] += ":/usr/sbin:/sbin"
    if missing := cluster.missing_programs():
        print(f"skipped: Slurm is not installed (there is no {missing[0]}): scripts/setup tests")
        sys.exit(77)
    with tempfile.TemporaryDirectory(prefix="fissure-slurm-") as temporary:
        folder = pathlib.Path(temporary) / "it's a sweep"
        folder.mkdir()
        os.environ["TMPDIR"] = temporary  # for what killed tasks leave behind
        (folder / "sweep.yaml").write_text(SWEEP)
        fissure = Fissure(arguments.fissure, folder)
        write_scenario(fissure, folder / "press.yaml")
        fissure("sweep", "sweep.yaml", "-o", "truth", "-j", "2")
        say("simulated here")
        with Cluster(pathlib.Path(temporary) / "c") as the_cluster:
            say("cluster started")
            break_and_resume(fissure, folder)
            the_cluster.start("node 2")
            wait_until("both nodes", lambda: idle_nodes() == 2)
            lose_controller_midway(fissure, folder, the_cluster)
        for name in "de":
            check_table(arguments, folder, name)
        say("the same tables")


if __name__ == "__main__":
    main()
