"""A process that renders its share of the images: ``python -m vpr_datasets.simulation.worker``.

It reads a :class:`~vpr_datasets.simulation.job.Job` as JSON from its input and writes one line,
:data:`STEP`, for every image. When nobody reads any more, it stops.
"""

import sys

import cv2

from vpr_datasets.simulation.job import Job

STEP = "image written"


def main() -> None:
    """Carry out the job on standard input."""
    # One process per processor is enough; OpenCV's own threads would only get in each other's way.
    cv2.setNumThreads(1)
    job = Job.model_validate_json(sys.stdin.read())
    for _ in job.carry_out():
        sys.stdout.write(STEP + "\n")
        sys.stdout.flush()


if __name__ == "__main__":
    main()
