"""Exit 0 when two results hold the same data, bit for bit, outside timing/ and provenance; else 1."""
import sys

import h5py
import numpy


def contents(path):
    found = {}

    def note(name, item):
        if "timing" in name.split("/") or name.startswith("provenance"):
            return
        for key, value in item.attrs.items():
            if key not in ("DIMENSION_LIST", "REFERENCE_LIST"):
                found[name + "@" + key] = numpy.asarray(value)
        if isinstance(item, h5py.Dataset):
            found[name] = item[()]

    with h5py.File(path, "r") as file:
        for key in file.attrs:
            if key not in ("history", "date_created", "id"):
                found["@" + key] = numpy.asarray(file.attrs[key])
        file.visititems(note)
    return found


def differences(first, second):
    """Names of what differs in two results, or is in one alone."""
    one, two = contents(first), contents(second)
    different = set(one) ^ set(two)
    for name in set(one) & set(two):
        a, b = numpy.asarray(one[name]), numpy.asarray(two[name])
        same_bits = a.dtype == b.dtype and a.shape == b.shape and (
            a.tolist() == b.tolist() if a.dtype.kind in "OSU" else a.tobytes() == b.tobytes())
        if not same_bits:
            different.add(name)
    return sorted(different) if one else ["everything"]


if __name__ == "__main__":
    DIFFERENT = differences(sys.argv[1], sys.argv[2])
    print("\n".join(DIFFERENT))
    sys.exit(1 if DIFFERENT else 0)
