"""How long it takes to make an environment, and what a step of the vector environment costs beyond copying images."""

import time
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from typing import Any

import numpy as np

_REPEATS = 5  # makes in one process, of which the first also imports what it needs
_SMALL = (4, 4)


def run(dataset: str, num_envs: int = 32, episodes: int = 5) -> dict[str, Any]:
    """Measure the environments of a dataset, each figure in a fresh process.

    Parameters
    ----------
    dataset : str
        Its images must be there; simulated ones are rendered before anything is measured.
    num_envs : int
        Queries per step of the vector environment.
    episodes : int
        How often all queries are asked.

    Returns
    -------
    dict
        JSON-able: ``first_seconds``, from ``gymnasium.make`` to the first observation in a process that has imported
        ``gymnasium`` and ``vpr_bench`` and nothing else; ``again_seconds``, the same a second time; microseconds per
        query of a step of the vector environment with all images in memory: ``step_us``, ``copy_us`` for copying such
        images into a new array, and ``overhead_us``, a step with images so small that copying them takes no time.
    """
    from vpr_bench.dataset.load import load_case  # here, so that the processes that measure start without it

    case = load_case(dataset)  # renders, and computes the digests
    facts = {
        "benchmark": "envs",
        "protocol": str(case.protocol),
        "queries": len(case.queries),
        "size": list(case.queries[0].shape),
        "num_envs": num_envs,
        "episodes": episodes,
    }
    for measure in (_measure_making, _measure_stepping):
        with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
            facts |= pool.submit(measure, dataset, num_envs, episodes).result()
    return facts


def _measure_making(dataset: str, num_envs: int, episodes: int) -> dict[str, float]:
    import gymnasium

    seconds = []
    for _ in range(_REPEATS):
        start = time.perf_counter()
        gymnasium.make("vpr_bench/Place-v0", dataset=dataset).reset(seed=0)
        seconds.append(time.perf_counter() - start)
    return {"first_seconds": seconds[0], "again_seconds": float(np.median(seconds[1:]))}


def _measure_stepping(dataset: str, num_envs: int, episodes: int) -> dict[str, float]:
    whole = _step_seconds(dataset, num_envs, episodes, None)
    small = _step_seconds(dataset, num_envs, episodes, _SMALL)
    return {
        "step_us": 1e6 * whole / num_envs,
        "copy_us": 1e6 * _copy_seconds(dataset, num_envs, episodes) / num_envs,
        "overhead_us": 1e6 * small / num_envs,
    }


def _step_seconds(dataset: str, num_envs: int, episodes: int, size: tuple[int, int] | None) -> float:
    """Return the seconds of one step, the median over those whose batch is full."""
    from vpr_bench.envs.vector import VprVectorEnv

    env = VprVectorEnv(dataset, size=size, in_memory=True, num_envs=num_envs, autoreset_mode="Disabled")
    action = env.action_space.sample()
    seconds = []
    for episode in range(episodes + 1):  # the first one decodes
        _, info = env.reset(seed=episode)
        over = False
        while not over:
            start = time.perf_counter()
            _, _, terminated, _, info = env.step(action)
            taken = time.perf_counter() - start
            over = bool(terminated.all())
            if episode and (over or info["mask"].all()):
                seconds.append(taken)
    return float(np.median(seconds))


def _copy_seconds(dataset: str, num_envs: int, episodes: int) -> float:
    """Return the seconds of copying as many images in a shuffled order into a new array, the median."""
    from vpr_bench.dataset.load import load_case
    from vpr_bench.envs.task import Task

    frames = Task.of(load_case(dataset)).frames
    images = [frames[query] for query in range(len(frames.sizes))]
    seconds = []
    for episode in range(episodes):
        order = np.random.default_rng(episode).permutation(len(images)).tolist()
        for first in range(0, len(order) - num_envs + 1, num_envs) or [0]:
            chosen = [images[query] for query in order[first : first + num_envs]]
            start = time.perf_counter()
            batch = np.empty((num_envs, *frames.shape), np.uint8)
            for row, image in enumerate(chosen):
                batch[row] = image
            seconds.append(time.perf_counter() - start)
    return float(np.median(seconds))
