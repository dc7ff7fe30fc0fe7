"""The command line: ``vpr-bench``. Commands import what they need when they run, so that start-up stays light."""

import atexit
import contextlib
import os
import sys
from typing import NoReturn

from vpr_bench.errors import VprBenchError

INTERRUPTED = 130


def main() -> None:
    """Run the command line and exit: 0 good, 1 a check failed, 2 usage, 3 data missing or damaged, 130 interrupted."""
    # OpenMP's threads wait for each other by spinning, for ever by default: with anything else running on one
    # of the cores a network becomes 50 times slower. This much is as fast on an idle machine.
    os.environ.setdefault("GOMP_SPINCOUNT", "10000")
    # So do those of NumPy's BLAS, for tens of milliseconds after every product: 2 to the power of this many cycles.
    os.environ.setdefault("OPENBLAS_THREAD_TIMEOUT", "4")
    try:
        from vpr_bench.cli.app import app
        from vpr_bench.cli.console import notes_on_stderr

        with notes_on_stderr():
            code = app(prog_name="vpr-bench", standalone_mode=False)
        if code == INTERRUPTED:
            _fail("interrupted; give the same command again to go on", INTERRUPTED)
    except KeyboardInterrupt:
        _fail("interrupted; give the same command again to go on", INTERRUPTED)
    except VprBenchError as error:
        _fail(str(error), error.exit_code)
    except OSError as error:
        _fail(f"Cannot read or write {error.filename or 'a file'}: {error.strerror or error}.", 3)
    except Exception as error:
        code = getattr(error, "exit_code", 1)
        if str(error) or not hasattr(error, "format_message"):  # else the help has been shown, and says it all
            _fail(_explain(error), code)
    sys.exit(code if isinstance(code, int) else 0)


def script() -> NoReturn:
    """Do what :func:`main` does, as a process of its own.

    When everything is written and every library has said goodbye, the process ends at once: taking apart all that a
    network library has made would take a third of a second.
    """
    code = 1

    def leave() -> None:
        for stream in (sys.stdout, sys.stderr):
            with contextlib.suppress(OSError, ValueError):  # a pipe whose reader has gone
                stream.flush()
        os._exit(code)

    atexit.register(leave)  # what is registered first comes last
    try:
        main()
    except SystemExit as stopped:
        code = stopped.code if isinstance(stopped.code, int) else int(stopped.code is not None)
        raise
    raise SystemExit(0)


def _explain(error: Exception) -> str:
    """Put into words what the command-line library refuses, and what we did not foresee."""
    if hasattr(error, "format_message"):
        command = getattr(getattr(error, "ctx", None), "command_path", "vpr-bench")
        return f"{error.format_message().rstrip('.')}. See `{command} --help`."
    if os.environ.get("VPR_BENCH_DEBUG"):
        raise error
    return f"unforeseen {type(error).__name__}: {error}. Set VPR_BENCH_DEBUG=1 to see where, and please report it."


def _fail(message: str, exit_code: int) -> NoReturn:
    from vpr_bench.cli.console import complain

    complain(message)
    sys.exit(exit_code)
