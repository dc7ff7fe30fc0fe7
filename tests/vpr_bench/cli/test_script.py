"""The command as a process of its own."""

import subprocess
import sys

import pytest

PROGRAM = """
import atexit, sys, threading, time
from vpr_bench.cli import script
threading.Thread(target=lambda: (time.sleep(0.2), print("thread done"), atexit.register(print, "swept"))).start()
class Late:
    def __del__(self):
        print("taken apart")
sys.late = Late()
script()
"""


def start(*arguments):
    return subprocess.run(
        [sys.executable, "-c", PROGRAM, *arguments], capture_output=True, text=True, timeout=60, check=False
    )


@pytest.mark.parametrize(("arguments", "code"), [(["--version"], 0), (["nonsense"], 2), (["info", "nonsense"], 2)])
def test_it_ends_with_the_exit_code_and_everything_written(arguments, code):
    done = start(*arguments)
    assert done.returncode == code
    assert done.stdout.startswith("vpr-bench") if code == 0 else "nonsense" in done.stderr, done


def test_threads_and_clean_up_are_waited_for_but_nothing_is_taken_apart():
    said = start("--version").stdout
    assert "thread done" in said and "swept" in said and "taken apart" not in said
