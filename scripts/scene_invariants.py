"""What must hold of every run of a scene, whatever the scene: the invariants of random_scenes.py.

Each yields (run, complaint, explanation): no complaint where it holds; with a complaint an explanation, or "" where it is a fault.
A number compared is relative to the largest of its kind in the run, unless its line says otherwise.
"""
import re

import numpy as np

import scene_transforms as transforms
from scene_generator import rotation
from scene_result import differences

ROUNDING = 1e-9
FAR_TURN = np.cos(0.05)  # between quaternions: of a turn by 0.1 rad
BULLET = {"default", "null", "cluster"}
# Settings of a shell with which it has forces beside its springs and weight, or a time of its own.
OF_SHAPE = ("damping", "pose_matching", "drag", "lift", "pressure", "volume_conservation", "time_scale", "velocity_iterations", "drift_iterations")


def held(name):
    return name, "", ""


def broken(name, text):
    return name, text, ""


def explained(name, text, why):
    return name, text, why


def momentum_response(settings):
    """Whether contacts are impulses."""
    pipeline = settings["pipeline"]
    return pipeline == "swept" or settings.get("response", "none" if pipeline == "raycast" else "momentum") == "momentum" and pipeline in ("raycast", "fukuhara")


def elastic(scenario):
    return scenario["bodies"][0].get("model") == "elastic"


# How it ends.


def ends(case):
    """Exit code as the book says, one line for what is refused, a reason for what ends early."""
    lines = [line for line in case.stderr.splitlines() if ": warning: " not in line]
    if case.code not in (0, 3):
        yield broken("", f"exit code {case.code}: {' / '.join(lines)}")
        return
    for run in case.runs.values():
        detail = run.attrs["status_detail"]
        if run.status == "non_finite":
            step = run.summary["non_finite_at_step"]
            good = detail and "\n" not in detail and step >= 0 and f"at step {step}" in detail and len(run["time"]) == step + 1
            yield held(run.name) if good else broken(run.name, f"non_finite without where: {detail!r}, step {step}, {len(run['time'])} rows")
        elif run.status == "timeout":
            good = re.fullmatch(r"time limit of \S+ s reached (after step \d+ of \d+|before its first step)", detail)
            why = "tissue that flies apart takes up to 10,000 substeps in a step, and tissue without room for itself a search in each"
            yield explained(run.name, "timeout", why) if good else broken(run.name, f"timeout: {detail}")
        elif run.status != "ok":
            yield broken(run.name, f"{run.status}: {detail}")
        elif detail or run.summary["steps"] != case.steps or run.summary["non_finite_at_step"] != -1:
            yield broken(run.name, f"ok with {detail!r}, {run.summary['steps']} steps of {case.steps}")
        else:
            yield held(run.name)
    failed = any(run.status != "ok" for run in case.runs.values())
    if failed != (case.code == 3):
        yield broken("", f"exit code {case.code} with statuses {[run.status for run in case.runs.values()]}")


def missing_is_meant(case, run, path, values):
    """Mask of values that may be NaN."""
    name, settings, mask = path.split("/")[-1], run.settings(case.scenario), np.zeros(values.shape, bool)
    if name == "stand_off":
        return np.ones(values.shape, bool)
    if path.startswith("timing/"):
        mask[0] = True
    if name in ("reaction_force", "tool_reaction", "clamp_reaction"):
        if run.pipeline in BULLET or run.pipeline == "prescribed" and not elastic(case.scenario):
            mask[...] = True
        if name != "reaction_force" and not momentum_response(settings):
            mask[...] = True
    if name in ("viscous_loss", "energy_error", "mass_damping_loss") and run.pipeline == "deformable":
        mask[...] = True
    if name in ("jaw_opening", "jaw_angle"):
        hinged = np.array([tool["clamp"]["opening"] == "hinged" for tool in case.scenario["tools"] if "clamp" in tool])
        mask[:, hinged if name == "jaw_opening" else ~hinged] = True
    if name == "node_thickness":
        mask |= run[path.replace("thickness", "partner")] < 0
    for i, law in enumerate(case.scenario.get("force", [])):  # too large for a number
        step = run.summary.get(f"force_non_finite_at_step_{law['name']}")
        if step is not None and "law" in run.axes[path]:
            np.moveaxis(mask, run.axes[path].index("law"), 0)[i] |= True
    if run.status == "non_finite":
        if path.startswith("force_inputs"):
            mask[len(mask) - int(run["force_inputs/row_size"][-1]) :] = True
        elif path in ("positions", "contact_pressure"):
            mask[-1] = True
        elif run.over_time(path) is not None:
            np.moveaxis(mask, run.over_time(path), 0)[-1] = True
    return mask


def no_number_is_missing(case):
    """No NaN and no infinity but where the book of the format has a meaning for it, and the last row of a run that ended non_finite."""
    for run in case.finished():
        bad = []
        for path, values in run.items():
            if values.dtype.kind == "f":
                found = ~np.isfinite(values) & ~missing_is_meant(case, run, path, values)
                if found.any():
                    bad.append(f"{path}{np.argwhere(found)[0].tolist()}")
        touched = "contact_count" in run and bool((run["contact_count"] > 0).any())
        for name, value in run.summary.items():
            if isinstance(value, str) or np.isfinite(value) or run.status != "ok":
                continue
            overflows = any(key.startswith("force_non_finite_at_step_") for key in run.summary)
            if ("_force_" in f"_{name}" or "_resultant_" in name) and overflows or name == "first_contact_time_s" and not touched or "roughness" in name or name.endswith("final_lag_m"):
                continue  # there is nothing that it could be of
            if "reaction" in name and (run.pipeline in BULLET or run.pipeline == "prescribed" or not momentum_response(run.settings(case.scenario))):
                continue
            if name == "energy_balance_error" and (run.pipeline == "deformable" or not run["tool_work"].any() if "tool_work" in run else True):
                continue
            bad.append("summary " + name)
        yield broken(run.name, "NaN in " + ", ".join(bad[:5])) if bad else held(run.name)


# Depth and proof.


def proof_and_depth_agree(case):
    """A step that is proved free of overlap has depth 0, inverted tissue counted, and nothing passes through between two such steps."""
    for run in case.finished():
        if "certified" not in run:
            continue
        proved = run["certified"] == 1
        worst_m = max((float(np.nanmax(run[name][proved])) for name in ("penetration_depth", "inversion_aware_depth") if proved.any()), default=0)
        passing = np.diff(run["passed_through"])[proved[1:] & proved[:-1]]
        summary = run.summary
        if worst_m > ROUNDING * case.size_m:
            yield broken(run.name, f"{worst_m:.3g} m deep in a proved step")
        elif (passing > 0).any():
            text, steps = "passed through between proved steps", np.flatnonzero(proved[1:] & proved[:-1])[passing > 0] + 1
            turns = np.abs((run["tool_quaternion"][1:] * run["tool_quaternion"][:-1]).sum(axis=2)).min(axis=1)
            far = turns[steps - 1] < FAR_TURN
            if far.all():
                yield explained(run.name, text, "of a tool that turns far in a step, samples go straight in space and tissue, for the proof, in the tool's frame")
            else:
                yield broken(run.name, text)
        elif summary["certified_steps"] != proved.sum() or summary["uncertified_steps"] != (~proved).sum():
            yield broken(run.name, "the summary counts other proved steps than the series")
        elif summary["max_penetration_depth_m"] != np.nanmax(run["penetration_depth"]) and run.status == "ok":
            yield broken(run.name, "the summary's depth is not the largest of the series")
        else:
            yield held(run.name)


def swept_holds(case):
    """What starts outside stays outside, proved, unless a step had no room for it, or the run says that it had none without proof."""
    for run in case.finished():
        if run.pipeline != "swept" or "certified" not in run or run.status != "ok" or case.scenario["time"].get("settle_s"):
            continue
        free = run["certified"][0] == 1 and run.summary["freeing_steps"] == 0 and run.summary["no_room_steps"] == 0
        if free and not run["certified"].all() and run.get("substeps", np.ones(1)).max() > 1 and not run["inversion_aware_depth"].any():
            yield explained(run.name, "steps without proof, none of them with depth", "the proof takes the path of a step for straight, and in substeps tissue goes round a tool")
        elif free and not run["certified"].all():
            yield broken(run.name, f"{int((run['certified'] == 0).sum())} steps without proof: {run.summary.get('first_uncertified', '')}")
        elif free:
            yield held(run.name)


# Forces.


def law_value(law, x, rate, area_m2):
    """Elastic and viscous terms of a law at deformations, before what pulls is cut off."""
    k = law["k"]
    terms = {"hunt_crossley": lambda: (k * x ** law["n"], law["lambda"] * x ** law["n"] * rate), "kelvin_voigt": lambda: (k * x, law["c"] * rate),
             "linear_elastic": lambda: (k * x, 0 * x), "exponential": lambda: (k * np.expm1(law["a"] * x), law["c"] * rate)}[law["model"]]()
    return [term * (area_m2 if law.get("per_area") else 1) for term in terms]


def laws_never_pull(case):
    """The force of a law is the sum over its triangles of what its formula gives, never below zero, along their directions."""
    for run in case.finished():
        if "force_inputs/row_size" not in run or run.status != "ok" or any(name.startswith("force_non_finite") for name in run.summary):
            continue
        ends_at = np.cumsum(run["force_inputs/row_size"])
        starts_at = ends_at - run["force_inputs/row_size"]
        directions, complaint = run["force_inputs/direction"], ""
        for i, law in enumerate(case.laws()):
            x, rate = run["force_inputs/deformation"][:, i], run["force_inputs/deformation_rate"][:, i]
            terms = law_value(law, x, rate, run["force_inputs/area"])
            if (x < 0).any():
                complaint = f"{law['name']}: a deformation below zero"
            pushes = np.maximum(terms[0] + terms[1], 0)
            sums = np.array([(pushes[a:b, None] * directions[a:b]).sum(axis=0) for a, b in zip(starts_at, ends_at)])
            reach = np.array([pushes[a:b].sum() for a, b in zip(starts_at, ends_at)])[:, None]
            off = np.abs(sums - run["force"][i]) > ROUNDING * reach + 1e-300
            if off.any():
                complaint = f"{law['name']}: force {run['force'][i][off.any(axis=1)][0]} where its triangles give {sums[off.any(axis=1)][0]}"
            if (run["force_elastic"][i] < 0).any():
                complaint = f"{law['name']}: an elastic term below zero"
            if (np.linalg.norm(run["force"][i], axis=1) > reach[:, 0] * (1 + ROUNDING) + 1e-300).any():
                complaint = f"{law['name']}: more force than its triangles have together"
        lengths = np.linalg.norm(directions, axis=1)
        if (lengths > 1 + ROUNDING).any():
            complaint = "a direction longer than 1"
        if "tool_force" in run and (np.abs(run["tool_force"].sum(axis=2) - run["force"]) > ROUNDING * np.abs(run["tool_force"]).sum(axis=2) + 1e-300).any():
            complaint = complaint or "forces on single tools do not add up"
        yield broken(run.name, complaint) if complaint else held(run.name)


def in_tool_frame(run, t):
    """Tissue in the frame of tool `t` at each step, [step, vertex, xyz]."""
    origins, turns = run["tool_position"][:, t], [rotation(q) for q in run["tool_quaternion"][:, t]]
    return np.array([(x - o) @ r for x, o, r in zip(run["positions"], origins, turns)])


def plates(case, run):
    """(tool, axis, side) of single boxes without friction, before one of whose large faces all tissue lies in all steps."""
    tools = case.scenario.get("tools", [])
    for t, tool in enumerate(tools):
        if len(tools) > 1 or "clamp" in tool or tool["shape"]["type"] != "box" or tool["friction"] > 0:
            continue
        half, at = np.array(tool["shape"]["size_m"]) / 2, in_tool_frame(run, t)
        axis = int(np.argmin(half))
        others = [a for a in range(3) if a != axis]
        if (np.abs(at[..., others]) < half[others] - 4 * case.margin_m).all():
            for side in (1, -1):
                if (side * at[..., axis] > 0).all():
                    yield t, axis, side


def reaction_never_pulls(case):
    """On a plate without friction the reaction points away from the tissue, and the largest pressure of contacts is never below zero."""
    for run in case.finished():
        if run.status != "ok" or "reaction_force" not in run:
            continue
        complaint, looked = "", False
        if "max_pressure" in run:  # of the single vertices of a coarse mesh some may be below zero, where contacts push across their normals
            looked = True
            if (run["max_pressure"] < 0).any():
                complaint = "max_pressure below zero"
        if momentum_response(run.settings(case.scenario)) and len(run["time"]) == len(run["positions"]):
            for t, axis, side in plates(case, run):
                normals = np.array([rotation(q)[:, axis] * side for q in run["tool_quaternion"][:, t]])
                pull_N = np.einsum("ij,ij->i", run["reaction_force"], normals)
                largest_N = np.abs(run["reaction_force"]).max()
                looked |= largest_N > 0
                if (pull_N > ROUNDING * largest_N).any():
                    complaint = f"the reaction pulls with {pull_N.max():.3g} of {largest_N:.3g} N"
        if looked:
            yield broken(run.name, complaint) if complaint else held(run.name)


def far_is_free(case):
    """No contact, force and reaction in a step at both of whose ends boxes around tool and tissue are farther apart than both went and four margins."""
    for run in case.finished():
        if "tool_position" not in run or run.status != "ok" or len(run["time"]) != len(run["positions"]):
            continue
        near, springs_there = np.zeros(len(run["time"]), bool), np.zeros(len(run["time"]), bool)
        near[0] = "settle_s" in case.scenario["time"]  # how far the last step of settling went is not known
        firsts = list(run["first_vertex"]) + [run["positions"].shape[1]]
        walk_m = np.zeros(len(run["time"]))
        walk_m[1:] = np.linalg.norm(np.diff(run["positions"], axis=0), axis=2).max(axis=1)
        for t, name in enumerate(run.texts("tool")):
            vertices, tissue = run[f"tools/{name}/vertices"], in_tool_frame(run, t)
            for a, b in zip(firsts, firsts[1:]):
                gap = np.maximum(tissue[:, a:b].min(axis=1) - vertices.max(axis=0), vertices.min(axis=0) - tissue[:, a:b].max(axis=1))
                away_m = np.linalg.norm(np.maximum(gap, 0), axis=1)
                went_m = np.zeros(len(away_m))
                went_m[1:] = np.linalg.norm(np.diff(tissue[:, a:b], axis=0), axis=2).max(axis=1)
                close = away_m < 4 * case.margin_m + 2 * (went_m + walk_m)
                middle = tissue[:, a:b].mean(axis=1)
                outside_m = np.linalg.norm(np.maximum(np.maximum(vertices.min(axis=0) - middle, middle - vertices.max(axis=0)), 0), axis=1)
                springs_there |= outside_m < np.linalg.norm(tissue[0, a:b] - middle[0], axis=1).max() + 4 * case.margin_m
                near |= close
                near[1:] |= close[:-1]
        far = ~near
        reaction = np.nan_to_num(run["reaction_force"])
        acting = (run["contact_count"] > 0) | (reaction != 0).any(axis=1)
        if "force" in run:
            acting |= (run["force"] != 0).any(axis=(0, 2)) | (run["colliding_triangles"] > 0)
        if not far.any():
            continue
        if not (acting & far).any():
            yield held(run.name)
            continue
        text = f"contact or force at step {int(np.argmax(acting & far))}, where nothing is near"
        settings = run.settings(case.scenario)
        if run.pipeline in ("default", "null", "deformable") and settings.get("settings", "stock") == "stock":
            yield explained(run.name, text, "the stock cell of Bullet's distance field is larger than the scene")
        elif run.pipeline in BULLET | {"deformable"}:
            yield explained(run.name, text, "Bullet's own margins and cells are lengths of their own")
        elif not elastic(case.scenario) and springs_there[acting & far].all():
            yield explained(run.name, text, "contacts meet a shell where its springs have put it within the step, up to its size at rest, before they push "
                                            "it back")
        elif run.pipeline == "swept" and run.summary["freeing_steps"] > 0:
            yield explained(run.name, text, "a tool without room stands, for its contacts, where it had some, and presses from there until it gets round the tissue")
        else:
            yield broken(run.name, text)


# Balances.


def momentum_balances(case):
    """The momentum of free tissue changes by its weight less what contacts took, step by step."""
    scenario = case.scenario
    if any("fixed" in body for body in scenario["bodies"]) or scenario["time"].get("settle_s"):
        return
    for run in case.finished():
        settings = run.settings(scenario)
        own_ground = run.pipeline == "swept" or settings.get("ground_contact") == "half_space" or "ground" not in scenario
        if run.status != "ok" or not momentum_response(settings) or not own_ground or settings.get("precision") == "f32":
            continue
        if elastic(scenario):
            if "mass_damping_1_s" in scenario["bodies"][0]["elastic"]:
                continue
        else:
            if any(key in body["solver"] for body in scenario["bodies"] for key in OF_SHAPE) or any("soft_contact" in body for body in scenario["bodies"]):
                continue
        mass_kg = case.mass_kg(run)
        if mass_kg is None:
            continue
        dt = scenario["time"]["step_s"]
        change = np.diff(run["momentum"], axis=0) / dt
        taken = run["reaction_force"][1:] if "reaction_force" in run else np.zeros_like(change)
        if "ground_reaction" in run:
            taken = taken + run["ground_reaction"][1:]
        weight = mass_kg * np.array(scenario["world"]["gravity_m_s2"])
        size = np.abs(change).max() + np.abs(taken).max() + np.abs(weight).max() + np.abs(run["momentum"]).max() / dt
        inner = np.sqrt(2 * mass_kg * run["kinetic_energy"].max()) / dt  # at least what rounds: the vertices' own momenta together
        off = np.abs(change + taken - weight).max()
        rest = mass_kg * case.size_m / dt ** 2  # whose rounding places at rest have
        limit = 1e-7 * np.abs(weight).max() + 1e-9 * size + 1e-12 * inner + 1e-15 * rest  # Bullet takes steps in single precision
        yield broken(run.name, f"{off:.3g} N unaccounted for of {size:.3g} N") if off > limit else held(run.name)


def has_exploded(run, step):
    """Whether the run says that its tissue explodes, in this step or before."""
    return "explodes" in run.summary.get("unsound_tissue", "") and step >= run.summary["first_unsound_step"]


def energy_balances(case):
    """Energies of elastic tissue balance: the error is what the other energies leave, losses only grow, and elements at rest have none."""
    for run in case.finished():
        if "stored_energy" not in run or run.status != "ok" or run.pipeline == "deformable":
            continue
        total = run["kinetic_energy"] + run["stored_energy"] + run["gravity_energy"] + run["viscous_loss"] + run["mass_damping_loss"] - run["contact_work"]
        size = max(np.abs(run[name]).max() for name in ("kinetic_energy", "stored_energy", "gravity_energy", "viscous_loss", "mass_damping_loss", "contact_work"))
        complaint, reason = "", ""
        stiffest = max(float(body["elastic"]["youngs_modulus_Pa"]) for body in case.bodies() if body["model"] == "elastic")
        if size > 0 and np.abs(total - total[0] - run["energy_error"] + run["energy_error"][0]).max() > ROUNDING * size:
            complaint = f"energy_error is off by {np.abs(total - total[0] - run['energy_error']).max() / size:.3g} of the largest energy"
        # Velocities are half a substep behind positions, and losses and stored energy are taken between: near 0 they are off by a share of all energy.
        for name in ("viscous_loss", "mass_damping_loss"):
            if (np.diff(run[name]) < -1e-3 * size).any():
                if not complaint and has_exploded(run, np.diff(run[name]).argmin() + 1):
                    reason = "of tissue that explodes within a few substeps, losses are taken between velocities that have little in common"
                complaint = complaint or f"{name} falls"
        if (run["kinetic_energy"] < 0).any() or (run["stored_energy"] < -0.05 * size - 1e-13 * stiffest * run["volume"][0]).any():
            complaint, reason = "an energy below zero", ""
        if "tool_work" in run and np.abs(run["tool_work"] - run["contact_work"] - run["contact_loss"]).max() > ROUNDING * max(size, np.abs(run["tool_work"]).max()):
            complaint, reason = "contact_loss is not tool_work less contact_work", ""
        yield explained(run.name, complaint, reason) if reason else broken(run.name, complaint) if complaint else held(run.name)


# The same scene once more.


def null_is_default(case):
    """Pipeline null equals default bit for bit."""
    if "twin" not in case.runs or case.runs["twin"].status == "timeout":  # of another load of the machine
        return
    for null in case.finished():
        if null.pipeline == "null":
            found = differences(null, case.runs["twin"], apart=("@pipeline", "@description"))
            yield broken(null.name, f"differs from default in {found[:4]}") if found else held(null.name)


def repeats(case):
    """The scenario that is stored in the result gives the same bits once more."""
    other = case.other("resolved")
    for run in case.finished() if other else ():
        if other[run.name].status != "timeout":  # of another load of the machine
            found = differences(run, other[run.name])
            yield broken(run.name, f"differs in {found[:4]}") if found else held(run.name)


def thins(case):
    """With record.every the rows are some of the same rows, and the summary is the same."""
    other = case.other("thinned")
    for run in case.finished() if other else ():
        thin = other[run.name]
        if thin.status == "timeout":
            continue
        if thin.status != run.status:
            yield broken(run.name, f"ends {thin.status} in place of {run.status}")
            continue
        kept = np.flatnonzero(np.isin(run["time"], thin["time"]))
        found = [f"summary {name}" for name in sorted(set(run.summary) | set(thin.summary))
                 if name not in run.summary or name not in thin.summary or not np.array_equal(run.summary[name], thin.summary[name], equal_nan=not isinstance(run.summary[name], str))]
        for path in run:
            axis = run.over_time(path)
            if axis is None:
                continue
            if not np.array_equal(np.take(run[path], kept, axis=axis), thin[path], equal_nan=run[path].dtype.kind == "f"):
                found.append(path)
        if len(kept) != len(thin["time"]) or kept[-1] != len(run["time"]) - 1:
            found.append("time")
        yield broken(run.name, f"differs in {found[:4]}") if found else held(run.name)


# Symmetry.


def matched(points, others, tolerance_m):
    """For each point the index of the other one at its place; None where they are not the same set."""
    if len(points) != len(others):
        return None
    distances_m = np.linalg.norm(points[:, None] - others[None], axis=2)
    found = distances_m.argmin(axis=1)
    return found if distances_m.min(axis=1).max() <= tolerance_m and len(set(found)) == len(found) else None


def triangles_of(faces, numbers=None, flipped=False):
    faces = faces if numbers is None else numbers[faces]
    faces = faces[:, ::-1] if flipped else faces
    return {tuple(np.roll(face, -int(np.argmin(face)))) for face in faces}


def same_meshes(case, run, other, matrix, numbers):
    """Whether tissue and tools of `other` are those of `run`, moved."""
    flipped = np.linalg.det(matrix) < 0
    if triangles_of(run["faces"], numbers, flipped) != triangles_of(other["faces"]):
        return False
    for body in case.scenario["bodies"]:
        path = f"volumes/{body['name']}/"
        if path + "vertices" in run:
            at = matched(run[path + "vertices"] @ matrix.T, other[path + "vertices"], 1e-9 * case.size_m)
            cells = run[path + "tetrahedra"]
            if at is None or {frozenset(c) for c in at[cells].tolist()} != {frozenset(c) for c in other[path + "tetrahedra"].tolist()}:
                return False
    for path in run:
        if flipped and path.startswith("tools/") and path.endswith("/vertices"):
            own, its = run[path], other[path]
            box = len(own) == 8 and len(run[path.replace("vertices", "faces")]) == 12
            at = matched(own @ matrix.T, its, 1e-9 * case.size_m)
            faces = path.replace("vertices", "faces")
            if at is None or not box and triangles_of(run[faces], at, True) != triangles_of(other[faces]):
                return False
    return True


def of_contact(run):
    """The first step in which contacts, tools' or the ground's, did anything; the number of rows where none did."""
    acting = np.zeros(len(run["time"]), bool)
    for name in ("contact_count", "contact_work", "reaction_force", "ground_reaction", "colliding_triangles"):
        if name in run:
            acting |= np.nan_to_num(run[name].reshape(len(acting), -1)).any(axis=1)
    return int(np.argmax(acting)) if acting.any() else len(acting)


def moves_alike(case, variant):
    """The variant's tissue is where this scene's is, moved: until the first contact to rounding, and in its first step by a share of the motion."""
    other, matrix = case.other(variant), transforms.MADE[variant]
    length = transforms.factors(case.scenario)[0] if variant == "scaled" else 1
    if not other or case.scenario["time"].get("settle_s"):
        return
    for run in case.finished():
        its = other[run.name]
        if its.status not in ("ok", "non_finite") or run.pipeline == "deformable":
            continue
        single = run.settings(case.scenario).get("precision") == "f32"
        numbers = matched(run["positions"][0] @ matrix.T, its["positions"][0] / length, (1e-5 if single else 1e-7) * case.size_m)
        if numbers is None or variant != "scaled" and not same_meshes(case, run, its, matrix, numbers):
            yield broken(run.name, "its meshes are others")
            continue
        here, there = run["positions"] @ matrix.T, its["positions"][:, numbers] / length
        rows = min(len(here), len(there))
        # In powers of four nothing rounds, and contacts must be the same too.
        contact = rows if variant == "scaled" else min(of_contact(run), of_contact(its))
        if contact < 2:
            continue
        shell = not elastic(case.scenario)
        reordered = shell and variant in ("mirrored", "renumbered")
        if reordered:
            if "ground" in case.scenario or any("fixed" in body or body.get("mass_from_faces") or body.get("soft_contact") or any(key in body["solver"] for key in OF_SHAPE)
                                                   for body in case.scenario["bodies"]):
                continue
            # Springs are relaxed one after the other, in the order of the triangles: vertices go other ways, their middle does not.
            here, there = here.mean(axis=1, keepdims=True), there.mean(axis=1, keepdims=True)
        off_m = np.linalg.norm(here[:rows] - there[:rows], axis=2).max(axis=1)
        went_m = np.maximum.accumulate(np.linalg.norm(run["positions"] - run["positions"][0], axis=2).max(axis=1))[:rows]
        share, floor = (1e-3, 1e-4) if single else (1e-2, 1e-8) if reordered else (1e-6, 1e-9)
        free = (np.arange(rows) < contact) & np.isfinite(here[:rows] + there[:rows]).all(axis=(1, 2))
        bad = off_m > share * went_m + floor * case.size_m
        if (bad & free).any():
            step = int(np.argmax(bad & free))
            text = f"{off_m[step]:.3g} m off at step {step}, where tissue has moved {went_m[step]:.3g} m; first contact at {of_contact(run)}"
            if has_exploded(run, step):
                yield explained(run.name, text, "what rounds grows with tissue that explodes")
            else:
                yield broken(run.name, text)
        elif bad.any():
            yield explained(run.name, f"apart from step {int(np.argmax(bad))} on, first contact at {contact}",
                            "contacts are looked for and swept in the order of a tree and of numbers, and what they do from then on is chaotic")
        else:
            yield held(run.name)


def turns(case):
    """A scene turned by 90 degrees about the vertical gives the turned result."""
    return moves_alike(case, "turned")


def mirrors(case):
    """A mirrored scene gives the mirrored result."""
    return moves_alike(case, "mirrored")


def renumbers(case):
    """Vertices and elements in another order give the same result."""
    return moves_alike(case, "renumbered")


def scales(case):
    """An elastic scene in other units of length, mass and time gives the same result in these units, contacts too where nothing rounds."""
    other = case.other("scaled")
    yield from moves_alike(case, "scaled")
    m, kg, s = transforms.factors(case.scenario)
    powers = {"reaction_force": (1, 1, -2), "momentum": (1, 1, -1), "stored_energy": (2, 1, -2), "kinetic_energy": (2, 1, -2), "max_pressure": (-1, 1, -2)}
    for run in case.finished() if other else ():
        its = other[run.name]
        if its.status not in ("ok", "non_finite") or run.pipeline == "deformable":
            continue
        stiff = case.scenario["bodies"][0]["elastic"]["youngs_modulus_Pa"]  # what is below a billionth of these is rounding
        floors = {"reaction_force": stiff * case.size_m ** 2, "momentum": case.least_momentum(), "max_pressure": stiff}
        until = min(len(run["time"]), len(its["time"]))
        for name, (length, mass, time) in powers.items():
            if name in run and until > 0:
                scale = floors.get(name, stiff * case.size_m ** 3)
                a, b = run[name][:until], its[name][:until] / (m ** length * kg ** mass * s ** time)
                finite = np.isfinite(a + b)
                a, b = np.where(finite, a, 0), np.where(finite, b, 0)
                if np.abs(a - b).max() > 1e-6 * np.abs(a).max() + 1e-9 * scale:
                    yield broken(run.name, f"{name} is {b.ravel()[np.abs(a - b).argmax()]:.6g} in its own units in place of {a.ravel()[np.abs(a - b).argmax()]:.6g}")


INVARIANTS = {function.__name__: function for function in (
    ends, no_number_is_missing, proof_and_depth_agree, swept_holds, laws_never_pull, reaction_never_pulls, far_is_free, momentum_balances,
    energy_balances, null_is_default, repeats, thins, turns, mirrors, renumbers, scales)}
VARIANT = {"repeats": "resolved", "thins": "thinned", "turns": "turned", "mirrors": "mirrored", "renumbers": "renumbered", "scales": "scaled"}


# What each must notice: changes of a run that was good.


def change(name, value, at=-1):
    def apply(case, run):
        run[name][at] = run[name][at] + value(case, run)
    return apply


def far_contact(case, run):
    run["contact_count"][...] = 1


def next_to(number):
    return np.nextafter(number, np.inf) if np.isfinite(number) else 0.0


def of_variant(name):
    def apply(case, run):
        other = case.results[name][run.name]
        if name == "thinned":
            other["kinetic_energy"][-1] = next_to(other["kinetic_energy"][-1])
        elif name == "resolved":
            other["positions"][-1, 0, 0] = next_to(other["positions"][-1, 0, 0])
        else:
            other["positions"][1:] = other["positions"][1:] + 0.1 * case.size_m
    return apply


def unexplained(case, run):
    run.attrs["status_detail"] = ""
    run.summary["steps"] = run.summary["steps"] + 1


def deep_though_proved(case, run):
    if not run["certified"].any():
        run.summary["certified_steps"] = run.summary["certified_steps"] + 1
    run["penetration_depth"][np.argmax(run["certified"] == 1)] += 1e-6 * case.size_m


def overlapping(case, run):
    run["certified"][-1], run["inversion_aware_depth"][-1] = 0, case.size_m


def pulling(case, run):
    if "max_pressure" in run:
        run["max_pressure"][-1] = -1
    run["reaction_force"][...] *= -1


def pulling_law(case, run):
    run["force"][...] = -run["force"] - 1


def another_twin(case, run):
    case.runs["twin"]["volume"][-1] *= 1 + 1e-15


CHANGES = {
    "ends": unexplained, "no_number_is_missing": change("volume", lambda case, run: np.nan, at=0), "proof_and_depth_agree": deep_though_proved,
    "swept_holds": overlapping, "laws_never_pull": pulling_law, "reaction_never_pulls": pulling, "far_is_free": far_contact,
    "momentum_balances": change("momentum", lambda case, run: 1e-3 * np.abs(run["momentum"]).max() + 1e-3 * case.least_momentum()),
    "energy_balances": change("energy_error", lambda case, run: 1e-3 * run["stored_energy"].max() + 1e-3 * run["kinetic_energy"].max() + 1e-30),
    "null_is_default": another_twin, **{name: of_variant(variant) for name, variant in VARIANT.items()}}
