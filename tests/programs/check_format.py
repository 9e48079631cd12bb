"""Compares results with src/results/store/FORMAT.md: every dataset with its axes, type and unit, and every attribute, stands in its tables.

Usage: check_format.py FORMAT.md RESULT... [--all]      --all: and every dataset of the tables is in one of the results
"""
import argparse
import re

import h5py
import numpy as np

OF_NETCDF = {"CLASS", "NAME", "DIMENSION_LIST", "REFERENCE_LIST", "_FillValue", "units", "long_name", "flag_values", "flag_meanings"}
GROUPS = {  # which section's attributes belong to which group
    "2.": r"", "3.": r"provenance", "4.": r"pipelines/[^/]+", "7.": r"pipelines/[^/]+/summary", "8.": r"pipelines/[^/]+/timing"}
OF_DATASETS = {"sample_dimension", "IMAGE_VERSION", "IMAGE_SUBCLASS", "INTERLACE_MODE"}


def pattern(name):
    """A name of the book as an expression: <tool> and the like stand for any name."""
    any_of = {"<number>": r"\d+"}
    return "".join(any_of.get(part, r"[^/]+?") if part.startswith("<") else re.escape(part) for part in re.split(r"(<\w+>)", name))


class Book:
    def __init__(self, path):
        self.datasets = {}  # expression: (axes, type, unit)
        self.attributes = {}  # section: expressions
        section, head = "", []
        for line in open(path, encoding="utf-8"):
            if line.startswith("## "):
                section = line.split()[1]
            if not line.startswith("|"):
                head = []
                continue
            cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
            if not head:
                head = cells
            elif head[0] == "dataset" and cells[0].startswith("`"):
                (name,), (kind, *unit) = re.findall(r"`([^`]+)`", cells[0]), cells[2].split(", ")
                below = "provenance/" if section == "3." else r"pipelines/[^/]+/"
                self.datasets[below + pattern(name)] = (tuple(filter(None, cells[1].split(", "))), kind, "".join(unit))
            elif head[0] == "attribute":
                self.attributes.setdefault(section, set()).update(map(pattern, re.findall(r"`([^`]+)`", cells[0])))
        self.seen = set()

    def group_attributes(self, group, names):
        for section, expression in GROUPS.items():
            if re.fullmatch(expression, group):
                return {name for name in names if not any(re.fullmatch(known, name) for known in self.attributes[section])}
        return set(names)


def kind_of(dataset):
    if h5py.check_string_dtype(dataset.dtype):
        return "text"
    return {np.dtype("f8"): "f64", np.dtype("i8"): "i64", np.dtype("u1"): "u8"}.get(dataset.dtype, str(dataset.dtype))


def axes_of(dataset):
    if h5py.h5ds.is_scale(dataset.id):
        return (dataset.name.rsplit("/")[-1],)
    return tuple(list(axis.values())[0].name.rsplit("/")[-1] for axis in dataset.dims)


def check(book, path, complaints):
    def need(good, name, what):
        if not good:
            complaints.append(f"{path}: {name}: {what}")

    def visit(name, item):
        if isinstance(item, h5py.Group):
            for lacking in book.group_attributes(name, item.attrs):
                need(False, f"{name}@{lacking}", "no such attribute in the book")
            return
        own = set(item.attrs) - OF_NETCDF - OF_DATASETS
        if name.endswith("/force"):
            laws = [law.decode() for law in item.parent["law"][()]]
            own = {a for a in own if not any(re.fullmatch(rf"{re.escape(law)}_(model|deformation|per_area|rate|[a-z]+(_units)?)", a) for law in laws)}
        need(not own, name, f"attributes {sorted(own)} are not in the book")
        for expression, (axes, kind, unit) in book.datasets.items():
            if not re.fullmatch(expression, name):
                continue
            book.seen.add(expression)
            found = (axes_of(item), kind_of(item), item.attrs.get("units", ""))
            need(found == (axes, kind, unit), name, f"the book says {(axes, kind, unit)}, the file has {found}")
            return
        need(h5py.h5ds.is_scale(item.id), name, "no such dataset in the book")

    with h5py.File(path) as file:
        for lacking in book.group_attributes("", file.attrs):
            need(False, f"/@{lacking}", "no such attribute in the book")
        file.visititems(visit)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("book")
    parser.add_argument("results", nargs="+")
    parser.add_argument("--all", action="store_true")
    arguments = parser.parse_args()
    book, complaints = Book(arguments.book), []
    for path in arguments.results:
        check(book, path, complaints)
    if arguments.all:
        complaints += [f"{arguments.book}: {name}: in none of the results" for name in sorted(set(book.datasets) - book.seen)]
    print(f"{len(book.seen)} of {len(book.datasets)} datasets of the book seen")
    print("\n".join(complaints), end="\n" if complaints else "")
    raise SystemExit(1 if complaints or not book.seen else 0)


main()
