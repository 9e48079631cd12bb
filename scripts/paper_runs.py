"""The runs behind results/paper, and the numbers taken from them; used by scripts/reproduce."""
import pathlib

import h5py
import numpy as np

from references import ROOT, fissure

METHOD = "{name: paper, pipeline: fukuhara, response: none, vertex_contacts: false}"  # the paper's, and nothing else
DEFAULTS = "{name: default, pipeline: default, settings: stock}, {name: default_tuned, pipeline: default, settings: tuned}"
NODES = "{pipeline: fukuhara}"
OURS = NODES + ", {pipeline: swept}"
SPEED = "tools.{}.motion.segments.0.speed_m_s={}"
SPEEDS_M_S = (0.02, 0.1, 2)
PRESSES_MM = (1, 5, 25)
THICKNESSES_MM = (2, 8, 30)


def pipelines(*entries):
    return f"pipelines=[{', '.join(entries)}]"


class Run:
    """One call of fissure: a scenario of configs/ with overrides."""

    def __init__(self, config, *overrides, frames=False):
        self.config, self.overrides, self.frames = config, overrides, frames

    def make(self, arguments, path):
        """Pictures change no number, and are drawn only where the page is written."""
        words = [word for override in ("expect=[]", *self.overrides) for word in ("--set", override)]
        words += [] if self.frames and not arguments.check else ["--no-frames"]
        fissure(arguments, "run", ROOT / f"configs/{self.config}.yaml", "-o", path, "--force", "-j", "2", *words)


def all_runs():
    """By part, then by name."""
    everything = pipelines(DEFAULTS, "{pipeline: raycast}", METHOD, OURS)
    press = {"press": Run("spatula_press", everything, frames=True),
             "fast": Run("spatula_press", everything, SPEED.format("spatula", 2), "record.frames.every_s=0.005", frames=True)}
    for speed in SPEEDS_M_S:
        for mm in PRESSES_MM:
            press[f"spatula_{speed}_{mm}"] = Run(
                "spatula_press", pipelines(DEFAULTS, METHOD, OURS), SPEED.format("spatula", speed),
                f"tools.spatula.motion.segments.0.move_to_m=[0, {0.061 - mm / 1000:.4g}, 0]")
    plate = {f"plate_{speed}": Run("plate_press", pipelines(DEFAULTS, METHOD, OURS), SPEED.format("plate", speed),
                                   "measure.sample_spacing_m=0.002") for speed in (0.1, 10)}
    thickness = {f"thick_{mm}": Run(
        "spatula_press", pipelines("{pipeline: raycast}", METHOD),
        f"tools.spatula.shape.size_m=[0.04, {mm / 1000}, 0.015]", f"tools.spatula.motion.start_m=[0, {0.066 + mm / 2000}, 0]",
        f"tools.spatula.motion.segments.0.move_to_m=[0, {0.035 + mm / 2000}, 0]") for mm in THICKNESSES_MM}
    law = {"law": Run("spatula_press", pipelines("{pipeline: raycast}", METHOD, NODES), "time.settle_s=0")}
    shape = {"convex": Run("convex_spatula", pipelines(METHOD, OURS), "measure.sample_spacing_m=0.001", frames=True),
             "coarse": Run("convex_spatula", pipelines(METHOD, OURS), "bodies.sphere.shape.subdivisions=2",
                           "measure.sample_spacing_m=0.001"),
             "unlimited": Run("convex_spatula", pipelines(METHOD), "bodies.sphere.shape.subdivisions=2",
                              "tools.spatula.nodes.lone_nodes=true", "measure.sample_spacing_m=0.001")}
    clamp = {"sphere": Run("clamp_sphere", "record.frames.camera={position_m: [0.08, 0.1, 0.22], look_at_m: [0, 0.045, 0]}",
                           frames=True),
             "sphere_paper": Run("clamp_sphere", pipelines(METHOD), "tools.clamp.friction=0"),
             "vessel": Run("clamp_vessel", frames=True),
             "vessel_paper": Run("clamp_vessel", pipelines(METHOD), "tools.clamp.friction=0")}
    return {"press": {**press, **plate}, "thickness": thickness, "law": law, "shape": shape, "clamp": clamp}


class Result:
    """What the page needs of one result file."""

    def __init__(self, path):
        self.path = pathlib.Path(path)

    def summary(self, run, name):
        with h5py.File(self.path) as file:
            return file[f"pipelines/{run}/summary"].attrs[name]

    def read(self, run, name):
        with h5py.File(self.path) as file:
            return file[f"pipelines/{run}/{name}"][()]

    def depth_mm(self, run):
        return 1000 * float(self.summary(run, "max_penetration_depth_m"))

    def inverted(self, run):
        return int(self.summary(run, "max_inverted_triangles"))

    def passed(self, run):
        return int(self.summary(run, "passed_through_samples"))

    def law_error_N(self, run, k=200.0, n=1.3):
        """Largest difference between the recorded elastic term and the formula on the snapshots, from positions and contact states.

        Where a triangle would pull, the law leaves both of its terms out: those instants are not compared.
        """
        positions, faces = self.read(run, "positions"), self.read(run, "faces")
        centroids = positions[:, faces].mean(axis=2)
        deformation = np.linalg.norm(centroids - centroids[0], axis=2)
        colliding = self.read(run, "vertex_contact").astype(bool)[:, faces].any(axis=2)
        formula = (k * deformation**n * colliding).sum(axis=1)
        rows = np.searchsorted(self.read(run, "time"), self.read(run, "snapshot_time"))
        compared = self.read(run, "adhesion_clamped")[0][rows] == 0
        assert compared.sum() > 10 and formula[compared].max() > 1
        return float(np.abs(formula - self.read(run, "force_elastic")[0][rows])[compared].max())

    def unmutual_nodes(self, run, tool):
        """Nodes with a partner, and those among them whose partner has another one."""
        partner = self.read(run, f"tools/{tool}/node_partner")
        paired = np.flatnonzero(partner >= 0)
        return len(paired), int(np.sum(partner[partner[paired]] != paired))

    def clamp_force_N(self, run, law=0):
        """Time, the left and the right jaw's force, and the resultant, by magnitude."""
        jaws = self.read(run, "tool_force")[law]
        whole = self.read(run, "clamp_force")[law, :, 0]
        length = [np.linalg.norm(vector, axis=1) for vector in (jaws[:, 0], jaws[:, 1], whole)]
        return self.read(run, "time"), *length


def take_numbers(results):
    """(name, value, unit) of everything that the page says, from the results that are there."""
    numbers = []

    def add(name, value, unit):
        numbers.append((name, float(value), unit))

    for name, result in results.items():
        with h5py.File(result.path) as file:
            runs = list(file["pipelines"])
        for run in runs:
            add(f"{name}/{run}/depth", result.depth_mm(run), "mm")
            add(f"{name}/{run}/inverted", result.inverted(run), "1")
            add(f"{name}/{run}/passed", result.passed(run), "1")
            add(f"{name}/{run}/roughness", result.summary(run, "force_roughness"), "1")
            add(f"{name}/{run}/peak_force", result.summary(run, "max_force_N"), "N")
    if "press" in results:
        add("press/triangles", len(results["press"].read("paper", "faces")), "1")
    if "law" in results:
        for run in ("raycast", "paper", "fukuhara"):
            add(f"law/{run}/error", results["law"].law_error_N(run), "N")
    if "convex" in results:
        paired, unmutual = results["convex"].unmutual_nodes("paper", "spatula")
        add("convex/paired_nodes", paired, "1")
        add("convex/unmutual_nodes", unmutual, "1")
        thickness = results["convex"].read("paper", "tools/spatula/node_thickness")
        add("convex/thinnest_pair", 1000 * np.nanmin(thickness), "mm")
        add("convex/thickest_pair", 1000 * np.nanmax(thickness), "mm")
    for name, run in (("sphere", "fukuhara"), ("sphere_paper", "paper")):
        if name in results:
            time, left, right, whole = results[name].clamp_force_N(run)
            held = time > time[-1] - 0.1
            for what, force in (("left", left), ("right", right), ("resultant", whole)):
                add(f"{name}/{run}/{what}_held", force[held].mean(), "N")
            add(f"{name}/{run}/resultant_largest", whole.max(), "N")
    if "vessel" in results:
        add("vessel/fukuhara/final_reaction", results["vessel"].summary("fukuhara", "clamp_final_reaction_N"), "N")
    return numbers
