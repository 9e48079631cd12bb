"""Faults of the system in the folders of scripts/fault_cases.py: little memory, a clock that is set, a worker that is stopped for a while."""
import os
import signal
import time

from fault_trial import session

DAY_S = 86400
MIB = 1 << 20
STOPPED_S = 0.3
WITH_WORKERS = {"run", "sweep", "study stability"}
LIMITED_ENGINE = '#!/bin/sh\nulimit -v KIB\nexec PROGRAM "$@"\n'


def least_memory(start):
    """The smallest address space, in MiB, in which `start(bytes)` succeeds: below, the system cannot even load the program."""
    low, high = 1, 1024
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if start(middle * MIB) else (middle, high)
    return high


def limits(shop, few, rng, program, most):
    """Address spaces, in bytes, from what the program needs to start to `most` MiB more."""
    least = least_memory(lambda size: shop.run(["--version" if program == "fissure" else "--help"], program=program, address_space=size)
                         .returncode == 0)
    return [int((least + most * (number + rng.random()) / few) * MIB) for number in range(few)]


def little_memory(shop, case, few, rng):
    for size in limits(shop, few, rng, "fissure", 40):
        yield size, shop.run(case.words, address_space=size)


def little_memory_of_workers(shop, case, few, rng):
    engines = shop.top / "engines"
    engines.mkdir(exist_ok=True)
    name = "fissure-engine-f64"
    for size in limits(shop, few, rng, name, 30):
        text = LIMITED_ENGINE.replace("KIB", str(size // 1024)).replace("PROGRAM", str(shop.programs / name))
        (engines / name).write_text(text)
        (engines / name).chmod(0o755)
        yield size, shop.run(case.words, engines=engines)


def clock_set(shift_s):
    def fault(shop, case, few, rng):
        for _ in range(few if shop.clock_reads else 0):
            reading = rng.randint(1, shop.clock_reads)
            shop.arm(clock_from=reading, clock_shift_s=shift_s)
            yield reading, shop.run(case.words)

    return fault


def clock_set_back_under_a_limit(shop, case, few, rng):
    """A run without end, whose time limit comes all the same."""
    endless = [*case.words, "--set", "time.duration_s=10000", "--set", "pipelines.fukuhara.time_limit_s=1"]
    for _ in range(max(1, few // 3)):
        shop.arm(clock_from=rng.randint(1, 500), clock_shift_s=-DAY_S)
        yield 1, shop.run(endless)


def worker_stopped(shop, case, few, rng):
    """Stopped in the middle of its run, and continued."""
    for _ in range(few):
        front = shop.start(case.words)
        worker = None
        while worker is None and front.poll() is None:
            worker = next((pid for pid, state, name in session(front.pid) if name.startswith("fissure-engine") and state != "Z"), None)
        time.sleep(rng.uniform(0, 0.05))
        for number, pause_s in ((signal.SIGSTOP, STOPPED_S), (signal.SIGCONT, 0)):
            try:
                os.kill(worker or front.pid, number)
            except ProcessLookupError:
                break
            time.sleep(pause_s)
        yield worker, shop.end(front)


def is_unharmed(ended):
    return ended.returncode == 0


def is_timeout(ended):
    return ended.returncode == 3 and "timeout" in ended.stdout


def may_fail(ended):
    return ended.returncode in (0, 2, 3)


def system_faults(shop, case, few, rng, look, report):
    """What a fault is called, and what was seen in each of its trials."""
    faults = [("clock set forward by a day", clock_set(DAY_S), is_unharmed), ("clock set back by a day", clock_set(-DAY_S), is_unharmed)]
    if case.name in WITH_WORKERS:
        faults.append(("worker stopped for a while (SIGSTOP, SIGCONT)", worker_stopped, is_unharmed))
    faults.append(("little memory (ulimit -v), all processes", little_memory, may_fail))
    if case.name == "run":  # a sweep would be planned anew for other workers
        faults.append(("little memory (ulimit -v), workers", little_memory_of_workers, may_fail))
        faults.append(("clock set back under a time limit of 1 s", clock_set_back_under_a_limit, is_timeout))
    for name, fault, is_promised in faults:
        found = []
        shop.renew()
        shop.arm()
        for number, ended in fault(shop, case, few, rng):
            seen = look(shop, case, ended)
            if not is_promised(ended):
                seen.bad.append("another end")
            report(shop, case.name, name, number, seen)
            found.append(seen)
            shop.renew()
            shop.arm()
        if found:
            yield name, found
