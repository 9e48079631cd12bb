"""What swept contact costs as meshes grow, for scripts/bench --growth: results/growth."""
import math
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from montage import COLOURS

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "results/growth"
CONTACT = (128, 512, 2048, 8192, 32768)
STEPS = {128: "spatula_press", 512: "plate_press", 2048: "plate_press_2048", 8192: "plate_press_8192"}
HEAD = """# What swept contact costs, by the size of the mesh

    /usr/bin/python3 scripts/bench --growth

Medians of one run on one machine, its benchmarks interleaved; times on different machines do not compare, ratios do. The contact stage is
that of the sphere and the blade of [spatula_press](../../configs/spatula_press.yaml), pressed 8 mm, without an engine; a whole step is
one of spatula_press (128 triangles) and of [plate_press](../../configs/plate_press.yaml) (512 and more), engine and contact,
nothing measured or stored. Growth: of the time, as a power of the number of triangles from the row above.

![Time of the contact stage and of a whole step over the number of triangles](growth.png)

"""


def growth(times, sizes, i):
    return f"{math.log(times[i] / times[i - 1]) / math.log(sizes[i] / sizes[i - 1]):.2f}" if i else ""


def contact_rows(found):
    swept = [found[f"detect/{n}/swept"] for n in CONTACT]
    times = [entry["real_time"] for entry in swept]
    yield "| triangles | contacts | swept over 16 x 16 nodes | growth of swept | allocations |\n|--:|--:|--:|--:|--:|\n"
    for i, n in enumerate(CONTACT):
        nodes = found[f"detect/{n}/16x16"]["real_time"]
        yield (f"| {n:,} | {swept[i]['contacts']:.0f} | {times[i] / nodes:.2f} | {growth(times, CONTACT, i)} | "
               f"{swept[i]['allocations']:.0f} |\n")


def step_rows(found):
    sizes = tuple(STEPS)
    times = [found[f"step/{name}/swept"]["real_time"] for name in STEPS.values()]
    yield "\n| triangles | scene | whole step, swept over default_tuned | growth of swept |\n|--:|---|--:|--:|\n"
    for i, (n, name) in enumerate(STEPS.items()):
        default = found[f"step/{name}/default_tuned"]["real_time"]
        yield f"| {n:,} | {name.split('_press')[0]}_press | {times[i] / default:.2f} | {growth(times, sizes, i)} |\n"


def draw(found):
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4), constrained_layout=True)
    unit = found["detect/128/swept"]["real_time"]
    for colour, what, label in zip(COLOURS, ("16x16", "swept"), ("fukuhara, 16 x 16 nodes", "swept")):
        left.loglog(CONTACT, [found[f"detect/{n}/{what}"]["real_time"] / unit for n in CONTACT], "o-", color=colour, label=label)
    left.loglog(CONTACT, [n / CONTACT[0] for n in CONTACT], ":", color="grey", label="in proportion to triangles")
    left.set_ylabel("contact stage, 1: swept on 128 triangles")
    unit = found["step/spatula_press/swept"]["real_time"]
    for colour, what, label in zip(COLOURS, ("default_tuned", "swept"), ("Bullet's default, tuned", "swept")):
        right.loglog(tuple(STEPS), [found[f"step/{name}/{what}"]["real_time"] / unit for name in STEPS.values()], "o-",
                     color=colour, label=label)
    right.loglog(tuple(STEPS), [n / 128 for n in STEPS], ":", color="grey", label="in proportion to triangles")
    right.set_ylabel("whole step, 1: swept on 128 triangles")
    for axis in (left, right):
        axis.set_xlabel("triangles of the tissue")
        axis.grid(alpha=0.3)
        axis.legend(frameon=False, fontsize=8)
    figure.savefig(FOLDER / "growth.png", dpi=90, metadata={"Software": None})
    plt.close(figure)


def write_growth(found):
    """`found`: each benchmark's median entry, by name."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    draw(found)
    (FOLDER / "README.md").write_text(HEAD + "".join(contact_rows(found)) + "".join(step_rows(found)))
