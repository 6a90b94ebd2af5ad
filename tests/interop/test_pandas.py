"""pandas, numpy and astropy read every table as it is: its columns by name, each a column of numbers (or of words, where it is one)."""
import csv

import numpy as np
import pandas
from astropy.table import Table

import support

PROGRAM = f"pandas {pandas.__version__}"
TABLES = {
    "curve.csv": ("lightcurve", "sgr-a-flare", "--steps", "4", "--size", "32x32", "-o", "curve"),
    "line.csv": ("profile", "m87", "--size", "48x48", "-o", "line"),
    "bins.csv": ("spectrum", "--spin", "0.998", "--inclination", "30", "--line", "6.4", "-o", "bins"),
    "ring.csv": ("figure", "photon-ring", "sky-only", "-o", "ring"),
    "camera.csv": ("path", "kerr-plunge", "0:5", "--cartesian", "-o", "camera.csv"),
    "ends.csv": ("trace", "sky-only", "--rays", "rays.csv", "--crossings", "2", "-o", "ends.csv"),
}


def tables(report, folder):
    (folder / "rays.csv").write_text("q,zeta0,s\n0.384,0.1,1\n0.2,0.1,1\n")
    for name, command in TABLES.items():
        support.nullscope(*command, folder=folder)
        with open(folder / name, newline="") as file:
            head, *rows = csv.reader(file)
        meant = {column: [row[i] for row in rows] for i, column in enumerate(head)}
        frame, table = pandas.read_csv(folder / name), Table.read(folder / name, format="ascii.csv")
        array = np.genfromtxt(folder / name, delimiter=",", names=True, dtype=None, encoding="utf-8", deletechars="")
        report.add(f"{name}: columns of {len(head)} with another name", sum(list(found) != head for found in (frame.columns, table.colnames, array.dtype.names)), 0)
        numbers = [column for column in head if all(is_number(value) for value in meant[column])]
        off = sum(int(not np.array_equal(np.asarray(found[column], dtype=float), np.array(meant[column], dtype=float), equal_nan=True))
                  for column in numbers for found in (frame, table, array))
        report.add(f"{name}: columns of {len(numbers)} with other numbers, of {len(rows)} rows", off if len(rows) > 1 and numbers else 99, 0)


def is_number(word):
    try:
        float(word)
        return True
    except ValueError:
        return False


if __name__ == "__main__":
    support.main(PROGRAM, tables)
