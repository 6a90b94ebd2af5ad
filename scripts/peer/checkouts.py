"""The other program: its sources at one commit, its tables made by its own programs, and the harness, all in a folder that is thrown away."""
import os
import subprocess
from pathlib import Path

HERE = Path(__file__).resolve().parent
COMMIT = "e72b3f2"
SOURCE = "https://github.com/ebruneton/black_hole_shader.git"
TYPES_SOURCE = "https://github.com/ebruneton/dimensional_types.git"
TYPES = "submodules/dimensional_types"   # headers that its preprocessing includes; at the commit that its tree names
PATIENCE_S = 300   # for any one command; all take seconds
TABLES = "output/black_hole/demo"
MADE = [f"{TABLES}/{name}" for name in ("deflection.dat", "black_body.dat", "doppler.dat")]   # the first beside inverse_radius.dat


def ran(*command, cwd=None):
    """What it prints; its last lines and the command, where it fails."""
    try:
        done = subprocess.run([str(word) for word in command], cwd=cwd, capture_output=True, text=True, timeout=PATIENCE_S)
    except subprocess.TimeoutExpired:
        raise SystemExit(f"peer: {' '.join(str(word) for word in command)}: not done after {PATIENCE_S} s") from None
    if done.returncode != 0:
        said = "\n".join((done.stdout + done.stderr).strip().split("\n")[-20:])
        raise SystemExit(f"peer: {' '.join(str(word) for word in command)}: exit status {done.returncode}\n{said}")
    return done.stdout


def cloned(source, folder, commit):
    ran("git", "clone", "--quiet", "--no-checkout", source, folder)
    ran("git", "checkout", "--quiet", commit, cwd=folder)


def made(folder, source, types_source):
    """The checkout with its tables, made in `folder` where they are not there already."""
    checkout = folder / "black_hole_shader"
    if not checkout.exists():
        print(f"peer: {source} at {COMMIT}, and its tables by its own programs", flush=True)
        cloned(source, checkout, COMMIT)
        commit = ran("git", "rev-parse", f"HEAD:{TYPES}", cwd=checkout).strip()
        cloned(types_source, checkout / TYPES, commit)
    ran("make", *MADE, cwd=checkout)
    return checkout


def harness(folder):
    """Our program that draws by shaders from files."""
    program = folder / "harness"
    ran(os.environ.get("CXX", "g++"), "-std=c++20", "-O2", "-Wall", "-Wextra", HERE / "harness.cpp", "-lEGL", "-lGL", "-lpng", "-o", program)
    return program
