#!/usr/bin/python3
"""The tools of configs/meshes that are our own: writes them again, in millimetres.

    /usr/bin/python3 scripts/make_meshes.py [FOLDER]

convex_spatula.obj: 40 x 15 x 2 mm, rounded in plan, bevelled to an edge 0.02 mm thick, a hundredth of its
thickness: the triangles there are the critical ones of the paper's Fig. 2.
hooked_spatula.obj: a blade 12 mm wide and 2 mm thick whose end is bent by 90 degrees: closed, but not convex.
flat_bar.obj: 90 x 12 x 1.5 mm with a hole near one end, triangulated as CAD programs do, without a vertex inside a face:
slivers from the hole's edges of 0.3 mm to the bar's corners, up to 82 mm away, and edges of 90 mm.
sheet.obj: 40 x 15 mm without thickness: open, its faces look down.
"""
import pathlib
import sys

import numpy as np


def ring(length, width, y, count):
    """A closed curve between an ellipse and a rectangle, counter-clockwise seen from -y."""
    angle = 2 * np.pi * np.arange(count) / count
    cos, sin = np.cos(angle), np.sin(angle)
    power = 0.5  # 1: an ellipse
    return np.column_stack([length / 2 * np.sign(cos) * abs(cos) ** power,
                            np.full(count, y),
                            width / 2 * np.sign(sin) * abs(sin) ** power])


def band(first, second, count):
    """Triangles between two rings of vertices that start at these indices."""
    faces = []
    for i in range(count):
        j = (i + 1) % count
        faces += [(first + i, second + i, second + j), (first + i, second + j, first + j)]
    return faces


def convex_spatula():
    count = 24
    # One outline, scaled: quadrangles of a bevel are plane.
    rings = [(40 * scale, 15 * scale, y) for scale, y in ((0.15, 1), (0.5, 1), (0.8, 1), (1, 0.01))]
    rings += [(length, width, -y) for length, width, y in reversed(rings)]
    vertices = np.vstack([ring(*measures, count) for measures in rings] + [[[0, 1, 0], [0, -1, 0]]])
    faces = []
    for i in range(len(rings) - 1):
        faces += band(i * count, (i + 1) * count, count)
    top, bottom, last = len(rings) * count, len(rings) * count + 1, (len(rings) - 1) * count
    for i in range(count):
        j = (i + 1) % count
        faces += [(top, i, j), (bottom, last + j, last + i)]
    return vertices, faces


def hooked_spatula():
    thickness, width, radius = 2.0, 12.0, 5.0
    # The middle line in the x-y plane: straight, an arc of 90 degrees downwards, straight.
    bend = np.radians(np.linspace(0, 90, 7))
    line = [(x, 0.0, 0.0) for x in np.linspace(-28, 0, 8)[:-1]]
    line += [(radius * np.sin(a), -radius * (1 - np.cos(a)), a) for a in bend]
    line += [(radius, -radius - d, np.pi / 2) for d in (3.0, 6.0)]
    across = np.linspace(-width / 2, width / 2, 4)
    sections = []
    for x, y, angle in line:
        up = np.array([np.sin(angle), np.cos(angle)]) * thickness / 2
        section = [(x + up[0], y + up[1], z) for z in across]
        section += [(x - up[0], y - up[1], z) for z in reversed(across)]
        sections.append(section)
    count = len(sections[0])
    vertices = np.array([point for section in sections for point in section])
    faces = []
    for i in range(len(sections) - 1):
        faces += band(i * count, (i + 1) * count, count)
    half = count // 2
    last = (len(sections) - 1) * count
    for k in range(half - 1):  # both ends, each a strip of quadrangles
        a, b, c, d = k, k + 1, count - 2 - k, count - 1 - k
        faces += [(a, b, c), (a, c, d)]
        faces += [(last + a, last + c, last + b), (last + a, last + d, last + c)]
    return vertices, faces


def flat_bar():
    length, half_width, half_thickness, middle, radius, count = 90.0, 6.0, 0.75, 8.0, 3.0, 60
    angle = 2 * np.pi * np.arange(count) / count
    # From +x over +z to -x: the hole, and the corners in the quarter of the hole's edges that they are joined to.
    hole = np.column_stack([middle + radius * np.cos(angle), radius * np.sin(angle)])
    corners = np.array([(length, half_width), (0, half_width), (0, -half_width), (length, -half_width)])
    plan = np.vstack([hole, corners])
    vertices = np.array([(x, y, z) for y in (half_thickness, -half_thickness) for x, z in plan])
    below = len(plan)
    flat = []
    for i in range(count):
        flat.append((i, (i + 1) % count, count + 4 * i // count))
    for corner in range(4):
        flat.append((count + corner, ((corner + 1) * count // 4) % count, count + (corner + 1) % 4))
    faces = [(a, b, c) for a, b, c in flat] + [(below + a, below + c, below + b) for a, b, c in flat]
    for start, edges, inward in ((0, count, False), (count, 4, True)):
        for i in range(edges):
            a, b = start + i, start + (i + 1) % edges
            quad = [(a, a + below, b + below), (a, b + below, b)]
            faces += [(x, z, y) for x, y, z in quad] if inward else quad
    return vertices, faces


def sheet():
    along, across = np.linspace(-20, 20, 9), np.linspace(-7.5, 7.5, 4)
    vertices = np.array([(x, 0, z) for x in along for z in across])
    count = len(across)
    faces = []
    for i in range(len(along) - 1):
        for k in range(count - 1):
            a, b, c, d = i * count + k, (i + 1) * count + k, (i + 1) * count + k + 1, i * count + k + 1
            faces += [(a, b, c), (a, c, d)]
    return vertices, faces


def volume(vertices, faces):
    a, b, c = (vertices[np.array(faces)[:, i]] for i in range(3))
    return np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6


def write(path, vertices, faces):
    if volume(vertices, faces) < 0:
        faces = [(a, c, b) for a, b, c in faces]
    lines = [f"# written by scripts/make_meshes.py, millimetres"]
    lines += ["v " + " ".join(f"{x:.6g}" for x in vertex + 0.0) for vertex in vertices]
    lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in faces]
    path.write_text("\n".join(lines) + "\n")
    print(f"{path}: {len(vertices)} vertices, {len(faces)} triangles, {abs(volume(vertices, faces)):.1f} mm3")


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else
                          pathlib.Path(__file__).resolve().parent.parent / "configs" / "meshes")
    write(folder / "convex_spatula.obj", *convex_spatula())
    write(folder / "hooked_spatula.obj", *hooked_spatula())
    write(folder / "flat_bar.obj", *flat_bar())
    write(folder / "sheet.obj", *sheet())


if __name__ == "__main__":
    main()
