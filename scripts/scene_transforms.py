"""What random_scenes.py runs beside a scene: the same scene mirrored, turned, renumbered, in other units, thinned."""
import copy

import numpy as np

from scene_generator import plain, rotation

TURN = np.array([[0.0, 0, 1], [0, 1, 0], [-1, 0, 0]])  # by 90 degrees about the vertical
MIRROR = np.diag([-1.0, 1, 1])  # in the plane x = 0
POINTS = {"position_m", "start_m", "move_to_m", "gravity_m_s2"}
TURNS = {"orientation", "start_orientation", "rotate_to", "mount"}
OWN_FRAME = {"shape", "clamp", "nodes", "regions", "pipelines"}
# Exponents of length, mass and time, by the ending of a key; the longest ending that fits.
UNITS = {"_m_s2": (1, 0, -2), "_m_s": (1, 0, -1), "_N_s_m": (0, 1, -1), "_N_m": (0, 1, -2), "_Pa_s": (-1, 1, -1), "_Pa": (-1, 1, -2),
         "_kg_m3": (-3, 1, 0), "_1_s": (0, 0, -1), "_kg": (0, 1, 0), "_N": (1, 1, -2), "_s": (0, 0, 1), "_m": (1, 0, 0)}
MADE = {"turned": TURN, "mirrored": MIRROR, "renumbered": np.eye(3), "scaled": np.eye(3)}


def turned(quaternion, matrix):
    x, y, z, w = quaternion
    if np.linalg.det(matrix) < 0:
        return [x, -y, -z, w]
    s = np.sqrt(0.5)  # (0, s, 0, s) times the quaternion
    return [s * x + s * z, s * y + s * w, s * z - s * x, s * w - s * y]


def moved(item, matrix, key=""):
    """A scenario, or a part of it, with all that is in the scene's frame moved."""
    if key in OWN_FRAME:
        return item
    if key in POINTS:
        return plain(matrix @ item)
    if key in TURNS:
        return plain(turned(item, matrix))
    if key == "box":
        corners = matrix @ np.array([item["min_m"], item["max_m"]]).T
        return {"min_m": plain(corners.min(axis=1)), "max_m": plain(corners.max(axis=1))}
    if isinstance(item, dict):
        return {name: moved(value, matrix, name) for name, value in item.items()}
    return [moved(value, matrix) for value in item] if isinstance(item, list) else item


def with_orientations(scenario):
    for body in scenario["bodies"]:
        body.setdefault("orientation", [0.0, 0.0, 0.0, 1.0])
    for tool in scenario.get("tools", []):
        if tool["motion"]["type"] == "script":
            tool["motion"].setdefault("start_orientation", [0.0, 0.0, 0.0, 1.0])
    return scenario


def moved_scene(scene, matrix):
    scenario = with_orientations(copy.deepcopy(scene["scenario"]))
    files = copy.deepcopy(scene["files"])
    for content in files.values():
        if "rows" in content:
            content["rows"] = [[row[0], *plain(matrix @ row[1:4])] for row in content["rows"]]
    return {**scene, "scenario": moved(scenario, matrix), "files": files}


def turned_scene(scene):
    return moved_scene(scene, TURN)


def with_meshes(scene, run, matrix, rng=None):
    """Each body from its own vertices and cells, moved in its own frame; with `rng` in another order. `run`: one of the scene's."""
    made = copy.deepcopy(scene)
    flipped = np.linalg.det(matrix) < 0
    firsts = list(run["first_vertex"]) + [run["positions"].shape[1]]
    first_faces = list(run["first_face"]) + [len(run["faces"])]
    for b, body in enumerate(made["scenario"]["bodies"]):
        if f"volumes/{body['name']}/vertices" in run:
            points, cells = run[f"volumes/{body['name']}/vertices"], run[f"volumes/{body['name']}/tetrahedra"]
        else:
            points = run["positions"][0, firsts[b] : firsts[b + 1]]
            cells = run["faces"][first_faces[b] : first_faces[b + 1]] - firsts[b]
        own = (points - body["position_m"]) @ rotation(body.get("orientation", [0, 0, 0, 1])) @ matrix
        if flipped:
            cells = np.concatenate([cells[:, 1::-1], cells[:, 2:]], axis=1)
        if rng:
            order = rng.permutation(len(points))  # new number -> old one
            own, cells = own[order], np.argsort(order)[cells[rng.permutation(len(cells))]]
        if cells.shape[1] == 3:
            body["shape"] = {"type": "triangles", "vertices_m": plain(own), "faces": plain(cells)}
        else:
            name = f"cells{b}.vtk"
            made["files"][name] = {"vertices": plain(own), "tetrahedra": plain(cells)}
            body["shape"] = {"type": "tetrahedra", "file": name, "unit": "m"}
    return made


def mirrored_scene(scene, run):
    """Bodies and tools as mirrored meshes; boxes and jaws are their own mirror images."""
    made = with_meshes(scene, run, MIRROR)
    for tool in made["scenario"].get("tools", []):
        if tool["shape"]["type"] != "box" and "clamp" not in tool:
            vertices, faces = run[f"tools/{tool['name']}/vertices"], run[f"tools/{tool['name']}/faces"]
            tool["shape"] = {"type": "triangles", "vertices_m": plain(vertices @ MIRROR), "faces": plain(faces[:, [1, 0, 2]])}
    return moved_scene(made, MIRROR)


def renumbered_scene(scene, run, seed):
    """Vertices, triangles and tetrahedra in another order."""
    return with_meshes(scene, run, np.eye(3), np.random.Generator(np.random.PCG64(seed)))


def factor(key, m, kg, s):
    for ending, (length, mass, time) in UNITS.items():
        if key.endswith(ending):
            return m ** length * kg ** mass * s ** time
    return 1


def scaled(item, m, kg, s, key=""):
    if isinstance(item, dict):
        return {name: scaled(value, m, kg, s, name) for name, value in item.items()}
    if isinstance(item, list):
        return [scaled(value, m, kg, s, key) for value in item]
    by = factor(key, m, kg, s)
    return item if by == 1 or isinstance(item, (str, bool)) or key == "time_limit_s" else item * by


def scaled_law(law, m, kg, s):
    newton = kg * m / s ** 2 / (m ** 2 if law.get("per_area") else 1)
    n = law.get("n", 1)
    by = {"k": newton / (1 if law["model"] == "exponential" else m ** n), "lambda": newton * s / m ** (n + 1), "c": newton * s / m, "a": 1 / m}
    return {key: value * by.get(key, 1) if key in by else value for key, value in law.items()}


def factors(scenario):
    """Of length, mass and time: powers of four, which round as one does. A law that moves a tool does so in steps of a micronewton: there a newton stays one."""
    felt = any(tool.get("coupling", {}).get("force", "reaction") != "reaction" for tool in scenario.get("tools", []))
    return 4.0, 1 / 64 if felt else 16.0, 0.25


def scaled_scene(scene):
    m, kg, s = factors(scene["scenario"])
    scenario = scaled(copy.deepcopy(scene["scenario"]), m, kg, s)
    if "force" in scenario:
        scenario["force"] = [scaled_law(law, m, kg, s) for law in scene["scenario"]["force"]]
    files = copy.deepcopy(scene["files"])
    for content in files.values():
        if "rows" in content:
            content["rows"] = [[row[0] * s, *(v * m for v in row[1:])] for row in content["rows"]]
        else:
            content["vertices"] = plain(np.array(content["vertices"]) * m)
    return {**scene, "scenario": scenario, "files": files}


def thinned_scene(scene, every):
    made = copy.deepcopy(scene)
    made["scenario"]["record"].update(every=every, snapshots_every_s=every * made["scenario"]["time"]["step_s"])
    made["scenario"]["measure"]["every"] = 1
    return made
