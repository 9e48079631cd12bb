"""Random valid scenes for random_scenes.py: a scenario as YAML has it, with the meshes and logs that it names.

A scene is drawn in a length `size_m`, about the radius of its bodies: 1e-3 to 1e3 times 30 mm. Tools start far away, near, touching
or inside, and go into the tissue, along it, out of it, or through it.
"""
import copy
import io

import numpy as np
import yaml

LAWS = ["hunt_crossley", "kelvin_voigt", "linear_elastic", "exponential"]
PRESETS = ["liver", "brain", "vessel_wall", "ecoflex_00_10", "ecoflex_00_30", "ecoflex_00_50", "ecoflex_00_10_thinned"]
NODES, BULLET = {"raycast", "fukuhara"}, {"default", "null", "cluster"}


class Draw:
    """Random choices from a seed and the number of a scene: the same on every machine."""

    def __init__(self, seed, number):
        self.rng = np.random.Generator(np.random.PCG64([seed, number]))

    def chance(self, share):
        return bool(self.rng.random() < share)

    def number(self, low, high):
        return float(self.rng.uniform(low, high))

    def power(self, low, high):
        """10 to a power between these."""
        return float(10 ** self.rng.uniform(low, high))

    def whole(self, low, high):
        """`high` included."""
        return int(self.rng.integers(low, high + 1))

    def one(self, *choices):
        return choices[self.whole(0, len(choices) - 1)]

    def some(self, choices, least, most):
        count = min(self.whole(least, most), len(choices))
        return [choices[i] for i in sorted(self.rng.permutation(len(choices))[:count])]

    def direction(self):
        vector = self.rng.normal(size=3)
        return vector / np.linalg.norm(vector)

    def quaternion(self):
        vector = self.rng.normal(size=4)
        return plain(vector / np.linalg.norm(vector))


def plain(values):
    """As YAML takes it: floats and ints of Python, not of NumPy."""
    return np.asarray(values).tolist()


def rotation(quaternion):
    x, y, z, w = np.asarray(quaternion) / np.linalg.norm(quaternion)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def octahedron(radii):
    """A closed surface: eight triangles, outward."""
    vertices = np.concatenate([np.diag(radii), -np.diag(radii)])
    faces = [[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5]]
    return plain(vertices), faces


def split(vertices, faces):
    """Each triangle in four."""
    vertices, middle = [list(v) for v in vertices], {}

    def between(a, b):
        key = (min(a, b), max(a, b))
        if key not in middle:
            middle[key] = len(vertices)
            vertices.append([(p + q) / 2 for p, q in zip(vertices[a], vertices[b])])
        return middle[key]

    finer = []
    for a, b, c in faces:
        ab, bc, ca = between(a, b), between(b, c), between(c, a)
        finer += [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
    return vertices, finer


def lump(draw, size_m, finer):
    """An ellipsoid with dents."""
    vertices, faces = octahedron([1, 1, 1])
    for _ in range(finer):
        vertices, faces = split(vertices, faces)
    radii = np.array([draw.number(0.7, 1.3) for _ in range(3)])
    points = [np.asarray(v) / np.linalg.norm(v) for v in vertices]
    return {"vertices": [plain(size_m * draw.number(0.9, 1.1) * radii * p) for p in points], "faces": faces}


def sheet(size_m, thickness_m, cells):
    """An open rectangle, bent across x."""
    rows = [[[size_m * (2 * i / cells - 1), thickness_m * (2 * i / cells - 1) ** 2, size_m * 0.5 * (2 * k - 1)]
             for k in range(2)] for i in range(cells + 1)]
    faces = [face for i in range(cells) for face in ([2 * i, 2 * i + 1, 2 * i + 3], [2 * i, 2 * i + 3, 2 * i + 2])]
    return {"vertices": [vertex for row in rows for vertex in row], "faces": faces}


def file_text(name, content):
    """The text of a mesh, a volume or a log, by the ending of its name."""
    if "rows" in content:
        return "\n".join([",".join(content["columns"])] + [",".join(map(repr, row)) for row in content["rows"]]) + "\n"
    vertices, text = content["vertices"], io.StringIO()
    line = lambda values: text.write(" ".join(map(repr, values)) + "\n")
    if name.endswith(".vtk"):
        cells = content["tetrahedra"]
        text.write("# vtk DataFile Version 3.0\nscene\nASCII\nDATASET UNSTRUCTURED_GRID\n" + f"POINTS {len(vertices)} double\n")
        for vertex in vertices:
            line(vertex)
        text.write(f"CELLS {len(cells)} {5 * len(cells)}\n")
        for cell in cells:
            line([4, *cell])
        text.write(f"CELL_TYPES {len(cells)}\n" + "10\n" * len(cells))
        return text.getvalue()
    faces = content["faces"]
    if name.endswith(".obj"):
        for vertex in vertices:
            text.write("v ")
            line(vertex)
        for face in faces:
            text.write("f ")
            line([v + 1 for v in face])
    elif name.endswith(".off"):
        text.write(f"OFF\n{len(vertices)} {len(faces)} 0\n")
        for vertex in vertices:
            line(vertex)
        for face in faces:
            line([3, *face])
    elif name.endswith(".ply"):
        text.write(f"ply\nformat ascii 1.0\nelement vertex {len(vertices)}\nproperty double x\nproperty double y\nproperty double z\n"
                   f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
        for vertex in vertices:
            line(vertex)
        for face in faces:
            line([3, *face])
    else:
        text.write("solid scene\n")
        for face in faces:
            text.write("facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {' '.join(map(repr, vertices[v]))}\n" for v in face) + "endloop\nendfacet\n")
        text.write("endsolid scene\n")
    return text.getvalue()


def write(scene, folder, name="scene"):
    """The scenario and its files; the path of the scenario."""
    folder.mkdir(parents=True, exist_ok=True)
    for file, content in scene["files"].items():
        (folder / file).write_text(file_text(file, content))
    path = folder / f"{name}.yaml"
    path.write_text(yaml.safe_dump({**scene["scenario"], "name": name}, sort_keys=False, default_flow_style=None, width=140))
    return path


class Generator:
    """One scene."""

    def __init__(self, seed, number):
        self.draw = draw = Draw(seed, number)
        self.files, self.kinds = {}, set()
        self.elastic = draw.chance(0.45)
        self.size_m = 0.03 * (draw.power(-3, 3) if draw.chance(0.45) else 1)
        self.margin_m = self.size_m * draw.power(-3, -1.2)
        self.steps = draw.one(draw.whole(10, 30), draw.whole(10, 60))
        self.force = []

    def scene(self):
        draw = self.draw
        self.kinds.add("elastic" if self.elastic else "shell")
        bodies = [self.body(i) for i in range(1 if self.elastic or draw.chance(0.75) else draw.whole(2, 3))]
        self.choose_time(bodies[0])
        if draw.chance(0.6):
            self.force = [self.law(i) for i in range(draw.whole(1, 3))]
        tools = [self.tool(i, bodies) for i in range(draw.one(0, *[1] * 12, 2, 2, 3))]
        ground = self.ground(bodies)
        scenario = {"format": 1, "name": "scene",
                    "time": {"step_s": self.step_s, "duration_s": self.steps * self.step_s},
                    "world": {"gravity_m_s2": self.gravity_m_s2}}
        if draw.chance(0.15):
            scenario["time"]["settle_s"] = self.step_s * draw.whole(1, 8)
        if ground:
            scenario["ground"] = ground
        scenario.update(bodies=bodies, tools=tools, pipelines=self.pipelines(bodies, tools, ground))
        if not tools:
            del scenario["tools"]
        if self.force:
            scenario["force"] = self.force
        scenario["record"] = {"every": 1, "snapshots_every_s": self.step_s}
        if self.force:
            scenario["record"]["force_inputs"] = True
        scenario["measure"] = {"certify": draw.chance(0.95)}
        if draw.chance(0.6):
            scenario["measure"]["sample_spacing_m"] = 0.06 * self.size_m
        for run in scenario["pipelines"]:
            self.kinds.add(f"pipeline {run['pipeline']}")
        return {"scenario": scenario, "files": self.files, "kinds": sorted(self.kinds), "size_m": self.size_m}

    # Bodies.

    def surface(self, size_m, prefix, fine):
        """A closed shape about `size_m` in radius, its half extents, and its kind."""
        draw = self.draw
        kind = draw.one("sphere", "sphere", "box", "box", "capsule", "lobes", "triangles", "file")
        if kind == "sphere":
            return {"type": kind, "radius_m": size_m, "subdivisions": draw.one(0, 1, 1, 2)}, [size_m] * 3
        if kind == "box":
            half = [size_m * draw.number(0.5, 1.3) for _ in range(3)]
            cells = draw.one([1, 1, 1], [2, 2, 2], [4, 2, 4], [3, 2, 3], [2, 2, 1]) if fine else [1, 1, 1]
            return {"type": kind, "size_m": [2 * h for h in half], "cells": cells}, half
        if kind == "capsule":
            radius_m, length_m = size_m * draw.number(0.4, 0.8), size_m * draw.number(0.2, 1.2)
            return ({"type": kind, "radius_m": radius_m, "length_m": length_m, "subdivisions": draw.one(0, 1, 1)},
                    [radius_m + length_m / 2, radius_m, radius_m])
        if kind == "lobes":
            half = [size_m * draw.number(0.9, 1.2), size_m * draw.number(0.5, 0.8), size_m * draw.number(0.9, 1.2)]
            return ({"type": kind, "size_m": [2 * h for h in half], "slit_depth_m": half[1] * draw.number(0.4, 1.2),
                     "slit_width_m": half[0] * draw.number(0.1, 0.4), "edge_m": size_m * draw.number(0.5, 0.8)}, half)
        mesh = lump(draw, size_m, draw.one(0, 1, 1))
        half = np.abs(mesh["vertices"]).max(axis=0).tolist()
        if kind == "triangles" or not 0.002 < size_m < 0.5:  # files of other sizes are refused
            return {"type": "triangles", "vertices_m": mesh["vertices"], "faces": mesh["faces"]}, half
        name = f"{prefix}.{draw.one('obj', 'stl', 'ply', 'off')}"
        self.files[name] = mesh
        return {"type": kind, "file": name, "unit": "m"}, half

    def body(self, index):
        draw, size_m = self.draw, self.size_m
        shape, half = self.surface(size_m, f"body{index}", True)
        self.kinds.add(f"body {shape['type']}")
        body = {"name": f"body{index}", "shape": shape, "margin_m": self.margin_m}
        turned, least = draw.chance(0.4), float(min(half))
        if turned:
            body["orientation"] = draw.quaternion()
            half = [max(half)] * 3
        self.half = half = np.asarray(half)
        gap_m = size_m * draw.one(0.2, 0.02, 0, -0.1)
        on_its_side = shape["type"] == "lobes" and not turned  # their origin is at their foot
        body["position_m"] = [0.0 if index == 0 else index * (2.4 * size_m + gap_m), 0.0 if on_its_side else float(half[1]), 0.0]
        if draw.chance(0.35):
            at, thin_m = np.array(body["position_m"]), 0.3 * min(least, size_m)
            if draw.chance(0.5):
                body["fixed"] = [{"below_m": float(at[1] + thin_m * (draw.number(0, 0.5) if on_its_side else draw.number(-1, 1)))}]
            else:
                body["fixed"] = [{"box": {"min_m": plain(at - 3 * half), "max_m": plain(at + [0.1234 * thin_m, 3 * half[1], 3 * half[2]])}}]  # not through a vertex
        if self.elastic:
            body["model"], body["elastic"] = "elastic", self.elastic_material()
        else:
            self.shell(body)
        if draw.chance(0.2):
            far = 3 * half
            body["gauges"] = [{"name": f"gauge{index}", "box": {"min_m": plain(np.array(body["position_m"]) - far),
                                                               "max_m": plain(np.array(body["position_m"]) + far)}}]
        return body

    def elastic_material(self):
        draw = self.draw
        material = {"material": draw.one("neo_hookean", "neo_hookean", "linear_corotated", "saint_venant_kirchhoff"),
                    "friction": draw.one(0.2, 0.0, draw.number(0, 1))}
        if draw.chance(0.2):
            material["preset"] = draw.one(*PRESETS)
        else:
            material.update(youngs_modulus_Pa=draw.power(2, 7), density_kg_m3=draw.power(2, 4),
                            poissons_ratio=draw.one(0.0, 0.3, 0.4, 0.45, 0.49))
        if draw.chance(0.3):
            material["viscosity_Pa_s"] = material.get("youngs_modulus_Pa", 1e4) * draw.power(-5, -3.5) * min(1, self.size_m / 0.03)
        if draw.chance(0.2):
            material["mass_damping_1_s"] = draw.power(-1, 2)
        return material

    def shell(self, body):
        draw = self.draw
        body["mass_kg"] = draw.power(-3, 1)
        solver = {"position_iterations": draw.whole(1, 10), "dynamic_friction": draw.one(0.2, 0.0, 0.5, draw.number(0, 1))}
        for key, value, share in (("damping", draw.power(-3, -0.5), 0.3), ("pose_matching", draw.power(-2.5, -0.5), 0.4),
                                  ("volume_conservation", draw.power(-1, 2), 0.1), ("pressure", draw.number(-5, 5), 0.1),
                                  ("drag", draw.power(-3, 0), 0.05), ("lift", draw.power(-3, 0), 0.05),
                                  ("time_scale", draw.number(0.5, 2), 0.05), ("velocity_iterations", draw.whole(1, 4), 0.1),
                                  ("drift_iterations", draw.whole(1, 4), 0.1)):
            if draw.chance(share):
                solver[key] = value
        body["solver"] = solver
        body["material"] = {"linear_stiffness": draw.one(1.0, 0.5, draw.power(-2, 0))}
        for key, value, share in (("bending_distance", draw.one(0, 2, 3), 0.4), ("randomize_links", False, 0.2),
                                  ("mass_from_faces", True, 0.2), ("pose_volume", False, 0.1), ("pose_frame", False, 0.1),
                                  ("soft_contact", draw.one("vertices", "clusters"), 0.1)):
            if draw.chance(share):
                body[key] = value
        if draw.chance(0.3):
            body["clusters"] = {"count": draw.one(0, 1, 4, 8)}

    # Time, weight and ground.

    def choose_time(self, body):
        """A step in which elastic tissue takes one to some twenty substeps, or any for a shell."""
        draw = self.draw
        if self.elastic:
            material = body["elastic"]
            wave_m_s = np.sqrt(2 * material.get("youngs_modulus_Pa", 1e5) / material.get("density_kg_m3", 1000))
            self.step_s = float(0.2 * self.size_m / wave_m_s * draw.power(-0.5, 0.8))
        else:
            self.step_s = draw.power(-3.7, -1.7)
        time_s = self.steps * self.step_s
        falls_m_s2 = 2 * self.size_m * draw.number(0.1, 1) / time_s ** 2  # through a part of its size in the run
        strength = draw.one(0.0, 9.81, 9.81 * self.size_m / 0.03, falls_m_s2, falls_m_s2)
        direction = np.array([0, -1.0, 0]) if draw.chance(0.85) else draw.direction()
        self.gravity_m_s2 = plain(strength * direction)

    def ground(self, bodies):
        """Under the bodies, some way below them, or a little above their lowest point."""
        draw = self.draw
        if not draw.chance(0.5):
            return None
        self.kinds.add("ground")
        ground = {"height_m": self.size_m * draw.one(0.0, -0.1, -draw.power(-2, -0.3), 0.05), "friction": draw.one(0.5, 0.0, draw.number(0, 2))}
        if not self.elastic and draw.chance(0.2):
            ground["hardness"] = draw.number(0, 1)
        return ground

    # Tools.

    def tool_shape(self, index):
        draw, size_m = self.draw, self.size_m
        kind = draw.one("blade", "blade", "plate", "box", "ball", "needle", "closed", "sheet")
        if kind == "blade":
            size = np.array([1.4, draw.power(-1.8, -0.7), 0.6]) * size_m
        elif kind == "plate":
            size = np.array([6, draw.power(-1.5, -0.5), 6]) * size_m
        elif kind == "box":
            size = np.array([draw.number(0.2, 1) for _ in range(3)]) * size_m
        if kind in ("blade", "plate", "box"):
            return kind, {"type": "box", "size_m": plain(size)}, size / 2
        if kind == "ball":
            radius_m = size_m * draw.number(0.1, 0.6)
            return kind, {"type": "sphere", "radius_m": radius_m, "subdivisions": draw.one(0, 1, 2)}, np.full(3, radius_m)
        if kind == "needle":
            radius_m, length_m = size_m * draw.power(-1.7, -0.7), size_m * draw.number(0.3, 1.5)
            return (kind, {"type": "capsule", "radius_m": radius_m, "length_m": length_m, "subdivisions": draw.one(0, 1)},
                    np.array([radius_m + length_m / 2, radius_m, radius_m]))
        if kind == "sheet":
            mesh = sheet(0.6 * size_m, size_m * draw.number(0, 0.3), draw.one(2, 3, 4))
            return kind, {"type": "triangles", "vertices_m": mesh["vertices"], "faces": mesh["faces"]}, np.array([0.6, 0.3, 0.3]) * size_m
        shape, half = self.surface(size_m * draw.number(0.3, 0.7), f"tool{index}", False)
        return kind, shape, np.asarray(half)

    def tool(self, index, bodies):
        draw = self.draw
        if draw.chance(0.15):
            return self.clamp(index, bodies)
        kind, shape, half = self.tool_shape(index)
        self.kinds.add(f"tool {kind}")
        tool = {"name": f"tool{index}", "shape": shape, "friction": draw.one(0.0, 0.0, 0.0, draw.number(0, 2))}
        if shape["type"] == "box":
            tool["nodes"] = {"resolution": draw.one([4, 4], [8, 8], [3, 2], [1, 1]), "narrow_rows": draw.one(0, 0, 0, 2)}
        elif kind == "sheet" or draw.chance(0.3):
            tool["nodes"] = {"lone_nodes": True}
        if draw.chance(0.2):
            tool["force_limit_N"] = draw.power(-3, 1)
        self.couple(tool, bodies)
        tool["motion"] = self.motion(index, draw.one(*bodies), half, "coupling" in tool)
        return tool

    def couple(self, tool, bodies):
        """Stiffness and damping by which the tool follows its hand within some steps."""
        draw = self.draw
        if not draw.chance(0.15):
            return
        self.kinds.add("coupled")
        mass_kg = (bodies[0].get("mass_kg") or 1000 * self.size_m ** 3) * draw.power(-1, 1)
        omega_1_s = draw.power(-1.5, 0) / self.step_s
        tool["coupling"] = {"mass_kg": mass_kg, "stiffness_N_m": mass_kg * omega_1_s ** 2,
                            "damping_N_s_m": mass_kg * omega_1_s * draw.number(0, 2),
                            "force": draw.one("reaction", "reaction", *[law["name"] for law in self.force])}
        for body in bodies:  # tool and tissue share one time
            body.get("solver", {}).pop("time_scale", None)

    def way(self, body, half):
        """Points from outside to a body, and where the tool's travel ends, with the tool's orientation."""
        draw, centre = self.draw, np.array(body["position_m"])
        direction = np.array([0, 1.0, 0]) if draw.chance(0.5) else draw.direction()
        direction[1] = abs(direction[1])
        orientation = [0.0, 0.0, 0.0, 1.0] if draw.chance(0.6) else draw.quaternion()
        reach_m = float(np.abs(rotation(orientation).T @ direction) @ half)
        extent_m = 1 / np.linalg.norm(direction / self.half)  # of an ellipsoid along the direction
        start = draw.one("far", "near", "near", "near", "touching", "inside", "inside")
        self.kinds.add(f"start {start}")
        gap_m = self.size_m * {"far": draw.number(2, 5), "near": draw.power(-2, -0.6), "touching": 0.0, "inside": -draw.power(-2, 0)}[start]
        aside = np.cross(direction, draw.direction()) * self.size_m * draw.one(0.0, draw.number(0, 0.8))
        begin = centre + direction * (extent_m + reach_m + gap_m) + aside
        deeper_m = self.size_m * (draw.number(0.02, 0.6) if draw.chance(0.7) else draw.number(0.6, 4)) + max(gap_m, 0)
        if start == "far" and draw.chance(0.5):
            deeper_m = gap_m / 2  # and stays there
        points = [begin, begin - direction * deeper_m]
        then = draw.one("stay", "out", "slide", "hold")
        if then == "out":
            points.append(begin + direction * self.size_m)
        elif then == "slide":
            points.append(points[-1] + np.cross(direction, draw.direction()) * self.size_m * draw.number(0.1, 2))
        return points, orientation, then

    def motion(self, index, body, half, coupled):
        draw = self.draw
        points, orientation, then = self.way(body, half)
        time_s = self.steps * self.step_s
        if draw.chance(0.2):
            self.kinds.add("replay")
            name, shares = f"log{index}.csv", np.sort([0.0, 1.0, *(draw.number(0, 1) for _ in range(draw.whole(3, 20)))])
            places = [points[0] + (points[1] - points[0]) * s + draw.direction() * 0.02 * self.size_m for s in shares]
            times = np.unique(shares) * time_s
            self.files[name] = {"columns": ["t", "x", "y", "z"], "rows": [[float(t), *plain(p)] for t, p in zip(times, places)]}
            return {"type": "replay", "file": name, "time_column": "t", "time_unit": "s", "max_gap_s": 2 * time_s,
                    "interpolation": draw.one("linear", "monotone_cubic"), "mapping": {"mount": orientation}}
        segments, share = [], draw.number(0.3, 0.7)
        timing = draw.one("constant", "trapezoidal", "minimum_jerk")
        segments.append({"move_to_m": plain(points[1]), "duration_s": share * time_s, "timing": timing})
        if then == "hold":
            segments.append({"hold_s": 0.2 * time_s})
        if len(points) > 2:
            segments.append({"move_to_m": plain(points[2]), "duration_s": (1 - share) * time_s})
        elif draw.chance(0.3) and not coupled:
            self.kinds.add("turning")
            segments.append({"rotate_to": draw.quaternion(), "duration_s": (1 - share) * time_s})
        return {"type": "script", "start_m": plain(points[0]), "start_orientation": orientation, "segments": segments}

    def clamp(self, index, bodies):
        """Two jaws that close on a body, and perhaps lift it."""
        draw, size_m, body = self.draw, self.size_m, self.draw.one(*bodies)
        kind, half = draw.one("parallel", "parallel", "hinged"), float(self.half[0])
        self.kinds.add(f"tool clamp {kind}")
        thickness_m, height_m = size_m * draw.power(-1.5, -0.6), size_m * draw.number(0.6, 1.5)
        tool = {"name": f"tool{index}", "shape": {"type": "box", "size_m": [thickness_m, height_m, size_m]},
                "clamp": {"opening": kind, "jaw_position_m": [thickness_m / 2, 0.0, 0.0]},
                "nodes": {"resolution": draw.one([4, 4], [8, 8])}, "friction": draw.one(0.0, 0.0, draw.number(0, 2))}
        time_s, unit = self.steps * self.step_s, "m"
        open_by = 2 * (half + size_m * draw.one(0.02, 0.2, -0.1))
        close_to = 2 * half * draw.one(0.9, 0.6, 0.0)
        if kind == "hinged":
            tool["clamp"]["hinge_height_m"] = 1.5 * height_m
            unit, open_by, close_to = "deg", draw.number(60, 170), draw.one(0.0, 30.0)
        start = np.array(body["position_m"])
        segments = [{f"open_to_{unit}": close_to, "duration_s": 0.6 * time_s, "timing": draw.one("constant", "minimum_jerk")}]
        if draw.chance(0.5):
            segments.append({"move_to_m": plain(start + [0, 0.3 * size_m, 0]), "duration_s": 0.4 * time_s})
        tool["motion"] = {"type": "script", "start_m": plain(start), f"start_opening_{unit}": open_by, "segments": segments}
        return tool

    # Runs and laws.

    def law(self, index):
        draw = self.draw
        model = draw.one(*LAWS)
        law = {"name": f"law{index}", "model": model, "deformation": draw.one("paper", "corotated")}
        size = {"hunt_crossley": {"k": draw.power(0, 4), "lambda": draw.power(-1, 3), "n": draw.number(1, 2.5)},
                "kelvin_voigt": {"k": draw.power(0, 4), "c": draw.power(-2, 2)}, "linear_elastic": {"k": draw.power(0, 4)},
                "exponential": {"k": draw.power(-2, 1), "a": draw.power(0, 1) / self.size_m, "c": draw.power(-2, 2)}}[model]
        law.update(size)
        if draw.chance(0.3):
            law["per_area"] = True
        if model == "hunt_crossley" and draw.chance(0.1):
            law = {"name": law["name"], "model": model, "tissue": "phantom_silicone"}
        if model != "linear_elastic" and draw.chance(0.3):
            law["rate"] = "velocities"
        return law

    def pipelines(self, bodies, tools, ground):
        draw = self.draw
        boxes = all(tool["shape"]["type"] == "box" for tool in tools)
        convex = all(tool["shape"]["type"] in ("box", "sphere", "capsule") for tool in tools)
        rubs = any(tool["friction"] > 0 for tool in tools)
        coupled = any("coupling" in tool and tool["coupling"]["force"] == "reaction" for tool in tools)
        choices = ["swept", "swept", "fukuhara"]
        if not coupled:
            if boxes and (not self.elastic or not ground):
                choices.append("prescribed")
            if not self.elastic:
                choices += ["default", "null", "cluster"] if convex else []
                choices.append("raycast")
            elif convex and self.draw.chance(0.4) and bodies[0]["elastic"]["material"] != "saint_venant_kirchhoff" and len(tools) == 1:
                if bodies[0]["elastic"]["material"] == "linear_corotated" or "mass_damping_1_s" not in bodies[0]["elastic"]:
                    choices.append("deformable")
        if "raycast" in choices and rubs and draw.chance(0.5):
            choices.remove("raycast")
        runs = []
        for number, pipeline in enumerate(dict.fromkeys(draw.some(choices, 1, 2))):
            run = {"name": f"run{number}", "pipeline": pipeline}
            if pipeline in BULLET:
                run["settings"] = draw.one("stock", "tuned")
            if pipeline == "deformable":
                run.update(settings=draw.one("stock", "tuned"), contacts=draw.one("nodes", "faces"), time_limit_s=10)
            if pipeline in NODES:
                run["max_displacement_m"] = self.size_m * draw.one(0.2, 0.05)
                if pipeline == "raycast" and (rubs or draw.chance(0.3)):
                    run["response"] = "momentum"
                if pipeline == "fukuhara" and not self.elastic and not rubs and not coupled and draw.chance(0.1):
                    run["response"] = "none"
                momentum = run.get("response", "none" if pipeline == "raycast" else "momentum") == "momentum"
                if ground and momentum and (self.elastic or draw.chance(0.5)):
                    run["ground_contact"] = "half_space"
                if draw.chance(0.2):
                    run["vertex_contacts"] = draw.chance(0.5)
            if pipeline == "swept":
                run["max_displacement_m"] = self.size_m * draw.one(0.2, 0.05)
                if draw.chance(0.2):
                    run["rounds"] = draw.whole(0, 3)
            if not self.elastic and draw.chance(0.25):
                run["precision"] = "f32"
            run.setdefault("time_limit_s", 10)
            runs.append(run)
        if "null" in [run["pipeline"] for run in runs]:  # and what it must equal
            twin = {**next(run for run in runs if run["pipeline"] == "null"), "name": "twin", "pipeline": "default"}
            runs.append(twin)
        return runs


def draw_scene(seed, number):
    scene = Generator(seed, number).scene()
    return copy.deepcopy(scene)
