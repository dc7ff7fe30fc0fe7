"""The command line: ``vpr-bench``. Commands import what they need when they run, so that start-up stays light."""

import os
import sys

from vpr_bench.errors import VprBenchError

INTERRUPTED = 130


def main() -> None:
    """Run the command line and exit: 0 good, 1 a check failed, 2 usage, 3 data missing or damaged, 130 interrupted."""
    # OpenMP's threads wait for each other by spinning, for ever by default: with anything else running on one
    # of the cores a network becomes 50 times slower. This much is as fast on an idle machine.
    os.environ.setdefault("GOMP_SPINCOUNT", "10000")
    try:
        from vpr_bench.cli.app import app
        from vpr_bench.cli.console import notes_on_stderr

        with notes_on_stderr():
            app(prog_name="vpr-bench")
    except VprBenchError as error:
        _fail(str(error), error.exit_code)
    except KeyboardInterrupt:
        _fail("interrupted", INTERRUPTED)
    except OSError as error:
        _fail(f"Cannot read or write {error.filename or 'a file'}: {error.strerror or error}.", 3)


def _fail(message: str, exit_code: int) -> None:
    from vpr_bench.cli.console import complain

    complain(message)
    sys.exit(exit_code)
