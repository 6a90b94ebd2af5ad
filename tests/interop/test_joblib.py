"""joblib and dask hand scenes, spacetimes, observers and pictures to worker processes and back. The environment has the package nullscope too."""
import dask
import joblib
import numpy as np

import nullscope as ns
import support

PROGRAM = f"joblib {joblib.__version__}, dask {dask.__version__}"
SIZE = 48, 27


def seen(scene, spacetime, observer):
    """In a worker: everything that is handed over, back again."""
    return ns.capture(scene, SIZE), scene, spacetime, observer


def by_joblib(jobs):
    return joblib.Parallel(n_jobs=2)(joblib.delayed(seen)(*job) for job in jobs)


def by_dask(jobs):
    return dask.compute(*(dask.delayed(seen)(*job) for job in jobs), scheduler="processes", num_workers=2)


def workers(report, folder):
    names = "sky-only", "first-light", "kerr", "m87-swirl"
    jobs = [(ns.scene(name), ns.Observer(name).spacetime, ns.Observer(name)) for name in names]
    for program, run in (("joblib", by_joblib), ("dask", by_dask)):
        there = run(jobs)
        report.add(f"{program}: jobs of {len(jobs)} that came back", abs(len(there) - len(jobs)), 0)
        for name, job, (picture, *rest) in zip(names, jobs, there):
            here = ns.capture(job[0], SIZE)
            report.add(f"{program}, {name}: numbers of its picture that differ", int((np.asarray(picture) != np.asarray(here)).sum()), 0)
            report.add(f"{program}, {name}: of scene, spacetime and observer, those that are not the same", sum(a != b for a, b in zip(job, rest)), 0)


if __name__ == "__main__":
    support.main(PROGRAM, workers)
