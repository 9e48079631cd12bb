"""What results and sweeps' tables hold, bit by bit: compares two of them, or is imported by scripts that compare many.

    result_bits.py FIRST SECOND      exit code 0 when they hold the same outside timing/ and provenance; else 1, and what differs is printed
"""
import hashlib
import sys

import h5py
import numpy


def contents(path):
    """Everything in a result or a sweep's table but timing and provenance: by name, as arrays."""
    found = {}

    def take(name, item):
        if "timing" in name.split("/") or name.startswith("provenance"):
            return
        for key, value in item.attrs.items():
            if key not in ("DIMENSION_LIST", "REFERENCE_LIST"):
                found[f"{name}@{key}"] = numpy.asarray(value)
        if isinstance(item, h5py.Dataset):
            found[name] = numpy.asarray(item[()])

    with h5py.File(path, "r") as file:
        for key in file.attrs:
            if key not in ("history", "date_created", "id"):
                found[f"@{key}"] = numpy.asarray(file.attrs[key])
        file.visititems(take)
    if not found:
        raise ValueError(f"{path}: holds nothing, expected a result")
    return found


def places_that_differ(one, two):
    """The places at which two arrays of one type and shape differ in a bit: NaN is NaN, and -0 is not 0."""
    if one.dtype.kind in "OSU":
        return [at for at, (a, b) in enumerate(zip(one.ravel().tolist(), two.ravel().tolist())) if str(a) != str(b)]
    raw = [numpy.frombuffer(array.tobytes(), numpy.uint8).reshape(array.size, array.dtype.itemsize) for array in (one, two)]
    return numpy.flatnonzero((raw[0] != raw[1]).any(axis=1))


def difference(name, a, b):
    """What differs in two arrays of a name, in a sentence, or None."""
    texts = a.dtype.kind == "U" and b.dtype.kind == "U"
    if a.dtype != b.dtype and not texts or a.shape != b.shape:
        return f"{name} is {a.dtype} {a.shape} and {b.dtype} {b.shape}"
    different = places_that_differ(a, b)
    if not len(different):
        return None
    at = int(different[0])
    place = f" at {list(map(int, numpy.unravel_index(at, a.shape)))}" if a.shape else ""
    values = " and ".join(str(array.ravel()[at])[:60].splitlines()[0] for array in (a, b))
    return f"{name} differs in {len(different)} of {a.size} values, first{place}: {values}"


def differences(one, two):
    """What differs in two contents, a sentence for each name. The hash of a final state comes last, because it says least."""
    for name in sorted(set(one) ^ set(two)):
        yield f"{name} is in one of them alone"
    for name in sorted(set(one) & set(two), key=lambda n: (n.endswith("final_state_hash"), n)):
        if said := difference(name, one[name], two[name]):
            yield said


def first_difference(one, two):
    return next(differences(one, two), None)


def hash_of(found):
    """SHA-256 of contents: names, types, shapes and bytes."""
    digest = hashlib.sha256()
    for name in sorted(found):
        array = found[name]
        as_text = array.dtype.kind in "OSU"
        digest.update(f"{name} {'text' if as_text else array.dtype} {array.shape}\n".encode())
        digest.update(repr(list(map(str, array.ravel().tolist()))).encode() if as_text else array.tobytes())
    return digest.hexdigest()


if __name__ == "__main__":
    FOUND = list(differences(contents(sys.argv[1]), contents(sys.argv[2])))
    print("\n".join(FOUND))
    sys.exit(1 if FOUND else 0)
