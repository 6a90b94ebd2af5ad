"""Random numbers of the tests of programs: others in every run, and the same again where they are asked for."""
import os
import random


def dice(what=""):
    """NULLSCOPE_SEED=n repeats those of a run that has printed n; NULLSCOPE_RUN is what scripts/test.sh gives all tests of a run."""
    seed = int(os.environ.get("NULLSCOPE_SEED") or os.environ.get("NULLSCOPE_RUN") or random.SystemRandom().randrange(10 ** 6))
    print(f"{what}{': ' if what else '    '}NULLSCOPE_SEED={seed}", flush=True)
    return random.Random(seed)
