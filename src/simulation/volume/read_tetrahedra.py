"""Writes the tetrahedra of a mesh file to standard output, for fissure, which runs this text.

    python3 -c TEXT FILE FORMAT

FORMAT is meshio's name of the format. Output: one line "VERTICES TETRAHEDRA QUADRATIC TAGS", then the
vertices' coordinates (doubles), the four corners of each tetrahedron (32-bit integers, from 0) and, where TAGS is
not 0, one 32-bit integer per tetrahedron. QUADRATIC: how many of them had vertices on their edges, which are left
out. Exit code 2 and a line on standard error: the file is not good; 3: meshio is not installed.
"""
import contextlib
import io
import sys

try:
    import meshio
    import numpy
except ImportError as error:
    print(error, file=sys.stderr)
    sys.exit(3)


def refuse(text):
    print(" ".join(str(text).split()), file=sys.stderr)
    sys.exit(2)


def read(file, file_format):
    said = io.StringIO()
    try:
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            return meshio.read(file, file_format=file_format)
    except (Exception, SystemExit) as error:  # meshio meets a damaged file with any of them
        lines = [line for line in said.getvalue().splitlines() if line.strip()]
        reason = lines[-1].strip() if isinstance(error, SystemExit) and lines else error
        refuse(f"cannot be read ({str(reason)[:120] or type(error).__name__})")


def tags_of(mesh, block):
    """Of one block of cells: the first of the usual names that the file has."""
    for name in ("gmsh:physical", "medit:ref", "region", "tag", "material", "CellEntityIds"):
        values = mesh.cell_data.get(name)
        if values is not None and numpy.size(values[block]) == len(mesh.cells[block].data):
            return numpy.ravel(values[block])
    return None


def main(file, file_format):
    with open(file, "rb") as whole:
        if file_format == "gmsh" and b"$EndElements" not in whole.read():
            refuse("cannot be read (a damaged file: $EndElements is missing)")
    mesh = read(file, file_format)
    corners, tags, quadratic = [], [], 0
    for block, cells in enumerate(mesh.cells):
        if cells.type in ("hexahedron", "wedge", "pyramid", "polyhedron", "voxel") and len(cells.data):
            refuse(f"has {len(cells.data)} cells of type {cells.type}, expected tetrahedra alone")
        if cells.type not in ("tetra", "tetra10"):
            continue
        corners.append(numpy.asarray(cells.data)[:, :4])
        quadratic += len(cells.data) if cells.type == "tetra10" else 0
        tags.append(tags_of(mesh, block))
    if not sum(map(len, corners)):
        refuse("has no tetrahedra, expected a volume")
    points = numpy.asarray(mesh.points, dtype="<f8")
    if points.ndim != 2 or points.shape[1] != 3:
        refuse("has vertices of other than three coordinates")
    cells = numpy.concatenate(corners)
    if cells.min() < 0 or cells.max() >= len(points):
        refuse(f"has a tetrahedron with a corner that does not exist, expected vertices 0 to {len(points) - 1}")
    tagged = all(values is not None for values in tags)
    out = sys.stdout.buffer
    out.write(f"{len(points)} {len(cells)} {quadratic} {int(tagged)}\n".encode())
    out.write(points.tobytes())
    out.write(cells.astype("<i4").tobytes())
    if tagged:
        out.write(numpy.concatenate(tags).astype("<i4").tobytes())


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
