"""Which reader a file is for."""
from . import athena, athenak, hamr, iharm, kharma, koral
from .common import Hdf5, fail

# A code's files: name, how they begin (None: HDF5), by what they are known, and the reader, (Hdf5 or path, options) -> Flow. The first that fits reads.
READERS = (("AthenaK (.bin)", athenak.MAGIC, None, athenak.read),
           ("iharm3d", None, iharm.is_of, iharm.read),
           ("KHARMA (.phdf, .rhdf)", None, kharma.is_of, kharma.read),
           ("Athena++ (.athdf)", None, athena.is_of, athena.read),
           ("KORAL (KORALv2)", None, koral.is_of, koral.read),
           ("H-AMR (regular grid)", None, hamr.is_of, hamr.read))
ALLOWED = ", ".join(name for name, *_ in READERS)
# Files that cannot be read, by the end of their name, and why.
REFUSED = ((".dat", "BHAC's raw output does not hold its domain, base grid and coordinates"),
           (".blk", "BHAC's blocks do not say whether their field is divided by the lapse"))


def opened(path):
    try:
        import h5py
    except ImportError:
        fail("needs h5py (pip install h5py)")
    if not h5py.is_hdf5(path):
        why = next((why for end, why in REFUSED if path.endswith(end)), "it is no HDF5 file")
        fail(f"{path}: no dump of a code that is known: {why}; allowed: {ALLOWED}")
    return h5py.File(path, "r")


def read(path, wanted):
    """The Flow of a file."""
    try:
        with open(path, "rb") as file:
            start = file.read(64)
    except OSError as error:
        fail(f"{path}: no dump: {error.strerror}")
    reader = next((read for _, magic, _, read in READERS if magic and start.startswith(magic)), None)
    if reader:
        return reader(path, wanted)
    try:
        with opened(path) as file:
            known = Hdf5(path, file)
            reader = next((read for _, _, is_of, read in READERS if is_of and is_of(known)), None)
            if reader is None:
                fail(f"{path}: no dump of a code that is known; allowed: {ALLOWED}")
            return reader(known, wanted)
    except (OSError, KeyError, RuntimeError, ValueError, TypeError) as error:
        fail(f"{path}: its HDF5 cannot be read: it is cut short or damaged, or packed by a filter that is not installed ({type(error).__name__})")
